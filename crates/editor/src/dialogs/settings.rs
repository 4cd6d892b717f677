//! «Settings»: of the program, which take effect at once and are taken back by «Cancel», and of the scene's picture.

use super::frame::{self, Buttons, Shell, Verdict};
use super::{Around, Outcome, RENDERERS, one_step};
use crate::action::{Action, Actions};
use crate::document::{EditCommand, Thing};
use crate::files::Config;
use crate::text::{Language, tr};
use crate::theme;
use crate::widgets::{Field, Number, Shown, number_field, toggle};
use eframe::egui::{Context, Ui};
use vitrine::render::threads;
use vitrine::scene::{ParamValue, Renderer, Settings, Value};

/// The dialog «Settings».
#[derive(Debug)]
pub struct SettingsDialog {
    config: Config,
    depth: u32,
    renderer: Renderer,
    /// What the program's settings were.
    before: Config,
    /// How many threads the machine has.
    machine: usize,
}

impl SettingsDialog {
    /// As everything is now.
    #[must_use]
    pub fn new(around: &Around<'_>) -> Self {
        let settings = &around.document.scene().settings;
        Self {
            config: around.config.clone(),
            depth: settings.depth,
            renderer: settings.renderer,
            before: around.config.clone(),
            machine: threads::of_machine(),
        }
    }

    pub(super) fn show(&mut self, ctx: &Context, around: &Around<'_>, actions: &mut Actions) -> Outcome {
        let title = tr!("dialog-settings-title");
        let width = theme::of(ctx).sizes.dialog_width;
        let shown = self.config.clone();
        let verdict = frame::show(ctx, Shell { id: "settings", title: &title, width }, |ui| {
            self.body(ui);
            Buttons::accept("dialog-ok", true)
        });
        // What is seen at once: so a person can judge it.
        if self.config != shown {
            actions.push(Action::Configure(Box::new(self.config.clone())));
        }
        match verdict {
            Verdict::Accept => {
                one_step(self.commands(&around.document.scene().settings), None, actions);
                Outcome::Close(None)
            }
            Verdict::Cancel => {
                if self.config != self.before {
                    actions.push(Action::Configure(Box::new(self.before.clone())));
                }
                Outcome::Close(None)
            }
            Verdict::Open | Verdict::Other => Outcome::Stay(None),
        }
    }

    fn body(&mut self, ui: &mut Ui) {
        let gap = theme::of(ui).sizes.gap_l;
        frame::heading(ui, &tr!("dialog-settings-machine"));
        let all = tr!("dialog-settings-threads-all", count = self.machine);
        let mut threads = vec![(0, all)];
        // A number that was chosen on a larger machine stays in the list.
        let most = self.machine.max(self.config.threads);
        threads.extend((1..=most).map(|n| (n, n.to_string())));
        if let Some(chosen) = frame::choice(ui, "dialog-settings-threads", &self.config.threads, &threads) {
            self.config.threads = chosen;
        }
        ui.add_space(gap);
        frame::heading(ui, &tr!("dialog-settings-picture"));
        depth(ui, &mut self.depth);
        let renderers = RENDERERS.map(|(renderer, key)| (renderer, tr!(key)));
        if let Some(chosen) = frame::choice(ui, "dialog-settings-renderer", &self.renderer, &renderers) {
            self.renderer = chosen;
        }
        let key = RENDERERS.iter().find(|(r, _)| *r == self.renderer).map_or("", |(_, key)| key);
        frame::hint(ui, &tr!(&format!("{key}.tooltip")));
        ui.add_space(gap);
        frame::heading(ui, &tr!("dialog-settings-window"));
        let languages = Language::ALL.map(|l| (l, l.own_name().to_owned()));
        if let Some(chosen) = frame::choice(ui, "dialog-settings-language", &self.config.language, &languages)
        {
            self.config.language = chosen;
        }
        let key = "dialog-settings-large-text";
        toggle(ui, &mut self.config.large_text, &tr!(key), &tr!(&format!("{key}.tooltip")));
        let key = "dialog-settings-high-contrast";
        toggle(ui, &mut self.config.high_contrast, &tr!(key), &tr!(&format!("{key}.tooltip")));
    }

    fn commands(&self, settings: &Settings) -> Vec<EditCommand> {
        let set =
            |key: &str, value| EditCommand::Set { things: vec![Thing::Settings], key: key.into(), value };
        let depth = Value::Integer(i64::from(self.depth));
        let depth = (self.depth != settings.depth).then(|| set("depth", depth));
        let renderer = self.renderer.to_value();
        let renderer = (self.renderer != settings.renderer).then(|| set("renderer", renderer));
        depth.into_iter().chain(renderer).collect()
    }
}

fn depth(ui: &mut Ui, depth: &mut u32) {
    let Some(spec) = Settings::SPECS.iter().find(|s| s.name == "depth") else { return };
    let (label, tooltip) = (tr!("dialog-settings-depth"), tr!("dialog-settings-depth.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(edit) = number_field(ui, &field, &Number::of(spec), f64::from(*depth)) {
        *depth = edit.value as u32;
    }
}
