//! A choice among words.

use super::describe;
use super::field::{self, Field, Shown};
use crate::theme::{self, icon_font, icons};
use crate::tr;
use eframe::egui::{Align2, Color32, ComboBox, FontId, RichText, Ui};

/// A label and a list that opens. `choices` are what each stands for and its name. Gives what has been chosen.
pub fn choice_field<T: Clone + PartialEq>(
    ui: &mut Ui,
    field: &Field<'_>,
    current: Option<&T>,
    choices: &[(T, String)],
) -> Option<T> {
    let sizes = &theme::of(ui).sizes;
    let (text, color) = shown(ui, field, current, choices);
    let font = FontId::proportional(sizes.text);
    let needed =
        ui.painter().layout_no_wrap(text.clone(), font, color).size().x + sizes.icon + 4.0 * sizes.gap_m;
    let usual = (ui.available_width() * 0.56).floor();
    // A name that does not fit beside the label gets the whole width below it.
    let width = if needed <= usual { usual } else { ui.available_width() };
    field::labelled(ui, field, width, |ui, width| {
        let mut chosen = None;
        let text = RichText::new(text).color(color);
        let combo =
            ComboBox::from_id_salt(("choice", field.label)).width(width).selected_text(text).truncate();
        let inner = combo.icon(draw_icon).show_ui(ui, |ui| {
            ui.set_min_width(width);
            for (choice, name) in choices {
                let is_current = current == Some(choice) && field.shown != Shown::Mixed;
                if describe(ui.selectable_label(is_current, name), name, field.tooltip).clicked() {
                    chosen = Some(choice.clone());
                }
            }
        });
        describe(inner.response, field.label, field.tooltip);
        chosen
    })
}

/// What the closed list says.
fn shown<T: PartialEq>(
    ui: &Ui,
    field: &Field<'_>,
    current: Option<&T>,
    choices: &[(T, String)],
) -> (String, Color32) {
    let theme = theme::of(ui);
    let named = choices.iter().find(|(choice, _)| Some(choice) == current).map(|(_, name)| name.clone());
    match (field.shown, named) {
        (Shown::Mixed, _) => (tr!("widgets-mixed"), theme.text_muted),
        (_, None) => (tr!("widgets-choose"), theme.text_muted),
        (Shown::Derived, Some(name)) => (name, theme.text_muted),
        (Shown::Stated, Some(name)) => (name, theme.text),
    }
}

fn draw_icon(
    ui: &Ui,
    rect: eframe::egui::Rect,
    visuals: &eframe::egui::style::WidgetVisuals,
    _is_open: bool,
) {
    let font = icon_font(theme::of(ui).sizes.text_small);
    ui.painter().text(rect.center(), Align2::CENTER_CENTER, icons::OPEN_DOWN, font, visuals.fg_stroke.color);
}
