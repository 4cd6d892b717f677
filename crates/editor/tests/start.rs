//! The gallery at the start and the strip of materials, driven by accessible names, in both languages.

mod support;

use eframe::egui::{Ui, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::sync::Arc;
use std::time::Duration;
use vitrine::templates::TEMPLATES;
use vitrine_editor::action::{Action, Actions};
use vitrine_editor::document::{Document, EditCommand, Thing};
use vitrine_editor::files::{
    Autosave, Config, Places, Recent, Recovery, Snapshot, read_template, recoverable,
};
use vitrine_editor::library::{Thumbnails, materials};
use vitrine_editor::panels::gallery::{GalleryAnswer, GalleryModel, GalleryState, gallery_ui};
use vitrine_editor::panels::materials::{MaterialsState, materials_ui};
use vitrine_editor::text::{Language, set_language, tr};
use vitrine_editor::theme;

/// What is drawn, and what was asked for.
struct Screen {
    document: Document,
    strip: MaterialsState,
    gallery: GalleryState,
    thumbnails: Thumbnails,
    config: Config,
    recent: Recent,
    recoveries: Vec<Recovery>,
    asked: Actions,
    answer: Option<GalleryAnswer>,
}

impl Screen {
    fn new(language: Language) -> Self {
        let opened = read_template("glass-ball").expect("the template is carried");
        Self {
            document: Document::untitled(opened.file, opened.assets, std::path::PathBuf::new()),
            strip: MaterialsState::default(),
            gallery: GalleryState::default(),
            thumbnails: Thumbnails::immediate(),
            config: Config { language, ..Config::default() },
            recent: Recent::default(),
            recoveries: Vec::new(),
            asked: Actions::new(),
            answer: None,
        }
    }

    fn gallery(&mut self, ui: &mut Ui) {
        let model = GalleryModel {
            recent: &self.recent,
            recoveries: &self.recoveries,
            thumbnails: &self.thumbnails,
            config: &self.config,
            can_return: true,
        };
        self.answer = self.answer.or(gallery_ui(ui, &mut self.gallery, &model, &mut self.asked));
    }

    fn strip(&mut self, ui: &mut Ui) {
        materials_ui(ui, &self.document, (&mut self.strip, &self.thumbnails), &mut self.asked);
    }
}

fn harness(screen: Screen, size: Vec2, draw: fn(&mut Screen, &mut Ui)) -> Harness<'static, Screen> {
    let mut is_ready = false;
    let whole = move |ui: &mut Ui, screen: &mut Screen| {
        set_language(screen.config.language);
        // Fonts are there from the next frame on.
        if std::mem::replace(&mut is_ready, true) {
            draw(screen, ui);
        } else {
            theme::apply(ui, &screen.config);
            ui.request_repaint();
        }
    };
    let mut harness = Harness::builder()
        .with_size(size)
        .renderer(support::CpuRenderer::default())
        .build_ui_state(whole, screen);
    harness.run();
    harness
}

const WINDOW: Vec2 = vec2(1280.0, 800.0);
const STRIP: Vec2 = vec2(794.0, 118.0);

fn languages() -> [(Language, &'static str); 2] {
    [(Language::English, "en"), (Language::Russian, "ru")]
}

#[test]
fn every_template_is_one_click_away_and_the_empty_scene_comes_first() {
    for (language, tag) in languages() {
        let mut harness = harness(Screen::new(language), WINDOW, Screen::gallery);
        set_language(language);
        assert_eq!(TEMPLATES[0].name, "empty");
        for template in TEMPLATES {
            let title = tr!(&format!("template-{}", template.name));
            assert_ne!(title, format!("template-{}", template.name));
            // Also those further down.
            harness.get_by_label(&title).click_accesskit();
            harness.run();
            let asked = std::mem::take(&mut harness.state_mut().asked);
            assert_eq!(asked, [Action::NewFrom(template.name.to_owned())], "{title}");
        }
        assert_eq!(support::controls_without_name_or_tooltip(&harness), [""; 0]);
        assert_eq!(support::labels_clipped(&harness), [""; 0]);
        support::picture(&mut harness, &format!("gallery-{tag}"));
    }
}

#[test]
fn the_gallery_opens_files_switches_languages_and_goes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ball.vitrine.toml");
    std::fs::write(&path, "format = 1\n").unwrap();
    let mut screen = Screen::new(Language::English);
    screen.recent.add(&path);
    let mut harness = harness(screen, WINDOW, Screen::gallery);
    for name in ["Open…", "ball", "Русский"] {
        harness.get_by_label(name).click();
        harness.run();
    }
    let [Action::Open, Action::OpenFile(opened), Action::Configure(config)] = &harness.state().asked[..]
    else {
        panic!("{:?}", harness.state().asked)
    };
    assert_eq!((opened, config.language), (&path, Language::Russian));
    harness.get_by_label("Back to the scene").click();
    harness.run();
    assert_eq!(harness.state().answer, Some(GalleryAnswer::Return));
}

#[test]
fn what_can_be_recovered_is_offered_with_its_age() {
    let home = tempfile::tempdir().unwrap();
    let places = Places::inside(home.path());
    let opened = read_template("snow-globe").unwrap();
    let mut autosave = Autosave::start(&places, Duration::ZERO).unwrap();
    let thumbnails = Thumbnails::immediate();
    autosave.offer(Snapshot {
        revision: 1,
        title: "Winter".into(),
        scene: Arc::new(opened.file.scene().clone()),
        base: None,
        path: None,
        folder: None,
        seen: None,
        thumbnail: thumbnails.template("snow-globe").map(Arc::unwrap_or_clone),
    });
    drop(autosave);
    for (language, tag) in languages() {
        let mut screen = Screen::new(language);
        screen.recoveries = recoverable(&places);
        assert_eq!(screen.recoveries.len(), 1);
        let mut harness = harness(screen, WINDOW, Screen::gallery);
        set_language(language);
        harness.get_by_label(&tr!("gallery-recover")).click();
        harness.run();
        assert_eq!(harness.state_mut().answer.take(), Some(GalleryAnswer::Recover(0)));
        harness.get_by_label(&tr!("gallery-discard")).click();
        harness.run();
        assert_eq!(harness.state().answer, Some(GalleryAnswer::Discard(0)));
        assert_eq!(support::controls_without_name_or_tooltip(&harness), [""; 0]);
        support::picture(&mut harness, &format!("gallery-recover-{tag}"));
    }
}

#[test]
fn a_click_paints_what_is_selected() {
    for (language, tag) in languages() {
        let mut screen = Screen::new(language);
        let ball = Thing::object("red ball");
        screen.document.select([ball.clone()]);
        let mut harness = harness(screen, STRIP, Screen::strip);
        set_language(language);
        let red = materials().iter().find(|m| m.key() == "material-red-glass").unwrap();
        harness.get_by_label(&red.title()).click();
        harness.run();
        let expected = EditCommand::Paint { things: vec![ball], material: Box::new(red.paint()) };
        assert_eq!(harness.state().asked, [Action::Edit(expected)]);
        assert_eq!(support::controls_without_name_or_tooltip(&harness), [""; 0]);
        assert_eq!(support::labels_clipped(&harness), [""; 0]);
        support::picture(&mut harness, &format!("materials-{tag}"));
    }
}

#[test]
fn a_click_with_nothing_selected_says_what_to_do() {
    let mut harness = harness(Screen::new(Language::English), STRIP, Screen::strip);
    harness.get_by_label("Clear glass").click();
    harness.run();
    assert!(harness.state().asked.is_empty());
    harness.get_by_label_contains("Select an object first");
}

#[test]
fn the_scenes_own_materials_come_first_and_shelves_part_the_library() {
    let mut harness = harness(Screen::new(Language::English), vec2(4000.0, 118.0), Screen::strip);
    let left = |harness: &Harness<'_, Screen>, name: &str| harness.get_by_label(name).rect().left();
    assert!(left(&harness, "yellow") < left(&harness, "Clear glass"), "the scene's own first");
    harness.get_by_label("Metal").click();
    harness.run();
    assert!(harness.query_by_label("Gold").is_some() && harness.query_by_label("Clear glass").is_none());
    harness.get_by_label("In the scene").click();
    harness.run();
    assert!(harness.query_by_label("yellow").is_some() && harness.query_by_label("Gold").is_none());
}

#[test]
fn a_picture_of_the_library_comes_with_its_material() {
    let mut document = Screen::new(Language::English).document;
    for key in ["material-wood", "material-brick", "material-gold"] {
        let paint = materials().iter().find(|m| m.key() == key).unwrap().paint();
        let things = vec![Thing::object("red ball")];
        document.apply(EditCommand::Paint { things, material: Box::new(paint) }).unwrap();
        vitrine::render::compile(document.scene(), document.assets()).unwrap();
    }
    assert_eq!(document.assets().pictures.len(), 2);
}
