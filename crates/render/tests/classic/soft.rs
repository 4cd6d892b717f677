//! C8 and C12: the disc lamp and its soft shadows, against areas and integrals.

use crate::common::{Shot, cuboid, flat, glass, matte, plane, v};
use vitrine_math::{Rgb, Vec3};

/// White ground under a disc lamp at height 4, half hidden by a black sheet at height 2 whose rim lies at x = `rim`.
fn half_hidden(radius: f32, rim: f32) -> Shot {
    let mut shot = Shot::probe(v(0.0, 0.2, 0.3), Vec3::ZERO);
    shot.put(plane(), matte(Rgb::WHITE));
    shot.put(cuboid(v(100.0, 1e-4, 100.0)), flat(Rgb::BLACK)).position = v(rim - 50.0, 2.0, 0.0);
    shot.disc(v(0.0, 4.0, 0.0), radius, 1.0);
    shot.scene.settings.shadow_error = 0.0;
    shot
}

/// ∫ over the visible part of the disc of ⟨N, L⟩ dA, over the disc's area, seen from the origin: strips along z.
fn truth(radius: f64, rim: f64) -> f64 {
    let (from, n) = (2.0 * rim, 4000);
    let from = from.max(-radius);
    let step = (radius - from) / f64::from(n);
    let mut sum = 0.0;
    for i in 0..n {
        let x = from + (f64::from(i) + 0.5) * step;
        let half = (radius * radius - x * x).max(0.0).sqrt();
        // ∫ 4/√(16 + x² + z²) dz = 4·asinh(z/√(16 + x²))
        sum += 8.0 * (half / (16.0 + x * x).sqrt()).asinh() * step;
    }
    sum / (std::f64::consts::PI * radius * radius)
}

/// The pixel with many seeds.
fn seen(shot: &Shot, seeds: u32) -> Vec<f64> {
    let scene = shot.compiled();
    (0..seeds)
        .map(|seed| {
            let mut options = shot.options();
            options.settings.seed = seed;
            f64::from(crate::common::run(&scene, options, 1).film.image().pixel(0, 0).g)
        })
        .collect()
}

fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64;
    (mean, variance.sqrt())
}

#[test]
fn c8_c12_the_visible_part_of_the_disc_is_what_lights() {
    const SEEDS: u32 = 400;
    for radius in [0.1_f32, 1.0] {
        for part in [-1.1_f32, -0.6, -0.2, 0.0, 0.3, 0.9, 1.1] {
            let rim = 0.5 * part * radius;
            let truth = truth(f64::from(radius), f64::from(rim));
            let mut shot = half_hidden(radius, rim);
            shot.scene.settings.shadow_points = 256;
            let (mean, deviation) = mean_and_deviation(&seen(&shot, SEEDS));
            let allowed = 3.5 * deviation / f64::from(SEEDS).sqrt() + 2e-5;
            assert!((mean - truth).abs() < allowed, "radius {radius}, {part}: {mean} in place of {truth}");
            assert!(allowed < 1.5e-3, "the test is sharp: {allowed}");
        }
    }
}

#[test]
fn c8_a_small_disc_is_hidden_by_the_area_of_a_segment() {
    // Far above, all of the disc shines straight down: the light is the visible area alone.
    for part in [-0.8_f64, -0.3, 0.0, 0.5, 0.95] {
        let area = part.acos() - part * (1.0 - part * part).sqrt();
        assert!((truth(0.01, 0.005 * part) - area / std::f64::consts::PI).abs() < 1e-4, "the oracle itself");
        let mut shot = half_hidden(0.01, 0.005 * part as f32);
        shot.scene.settings.shadow_points = 1024;
        let (mean, _) = mean_and_deviation(&seen(&shot, 100));
        assert!((mean - area / std::f64::consts::PI).abs() < 5e-4, "{part}: {mean}");
    }
}

#[test]
fn c12_stratified_points_converge_faster_than_random_ones() {
    // Random points: σ ~ N^(−1/2). A straight edge through strata: N^(−3/4).
    let deviation = |points: u32| {
        let mut shot = half_hidden(1.0, 0.13);
        shot.scene.settings.shadow_points = points;
        mean_and_deviation(&seen(&shot, 300)).1
    };
    let (few, many) = (deviation(16), deviation(1024));
    let order = (few / many).ln() / 64.0_f64.ln();
    assert!(order > 0.68, "the error falls with the power {order}");
    assert!(few < 0.5 * (0.25_f64 / 16.0).sqrt(), "16 stratified points: {few}");
}

#[test]
fn c12_shadow_points_are_all_used_at_error_0_and_few_where_the_shadow_is_plain() {
    let rays = |shot: &Shot, points: u32, error: f32| {
        let mut shot = shot.clone();
        (shot.scene.settings.shadow_points, shot.scene.settings.shadow_error) = (points, error);
        shot.rendered(1, None).rays - 1
    };
    let half = half_hidden(1.0, 0.0);
    for points in [1, 5, 16, 17, 64, 100, 4096] {
        assert_eq!(rays(&half, points, 0.0), u64::from(points));
    }
    let lit = half_hidden(1.0, -50.0);
    let (in_light, in_half_shadow) = (rays(&lit, 4096, 0.02), rays(&half, 4096, 0.02));
    assert!(in_light < 200, "{in_light} rays where nothing stands in the light");
    assert!(in_half_shadow > 2 * in_light, "{in_half_shadow} where the lamp is half hidden");
    assert!(rays(&half, 4096, 0.005) > 4 * in_half_shadow, "better quality takes more");
}

#[test]
fn c12_the_asked_for_error_is_kept() {
    for error in [0.05_f32, 0.02, 0.01] {
        for rim in [-0.3, 0.0, 0.2] {
            let mut shot = half_hidden(1.0, rim);
            (shot.scene.settings.shadow_points, shot.scene.settings.shadow_error) = (4096, error);
            let (mean, deviation) = mean_and_deviation(&seen(&shot, 200));
            assert!(deviation < f64::from(error), "{deviation} in place of {error}");
            let off = (mean - truth(1.0, f64::from(rim))).abs();
            assert!(off < 0.25 * f64::from(error), "stopping early leans by {off}");
        }
    }
}

#[test]
fn c8_a_disc_in_the_open_lights_like_its_integral_and_a_tiny_one_like_a_bulb() {
    let open = |radius: f32| {
        let mut shot = half_hidden(radius, -90.0);
        shot.scene.settings.shadow_points = 1024;
        mean_and_deviation(&seen(&shot, 20)).0
    };
    assert!((open(3.0) - truth(3.0, -90.0)).abs() < 1e-4);
    let mut bulb = half_hidden(1.0, -90.0);
    bulb.scene.lights.clear();
    bulb.point(v(0.0, 4.0, 0.0), 1.0);
    assert!((open(1e-4) - f64::from(bulb.pixel().g)).abs() < 1e-6);
}

#[test]
fn c8_the_disc_lies_level() {
    // A wall at x = 0 hides half of a disc above it, whatever the height; seen edge-on, from its own height, nothing is hidden.
    let mut shot = Shot::probe(v(0.5, 3.999, 2.0), v(0.0, 3.999, 0.0));
    shot.put(cuboid(v(0.1, 1.0, 1.0)), matte(Rgb::WHITE)).position = v(-0.05, 3.999, 0.0);
    shot.disc(v(3.0, 4.0, 0.0), 1.0, 1.0);
    // The wall faces +x, and the disc, at its height, stands squarely before it: ⟨N, L⟩ is 1 but for the disc's width along z.
    let seen = shot.pixel().g;
    let mean_cos = {
        let mut sum = 0.0;
        let n = 400;
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let [x, z] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(n) * 2.0 - 1.0);
            if x * x + z * z < 1.0 {
                sum += (3.0 + x) / ((3.0 + x).powi(2) + z * z).sqrt() * 4.0 / f64::from(n * n);
            }
        }
        sum / std::f64::consts::PI
    };
    assert!((f64::from(seen) - mean_cos).abs() < 2e-3, "{seen} in place of {mean_cos}");
}

#[test]
fn c8_two_lamps_have_their_own_points_and_add_up() {
    let one = half_hidden(1.0, 0.1);
    let mut two = one.clone();
    two.disc(v(0.0, 4.0, 0.0), 1.0, 1.0);
    let (one, two) = (seen(&one, 300), seen(&two, 300));
    let ((m1, d1), (m2, d2)) = (mean_and_deviation(&one), mean_and_deviation(&two));
    assert!((m2 - 2.0 * m1).abs() < 3.5 * (2.0 * d1 + d2) / 300.0_f64.sqrt());
    // Points in common would give twice the deviation; independent ones give √2 times.
    assert!(d2 < 1.75 * d1, "{d2} against {d1}");
}

#[test]
fn c12_soft_shadows_of_transparent_things_are_faint_in_proportion() {
    let t = 0.6;
    let mut shot = half_hidden(1.0, 0.0);
    shot.scene.materials[1] = vitrine_scene::Material { name: "material 1".into(), ..glass(Rgb::BLACK, t) };
    shot.scene.settings.shadow_points = 256;
    let (open, half) = (truth(1.0, -90.0), truth(1.0, 0.0));
    let share = f64::from(t * t);
    let (mean, _) = mean_and_deviation(&seen(&shot, 200));
    assert!((mean - (half + (open - half) * share)).abs() < 1e-3, "{mean}");
}

#[test]
fn c12_points_differ_from_pixel_to_pixel_and_from_sample_to_sample() {
    let mut shot = half_hidden(1.0, 0.0);
    shot.scene.settings.size = [32, 32];
    shot.scene.camera.view_angle_deg = 1.0;
    shot.scene.settings.shadow_points = 16;
    let deviation = |shot: &Shot| {
        let values: Vec<f64> = shot.picture().pixels.iter().map(|p| f64::from(p.g)).collect();
        mean_and_deviation(&values).1
    };
    let one = deviation(&shot);
    assert!(one > 1e-3, "neighbours differ: {one}");
    shot.scene.settings.samples = 16;
    let many = deviation(&shot);
    assert!(many < 0.4 * one, "samples of a pixel differ: {many} against {one}");
}
