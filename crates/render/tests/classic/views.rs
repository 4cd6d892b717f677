//! C13 and the picture as a whole: the camera, the pixels and their samples, the background, and ray casting.

use crate::agreement::lit_scene;
use crate::common::{
    BLUE, GREEN, RED, Shot, assert_near, ball, cuboid, flat, glass, matte, mirror, plane, v,
};
use vitrine_math::{Axis, Rgb, Vec3};
use vitrine_scene::Camera;

/// Flat balls, small and far from the camera: each is a mark in the picture.
fn marks() -> Shot {
    let mut shot = Shot::new([101, 101], Vec3::ZERO, Vec3::NEG_Z);
    (shot.scene.camera.look_at, shot.scene.camera.view_angle_deg) = (None, 90.0);
    shot.ambient(1.0);
    for (direction, color) in
        [(v(0.0, 0.0, -1.0), RED), (v(0.5, 0.0, -1.0), GREEN), (v(0.0, 0.5, -1.0), BLUE)]
    {
        shot.put(ball(0.1), flat(color)).position = direction * 10.0;
    }
    shot
}

/// The middle of the pixels of that colour.
fn place_of(shot: &Shot, color: Rgb) -> Option<[f32; 2]> {
    let picture = shot.picture();
    let (mut sum, mut n) = ([0.0; 2], 0.0);
    for (x, y) in (0..picture.size[1]).flat_map(|y| (0..picture.size[0]).map(move |x| (x, y))) {
        if picture.pixel(x, y) == color {
            sum = [sum[0] + x as f32 + 0.5, sum[1] + y as f32 + 0.5];
            n += 1.0;
        }
    }
    (n > 0.0).then(|| sum.map(|s| s / n))
}

#[track_caller]
fn assert_place(shot: &Shot, color: Rgb, truth: [f32; 2]) {
    let seen = place_of(shot, color).expect("the mark is in the picture");
    let off = (seen[0] - truth[0]).abs().max((seen[1] - truth[1]).abs());
    assert!(off < 0.6, "{seen:?} in place of {truth:?}");
}

#[test]
fn c13_a_camera_that_is_not_turned_looks_along_minus_z_with_y_up() {
    let shot = marks();
    // At 90° a direction of (x, y, −1) is at 50.5·(1 + x), 50.5·(1 − y).
    assert_place(&shot, RED, [50.5, 50.5]);
    assert_place(&shot, GREEN, [75.75, 50.5]);
    assert_place(&shot, BLUE, [50.5, 25.25]);
}

#[test]
fn c13_moving_the_camera_moves_the_picture_the_other_way() {
    let mut shot = marks();
    shot.scene.camera.position = v(2.0, 1.0, 0.0);
    assert_place(&shot, RED, [50.5 * 0.8, 50.5 * 1.1]);
    shot.scene.camera.position = v(0.0, 0.0, -2.0);
    assert_place(&shot, GREEN, [50.5 * 1.625, 50.5]);
}

#[test]
fn c13_turning_about_an_axis_turns_the_picture_as_the_rotation_says() {
    for (axis, angle) in [(Axis::X, 20.0), (Axis::Y, -25.0), (Axis::Z, 40.0), (Axis::Y, 10.0)] {
        let mut shot = marks();
        shot.scene.camera.turn(axis, angle);
        let back = axis.rotation_deg(-angle);
        for (direction, color) in
            [(v(0.0, 0.0, -1.0), RED), (v(0.5, 0.0, -1.0), GREEN), (v(0.0, 0.5, -1.0), BLUE)]
        {
            let d = back * direction;
            let truth = [50.5 * (1.0 + d.x / -d.z), 50.5 * (1.0 - d.y / -d.z)];
            if truth.iter().all(|p| (2.0..99.0).contains(p)) {
                assert_place(&shot, color, truth);
            }
        }
    }
}

#[test]
fn c13_the_view_angle_spans_the_height_and_pixels_are_square() {
    for size in [[40, 80], [80, 40], [61, 61]] {
        for angle in [20.0_f32, 60.0, 120.0] {
            let mut shot = Shot::new(size, Vec3::ZERO, Vec3::NEG_Z);
            shot.scene.camera.view_angle_deg = angle;
            shot.ambient(1.0);
            // A square sheet that just fills the height.
            let half = (angle.to_radians() * 0.5).tan() * 10.0;
            shot.put(cuboid(v(2.0 * half, 2.0 * half, 0.001)), flat(RED)).position = v(0.0, 0.0, -10.0);
            let picture = shot.picture();
            let column = (0..size[1]).filter(|y| picture.pixel(size[0] / 2, *y) == RED).count() as u32;
            let row = (0..size[0]).filter(|x| picture.pixel(*x, size[1] / 2) == RED).count() as u32;
            assert_eq!((column, row), (size[1], size[0].min(size[1])), "{size:?} at {angle}°");
        }
    }
}

/// A red half plane whose upright rim lies at that x of the picture, in pixels, or aslant.
fn rim(x: f32, slope_deg: f32, samples: u32) -> Shot {
    let mut shot = Shot::new([16, 16], v(0.0, 0.0, 8.0), Vec3::ZERO);
    shot.scene.camera.view_angle_deg = 2.0 * 1.0_f32.atan().to_degrees();
    shot.scene.settings.samples = samples;
    shot.ambient(1.0);
    // A pixel is one metre wide at z = 0.
    let sheet = shot.put(cuboid(v(100.0, 100.0, 1e-4)), flat(RED));
    let turn = Axis::Z.rotation_deg(slope_deg);
    (sheet.position, sheet.turn_deg) =
        (v(x - 8.0, 0.0, 0.0) + turn * v(-50.0, 0.0, 0.0), v(0.0, 0.0, slope_deg));
    shot
}

#[test]
fn one_sample_is_the_middle_of_the_pixel() {
    for (x, red) in [(3.499, 3), (3.501, 4), (4.499, 4), (4.501, 5)] {
        let picture = rim(x, 0.0, 1).picture();
        for y in 0..16 {
            let count = (0..16).filter(|x| picture.pixel(*x, y) == RED).count();
            assert_eq!(count, red, "rim at {x}");
        }
    }
}

#[test]
fn many_samples_are_the_covered_part_of_the_pixel() {
    for (slope, samples, allowed) in
        [(0.0_f32, 64, 0.04), (0.0, 1024, 0.005), (30.0, 64, 0.06), (30.0, 1024, 0.012)]
    {
        for x in [7.25_f32, 7.5, 7.8] {
            let picture = rim(x, slope, samples).picture();
            for y in 6..10 {
                // Where the rim crosses the middle of this row; a rim at 30° stays within two pixels of a row.
                let middle = x - (8.0 - (y as f32 + 0.5)) * slope.to_radians().tan();
                let covered: f32 = (0..16).map(|x| picture.pixel(x, y).r).sum();
                assert!((covered - middle).abs() < 2.0 * allowed, "row {y}: {covered} in place of {middle}");
                if slope == 0.0 {
                    let at = picture.pixel(x as u32, y).r;
                    assert!((at - x.fract()).abs() < allowed, "{at} in place of {}", x.fract());
                }
            }
        }
    }
}

#[test]
fn the_seed_changes_soft_shadows_alone() {
    let with_seed = |shot: &Shot, seed: u32| {
        let mut shot = shot.clone();
        (shot.scene.settings.seed, shot.scene.settings.samples) = (seed, 3);
        shot.picture()
    };
    let mut shot = lit_scene();
    assert!(with_seed(&shot, 1) == with_seed(&shot, 2));
    shot.disc(v(2.0, 6.0, 1.0), 1.5, 0.5);
    let (a, b) = (with_seed(&shot, 1), with_seed(&shot, 2));
    assert!(a != b && a == with_seed(&shot, 1));
    let mean = |p: &vitrine_film::Image| p.pixels.iter().map(|p| p.g).sum::<f32>() / p.pixels.len() as f32;
    assert!((mean(&a) - mean(&b)).abs() < 2e-3, "of the same quality");
}

#[test]
fn the_background_is_where_nothing_is() {
    let mut shot = Shot::new([8, 8], Vec3::ZERO, Vec3::Z);
    shot.scene.settings.background = Rgb::new(0.3, 2.0, 0.0);
    assert!(shot.picture().pixels.iter().all(|p| *p == Rgb::new(0.3, 2.0, 0.0)));
}

#[test]
fn cast_shows_no_shadows_mirrors_or_transparency() {
    let mut shot = Shot::probe(v(0.0, 3.0, 3.0), Vec3::ZERO);
    shot.put(plane(), matte(GREEN));
    shot.put(ball(0.5), flat(Rgb::WHITE)).position = v(0.0, 4.0, 0.0);
    shot.sun(v(0.0, -1.0, 0.0), 1.0);
    assert_eq!(shot.pixel(), Rgb::BLACK, "in the ball's shadow");
    assert_eq!(shot.cast().pixel(), GREEN);
    for material in [mirror(GREEN, 0.7), glass(GREEN, 0.7)] {
        let mut shot = Shot::probe(v(0.0, 3.0, 3.0), Vec3::ZERO);
        shot.scene.settings.background = RED;
        shot.put(plane(), material);
        shot.ambient(1.0);
        assert!(shot.pixel().r > 0.5);
        assert_eq!(shot.cast().pixel(), GREEN, "the nearest surface alone");
    }
}

#[test]
fn cast_takes_a_disc_for_its_middle() {
    let mut shot = Shot::probe(v(0.0, 1.0, 1.0), v(0.4, 0.0, 0.1));
    shot.put(plane(), matte(GREEN));
    let mut bulb = shot.clone();
    shot.disc(v(1.0, 2.0, 0.0), 1.5, 0.8);
    bulb.point(v(1.0, 2.0, 0.0), 0.8);
    assert_near(shot.cast().pixel(), bulb.pixel(), 1e-6);
}

#[test]
fn cast_is_the_classic_picture_of_an_opaque_scene_without_shadows() {
    let mut shot = lit_scene();
    for light in &mut shot.scene.lights {
        // A lamp where the camera is casts no shadow that the camera could see.
        light.source = vitrine_scene::LightSource::Point(vitrine_scene::lights::Point {
            position: shot.scene.camera.position,
        });
    }
    shot.scene.settings.depth = 0;
    let (classic, cast) = (shot.picture(), shot.cast().picture());
    let differ = classic.pixels.iter().zip(&cast.pixels).filter(|(a, b)| a != b).count();
    assert!(differ <= 3, "{differ} pixels differ; a few may graze an edge");
    assert!(shot.rendered(1, None).rays > shot.cast().rendered(1, None).rays);
}

#[test]
fn c13_look_at_and_turn_say_the_same_in_two_ways() {
    let mut looking = lit_scene();
    looking.scene.camera.look_at = Some(v(1.0, -0.4, 0.7));
    let mut turned = looking.clone();
    // The turn about Y by 0 and about X by nothing changes nothing but the way in which the aim is written.
    turned.scene.camera.turn(Axis::Y, 0.0);
    assert!(turned.scene.camera.look_at.is_none());
    let far = looking
        .picture()
        .pixels
        .iter()
        .zip(&turned.picture().pixels)
        .map(|(a, b)| (a.g - b.g).abs())
        .sum::<f32>();
    assert!(far < 1.0, "{far}");
    assert_eq!(Camera::default().rotation() * Vec3::NEG_Z, Vec3::NEG_Z);
}
