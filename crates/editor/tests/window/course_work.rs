//! C1 to C17: each row of the course work that a person meets in the window.

use crate::person::{Person, beside};
use eframe::egui::{Key, Modifiers};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::{LightSource, Shape, Value};
use vitrine_editor::document::Thing;
use vitrine_editor::text::Language;

fn in_english() -> Person {
    Person::in_empty_scene(Language::English)
}

/// The object added last.
fn newest(person: &Person) -> vitrine::scene::Object {
    person.scene().objects.last().expect("an object").clone()
}

#[test]
fn c1_a_sphere_comes_from_the_dialog_with_its_centre_and_radius_and_is_seen() {
    let mut person = in_english();
    let before = person.color_at([0.5, 0.5]);
    person.choose(&["Add", "Sphere"]);
    person.type_into("Radius", "0.75");
    person.type_into("Place Y", "0.75");
    person.type_into("Place X", "0");
    person.type_into("Place Z", "0");
    person.click("Add to scene");
    let ball = newest(&person);
    let Shape::Sphere(sphere) = &ball.shape else { panic!("a sphere, not {ball:?}") };
    assert_eq!((sphere.radius, ball.position), (0.75, Vec3::new(0.0, 0.75, 0.0)));
    assert!(person.document().selection().contains(&Thing::object(&*ball.name)));
    assert_ne!(person.color_at([0.5, 0.5]), before, "it is in the picture");
}

#[test]
fn c14_a_thing_is_edited_by_the_list_deleted_and_brought_back() {
    let mut person = in_english();
    person.click("Sphere");
    let name = newest(&person).name;
    person.click("Edit");
    person.type_into("Radius", "0.33");
    person.click("OK");
    let radius = |p: &Person| match newest(p).shape {
        Shape::Sphere(s) => s.radius,
        other => panic!("{other:?}"),
    };
    assert_eq!(radius(&person), 0.33);
    let before = person.scene().objects.len();
    person.click("Delete");
    assert_eq!(person.scene().objects.len(), before - 1);
    assert!(!person.sees(&name), "it is out of the list");
    person.press(Key::Z, Modifiers::COMMAND);
    assert_eq!((person.scene().objects.len(), radius(&person)), (before, 0.33));
    person.press(Key::Z, Modifiers::COMMAND);
    assert_ne!(radius(&person), 0.33, "the edit is undone as one step");
}
