//! Values, names, kinds, adding, deleting, duplicating, painting.

use crate::document::tests::{edit, object, objects, point, refused, shelf};
use crate::document::{Addition, EditCommand, EditError, Message, Paint, Selection, Thing, allowed};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::{Cause, ListName, Material, Object, ParamKind, Range, Texture, Value};

fn set(things: Vec<Thing>, key: &str, value: Value) -> EditCommand {
    EditCommand::Set { things, key: key.into(), value }
}

fn names(document: &crate::document::Document, list: ListName) -> Vec<&str> {
    document.scene().names(list).collect()
}

#[test]
fn c14_values_of_objects_lights_camera_and_settings_are_set() {
    let mut document = shelf();
    let value = |d: &crate::document::Document, thing: &Thing, key: &str| {
        d.scene().value(thing.owner(d.scene()).unwrap(), key).unwrap()
    };
    for (thing, key, new) in [
        (Thing::object("ball"), "radius", Value::Number(2.0)),
        (Thing::object("box"), "size", Value::Vector(Vec3::new(1.0, 2.0, 3.0))),
        (Thing::light("lamp"), "intensity", Value::Number(0.4)),
        (Thing::light("sun"), "direction", Value::Vector(Vec3::NEG_ONE)),
        (Thing::material("glass"), "refraction", Value::Number(1.5)),
        (Thing::group("shelf"), "scale", Value::Vector(Vec3::ONE)),
        (Thing::Camera, "view_angle_deg", Value::Number(30.0)),
        (Thing::Settings, "depth", Value::Integer(7)),
    ] {
        edit(&mut document, set(vec![thing.clone()], key, new.clone()));
        assert_eq!(value(&document, &thing, key), new, "{thing:?}");
    }
}

#[test]
fn of_several_things_those_that_have_the_key_are_set() {
    let mut document = shelf();
    let things = vec![Thing::object("box"), Thing::object("ball"), Thing::light("lamp")];
    edit(&mut document, set(things, "radius", Value::Number(0.25)));
    let count = document.text().matches("radius = 0.25").count();
    assert_eq!(count, 2);
}

#[test]
fn a_value_that_does_not_fit_is_refused_with_what_is_allowed() {
    let mut document = shelf();
    let error = refused(&mut document, set(objects(["ball"]), "radius", Value::Number(-1.0)));
    assert_eq!(error.message(), Message::new("allowed-more-than").with("min", &0.0));
    let glass = || vec![Thing::material("glass")];
    let error = refused(&mut document, set(glass(), "transparency", Value::Number(2.0)));
    assert_eq!(error.message(), Message::new("allowed-from-to").with("min", &0.0).with("max", &1.0));
    let error = refused(&mut document, set(vec![Thing::Settings], "depth", Value::Integer(33)));
    assert_eq!(error.message(), Message::new("allowed-integer").with("min", &0).with("max", &32));
    let error = refused(&mut document, set(glass(), "radius", Value::Number(1.0)));
    assert_eq!(error.message().key, "edit-no-parameter");
    let error = refused(&mut document, set(objects(["nobody"]), "radius", Value::Number(1.0)));
    assert_eq!(error, EditError::NoThing);
    // One of several: then none.
    let two = || objects(["ball", "box"]);
    refused(&mut document, set(two(), "scale", Value::Vector(Vec3::ZERO)));
    let half_open = Range { min: 1.0, max: 2.0, above_min: true };
    assert_eq!(allowed(ParamKind::Number(half_open)).key, "allowed-more-than-to");
}

#[test]
fn what_would_make_the_scene_meaningless_is_refused() {
    let mut document = shelf();
    let error = refused(&mut document, set(objects(["ball"]), "material", Value::Text("glas".into())));
    assert!(matches!(error, EditError::Scene(Cause::MissingReference { .. })), "{error}");
    let error =
        refused(&mut document, set(vec![Thing::group("shelf")], "group", Value::Text("shelf".into())));
    assert_eq!(error.message().key, "problem-group-cycle");
    let flat = Value::Points(vec![Vec3::ZERO, Vec3::X, Vec3::X * 2.0]);
    let error = refused(&mut document, set(objects(["pane"]), "points", flat));
    assert_eq!(error.message().key, "problem-flat-triangle");
    let error = refused(&mut document, set(vec![Thing::Settings], "size", Value::Size([32_768, 32_768])));
    assert_eq!(error.message().key, "problem-picture-too-large");
    let at = document.scene().camera.position;
    let error = refused(&mut document, set(vec![Thing::Camera], "look_at", Value::Vector(at)));
    assert_eq!(error.message().key, "problem-look-at");
}

#[test]
fn another_kind_keeps_what_both_have() {
    let mut document = shelf();
    let kind = |thing: Thing, kind: &str| EditCommand::SetKind { thing, kind: kind.into() };
    edit(&mut document, kind(Thing::light("lamp"), "point"));
    let lamp = Thing::light("lamp").owner(document.scene()).unwrap();
    assert_eq!(document.scene().value(lamp, "position"), Some(Value::Vector(Vec3::new(2.0, 5.0, 3.0))));
    assert_eq!(document.scene().value(lamp, "radius"), None);
    edit(&mut document, kind(Thing::object("ball"), "box"));
    assert_eq!(object(&document, "ball").material.as_deref(), Some("tiled"));
    document.apply(kind(Thing::object("ball"), "box")).unwrap();
    assert_eq!(document.history().undoable(), 2, "it is one already");
    let error = refused(&mut document, kind(Thing::object("ball"), "teapot"));
    assert_eq!(error, EditError::NoKind { word: "teapot".into() });
    assert_eq!(refused(&mut document, kind(Thing::Camera, "box")), EditError::NotPossible);
}

#[test]
fn references_and_the_selection_follow_a_new_name() {
    let mut document = shelf();
    let rename = |thing: Thing, name: &str| EditCommand::Rename { thing, name: name.into() };
    edit(&mut document, rename(Thing::material("tiled"), "chess"));
    edit(&mut document, rename(Thing::texture("tiles"), "squares"));
    edit(&mut document, rename(Thing::group("shelf"), "case"));
    edit(&mut document, rename(Thing::object("ball"), "globe "));
    let globe = object(&document, "globe");
    assert_eq!((globe.material.as_deref(), globe.group.as_deref()), (Some("chess"), Some("case")));
    assert_eq!(document.scene().material("chess").unwrap().texture.as_deref(), Some("squares"));
    assert_eq!(document.selection().things(), objects(["globe"]));
    let ball = || Thing::object("globe");
    assert_eq!(refused(&mut document, rename(ball(), " ")), EditError::EmptyName);
    assert_eq!(refused(&mut document, rename(ball(), "box")), EditError::NameTaken { name: "box".into() });
    assert_eq!(refused(&mut document, rename(Thing::Camera, "eye")), EditError::NotPossible);
    document.apply(rename(ball(), "globe")).unwrap();
}

#[test]
fn c14_deleting_leaves_no_reference_behind_and_takes_members_along() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Delete(vec![Thing::material("tiled")]));
    assert_eq!(object(&document, "ball").material, None);
    edit(&mut document, EditCommand::Delete(vec![Thing::light("lamp"), Thing::object("pane")]));
    assert_eq!(names(&document, ListName::Light), ["sun", "air"]);
    edit(&mut document, EditCommand::Group(vec![Thing::group("shelf")]));
    edit(&mut document, EditCommand::Delete(vec![Thing::group("group")]));
    assert_eq!(names(&document, ListName::Object), ["floor"]);
    assert_eq!(names(&document, ListName::Group), [""; 0]);
    assert_eq!(document.selection(), &Selection::default());
    assert_eq!(refused(&mut document, EditCommand::Delete(vec![Thing::Camera])), EditError::NotPossible);
    // A texture that nobody uses any more stays: it may be wanted again.
    assert_eq!(names(&document, ListName::Texture), ["tiles"]);
    edit(&mut document, EditCommand::Delete(vec![Thing::texture("tiles")]));
}

#[test]
fn a_copy_stands_beside_and_has_the_next_name() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Duplicate(objects(["ball"])));
    edit(&mut document, EditCommand::Duplicate(objects(["ball"])));
    assert_eq!(document.selection().things(), objects(["ball 3"]));
    let [first, second, third] = ["ball", "ball 2", "ball 3"].map(|name| point(&document, name, Vec3::ZERO));
    // The shelf makes it twice as large: 2 m across.
    for (a, b) in [(first, second), (second, third)] {
        assert!((b - a).x >= 2.0 && (b - a).x < 2.5, "{a} and {b}");
        assert!((b - a).with_x(0.0).length() < 1e-5);
    }
    assert_eq!(object(&document, "ball 2").group.as_deref(), Some("shelf"));
}

#[test]
fn a_copied_group_has_copies_of_its_members() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Duplicate(vec![Thing::group("shelf"), Thing::object("ball")]));
    assert_eq!(document.selection().things(), [Thing::group("shelf 2")]);
    assert_eq!(object(&document, "ball 2").group.as_deref(), Some("shelf 2"));
    assert_eq!(object(&document, "ball").group.as_deref(), Some("shelf"));
    assert_eq!(names(&document, ListName::Object).len(), 6);
}

#[test]
fn materials_textures_and_lights_are_copied_too() {
    let mut document = shelf();
    let things = vec![Thing::material("glass"), Thing::texture("tiles"), Thing::light("air")];
    edit(&mut document, EditCommand::Duplicate(things));
    assert_eq!(names(&document, ListName::Material), ["tiled", "glass", "glass 2"]);
    assert_eq!(names(&document, ListName::Texture), ["tiles", "tiles 2"]);
    assert_eq!(names(&document, ListName::Light).last(), Some(&"air 2"));
    assert_eq!(refused(&mut document, EditCommand::Duplicate(vec![Thing::Camera])), EditError::NotPossible);
}

#[test]
fn what_is_added_is_selected_under_a_free_name() {
    let mut document = shelf();
    let ball = Object { name: "ball".into(), material: Some("glass".into()), ..Object::default() };
    let glass = Material { name: "glass".into(), color: Some(Rgb::WHITE), ..Material::default() };
    let addition = Addition { objects: vec![ball], materials: vec![glass], ..Addition::default() };
    edit(&mut document, EditCommand::Add(addition));
    assert_eq!(document.selection().things(), objects(["ball 2"]));
    assert_eq!(object(&document, "ball 2").material.as_deref(), Some("glass 2"), "another glass");
    let empty = Addition {
        objects: vec![Object { name: String::new(), ..Object::default() }],
        ..Addition::default()
    };
    let error = refused(&mut document, EditCommand::Add(empty));
    assert_eq!(error, EditError::Scene(Cause::EmptyName));
}

#[test]
fn painting_adds_the_material_once() {
    let mut document = shelf();
    let paint = |color: Rgb| {
        let texture = Texture { name: "tiles".into(), repeat: [3.0, 3.0], ..Texture::default() };
        let texture_name = Some(texture.name.clone());
        let material = Material {
            name: "glass".into(),
            color: Some(color),
            texture: texture_name,
            ..Material::default()
        };
        Box::new(Paint { material, texture: Some(texture) })
    };
    let red = Rgb::new(1.0, 0.0, 0.0);
    edit(&mut document, EditCommand::Paint { things: objects(["ball"]), material: paint(red) });
    edit(&mut document, EditCommand::Paint { things: vec![Thing::group("shelf")], material: paint(red) });
    edit(&mut document, EditCommand::Paint { things: objects(["pane"]), material: paint(Rgb::WHITE) });
    assert_eq!(names(&document, ListName::Material), ["tiled", "glass", "glass 2", "glass 3"]);
    assert_eq!(names(&document, ListName::Texture), ["tiles", "tiles 2"]);
    assert_eq!(document.scene().material("glass 3").unwrap().texture.as_deref(), Some("tiles 2"));
    let of = |name| object(&document, name).material.clone().unwrap();
    assert_eq!([of("ball"), of("box"), of("pane")], ["glass 2", "glass 2", "glass 3"]);
    assert_eq!(document.selection().things(), objects(["ball"]), "painting selects nothing");
    let lamp = vec![Thing::light("lamp")];
    let error = refused(&mut document, EditCommand::Paint { things: lamp, material: paint(red) });
    assert_eq!(error, EditError::NotPossible);
}

#[test]
fn showing_and_hiding() {
    let mut document = shelf();
    let all = || vec![Thing::object("ball"), Thing::light("lamp"), Thing::group("shelf"), Thing::Camera];
    edit(&mut document, EditCommand::Show { things: all(), visible: false });
    assert!(!object(&document, "ball").visible && !document.scene().lights[0].visible);
    edit(&mut document, EditCommand::Show { things: all(), visible: true });
    let camera = EditCommand::Show { things: vec![Thing::Camera], visible: false };
    assert_eq!(refused(&mut document, camera), EditError::NotPossible);
}

#[test]
fn several_edits_are_one_step_or_none() {
    let mut document = shelf();
    let radius = |r: f32| set(objects(["ball"]), "radius", Value::Number(r));
    edit(&mut document, EditCommand::Several(vec![radius(3.0), EditCommand::SetAbout("new".into())]));
    assert_eq!(document.history().undoable(), 1);
    refused(&mut document, EditCommand::Several(vec![radius(4.0), radius(-4.0)]));
}
