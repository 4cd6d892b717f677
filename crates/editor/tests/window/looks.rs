//! How the window looks in its main states, in both languages: the pictures in `docs/window/`, which the guide shows. A picture
//! that differs is a question: look at both before taking the new one over with `UPDATE_SNAPSHOTS=1`.

use crate::person::Person;
use egui_kittest::SnapshotOptions;
use vitrine_editor::text::{Language, text_of};

fn compare(person: &mut Person, name: &str, language: Language) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/window");
    let options = SnapshotOptions::new().output_path(folder);
    person.window.snapshot_options(format!("{name}-{}", language.tag()), &options);
}

fn in_both(state: impl Fn(Language) -> Person, name: &str) {
    for language in Language::ALL {
        compare(&mut state(language), name, language);
    }
}

fn say(key: &str) -> String {
    text_of(key, &[])
}

#[test]
fn the_start() {
    in_both(Person::at_the_start, "start");
}

#[test]
fn a_scene_with_a_red_glass_ball() {
    let state = |language| {
        let mut person = Person::in_empty_scene(language);
        person.click(&say("toolbar-sphere"));
        person.click(&say("material-red-glass"));
        person
    };
    in_both(state, "scene");
}
