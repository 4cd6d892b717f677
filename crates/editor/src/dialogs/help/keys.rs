//! All keys, and what the mouse does in the picture.

use crate::dialogs::frame::{self, Buttons, Caption, Shell, Verdict};
use crate::dialogs::{Outcome, Reply};
use crate::shortcuts::{SHORTCUTS, Section};
use crate::text::tr;
use crate::theme;
use eframe::egui::{Align, Context, Label, Layout, RichText, Ui, vec2};

/// What the mouse does in the picture.
const MOUSE: [&str; 5] = ["select", "focus", "orbit", "pan", "zoom"];

pub(in crate::dialogs) fn shortcuts(ctx: &Context) -> Outcome {
    let title = tr!("help-shortcuts-title");
    let width = theme::of(ctx).sizes.dialog_wide;
    let verdict = frame::show(ctx, Shell { id: "shortcuts", title: &title, width }, |ui| {
        frame::columns(ui, |left, right| {
            section(left, Section::Edit);
            section(left, Section::Render);
            section(right, Section::File);
            section(right, Section::View);
            mouse(right);
        });
        Buttons { other: Some(Caption::of("tour-begin")), ..Buttons::close() }
    });
    match verdict {
        Verdict::Open => Outcome::Stay(None),
        Verdict::Other => Outcome::Close(Some(Reply::BeginTour)),
        Verdict::Accept | Verdict::Cancel => Outcome::Close(None),
    }
}

fn section(ui: &mut Ui, section: Section) {
    frame::heading(ui, &tr!(section.text_key()));
    for shortcut in SHORTCUTS.iter().filter(|s| s.section == section) {
        row(ui, &tr!(&shortcut.text_key()), &shortcut.keys_text(ui));
    }
    ui.add_space(theme::of(ui).sizes.gap_l);
}

fn mouse(ui: &mut Ui) {
    frame::heading(ui, &tr!("help-shortcuts-mouse"));
    for word in MOUSE {
        let key = format!("help-shortcuts-mouse-{word}");
        row(ui, &tr!(&format!("{key}.what")), &tr!(&key));
    }
}

/// What is done, and the keys that do it.
fn row(ui: &mut Ui, what: &str, keys: &str) {
    let theme = theme::of(ui);
    let room = vec2(ui.available_width(), theme.sizes.text + theme.sizes.gap_s);
    ui.allocate_ui_with_layout(room, Layout::right_to_left(Align::Center), |ui| {
        let keys = RichText::new(keys).size(theme.sizes.text_small).color(theme.text_muted);
        ui.add(Label::new(keys).selectable(false));
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add(Label::new(RichText::new(what).color(theme.text)).truncate().selectable(false));
        });
    });
}
