//! Scenes that are missing something, or hold awkward numbers: a clear error or a picture, never a panic and never a number
//! that is none.

use crate::common::{
    GREEN, RED, Shot, assert_near, ball, cuboid, disc, flat, glass, matte, plane, triangle, v,
};
use crate::models;
use vitrine_math::{Rgb, Vec3};
use vitrine_render::{CompileError, ModelFlaw, compile};
use vitrine_scene::shapes::Mesh;
use vitrine_scene::textures::PictureFile;
use vitrine_scene::{Group, Material, MeshMaterial, Shape, TextureSource, TriangleMesh};

fn error(shot: &Shot) -> CompileError {
    compile(&shot.scene, &shot.assets).expect_err("the scene does not compile")
}

fn empty() -> Shot {
    let mut shot = Shot::new([33, 33], v(0.0, 0.0, 5.0), Vec3::ZERO);
    shot.ambient(1.0);
    shot
}

#[track_caller]
fn assert_sane(shot: &Shot) {
    for (i, p) in shot.picture().pixels.iter().enumerate() {
        assert!(p.is_finite() && p.to_array().iter().all(|c| *c >= 0.0), "pixel {i} is {p:?}");
    }
}

#[test]
fn missing_models_and_pictures_are_named() {
    let mut shot = empty();
    shot.put(Shape::Mesh(Mesh { file: "gone.obj".into(), ..Mesh::default() }), flat(RED)).name =
        "cone".into();
    assert_eq!(error(&shot), CompileError::MissingModel { object: "cone".into() });
    shot.scene.objects[0].visible = false;
    assert!(compile(&shot.scene, &shot.assets).is_ok(), "what is hidden is not needed");

    let mut shot = empty();
    let file = "gone.png".into();
    shot.texture(TextureSource::Picture(PictureFile { file, ..PictureFile::default() }));
    assert_eq!(error(&shot), CompileError::MissingPicture { texture: "texture 0".into() });

    let mut shot = empty();
    let mut mesh = models::cube();
    let material = Material { name: "bark".into(), ..Material::default() };
    mesh.materials = vec![MeshMaterial { material, picture: Some("gone.png".into()) }];
    let shape = shot.model(mesh);
    shot.put_plain(shape);
    assert_eq!(error(&shot), CompileError::MissingPicture { texture: "bark".into() });
}

#[test]
fn names_that_the_scene_does_not_have_are_named_with_who_wants_them() {
    let mut shot = empty();
    shot.put_plain(ball(1.0)).material = Some("gold".into());
    assert_eq!(error(&shot).to_string(), "`object 0` refers to `gold`, which the scene does not have");
    let mut shot = empty();
    shot.put(ball(1.0), Material { texture: Some("wood".into()), ..Material::default() });
    assert_eq!(error(&shot).to_string(), "`material 0` refers to `wood`, which the scene does not have");
}

#[test]
fn models_that_make_no_sense_are_refused_by_name() {
    let refused = |change: &dyn Fn(&mut TriangleMesh), transparency: f32| {
        let mut shot = empty();
        let mut mesh = models::square();
        change(&mut mesh);
        let shape = shot.model(mesh);
        shot.put(shape, glass(RED, transparency)).name = "sail".into();
        match error(&shot) {
            CompileError::BadModel { object, flaw } if object == "sail" => flaw,
            other => panic!("{other}"),
        }
    };
    for number in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for (vertex, axis) in (0..4).flat_map(|vertex| (0..3).map(move |axis| (vertex, axis))) {
            for transparency in [0.0, 0.5] {
                let flaw = refused(&|mesh| mesh.positions[vertex][axis] = number, transparency);
                assert_eq!(flaw, ModelFlaw::Position);
            }
        }
        let normals = |mesh: &mut TriangleMesh| mesh.normals = vec![v(0.0, number, 0.0); 4];
        assert_eq!(refused(&normals, 0.0), ModelFlaw::Normals);
        assert_eq!(refused(&|mesh| mesh.uvs[2].y = number, 0.0), ModelFlaw::Uvs);
    }
    assert_eq!(refused(&|mesh| mesh.normals = vec![Vec3::Y; 3], 0.0), ModelFlaw::Normals);
    assert_eq!(refused(&|mesh| mesh.uvs.truncate(3), 0.0), ModelFlaw::Uvs);
    assert_eq!(refused(&|mesh| mesh.triangles[1][2] = 4, 0.0), ModelFlaw::Corner { triangle: 1 });
    assert_eq!(refused(&|mesh| mesh.parts[0].triangles.end = 3, 0.0), ModelFlaw::Part { part: 0 });
    assert_eq!(refused(&|mesh| mesh.parts[0].material = Some(0), 0.0), ModelFlaw::Part { part: 0 });
}

#[test]
fn what_is_too_large_or_too_far_is_refused_by_name() {
    let shape = |shot: &mut Shot, kind: u32, s: f32| match kind {
        0 => ball(s),
        1 => cuboid(v(1.0, s, 1.0)),
        2 => disc(s),
        3 => triangle([Vec3::ZERO, v(s, 0.0, 0.0), v(0.0, 1.0, 0.0)]),
        _ => shot.model(models::faceted_ball(s, 2)),
    };
    let refused = |kind: u32, size: f32, position: Vec3| {
        let mut shot = empty();
        let shape = shape(&mut shot, kind, size);
        let object = shot.put(shape, matte(RED));
        (object.name, object.position) = ("giant".into(), position);
        assert_eq!(error(&shot), CompileError::OutOfRange { object: "giant".into() });
    };
    for kind in 0..5 {
        [3e12_f32, 1e30, 3e38].into_iter().for_each(|size| refused(kind, size, Vec3::ZERO));
        refused(kind, 1.0, v(0.0, -1e30, 0.0));
    }
    let mut shot = empty();
    shot.put(plane(), matte(RED)).position = v(0.0, -1e30, 0.0);
    assert!(error(&shot).to_string().contains("1e12 metres"));
}

#[test]
fn what_is_large_and_allowed_is_seen() {
    for size in [1e3_f32, 1e6, 1e9, 1e11] {
        let mut shot = Shot::probe(v(0.0, 0.0, 5.0 * size), Vec3::ZERO);
        shot.ambient(0.5);
        shot.sun(v(0.0, 0.0, -1.0), 0.5);
        for (k, x) in [-4.0_f32, -2.0, 0.0, 2.0].into_iter().enumerate() {
            let shape = match k {
                0 => ball(size),
                1 => cuboid(Vec3::splat(size)),
                2 => triangle([v(-size, -size, 0.0), v(size, -size, 0.0), v(0.0, size, 0.0)]),
                _ => shot.model(models::faceted_ball(size, 3)),
            };
            shot.put(shape, matte(GREEN)).position = v(x * size, 0.0, 0.0);
            let seen = shot.look(v(x * size, 0.0, 9.0 * size), v(x * size, 0.0, 0.0));
            assert!(seen.g > 0.9, "shape {k} of size {size}: {seen:?}");
        }
    }
}

#[test]
fn what_is_tiny_does_no_harm() {
    for size in [1e-6_f32, 1e-12, 1e-30, 1e-38, 1e-45] {
        let mut shot = empty();
        shot.put(ball(size), matte(RED));
        shot.put(ball(1.0), matte(RED)).scale = v(size.max(2e-18), 1.0, 1.0);
        shot.put(triangle([Vec3::ZERO, v(size, 0.0, 0.0), v(0.0, size, 0.0)]), matte(RED));
        let model = shot.model(models::faceted_ball(size, 2));
        shot.put(model, glass(RED, 0.5));
        shot.point(v(1.0, 2.0, 3.0), 1.0);
        shot.put(cuboid(Vec3::splat(size.max(4e-18))), glass(GREEN, 0.5));
        shot.put(cuboid(v(1.0, size.max(4e-18), 1.0)), matte(GREEN)).turn_deg = v(40.0, 20.0, 0.0);
        assert_sane(&shot);
    }
}

#[test]
fn a_scene_may_be_small_all_over() {
    // Everything a thousandth of a millimetre: the picture is that of the scene a metre wide.
    let picture = |scale: f32| {
        let mut shot = Shot::new([48, 48], v(0.0, 2.0, 5.0) * scale, Vec3::ZERO);
        shot.put(plane(), matte(Rgb::WHITE)).position = v(0.0, -1.0, 0.0) * scale;
        shot.put(ball(scale), matte(RED));
        shot.put(cuboid(Vec3::splat(scale)), glass(GREEN, 0.5)).position = v(1.5, -0.5, 0.5) * scale;
        shot.point(v(3.0, 5.0, 4.0) * scale, 1.0);
        shot.picture()
    };
    let metre = picture(1.0);
    // A power of two changes exponents alone.
    for scale in [2.0_f32.powi(-20), 2.0_f32.powi(10)] {
        assert!(picture(scale) == metre, "scale {scale}");
    }
}

#[test]
fn empty_models_and_single_triangles_are_models() {
    let mut shot = empty();
    let nothing = shot.model(TriangleMesh::default());
    shot.put(nothing, glass(RED, 0.5));
    assert_eq!(shot.pixel(), Rgb::BLACK);
    assert!(shot.compiled().bounds().is_empty());
    let corners = vec![v(-1.0, -1.0, 0.0), v(1.0, -1.0, 0.0), v(0.0, 1.0, 0.0)];
    let one = shot.model(models::of(corners, vec![[0, 1, 2]]));
    shot.put(one, flat(GREEN));
    assert_eq!(shot.look(v(0.0, 0.0, 5.0), Vec3::ZERO), GREEN);
    assert_eq!(shot.compiled().triangles(), 1);
}

#[test]
fn triangles_without_area_are_not_seen() {
    let p = v(0.3, 0.2, 0.1);
    let mut shot = empty();
    let mesh =
        models::of(vec![p, p, v(1.0, 0.0, 0.0), v(2.0, 0.0, 0.0)], vec![[0, 1, 2], [0, 0, 0], [2, 3, 2]]);
    let shape = shot.model(mesh);
    shot.put(shape, matte(RED));
    assert_sane(&shot);
}

#[test]
fn a_hundred_thousand_triangles_in_one_place_are_no_trouble() {
    let mut shot = empty();
    let corners = vec![v(-1.0, -1.0, 0.0), v(1.0, -1.0, 0.0), v(0.0, 1.0, 0.0)];
    let shape = shot.model(models::of(corners, vec![[0, 1, 2]; 100_000]));
    shot.put(shape, matte(GREEN));
    shot.scene.settings.size = [4, 4];
    shot.scene.camera.view_angle_deg = 5.0;
    assert!(shot.picture().pixels.iter().all(|p| *p == GREEN));
}

#[test]
fn flat_boxes_are_sheets() {
    for thickness in [1e-3_f32, 1e-7, 1e-12, 1e-17] {
        let mut shot = Shot::probe(v(0.3, 2.0, 0.1), v(0.2, 0.0, 0.0));
        shot.put(cuboid(v(2.0, thickness, 2.0)), matte(GREEN));
        shot.sun(v(0.0, -1.0, 0.0), 1.0);
        assert_near(shot.pixel(), GREEN, 1e-6);
        shot.scene.objects[0].turn_deg = v(90.0, 0.0, 0.0);
        shot.scene.lights.clear();
        shot.sun(v(0.0, 0.0, -1.0), 1.0);
        assert_near(shot.look(v(0.3, 0.1, 5.0), v(0.2, 0.3, 0.0)), GREEN, 1e-6);
    }
}

/// Twice as much would be no number, which its box does not show.
#[test]
fn a_disc_may_be_stretched_across_itself_as_far_as_numbers_go() {
    let mut shot = Shot::probe(v(0.3, 2.0, 0.1), v(0.2, 0.0, 0.0));
    shot.put(disc(2.0), flat(GREEN)).scale = v(1.0, 3.4e38, 1.0);
    shot.ambient(1.0);
    assert_eq!(shot.compiled().validate(), Ok(()));
    assert_eq!(shot.pixel(), GREEN);
    let group = Group { name: "tall".into(), scale: v(1.0, 2.0, 1.0), ..Group::default() };
    shot.scene.groups.push(group);
    let object = &mut shot.scene.objects[0];
    (object.name, object.group) = ("giant".into(), Some("tall".into()));
    assert_eq!(error(&shot), CompileError::OutOfRange { object: "giant".into() });
}

/// Its normals were no numbers, and so was the picture.
#[test]
fn a_flat_model_is_not_stretched_across_itself_beyond_numbers() {
    for (size, is_refused) in [(1e17_f32, false), (1e19, true), (3.4e38, true)] {
        let mut shot = Shot::probe(v(0.3, 2.0, 0.1), v(0.2, 0.0, 0.0));
        let square = shot.model(models::square());
        let object = shot.put(square, flat(GREEN));
        (object.name, object.scale) = ("giant".into(), v(2.0, size, 2.0));
        shot.ambient(1.0);
        if is_refused {
            assert_eq!(error(&shot), CompileError::OutOfRange { object: "giant".into() });
        } else {
            assert_eq!(shot.pixel(), GREEN);
        }
    }
}

#[test]
fn what_is_too_thin_is_refused_by_name() {
    for size in [1e-19_f32, 1e-30, 1e-38, 1e-45] {
        let shapes: [(Shape, Vec3); 6] = [
            (cuboid(v(1.0, size, 1.0)), Vec3::ONE),
            (ball(1.0), v(size.max(1e-38), 1.0, 1.0)),
            (plane(), v(1.0, size.max(1e-38), 1.0)),
            (disc(size), Vec3::ONE),
            (disc(1.0), v(1.0, size.max(1e-38), 1.0)),
            (triangle([Vec3::ZERO, Vec3::X, Vec3::Y]), Vec3::splat(size.max(1e-38))),
        ];
        for (shape, scale) in shapes {
            let mut shot = empty();
            let object = shot.put(shape, matte(RED));
            (object.name, object.scale) = ("film".into(), scale);
            assert_eq!(error(&shot), CompileError::TooThin { object: "film".into() });
        }
    }
}

#[test]
fn no_light_is_black_and_no_object_is_background() {
    let mut shot = Shot::new([20, 20], v(0.0, 0.0, 5.0), Vec3::ZERO);
    shot.scene.settings.background = RED;
    assert!(shot.picture().pixels.iter().all(|p| *p == RED));
    shot.put(ball(100.0), matte(GREEN));
    assert!(shot.picture().pixels.iter().all(|p| *p == Rgb::BLACK));
    let rendered = shot.rendered(1, None);
    assert_eq!((rendered.is_complete(), rendered.rays), (true, 400));
}

#[test]
fn lamps_and_cameras_far_away_do_no_harm() {
    for far in [1e6_f32, 1e12, 1e18, 1e25, 3e38] {
        let mut shot = empty();
        shot.put(ball(1.0), Material { specular: Some(1.0), ..matte(RED) });
        shot.put(plane(), matte(GREEN)).position = v(0.0, -1.0, 0.0);
        shot.point(v(0.3, 0.5, 1.0) * far, 1.0);
        shot.disc(v(0.3, 0.5, 1.0) * far, far, 1.0);
        assert_sane(&shot);
        // However far, a bulb shines like the sun from there.
        let mut one = empty();
        one.scene.lights.clear();
        one.put(ball(1.0), matte(GREEN));
        let mut sun = one.clone();
        one.point(v(0.3, 0.5, 1.0) * far, 1.0);
        sun.sun(v(-0.3, -0.5, -1.0), 1.0);
        let (a, b) = (v(0.0, 0.0, 5.0), Vec3::ZERO);
        assert_near(one.look(a, b), sun.look(a, b), 2e-6);
        shot.scene.camera.position = v(0.0, 1.0, 1.0) * far;
        assert_sane(&shot);
    }
}

#[test]
fn glaring_light_stays_a_number() {
    let mut shot = empty();
    shot.put(ball(1.0), Material { color: Some(Rgb::splat(3e38)), specular: Some(1.0), ..matte(RED) });
    shot.put(plane(), matte(Rgb::new(1e30, 0.0, 1.0))).position = v(0.0, -1.0, 0.0);
    shot.scene.settings.background = Rgb::splat(3e38);
    shot.scene.settings.samples = 3;
    for _ in 0..3 {
        shot.point(v(2.0, 3.0, 4.0), 3e38).color = Rgb::splat(3e38);
        shot.disc(v(-2.0, 3.0, 4.0), 1.0, 3e38);
        shot.ambient(3e38);
    }
    assert_sane(&shot);
}

#[test]
fn textures_far_out_stay_colours() {
    let mut shot = empty();
    let file = "p.png".to_owned();
    let texels = vec![[255, 0, 0], [0, 255, 0]];
    let picture = vitrine_scene::Picture { size: [2, 1], texels };
    shot.assets.pictures.insert(file.clone().into(), std::sync::Arc::new(picture));
    let name = shot.texture(TextureSource::Picture(PictureFile { file, ..PictureFile::default() }));
    shot.put(plane(), Material { texture: Some(name), ..flat(RED) }).position = v(0.0, -1.0, 0.0);
    for (repeat, shift) in
        [([1e30, 1e30], [0.0; 2]), ([3e38, 1e-38], [3e38, -3e38]), ([1.0; 2], [1e20, -1e20])]
    {
        (shot.scene.textures[0].repeat, shot.scene.textures[0].shift) = (repeat, shift);
        assert_sane(&shot);
    }
}
