//! C1 to C5 and C14: each shape is where it should be and turns the right way. Normals are read from the picture: three
//! coloured suns along the axes light a white surface by the components of its normal.

use crate::common::{
    BLUE, Dice, GREEN, RED, Shot, assert_near, ball, cuboid, disc, flat, matte, plane, triangle, v,
};
use crate::models;
use crate::oracle::{D3, turned};
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{Group, MeshMaterial, MeshPart, Object, Shape};

/// The normal, on the viewer's side, of what is seen in the direction of a point.
fn normal_seen(shot: &Shot, from: Vec3, at: Vec3) -> Vec3 {
    let lit = |sign: f32| {
        let mut shot = shot.cast();
        shot.scene.lights.clear();
        shot.sun(v(-sign, 0.0, 0.0), 1.0).color = RED;
        shot.sun(v(0.0, -sign, 0.0), 1.0).color = GREEN;
        shot.sun(v(0.0, 0.0, -sign), 1.0).color = BLUE;
        Vec3::from(shot.look(from, at).to_array())
    };
    lit(1.0) - lit(-1.0)
}

#[track_caller]
fn assert_normal(shot: &Shot, from: Vec3, at: Vec3, truth: Vec3, allowed: f32) {
    let seen = normal_seen(shot, from, at);
    assert!((seen - truth).length() <= allowed, "{seen} in place of {truth}");
    assert!((seen.length() - 1.0).abs() <= 1e-6, "the length of a normal is {}", seen.length());
}

/// One white object.
fn alone(shape: Shape, change: impl Fn(&mut Object)) -> Shot {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    change(shot.put(shape, matte(Rgb::WHITE)));
    shot
}

fn turn(p: Vec3, turn_deg: Vec3) -> Vec3 {
    Vec3::from(turned(D3::of(p), turn_deg).0.map(|c| c as f32))
}

#[test]
fn c1_a_ball_is_hit_where_it_is_at_any_size() {
    let mut dice = Dice(1);
    for radius in [1e-3_f32, 0.1, 1.0, 50.0, 1e4] {
        let center = dice.vector() * radius * 3.0;
        let shot = alone(ball(radius), |o| o.position = center);
        for _ in 0..40 {
            let n = dice.direction();
            let from = center + (n + dice.direction() * 0.7).normalize() * (radius * dice.between(2.5, 30.0));
            if (from - center).normalize().dot(n) > 0.5 {
                assert_normal(&shot, from, center + n * radius, n, 3e-5);
            }
        }
    }
}

#[test]
fn c1_the_rim_of_a_ball_is_where_the_tangent_is() {
    let mut shot = alone(ball(1.5), |o| o.position = v(0.0, 0.0, -4.0));
    shot.ambient(1.0);
    // The tangent from distance 4 has sin θ = 1.5/4.
    let rim = (1.5_f64 / 4.0).asin();
    for (angle, hit) in [(rim * 0.99999, true), (rim * 1.00001, false)] {
        for turn in [0.0_f64, 1.0, 2.5, 4.0] {
            let at = v((angle.tan() * turn.cos()) as f32, (angle.tan() * turn.sin()) as f32, -1.0);
            assert_eq!(shot.look(Vec3::ZERO, at) == Rgb::WHITE, hit, "{angle} at {turn}");
        }
    }
}

#[test]
fn c1_c14_a_stretched_ball_has_the_normals_of_an_ellipsoid() {
    let mut dice = Dice(2);
    for scale in [v(2.0, 1.0, 1.0), v(0.5, 3.0, 1.0), v(1.0, -0.2, 5.0)] {
        let (center, turn_deg) = (dice.vector() * 4.0, dice.vector() * 180.0);
        let shot = alone(ball(0.7), |o| (o.position, o.turn_deg, o.scale) = (center, turn_deg, scale));
        for _ in 0..40 {
            let u = dice.direction();
            // (x/a)² + (y/b)² + (z/c)² = 1 has the normal (x/a², y/b², z/c²).
            let (p, n) = (turn(u * 0.7 * scale, turn_deg), turn((u / scale).normalize(), turn_deg));
            let from = center + p + (n + dice.direction() * 0.5).normalize() * 20.0;
            assert_normal(&shot, from, center + p, n, 1e-4);
        }
    }
}

#[test]
fn c2_every_face_of_a_turned_box_is_in_its_place() {
    let mut dice = Dice(3);
    let size = v(2.0, 0.5, 1.0);
    for turn_deg in [Vec3::ZERO, v(0.0, 30.0, 0.0), v(10.0, -70.0, 45.0), v(90.0, 180.0, 0.0)] {
        let center = dice.vector() * 3.0;
        let shot = alone(cuboid(size), |o| (o.position, o.turn_deg) = (center, turn_deg));
        for (axis, side) in (0..3).flat_map(|axis| [(axis, -1.0_f32), (axis, 1.0)]) {
            for _ in 0..10 {
                let mut p = dice.vector() * 0.49 * size;
                p[axis] = side * 0.5 * size[axis];
                let (p, n) = (center + turn(p, turn_deg), turn(Vec3::AXES[axis] * side, turn_deg));
                let from = p + (n + dice.direction() * 0.6).normalize() * 9.0;
                assert_normal(&shot, from, p, n, 2e-6);
            }
        }
    }
}

#[test]
fn c2_the_edges_of_a_box_are_sharp() {
    let mut shot = alone(cuboid(v(2.0, 1.0, 1.0)), |_| ());
    shot.ambient(1.0);
    for (y, hit) in [(0.49999, true), (0.50001, false)] {
        for x in [-0.9, 0.0, 0.9] {
            assert_eq!(shot.look(v(x, y, 5.0), v(x, y, 0.0)) == Rgb::WHITE, hit);
            assert_eq!(shot.look(v(x, -y, 5.0), v(x, -y, 0.0)) == Rgb::WHITE, hit);
        }
    }
}

#[test]
fn c3_a_plane_is_level_until_it_is_turned_and_has_two_sides() {
    let level = alone(plane(), |o| o.position = v(3.0, -1.0, 2.0));
    for from in [v(0.0, 2.0, 0.0), v(500.0, 30.0, -700.0), v(0.0, 1e4, 0.0)] {
        assert_normal(&level, from, v(from.x + 1.0, -1.0, from.z), Vec3::Y, 0.0);
        let below = v(from.x, -2.0 - from.y, from.z);
        assert_normal(&level, below, v(from.x + 1.0, -1.0, from.z), Vec3::NEG_Y, 0.0);
    }
    for turn_deg in [v(90.0, 0.0, 0.0), v(0.0, 0.0, 30.0), v(20.0, 50.0, -65.0)] {
        let shot = alone(plane(), |o| o.turn_deg = turn_deg);
        let n = turn(Vec3::Y, turn_deg);
        assert_normal(&shot, n * 3.0 + v(0.1, 0.0, 0.2), Vec3::ZERO, n, 1e-6);
        assert_normal(&shot, n * -3.0, Vec3::ZERO, -n, 1e-6);
    }
}

#[test]
fn c3_a_plane_ends_at_the_horizon() {
    let mut shot = alone(plane(), |o| o.position = v(0.0, -1.0, 0.0));
    shot.ambient(1.0);
    assert_eq!(shot.look(Vec3::ZERO, v(0.0, -1e-4, -1.0)), Rgb::WHITE);
    assert_eq!(shot.look(Vec3::ZERO, v(0.0, 0.0, -1.0)), Rgb::BLACK, "along the plane");
    assert_eq!(shot.look(Vec3::ZERO, v(0.0, 1e-4, -1.0)), Rgb::BLACK);
}

#[test]
fn a_disc_is_hit_inside_its_rim_and_from_both_sides() {
    let mut dice = Dice(4);
    for (turn_deg, scale) in [
        (Vec3::ZERO, Vec3::ONE),
        (v(20.0, 50.0, -65.0), Vec3::splat(0.01)),
        (v(-70.0, 10.0, 15.0), v(3.0, 0.2, 0.5)),
        (v(0.0, 0.0, 90.0), v(1.0, -1.0, 2.0)),
    ] {
        let center = dice.vector() * 3.0;
        let mut shot = alone(disc(0.7), |o| (o.position, o.turn_deg, o.scale) = (center, turn_deg, scale));
        // Its upper side stays the outer one, wherever the scale turns it to.
        let n = turn(Vec3::Y, turn_deg) * scale.y.signum();
        for _ in 0..40 {
            let angle = dice.between(0.0, 6.3);
            let rim = turn(v(0.7 * angle.cos(), 0.0, 0.7 * angle.sin()) * scale, turn_deg);
            let aside = (n + dice.direction() * 0.6).normalize() * (20.0 * scale.x);
            for (part, is_hit) in [(dice.unit() * 0.99, true), (0.9999, true), (1.0001, false)] {
                let at = center + rim * part;
                shot.scene.lights.clear();
                if is_hit {
                    assert_normal(&shot, at + aside, at, n, 2e-6);
                    assert_normal(&shot, at - aside, at, -n, 2e-6);
                }
                shot.ambient(1.0);
                assert_eq!(shot.look(at + aside, at) == Rgb::WHITE, is_hit, "{part} of the radius");
                assert_eq!(shot.look(at - aside, at) == Rgb::WHITE, is_hit, "{part} of the radius");
            }
        }
    }
}

#[test]
fn a_disc_seen_from_its_edge_is_not_there() {
    let mut shot = alone(disc(1.0), |_| ());
    shot.ambient(1.0);
    for at in [Vec3::ZERO, v(0.3, 0.0, 0.2), v(1.0, 0.0, 0.0)] {
        assert_eq!(shot.look(v(5.0, 0.0, 0.0), at), Rgb::BLACK);
    }
}

#[test]
fn c4_a_triangle_is_hit_inside_its_edges_and_from_both_sides() {
    let points = [v(-1.0, -0.5, 0.2), v(1.5, 0.0, -0.4), v(0.1, 1.4, 0.3)];
    let mut shot = alone(triangle(points), |_| ());
    let [a, b, c] = points;
    let n = (b - a).cross(c - a).normalize();
    let at = |u: f32, w: f32| a + (b - a) * u + (c - a) * w;
    for (u, w) in [(0.3, 0.3), (0.01, 0.01), (0.98, 0.01), (0.01, 0.98), (0.5, 0.49)] {
        assert_normal(&shot, at(u, w) + n * 5.0, at(u, w), n, 1e-6);
        assert_normal(&shot, at(u, w) - n * 2.0, at(u, w), -n, 1e-6);
    }
    shot.ambient(1.0);
    let inside = |u, w| shot.look(at(u, w) + n * 5.0, at(u, w)) == Rgb::WHITE;
    for k in 1..10_u8 {
        let s = f32::from(k) / 10.0;
        assert!(inside(s, 1e-5) && inside(1e-5, s) && inside(s, 0.99999 - s));
        assert!(!inside(s, -1e-5) && !inside(-1e-5, s) && !inside(s, 1.00001 - s));
    }
}

#[test]
fn c5_a_model_of_a_cube_looks_like_the_box() {
    let place = |o: &mut Object| {
        (o.position, o.turn_deg, o.scale) = (v(0.2, 0.1, -0.3), v(20.0, 30.0, 40.0), v(0.5, 1.0, 0.7));
    };
    let mut model = Shot::new([64, 64], v(3.0, 2.0, 5.0), Vec3::ZERO);
    model.scene.camera.view_angle_deg = 25.0;
    let mut solid = model.clone();
    let cube = model.model(models::cube());
    place(model.put(cube, matte(Rgb::WHITE)));
    place(solid.put(cuboid(Vec3::splat(2.0)), matte(Rgb::WHITE)));
    for shot in [&mut model, &mut solid] {
        shot.ambient(0.1);
        shot.point(v(2.0, 5.0, 3.0), 0.9);
    }
    let (model, solid) = (model.picture(), solid.picture());
    assert!(solid.pixels.iter().filter(|p| p.r > 0.2).count() > 500);
    for (a, b) in model.pixels.iter().zip(&solid.pixels) {
        assert_near(*a, *b, 2e-6);
    }
}

#[test]
fn c5_smooth_normals_round_a_model_unless_it_is_told_otherwise() {
    let mut mesh = models::faceted_ball(1.0, 4);
    let corners = mesh.triangles[3].map(|i| mesh.positions[i as usize]);
    let weights = [0.2, 0.3, 0.5];
    let p: Vec3 = (0..3).map(|k| corners[k] * weights[k]).sum();
    let facet = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    let flat = shot.model(mesh.clone());
    shot.put(flat, matte(Rgb::WHITE));
    assert_normal(&shot, p * 4.0, p, facet, 1e-6);
    mesh.normals = mesh.positions.clone();
    let Shape::Mesh(smooth) = shot.model(mesh) else { unreachable!("a model is a mesh") };
    shot.scene.objects[0].shape = Shape::Mesh(smooth.clone());
    assert_normal(&shot, p * 4.0, p, p.normalize(), 1e-6);
    let angular = vitrine_scene::shapes::Mesh { smooth: false, ..smooth };
    shot.scene.objects[0].shape = Shape::Mesh(angular);
    assert_normal(&shot, p * 4.0, p, facet, 1e-6);
}

#[test]
fn c5_parts_of_a_model_keep_their_materials_unless_the_object_has_one() {
    let mut mesh = models::cube();
    let material = |color| MeshMaterial { material: flat(color), picture: None };
    mesh.materials = vec![material(RED), material(GREEN)];
    let part = |triangles, material| MeshPart { name: String::new(), triangles, material };
    mesh.parts = vec![part(0..4, Some(0)), part(4..8, None), part(8..12, Some(1))];
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    let shape = shot.model(mesh);
    shot.put_plain(shape);
    shot.ambient(1.0);
    let seen = |shot: &Shot, from: Vec3| shot.look(from, Vec3::ZERO);
    for (axis, color) in [(Vec3::X, RED), (Vec3::Y, Rgb::splat(0.8)), (Vec3::Z, GREEN)] {
        assert_eq!(seen(&shot, axis * 4.0 + v(0.01, 0.02, 0.03)), color);
        assert_eq!(seen(&shot, axis * -4.0 + v(0.01, 0.02, 0.03)), color);
    }
    shot.scene.materials.push(vitrine_scene::Material { name: "own".into(), ..flat(BLUE) });
    shot.scene.objects[0].material = Some("own".into());
    assert_eq!(seen(&shot, v(4.0, 0.1, 0.2)), BLUE);
}

#[test]
fn c14_groups_move_models_and_hide_them() {
    let mut shot = Shot::probe(v(0.0, 0.0, 20.0), Vec3::ZERO);
    let shape = shot.model(models::cube());
    for (k, color) in [RED, GREEN, BLUE].into_iter().enumerate() {
        let object = shot.put(shape.clone(), flat(color));
        object.position = v(4.0 * k as f32, 0.0, 0.0);
        object.group = Some("row".into());
    }
    let group = |name: &str, outer: Option<&str>| Group {
        name: name.into(),
        group: outer.map(str::to_owned),
        ..Group::default()
    };
    shot.scene.groups = vec![group("row", Some("hall")), group("hall", None)];
    shot.scene.groups[0].turn_deg = v(0.0, 0.0, 90.0);
    shot.scene.groups[1].position = v(-3.0, 1.0, 0.0);
    shot.scene.groups[1].scale = Vec3::splat(0.5);
    shot.ambient(1.0);
    // Turned up about Z, halved and moved: the middles are at y = 1, 3, 5 and x = −3.
    let seen = |shot: &Shot, y: f32| shot.look(v(0.0, 0.0, 20.0), v(-3.0, y, 0.5));
    assert_eq!([1.0, 3.0, 5.0].map(|y| seen(&shot, y)), [RED, GREEN, BLUE]);
    assert_eq!(seen(&shot, 1.49), RED);
    assert_eq!(seen(&shot, 1.51), Rgb::BLACK);
    shot.scene.objects[1].visible = false;
    assert_eq!([1.0, 3.0, 5.0].map(|y| seen(&shot, y)), [RED, Rgb::BLACK, BLUE]);
    shot.scene.groups[1].visible = false;
    assert_eq!([1.0, 3.0, 5.0].map(|y| seen(&shot, y)), [Rgb::BLACK; 3]);
}

#[test]
fn c1_c5_bounds_hold_every_point_that_is_hit() {
    let mut dice = Dice(9);
    for k in 0..40 {
        let (position, turn_deg) = (dice.vector() * 5.0, dice.vector() * 180.0);
        let scale = v(dice.between(0.1, 2.0), dice.between(0.1, 2.0), dice.between(0.1, 2.0));
        let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
        let shape = match k % 4 {
            0 => ball(1.0),
            1 => cuboid(Vec3::splat(2.0)),
            2 => disc(1.0),
            _ => shot.model(models::faceted_ball(1.0, 6)),
        };
        let object = shot.put(shape, flat(Rgb::WHITE));
        (object.position, object.turn_deg, object.scale) = (position, turn_deg, scale);
        shot.ambient(1.0);
        let bounds = shot.compiled().bounds();
        for _ in 0..40 {
            // A point of the surface: on the ball or the model's ball; the same direction on the cube and from above on the disc.
            let u = dice.direction();
            let on = match k % 4 {
                0 => u,
                1 => u / u.abs().max_element(),
                2 => u.with_y(0.0),
                _ => u * 0.9,
            };
            let p = position + turn(on * scale, turn_deg);
            let slack = Vec3::splat(1e-5);
            assert!(bounds.min.cmple(p + slack).all() && bounds.max.cmpge(p - slack).all(), "{p} {bounds:?}");
            assert_eq!(shot.look(p + dice.direction() * 30.0, position + (p - position) * 0.99), Rgb::WHITE);
        }
    }
}
