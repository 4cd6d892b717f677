//! The scene and how its picture is made: shown while nothing is selected.

use super::ask::Ask;
use super::{remark_ui, title_ui};
use crate::document::{EditCommand, Thing};
use crate::text::tr;
use crate::theme::icons;
use crate::widgets::{Field, Shown, section, subsection, text_field};
use eframe::egui::Ui;
use vitrine::scene::Settings;

/// What is shown at first; the rest stands under "More".
const FIRST: [&str; 5] = ["size", "renderer", "depth", "samples", "background"];

/// The scene's part of the panel.
pub(super) fn scene_ui(ui: &mut Ui, ask: &mut Ask<'_>) {
    ui.horizontal(|ui| title_ui(ui, icons::EDIT, &tr!("properties-scene")));
    remark_ui(ui, &tr!("properties-nothing-selected"));
    let (label, tooltip) = (tr!("properties-about"), tr!("properties-about.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(edit) = text_field(ui, &field, &ask.scene.about) {
        ask.edit(EditCommand::SetAbout(edit.value));
    }
    let things = [Thing::Settings];
    section(ui, &tr!("properties-picture"), true, |ui| {
        FIRST.into_iter().for_each(|key| ask.param_ui(ui, &things, key));
        subsection(ui, &tr!("properties-more"), false, |ui| {
            let rest = Settings::SPECS.iter().filter(|s| !FIRST.contains(&s.name));
            rest.for_each(|spec| ask.param_ui(ui, &things, spec.name));
        });
    });
}
