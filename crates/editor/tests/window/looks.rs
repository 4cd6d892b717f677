//! How the window looks in its main states, in both languages: the pictures in `docs/window/`, which the guide shows. A picture
//! that differs is a question: look at both before taking the new one over with `UPDATE_SNAPSHOTS=1`.

use crate::person::Person;
use eframe::egui::vec2;
use egui_kittest::{SnapshotOptions, SnapshotResults};
use vitrine::scene::ListName;
use vitrine_editor::action::{Action, NewThing, Screen};
use vitrine_editor::document::Thing;
use vitrine_editor::files::Config;
use vitrine_editor::text::{Language, text_of};

fn compare(mut person: Person, name: &str, language: Language) -> SnapshotResults {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/window");
    let options = SnapshotOptions::new().output_path(folder);
    // Neither the pointer nor a line that blinks is a part of the window, and previews come when they are ready.
    person.window.remove_cursor();
    person.window.ctx.all_styles_mut(|style| style.visuals.text_cursor.blink = false);
    person.settle();
    person.window.snapshot_options(format!("{name}-{}", language.tag()), &options);
    person.window.take_snapshot_results()
}

fn in_both(name: &str, state: impl Fn(Language) -> Person) {
    let mut results = SnapshotResults::new();
    Language::ALL.into_iter().for_each(|language| results.extend(compare(state(language), name, language)));
}

fn say(key: &str) -> String {
    text_of(key, &[])
}

/// The gallery on any machine: the number of threads is told.
fn at_the_start(language: Language) -> Person {
    Person::with(tempfile::tempdir().unwrap(), &Config { language, threads: 2, ..Config::default() })
}

/// A red glass ball on the floor, selected.
fn with_red_ball(language: Language) -> Person {
    let mut person = at_the_start(language);
    person.click(&say("template-empty"));
    person.use_tool(&say("toolbar-sphere"));
    person.click(&say("material-red-glass"));
    person
}

fn with_dialog(language: Language, action: Action) -> Person {
    let mut person = with_red_ball(language);
    person.ask(action);
    person
}

#[test]
fn the_start() {
    in_both("start", at_the_start);
}

#[test]
fn a_scene_with_a_red_glass_ball() {
    in_both("scene", with_red_ball);
}

#[test]
fn the_dialog_that_adds_a_box() {
    let new = NewThing { list: ListName::Object, kind: "box" };
    in_both("add", |language| with_dialog(language, Action::AddDialog(new)));
}

#[test]
fn the_settings_of_a_model() {
    in_both("model", |language| {
        let mut person = with_red_ball(language);
        let path = person.path("vase.obj");
        std::fs::write(&path, vase()).unwrap();
        person.open(path);
        person
    });
}

/// A vase, turned: rings of points, wide in the middle.
fn vase() -> String {
    const AROUND: usize = 48;
    let profile =
        [[0.18, 0.0], [0.3, 0.12], [0.36, 0.3], [0.3, 0.5], [0.16, 0.68], [0.14, 0.78], [0.22, 0.9]];
    let mut text = String::new();
    for [radius, y] in profile {
        for i in 0..AROUND {
            let at = vec2(radius, 0.0);
            let angle = std::f32::consts::TAU * i as f32 / AROUND as f32;
            let at = eframe::egui::emath::Rot2::from_angle(angle) * at;
            text += &format!("v {:.4} {y} {:.4}\n", at.x, at.y);
        }
    }
    for ring in 0..profile.len() - 1 {
        for i in 0..AROUND {
            let [a, b] = [i, (i + 1) % AROUND].map(|i| ring * AROUND + i + 1);
            text += &format!("f {a} {} {} {b}\n", a + AROUND, b + AROUND);
        }
    }
    text
}

#[test]
fn the_dialog_that_saves_the_picture() {
    in_both("save", |language| {
        let mut person = with_dialog(language, Action::SavePicture);
        // Not where this home happens to be.
        let folder = person.home.path().parent().unwrap().to_owned();
        let field = say("dialog-save-path");
        person.enter(&field, &folder.join("ball.png").display().to_string());
        person
    });
}

#[test]
fn the_settings() {
    in_both("settings", |language| with_dialog(language, Action::Show(Screen::Settings)));
}

#[test]
fn the_glossary() {
    in_both("glossary", |language| with_dialog(language, Action::Show(Screen::Glossary)));
}

#[test]
fn the_camera() {
    in_both("camera", |language| with_dialog(language, Action::Select(vec![Thing::Camera])));
}
