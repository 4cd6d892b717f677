//! What is seen through panes, water and prisms: how bright it is, what colour it has, and where it is seen.

use crate::common::{
    Measured, Rgb, Shot, Vec3, ball, bulb, clear, cuboid, disc, fresnel, glowing, measure, measuring, plane,
    solid, tinted, v,
};
use vitrine_scene::TriangleMesh;

/// A wall that glows behind z = 0, seen at so many degrees from its normal; what is reflected is black.
fn before_a_wall(angle_deg: f32) -> Shot {
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let mut shot = measuring(v(5.0 * sin, 0.0, 5.0 * cos), Vec3::ZERO);
    let wall = shot.put(plane(), glowing(1.0));
    (wall.position, wall.turn_deg) = (v(0.0, 0.0, -2.0), v(90.0, 0.0, 0.0));
    shot
}

fn panes(angle_deg: f32, count: u32, unpolarised: bool) -> Measured {
    let mut shot = before_a_wall(angle_deg);
    for k in 0..count {
        shot.put(cuboid(v(20.0, 20.0, 0.01)), clear(1.5)).position.z = k as f32 * 0.05;
    }
    shot.scene.settings.unpolarised = unpolarised;
    measure(&shot, 2048)
}

#[test]
fn panes_let_through_what_fresnel_says() {
    // (1−R)/(1+R), and for N panes (1−R)/(1+(2N−1)R)
    panes(0.0, 1, false).assert_is_grey(0.923_077, 1e-3);
    panes(0.0, 2, false).assert_is_grey(0.857_143, 2e-3);
    panes(0.0, 4, false).assert_is_grey(0.96 / 1.28, 2e-3);
}

#[test]
fn at_a_slant_both_polarisations_go_their_own_ways() {
    for (angle, truth, averaged) in [(70.0, 0.7287, 0.7079), (80.0, 0.4585, 0.4412)] {
        let [s, p] = fresnel(f64::to_radians(angle).cos(), 1.5);
        let passed = |r: f64| (1.0 - r) / (1.0 + r);
        let exact = 0.5 * (passed(s) + passed(p));
        assert!((exact - truth).abs() < 1e-4, "{exact}");
        panes(angle as f32, 1, false).assert_is_grey(exact, 5e-3);
        let exact = passed(0.5 * (s + p));
        assert!((exact - averaged).abs() < 1e-4, "{exact}");
        panes(angle as f32, 1, true).assert_is_grey(exact, 5e-3);
        // Three panes of each polarisation.
        let passed = |r: f64| (1.0 - r) / (1.0 + 5.0 * r);
        panes(angle as f32, 3, false).assert_is_grey(0.5 * (passed(s) + passed(p)), 1e-2);
    }
}

#[test]
fn after_the_stated_depth_glass_has_the_stated_colour() {
    // τ = (1−R)²A/(1−R²A²), with A = c^(ℓ/d): c itself at ℓ = d
    let color = Rgb::new(0.8, 0.5, 0.2);
    for length in [0.1_f32, 0.25] {
        let mut shot = before_a_wall(0.0);
        shot.put(cuboid(v(0.4, 0.4, length)), tinted(1.5, color, 0.1));
        let truth = color.to_array().map(|c| {
            let (a, r) = (c.powf(length / 0.1), 0.04_f32);
            (1.0 - r).powi(2) * a / (1.0 - r * r * a * a)
        });
        measure(&shot, 1024).assert_is(Rgb::from(truth), 5e-3);
    }
}

#[test]
fn a_sheet_is_a_pane_without_thickness() {
    let mut shot = before_a_wall(0.0);
    shot.put(disc(3.0), clear(1.5)).turn_deg = v(90.0, 0.0, 0.0);
    measure(&shot, 1024).assert_is_grey(0.923_077, 2e-3);
    // Two surfaces of glass and what lies between them: T = (1−F)²A/(1−F²A²)
    let mut shot = before_a_wall(0.0);
    let tint = vitrine_scene::Material { transmission_color: Some(Rgb::splat(0.5)), ..clear(1.5) };
    shot.put(disc(3.0), tint).turn_deg = v(90.0, 0.0, 0.0);
    let (f, a) = (0.04_f64, 0.5_f64);
    measure(&shot, 1024).assert_is_grey((1.0 - f).powi(2) * a / (1.0 - f * f * a * a), 5e-3);
}

#[test]
fn things_in_water_are_seen_raised() {
    // The rim of a disc at depth d is seen at the angle θ with r = h·tanθ + d·sinθ/√(n²−sin²θ), and its radiance as (1−F)/n².
    let (n, height, depth) = (1.333_f64, 1.0_f64, 0.8_f64);
    for angle in [2.0_f64, 35.0, 60.0] {
        let (sin, cos) = angle.to_radians().sin_cos();
        let rim = height * sin / cos + depth * sin / (n * n - sin * sin).sqrt();
        for (share, is_seen) in [(0.99, false), (1.01, true)] {
            // The camera looks at the point of the surface through which the rim is seen.
            let mut shot = measuring(v(0.0, height as f32, 0.0), v((height * sin / cos) as f32, 0.0, 0.0));
            shot.put(plane(), solid(clear(n as f32)));
            shot.put(disc((rim * share) as f32), glowing(1.0)).position.y = -depth as f32;
            let passed = 1.0 - fresnel(cos, n).iter().sum::<f64>() * 0.5;
            let truth = if is_seen { passed / (n * n) } else { 0.0 };
            measure(&shot, 256).assert_is_grey(truth, 5e-3);
        }
    }
}

#[test]
fn from_under_water_the_sky_is_a_window() {
    // Snell's window ends at asin(1/n) from the vertical, 48.61° for n = 1.333. Inside radiance is n² times that of the sky, less
    // what is reflected.
    let n = 1.333_f64;
    let edge = (1.0 / n).asin().to_degrees();
    for (angle, is_sky) in [(0.0, true), (30.0, true), (edge - 0.3, true), (edge + 0.3, false), (70.0, false)]
    {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let eye = v(0.0, -1.0, 0.0);
        let mut shot = measuring(eye, eye + v(sin as f32, cos as f32, 1e-4));
        shot.put(plane(), solid(clear(n as f32)));
        shot.scene.settings.background = Rgb::WHITE;
        // The floor is black, so that total reflection shows nothing.
        shot.put(plane(), crate::common::white(0.0)).position.y = -3.0;
        let out = n * sin;
        let passed =
            if is_sky { 1.0 - 0.5 * fresnel((1.0 - out * out).sqrt(), n).iter().sum::<f64>() } else { 0.0 };
        measure(&shot, 256).assert_is_grey(passed * n * n, 1e-2);
    }
}

/// A prism of that many degrees whose edge is along y.
pub fn prism(angle_deg: f32) -> TriangleMesh {
    let (sin, cos) = (angle_deg.to_radians() * 0.5).sin_cos();
    let corners = [(0.0, cos), (-sin, 0.0), (sin, 0.0)];
    let ring = |y: f32| corners.map(|(x, z)| v(x, y, z));
    let positions = [ring(-2.0), ring(2.0)].concat();
    let mut triangles = vec![[0, 1, 2], [5, 4, 3]];
    for k in 0..3_u32 {
        let next = (k + 1) % 3;
        triangles.extend([[k, k + 3, next], [next, k + 3, next + 3]]);
    }
    TriangleMesh { positions, triangles, ..TriangleMesh::default() }
}

#[test]
fn a_prism_turns_light_by_its_least_deviation() {
    // δ = 2·asin(n·sin(A/2)) − A: 37.18° for n = 1.5, A = 60°. Inside, the ray runs along x in the middle of the prism.
    let (n, apex) = (1.5_f64, 60.0_f64);
    let incidence = (n * (apex * 0.5).to_radians().sin()).asin();
    let deviation = 2.0 * incidence - apex.to_radians();
    assert!((deviation.to_degrees() - 37.18).abs() < 0.01);
    let [s, p] = fresnel(incidence.cos(), n);
    let passed = 0.5 * ((1.0 - s).powi(2) + (1.0 - p).powi(2));
    // It bends towards the base, −z: the ray comes to its side and leaves it with half of the deviation each.
    let (sin, cos) = (deviation * 0.5).sin_cos();
    let height = 0.4_f32;
    let entry = v(-0.5 * (1.0 - height / 0.866_025_4), 0.0, height);
    for (off_deg, is_seen) in [(0.0, true), (-0.6, false), (0.6, false)] {
        let mut shot = measuring(entry - v(cos as f32, 0.0, sin as f32) * 3.0, entry);
        let shape = shot.model(prism(apex as f32));
        shot.put(shape, clear(n as f32));
        let (sin, cos) = (deviation * 0.5 + f64::to_radians(off_deg)).sin_cos();
        let exit = v(-entry.x, 0.0, height);
        bulb(&mut shot, exit + v(cos as f32, 0.0, -sin as f32) * 100.0, 0.5, 1.0);
        measure(&shot, 512).assert_is_grey(if is_seen { passed } else { 0.0 }, 5e-3);
    }
}

#[test]
fn a_ball_shows_the_world_upside_down() {
    // Through the middle, light goes straight on: (1−R)²/(1−R²) as through a pane.
    let mut shot = before_a_wall(0.0);
    shot.put(ball(0.5), clear(1.5));
    measure(&shot, 1024).assert_is_grey(0.923_077, 5e-3);
}
