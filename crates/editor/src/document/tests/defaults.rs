//! New things stand where one looks, on the floor, and can be seen.

use super::*;
use vitrine::scene::{LightSource, ListName, Shape};
use vitrine::templates::TEMPLATES;

fn empty_template() -> Document {
    let template = TEMPLATES.iter().find(|t| t.name == "empty").unwrap();
    document_of(template.text())
}

fn add(document: &mut Document, list: ListName, kind: &str) -> Addition {
    let addition = new_thing(document.scene(), document.assets(), list, kind);
    edit(document, EditCommand::Add(addition.clone()));
    addition
}

#[test]
fn a_new_object_stands_on_the_floor_where_the_camera_looks_a_quarter_of_the_picture_high() {
    for kind in ["sphere", "box", "triangle"] {
        let mut document = empty_template();
        add(&mut document, ListName::Object, kind);
        let bounds = bounds_of(document.scene(), document.assets(), document.selection().things());
        assert_eq!(bounds.min.y, 0.0, "{kind} stands on the floor");
        let camera = &document.scene().camera;
        let seen = camera.rotation().transpose() * (bounds.center().with_y(0.0) - camera.position);
        assert!(seen.x.abs() < 0.01 * -seen.z, "{kind} is in the middle: {seen}");
        let height = 2.0 * -seen.z * (camera.view_angle_deg / 2.0).to_radians().tan();
        let share = bounds.size().y / height;
        assert!((0.15..0.4).contains(&share), "{kind} takes {share} of the picture");
    }
}

#[test]
fn new_objects_do_not_stand_in_one_another_and_differ_in_colour() {
    let mut document = empty_template();
    for _ in 0..8 {
        add(&mut document, ListName::Object, "sphere");
    }
    let scene = document.scene();
    let name = |i: usize| if i == 0 { "sphere".to_owned() } else { format!("sphere {}", i + 1) };
    for a in 0..8 {
        for b in 0..a {
            let box_of = |i: usize| bounds_of(scene, document.assets(), &[Thing::object(name(i))]);
            assert!(bounds::is_apart(&box_of(a), &box_of(b), [0, 1, 2]), "{a} in {b}");
            let color_of = |i: usize| scene.material(&name(i)).and_then(|m| m.color).unwrap();
            assert_ne!(color_of(a), color_of(b));
        }
    }
    let material = scene.material("sphere 3").unwrap();
    assert_eq!((material.diffuse, material.specular, material.shininess), (Some(0.8), Some(0.3), Some(50.0)));
    assert_eq!((material.reflectivity, material.transparency), (Some(0.0), Some(0.0)));
}

#[test]
fn the_first_plane_is_a_floor_and_the_next_a_wall_behind_everything() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Delete(objects(["floor"])));
    add(&mut document, ListName::Object, "plane");
    assert_eq!(object(&document, "plane").turn_deg, Vec3::ZERO);
    add(&mut document, ListName::Object, "plane");
    let wall = document.scene().world_from_object(object(&document, "plane 2"));
    let normal = wall.normal(Vec3::Y);
    assert_near(normal, Vec3::Z);
    let bounds = bounds_of_all(document.scene(), document.assets());
    assert!(wall.point(Vec3::ZERO).z < bounds.min.z);
}

#[test]
fn every_kind_of_light_hangs_above_and_shines_on_the_place() {
    // What needs a file is added with it.
    for kind in LightSource::KINDS.iter().filter(|k| k.specs.iter().all(|s| !s.required)) {
        let mut document = empty_template();
        add(&mut document, ListName::Light, kind.name);
        let light = document.scene().lights.last().unwrap();
        assert_eq!(light.source.kind(), kind.name);
        let owner = Thing::light(&light.name).owner(document.scene()).unwrap();
        if let Some(vitrine::scene::Value::Vector(p)) = document.scene().value(owner, "position") {
            assert!(p.y > 2.0, "{} hangs at {p}", kind.name);
        }
        if let Some(vitrine::scene::Value::Vector(d)) = document.scene().value(owner, "direction") {
            assert!(d.y < 0.0, "{} shines along {d}", kind.name);
        }
    }
}

#[test]
fn sizes_follow_the_view() {
    for scale in [0.01_f32, 100.0] {
        let mut document = empty_template();
        let camera = &mut Arc::make_mut(&mut document.scene).camera;
        camera.position *= scale;
        camera.look_at = camera.look_at.map(|p| p * scale);
        add(&mut document, ListName::Object, "sphere");
        let Shape::Sphere(sphere) = &object(&document, "sphere").shape else { panic!() };
        assert!((0.7 * scale..1.5 * scale).contains(&sphere.radius), "{} at {scale}", sphere.radius);
    }
}

#[test]
fn what_is_no_kind_adds_nothing() {
    let mut document = empty_template();
    let nothing = new_thing(document.scene(), document.assets(), ListName::Object, "teapot");
    assert_eq!(nothing, Addition::default());
    assert_eq!(refused(&mut document, EditCommand::Add(nothing)), EditError::NothingToAdd);
}

#[test]
fn another_name_is_its_materials_too() {
    let mut document = empty_template();
    let ball = new_thing(document.scene(), document.assets(), ListName::Object, "sphere");
    edit(&mut document, EditCommand::Add(ball.named("Шар")));
    assert_eq!(object(&document, "Шар").material.as_deref(), Some("Шар"));
    assert!(document.scene().material("Шар").is_some());
}

#[test]
fn the_camera_turns_about_what_it_looks_at() {
    let mut document = shelf();
    let center = |d: &Document| orbit_center(d.scene(), d.assets());
    assert_eq!(center(&document), Vec3::new(0.0, 0.5, 0.0));
    let camera = |d: &mut Document, position, turn_deg| {
        let camera = &mut Arc::make_mut(&mut d.scene).camera;
        (camera.position, camera.look_at, camera.turn_deg) = (position, None, Some(turn_deg));
    };
    // Onto the floor.
    camera(&mut document, Vec3::new(0.0, 1.0, 3.0), Vec3::new(-45.0, 0.0, 0.0));
    assert_near(center(&document), Vec3::new(0.0, 0.0, 2.0));
    // Level: as far as the things.
    camera(&mut document, Vec3::new(0.0, 1.0, 20.0), Vec3::ZERO);
    let z = center(&document).z;
    assert!((-3.0..3.0).contains(&z), "{z}");
    // Into nothing.
    camera(&mut document, Vec3::new(0.0, 1.0, 20.0), Vec3::new(0.0, 180.0, 0.0));
    assert_near(center(&document), Vec3::new(0.0, 1.0, 25.0));
}

#[test]
fn a_name_that_is_taken_gets_the_next_number() {
    let document = shelf();
    let free = |list, name: &str| free_name(document.scene(), list, name);
    assert_eq!(free(ListName::Object, "cube"), "cube");
    assert_eq!(free(ListName::Object, "ball"), "ball 2");
    assert_eq!(free(ListName::Light, "ball"), "ball", "each list has names of its own");
    let taken = ["glass", "glass 2"];
    assert_eq!(free_name_among(taken.into_iter(), "glass"), "glass 3");
    assert_eq!(free_name_among(taken.into_iter(), "glass 2"), "glass 3");
    assert_eq!(free_name_among(taken.into_iter(), "glass 3"), "glass 3");
}
