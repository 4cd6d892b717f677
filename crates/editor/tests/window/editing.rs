//! C14 and what goes with it: moving, turning and scaling, the list, selection, undo, the clipboard, materials.

use crate::course_work::{in_english, must_be_seen, newest, value};
use crate::person::Person;
use eframe::egui::accesskit::Toggled;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, vec2};
use vitrine::math::Vec3;
use vitrine::scene::{Shape, Value};
use vitrine_editor::action::Action;
use vitrine_editor::document::{EditCommand, Thing};

fn radius(person: &Person) -> f32 {
    match newest(person).shape {
        Shape::Sphere(sphere) => sphere.radius,
        other => panic!("{other:?}"),
    }
}

#[test]
fn c14_a_thing_is_edited_by_the_list_deleted_and_brought_back() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let name = newest(&person).name;
    person.click("Edit");
    person.type_into("Radius", "0.33");
    person.click("Apply");
    assert_eq!(radius(&person), 0.33);
    let before = person.scene().objects.len();
    must_be_seen(&mut person, |person| person.click("Delete"));
    assert_eq!(person.scene().objects.len(), before - 1);
    assert!(!person.sees(&format!("Hide {name}")), "it is out of the list");
    person.press(Key::Z, Modifiers::COMMAND);
    assert_eq!((person.scene().objects.len(), radius(&person)), (before, 0.33));
    person.press(Key::Z, Modifiers::COMMAND);
    assert_ne!(radius(&person), 0.33, "the edit is undone as one step");
    person.press(Key::Z, Modifiers::COMMAND | Modifiers::SHIFT);
    assert_eq!(radius(&person), 0.33);
}

#[test]
fn c14_numbers_move_turn_and_scale_an_object_and_a_light() {
    let mut person = in_english();
    person.use_tool("Box");
    must_be_seen(&mut person, |person| person.type_into("Place X", "1.25"));
    must_be_seen(&mut person, |person| person.type_into("Turn Y", "35"));
    must_be_seen(&mut person, |person| person.type_into("Size Y", "2"));
    assert_eq!(newest(&person).scale, Vec3::splat(2.0), "it keeps its proportions");
    person.click("Keep proportions");
    must_be_seen(&mut person, |person| person.type_into("Size Y", "1"));
    let made = newest(&person);
    assert_eq!((made.position.x, made.turn_deg.y, made.scale), (1.25, 35.0, Vec3::new(2.0, 1.0, 2.0)));
    person.select("lamp");
    must_be_seen(&mut person, |person| person.type_into("Place X", "-2"));
    let Value::Vector(place) = value(&person, &Thing::light("lamp"), "position") else { panic!() };
    assert_eq!(place.x, -2.0);
}

#[test]
fn c14_a_thing_is_dragged_along_the_floor_as_one_step() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let (before, steps) = (newest(&person).position, person.document().history().undoable());
    // Beside the arrows.
    let at = person.place_of("Sphere") + vec2(-28.0, 28.0);
    must_be_seen(&mut person, |person| person.drag(at, at + vec2(-60.0, 20.0)));
    let after = newest(&person).position;
    assert!(after.x < before.x && after.z > before.z && after.y == before.y, "{before} {after}");
    assert_eq!(person.document().history().undoable(), steps + 1);
    let text = person.control("Place X").value().unwrap_or_default();
    assert_ne!(text, "0 m", "the numbers in the panel follow");
}

#[test]
fn c14_rings_turn_and_boxes_scale_in_the_picture() {
    let mut person = in_english();
    person.use_tool("Box");
    let pivot = person.place_of("Box");
    person.press(Key::R, Modifiers::NONE);
    let mut hit = None;
    // The box in the middle lies somewhere near the middle of what is seen.
    for offset in [[0.0, 0.0], [0.0, 8.0], [0.0, -8.0], [8.0, 0.0], [-8.0, 0.0], [8.0, 8.0], [8.0, -8.0]] {
        let at = pivot + vec2(offset[0], offset[1]);
        person.drag(at, at + vec2(50.0, 0.0));
        if newest(&person).scale.x > 1.2 {
            hit = Some(at);
            break;
        }
        while newest(&person).position != person.scene().objects[1].position {
            person.press(Key::Z, Modifiers::COMMAND);
        }
    }
    let at = hit.expect("a box to drag in the middle");
    let scale = newest(&person).scale;
    assert!((scale.x - scale.y).abs() < 1e-5 && (scale.x - scale.z).abs() < 1e-5, "{scale}");
    person.press(Key::Z, Modifiers::COMMAND);
    person.press(Key::E, Modifiers::NONE);
    let ring = at + vec2(84.0, 0.0);
    person.drag(ring, ring + vec2(-6.0, -60.0));
    assert_ne!(newest(&person).turn_deg, Vec3::ZERO, "the ring turns it");
}

#[test]
fn the_selection_in_the_picture_and_in_the_list_is_the_same() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.select("ground");
    assert!(person.document().selection().contains(&Thing::object("ground")));
    let at = person.place_of("Sphere");
    person.click_at(at);
    assert_eq!(person.document().selection().things(), [Thing::object("Sphere")]);
    let selected = |person: &Person, name: &str| {
        use egui_kittest::kittest::NodeT as _;
        person.row(name).accesskit_node().toggled() == Some(Toggled::True)
    };
    assert_eq!([selected(&person, "Sphere"), selected(&person, "ground")], [true, false]);
    assert!(person.sees("Radius"), "its properties are shown");
    person.press(Key::Escape, Modifiers::NONE);
    assert!(person.document().selection().is_empty());
}

#[test]
fn things_are_hidden_renamed_and_duplicated() {
    let mut person = in_english();
    person.use_tool("Sphere");
    must_be_seen(&mut person, |person| person.click("Hide Sphere"));
    assert!(!newest(&person).visible);
    must_be_seen(&mut person, |person| person.click("Show Sphere"));
    person.press(Key::F2, Modifiers::NONE);
    person.enter("New name of Sphere", "Globe");
    person.press(Key::Enter, Modifiers::NONE);
    assert_eq!(newest(&person).name, "Globe");
    assert!(person.document().selection().contains(&Thing::object("Globe")));
    must_be_seen(&mut person, |person| person.press(Key::D, Modifiers::COMMAND));
    assert_eq!(person.scene().objects.len(), 3);
    assert_ne!(newest(&person).name, "Globe");
}

#[test]
fn several_are_selected_changed_together_and_grouped() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.use_tool("Box");
    person.select("Sphere");
    person.select_with("Box", Modifiers::COMMAND);
    assert_eq!(person.document().selection().things().len(), 2);
    assert!(person.sees("Made of"), "what they have in common is shown");
    let before: Vec<_> = person.scene().objects.iter().map(|o| o.position).collect();
    let x = before[2].x + 1.0;
    person.type_into("Place X", &x.to_string());
    let moved: Vec<_> = person.scene().objects.iter().zip(&before).map(|(o, b)| o.position.x - b.x).collect();
    assert!(moved[0] == 0.0 && (moved[1] - 1.0).abs() < 1e-3 && (moved[2] - 1.0).abs() < 1e-3, "{moved:?}");
    person.select("Sphere");
    person.select_with("Box", Modifiers::COMMAND);
    person.press(Key::G, Modifiers::COMMAND);
    let group = person.scene().groups.first().expect("a group").name.clone();
    assert!(person.scene().objects[1..].iter().all(|o| o.group.as_ref() == Some(&group)));
    must_be_seen(&mut person, |person| person.click(&format!("Hide {group}")));
    person.click(&format!("Show {group}"));
    person.select(&group);
    person.press(Key::G, Modifiers::COMMAND | Modifiers::SHIFT);
    assert!(person.scene().groups.is_empty());
}

#[test]
fn two_hundred_steps_and_more_are_undone_and_done_again() {
    let mut person = in_english();
    let start = person.scene().clone();
    for i in 1..=220 {
        let value = Value::Number(i as f32 / 1000.0);
        let set = EditCommand::Set { things: vec![Thing::light("lamp")], key: "intensity".into(), value };
        person.window.state_mut().ask(Action::Edit(set));
    }
    person.wait();
    let end = person.scene().clone();
    person.press(Key::Z, Modifiers::COMMAND);
    (0..218).for_each(|_| person.window.state_mut().ask(Action::Undo));
    person.wait();
    person.choose(&["Edit", "Undo"]);
    assert_eq!(*person.scene(), start);
    (0..219).for_each(|_| person.window.state_mut().ask(Action::Redo));
    person.wait();
    person.use_tool("Redo");
    assert_eq!(*person.scene(), end);
}

/// What the last frame wrote into the clipboard.
fn copied(person: &Person) -> String {
    let commands = &person.window.output().platform_output.commands;
    let text =
        |c: &OutputCommand| if let OutputCommand::CopyText(text) = c { Some(text.clone()) } else { None };
    commands.iter().find_map(text).expect("something was copied")
}

#[test]
fn the_clipboard_copies_cuts_and_pastes_the_text_of_a_scene() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.window.event(Event::Copy);
    person.window.step();
    let text = copied(&person);
    assert!(text.contains("[[object]]") && text.contains("sphere"), "{text}");
    person.window.event(Event::Cut);
    person.window.step();
    assert_eq!(copied(&person), text);
    person.wait();
    assert_eq!(person.scene().objects.len(), 1);
    for count in 2..=3 {
        must_be_seen(&mut person, |person| {
            person.window.event(Event::Paste(text.clone()));
            person.wait();
        });
        assert_eq!(person.scene().objects.len(), count);
    }
    person.window.event(Event::Paste("this is no scene".into()));
    person.wait();
    assert_eq!(person.scene().objects.len(), 3, "nonsense is refused");
}

#[test]
fn a_material_of_the_strip_is_clicked_or_dragged_onto_a_thing() {
    let mut person = in_english();
    person.use_tool("Sphere");
    must_be_seen(&mut person, |person| person.click("Red glass"));
    let first = newest(&person).material.unwrap();
    assert!(person.scene().material(&first).unwrap().transparency.unwrap_or(0.0) > 0.0);
    person.select("ground");
    let (from, to) = (person.control("Blue glass").rect().center(), person.place_of("Sphere"));
    must_be_seen(&mut person, |person| person.drag(from, to));
    assert_ne!(newest(&person).material.unwrap(), first);
    assert_eq!(person.scene().objects[0].material.as_deref(), Some("floor"));
}

#[test]
fn nonsense_in_a_field_for_a_number_keeps_the_old_value_and_says_why() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let before = radius(&person);
    for (nonsense, why) in [("wide", "is not a number"), ("-2", "Must be more than 0")] {
        person.enter("Radius", nonsense);
        person.press(Key::Enter, Modifiers::NONE);
        assert_eq!(radius(&person), before);
        assert!(person.reads(why), "{nonsense}: {:?}", person.names());
    }
    person.type_into("Radius", "0.5");
    assert_eq!(radius(&person), 0.5);
    assert!(!person.reads("Must be more"));
}

#[test]
fn keys_do_what_the_list_of_keys_says() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.press(Key::F1, Modifiers::NONE);
    assert!(person.reads("Ctrl+Shift+S"), "{:?}", person.names());
    person.press(Key::Delete, Modifiers::NONE);
    assert_eq!(person.scene().objects.len(), 2, "keys belong to the dialog");
    person.press(Key::Escape, Modifiers::NONE);
    person.press(Key::H, Modifiers::NONE);
    assert!(!newest(&person).visible);
    person.press(Key::H, Modifiers::NONE);
    must_be_seen(&mut person, |person| person.press(Key::F, Modifiers::NONE));
    person.press(Key::Home, Modifiers::NONE);
    person.press(Key::A, Modifiers::COMMAND);
    assert_eq!(person.document().selection().things().len(), 4);
    person.select("Sphere");
    person.type_into("Place Y", "3");
    person.press(Key::Escape, Modifiers::NONE);
    person.press(Key::End, Modifiers::NONE);
    assert!(newest(&person).position.y < 1.5, "it has dropped to the floor");
    person.press(Key::Delete, Modifiers::NONE);
    assert_eq!(person.scene().objects.len(), 1);
}
