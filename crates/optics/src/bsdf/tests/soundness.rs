//! Whatever goes in, finite numbers come out; and the two ways of asking agree.

use super::*;

/// A surface whose parameters are drawn from their ranges, the ends often.
fn any_surface(seed: u32) -> Surface {
    let unit = |k: u32| {
        let h = hash::join(hash::mix(seed), k);
        match h % 5 {
            0 => 0.0,
            1 => 1.0,
            _ => hash::unit(hash::mix(h)),
        }
    };
    let color = |k: u32| Rgb::new(unit(k), unit(k + 1), unit(k + 2));
    let index = 1.0 + 1.6 * unit(4);
    Surface {
        base_color: color(10),
        diffuse_roughness: unit(0),
        metalness: unit(1),
        metal: (unit(2) > 0.7).then(|| (color(13) * 3.0 + Rgb::splat(0.01), color(16) * 5.0)),
        specular_weight: unit(3),
        specular_color: color(19),
        roughness: unit(5),
        eta: if unit(6) > 0.5 { index } else { 1.0 / index },
        transmission: unit(7),
        transmission_tint: color(22),
        thin_walled: unit(8) > 0.6,
        thin_absorption: color(25),
        coat_weight: unit(9),
        coat_color: color(28),
        coat_roughness: unit(31),
        coat_ior: 1.0 + unit(32),
        thin_film_weight: unit(33),
        thin_film_thickness: 3.0 * unit(34),
        thin_film_ior: 1.0 + unit(35),
    }
}

#[test]
fn no_input_gives_a_number_that_is_not_finite() {
    let cosines = [1.0, 0.999_999_9, 0.7, 0.1, 1e-3, 1e-5, 1e-9, 0.0];
    let ends = [0.0, 0.5, 0.999_999_94];
    for seed in 0..4000 {
        let surface = any_surface(seed);
        let cos = cosines[seed as usize % cosines.len()];
        let wo = direction(cos, seed as f32);
        let bsdf = Bsdf::new(&surface, cos);
        assert!(bsdf.albedo().is_finite(), "{surface:?}");
        for u_lobe in [0.0, 0.2, 0.4, 0.6, 0.8, 0.999_999_94] {
            for u in ends.iter().flat_map(|a| ends.map(|b| [*a, b])) {
                let Some(s) = bsdf.sample(wo, u_lobe, u) else { continue };
                let channels = s.weight.to_array();
                assert!(channels.iter().all(|w| *w >= 0.0 && w.is_finite()), "{s:?} at {cos} of {surface:?}");
                assert!(s.pdf > 0.0 && s.pdf.is_finite(), "{s:?} at {cos} of {surface:?}");
                assert!((s.wi.length() - 1.0).abs() < 1e-3, "{s:?} at {cos} of {surface:?}");
                assert_eq!(s.event.is_transmission, s.wi.z < 0.0, "{s:?} at {cos} of {surface:?}");
            }
        }
        for wi in [wo, -wo, Vec3::Z, -Vec3::Z, Vec3::X, direction(1e-6, 1.0), direction(-0.3, 2.0)] {
            let (f, pdf) = bsdf.eval(wo, wi);
            assert!(
                f.is_finite() && pdf.is_finite() && pdf >= 0.0,
                "{f:?} {pdf} at {cos}, {wi} of {surface:?}"
            );
        }
    }
}

#[test]
fn a_sample_weighs_what_evaluating_it_says() {
    for seed in 0..600 {
        let surface = any_surface(seed);
        let wo = direction(0.6, 1.0);
        let bsdf = Bsdf::new(&surface, wo.z);
        for (u_lobe, u) in numbers(8, seed) {
            let Some(s) = bsdf.sample(wo, u_lobe, u).filter(|s| !s.event.is_delta) else { continue };
            let (f, pdf) = bsdf.eval(wo, s.wi);
            assert!(bsdf.has_smooth_part());
            assert!((pdf - s.pdf).abs() <= 1e-5 * pdf, "{surface:?}");
            let error = f / pdf + s.weight * -1.0;
            assert!(error.to_array().iter().all(|e| e.abs() < 1e-4 * (1.0 + mean(s.weight))), "{surface:?}");
        }
    }
}
