//! C6 and C9: what a pixel shows is the formula, worked out apart in double precision.

use crate::common::{Shot, assert_near, ball, flat, matte, plane, v};
use crate::oracle::D3;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::Material;

const COLOR: Rgb = Rgb::new(0.8, 0.5, 0.1);

/// A ball of radius 1 at the origin.
fn ball_of(material: Material) -> Shot {
    let mut shot = Shot::probe(v(0.0, 0.0, 5.0), Vec3::ZERO);
    shot.put(ball(1.0), material);
    shot
}

/// k_d·max(0, ⟨N, L⟩) and k_s·max(0, ⟨R, V⟩)^s.
fn terms(n: D3, l: D3, wo: D3, [kd, ks, s]: [f64; 3]) -> (f64, f64) {
    let cos = n.dot(l) / (n.length() * l.length());
    let r = n * (2.0 * n.dot(l)) - l;
    let cos_r = r.dot(wo) / (r.length() * wo.length());
    let lit = if cos > 0.0 { 1.0 } else { 0.0 };
    (kd * cos.max(0.0), lit * ks * cos_r.max(0.0).powf(s))
}

#[test]
fn c9_a_pixel_is_the_formula_of_all_lights_together() {
    let mut shot = ball_of(Material {
        color: Some(COLOR),
        diffuse: Some(0.7),
        specular: Some(0.4),
        shininess: Some(13.0),
        ..Material::default()
    });
    let (bulb, sun) = (v(3.0, 4.0, 5.0), v(1.0, -2.0, -1.5));
    shot.ambient(0.15);
    shot.point(bulb, 0.6).color = Rgb::new(1.0, 0.9, 0.5);
    shot.sun(sun, 0.5);
    for p in [v(0.0, 0.0, 1.0), v(0.6, 0.0, 0.8), v(0.0, 0.8, 0.6), v(-0.48, 0.6, 0.64), v(0.0, -0.8, 0.6)] {
        let n = D3::of(p).unit();
        let wo = D3::of(v(0.0, 0.0, 5.0)) - n;
        let k = [f64::from(0.7_f32), f64::from(0.4_f32), 13.0];
        let (d1, s1) = terms(n, D3::of(bulb) - n, wo, k);
        let (d2, s2) = terms(n, -D3::of(sun), wo, k);
        let (white, yellow) = (D3::new(1.0, 1.0, 1.0), D3::of_color(Rgb::new(1.0, 0.9, 0.5)));
        let color = D3::of_color(COLOR);
        let truth = color * 0.15
            + yellow.times(color * d1 + white * s1) * 0.6
            + white.times(color * d2 + white * s2) * 0.5;
        assert_near(shot.look(v(0.0, 0.0, 5.0), p), truth.color(), 2e-6);
    }
}

#[test]
fn c9_light_from_behind_gives_nothing() {
    let mut shot = ball_of(Material { specular: Some(1.0), shininess: Some(1.0), ..matte(Rgb::WHITE) });
    // Just behind the surface that the camera sees, so that the mirror direction is near the viewer's.
    shot.sun(v(0.0, -1.0, 0.1), 1.0);
    assert_eq!(shot.pixel(), Rgb::BLACK);
    let mut grazing = shot.clone();
    grazing.scene.lights.clear();
    grazing.sun(v(0.0, -1.0, -0.1), 1.0);
    assert!(grazing.pixel().g > 0.05);
}

#[test]
fn c9_the_highlight_ends_where_the_mirror_direction_is_square_to_the_viewer() {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    shot.put(plane(), Material { specular: Some(1.0), shininess: Some(1.0), ..flat(Rgb::WHITE) });
    // Light along (−1, 1): the mirror direction is (1, 1). Seen at 45° from the other side that is a right angle.
    shot.sun(v(1.0, -1.0, 0.0), 1.0);
    let seen = |angle: f32| {
        let from = v(angle.to_radians().sin(), angle.to_radians().cos(), 0.0);
        shot.look(from, Vec3::ZERO).g
    };
    assert_eq!(seen(-46.0), 0.0);
    assert_eq!(seen(-60.0), 0.0);
    for angle in [-44.0_f32, -10.0, 0.0, 30.0, 45.0, 80.0] {
        let truth = (45.0 - angle).to_radians().cos();
        assert!((seen(angle) - truth).abs() < 1e-5, "{angle}°: {} in place of {truth}", seen(angle));
    }
}

#[test]
fn c9_without_highlight_it_is_lambert_whatever_the_shininess() {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    shot.put(plane(), Material { specular: Some(0.0), shininess: Some(5.0), ..matte(COLOR) });
    shot.sun(v(-1.0, -1.0, 0.0), 1.0);
    let cos = std::f32::consts::FRAC_1_SQRT_2;
    for from in [v(0.0, 1.0, 0.0), v(1.0, 1.0, 0.0), v(-3.0, 0.2, 1.0)] {
        assert_near(shot.look(from, Vec3::ZERO), COLOR * cos, 1e-6);
    }
}

#[test]
fn c6_the_scales_of_a_material_do_what_they_say() {
    let seen = |material: Material| {
        let mut shot = ball_of(Material { color: Some(COLOR), ..material });
        shot.sun(v(0.0, 0.0, -1.0), 1.0);
        shot.pixel()
    };
    for kd in [0.0, 0.25, 1.0] {
        assert_near(seen(Material { diffuse: Some(kd), ..Material::default() }), COLOR * kd, 1e-6);
    }
    // Seen along the mirror direction the highlight is k_s whatever s; it keeps the light's colour, here white.
    for (ks, s) in [(0.0, 10.0), (0.3, 10.0), (1.0, 1000.0)] {
        let material =
            Material { diffuse: Some(0.5), specular: Some(ks), shininess: Some(s), ..Material::default() };
        assert_near(seen(material), COLOR * 0.5 + Rgb::splat(ks), 1e-5);
    }
    // Where nothing is stated: k_d = 0.8, k_s = 0.
    assert_near(seen(Material::default()), COLOR * 0.8, 1e-6);
}

#[test]
fn c6_a_greater_shininess_makes_a_smaller_highlight() {
    let seen = |s: f32| {
        let mut shot = ball_of(Material { specular: Some(1.0), shininess: Some(s), ..flat(COLOR) });
        shot.sun(v(0.5, 0.0, -1.0), 1.0);
        shot.pixel().g
    };
    let cos_r = 1.0 / 1.25_f32.sqrt();
    for s in [1.0, 2.0, 8.0, 50.0, 300.0] {
        assert!((seen(s) - cos_r.powf(s)).abs() < 1e-5, "{s}: {}", seen(s));
    }
}

#[test]
fn c9_the_highlight_has_the_lights_colour_and_the_rest_the_surfaces() {
    let orange = Rgb::new(1.0, 0.5, 0.25);
    let green = Rgb::new(0.2, 0.9, 0.3);
    let mut shot = ball_of(Material { specular: Some(0.5), ..matte(green) });
    shot.sun(v(0.0, 0.0, -1.0), 1.0).color = orange;
    assert_near(shot.pixel(), green * orange + orange * 0.5, 1e-6);
    shot.scene.materials[0].diffuse = Some(0.0);
    assert_near(shot.pixel(), orange * 0.5, 1e-6);
}

#[test]
fn c8_c9_intensities_add_and_light_does_not_fade_with_distance() {
    let mut near = ball_of(matte(COLOR));
    near.point(v(0.0, 0.0, 3.0), 0.4);
    let one = near.pixel();
    near.point(v(0.0, 0.0, 3.0), 0.4);
    assert_near(near.pixel(), one + one, 1e-6);
    for distance in [1.5, 30.0, 3e5, 3e12] {
        let mut far = ball_of(matte(COLOR));
        far.point(v(0.0, 0.0, distance), 0.4);
        assert_near(far.pixel(), one, 1e-6);
    }
    let mut off = near.clone();
    off.scene.lights[1].visible = false;
    assert_near(off.pixel(), one, 0.0);
    off.scene.lights[0].intensity = 0.0;
    assert_eq!(off.pixel(), Rgb::BLACK);
}

#[test]
fn c8_ambient_light_reaches_everything_alike_and_adds_up() {
    let mut shot = ball_of(Material { diffuse: Some(0.3), ..matte(COLOR) });
    shot.ambient(0.25);
    shot.ambient(0.5).color = Rgb::new(1.0, 0.0, 0.5);
    let light = Rgb::splat(0.25) + Rgb::new(0.5, 0.0, 0.25);
    for at in [Vec3::ZERO, v(0.5, 0.5, 0.0), v(-0.7, -0.2, 0.0)] {
        assert_near(shot.look(v(0.0, 0.0, 5.0), at), COLOR * light, 1e-7);
    }
}

#[test]
fn c8_the_length_of_a_direction_does_not_matter() {
    let seen = |direction: Vec3| {
        let mut shot = ball_of(matte(COLOR));
        shot.sun(direction, 1.0);
        shot.pixel()
    };
    let one = seen(v(0.3, -0.5, -1.0));
    for length in [1e-18, 1e-3, 77.0, 1e18, 1e30] {
        assert_near(seen(v(0.3, -0.5, -1.0) * length), one, 1e-6);
    }
}
