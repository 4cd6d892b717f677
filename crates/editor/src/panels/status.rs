//! The line at the bottom: how far the picture is, how it is made, whether the scene is saved.

use super::Around;
use crate::action::{Action, Actions, Screen};
use crate::document::{EditCommand, Thing};
use crate::text::{FluentValue, text_of, tr};
use crate::theme::{self, icons};
use crate::widgets::describe;
use eframe::egui::{self, Align, Button, Label, Layout, ProgressBar, RichText, Ui};
use std::time::Duration;
use vitrine::scene::{ParamKind, Settings, Value};

/// What the line says of the picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Progress {
    /// In words.
    pub text: String,
    /// From 0 to 1; None when there is nothing to wait for.
    pub share: Option<f32>,
}

/// What the line says of the scene and its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Standing {
    /// Saved, changed, not saved yet.
    pub file: String,
    /// How many things may be wrong with the scene.
    pub problems: usize,
    /// How many threads compute the picture.
    pub threads: usize,
}

/// Draws the line.
pub fn status_ui(
    ui: &mut Ui,
    around: &Around,
    progress: &Progress,
    standing: &Standing,
    actions: &mut Actions,
) {
    let theme = theme::of(ui);
    ui.horizontal_centered(|ui| {
        progress_ui(ui, progress);
        ui.separator();
        renderers_ui(ui, around, actions);
        ui.separator();
        setting_ui(ui, "status-threads", standing.threads as u64, actions);
        let depth = match around.setting("depth") {
            Some(Value::Integer(depth)) => depth.unsigned_abs(),
            _ => 0,
        };
        setting_ui(ui, "status-depth", depth, actions);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let file = RichText::new(&standing.file).color(theme.text_muted);
            ui.add(Label::new(file).truncate().selectable(false));
            problems_ui(ui, standing.problems, actions);
        });
    });
}

fn progress_ui(ui: &mut Ui, progress: &Progress) {
    let theme = theme::of(ui);
    let width = theme.sizes.list_width - 2.0 * theme.sizes.gap_m;
    let (name, tooltip) = (tr!("status-progress"), tr!("status-progress.tooltip"));
    let response = match progress.share {
        Some(share) => {
            let text = RichText::new(&progress.text).size(theme.sizes.text_small);
            let bar = ProgressBar::new(share).desired_width(width).desired_height(theme.sizes.control - 8.0);
            ui.add(bar.text(text).fill(theme.selection).corner_radius(theme.sizes.radius))
        }
        None => {
            let size = egui::vec2(width, theme.sizes.control - 8.0);
            let text = RichText::new(&progress.text).color(theme.text_muted);
            ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
                ui.set_min_width(width);
                ui.add(Label::new(text).truncate().selectable(false))
            })
            .inner
        }
    };
    describe(response, &name, &tooltip);
}

/// One word for each way to make the picture.
fn renderers_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let Some(spec) = Settings::SPECS.iter().find(|s| s.name == "renderer") else { return };
    let ParamKind::Choice(words) = spec.kind else { return };
    let now = around.setting("renderer");
    ui.spacing_mut().item_spacing.x = theme::of(ui).sizes.gap_xs;
    for word in words {
        let name = crate::text::choice_name(spec, word);
        let is_chosen = now == Some(Value::Text((*word).to_owned()));
        let response = ui.add(Button::selectable(is_chosen, name.as_str()));
        if response.clicked() && !is_chosen {
            let value = Value::Text((*word).to_owned());
            let things = vec![Thing::Settings];
            actions.push(Action::Edit(EditCommand::Set { things, key: spec.name.to_owned(), value }));
        }
        describe(response, &name, &tr!("status-renderer.tooltip"));
    }
}

/// A number that is changed in the settings.
fn setting_ui(ui: &mut Ui, key: &str, count: u64, actions: &mut Actions) {
    let text = text_of(key, &[("count", FluentValue::from(count))]);
    let response = ui.add(Button::new(text.as_str()).frame_when_inactive(false));
    if response.clicked() {
        actions.push(Action::Show(Screen::Settings));
    }
    describe(response, &text, &tr!(&format!("{key}.tooltip")));
}

fn problems_ui(ui: &mut Ui, count: usize, actions: &mut Actions) {
    if count == 0 {
        return;
    }
    let theme = theme::of(ui);
    let text = tr!("status-problems", count = count as u64);
    let shown = RichText::new(format!("{}  {text}", icons::WARNING)).color(theme.warning_text);
    let response = ui.add(Button::new(shown).frame_when_inactive(false));
    if response.clicked() {
        actions.push(Action::Show(Screen::Problems));
    }
    describe(response, &text, &tr!("status-problems.tooltip"));
}

/// A length of time for people: "0:41", "1:02:03".
#[must_use]
pub fn time_text(time: Duration) -> String {
    let seconds = time.as_secs();
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    if hours > 0 { format!("{hours}:{minutes:02}:{seconds:02}") } else { format!("{minutes}:{seconds:02}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_read_as_on_a_clock() {
        let text = |seconds| time_text(Duration::from_secs(seconds));
        assert_eq!([0, 41, 62, 3723].map(text), ["0:00", "0:41", "1:02", "1:02:03"]);
    }
}
