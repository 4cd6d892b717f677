//! In every state of the window, in both languages and in large text: each control has a name and a tooltip, and no text is
//! cut off.

use crate::person::Person;
use crate::support::{controls_without_name_or_tooltip, labels_clipped};
use eframe::egui::{Key, Modifiers};
use vitrine::scene::{LightSource, ListName, Shape};
use vitrine_editor::action::{Action, NewThing, Screen};
use vitrine_editor::document::Thing;
use vitrine_editor::files::Config;
use vitrine_editor::text::{Language, text_of};

/// Faults that were found, each once, with the state in which it was first.
#[derive(Default)]
struct Faults(Vec<(String, String)>);

impl Faults {
    fn look(&mut self, person: &Person, state: &str) {
        let nameless = controls_without_name_or_tooltip(&person.window);
        let clipped = labels_clipped(&person.window);
        let all = nameless.into_iter().map(|f| format!("no name or tooltip: {f}")).chain(clipped);
        // A name that a person has given may be so long that "…" stands for its end, a text in a field goes on as one
        // types, and the cards of the gallery go on below the window's edge: all of the window scrolls.
        let scene = person.scene();
        let names = scene.objects.iter().map(|o| &o.name).chain(scene.lights.iter().map(|l| &l.name));
        let long_names: Vec<_> = names.map(|name| format!("{name:?} is cut short")).collect();
        let about = format!("{:?} sticks out sideways", scene.about);
        let is_meant = |fault: &String| {
            long_names.contains(fault)
                || fault.starts_with(&about)
                || state == "gallery" && fault.contains("sticks out of the screen")
        };
        for fault in all.filter(|f| !is_meant(f)) {
            if !self.0.iter().any(|(known, _)| *known == fault) {
                self.0.push((fault, state.to_owned()));
            }
        }
    }
}

fn say(key: &str) -> String {
    text_of(key, &[])
}

/// Goes through the states of the window one after another.
fn go_through(config: &Config) -> Vec<String> {
    let mut faults = Faults::default();
    let mut person = Person::with(tempfile::tempdir().unwrap(), config);
    faults.look(&person, "gallery");
    person.ask(Action::NewFrom("empty".into()));
    faults.look(&person, "empty scene");
    person.click(&say("properties-more"));
    faults.look(&person, "settings of the scene");
    person.use_tool(&say("toolbar-sphere"));
    faults.look(&person, "an object selected");
    for thing in [Thing::light("lamp"), Thing::light("everywhere light"), Thing::Camera] {
        person.ask(Action::Select(vec![thing.clone()]));
        faults.look(&person, &format!("{thing:?} selected"));
    }
    person.ask(Action::SelectAll);
    faults.look(&person, "everything selected");
    person.press(Key::G, Modifiers::COMMAND);
    faults.look(&person, "a group selected");
    for menu in ["file", "edit", "add", "view", "render", "help"] {
        let name = say(&format!("menu-{menu}"));
        person.use_tool(&name);
        faults.look(&person, &format!("the menu {name}"));
        person.press(Key::Escape, Modifiers::NONE);
    }
    dialogs(&mut person, &mut faults);
    person.ask(Action::Show(Screen::Tour));
    faults.look(&person, "the tour");
    faults.0.into_iter().map(|(fault, state)| format!("{state}: {fault}")).collect()
}

fn dialogs(person: &mut Person, faults: &mut Faults) {
    let objects = Shape::KINDS.iter().filter(|k| k.name != "mesh").map(|k| (ListName::Object, k.name));
    let lights = LightSource::KINDS.iter().map(|k| (ListName::Light, k.name));
    for (list, kind) in objects.chain(lights) {
        person.ask(Action::AddDialog(NewThing { list, kind }));
        faults.look(person, &format!("the dialog that adds a {kind}"));
        person.press(Key::Escape, Modifiers::NONE);
    }
    person.ask(Action::EditDialog(Thing::object("ground")));
    faults.look(person, "the dialog that edits");
    person.press(Key::Escape, Modifiers::NONE);
    for screen in [Screen::Settings, Screen::Problems, Screen::Shortcuts, Screen::Glossary, Screen::About] {
        person.ask(Action::Show(screen));
        faults.look(person, &format!("{screen:?}"));
        person.press(Key::Escape, Modifiers::NONE);
    }
    person.ask(Action::SavePicture);
    faults.look(person, "the dialog that saves the picture");
    person.press(Key::Escape, Modifiers::NONE);
    person.ask(Action::Quit);
    faults.look(person, "the question about changes");
    person.press(Key::Escape, Modifiers::NONE);
    let path = person.path("corner.obj");
    std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n").unwrap();
    person.open(path);
    faults.look(person, "the settings of a model");
    person.press(Key::Escape, Modifiers::NONE);
    let path = person.path("broken.obj");
    std::fs::write(&path, "v 0 0 0\nf 1 2 9\n").unwrap();
    person.open(path);
    faults.look(person, "what is wrong with a file");
    person.press(Key::Escape, Modifiers::NONE);
    // The dialog in which a file is chosen is another crate's, which names no tooltips: it is not looked at.
}

fn none_in(language: Language, large_text: bool) {
    let config = Config { language, large_text, ..Config::default() };
    let faults = go_through(&config);
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn everything_is_named_and_whole_in_english() {
    none_in(Language::English, false);
}

#[test]
fn everything_is_named_and_whole_in_russian() {
    none_in(Language::Russian, false);
}

#[test]
fn everything_is_named_and_whole_in_english_in_large_text() {
    none_in(Language::English, true);
}

#[test]
fn everything_is_named_and_whole_in_russian_in_large_text() {
    none_in(Language::Russian, true);
}
