//! C11: transparency by alpha blending, the ray going straight on, and refraction by an index.

use crate::common::{
    BLUE, GREEN, RED, Shot, assert_near, ball, cuboid, flat, glass, matte, mirror, plane, triangle, v,
};
use crate::models;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::Material;

const A: Rgb = Rgb::new(0.9, 0.3, 0.1);
const B: Rgb = Rgb::new(0.1, 0.4, 0.8);

/// A camera at z = 5 that looks at the origin, before the background B.
fn before_background() -> Shot {
    let mut shot = Shot::probe(v(0.0, 0.0, 5.0), Vec3::ZERO);
    shot.scene.settings.background = B;
    shot.ambient(1.0);
    shot
}

#[test]
fn c11_two_surfaces_of_a_ball_blend_twice() {
    for t in [0.0, 0.2, 0.5, 0.8, 0.95, 1.0] {
        let alpha = 1.0 - t;
        let truth = A * alpha + (A * alpha + B * (1.0 - alpha)) * (1.0 - alpha);
        for shape in [ball(1.0), cuboid(v(1.0, 1.0, 1.0))] {
            let mut shot = before_background();
            shot.put(shape, glass(A, t));
            assert_near(shot.pixel(), truth, 1e-6);
        }
    }
}

#[test]
fn c11_one_surface_blends_once() {
    let mut shot = before_background();
    shot.put(triangle([v(-1.0, -1.0, 0.0), v(1.0, -1.0, 0.0), v(0.0, 1.0, 0.0)]), glass(A, 0.3));
    assert_near(shot.pixel(), A * 0.7 + B * 0.3, 1e-6);
    shot.scene.objects[0].shape = plane();
    shot.scene.objects[0].turn_deg = v(70.0, 10.0, 0.0);
    assert_near(shot.pixel(), A * 0.7 + B * 0.3, 1e-6);
}

#[test]
fn c11_c12_the_far_side_is_lit_through_the_near_side() {
    let t = 0.6;
    let mut shot = before_background();
    shot.scene.lights.clear();
    shot.put(ball(1.0), Material { transparency: Some(t), ..matte(A) });
    shot.sun(v(0.0, 0.0, -1.0), 1.0);
    let truth = A * (1.0 - t) + (A * t * (1.0 - t) + B * t) * t;
    assert_near(shot.pixel(), truth, 1e-6);
}

#[test]
fn c11_stacked_panes_let_a_power_through() {
    for (n, t) in [(1, 0.5), (5, 0.8), (12, 0.5), (60, 0.97), (99, 0.99)] {
        let mut shot = before_background();
        for k in 0..n {
            let pane = shot.put(plane(), glass(Rgb::BLACK, t));
            (pane.position, pane.turn_deg) = (v(0.0, 0.0, k as f32 * 0.01), v(90.0, 0.0, 0.0));
        }
        assert_near(shot.pixel(), B * t.powi(n), 2e-5);
    }
}

#[test]
fn c11_any_number_of_invisible_panes_is_invisible() {
    let mut shot = before_background();
    let things = (0..300).map(|k| v(0.0, 0.0, -0.01 * k as f32));
    things.for_each(|p| shot.put(cuboid(v(1.0, 1.0, 0.005)), glass(A, 1.0)).position = p);
    shot.put(cuboid(Vec3::ONE), flat(GREEN)).position = v(0.0, 0.0, -10.0);
    assert_eq!(shot.pixel(), GREEN);
}

/// Things of every kind in a lit scene, with mirrors and shadows.
fn busy() -> Shot {
    let mut shot = Shot::new([64, 48], v(0.5, 1.5, 6.0), v(0.0, 0.5, 0.0));
    shot.scene.settings.background = B;
    shot.put(plane(), mirror(A, 0.3)).position = v(0.0, -1.0, 0.0);
    shot.put(ball(0.8), mirror(GREEN, 0.5)).position = v(-1.0, 0.0, 0.0);
    shot.put(cuboid(Vec3::ONE), matte(RED)).position = v(1.0, 0.0, -0.5);
    shot.put(ball(0.3), Material { transparency: Some(0.7), ..matte(BLUE) }).position = v(0.2, 0.0, 1.5);
    shot.ambient(0.2);
    shot.point(v(3.0, 5.0, 4.0), 0.7);
    shot.disc(v(-3.0, 5.0, 2.0), 0.7, 0.5);
    shot
}

#[test]
fn c11_transparency_one_is_invisible_to_the_last_bit() {
    let without = busy().picture();
    let invisible = || Material { specular: Some(1.0), reflectivity: Some(1.0), ..glass(A, 1.0) };
    let mut shot = busy();
    shot.put(ball(3.0), invisible());
    shot.put(ball(1.0), invisible()).scale = v(1.0, 2.0, 0.5);
    shot.put(cuboid(v(3.0, 2.0, 5.0)), invisible()).turn_deg = v(10.0, 20.0, 30.0);
    shot.put(plane(), invisible()).turn_deg = v(70.0, 0.0, 0.0);
    shot.put(triangle([v(-2.0, -1.0, 2.0), v(2.0, -1.0, 2.0), v(0.0, 2.0, 2.0)]), invisible());
    let model = shot.model(models::faceted_ball(1.5, 5));
    shot.put(model, invisible());
    assert!(shot.picture() == without, "the picture differs");
}

#[test]
fn c11_a_hidden_object_is_not_there_at_all() {
    let without = busy().picture();
    let mut shot = busy();
    shot.put(ball(1.0), matte(RED)).visible = false;
    assert!(shot.picture() == without);
}

#[test]
fn c11_refraction_one_is_straight_on() {
    let mut plain = busy();
    plain.put(ball(1.0), glass(A, 0.8));
    let mut stated = busy();
    stated.put(ball(1.0), Material { refraction: Some(1.0), ..glass(A, 0.8) });
    assert!(stated.picture() == plain.picture());
    let mut nearly = busy();
    nearly.put(ball(1.0), Material { refraction: Some(1.000_001), ..glass(A, 0.8) });
    let off = nearly
        .picture()
        .pixels
        .iter()
        .zip(&plain.picture().pixels)
        .map(|(a, b)| (a.g - b.g).abs())
        .sum::<f32>();
    assert!(off < 3.0, "no picture's worth of change: {off}");
}

/// Where along x the camera must stand so that a ray aslant by that angle meets an edge behind the slab. Without a slab the
/// ray passes the origin.
fn edge_seen(slab: impl Fn(&mut Shot), angle_deg: f32) -> f64 {
    let tan = angle_deg.to_radians().tan();
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    shot.put(cuboid(v(100.0, 100.0, 0.01)), flat(GREEN)).position = v(50.0 + 3.0 * tan, 0.0, -3.0);
    slab(&mut shot);
    shot.ambient(1.0);
    let sees_edge = |x: f64| {
        let x = x as f32;
        shot.look(v(x, 0.0, 3.0), v(x + 6.0 * tan, 0.0, -3.0)) == GREEN
    };
    let straight = -3.0 * f64::from(tan);
    let (mut dark, mut green) = (straight - 2.5, straight + 2.5);
    while green - dark > 1e-6 {
        let middle = 0.5 * (dark + green);
        *if sees_edge(middle) { &mut green } else { &mut dark } = middle;
    }
    green
}

#[test]
fn c11_a_slab_shifts_what_is_behind_it_by_snells_law() {
    for (thickness, index, angle) in
        [(1.0_f32, 1.5_f32, 30.0_f32), (2.0, 1.33, 60.0), (0.5, 2.4, 75.0), (1.0, 0.8, 20.0)]
    {
        let (d, n, theta) = (f64::from(thickness), f64::from(index), f64::from(angle).to_radians());
        let (sin, cos) = theta.sin_cos();
        // The way of the ray is moved aside by d·sin θ·(1 − cos θ/√(n² − sin² θ)); along x that is more by 1/cos θ.
        let truth = d * sin * (1.0 - cos / (n * n - sin * sin).sqrt()) / cos;
        let material = || Material { refraction: Some(index), ..glass(A, 1.0) };
        let straight = edge_seen(|_| (), angle);
        let two_planes = |shot: &mut Shot| {
            for side in [1.0, -1.0] {
                let face = shot.put(plane(), material());
                (face.position, face.turn_deg) =
                    (v(0.0, 0.0, 0.5 * side * thickness), v(90.0 * side, 0.0, 0.0));
            }
        };
        let shift = edge_seen(two_planes, angle) - straight;
        assert!((shift - truth).abs() < 3e-5, "{angle}°, index {index}: {shift} in place of {truth}");
        // Transparent boxes draw back by some millionths of their size.
        let block = |shot: &mut Shot| _ = shot.put(cuboid(v(8.0, 8.0, thickness)), material());
        let shift = edge_seen(block, angle) - straight;
        assert!((shift - truth).abs() < 2.5e-4, "{angle}°, index {index}: {shift} in place of {truth}");
    }
}

#[test]
fn c11_beyond_the_critical_angle_all_is_reflected_inside() {
    let index = 1.5_f64;
    let critical = (1.0 / index).asin();
    // Inside a block, looking up at its top, y = 1. Below, at the mirrored place, there is a red ball.
    let seen = |angle: f64| {
        let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
        shot.scene.settings.background = B;
        shot.ambient(1.0);
        let material = Material { refraction: Some(index as f32), ..glass(A, 1.0) };
        shot.put(cuboid(v(100.0, 2.0, 100.0)), material);
        let x = angle.tan() as f32;
        shot.put(ball(0.2), flat(RED)).position = v(2.0 * x, 0.0, 0.0);
        shot.look(Vec3::ZERO, v(x, 1.0, 0.0))
    };
    assert_eq!(seen(critical + 1e-4), RED);
    assert_eq!(seen(critical + 0.5), RED);
    assert_eq!(seen(critical - 1e-4), B);
    assert_eq!(seen(critical - 0.3), B);
}

#[test]
fn c11_the_camera_may_stand_inside() {
    for refraction in [None, Some(1.5)] {
        let mut shot = before_background();
        shot.put(ball(10.0), Material { refraction, ..glass(A, 0.6) });
        assert_near(shot.look(v(0.0, 0.0, 1.0), Vec3::ZERO), A * 0.4 + B * 0.6, 1e-6);
        shot.scene.objects[0].shape = cuboid(Vec3::splat(20.0));
        assert_near(shot.look(v(0.0, 0.0, 1.0), v(0.3, 0.4, 0.0)), A * 0.4 + B * 0.6, 1e-6);
    }
}

#[test]
fn c10_c11_a_transparent_mirror_shares_its_light() {
    // C = α·((1 − r)·A + r·mirrored) + (1 − α)·behind; the mirror image is the background, too.
    let (t, r) = (0.4, 0.25);
    let mut shot = before_background();
    shot.put(plane(), Material { reflectivity: Some(r), ..glass(A, t) }).turn_deg = v(60.0, 0.0, 0.0);
    let truth = (A * (1.0 - r) + B * r) * (1.0 - t) + B * t;
    assert_near(shot.pixel(), truth, 1e-6);
}
