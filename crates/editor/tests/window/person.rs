//! A person before the window.

use crate::support::CpuRenderer;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2, Rect, Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, Node};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use vitrine::scene::Scene;
use vitrine_editor::action::Action;
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
        Self::at_pace(home, config, Pace::Immediate)
    }

    /// The same, with pictures at once or on threads of their own.
    pub fn at_pace(home: TempDir, config: &Config, pace: Pace) -> Self {
        let places = Places::inside(home.path());
        config.save(&places).unwrap();
        text::set_language(config.language);
        let size = Vec2::from(WINDOW_SIZE);
        let builder = Harness::builder().with_size(size).with_max_steps(32).renderer(CpuRenderer::default());
        let window =
            builder.build_eframe(move |creation| Editor::new(&creation.egui_ctx, places, None, pace));
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

    /// Waits until something is so, then for the window to come to rest. Fails after a long time.
    pub fn until(&mut self, what: &str, is_so: impl Fn(&Editor) -> bool) {
        self.until_seen(what, is_so);
        self.wait();
    }

    /// Waits until something is so, and no longer: the window may go on. Fails after a long time.
    pub fn until_seen(&mut self, what: &str, is_so: impl Fn(&Editor) -> bool) {
        let start = Instant::now();
        while !is_so(self.window.state()) {
            assert!(start.elapsed() < Duration::from_secs(60), "waited for {what}");
            std::thread::sleep(Duration::from_millis(2));
            self.window.step();
        }
    }

    /// Asks for what only the system could ask for, such as a file that was chosen.
    pub fn ask(&mut self, action: Action) {
        self.window.state_mut().ask(action);
        self.wait();
    }

    /// Opens a file as if it had been chosen.
    pub fn open(&mut self, path: PathBuf) {
        self.window.state_mut().ask(Action::OpenFile(path));
        self.window.step();
        self.settle();
    }

    /// Gives files on other threads the time that they need.
    pub fn settle(&mut self) {
        for _ in 0..40 {
            std::thread::sleep(Duration::from_millis(5));
            self.window.step();
        }
        self.wait();
    }

    /// The controls of that name, in the order in which they are drawn: what is on top comes last.
    pub fn all<'a>(&'a self, name: &'a str) -> Vec<Node<'a>> {
        let is_control =
            |n: &Node<'_>| !matches!(n.accesskit_node().role(), Role::Label | Role::GenericContainer);
        let named = || self.window.query_all_by_label(name);
        let found: Vec<_> = named().filter(is_control).collect();
        if found.is_empty() { named().collect() } else { found }
    }

    /// The control of that name; of several the one on top.
    pub fn control<'a>(&'a self, name: &'a str) -> Node<'a> {
        let found = self.all(name).pop();
        found.unwrap_or_else(|| panic!("there is no {name:?}; there are: {:?}", self.names()))
    }

    /// The first control of that name: a tool of the bars above the picture.
    pub fn tool<'a>(&'a self, name: &'a str) -> Node<'a> {
        let found = self.all(name).into_iter().next();
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
        // What has to be scrolled to first is pressed as a screen reader presses it.
        let at = self.control(name).rect();
        if at.bottom() < 765.0 && at.right() < WINDOW_SIZE[0] || at.top() > 770.0 && at.bottom() <= 800.0 {
            self.control(name).click();
        } else {
            self.control(name).click_accesskit();
        }
        self.wait();
    }

    /// Clicks a tool above the picture.
    pub fn use_tool(&mut self, name: &str) {
        self.tool(name).click();
        self.wait();
    }

    /// The row of the list, which lies at the left of the window.
    pub fn row<'a>(&'a self, name: &'a str) -> Node<'a> {
        let is_row = |n: &Node<'_>| n.rect().right() < 215.0 && n.rect().top() > 100.0;
        self.all(name).into_iter().find(is_row).unwrap_or_else(|| panic!("no row {name:?}"))
    }

    /// Selects in the list.
    pub fn select(&mut self, name: &str) {
        self.row(name).click();
        self.wait();
    }

    /// Clicks a row with a modifier held.
    pub fn select_with(&mut self, name: &str, modifiers: Modifiers) {
        self.row(name).click_modifiers(modifiers);
        self.wait();
    }

    /// Opens a menu and clicks through its entries.
    pub fn choose(&mut self, names: &[&str]) {
        self.use_tool(names[0]);
        names[1..].iter().for_each(|name| self.click(name));
    }

    /// Opens a list of choices and takes one.
    pub fn pick(&mut self, list: &str, choice: &str) {
        self.click(list);
        self.click(choice);
    }

    pub fn press(&mut self, key: Key, modifiers: Modifiers) {
        self.window.key_press_modifiers(modifiers, key);
        self.wait();
    }

    /// Types into a field in place of what stands there, and goes on to the next.
    pub fn type_into(&mut self, name: &str, text: &str) {
        self.enter(name, text);
        self.press(Key::Tab, Modifiers::NONE);
    }

    /// Types into a field in place of what stands there, and stays in it.
    pub fn enter(&mut self, name: &str, text: &str) {
        let is_field = |n: &Node<'_>| matches!(n.accesskit_node().role(), Role::TextInput | Role::SpinButton);
        let field = self.all(name).into_iter().rfind(is_field);
        field.unwrap_or_else(|| panic!("no field {name:?}; there are: {:?}", self.names())).focus();
        self.wait();
        self.press(Key::A, Modifiers::COMMAND);
        self.window.event(Event::Text(text.to_owned()));
        self.wait();
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

    /// Where the picture is in the window.
    pub fn picture_rect(&self) -> Rect {
        let name = text::text_of("viewport-picture", &[]);
        let is_picture = |n: &Node<'_>| n.accesskit_node().role() == Role::Image;
        self.window.query_all_by_label(&name).find(is_picture).expect("the picture").rect()
    }

    /// Where an object is seen in the window: the middle of what is seen of it.
    pub fn place_of(&self, name: &str) -> Pos2 {
        let rect = self.picture_rect();
        let live = self.window.state().live();
        let shares = (0..96).flat_map(|x| (0..72).map(move |y| vec2(x as f32 + 0.5, y as f32 + 0.5)));
        let shares = shares.map(|at| at / vec2(96.0, 72.0));
        let seen: Vec<_> = shares.filter(|s| live.pick(s.x, s.y).is_some_and(|p| p.name == name)).collect();
        assert!(!seen.is_empty(), "{name} is not in the picture");
        let middle = seen.iter().fold(Vec2::ZERO, |sum, s| sum + *s) / seen.len() as f32;
        rect.min + middle * rect.size()
    }

    /// The live picture's bytes.
    pub fn picture(&self) -> Vec<u8> {
        self.window.state().live().picture().expect("a picture").rgba.clone()
    }

    /// The colour that the live picture has at a point, given as shares of its size.
    pub fn color_at(&self, share: [f32; 2]) -> [u8; 3] {
        let picture = self.window.state().live().picture().expect("a picture");
        let [x, y] = [0, 1].map(|i| (share[i] * picture.size[i] as f32) as usize);
        let at = 4 * (y * picture.size[0] as usize + x);
        [picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]
    }

    /// A file in the home.
    pub fn path(&self, name: &str) -> PathBuf {
        self.home.path().join(name)
    }
}
