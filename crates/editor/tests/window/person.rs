//! A person before the window.

use crate::support::CpuRenderer;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2, Vec2, pos2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, Node};
use std::path::Path;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use vitrine::scene::Scene;
use vitrine_editor::document::Document;
use vitrine_editor::files::{Config, Places};
use vitrine_editor::text::{self, Language};
use vitrine_editor::{Editor, Pace, WINDOW_SIZE};

/// The window, with a home of its own, and hands.
pub struct Person {
    pub window: Harness<'static, Editor>,
    pub home: TempDir,
}

impl Person {
    /// Before the gallery of templates.
    pub fn at_the_start(language: Language) -> Self {
        Self::with(tempfile::tempdir().unwrap(), &Config { language, ..Config::default() })
    }

    /// In a home that is there already.
    pub fn with(home: TempDir, config: &Config) -> Self {
        let places = Places::inside(home.path());
        config.save(&places).unwrap();
        text::set_language(config.language);
        let size = Vec2::from(WINDOW_SIZE);
        let builder = Harness::builder().with_size(size).with_max_steps(32).renderer(CpuRenderer::default());
        let window = builder
            .build_eframe(move |creation| Editor::new(&creation.egui_ctx, places, None, Pace::Immediate));
        let mut person = Self { window, home };
        person.wait();
        person
    }

    /// In an empty scene.
    pub fn in_empty_scene(language: Language) -> Self {
        let mut person = Self::at_the_start(language);
        person.click(&text::text_of("template-empty", &[]));
        person
    }

    pub fn document(&self) -> &Document {
        self.window.state().document()
    }

    pub fn scene(&self) -> &Scene {
        self.document().scene()
    }

    /// Lets the window come to rest, files on other threads included.
    pub fn wait(&mut self) {
        let _ = self.window.run_ok();
    }

    /// Waits until something is so. Fails after a long time.
    pub fn until(&mut self, what: &str, is_so: impl Fn(&Editor) -> bool) {
        let start = Instant::now();
        while !is_so(self.window.state()) {
            assert!(start.elapsed() < Duration::from_secs(60), "waited for {what}");
            std::thread::sleep(Duration::from_millis(2));
            self.window.step();
        }
        self.wait();
    }

    /// The control of that name.
    pub fn control(&self, name: &str) -> Node<'_> {
        let all: Vec<_> = self.window.query_all_by_label(name).collect();
        // A label may say the same as the control that it belongs to.
        let is_control =
            |n: &&Node<'_>| !matches!(n.accesskit_node().role(), Role::Label | Role::GenericContainer);
        let found = all.iter().find(is_control).or_else(|| all.first()).copied();
        found.unwrap_or_else(|| panic!("there is no {name:?}; there are: {:?}", self.names()))
    }

    /// Whether there is a control or text of that name.
    pub fn sees(&self, name: &str) -> bool {
        self.window.query_all_by_label(name).next().is_some()
    }

    /// Whether a text that contains this can be seen.
    pub fn reads(&self, part: &str) -> bool {
        self.window.query_all_by_label_contains(part).next().is_some()
    }

    /// The names of all controls, for messages.
    pub fn names(&self) -> Vec<String> {
        let mut names = Vec::new();
        let mut open = vec![self.window.root().accesskit_node()];
        while let Some(node) = open.pop() {
            open.extend(node.children());
            names.extend(node.label().filter(|l| !l.is_empty()));
        }
        names
    }

    pub fn click(&mut self, name: &str) {
        self.control(name).click();
        self.wait();
    }

    /// Clicks with a modifier held.
    pub fn click_with(&mut self, name: &str, modifiers: Modifiers) {
        self.control(name).click_modifiers(modifiers);
        self.wait();
    }

    /// Clicks through entries of menus.
    pub fn choose(&mut self, names: &[&str]) {
        for name in names {
            self.click(name);
        }
    }

    pub fn press(&mut self, key: Key, modifiers: Modifiers) {
        self.window.key_press_modifiers(modifiers, key);
        self.wait();
    }

    /// Types into a field in place of what stands there, and Enter.
    pub fn type_into(&mut self, name: &str, text: &str) {
        let at = self.control(name).rect().center();
        self.click_at(at);
        self.press(Key::A, Modifiers::COMMAND);
        self.window.event(Event::Text(text.to_owned()));
        self.wait();
        self.press(Key::Enter, Modifiers::NONE);
    }

    pub fn click_at(&mut self, at: Pos2) {
        self.button(at, true);
        self.button(at, false);
        self.wait();
    }

    /// Presses the pointer, moves it in steps, and lets go.
    pub fn drag(&mut self, from: Pos2, to: Pos2) {
        self.window.hover_at(from);
        self.window.step();
        self.button(from, true);
        for step in 1..=4 {
            self.window.hover_at(from + (to - from) * (step as f32 / 4.0));
            self.window.step();
        }
        self.button(to, false);
        self.wait();
    }

    fn button(&mut self, at: Pos2, pressed: bool) {
        self.window.hover_at(at);
        let button = eframe::egui::PointerButton::Primary;
        self.window.event(Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
        self.window.step();
    }

    /// The middle of the picture.
    pub fn middle_of_picture(&self) -> Pos2 {
        self.control(&text::text_of("viewport-picture", &[])).rect().center()
    }

    /// The colour that the live picture has at a point, given as shares of its size.
    pub fn color_at(&self, share: [f32; 2]) -> [u8; 3] {
        let picture = self.window.state().live().picture().expect("a picture");
        let [x, y] = [0, 1].map(|i| (share[i] * picture.size[i] as f32) as usize);
        let at = 4 * (y * picture.size[0] as usize + x);
        [picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]
    }

    /// A file in the home.
    pub fn path(&self, name: &str) -> std::path::PathBuf {
        self.home.path().join(name)
    }
}

/// A point beside another.
pub fn beside(at: Pos2, x: f32, y: f32) -> Pos2 {
    pos2(at.x + x, at.y + y)
}

/// Reads a scene file as the command line would.
pub fn read(path: &Path) -> Scene {
    vitrine::load(path).unwrap().scene
}
