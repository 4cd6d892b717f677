//! A scene that has been edited: what is taken over, what is not, and how much memory there may be.

use crate::common::{GREEN, RED, Shot, ball, matte, run, v};
use crate::models;
use vitrine_film::Image;
use vitrine_math::Vec3;
use vitrine_render::{CompileError, CompileOptions, CompiledScene, compile_with};
use vitrine_scene::{Assets, Material, Object, Shape};

/// A model in two places, one of them of glass, and a ball.
fn shot() -> Shot {
    let mut shot = Shot::new([48, 40], v(0.0, 1.0, 6.0), Vec3::ZERO);
    let mut mesh = models::faceted_ball(1.0, 6);
    mesh.normals = mesh.positions.clone();
    let model = shot.model(mesh);
    shot.put(model.clone(), matte(RED)).position = v(-1.2, 0.0, 0.0);
    shot.put(model, Material { transparency: Some(0.6), ..matte(GREEN) }).position = v(1.2, 0.0, 0.0);
    shot.put(ball(0.5), matte(GREEN)).position = v(0.0, 0.5, -1.0);
    shot.point(v(3.0, 5.0, 4.0), 1.0);
    shot
}

fn picture(shot: &Shot, compiled: &CompiledScene) -> Image {
    run(compiled, shot.options(), 2).film.image()
}

#[test]
fn a_scene_compiled_after_a_change_gives_the_picture_of_one_compiled_afresh() {
    let changes: [fn(&mut Vec<Object>); 8] = [
        |objects| objects[0].position = v(-1.0, 0.3, 1.0),
        |objects| objects[1].turn_deg = v(10.0, 50.0, 0.0),
        |objects| objects[1].scale = v(0.5, 1.5, 1.0),
        |objects| objects[0].visible = false,
        |objects| objects[0].visible = true,
        |objects| {
            objects.swap(0, 2);
            objects[0].position.y += 0.5;
        },
        |objects| objects[2].material = objects[1].material.clone(),
        |objects| {
            let Shape::Mesh(mesh) = &mut objects[2].shape else { panic!("a model") };
            mesh.smooth = false;
        },
    ];
    let mut shot = shot();
    let mut compiled = shot.compiled();
    let mut before = picture(&shot, &compiled);
    for (i, change) in changes.into_iter().enumerate() {
        change(&mut shot.scene.objects);
        compiled = compiled.recompile(&shot.scene, &shot.assets).unwrap();
        assert_eq!(compiled.validate(), Ok(()));
        let now = picture(&shot, &compiled);
        assert!(now == picture(&shot, &shot.compiled()), "change {i}");
        assert!(now != before, "change {i} is seen");
        assert_eq!(compiled.memory(), shot.compiled().memory(), "change {i}");
        before = now;
    }
}

#[test]
fn a_model_that_has_changed_is_built_anew() {
    let mut shot = shot();
    let before = shot.compiled();
    let file = shot.assets.meshes.keys().next().unwrap().clone();
    let mut mesh = models::faceted_ball(0.7, 9);
    mesh.normals = mesh.positions.iter().map(|p| p.normalize()).collect();
    shot.assets = Assets { meshes: [(file, mesh.into())].into(), ..Assets::default() };
    let after = before.recompile(&shot.scene, &shot.assets).unwrap();
    assert_eq!(after.triangles(), 2 * 8 * 81);
    assert!(picture(&shot, &after) == picture(&shot, &shot.compiled()));
    assert!(picture(&shot, &after) != picture(&shot, &before));
}

#[test]
fn models_that_would_not_fit_into_memory_are_refused_before_they_are_built() {
    let mut shot = shot();
    let with = |shot: &Shot, memory: u64| {
        compile_with(&shot.scene, &shot.assets, CompileOptions { memory, ..CompileOptions::default() })
    };
    let refused = |shot: &Shot, memory: u64| match with(shot, memory) {
        Err(CompileError::TooMuchMemory { object, triangles, needed, allowed }) => {
            assert!(allowed == memory && needed > allowed);
            (object, triangles, needed)
        }
        other => panic!("{other:?}"),
    };
    let (object, triangles, needed) = refused(&shot, 10_000);
    assert_eq!((object.as_str(), triangles), ("object 0", 288));
    // Two objects with one model need it once.
    assert!(with(&shot, needed).is_ok());
    refused(&shot, needed - 1);

    let second = shot.model(models::faceted_ball(1.0, 20));
    shot.put(second, matte(RED)).name = "heap".into();
    let (object, triangles, both) = refused(&shot, needed);
    assert_eq!((object.as_str(), triangles), ("heap", 3200));
    assert!(both > 10 * needed, "the first counts, too");
    assert!(with(&shot, both).is_ok());

    // What is there already is not refused.
    let earlier = with(&shot, both).unwrap();
    let options = CompileOptions { memory: 0, earlier: Some(&earlier) };
    assert!(compile_with(&shot.scene, &shot.assets, options).is_ok());

    let error = CompileError::TooMuchMemory {
        object: "cave".into(),
        triangles: 90_000_000,
        needed: 9_900_000_000,
        allowed: 500 << 20,
    };
    let message = "the model of the object `cave` is too large: with 90000000 triangles it would bring the scene to 9.2 GiB \
                   of memory, and 500.0 MiB may be taken";
    assert_eq!(error.to_string(), message);
    assert!(error.help().contains("fewer triangles"));
}

#[test]
fn the_memory_that_may_be_taken_is_a_sensible_number() {
    let bytes = vitrine_render::memory_limit();
    assert!((1 << 28..1 << 50).contains(&bytes), "{bytes}");
}
