//! What the program is, and whose work is in it.

use crate::dialogs::Outcome;
use crate::dialogs::frame::{self, Buttons, Shell, Verdict};
use crate::text::tr;
use crate::theme;
use eframe::egui::{Context, Grid, Label, RichText, Ui};

/// What it is made with: the key of what it does, its name, its licence.
const PARTS: [[&str; 3]; 7] = [
    ["help-about-part-egui", "egui, eframe", "MIT / Apache-2.0"],
    ["help-about-part-inter", "Inter", "SIL OFL 1.1"],
    ["help-about-part-phosphor", "Phosphor Icons", "MIT"],
    ["help-about-part-fluent", "Fluent", "MIT / Apache-2.0"],
    ["help-about-part-toml", "toml_edit", "MIT / Apache-2.0"],
    ["help-about-part-images", "image, png, exr", "MIT / Apache-2.0 / BSD-3-Clause"],
    ["help-about-part-glam", "glam, libm", "MIT / Apache-2.0"],
];

pub(in crate::dialogs) fn about(ctx: &Context) -> Outcome {
    let title = tr!("help-about-title");
    let width = theme::of(ctx).sizes.dialog_width * 1.2;
    let verdict = frame::show(ctx, Shell { id: "about", title: &title, width }, |ui| {
        body(ui);
        Buttons::close()
    });
    if verdict == Verdict::Open { Outcome::Stay(None) } else { Outcome::Close(None) }
}

fn body(ui: &mut Ui) {
    let theme = theme::of(ui);
    frame::hint(ui, &tr!("help-about-version", version = vitrine::VERSION));
    frame::paragraph(ui, &tr!("help-about-text"));
    frame::paragraph(ui, &tr!("help-about-own"));
    ui.add_space(theme.sizes.gap_s);
    frame::heading(ui, &tr!("help-about-parts"));
    let muted = |text: &str| Label::new(RichText::new(text).color(theme.text_muted)).selectable(false);
    Grid::new("parts").num_columns(3).spacing([theme.sizes.gap_xl, theme.sizes.gap_s]).show(ui, |ui| {
        for [what, name, licence] in PARTS {
            ui.add(muted(&tr!(what)));
            ui.label(name);
            ui.add(muted(licence));
            ui.end_row();
        }
    });
}
