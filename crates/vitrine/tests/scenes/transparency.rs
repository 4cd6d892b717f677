//! The course work's experiment 4.2.1: one scene behind a surface that becomes less and less transparent.

use crate::support::{at, coursework, picture};
use vitrine::math::Vec3;

const TRANSPARENCIES: [f32; 6] = [1.0, 0.8, 0.6, 0.4, 0.2, 0.0];

/// How bright points of the ground are at each of the six transparencies.
fn brightness(points: &[Vec3]) -> Vec<Vec<f32>> {
    let project = coursework("transparent-sphere");
    let shown = TRANSPARENCIES.map(|t| {
        let change = format!("object.shell.material.transparency={t}");
        let image = picture(&project, &["settings.size=[320,320]", "settings.samples=1", &change]);
        points.iter().map(|p| at(&project, &image, *p).luminance()).collect()
    });
    shown.to_vec()
}

fn falls_all_along(values: &[f32], least: f32) -> bool {
    values.windows(2).all(|pair| pair[0] - pair[1] > least)
}

/// C19: the less transparent the sphere, the darker its shadow.
#[test]
fn c19_the_shadow_of_the_sphere_grows_darker() {
    // In the sphere's shadow, beside the sphere; and in the open.
    let [shade, open] = [Vec3::new(2.9, 0.0, -0.3), Vec3::new(1.0, 0.0, 2.4)];
    let shown = brightness(&[shade, open]);
    let shares: Vec<f32> = shown.iter().map(|b| b[0] / b[1]).collect();
    assert!(falls_all_along(&shares, 0.01), "{shares:?}");
    assert!(shares[0] > 0.85, "a sphere that nobody sees casts no shadow: {shares:?}");
    assert!(shares[5] < 0.45, "{shares:?}");
    let opens: Vec<f32> = shown.iter().map(|b| b[1]).collect();
    assert!(opens.iter().all(|b| (b - opens[0]).abs() < 1e-6), "the open ground is as it was: {opens:?}");
}

/// C19: the light that the sphere lets through on its way in and out again falls as the square of its transparency.
#[test]
fn c19_the_shadow_of_the_sphere_follows_the_square_of_its_transparency() {
    let shown = brightness(&[Vec3::new(2.9, 0.0, -0.3)]);
    let (whole, none) = (shown[0][0], shown[5][0]);
    for (t, b) in TRANSPARENCIES.iter().zip(&shown) {
        let share = (b[0] - none) / (whole - none);
        assert!((share - t * t).abs() < 1e-3, "{share} at {t}");
    }
}

/// C19: at the same time the shadows of the things inside fade, those that reach out of the sphere …
#[test]
fn c19_the_inner_shadows_that_reach_out_fade() {
    // Near the tip of the cone's shadow, and beside it.
    let shown = brightness(&[Vec3::new(1.96, 0.0, -0.97), Vec3::new(2.2, 0.0, -0.6)]);
    let contrasts: Vec<f32> = shown.iter().map(|b| (b[1] - b[0]) / b[1]).collect();
    assert!(contrasts[0] > 0.5, "{contrasts:?}");
    assert!(falls_all_along(&contrasts, 0.01), "{contrasts:?}");
    assert!(contrasts[5].abs() < 0.01, "an opaque sphere leaves nothing of them: {contrasts:?}");
}

/// C19: … and those that one sees through it.
#[test]
fn c19_the_inner_shadows_seen_through_the_sphere_fade() {
    // In the ball's shadow, and before it.
    let shown = brightness(&[Vec3::new(-0.05, 0.0, 0.14), Vec3::new(-0.05, 0.0, 0.75)]);
    let contrasts: Vec<f32> = shown.iter().map(|b| b[1] - b[0]).collect();
    assert!(contrasts[0] > 0.2, "{contrasts:?}");
    assert!(falls_all_along(&contrasts[..5], 0.005), "{contrasts:?}");
}
