//! Lamps light a white floor as the formulas of radiometry say. A white surface shows E/π.

use crate::common::{
    Rgb, Shot, Vec3, ball, bulb, clear, cuboid, fresnel, glowing, measure, measuring, plane, v, white,
};
use vitrine_scene::lights::Disc;
use vitrine_scene::{LightSource, Shape};

/// A floor at y = 0, seen in the origin, where only light that comes straight or through solved connections counts.
fn floor() -> Shot {
    let mut shot = measuring(v(0.5, 0.3, 0.4), Vec3::ZERO);
    shot.put(plane(), white(1.0));
    shot.scene.settings.bounces = 2;
    shot
}

fn disc_lamp(shot: &mut Shot, position: Vec3, radius: f32, radiance: f32) {
    shot.light(LightSource::Disc(Disc { position, radius }), radiance).full_at = Some(radius);
}

#[test]
fn a_disc_lamp_on_the_axis() {
    // E = π·L·r²/(r² + h²)
    let (r, h) = (0.5_f64, 0.8_f64);
    let mut shot = floor();
    disc_lamp(&mut shot, v(0.0, h as f32, 0.0), r as f32, 3.0);
    measure(&shot, 256).assert_is_grey(3.0 * r * r / (r * r + h * h), 1e-3);
}

#[test]
fn a_disc_lamp_beside_the_axis() {
    // E = π·L·½[1 − (1 + H² − Q²)/√(Z² − 4Q²)], H = h/a, Q = r/a, Z = 1 + H² + Q²
    let (r, h, a) = (0.5_f64, 0.8_f64, 0.7_f64);
    let (h2, q2) = ((h / a).powi(2), (r / a).powi(2));
    let z = 1.0 + h2 + q2;
    let truth = 0.5 * (1.0 - (1.0 + h2 - q2) / (z * z - 4.0 * q2).sqrt());
    let mut shot = floor();
    disc_lamp(&mut shot, v(a as f32, h as f32, 0.0), r as f32, 3.0);
    measure(&shot, 256).assert_is_grey(3.0 * truth, 1e-3);
    // A glowing disc that looks down is the same.
    let mut shot = floor();
    let lamp = shot.put(Shape::Disc(vitrine_scene::shapes::Disc { radius: r as f32 }), glowing(3.0));
    (lamp.position, lamp.turn_deg) = (v(a as f32, h as f32, 0.0), v(180.0, 0.0, 0.0));
    measure(&shot, 256).assert_is_grey(3.0 * truth, 1e-3);
}

#[test]
fn a_bulb_above_the_horizon() {
    // E = π·L·(R/d)²·cosθ
    let (position, r) = (v(0.9, 1.4, -0.3), 0.6_f32);
    let d2 = position.length_squared();
    let truth = 2.0 * r * r / d2 * (position.y / d2.sqrt());
    let mut shot = floor();
    bulb(&mut shot, position, r, 2.0);
    measure(&shot, 256).assert_is_grey(truth.into(), 1e-3);
    let mut shot = floor();
    shot.put(ball(r), glowing(2.0)).position = position;
    measure(&shot, 256).assert_is_grey(truth.into(), 1e-3);
}

#[test]
fn lamps_are_as_bright_as_they_say_where_they_say() {
    // A white surface that faces a lamp of intensity I shows I at the distance `full_at`.
    let mut shot = floor();
    shot.point(v(0.0, 1.5, 0.0), 0.7).full_at = Some(1.5);
    measure(&shot, 4).assert_is_grey(0.7, 1e-5);
    let mut shot = floor();
    shot.point(v(0.0, 3.0, 0.0), 0.7).full_at = Some(1.5);
    measure(&shot, 4).assert_is_grey(0.7 / 4.0, 1e-5);
    let mut shot = floor();
    shot.sun(v(0.6, -0.8, 0.0), 0.7);
    measure(&shot, 4).assert_is_grey(0.7 * 0.8, 1e-5);
}

#[test]
fn a_point_of_light_above_a_pane() {
    // E = I·(1−F)²·F^{2k}/(a + (2k+1)·d/n)² on the axis, where the light goes to and fro k times inside the pane; two
    // times are solved, what is beyond is less than a millionth.
    let (n, d, height) = (1.5_f64, 0.4_f64, 2.0_f64);
    let mut shot = floor();
    shot.put(cuboid(v(8.0, d as f32, 8.0)), clear(n as f32)).position.y = 1.1;
    shot.point(v(0.0, height as f32, 0.0), 1.0).full_at = Some(1.0);
    let [f, _] = fresnel(1.0, n);
    let order = |k: i32| {
        let a = height - d + f64::from(2 * k + 1) * d / n;
        (1.0 - f).powi(2) * f.powi(2 * k) / (a * a)
    };
    let truth: f64 = (0..3).map(order).sum();
    measure(&shot, 64).assert_is_grey(truth, 1e-4);
}

#[test]
fn sunlight_behind_a_pane() {
    // Straight through: ½Σ(1−R)/(1+R).
    let toward = v(0.6, 0.8, 0.0);
    let through =
        |pass: &dyn Fn(f64) -> f64, cos: f64| fresnel(cos, 1.5).into_iter().map(pass).sum::<f64>() * 0.5;
    let mut shot = floor();
    shot.sun(-toward, 1.0);
    shot.put(cuboid(v(20.0, 0.01, 20.0)), clear(1.5)).position.y = 1.0;
    measure(&shot, 64).assert_is_grey(0.8 * through(&|r| (1.0 - r) / (1.0 + r), 0.8), 1e-4);
}

#[test]
fn sunlight_behind_a_pane_that_is_turned() {
    // The pane's normal lies in the plane of x and y, 25° from the vertical.
    let mut shot = floor();
    shot.sun(v(-0.6, -0.8, 0.0), 1.0);
    let pane = shot.put(cuboid(v(8.0, 0.1, 8.0)), clear(1.5));
    (pane.position, pane.turn_deg) = (v(0.75, 1.0, 0.0), v(0.0, 0.0, 25.0));
    let (sin, cos) = 25.0_f64.to_radians().sin_cos();
    let passed = fresnel(-0.6 * sin + 0.8 * cos, 1.5).map(|r| (1.0 - r) / (1.0 + r));
    measure(&shot, 64).assert_is_grey(0.8 * 0.5 * (passed[0] + passed[1]), 1e-4);
}

#[test]
fn sunlight_that_a_pane_reflects() {
    // Straight, off the near face, and off the far one: 1 + F + (1−F)²F; more reflections inside carry a thousandth of that.
    let mut shot = floor();
    shot.sun(v(-0.6, -0.8, 0.0), 1.0);
    shot.put(cuboid(v(0.02, 4.0, 4.0)), clear(1.5)).position = v(-0.7, 2.05, 0.0);
    let reflected = fresnel(0.6, 1.5).map(|f| f + (1.0 - f).powi(2) * f);
    let truth = 0.8 * (1.0 + 0.5 * (reflected[0] + reflected[1]));
    measure(&shot, 64).assert_is_grey(truth, 1e-4);
}

#[test]
fn sunlight_under_water() {
    // What passes the surface, 1−F, and nothing else: its irradiance on level surfaces stays the same.
    let mut shot = measuring(v(0.5, 0.3, 0.4), Vec3::ZERO);
    shot.scene.settings.bounces = 2;
    shot.put(plane(), white(1.0));
    shot.put(plane(), crate::common::solid(clear(1.333))).position.y = 2.0;
    shot.sun(v(-0.6, -0.8, 0.0), 1.0);
    let [s, p] = fresnel(0.8, 1.333);
    measure(&shot, 64).assert_is_grey(0.8 * (1.0 - 0.5 * (s + p)), 1e-4);
}

#[test]
fn sunlight_through_two_faces_of_a_box_that_meet() {
    // In at the top at 70° from its normal, out at a side: E = E₀·τ·(cosθ₁/cosθ₂)·(cosθ₃/cosθ₄) across the beam, τ for each
    // polarisation on its own, as all lies in one plane.
    let n = 1.3_f64;
    let (sin1, cos1) = 70.0_f64.to_radians().sin_cos();
    let sin2 = sin1 / n;
    let cos2 = (1.0 - sin2 * sin2).sqrt();
    // From inside the side is met at 90° − θ₂.
    let (cos3, sin4) = (sin2, n * cos2);
    let cos4 = (1.0 - sin4 * sin4).sqrt();
    let ([s1, p1], [s2, p2]) = (fresnel(cos1, n), fresnel(cos4, n));
    let passed = 0.5 * ((1.0 - s1) * (1.0 - s2) + (1.0 - p1) * (1.0 - p2));
    let across = passed * (cos1 / cos2) * (cos3 / cos4);
    // The beam leaves the side 0.7 m above the floor. The straight line to the sun goes through the same two faces.
    let mut shot = floor();
    shot.sun(v(sin1 as f32, -cos1 as f32, 0.0), 1.0);
    let beside = (0.7 * cos4 / sin4) as f32;
    shot.put(cuboid(v(4.0, 1.0, 1.0)), clear(n as f32)).position = v(-beside - 2.0, 0.52, 0.0);
    measure(&shot, 64).assert_is_grey(across * sin4, 1e-3);
}

#[test]
fn sunlight_is_concentrated_behind_a_ball() {
    // On the axis, r_x from the centre: (1−F₀)²/(1 − r_x/f)², f = nR/(2(n−1)); 8.29 for n = 1.5, r_x = 2R
    let mut shot = floor();
    shot.put(ball(0.5), clear(1.5)).position.y = 1.0;
    shot.sun(Vec3::NEG_Y, 1.0);
    let truth = 0.96_f64.powi(2) * 9.0;
    let seen = measure(&shot, 64);
    assert!((seen.mean[1] / truth - 1.0).abs() < 2e-3, "{seen:?}, {truth}");
}

#[test]
fn a_coloured_lamp_lights_in_its_colour() {
    let mut shot = floor();
    let color = Rgb::new(0.9, 0.5, 0.1);
    let lamp = shot.point(v(0.0, 2.0, 0.0), 1.0);
    (lamp.full_at, lamp.color) = (Some(2.0), color);
    measure(&shot, 4).assert_is(color, 1e-5);
}
