//! The list of problems, with what the picture doctor has found: each with a mend, if there is one.

use super::Outcome;
use super::frame::{self, Buttons, Shell, Verdict};
use crate::action::{Action, Actions};
use crate::dialogs::Around;
use crate::document::{EditCommand, Thing};
use crate::text::tr;
use crate::theme::{self, icon_font, icons};
use crate::widgets::{describe, empty_hint, text_button};
use eframe::egui::{Align, Button, Context, Label, Layout, RichText, Ui, vec2};
use vitrine::scene::Severity;

/// One line of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct ProblemLine {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in the current language.
    pub text: String,
    /// What helps, or empty.
    pub help: String,
    /// The thing that is meant; a click selects it.
    pub thing: Option<Thing>,
    /// The mend.
    pub mend: Option<Mend>,
}

/// What mends a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Mend {
    /// What it does, in the current language.
    pub text: String,
    /// The edit.
    pub command: EditCommand,
}

pub(super) fn show(ctx: &Context, around: &Around<'_>, actions: &mut Actions) -> Outcome {
    let title = tr!("dialog-problems-title");
    let width = theme::of(ctx).sizes.dialog_width * 1.35;
    let verdict = frame::show(ctx, Shell { id: "problems", title: &title, width }, |ui| {
        if around.problems.is_empty() {
            empty_hint(ui, &tr!("dialog-problems-none"));
        }
        for (i, line) in around.problems.iter().enumerate() {
            if i > 0 {
                ui.separator();
            }
            ui.push_id(i, |ui| line_ui(ui, line, actions));
        }
        Buttons::close()
    });
    if verdict == Verdict::Open { Outcome::Stay(None) } else { Outcome::Close(None) }
}

fn line_ui(ui: &mut Ui, line: &ProblemLine, actions: &mut Actions) {
    let theme = theme::of(ui);
    let (icon, color, name) = match line.severity {
        Severity::Error => (icons::WARNING, theme.error_text, tr!("dialog-problems-error")),
        Severity::Warning => (icons::INFO, theme.warning_text, tr!("dialog-problems-warning")),
    };
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = theme.sizes.gap_m;
        let icon = RichText::new(icon).font(icon_font(theme.sizes.icon)).color(color);
        let room = vec2(theme.sizes.icon, theme.sizes.control);
        describe(ui.add_sized(room, Label::new(icon).selectable(false)), &name, &name);
        let mend_width = if line.mend.is_some() { theme.sizes.control * 4.5 } else { 0.0 };
        let room = vec2(ui.available_width() - mend_width, 0.0);
        ui.allocate_ui_with_layout(room, Layout::top_down(Align::Min), |ui| {
            ui.set_width(room.x);
            ui.spacing_mut().button_padding.x = 0.0;
            ui.spacing_mut().item_spacing.y = 0.0;
            what(ui, line, actions);
        });
        let Some(mend) = &line.mend else { return };
        ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
            let tooltip = tr!("dialog-problems-fix.tooltip", mend = mend.text.as_str());
            if text_button(ui, &tr!("dialog-problems-fix"), &tooltip).clicked() {
                actions.push(Action::Edit(mend.command.clone()));
            }
        });
    });
}

/// What is wrong and what helps. A click selects the thing that is meant.
fn what(ui: &mut Ui, line: &ProblemLine, actions: &mut Actions) {
    match &line.thing {
        Some(thing) => {
            let text = RichText::new(&line.text).color(theme::of(ui).text_strong);
            let button = Button::new(text).frame(false).wrap();
            let tooltip = tr!("dialog-problems-select.tooltip");
            if describe(ui.add(button), &line.text, &tooltip).clicked() {
                actions.push(Action::Select(vec![thing.clone()]));
            }
        }
        None => frame::paragraph(ui, &line.text),
    }
    if !line.help.is_empty() {
        frame::hint(ui, &line.help);
    }
}
