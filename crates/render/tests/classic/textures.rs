//! C7: pictures and patterns lie on every shape where they should. A picture whose red grows with u and whose green grows
//! with v shows the coordinates themselves.

use crate::common::{
    BLUE, Dice, GREEN, RED, Shot, assert_near, ball, cuboid, disc, flat, matte, plane, triangle, v,
};
use crate::models;
use std::path::PathBuf;
use std::sync::Arc;
use vitrine_math::{Rgb, Vec2, Vec3};
use vitrine_scene::shapes::Triangle;
use vitrine_scene::textures::{Checker, PictureFile};
use vitrine_scene::{Material, MeshMaterial, Picture, Shape, TextureSource, Wrap};

const YELLOW: Rgb = Rgb::new(1.0, 1.0, 0.0);

/// Green, yellow over black, red.
fn ramp() -> Picture {
    Picture { size: [2, 2], texels: vec![[0, 255, 0], [255, 255, 0], [0, 0, 0], [255, 0, 0]] }
}

fn picture(shot: &mut Shot, picture: Picture, wrap: Wrap) -> String {
    let file = format!("picture {}.png", shot.assets.pictures.len());
    shot.assets.pictures.insert(PathBuf::from(&file), Arc::new(picture));
    shot.texture(TextureSource::Picture(PictureFile { file, wrap }))
}

/// A shape that shows its coordinates from 0 to 1 as red and green.
fn showing_coordinates(shape: impl FnOnce(&mut Shot) -> Shape) -> Shot {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    let texture = picture(&mut shot, ramp(), Wrap::Clamp);
    // From the middle of the first texel to that of the second.
    (shot.scene.textures[0].repeat, shot.scene.textures[0].shift) = ([0.5; 2], [0.25; 2]);
    let shape = shape(&mut shot);
    shot.put(shape, Material { texture: Some(texture), ..flat(BLUE) });
    shot.ambient(1.0);
    shot
}

#[track_caller]
fn assert_coordinates(shot: &Shot, from: Vec3, at: Vec3, [u, v]: [f32; 2]) {
    assert_near(shot.look(from, at), Rgb::new(u, v, 0.0), 3e-6);
}

fn longitude_and_latitude(n: Vec3) -> [f32; 2] {
    let n = [n.x, n.y, n.z].map(f64::from);
    let u = 0.5 + n[0].atan2(n[2]) / std::f64::consts::TAU;
    [u as f32, (0.5 + n[1].asin() / std::f64::consts::PI) as f32]
}

#[test]
fn c7_a_ball_has_longitude_and_latitude() {
    let mut dice = Dice(21);
    let shot = showing_coordinates(|_| ball(2.0));
    for _ in 0..100 {
        let n = dice.direction();
        assert_coordinates(&shot, n * 6.0 + dice.vector(), n * 2.0, longitude_and_latitude(n));
    }
    assert_coordinates(&shot, v(0.0, 0.0, 9.0), v(0.0, 0.0, 2.0), [0.5, 0.5]);
    assert_coordinates(&shot, v(9.0, 0.0, 0.0), v(2.0, 0.0, 0.0), [0.75, 0.5]);
}

#[test]
fn c7_c14_the_picture_turns_and_stretches_with_the_ball() {
    let mut shot = showing_coordinates(|_| ball(1.0));
    let n = v(0.48, 0.6, 0.64);
    shot.scene.objects[0].turn_deg = v(0.0, 90.0, 0.0);
    // Turned by 90° about Y, Z goes to X and X to −Z.
    let turned = v(n.z, n.y, -n.x);
    assert_coordinates(&shot, turned * 5.0, turned, longitude_and_latitude(n));
    let scale = v(1.0, 3.0, 0.5);
    (shot.scene.objects[0].turn_deg, shot.scene.objects[0].scale) = (Vec3::ZERO, scale);
    assert_coordinates(&shot, n * scale + n / scale * 5.0, n * scale, longitude_and_latitude(n));
}

#[test]
fn c7_a_triangle_mixes_its_corners() {
    let points = [v(-1.0, 0.0, 0.0), v(1.0, 0.0, 0.5), v(0.0, 1.5, 0.0)];
    let check = |uvs: [[f32; 2]; 3]| {
        let shot = showing_coordinates(|_| Shape::Triangle(Triangle { points, uvs }));
        for weights in [[0.2_f32, 0.3, 0.5], [0.8, 0.1, 0.1], [0.05, 0.05, 0.9]] {
            let at = (0..3).map(|k| points[k] * weights[k]).sum::<Vec3>();
            let truth = [0, 1].map(|c| (0..3).map(|k| uvs[k][c] * weights[k]).sum::<f32>());
            assert_coordinates(&shot, at + v(0.1, 0.2, 3.0), at, truth);
            assert_coordinates(&shot, at - v(0.1, 0.2, 3.0), at, truth);
        }
    };
    check(Triangle::default().uvs);
    check([[0.1, 0.9], [0.3, 0.2], [1.0, 0.4]]);
}

#[test]
fn c7_every_face_of_a_box_shows_the_picture_upright() {
    let shot = showing_coordinates(|_| cuboid(v(2.0, 4.0, 6.0)));
    let half = v(1.0, 2.0, 3.0);
    // The face's normal, its right and its up, seen from outside; top and bottom as seen from the front.
    for (n, right, up) in [
        (Vec3::Z, Vec3::X, Vec3::Y),
        (Vec3::NEG_Z, Vec3::NEG_X, Vec3::Y),
        (Vec3::X, Vec3::NEG_Z, Vec3::Y),
        (Vec3::NEG_X, Vec3::Z, Vec3::Y),
        (Vec3::Y, Vec3::X, Vec3::NEG_Z),
        (Vec3::NEG_Y, Vec3::X, Vec3::Z),
    ] {
        for [a, b] in [[0.0, 0.0], [0.5, 0.25], [-0.9, 0.8], [0.99, -0.99]] {
            let at = (n + right * a + up * b) * half;
            assert_coordinates(&shot, at + n * 5.0 + right, at, [0.5 + 0.5 * a, 0.5 + 0.5 * b]);
        }
    }
}

#[test]
fn a_disc_shows_the_picture_as_seen_from_above() {
    let mut shot = showing_coordinates(|_| disc(2.0));
    let (place, scale) = (v(3.0, 1.0, -2.0), v(2.0, 1.0, 0.5));
    for [x, z] in [[0.0_f32, 0.0], [0.5, 0.25], [-0.7, 0.7], [0.999, 0.0], [0.0, -0.999]] {
        let (at, uv) = (v(x, 0.0, z), [0.5 + 0.5 * x, 0.5 - 0.5 * z]);
        shot.scene.objects[0].position = Vec3::ZERO;
        shot.scene.objects[0].scale = Vec3::ONE;
        assert_coordinates(&shot, at * 2.0 + v(0.1, 3.0, 0.2), at * 2.0, uv);
        assert_coordinates(&shot, at * 2.0 + v(0.1, -3.0, 0.2), at * 2.0, uv);
        (shot.scene.objects[0].position, shot.scene.objects[0].scale) = (place, scale);
        let at = place + at * 2.0 * scale;
        assert_coordinates(&shot, at + v(0.1, 3.0, 0.2), at, uv);
    }
}

#[test]
fn c7_a_plane_counts_metres() {
    let mut shot = showing_coordinates(|_| plane());
    for (x, z) in [(0.25, -0.75), (0.9, -0.1), (0.01, -0.02)] {
        assert_coordinates(&shot, v(x, 2.0, z + 1.0), v(x, 0.0, z), [x, -z]);
    }
    shot.scene.objects[0].position = v(100.0, 1.0, 50.0);
    shot.scene.objects[0].scale = Vec3::splat(2.0);
    assert_coordinates(&shot, v(100.5, 2.0, 50.0), v(100.5, 1.0, 49.0), [0.25, 0.5]);
}

#[test]
fn c7_a_model_has_its_own_coordinates_or_those_of_a_ball_around_its_middle() {
    let mut mesh = models::square();
    let shot = showing_coordinates(|shot| shot.model(mesh.clone()));
    for [a, b] in [[0.0, 0.0], [0.6, 0.3], [-0.9, 0.95]] {
        assert_coordinates(&shot, v(a, 3.0, 0.5 - b), v(a, 0.0, -b), [0.5 + 0.5 * a, 0.5 + 0.5 * b]);
    }
    mesh = models::cube();
    mesh.positions.iter_mut().for_each(|p| *p += v(10.0, 20.0, 30.0));
    let shot = showing_coordinates(|shot| shot.model(mesh));
    for on in [v(1.0, 0.3, -0.6), v(-0.2, 1.0, 0.4), v(0.5, 0.2, 1.0)] {
        let at = v(10.0, 20.0, 30.0) + on;
        assert_coordinates(&shot, at + on * 3.0, at, longitude_and_latitude(on.normalize()));
    }
}

/// A plane of four texels, black and yellow on the diagonal, red and green on the other.
fn texels(wrap: Wrap) -> Shot {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    let texture = picture(&mut shot, ramp(), wrap);
    shot.put(plane(), Material { texture: Some(texture), ..flat(BLUE) });
    shot.ambient(1.0);
    shot
}

fn at(shot: &Shot, u: f32, w: f32) -> Rgb {
    shot.look(v(u, 1.0, -w), v(u, 0.0, -w))
}

#[test]
fn c7_pictures_repeat_or_keep_their_edge() {
    let corners = [(0.25, 0.25, Rgb::BLACK), (0.75, 0.25, RED), (0.25, 0.75, GREEN), (0.75, 0.75, YELLOW)];
    let (repeated, clamped) = (texels(Wrap::Repeat), texels(Wrap::Clamp));
    for (u, w, color) in corners {
        for (du, dw) in [(0.0, 0.0), (1.0, 0.0), (-3.0, 2.0), (64.0, -64.0)] {
            assert_near(at(&repeated, u + du, w + dw), color, 2e-5);
        }
        assert_near(at(&clamped, u, w), color, 1e-6);
    }
    assert_near(at(&clamped, -5.0, -7.0), Rgb::BLACK, 0.0);
    assert_near(at(&clamped, 5.0, -7.0), RED, 0.0);
    assert_near(at(&clamped, -5.0, 0.75), GREEN, 1e-6);
    // Across the seam of a repeated picture the edges mix.
    assert_near(at(&repeated, 1.0, 0.25), RED * 0.5, 1e-6);
}

#[test]
fn c7_repeat_and_shift_count_pictures() {
    let mut shot = texels(Wrap::Repeat);
    shot.scene.textures[0].repeat = [2.0, 4.0];
    assert_near(at(&shot, 0.125, 0.0625), Rgb::BLACK, 1e-6);
    assert_near(at(&shot, 0.375, 0.0625), RED, 1e-6);
    assert_near(at(&shot, 0.125, 0.1875), GREEN, 1e-6);
    shot.scene.textures[0].repeat = [1.0, 1.0];
    shot.scene.textures[0].shift = [0.5, 0.0];
    assert_near(at(&shot, 0.25, 0.25), RED, 1e-6);
    shot.scene.textures[0].shift = [-7.0, 2.5];
    assert_near(at(&shot, 0.25, 0.25), GREEN, 1e-5);
}

#[test]
fn c7_a_checker_alternates() {
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    let texture = shot.texture(TextureSource::Checker(Checker { color: RED, other_color: GREEN }));
    shot.put(plane(), Material { texture: Some(texture), ..flat(BLUE) });
    shot.ambient(1.0);
    for (i, j) in (-3..4).flat_map(|i| (-3..4).map(move |j| (i, j))) {
        let color = if (i + j) % 2 == 0 { RED } else { GREEN };
        let (u, w) = (0.5 * i as f32, 0.5 * j as f32);
        for [a, b] in [[0.25, 0.25], [0.01, 0.01], [0.49, 0.01], [0.49, 0.49]] {
            assert_eq!(at(&shot, u + a, w + b), color, "square {i}, {j}");
        }
    }
}

#[test]
fn c7_c9_a_texture_tints_all_but_the_highlight() {
    let mut shot = Shot::probe(v(0.0, 0.0, 5.0), Vec3::ZERO);
    let texture = shot.texture(TextureSource::Checker(Checker { color: GREEN, other_color: GREEN }));
    let material = Material { texture: Some(texture), specular: Some(0.25), ..matte(RED) };
    shot.put(ball(1.0), material);
    shot.ambient(0.5);
    shot.sun(v(0.0, 0.0, -1.0), 0.4);
    assert_near(shot.pixel(), GREEN * 0.9 + Rgb::splat(0.1), 1e-6);
}

#[test]
fn c7_c11_a_texture_lies_on_transparent_things_too() {
    let mut shot = Shot::probe(v(0.25, 1.0, -0.25), v(0.25, 0.0, -0.25));
    shot.scene.settings.background = BLUE;
    let texture = shot.texture(TextureSource::Checker(Checker { color: RED, other_color: GREEN }));
    shot.put(plane(), Material { texture: Some(texture), transparency: Some(0.75), ..flat(Rgb::WHITE) });
    shot.ambient(1.0);
    assert_near(shot.pixel(), RED * 0.25 + BLUE * 0.75, 1e-6);
    assert_near(at(&shot, 0.75, 0.25), GREEN * 0.25 + BLUE * 0.75, 1e-6);
}

#[test]
fn c5_c7_a_models_material_brings_its_picture() {
    let mut mesh = models::square();
    mesh.parts[0].material = Some(0);
    let path = PathBuf::from("wood.png");
    mesh.materials = vec![MeshMaterial { material: flat(BLUE), picture: Some(path.clone()) }];
    let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
    shot.assets.pictures.insert(path, Arc::new(ramp()));
    let shape = shot.model(mesh);
    shot.put_plain(shape);
    shot.ambient(1.0);
    for (uv, color) in [(Vec2::new(0.25, 0.75), GREEN), (Vec2::new(0.75, 0.75), YELLOW)] {
        let p = v(2.0 * uv.x - 1.0, 0.0, 1.0 - 2.0 * uv.y);
        assert_near(shot.look(p + Vec3::Y, p), color, 1e-6);
    }
}

#[test]
fn c4_c7_a_plain_triangle_has_the_whole_picture_from_corner_to_corner() {
    let shot = showing_coordinates(|_| triangle([v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.5, 1.0, 0.0)]));
    for p in [v(0.5, 0.9, 0.0), v(0.1, 0.05, 0.0), v(0.9, 0.05, 0.0)] {
        assert_coordinates(&shot, p + Vec3::Z, p, [p.x, p.y]);
    }
}
