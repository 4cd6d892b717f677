//! Values from the optics of glass, and reciprocity.

use super::*;
use crate::fresnel;
use crate::metals::MeasuredMetal;

/// What is mirrored and what goes through a smooth surface, the green channel of radiance.
fn shares(surface: &Surface, cos: f32) -> (f32, f32) {
    let (wo, bsdf) = (direction(cos, 0.3), Bsdf::new(surface, cos));
    let share = |u: f32, is_transmission: bool| {
        bsdf.sample(wo, u, [0.5; 2])
            .filter(|s| s.event.is_transmission == is_transmission)
            .map_or(0.0, |s| s.weight.g * s.pdf)
    };
    (share(0.0, false), share(0.999_999_9, true))
}

#[test]
fn glass_mirrors_4_percent_and_thins_out_radiance_by_its_index_squared() {
    let (r, t) = shares(&glass(0.0), 1.0);
    assert!((r - 0.04).abs() < 1e-6);
    assert!((t - 0.96 / 2.25).abs() < 1e-6);
    let (r, t) = shares(&from_inside(glass(0.0)), 1.0);
    assert!((r - 0.04).abs() < 1e-6);
    assert!((t - 0.96 * 2.25).abs() < 1e-5);
}

#[test]
fn light_in_glass_is_caught_beyond_the_critical_angle() {
    let cos = |deg: f32| deg.to_radians().cos();
    let inside = from_inside(glass(0.0));
    assert!(shares(&inside, cos(41.7)).1 > 0.0);
    assert_eq!(shares(&inside, cos(41.9)), (1.0, 0.0));
}

#[test]
fn a_pane_lets_through_what_theory_says_for_both_polarisations() {
    for (deg, through) in [(0.0_f32, 0.923_08), (70.0, 0.728_7), (80.0, 0.458_5)] {
        let (r, t) = shares(&pane(0.0), deg.to_radians().cos());
        assert!((t - through).abs() < 1e-4, "{deg}°: {t}");
        assert!((r + t - 1.0).abs() < 1e-6);
    }
}

#[test]
fn a_pane_lets_84_percent_of_even_light_through() {
    const N: u16 = 20_000;
    let through: f64 = (0..N)
        .map(|i| (f32::from(i) + 0.5) / f32::from(N))
        .map(|cos| {
            // Without polarisation, as the stated value is.
            let f = fresnel::dielectric(cos, 1.5);
            2.0 * f64::from(cos * (1.0 - f) / (1.0 + f)) / f64::from(N)
        })
        .sum();
    assert!((through - 0.844_56).abs() < 1e-4, "{through}");
    let polarised: f64 = (0..N)
        .map(|i| (f32::from(i) + 0.5) / f32::from(N))
        .map(|cos| 2.0 * f64::from(cos * shares(&pane(0.0), cos).1) / f64::from(N))
        .sum();
    assert!(polarised > through && polarised < through + 0.02, "{polarised}");
}

#[test]
fn a_coloured_pane_absorbs_along_the_way_through_it() {
    let tinted = Surface { thin_absorption: Rgb::splat(0.5), ..pane(0.0) };
    let (r, t) = shares(&tinted, 1.0);
    // T = (1 − F)²A/(1 − F²A²), R = F(1 + (1 − F)²A²/(1 − F²A²))
    let bounced = 0.96_f32 * 0.96 / (1.0 - 0.04 * 0.04 * 0.25);
    assert!((t - bounced * 0.5).abs() < 1e-6, "{t}");
    assert!((r - 0.04 * (1.0 + bounced * 0.25)).abs() < 1e-6, "{r}");
    assert!(shares(&tinted, 0.2).1 / shares(&pane(0.0), 0.2).1 < 0.47, "the way is longer");
}

#[test]
fn a_soap_film_is_iridescent() {
    let soap = |thickness| Surface {
        eta: 1.33,
        thin_film_weight: 1.0,
        thin_film_ior: 1.33,
        thin_film_thickness: thickness,
        ..pane(0.0)
    };
    let mirrored = |thickness: f32| {
        let s = Bsdf::new(&soap(thickness), 0.8).sample(direction(0.8, 0.0), 0.0, [0.5; 2]).unwrap();
        s.weight * s.pdf
    };
    // Black while thin, then in changing colours.
    assert!(mirrored(0.005).g < 0.005);
    for thickness in [0.25, 0.4, 0.5] {
        let c = mirrored(thickness).to_array();
        let (least, most) = (c.iter().copied().fold(1.0, f32::min), c.iter().copied().fold(0.0, f32::max));
        assert!(most > 1.4 * least, "{thickness} µm: {c:?}");
    }
}

#[test]
fn gold_mirrors_as_measured() {
    let (n, k) = MeasuredMetal::Gold.index();
    let gold = Surface { metal: Some((n, k)), ..metal(0.0) };
    for cos in [1.0_f32, 0.5, 0.1] {
        let s = Bsdf::new(&gold, cos).sample(direction(cos, 0.0), 0.3, [0.5; 2]).unwrap();
        assert_eq!(s.weight, fresnel::conductor(cos, n, k));
    }
}

#[test]
fn a_clear_coat_of_the_same_index_changes_nothing_and_a_coloured_one_tints_twice() {
    let coat = Surface { coat_weight: 1.0, coat_ior: 1.5, ..glass(0.0) };
    assert!((shares(&coat, 0.6).0 - shares(&glass(0.0), 0.6).0).abs() < 1e-5);
    let color = Rgb::splat(0.64);
    let tinted = Surface { coat_weight: 1.0, coat_color: color, coat_ior: 1.5, ..metal(0.0) };
    let (r, _) = shares(&tinted, 1.0);
    // F + (1 − F)²·c/(1 − F): the mirror gives all back.
    assert!((r - (0.04 + 0.96 * 0.64)).abs() < 1e-4, "{r}");
}

#[test]
fn coated_glass_lets_the_same_through_both_ways() {
    let color = Rgb::new(0.9, 0.5, 0.2);
    let outside = Surface { coat_weight: 1.0, coat_color: color, coat_ior: 1.7, ..glass(0.0) };
    for cos in [1.0_f32, 0.7, 0.3, 0.05] {
        let cos_t = (1.0 - (1.0 - cos * cos) / 2.25).sqrt();
        let (into, out) = (shares(&outside, cos).1 * 2.25, shares(&from_inside(outside), cos_t).1 / 2.25);
        assert!((into - out).abs() < 2e-4, "{cos}: {into} {out}");
    }
}

#[test]
fn every_lobe_is_reciprocal() {
    let coated = |surface: Surface| Surface { coat_weight: 1.0, ..surface };
    for (name, surface) in [
        ("dusty plastic", Surface { diffuse_roughness: 0.8, ..white() }),
        ("metal", metal(0.4)),
        ("glass", glass(0.4)),
        ("glass from inside", from_inside(glass(0.4))),
        ("pane", pane(0.4)),
        ("film", Surface { thin_film_weight: 1.0, ..metal(0.4) }),
        ("coated metal", coated(metal(0.4))),
        ("rough coated plastic", Surface { coat_roughness: 0.3, ..coated(white()) }),
    ] {
        let eta2 = if surface.thin_walled { 1.0 } else { surface.eta * surface.eta };
        for seed in 0..400_u32 {
            let unit = |k: u32| hash::unit(hash::join(hash::mix(seed), k));
            let wo = direction(0.02 + 0.97 * unit(0), std::f32::consts::TAU * unit(1));
            let wi = direction(0.02 + 0.97 * unit(2), std::f32::consts::TAU * unit(3));
            let there = Bsdf::new(&surface, wo.z).f_cos(wo, wi).g / wi.z;
            let back = Bsdf::new(&surface, wi.z).f_cos(wi, wo).g / wo.z;
            assert!((there - back).abs() < 2e-3 * (there + back) + 1e-6, "{name}: {there} {back}");
            // Through: f(wi → wo)·η² = f(wo → wi), each as its own side sees it.
            let through = Bsdf::new(&surface, wo.z).f_cos(wo, -wi).g / wi.z * eta2;
            let other = if surface.thin_walled { surface } else { from_inside(surface) };
            let back = Bsdf::new(&other, wi.z).f_cos(wi, -wo).g / wo.z;
            assert!((through - back).abs() < 5e-3 * (through + back) + 1e-5, "{name}: {through} {back}");
        }
    }
}
