//! What is decided in «Add» and «Edit».

use super::*;
use crate::document::{Addition, EditCommand, Thing};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::{Light, LightSource, ListName, Material, Object, Scene, Shape, Value, lights, shapes};

fn scene() -> Scene {
    Scene {
        materials: vec![Material { name: "glass".into(), transparency: Some(0.9), ..Material::default() }],
        objects: vec![
            Object { name: "ball".into(), material: Some("glass".into()), ..Object::default() },
            Object { name: "bowl".into(), material: Some("glass".into()), ..Object::default() },
            Object { name: "bare".into(), ..Object::default() },
        ],
        lights: vec![Light { name: "bulb".into(), ..Light::default() }],
        ..Scene::default()
    }
}

fn set(thing: Thing, key: &str, value: Value) -> EditCommand {
    EditCommand::Set { things: vec![thing], key: key.into(), value }
}

#[test]
fn c6_a_new_thing_brings_its_new_material_under_a_free_name() {
    let scene = scene();
    let object = Object { name: "glass".into(), ..Object::default() };
    let addition = Addition { objects: vec![object], ..Addition::default() };
    let mut draft = ThingDraft::add(&addition, &scene).unwrap();
    let material = draft.material.as_mut().unwrap();
    material.choose(MaterialChoice::New, &scene);
    assert!(material.set("color", Value::Color(Rgb::new(1.0, 0.0, 0.0))));
    assert!(!material.set("reflectivity", Value::Number(2.0)), "out of range");
    let [EditCommand::Add(addition)] = &draft.commands(&scene)[..] else { panic!() };
    assert_eq!(addition.objects[0].material.as_deref(), Some("glass 2"));
    assert_eq!(addition.materials[0].name, "glass 2");
    assert_eq!(addition.materials[0].color, Some(Rgb::new(1.0, 0.0, 0.0)));
    assert_eq!(addition.materials[0].reflectivity, Some(0.0));
}

#[test]
fn c7_a_picture_comes_along_as_a_texture() {
    let scene = scene();
    let addition = Addition { objects: vec![Object::default()], ..Addition::default() };
    let mut draft = ThingDraft::add(&addition, &scene).unwrap();
    let material = draft.material.as_mut().unwrap();
    material.choose(MaterialChoice::New, &scene);
    material.set_picture("textures/globe.png", &scene);
    let [EditCommand::Add(addition)] = &draft.commands(&scene)[..] else { panic!() };
    assert_eq!(addition.materials[0].texture.as_deref(), Some("globe"));
    let file = addition.textures[0].source.as_kind().file();
    assert_eq!(file, Some(std::path::Path::new("textures/globe.png")));
}

#[test]
fn c14_edit_says_only_what_was_changed_and_renames_last() {
    let scene = scene();
    let ball = Thing::object("ball");
    let mut draft = ThingDraft::edit(&ball, &scene).unwrap();
    assert_eq!(draft.commands(&scene), [], "nothing changed, nothing to do");
    assert!(draft.subject.set("radius", Value::Number(2.0)));
    assert!(draft.subject.set("position", Value::Vector(Vec3::Y)));
    assert!(!draft.subject.set("radius", Value::Number(-1.0)));
    *draft.subject.name_mut() = " globe ".into();
    let rename = EditCommand::Rename { thing: ball.clone(), name: "globe".into() };
    let place = set(ball.clone(), "position", Value::Vector(Vec3::Y));
    let radius = set(ball, "radius", Value::Number(2.0));
    assert_eq!(draft.commands(&scene), [place, radius, rename]);
}

#[test]
fn a_shared_material_is_changed_where_it_stands_and_the_others_are_counted() {
    let scene = scene();
    let mut draft = ThingDraft::edit(&Thing::object("ball"), &scene).unwrap();
    let material = draft.material.as_mut().unwrap();
    assert_eq!(material.others(&scene, Some("ball")), 1);
    material.set("transparency", Value::Number(0.5));
    let wanted = set(Thing::material("glass"), "transparency", Value::Number(0.5));
    assert_eq!(draft.commands(&scene), [wanted]);
}

#[test]
fn a_material_can_be_chosen_taken_away_and_made_anew() {
    let scene = scene();
    let commands = |name: &str, choice: MaterialChoice| {
        let mut draft = ThingDraft::edit(&Thing::object(name), &scene).unwrap();
        draft.material.as_mut().unwrap().choose(choice, &scene);
        draft.commands(&scene)
    };
    let named = commands("bare", MaterialChoice::Named("glass".into()));
    assert_eq!(named, [set(Thing::object("bare"), "material", Value::Text("glass".into()))]);
    let none = commands("ball", MaterialChoice::Unstated);
    assert_eq!(none, [set(Thing::object("ball"), "material", Value::Nothing)]);
    let anew = commands("ball", MaterialChoice::New);
    let [EditCommand::Paint { things, material }] = &anew[..] else { panic!("{anew:?}") };
    assert_eq!(things[..], [Thing::object("ball")]);
    assert_eq!(material.material.transparency, Some(0.9), "it begins like the one before");
    assert_eq!(material.material.name, "ball");
}

#[test]
fn names_must_be_there_and_free() {
    let scene = scene();
    let flaw = |name: &str| {
        let mut draft = ThingDraft::edit(&Thing::object("ball"), &scene).unwrap();
        name.clone_into(draft.subject.name_mut());
        draft.flaw(&scene)
    };
    assert_eq!(flaw("  "), Some(Flaw::NoName));
    assert_eq!(flaw("bare"), Some(Flaw::NameTaken));
    assert_eq!(flaw("ball"), None);
    assert_eq!(flaw("bulb"), None, "a light may have the name of an object");
}

#[test]
fn every_kind_shows_where_it_is_and_what_it_takes_before_it_is_added() {
    let object = |shape| Subject::Object(Box::new(Object { shape, ..Object::default() }));
    let light = |source| Subject::Light(Box::new(Light { source, ..Light::default() }));
    let keys = |subject: Subject| subject.fields(true).iter().map(|s| s.name).collect::<Vec<_>>();
    assert_eq!(keys(object(Shape::Sphere(shapes::Sphere::default()))), ["position", "radius"]);
    assert_eq!(keys(object(Shape::Box(shapes::Cuboid::default()))), ["position", "size", "turn_deg"]);
    assert_eq!(keys(object(Shape::Plane(shapes::Plane::default()))), ["position", "turn_deg"]);
    assert_eq!(keys(object(Shape::Triangle(shapes::Triangle::default()))), ["points"]);
    assert_eq!(keys(light(LightSource::Ambient(lights::Ambient::default()))), ["intensity", "color"]);
    let disc = keys(light(LightSource::Disc(lights::Disc::default())));
    assert_eq!(disc, ["position", "radius", "intensity", "color"]);
}

#[test]
fn the_preview_shows_the_thing_in_the_scene_without_changing_it() {
    let scene = scene();
    let addition = Addition {
        objects: vec![Object { name: "ball".into(), ..Object::default() }],
        ..Addition::default()
    };
    let mut draft = ThingDraft::add(&addition, &scene).unwrap();
    draft.material.as_mut().unwrap().choose(MaterialChoice::New, &scene);
    let shown = draft.shown_in(&scene);
    assert_eq!(shown.objects.len(), 4);
    assert!(shown.problems().iter().all(|p| p.severity != vitrine::scene::Severity::Error));
    let mut edit = ThingDraft::edit(&Thing::object("ball"), &scene).unwrap();
    edit.subject.set("position", Value::Vector(Vec3::Y));
    let shown = edit.shown_in(&scene);
    assert_eq!(shown.names(ListName::Object).collect::<Vec<_>>(), ["ball", "bowl", "bare"]);
    assert_eq!(shown.object("ball").unwrap().position, Vec3::Y);
}
