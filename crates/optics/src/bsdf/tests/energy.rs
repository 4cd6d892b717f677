//! The white furnace: a surface that absorbs nothing cannot be seen in even light.

use super::*;

/// How bright the surface looks in light of radiance 1 above and η² below, and no less than four standard deviations of
/// that, both of the green channel.
fn furnace(surface: &Surface, cos: f32) -> (f64, f64) {
    const N: u32 = 40_000;
    let (wo, bsdf) = (direction(cos, 0.7), Bsdf::new(surface, cos));
    let (mut sum, mut squares) = (0.0_f64, 0.0_f64);
    for (u_lobe, u) in numbers(N, 5) {
        let Some(s) = bsdf.sample(wo, u_lobe, u) else { continue };
        let crosses = s.event.is_transmission && !surface.thin_walled;
        let light = if crosses { surface.eta * surface.eta } else { 1.0 };
        let seen = f64::from(s.weight.g * light);
        sum += seen;
        squares += seen * seen;
    }
    let n = f64::from(N);
    let mean = sum / n;
    (mean, 4.0 * ((squares / n - mean * mean).max(0.0) / n).sqrt())
}

const COSINES: [f32; 6] = [1.0, 0.8, 0.5, 0.2, 0.1, 0.05];

/// No energy is made, and no more than `loss` is lost.
fn assert_furnace(name: &str, surface: &Surface, gain: f64, loss: f64) {
    for cos in COSINES {
        let (mean, noise) = furnace(surface, cos);
        assert!(mean < 1.0 + gain + noise, "{name} at {cos}: {mean} makes energy");
        assert!(mean > 1.0 - loss - noise, "{name} at {cos}: {mean} loses energy");
    }
}

#[test]
fn smooth_surfaces_lose_nothing() {
    let film = Surface { thin_film_weight: 1.0, ..glass(0.0) };
    let soap = Surface { thin_film_weight: 1.0, thin_film_ior: 1.5, ..pane(0.0) };
    let coated = |surface: Surface| Surface { coat_weight: 1.0, ..surface };
    for (name, surface) in [
        ("glass", glass(0.0)),
        ("glass from inside", from_inside(glass(0.0))),
        ("half as reflecting glass", Surface { specular_weight: 0.5, ..glass(0.0) }),
        ("pane", pane(0.0)),
        ("glass with a film", film),
        ("glass with a film from inside", from_inside(film)),
        ("soap", soap),
        ("mirror", metal(0.0)),
        ("coated mirror", coated(metal(0.0))),
        ("coated glass", coated(glass(0.0))),
        ("coated glass from inside", from_inside(coated(glass(0.0)))),
        ("half coated glass", Surface { coat_weight: 0.5, ..glass(0.0) }),
    ] {
        assert_furnace(name, &surface, 1e-5, 1e-5);
    }
}

#[test]
fn matte_surfaces_lose_nothing() {
    let lambert = Surface { specular_weight: 0.0, ..white() };
    assert_furnace("lambert", &lambert, 1e-6, 1e-6);
    assert_furnace("rough", &Surface { diffuse_roughness: 1.0, ..lambert }, 2e-3, 2e-3);
}

#[test]
fn plastic_loses_nothing() {
    for roughness in [0.0, 0.05, 0.1, 0.3, 0.6, 1.0] {
        let plastic = Surface { roughness, ..white() };
        assert_furnace(&format!("plastic {roughness}"), &plastic, 0.006, 0.01);
        // The rough ground is not quite even towards the horizon, where the surface lets less through.
        let dusty = Surface { diffuse_roughness: 1.0, ..plastic };
        assert_furnace(&format!("dusty plastic {roughness}"), &dusty, 0.006, 0.03);
    }
}

#[test]
fn rough_metal_loses_nothing() {
    for roughness in [0.05, 0.1, 0.2, 0.4, 0.7, 1.0] {
        assert_furnace(&format!("metal {roughness}"), &metal(roughness), 0.005, 0.01);
    }
}

#[test]
fn rough_glass_loses_nothing_on_either_side() {
    for roughness in [0.05, 0.1, 0.2, 0.4, 0.7, 1.0] {
        for eta in [1.1, 1.33, 1.5, 2.4] {
            let surface = Surface { eta, ..glass(roughness) };
            assert_furnace(&format!("glass {eta} {roughness}"), &surface, 0.01, 0.012);
            let inside = from_inside(surface);
            assert_furnace(&format!("glass {eta} {roughness} from inside"), &inside, 0.01, 0.012);
        }
        assert_furnace(&format!("pane {roughness}"), &pane(roughness), 0.005, 0.01);
    }
}

#[test]
fn layers_lose_next_to_nothing() {
    let coated = |surface: Surface| Surface { coat_weight: 1.0, ..surface };
    let rough_coat = |surface: Surface| Surface { coat_roughness: 0.4, ..coated(surface) };
    for (name, surface) in [
        ("coated plastic", coated(white())),
        ("rough coated plastic", rough_coat(white())),
        ("coated metal", coated(metal(0.3))),
        ("coated rough metal", coated(metal(0.7))),
        ("rough coated mirror", rough_coat(metal(0.0))),
        ("coated rough glass", coated(glass(0.4))),
        ("plastic with a film", Surface { thin_film_weight: 1.0, ..white() }),
        ("metal, glass and plastic", Surface { metalness: 0.3, transmission: 0.5, ..white() }),
        ("all", Surface { metalness: 0.3, transmission: 0.5, coat_weight: 0.5, ..white() }),
    ] {
        assert_furnace(name, &surface, 0.012, 0.03);
    }
}

#[test]
fn darker_surfaces_give_less() {
    for surface in [white(), metal(0.5), Surface { coat_weight: 1.0, ..white() }] {
        let dark = Surface { base_color: Rgb::splat(0.3), ..surface };
        let (mean, _) = furnace(&dark, 0.7);
        assert!(mean < 0.5 && mean > 0.15, "{mean}");
    }
}
