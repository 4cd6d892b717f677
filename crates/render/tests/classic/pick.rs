//! What lies under a pixel: the object that the picture shows there, its point and its normal.

use crate::common::{Dice, Rgb, Shot, Vec3, ball, cuboid, flat, glass, plane, v};
use crate::models;
use vitrine_math::Ray;
use vitrine_render::NO_OBJECT;
use vitrine_scene::Object;

/// Each object shows a colour of its own; the second is hidden.
fn colourful() -> Shot {
    let mut shot = Shot::new([203, 117], v(0.5, 2.0, 7.0), v(0.0, 0.5, 0.0));
    shot.ambient(1.0);
    let mut dice = Dice(11);
    shot.put(ball(1.0), flat(dice.color())).position = v(-1.5, 1.0, 0.0);
    shot.put(ball(50.0), flat(dice.color())).visible = false;
    let object: &mut Object = shot.put(cuboid(v(1.0, 2.0, 1.0)), flat(dice.color()));
    (object.position, object.turn_deg) = (v(1.0, 1.0, 0.0), v(10.0, 30.0, 5.0));
    let model = shot.model(models::faceted_ball(1.0, 6));
    shot.put(model, flat(dice.color())).position = v(0.0, 1.0, 2.0);
    let object = shot.put(ball(0.5), flat(dice.color()));
    (object.position, object.scale) = (v(2.5, 0.5, 2.0), v(1.0, 2.0, 0.5));
    shot
}

#[test]
fn the_map_of_objects_shows_what_the_picture_shows() {
    let shot = colourful();
    let scene = shot.compiled();
    let size = shot.scene.settings.size;
    let map = scene.object_map(size, 3);
    let picture = shot.picture();
    assert_eq!(map.len(), picture.pixels.len());
    let color_of = |object: u32| match object {
        NO_OBJECT => Rgb::BLACK,
        index => shot.scene.materials[index as usize].color.unwrap(),
    };
    for (i, (&object, &seen)) in map.iter().zip(&picture.pixels).enumerate() {
        assert_eq!(color_of(object), seen, "pixel {i}");
    }
    for wanted in [0, 2, 3, 4, NO_OBJECT] {
        assert!(map.contains(&wanted), "{wanted} is in the picture");
    }
    assert_eq!(scene.object_map(size, 1), map);
}

#[test]
fn picking_agrees_with_the_map_and_lies_on_the_ray() {
    let shot = colourful();
    let scene = shot.compiled();
    let size = shot.scene.settings.size;
    let map = scene.object_map(size, 2);
    for (x, y) in (0..size[1]).step_by(3).flat_map(|y| (0..size[0]).step_by(3).map(move |x| (x, y))) {
        let at = [x as f32 + 0.5, y as f32 + 0.5];
        let picked = scene.pick(at, size);
        let index = picked.map_or(NO_OBJECT, |p| p.object as u32);
        assert_eq!(index, map[(y * size[0] + x) as usize], "{x} {y}");
        let Some(picked) = picked else { continue };
        let ray = scene.camera_ray(at, size);
        assert!((ray.at(picked.distance) - picked.point).length() < 1e-4, "{picked:?}");
        assert!(picked.n.is_normalized() && picked.n.dot(ray.direction) < 1e-3, "{picked:?}");
    }
}

#[test]
fn glass_is_picked_before_what_is_behind_it() {
    let mut shot = Shot::new([9, 9], v(0.0, 1.0, 5.0), v(0.0, 1.0, 0.0));
    shot.put(plane(), flat(Rgb::WHITE));
    shot.put(ball(0.5), flat(Rgb::WHITE)).position = v(0.0, 1.0, 0.0);
    shot.put(ball(1.0), glass(Rgb::WHITE, 1.0)).position = v(0.0, 1.0, 0.0);
    let picked = shot.compiled().pick([4.5, 4.5], [9, 9]).unwrap();
    assert_eq!(picked.object, 2);
    assert!((picked.distance - 4.0).abs() < 1e-5 && (picked.n - Vec3::Z).length() < 1e-5, "{picked:?}");
}

#[test]
fn rays_of_any_length_are_met_in_metres_and_end_where_they_say() {
    let mut shot = Shot::new([9, 9], v(0.0, 1.0, 5.0), Vec3::ZERO);
    shot.put(plane(), flat(Rgb::WHITE));
    let scene = shot.compiled();
    let down = Ray::new(v(3.0, 4.0, -2.0), v(0.0, -0.5, 0.0));
    let picked = scene.ray_hit(&down).unwrap();
    assert!((picked.distance - 4.0).abs() < 1e-5 && (picked.point - v(3.0, 0.0, -2.0)).length() < 1e-5);
    assert_eq!(picked.n, Vec3::Y);
    assert!(scene.ray_hit(&Ray { t_max: 7.9, ..down }).is_none(), "it ends before");
    assert!(scene.ray_hit(&Ray { t_max: 8.1, ..down }).is_some());
    assert!(scene.ray_hit(&Ray::new(Vec3::ONE, Vec3::ZERO)).is_none());
    assert!(scene.object_map([0, 5], 2).is_empty());
}

#[test]
fn one_looks_through_what_is_transparent_and_no_farther() {
    let mut shot = Shot::new([40, 40], v(0.0, 1.0, 6.0), v(0.0, 1.0, 0.0));
    shot.put(plane(), flat(Rgb::WHITE));
    shot.put(ball(0.5), flat(Rgb::WHITE)).position = v(0.0, 1.0, 0.0);
    shot.put(ball(2.0), glass(Rgb::WHITE, 0.5)).position = v(0.0, 1.0, 0.0);
    shot.put(ball(1.0), glass(Rgb::WHITE, 0.9)).position = v(0.0, 1.0, 0.0);
    let scene = shot.compiled();
    let objects = |at| scene.pick_through(at, [40, 40]).iter().map(|p| p.object).collect::<Vec<_>>();
    assert_eq!(objects([20.0, 20.0]), [2, 3, 1], "each shell once, and not what the ball hides");
    assert_eq!(objects([20.0, 39.5]), [0]);
    assert_eq!(objects([20.0, 0.5]), []);
    let behind = scene.object_map_behind_glass([40, 40], 2);
    let nearest = scene.object_map([40, 40], 2);
    for (i, (&behind, &nearest)) in behind.iter().zip(&nearest).enumerate() {
        let at = [(i % 40) as f32 + 0.5, (i / 40) as f32 + 0.5];
        let seen = objects(at);
        let opaque = seen.last().copied().filter(|o| *o < 2).map_or(NO_OBJECT, |o| o as u32);
        assert_eq!(behind, opaque, "{at:?}");
        assert_eq!(nearest, seen.first().map_or(NO_OBJECT, |o| *o as u32), "{at:?}");
    }
    assert!(behind.contains(&1) && behind.contains(&NO_OBJECT) && !nearest.contains(&1));
}
