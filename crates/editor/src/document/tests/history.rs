//! Undoing and redoing, gestures, and what the history costs.

use super::*;
use vitrine::scene::Value;

fn radius(r: f32) -> EditCommand {
    EditCommand::Set { things: objects(["ball"]), key: "radius".into(), value: Value::Number(r) }
}

#[test]
fn two_hundred_and_fifty_steps_can_be_undone_and_redone() {
    let mut document = shelf();
    let first = document.scene().clone();
    for i in 1..=250 {
        document.apply(radius(i as f32)).unwrap();
    }
    let last = document.scene().clone();
    for _ in 0..250 {
        assert!(document.undo());
    }
    assert_eq!(*document.scene(), first);
    assert!(!document.undo());
    for _ in 0..250 {
        assert!(document.redo());
    }
    assert_eq!(*document.scene(), last);
    assert!(!document.redo());
}

#[test]
fn a_drag_is_one_step_and_the_next_drag_another() {
    let mut document = shelf();
    let first = document.scene().clone();
    for gesture in [1, 2] {
        for i in 1..=20 {
            document.drag(radius(i as f32 + 30.0 * gesture as f32), gesture).unwrap();
        }
    }
    assert_eq!(document.history().undoable(), 2);
    document.undo();
    assert_eq!(
        document.scene().value(Thing::object("ball").owner(document.scene()).unwrap(), "radius"),
        Some(Value::Number(50.0))
    );
    document.undo();
    assert_eq!(*document.scene(), first);
    document.redo();
    document.redo();
    assert_eq!(
        document.scene().value(Thing::object("ball").owner(document.scene()).unwrap(), "radius"),
        Some(Value::Number(80.0))
    );
}

#[test]
fn a_drag_that_comes_back_to_where_it_began_is_no_step() {
    let mut document = shelf();
    for r in [2.0, 3.0, 0.5] {
        document.drag(radius(r), 1).unwrap();
    }
    assert_eq!((document.history().undoable(), document.history().entries()), (0, 0));
    assert!(!document.undo() && !document.is_changed());
}

#[test]
fn steps_share_what_is_selected() {
    let mut document = shelf();
    document.apply(radius(2.0)).unwrap();
    let first = document.selection().things().as_ptr();
    document.apply(radius(3.0)).unwrap();
    document.undo();
    assert_eq!(document.selection().things().as_ptr(), first, "one list for all steps");
}

#[test]
fn a_drag_after_undoing_does_not_grow_a_step_that_is_undone() {
    let mut document = shelf();
    document.drag(radius(2.0), 7).unwrap();
    document.undo();
    document.drag(radius(3.0), 7).unwrap();
    assert_eq!((document.history().undoable(), document.history().redoable()), (1, 0));
}

#[test]
fn what_was_undone_is_forgotten_with_the_next_edit() {
    let mut document = shelf();
    document.apply(radius(2.0)).unwrap();
    document.apply(radius(3.0)).unwrap();
    document.undo();
    document.apply(radius(4.0)).unwrap();
    assert!(!document.redo());
    assert_eq!(document.history().undoable(), 2);
}

#[test]
fn an_edit_that_changes_nothing_is_no_step() {
    let mut document = shelf();
    document.apply(radius(0.5)).unwrap();
    assert_eq!((document.history().undoable(), document.revision(), document.is_changed()), (0, 0, false));
}

fn many(count: usize) -> Document {
    let name =
        |i: usize| format!("[[object]]\nname = \"o{i}\"\nshape = \"sphere\"\nposition = [{i}.0, 0.0, 0.0]\n");
    let objects: String = (0..count).map(name).collect();
    document_of(&format!("format = 1\n{objects}"))
}

#[test]
fn a_thousand_steps_in_a_scene_of_ten_thousand_objects_keep_only_what_changed() {
    let mut document = many(10_000);
    let mut scene = Scene::clone(document.scene());
    let mut history = History::default();
    for i in 0..1000 {
        // Both ends of the list at once: what lies between them is not kept.
        let before = scene.clone();
        scene.objects[i].position.y += 1.0;
        scene.objects[9_999 - i].position.y += 1.0;
        let selection = Selection::default();
        history.note([&before, &scene], [selection.clone(), selection], None);
    }
    assert_eq!(history.undoable(), 1000);
    assert_eq!(history.entries(), 4 * 1000);
    // The whole document makes an edit there, too.
    let value = Value::Number(2.0);
    let things = vec![Thing::object("o1"), Thing::object("o9998")];
    document.apply(EditCommand::Set { things, key: "radius".into(), value }).unwrap();
    assert_eq!(document.history().entries(), 4);
}

#[test]
fn the_oldest_steps_are_forgotten_and_never_too_many() {
    let mut history = History::default();
    let mut scene = Scene::default();
    let none = Selection::default;
    for i in 0..History::MOST + 5 {
        let before = scene.clone();
        scene.about = i.to_string();
        history.note([&before, &scene], [none(), none()], None);
    }
    assert_eq!(history.undoable(), History::MOST);
    while history.undo(&mut scene).is_some() {}
    assert_eq!(scene.about, "4");

    // Steps that change everything: fewer are kept, and never less than what was promised.
    let mut history = History::default();
    let mut scene = Scene::clone(many(3000).scene());
    for _ in 0..History::LEAST + 20 {
        let before = scene.clone();
        scene.objects.iter_mut().for_each(|o| o.position.y += 1.0);
        history.note([&before, &scene], [none(), none()], None);
    }
    assert_eq!(history.undoable(), History::LEAST);
}
