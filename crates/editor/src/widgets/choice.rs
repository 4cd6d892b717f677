//! A choice among words.

use super::describe;
use super::field::{self, Field, Shown};
use crate::theme;
use crate::tr;
use eframe::egui::{ComboBox, RichText, Ui};

/// A label and a list that opens. `choices` are what each stands for and its name. Gives what has been chosen.
pub fn choice_field<T: Clone + PartialEq>(
    ui: &mut Ui,
    field: &Field<'_>,
    current: Option<&T>,
    choices: &[(T, String)],
) -> Option<T> {
    let width = (ui.available_width() * 0.56).floor();
    field::labelled(ui, field, width, |ui, width| choice_box(ui, field, width, current, choices))
}

fn choice_box<T: Clone + PartialEq>(
    ui: &mut Ui,
    field: &Field<'_>,
    width: f32,
    current: Option<&T>,
    choices: &[(T, String)],
) -> Option<T> {
    let theme = theme::of(ui);
    let name =
        current.and_then(|c| choices.iter().find(|(choice, _)| choice == c)).map(|(_, name)| name.as_str());
    let (text, color) = match (field.shown, name) {
        (Shown::Mixed, _) => (tr!("widgets-mixed"), theme.text_muted),
        (Shown::Derived, name) => (name.unwrap_or_default().to_owned(), theme.text_muted),
        (Shown::Stated, name) => (name.unwrap_or_default().to_owned(), theme.text),
    };
    let mut chosen = None;
    let combo = ComboBox::from_id_salt(("choice", field.label)).width(width).truncate();
    let inner = combo.selected_text(RichText::new(text).color(color)).show_ui(ui, |ui| {
        for (choice, name) in choices {
            let is_current = current == Some(choice) && field.shown != Shown::Mixed;
            let response = ui.selectable_label(is_current, name);
            if describe(response, name, field.tooltip).clicked() {
                chosen = Some(choice.clone());
            }
        }
    });
    describe(inner.response, field.label, field.tooltip);
    chosen
}
