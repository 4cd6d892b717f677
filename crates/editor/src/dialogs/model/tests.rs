//! What is decided in «Model settings».

use super::*;
use crate::document::{EditCommand, Thing};
use std::sync::Arc;
use vitrine::math::Vec3;
use vitrine::scene::{Object, Scene, Shape, TriangleMesh, Value, shapes};

/// A wedge that is 2 wide (x), 1 deep (y) and 4 high (z) in its file, 1 above its zero.
fn mesh() -> Arc<TriangleMesh> {
    let positions =
        [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 1.0, 1.0], [0.0, 0.0, 5.0]].map(Vec3::from_array);
    let triangles = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
    Arc::new(TriangleMesh { positions: positions.to_vec(), triangles, ..TriangleMesh::default() })
}

fn model(scale: f32) -> LoadedModel {
    let mut mesh = TriangleMesh::clone(&mesh());
    mesh.positions.iter_mut().for_each(|p| *p *= scale);
    LoadedModel { path: "models/wedge.obj".into(), mesh: Arc::new(mesh), remarks: Vec::new() }
}

#[test]
fn c5_a_model_is_added_standing_on_the_floor() {
    let scene = Scene {
        objects: vec![Object {
            name: "ground".into(),
            shape: Shape::Plane(shapes::Plane::default()),
            position: Vec3::Y * -0.5,
            ..Object::default()
        }],
        ..Scene::default()
    };
    let mut draft = ModelDraft::add(model(1.0), &scene);
    assert_eq!(draft.name, "wedge");
    draft.up = Up::Z;
    draft.put_down(&scene);
    let size = draft.size();
    assert!((size - Vec3::new(2.0, 4.0, 1.0)).length() < 1e-5, "{size}");
    let [EditCommand::Add(addition)] = &draft.commands(&scene)[..] else { panic!() };
    let object = &addition.objects[0];
    assert_eq!(object.material, None, "it keeps its own materials");
    assert_eq!(object.turn_deg, Vec3::new(-90.0, 0.0, 0.0));
    let lowest =
        draft.model.mesh.positions.iter().map(|p| object.place().point(*p).y).fold(f32::MAX, f32::min);
    assert!((lowest + 0.5).abs() < 1e-5, "{lowest}");
}

#[test]
fn units_and_the_axis_that_is_up_can_be_read_off_an_object_again() {
    let scene = Scene::default();
    for units in Units::ALL {
        for up in Up::ALL {
            let mut draft = ModelDraft::add(model(1.0), &scene);
            (draft.units, draft.up) = (units, up);
            draft.turn_deg = Vec3::new(10.0, 20.0, 0.0);
            let scene = Scene { objects: vec![draft.object()], ..Scene::default() };
            let again = ModelDraft::edit(&Thing::object("wedge"), mesh(), &scene).unwrap();
            assert_eq!(again.units, units);
            // Another turn about X hides which axis was up; what is shown is the same.
            assert_eq!(again.object(), draft.object());
            assert_eq!(again.commands(&scene), [], "{units:?} {up:?}");
        }
    }
}

#[test]
fn huge_numbers_are_taken_for_millimetres() {
    let mut draft = ModelDraft::add(model(100.0), &Scene::default());
    assert_eq!(draft.units, Units::Millimetre);
    assert!((draft.size().max_element() - 0.4).abs() < 1e-5);
}

#[test]
fn c5_settings_of_an_existing_model_say_only_what_was_changed() {
    let scene =
        Scene { objects: vec![ModelDraft::add(model(1.0), &Scene::default()).object()], ..Scene::default() };
    let thing = Thing::object("wedge");
    let mut draft = ModelDraft::edit(&thing, mesh(), &scene).unwrap();
    draft.units = Units::Centimetre;
    draft.smooth = false;
    let set = |key: &str, value| EditCommand::Set { things: vec![thing.clone()], key: key.into(), value };
    let scale = set("scale", Value::Vector(Vec3::splat(0.01)));
    assert_eq!(draft.commands(&scene), [scale, set("smooth", Value::Flag(false))]);
}

#[test]
fn a_thing_that_is_no_model_has_no_model_settings() {
    let scene =
        Scene { objects: vec![Object { name: "ball".into(), ..Object::default() }], ..Scene::default() };
    assert!(ModelDraft::edit(&Thing::object("ball"), mesh(), &scene).is_none());
}
