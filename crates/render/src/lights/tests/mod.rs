//! Lights against formulas: the irradiance that their samples tell.

mod densities;
mod edge_cases;
mod many;
mod seen;

use super::*;
use crate::samplers::PathSampler;
use std::sync::Arc;
use vitrine_math::Transform;
use vitrine_scene::RadianceMap;

fn lamp(emission: Emission, radiance: Rgb) -> LampSpec {
    LampSpec { emission, radiance, full_at: 2.0 }
}

fn of_lamp(emission: Emission) -> Lights {
    Lights::new(&[lamp(emission, Rgb::WHITE)], &[])
}

fn emitter(form: EmitterForm, is_two_sided: bool) -> Emitter {
    Emitter { form, radiance: Rgb::WHITE, is_two_sided, primitive: 0, triangle: 0 }
}

fn of_form(form: EmitterForm) -> Lights {
    Lights::new(&[], &[emitter(form, false)])
}

fn numbers(sample: u32, pixel: u32) -> (f32, [f32; 2]) {
    let sampler = PathSampler::new([pixel, 0], sample, 0);
    (sampler.one(0), sampler.two(1))
}

/// The irradiance at `p` on a surface of normal `n` that one sample tells, as a luminance.
fn irradiance_of(sample: &LightSample, p: Vec3, n: Vec3) -> f64 {
    let (toward, geometry) = match sample.at {
        LightPoint::Point { position } => {
            let v = position - p;
            (v.normalize(), 1.0 / v.length_squared())
        }
        LightPoint::Surface { position, n, .. } => {
            let v = position - p;
            (v.normalize(), -n.dot(v.normalize()) / v.length_squared())
        }
        LightPoint::Distant { toward } => (toward, 1.0),
    };
    f64::from(sample.le.luminance() * geometry * n.dot(toward).max(0.0) / sample.pdf)
}

/// The irradiance at `p` by N samples.
fn irradiance(lights: &Lights, p: Vec3, n: Vec3, with_normal: bool) -> f64 {
    const N: u32 = 1 << 16;
    let each = |i| {
        let (choice, u) = numbers(i, 3);
        let sample = lights.sample(p, with_normal.then_some(n), choice, u);
        sample.map_or(0.0, |sample| irradiance_of(&sample, p, n))
    };
    (0..N).map(each).sum::<f64>() / f64::from(N)
}

fn assert_irradiance(lights: &Lights, p: Vec3, n: Vec3, expected: f64, tolerance: f64) {
    for with_normal in [true, false] {
        let found = irradiance(lights, p, n, with_normal);
        assert!(
            (found - expected).abs() <= tolerance * expected,
            "{found} against {expected} at {p}, n given: {with_normal}"
        );
    }
}

const PI64: f64 = std::f64::consts::PI;

fn disc_of(radius: f32) -> EmitterForm {
    let unit = Transform::from_place(Vec3::ZERO, Vec3::ZERO, Vec3::new(radius, 1.0, radius));
    EmitterForm::Disc { unit, n: Vec3::NEG_Y }
}

#[test]
fn a_disc_on_its_axis_and_beside_it_lights_as_the_formulas_say() {
    let lights = of_form(disc_of(0.7));
    // E = πL·r²/(r² + h²)
    let on_axis = PI64 * 0.49 / (0.49 + 1.2 * 1.2);
    assert_irradiance(&lights, Vec3::new(0.0, -1.2, 0.0), Vec3::Y, on_axis, 1e-3);
    // E = πL·½·[1 − (1 + H² − Q²)/√(Z² − 4Q²)], H = h/a, Q = r/a, Z = 1 + H² + Q²
    let (h, q): (f64, f64) = (1.2 / 0.9, 0.7 / 0.9);
    let z = 1.0 + h * h + q * q;
    let beside = PI64 * 0.5 * (1.0 - (1.0 + h * h - q * q) / (z * z - 4.0 * q * q).sqrt());
    assert_irradiance(&lights, Vec3::new(0.9, -1.2, 0.0), Vec3::Y, beside, 1e-3);
    assert!(lights.sample(Vec3::new(0.0, 1.2, 0.0), Some(Vec3::NEG_Y), 0.5, [0.5; 2]).is_none());
}

#[test]
fn a_ball_lights_as_the_formula_says_near_and_far() {
    let lights = of_form(EmitterForm::Sphere { center: Vec3::new(0.0, 3.0, 1.0), radius: 0.5 });
    for p in [Vec3::ZERO, Vec3::new(0.0, 2.45, 1.0), Vec3::new(2.0, -40.0, 7.0)] {
        let v = Vec3::new(0.0, 3.0, 1.0) - p;
        // E = πL·(R/d)²·cosθ, all of it above the horizon
        let expected = PI64 * f64::from(0.25 / v.length_squared() * v.normalize().y);
        assert_irradiance(&lights, p, Vec3::Y, expected, 2e-3);
    }
}

#[test]
fn a_stretched_ball_is_a_ball_where_it_is_not_stretched_and_its_own_density_elsewhere() {
    let place =
        Transform::from_place(Vec3::new(0.0, 3.0, 1.0), Vec3::new(20.0, 30.0, 40.0), Vec3::splat(0.5));
    let expected = PI64 * 0.25 / 10.0 * 3.0 / 10.0_f64.sqrt();
    assert_irradiance(&of_form(EmitterForm::Ellipsoid { unit: place }), Vec3::ZERO, Vec3::Y, expected, 3e-3);
    // Very flat, it is a disc: seen along the axis, E = πL·r²/(r² + h²).
    let flat = Transform::from_place(Vec3::ZERO, Vec3::ZERO, Vec3::new(0.7, 1e-4, 0.7));
    let expected = PI64 * 0.49 / (0.49 + 1.44);
    let lights = of_form(EmitterForm::Ellipsoid { unit: flat });
    assert_irradiance(&lights, Vec3::new(0.0, -1.2, 0.0), Vec3::Y, expected, 3e-3);
}

/// Two triangles that are the rectangle [0, a] × [0, b] at y = 0, shining down.
fn rectangle(a: f32, b: f32) -> [EmitterForm; 2] {
    let [o, x, z, xz] = [[0.0, 0.0], [a, 0.0], [0.0, b], [a, b]].map(|[x, z]| Vec3::new(x, 0.0, z));
    [EmitterForm::Triangle { points: [o, x, z] }, EmitterForm::Triangle { points: [x, xz, z] }]
}

#[test]
fn a_rectangle_over_a_corner_lights_as_the_formula_says() {
    // E/(πL) = (1/2π)·[X/√(1+X²)·atan(Y/√(1+X²)) + Y/√(1+Y²)·atan(X/√(1+Y²))], X = a/c, Y = b/c
    let (x, y) = (1.5_f64 / 0.8, 0.9_f64 / 0.8);
    let part = |x: f64, y: f64| x / (1.0 + x * x).sqrt() * (y / (1.0 + x * x).sqrt()).atan();
    let expected = 0.5 * (part(x, y) + part(y, x));
    let emitters = rectangle(1.5, 0.9).map(|form| emitter(form, false));
    assert_irradiance(&Lights::new(&[], &emitters), Vec3::new(0.0, -0.8, 0.0), Vec3::Y, expected, 2e-3);
}

#[test]
fn a_box_lights_as_its_faces() {
    // From straight below only the lower face is seen; four times the formula for a corner.
    let unit = Transform::from_place(Vec3::new(0.0, 1.0, 0.0), Vec3::ZERO, Vec3::new(0.6, 0.2, 0.4));
    let (x, y) = (0.6 / 0.8, 0.4 / 0.8);
    let part = |x: f64, y: f64| x / (1.0 + x * x).sqrt() * (y / (1.0 + x * x).sqrt()).atan();
    let expected = 4.0 * 0.5 * (part(x, y) + part(y, x));
    let lights = of_form(EmitterForm::Box { unit });
    assert_irradiance(&lights, Vec3::ZERO, Vec3::Y, expected, 3e-3);
    // From aside, three faces are seen: as by their six triangles.
    let corner = |x: f32, y: f32, z: f32| unit.point(Vec3::new(x, y, z));
    let quad = |c: [Vec3; 4]| {
        [[c[0], c[1], c[2]], [c[0], c[2], c[3]]].map(|points| EmitterForm::Triangle { points })
    };
    let faces = [
        quad([corner(-1., -1., -1.), corner(1., -1., -1.), corner(1., -1., 1.), corner(-1., -1., 1.)]),
        quad([corner(1., -1., -1.), corner(1., 1., -1.), corner(1., 1., 1.), corner(1., -1., 1.)]),
        quad([corner(-1., -1., 1.), corner(1., -1., 1.), corner(1., 1., 1.), corner(-1., 1., 1.)]),
    ];
    let triangles = faces.concat().into_iter().map(|form| emitter(form, false)).collect::<Vec<_>>();
    let p = Vec3::new(2.0, -0.5, 1.7);
    let n = Vec3::new(-1.0, 1.0, -0.5).normalize();
    let expected = irradiance(&Lights::new(&[], &triangles), p, n, true);
    assert_irradiance(&lights, p, n, expected, 5e-3);
}

#[test]
fn coaxial_discs_exchange_what_the_formula_says() {
    // The mean over the receiving disc, equal radii r = h: 0.38197 of what leaves.
    let lights = of_form(disc_of(1.0));
    let (mut sum, n) = (0.0, 1 << 16);
    for i in 0..n {
        let sampler = PathSampler::new([9, 9], i, 1);
        let at = vitrine_math::warp::concentric_disk(sampler.two(5).into());
        let p = Vec3::new(at.x, -1.0, at.y);
        let sample = lights.sample(p, Some(Vec3::Y), sampler.one(0), sampler.two(1));
        sum += sample.map_or(0.0, |sample| irradiance_of(&sample, p, Vec3::Y));
    }
    assert!((sum / f64::from(n) / PI64 - 0.381_97).abs() < 1e-3, "{}", sum / f64::from(n) / PI64);
}

#[test]
fn lamps_light_a_white_surface_with_their_intensity_where_they_are_full() {
    let position = Vec3::new(1.0, 2.0, 3.0);
    let p = position - Vec3::Y * 2.0;
    let radius = 0.01;
    for emission in [
        Emission::Point { position },
        Emission::Sphere { position, radius },
        Emission::Disc { position, radius },
        Emission::Direction { travels: Vec3::NEG_Y },
        Emission::Everywhere,
    ] {
        // E = π·I
        assert_irradiance(&of_lamp(emission), p, Vec3::Y, PI64, 2e-3);
    }
}

fn map(size: [u32; 2], texel: impl Fn(u32, u32) -> f32) -> Arc<RadianceMap> {
    let [width, height] = size;
    let pixels = (0..width * height).map(|i| Rgb::splat(texel(i % width, i / width))).collect();
    Arc::new(RadianceMap { size, pixels })
}

#[test]
fn a_uniform_panorama_brings_pi_times_its_radiance() {
    let lights = of_lamp(Emission::Environment { map: map([16, 8], |_, _| 1.0), turn: 0.4 });
    assert_irradiance(&lights, Vec3::ZERO, Vec3::new(0.6, 0.0, 0.8), PI64, 3e-3);
    assert_eq!(lights.le_distant(Vec3::X), Rgb::WHITE);
}
