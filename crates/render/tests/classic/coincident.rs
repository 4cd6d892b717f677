//! C11: things that stand exactly on others. A face of glass in the plane of the floor shows the floor through both faces of
//! the glass everywhere: no speckles where rounding would put the floor before the lower face.

use crate::common::{BLUE, GREEN, RED, Shot, cuboid, disc, distance, flat, glass, matte, plane, triangle, v};
use crate::models;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{Group, Shape};

/// Fails unless every pixel has one of the colours, and each is there.
#[track_caller]
fn assert_only(shot: &Shot, colors: &[Rgb]) {
    let picture = shot.picture();
    for (i, p) in picture.pixels.iter().enumerate() {
        assert!(
            colors.iter().any(|c| distance(*c, *p) < 1e-5),
            "pixel {i} of {:?}: {p:?} is none of {colors:?}",
            shot.scene.objects
        );
    }
    for c in colors {
        let n = picture.pixels.iter().filter(|p| distance(*c, **p) < 1e-5).count();
        assert!(n > 100, "{c:?} is in {n} pixels alone");
    }
}

#[derive(Clone, Copy, Debug)]
enum Floor {
    Plane,
    Block,
    Model,
    Triangles,
}

/// A floor in y = 0, green.
fn put_floor(shot: &mut Shot, floor: Floor) {
    match floor {
        Floor::Plane => _ = shot.put(plane(), flat(GREEN)),
        Floor::Block => {
            shot.put(cuboid(v(40.0, 1.0, 40.0)), flat(GREEN)).position = v(0.0, -0.5, 0.0);
        }
        Floor::Model => {
            let square = shot.model(models::square());
            shot.put(square, flat(GREEN)).scale = v(20.0, 1.0, 20.0);
        }
        Floor::Triangles => {
            let [a, b, c, d] =
                [[-20.0, -20.0], [20.0, -20.0], [20.0, 20.0], [-20.0, 20.0]].map(|[x, z]| v(x, 0.0, z));
            shot.put(triangle([a, b, c]), flat(GREEN));
            shot.put(triangle([a, c, d]), flat(GREEN));
        }
    }
}

/// A block of red glass of that size that stands on y = 0.
fn put_block(shot: &mut Shot, size: f32, is_model: bool, turn: f32) {
    let shape: Shape = if is_model { shot.model(models::cube()) } else { cuboid(Vec3::splat(2.0)) };
    let block = shot.put(shape, glass(RED, 0.5));
    block.scale = Vec3::splat(0.5 * size);
    block.position = v(0.0, 0.5 * size, 0.0);
    block.turn_deg = v(0.0, turn, 0.0);
}

/// A camera that looks down at the block from so many sizes away.
fn camera(size: f32, away: f32) -> Shot {
    let middle = v(0.0, 0.2 * size, 0.0);
    let mut shot = Shot::new([64, 48], middle + v(0.1, 0.7, 0.8) * (size * away), middle);
    shot.scene.camera.view_angle_deg = 2.0 * (1.2 / away).atan().to_degrees();
    shot.ambient(1.0);
    shot
}

/// A green floor through two surfaces of red glass.
const THROUGH: Rgb = Rgb::new(0.75, 0.25, 0.0);

#[test]
fn c11_glass_on_the_floor_shows_it_without_speckles() {
    for floor in [Floor::Plane, Floor::Block, Floor::Model, Floor::Triangles] {
        for (size, away, turn) in [(1.0, 3.0, 0.0), (0.3, 10.0, 30.0), (0.07, 30.0, 17.0), (3.7, 4.0, 45.0)] {
            for is_model in [false, true] {
                let mut first = camera(size, away);
                put_block(&mut first, size, is_model, turn);
                put_floor(&mut first, floor);
                assert_only(&first, &[GREEN, THROUGH]);
                let mut last = camera(size, away);
                put_floor(&mut last, floor);
                put_block(&mut last, size, is_model, turn);
                assert_only(&last, &[GREEN, THROUGH]);
            }
        }
    }
}

#[test]
fn c11_glass_on_a_tilted_floor_far_from_the_origin_shows_it_without_speckles() {
    for floor in [Floor::Plane, Floor::Block, Floor::Model] {
        let mut shot = camera(1.0, 4.0);
        put_floor(&mut shot, floor);
        put_block(&mut shot, 1.0, false, 20.0);
        let place = v(30.1, -7.3, 12.9);
        for object in &mut shot.scene.objects {
            object.group = Some("slope".into());
        }
        let slope =
            Group { name: "slope".into(), position: place, turn_deg: v(20.0, 0.0, 15.0), ..Group::default() };
        shot.scene.groups.push(slope);
        shot.scene.camera.position = place + v(0.3, 3.0, 2.0);
        shot.scene.camera.look_at = Some(place + v(0.0, 0.3, 0.0));
        assert_only(&shot, &[GREEN, THROUGH]);
    }
}

#[test]
fn c11_a_thing_on_a_glass_table_is_seen_through_it_from_below() {
    let mut shot = Shot::new([64, 48], v(0.2, -2.0, 1.5), Vec3::ZERO);
    shot.scene.settings.background = BLUE;
    shot.ambient(1.0);
    shot.put(cuboid(v(50.0, 0.02, 50.0)), glass(RED, 0.5)).position = v(0.0, -0.01, 0.0);
    shot.put(cuboid(v(1.0, 0.3, 0.7)), flat(GREEN)).position = v(0.0, 0.15, 0.0);
    assert_only(&shot, &[THROUGH, Rgb::new(0.75, 0.0, 0.25)]);
}

#[test]
fn c11_touching_blocks_of_glass_keep_their_order() {
    // From above, red over blue: the four surfaces in order.
    let blend = |colors: [Rgb; 4]| colors.iter().rev().fold(GREEN, |behind, c| *c * 0.5 + behind * 0.5);
    let truth = blend([RED, RED, BLUE, BLUE]);
    for turn in [0.0, 33.0] {
        let mut shot = Shot::new([64, 48], v(0.1, 4.0, 0.5), Vec3::ZERO);
        shot.scene.camera.view_angle_deg = 18.0;
        shot.ambient(1.0);
        put_floor(&mut shot, Floor::Plane);
        for (k, color) in [BLUE, RED].into_iter().enumerate() {
            let block = shot.put(cuboid(v(2.0, 0.3, 2.0)), glass(color, 0.5));
            (block.position, block.turn_deg) = (v(0.0, 0.15 + 0.3 * k as f32, 0.0), v(0.0, turn, 0.0));
        }
        assert_only(&shot, &[truth]);
    }
}

#[test]
fn c11_bent_rays_find_the_floor_under_the_glass() {
    for floor in [Floor::Plane, Floor::Block, Floor::Model, Floor::Triangles] {
        for (size, away, turn) in [(1.0, 3.0, 0.0), (0.3, 10.0, 30.0)] {
            let mut shot = camera(size, away);
            put_floor(&mut shot, floor);
            put_block(&mut shot, size, false, turn);
            let glass = shot.scene.materials.last_mut().expect("the block's");
            (glass.refraction, glass.transparency) = (Some(1.3), Some(1.0));
            // Wherever a ray leaves the glass downwards it meets the floor: a hole would be blue. Upwards it meets the sky.
            shot.scene.settings.background = GREEN;
            shot.put(plane(), flat(BLUE)).position = v(0.0, -2.0, 0.0);
            assert_only(&shot, &[GREEN]);
        }
    }
}

/// A ray to the lamp starts a hair above the floor, by more where the floor is large: above the lower face of a small block on a
/// large floor, else below it. So the light passes one face or two, but everywhere the same.
#[test]
fn c11_c12_the_floor_under_glass_is_lit_evenly() {
    for (floor, faces) in [(Floor::Plane, 2), (Floor::Block, 1), (Floor::Model, 1)] {
        let mut shot = camera(1.0, 4.0);
        put_floor(&mut shot, floor);
        put_block(&mut shot, 1.0, false, 20.0);
        shot.scene.materials[0] = vitrine_scene::Material { name: "material 0".into(), ..matte(GREEN) };
        // Black glass shows the floor's light alone.
        shot.scene.materials[1].color = Some(Rgb::BLACK);
        shot.scene.lights.clear();
        shot.sun(v(0.5, -1.0, -0.2), 1.0);
        let lit = GREEN * (1.0 / 1.29_f32.sqrt());
        let under = 0.5_f32.powi(2 + faces);
        let picture = shot.picture();
        let count = |share: f32| picture.pixels.iter().filter(|p| distance(**p, lit * share) < 1e-5).count();
        // In the open, in the block's shadow or through the block, and the shadow through the block.
        let counts = [1.0, 0.25, 0.0625, under].map(count);
        let even = counts[0] + counts[1] + counts[3] + if faces == 1 { counts[2] } else { 0 };
        assert_eq!(even, 64 * 48, "{floor:?}: {counts:?}");
        assert!(counts[0] > 500 && counts[1] > 50 && counts[3] > 100, "{floor:?}: {counts:?}");
    }
}

/// A rug of red glass in the floor's plane: the first in the scene is met first, whatever the tree, and the other behind it.
#[test]
fn of_a_disc_and_a_plane_in_one_place_the_first_in_the_scene_counts() {
    let through = Rgb::new(0.5, 0.5, 0.0);
    for (rug_first, colors) in [(true, [through, GREEN]), (false, [GREEN, GREEN])] {
        let mut shot = Shot::new([64, 64], v(0.3, 2.0, 2.5), Vec3::ZERO);
        let put_rug = |shot: &mut Shot| _ = shot.put(disc(1.0), glass(RED, 0.5));
        if rug_first {
            put_rug(&mut shot);
        }
        put_floor(&mut shot, Floor::Plane);
        if !rug_first {
            put_rug(&mut shot);
        }
        shot.ambient(1.0);
        shot.scene.settings.background = GREEN;
        assert_only(&shot, &colors);
    }
}
