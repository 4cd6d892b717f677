//! Several boxes for numbers under one label: x, y and z; width and height; u and v.

use super::field::{self, Edit, Field};
use super::number::{Number, NumberBox, box_id, number_box};
use crate::theme;
use crate::tr;
use eframe::egui::{Align, Align2, FontId, Layout, Sense, Ui, vec2};
use vitrine::math::Vec3;

const AXES: [&str; 3] = ["X", "Y", "Z"];

/// A label and below it a box for each of x, y and z, with the letter in the axis's colour.
pub fn vector_field(ui: &mut Ui, field: &Field<'_>, number: &Number, value: Vec3) -> Option<Edit<Vec3>> {
    let values = value.to_array().map(f64::from);
    let (at, edit) = field::stacked(ui, field, |ui| boxes(ui, field, number, (&AXES, &values)))?;
    Some(edit.map(|component| {
        let mut changed = value;
        changed[at] = component as f32;
        changed
    }))
}

/// Boxes in rows, each with a word before it: three with letters of axes, two with words. Gives the one that was changed.
pub(super) fn boxes(
    ui: &mut Ui,
    field: &Field<'_>,
    number: &Number,
    (words, values): (&[&str], &[f64]),
) -> Option<(usize, Edit<f64>)> {
    let mut edit = None;
    let mut ids = Vec::with_capacity(words.len());
    let columns = if words == AXES { 3 } else { 2 };
    let all: Vec<usize> = (0..words.len()).collect();
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = theme::of(ui).sizes.gap_s;
        for row in all.chunks(columns) {
            let part = (words, values, row);
            if let Some(e) = row_ui(ui, field, number, part, &mut ids) {
                edit = Some(e);
            }
        }
    });
    ids.into_iter().for_each(|id| field::show_fault(ui, id));
    edit
}

fn row_ui(
    ui: &mut Ui,
    field: &Field<'_>,
    number: &Number,
    (words, values, row): (&[&str], &[f64], &[usize]),
    ids: &mut Vec<eframe::egui::Id>,
) -> Option<(usize, Edit<f64>)> {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let font = FontId::proportional(sizes.text_small);
    let wide = |word: &str| ui.painter().layout_no_wrap(word.to_owned(), font.clone(), theme.text).size().x;
    let letters: Vec<f32> = row.iter().map(|i| wide(words[*i]) + sizes.gap_s).collect();
    let columns = if words == AXES { 3 } else { 2 };
    let room = ui.available_width() - sizes.gap_m * (columns as f32 - 1.0) - letters.iter().sum::<f32>();
    let width = (room / columns as f32).floor();
    let size = vec2(ui.available_width(), sizes.control);
    let mut edit = None;
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        for (at, &i) in row.iter().enumerate() {
            let name = tr!("widgets-axis-of", name = field.label, axis = words[i]);
            let id = box_id(ui, &name);
            ids.push(id);
            let color = if columns == 3 { theme.axis(i) } else { theme.text_muted };
            let (rect, _) = ui.allocate_exact_size(vec2(letters[at], sizes.control), Sense::hover());
            ui.painter().text(rect.left_center(), Align2::LEFT_CENTER, words[i], font.clone(), color);
            let one = Field { label: &name, ..*field };
            if let Some(e) = number_box(ui, &NumberBox { id, width, field: &one, number }, values[i]) {
                edit = Some((i, e));
            }
            if at + 1 < row.len() {
                ui.add_space(sizes.gap_m);
            }
        }
    });
    edit
}
