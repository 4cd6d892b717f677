//! A window with a dialog in it, and the hands of a person.

use crate::support;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use vitrine::scene::{ParamSpec, Renderer};
use vitrine_editor::action::Actions;
use vitrine_editor::dialogs::*;
use vitrine_editor::document::Document;
use vitrine_editor::files::Config;
use vitrine_editor::text::{Language, param_label, set_language};
use vitrine_editor::theme;

/// A window with a dialog in it.
pub struct World {
    pub language: Language,
    pub document: Document,
    pub config: Config,
    pub problems: Vec<ProblemLine>,
    pub current: Option<CurrentPicture>,
    pub open: Option<Dialog>,
    pub actions: Actions,
    pub replies: Vec<Reply>,
    is_dressed: bool,
}

impl World {
    pub fn new(language: Language) -> Self {
        set_language(language);
        Self {
            language,
            document: Document::default(),
            config: Config { language, ..Config::default() },
            problems: Vec::new(),
            current: None,
            open: None,
            actions: Vec::new(),
            replies: Vec::new(),
            is_dressed: false,
        }
    }

    /// What a dialog that is made sees of the window.
    pub fn around(&self) -> Around<'_> {
        Around {
            document: &self.document,
            config: &self.config,
            problems: &[],
            samples_per_second: None,
            current: None,
        }
    }

    pub fn draw(&mut self, ui: &mut Ui) {
        set_language(self.language);
        if !std::mem::replace(&mut self.is_dressed, true) {
            theme::apply(ui, &self.config);
            return;
        }
        let around = Around {
            document: &self.document,
            config: &self.config,
            problems: &self.problems,
            samples_per_second: Some((Renderer::Classic, 1.0e6)),
            current: self.current,
        };
        let reply = dialogs_ui(ui, &mut self.open, &around, &mut self.actions);
        self.replies.extend(reply);
    }
}

pub fn harness(world: World) -> Harness<'static, World> {
    let builder = Harness::builder()
        .with_size(vec2(1280.0, 800.0))
        .with_max_steps(30)
        .renderer(support::CpuRenderer::default());
    let mut harness = builder.build_ui_state(|ui, world: &mut World| world.draw(ui), world);
    settle(&mut harness);
    harness
}

/// Lets the window come to rest. A preview that arrives meanwhile asks for another frame.
pub fn settle(harness: &mut Harness<'_, World>) {
    assert!(harness.run_ok().is_some(), "the window does not come to rest");
}

/// Types into the field of that name in place of what it held.
pub fn type_into(harness: &mut Harness<'_, World>, name: &str, text: &str) {
    let is_field = |role| matches!(role, Role::TextInput | Role::SpinButton | Role::NumberInput);
    let field = |harness: &Harness<'_, World>| {
        let nodes: Vec<_> = harness.query_all_by_label(name).map(|n| n.accesskit_node().role()).collect();
        let place = nodes.iter().position(|role| is_field(*role));
        place.unwrap_or_else(|| panic!("no field {name}: {nodes:?}"))
    };
    let at = field(harness);
    harness.query_all_by_label(name).nth(at).expect("the field was counted").focus();
    settle(harness);
    harness.key_combination_modifiers(Modifiers::COMMAND, &[Key::A]);
    settle(harness);
    let at = field(harness);
    harness.query_all_by_label(name).nth(at).expect("the field was counted").type_text(text);
    settle(harness);
}

pub fn press(harness: &mut Harness<'_, World>, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click();
    settle(harness);
}

pub fn both(test: impl Fn(Language)) {
    Language::ALL.into_iter().for_each(test);
}

pub fn label(kind: &str, specs: &'static [ParamSpec], key: &str) -> String {
    param_label(kind, specs.iter().find(|s| s.name == key).expect("there is such a parameter"))
}
