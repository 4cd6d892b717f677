//! C8 and C12: hard shadows end where geometry says, and transparent things let light through in proportion.

use crate::common::{Shot, assert_near, ball, cuboid, flat, glass, matte, plane, triangle, v};
use crate::models;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{Material, Shape};

/// White ground, seen from above at that point.
fn ground() -> Shot {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    shot.put(plane(), matte(Rgb::WHITE));
    shot
}

fn at(shot: &Shot, x: f32, z: f32) -> f32 {
    shot.look(v(x, 0.05, z + 0.03), v(x, 0.0, z)).g
}

/// Where along x the ground turns from dark to light.
fn edge(shot: &Shot, mut dark: f64, mut light: f64) -> f64 {
    assert!(at(shot, dark as f32, 0.1) == 0.0 && at(shot, light as f32, 0.1) > 0.0);
    while (light - dark).abs() > 1e-6 {
        let middle = 0.5 * (dark + light);
        *if at(shot, middle as f32, 0.1) > 0.0 { &mut light } else { &mut dark } = middle;
    }
    light
}

#[test]
fn c8_c12_the_shadow_of_an_edge_in_a_bulbs_light_ends_where_the_line_from_the_bulb_meets_the_ground() {
    for (bulb, height, rim) in
        [(v(0.0, 4.0, 0.0), 2.0, 1.0), (v(-3.0, 5.0, 1.0), 1.0, 0.5), (v(2.0, 2.5, 0.0), 2.0, 0.3)]
    {
        let mut shot = ground();
        // A sheet whose rim is its upper edge at x = rim.
        shot.put(cuboid(v(50.0, 0.5, 50.0)), flat(Rgb::BLACK)).position = v(rim - 25.0, height - 0.25, 0.0);
        shot.point(bulb, 1.0);
        let slope = f64::from(rim - bulb.x) / f64::from(height - bulb.y);
        // Light that passes the rim: by the upper edge if it comes from above the sheet, else by the lower one.
        let under = f64::from(bulb.x) + slope * f64::from(-bulb.y);
        let lower = f64::from(height) - 0.5;
        let by_lower =
            f64::from(bulb.x) + f64::from(rim - bulb.x) / (lower - f64::from(bulb.y)) * f64::from(-bulb.y);
        let truth = under.max(by_lower);
        let seen = edge(&shot, truth - 1.0, truth + 1.0);
        assert!((seen - truth).abs() < 2e-5, "{seen} in place of {truth}");
    }
}

#[test]
fn c8_c12_sunlight_casts_shadows_of_the_things_own_size() {
    for direction in [v(0.0, -1.0, 0.0), v(1.0, -1.0, 0.0), v(-0.5, -2.0, 0.0)] {
        let mut shot = ground();
        let corner = v(0.7, 3.0, 0.0);
        shot.put(triangle([v(-90.0, 3.0, -90.0), v(0.7, 3.0, -90.0), v(0.7, 3.0, 90.0)]), flat(Rgb::BLACK));
        shot.sun(direction, 1.0);
        let truth = f64::from(corner.x) - f64::from(direction.x / direction.y) * f64::from(corner.y);
        let seen = edge(&shot, truth - 1.0, truth + 1.0);
        assert!((seen - truth).abs() < 2e-5, "{seen} in place of {truth}");
        let lit = at(&shot, truth as f32 + 0.5, 0.0);
        assert!((lit - direction.y.abs() / direction.length()).abs() < 1e-6);
    }
}

#[test]
fn c8_c12_the_shadow_of_a_ball_is_a_cone() {
    let (height, radius, bulb) = (2.0_f64, 0.5_f64, 5.0_f64);
    let mut shot = ground();
    shot.put(ball(0.5), flat(Rgb::BLACK)).position = v(0.0, 2.0, 0.0);
    shot.point(v(0.0, 5.0, 0.0), 1.0);
    let half_angle = (radius / (bulb - height)).asin();
    let truth = (bulb * half_angle.tan()).hypot(0.0);
    // At z = 0.1 the circle is a little narrower.
    let truth = (truth * truth - 0.01).sqrt();
    let seen = edge(&shot, 0.0, 3.0);
    assert!((seen - truth).abs() < 2e-5, "{seen} in place of {truth}");
}

#[test]
fn c12_every_shape_casts_a_shadow() {
    let shapes: [&dyn Fn(&mut Shot) -> Shape; 6] = [
        &|_| ball(0.5),
        &|_| cuboid(Vec3::ONE),
        &|_| plane(),
        &|_| triangle([v(-1.0, 0.0, -1.0), v(1.0, 0.0, -1.0), v(0.0, 0.0, 1.0)]),
        &|shot| shot.model(models::cube()),
        &|shot| shot.model(models::faceted_ball(1.0, 3)),
    ];
    for shape in shapes {
        for scale in [Vec3::ONE, v(1.0, 0.5, 2.0)] {
            let mut shot = ground();
            let shape = shape(&mut shot);
            let object = shot.put(shape, flat(Rgb::BLACK));
            (object.position, object.scale) = (v(0.0, 2.0, 0.0), scale);
            shot.sun(v(0.0, -1.0, 0.0), 1.0);
            assert_eq!(at(&shot, 0.01, 0.02), 0.0, "{:?}", shot.scene.objects[1].shape);
            shot.scene.objects[1].visible = false;
            assert_eq!(at(&shot, 0.01, 0.02), 1.0);
        }
    }
}

#[test]
fn c8_c12_what_is_beyond_the_bulb_casts_no_shadow() {
    let mut shot = ground();
    shot.put(cuboid(v(5.0, 1.0, 5.0)), flat(Rgb::BLACK)).position = v(0.0, 4.0, 0.0);
    shot.point(v(0.0, 3.0, 0.0), 1.0);
    assert_near(Rgb::splat(at(&shot, 0.0, 0.0)), Rgb::WHITE, 1e-6);
    shot.scene.objects[1].position = v(0.0, -0.6, 0.0);
    assert_near(Rgb::splat(at(&shot, 0.0, 0.0)), Rgb::WHITE, 1e-6);
    shot.scene.objects[1].position = v(0.0, 1.5, 0.0);
    assert_eq!(at(&shot, 0.0, 0.0), 0.0);
}

#[test]
fn c12_light_through_transparent_surfaces_is_their_product() {
    let mut shot = ground();
    shot.sun(v(0.3, -1.0, 0.1), 1.0);
    let open = at(&shot, 0.0, 0.0);
    let mut product = 1.0;
    for (k, t) in [0.9_f32, 0.5, 0.8, 0.99, 0.3].into_iter().enumerate() {
        // A pane has one surface, a box two.
        let (shape, surfaces) = if k % 2 == 0 { (plane(), 1) } else { (cuboid(v(9.0, 0.1, 9.0)), 2) };
        shot.put(shape, glass(Rgb::BLACK, t)).position = v(0.0, 1.0 + k as f32, 0.0);
        product *= t.powi(surfaces);
        let seen = at(&shot, 0.0, 0.0);
        assert!((seen - open * product).abs() < 2e-7, "{seen} in place of {}", open * product);
    }
}

#[test]
fn c12_the_less_transparent_the_ball_the_darker_its_shadow() {
    let mut last = f32::INFINITY;
    for t in [1.0, 0.8, 0.6, 0.4, 0.2, 0.0_f32] {
        let mut shot = ground();
        shot.put(ball(0.5), Material { transparency: Some(t), ..matte(Rgb::WHITE) }).position =
            v(0.0, 2.0, 0.0);
        // Inside the ball stands a thing whose own shadow fades.
        shot.put(ball(0.1), matte(Rgb::WHITE)).position = v(0.0, 2.0, 0.0);
        shot.sun(v(0.0, -1.0, 0.0), 1.0);
        let (ring, core) = (at(&shot, 0.3, 0.0), at(&shot, 0.0, 0.0));
        assert!((ring - t * t).abs() < 1e-6, "two surfaces of {t}: {ring}");
        assert_eq!(core, 0.0);
        assert!(ring < last, "darker than before");
        last = ring;
    }
}

#[test]
fn c12_what_stands_in_a_transparent_ball_fades_with_it() {
    // The contrast of the inner thing's shadow against the ball's own.
    let contrast = |t: f32| {
        let mut shot = ground();
        shot.put(ball(0.5), glass(Rgb::BLACK, t)).position = v(0.0, 2.0, 0.0);
        shot.put(ball(0.1), glass(Rgb::BLACK, 0.5)).position = v(0.0, 2.0, 0.0);
        shot.sun(v(0.0, -1.0, 0.0), 1.0);
        at(&shot, 0.3, 0.0) - at(&shot, 0.0, 0.0)
    };
    for t in [1.0, 0.8, 0.4, 0.1] {
        assert!((contrast(t) - t * t * 0.75).abs() < 1e-6, "{t}");
    }
}

#[test]
fn c8_two_lamps_light_as_the_sum_of_each() {
    let scene = || {
        let mut shot = Shot::new([48, 36], v(0.0, 3.0, 6.0), Vec3::ZERO);
        shot.put(plane(), matte(Rgb::WHITE));
        shot.put(ball(0.8), Material { specular: Some(0.5), ..matte(Rgb::WHITE) }).position =
            v(0.0, 0.8, 0.0);
        shot
    };
    let light = |shot: &mut Shot, k: u32| match k {
        0 => _ = shot.point(v(3.0, 4.0, 2.0), 0.5),
        1 => _ = shot.sun(v(0.5, -1.0, -0.2), 0.4),
        _ => _ = shot.ambient(0.1),
    };
    let mut all = scene();
    let mut sums = vec![Rgb::BLACK; 48 * 36];
    for k in 0..3 {
        light(&mut all, k);
        let mut one = scene();
        light(&mut one, k);
        sums.iter_mut().zip(&one.picture().pixels).for_each(|(sum, p)| *sum += *p);
    }
    for (seen, sum) in all.picture().pixels.iter().zip(&sums) {
        assert_near(*seen, *sum, 1e-6);
    }
}

#[test]
fn c8_a_shadow_ray_goes_to_each_lamp_that_can_be_seen_and_to_no_other() {
    let mut shot = ground();
    let count = |shot: &Shot| {
        let mut shot = shot.clone();
        (shot.scene.camera.position, shot.scene.camera.look_at) = (v(0.0, 1.0, 1.0), Some(Vec3::ZERO));
        shot.rendered(1, None).rays
    };
    assert_eq!(count(&shot), 1, "the camera's ray alone");
    shot.ambient(1.0);
    assert_eq!(count(&shot), 1, "light from everywhere needs none");
    shot.point(v(0.0, 2.0, 0.0), 1.0);
    assert_eq!(count(&shot), 2);
    shot.sun(v(0.0, -1.0, 0.0), 1.0);
    assert_eq!(count(&shot), 3);
    shot.point(v(0.0, -2.0, 0.0), 1.0);
    assert_eq!(count(&shot), 3, "from below no light comes");
    assert_eq!(count(&shot.cast()), 1, "ray casting has no shadows");
}
