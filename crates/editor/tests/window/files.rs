//! Scenes from the gallery and from files, saving, recovering, questions, the doctor, the tour, the settings of the window.

use crate::course_work::{in_english, must_be_seen, newest};
use crate::person::Person;
use eframe::egui::{DroppedFile, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use vitrine::scene::Scene;
use vitrine_editor::action::Action;
use vitrine_editor::document::Thing;
use vitrine_editor::files::{Autosave, Config, Places, Snapshot, read_template};
use vitrine_editor::text::Language;

/// A small scene in the home.
fn scene_file(person: &Person, name: &str) -> PathBuf {
    let path = person.path(name);
    let text = "# A remark that stays.\nformat = 1\n[[light]]\nname = \"bulb\"\nkind = \"point\"\n\
                [[object]]\nname = \"ball\"\nshape = \"sphere\"\n";
    std::fs::write(&path, text).unwrap();
    path
}

fn read(path: &Path) -> Scene {
    vitrine::load(path).unwrap().scene
}

#[test]
fn one_click_in_the_gallery_leads_to_a_lit_picture() {
    let mut person = Person::at_the_start(Language::English);
    person.click("Glass ball");
    assert!(person.scene().objects.len() > 1);
    let picture = person.picture();
    assert!(picture.chunks_exact(4).any(|p| p[..3].iter().all(|v| *v > 100)), "it is lit");
    person.choose(&["File", "New…"]);
    person.click("Back to the scene");
    assert!(person.scene().objects.len() > 1);
}

#[test]
fn a_scene_is_opened_saved_with_its_remarks_and_one_backup_and_listed() {
    let mut person = in_english();
    let path = scene_file(&person, "shelf.vitrine.toml");
    let before = std::fs::read(&path).unwrap();
    person.open(path.clone());
    assert_eq!(person.document().path(), Some(path.as_path()));
    person.select("ball");
    person.type_into("Radius", "0.4");
    assert!(person.reads("Changed"));
    person.press(Key::S, Modifiers::COMMAND);
    person.until("the save", |e| !e.document().is_changed());
    assert!(person.reads("Saved"));
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("# A remark that stays."));
    assert_eq!(&read(&path), person.scene());
    assert_eq!(std::fs::read(person.path("shelf.vitrine.toml.bak")).unwrap(), before);
    person.use_tool("File");
    person.click("Open recent");
    assert!(person.sees("shelf.vitrine.toml"), "{:?}", person.names());
}

#[test]
fn a_new_scene_is_saved_under_the_name_that_is_chosen() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.choose(&["File", "Save as…"]);
    assert!(person.sees("Save the scene"), "{:?}", person.names());
    person.click("Save");
    person.until("the save", |e| e.document().path().is_some());
    let path = person.document().path().unwrap().to_owned();
    assert!(path.display().to_string().ends_with(".vitrine.toml"), "{}", path.display());
    assert!(path.starts_with(person.home.path()), "{}", path.display());
    assert_eq!(read(&path).objects.len(), 2);
}

#[test]
fn a_broken_scene_says_the_line_and_what_is_open_stays() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.press(Key::S, Modifiers::COMMAND);
    person.press(Key::Escape, Modifiers::NONE);
    let before = person.scene().clone();
    let path = scene_file(&person, "broken.vitrine.toml");
    let text = std::fs::read_to_string(&path).unwrap().replace("shape = \"sphere\"", "shape = \"sphear\"");
    std::fs::write(&path, text).unwrap();
    // Opening asks about the changes first.
    person.open(path);
    person.click("Don't save");
    person.settle();
    assert!(person.sees("The scene cannot be opened"), "{:?}", person.names());
    assert!(person.sees("Line 8") && person.reads("sphere"), "{:?}", person.names());
    person.click("Close");
    assert_eq!(person.scene(), &before);
    assert!(person.document().is_changed(), "what was not saved still is not");
}

#[test]
fn a_broken_model_and_a_file_of_no_known_kind_are_refused_with_the_reason() {
    let mut person = in_english();
    let path = person.path("broken.obj");
    std::fs::write(&path, "v 0 0 0\nf 1 2 9\n").unwrap();
    person.open(path);
    assert!(person.sees("The model cannot be read"), "{:?}", person.names());
    person.click("Close");
    let path = person.path("letter.docx");
    std::fs::write(&path, "hello").unwrap();
    person.open(path);
    assert!(person.sees("The scene cannot be opened"), "{:?}", person.names());
    person.press(Key::Escape, Modifiers::NONE);
    assert_eq!(person.scene().objects.len(), 1);
}

/// A file that is let go over the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|e| e.to_string())
    }
}

#[test]
fn a_file_that_is_dropped_onto_the_window_is_opened() {
    let mut person = in_english();
    let path = scene_file(&person, "dropped.vitrine.toml");
    person.window.input_mut().dropped_files.push(Arc::new(Dropped(path)));
    person.window.step();
    person.window.input_mut().dropped_files.clear();
    person.settle();
    assert!(person.scene().object("ball").is_some(), "{:?}", person.names());
}

fn commands(person: &Person) -> Vec<ViewportCommand> {
    let root = &person.window.output().viewport_output[&ViewportId::ROOT];
    root.commands.clone()
}

/// The person clicks the window's cross; what the window says to that.
fn close(person: &mut Person) -> Vec<ViewportCommand> {
    let close = |person: &mut Person, events: Vec<ViewportEvent>| {
        let viewports = &mut person.window.input_mut().viewports;
        viewports.get_mut(&ViewportId::ROOT).expect("the window").events = events;
    };
    close(person, vec![ViewportEvent::Close]);
    person.window.step();
    let said = commands(person);
    close(person, Vec::new());
    person.wait();
    said
}

#[test]
fn closing_asks_about_unsaved_changes() {
    let mut person = in_english();
    assert!(!close(&mut person).contains(&ViewportCommand::CancelClose), "there is nothing to lose");
    person.use_tool("Sphere");
    assert!(close(&mut person).contains(&ViewportCommand::CancelClose));
    assert!(person.sees("Save the changes?"), "{:?}", person.names());
    person.click("Cancel");
    assert!(!person.sees("Save the changes?"));
    close(&mut person);
    person.control("Don't save").click();
    person.window.step();
    person.window.step();
    assert!(!close(&mut person).contains(&ViewportCommand::CancelClose), "now it may close");
}

#[test]
fn opening_another_scene_asks_about_unsaved_changes_and_can_save_them() {
    let mut person = in_english();
    let [first, second] = ["first", "second"].map(|n| scene_file(&person, &format!("{n}.vitrine.toml")));
    person.open(first.clone());
    person.select("ball");
    person.type_into("Radius", "0.3");
    person.open(second.clone());
    assert!(person.reads("first.vitrine.toml”"), "{:?}", person.names());
    person.click("Save");
    person.until("the other scene", |e| e.document().path() == Some(&second));
    assert!(std::fs::read_to_string(&first).unwrap().contains("radius = 0.3"));
}

#[test]
fn what_a_killed_window_left_is_offered_and_recovered() {
    let home = tempfile::tempdir().unwrap();
    let places = Places::inside(home.path());
    let opened = read_template("snow-globe").unwrap();
    let mut autosave = Autosave::start(&places, Duration::ZERO).unwrap();
    autosave.offer(Snapshot {
        revision: 1,
        title: "Winter".into(),
        scene: Arc::new(opened.file.scene().clone()),
        base: None,
        path: None,
        folder: None,
        seen: None,
        thumbnail: None,
    });
    drop(autosave);
    let mut person = Person::with(home, &Config::default());
    assert!(person.reads("Winter"), "{:?}", person.names());
    person.click("Recover");
    assert_eq!(person.scene(), opened.file.scene());
    assert!(person.document().is_changed(), "it is not saved yet");
}

#[test]
fn the_language_the_letters_and_the_contrast_change_at_once() {
    let mut person = in_english();
    person.click("Language: Русский");
    assert!(person.sees("Файл") && !person.sees("File"), "{:?}", person.names());
    person.choose(&["Вид", "Крупный текст"]);
    person.choose(&["Вид", "Высокий контраст"]);
    let Person { window, home } = person;
    drop(window);
    let (config, _) = Config::load(&Places::inside(home.path()));
    assert_eq!((config.language, config.large_text, config.high_contrast), (Language::Russian, true, true));
    let person = Person::with(home, &config);
    assert!(person.sees("Открыть…"), "it is kept for the next start");
}

#[test]
fn the_picture_doctor_says_why_it_is_black_and_mends_it() {
    let mut person = in_english();
    assert!(!person.reads("problem"));
    for light in ["lamp", "everywhere light"] {
        person.select(light);
        person.click("Delete");
    }
    person.click("1 problem");
    assert!(person.reads("because there is no light"), "{:?}", person.names());
    must_be_seen(&mut person, |person| person.click("Fix"));
    assert_eq!(person.scene().lights.len(), 1);
    assert!(person.sees("Nothing is wrong with the scene"), "{:?}", person.names());
}

#[test]
fn the_tour_leads_to_a_saved_picture() {
    let mut person = in_english();
    person.choose(&["Help", "First picture in 60 seconds"]);
    assert!(person.sees("Add a ball"), "{:?}", person.names());
    person.use_tool("Sphere");
    assert!(!person.sees("Add a ball"), "the step is done");
    person.click("Red glass");
    let at = person.place_of("Sphere") + eframe::egui::vec2(-28.0, 28.0);
    person.drag(at, at + eframe::egui::vec2(-40.0, 10.0));
    person.use_tool("Start");
    person.use_tool("Picture");
    let path = person.path("first.png");
    person.type_into("File", &path.display().to_string());
    person.click("Save");
    person.until("the file", |_| path.is_file());
    person.settle();
    assert!(person.sees("Your first picture is ready"), "{:?}", person.names());
    person.click("Finish");
    assert!(!person.sees("Your first picture is ready"));
    assert!(person.document().selection().contains(&Thing::object(newest(&person).name)));
}

#[test]
fn a_scene_named_on_the_command_line_or_asked_for_is_opened_from_the_gallery() {
    let mut person = Person::at_the_start(Language::English);
    let path = scene_file(&person, "asked.vitrine.toml");
    person.open(path);
    assert!(person.scene().object("ball").is_some());
    person.ask(Action::Quit);
    assert!(!person.sees("Save the changes?"), "nothing has changed");
}
