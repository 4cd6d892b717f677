//! Three boxes in a row, for x, y and z.

use super::field::{self, Edit, Field};
use super::number::{Number, NumberBox, box_id, number_box};
use crate::theme;
use crate::tr;
use eframe::egui::{Align, FontId, Layout, RichText, Ui, vec2};
use vitrine::math::Vec3;

/// A label and below it a box for each of x, y and z, with the letter in the axis's colour.
pub fn vector_field(ui: &mut Ui, field: &Field<'_>, number: &Number, value: Vec3) -> Option<Edit<Vec3>> {
    if !field.label.is_empty() {
        field::label(ui, field);
    }
    let sizes = &theme::of(ui).sizes;
    let letter = sizes.text;
    let gap = sizes.gap_s;
    let all = ui.available_width();
    let width = ((all - 2.0 * gap) / 3.0 - letter).floor();
    let mut edit = None;
    let mut ids = Vec::with_capacity(3);
    ui.allocate_ui_with_layout(vec2(all, sizes.control), Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        for (i, axis) in ["X", "Y", "Z"].into_iter().enumerate() {
            let name = tr!("widgets-axis-of", name = field.label, axis = axis);
            let id = box_id(ui, &name);
            ids.push(id);
            let color = theme::of(ui).axis(i);
            let text = RichText::new(axis).font(FontId::proportional(sizes.text_small)).color(color);
            ui.add_sized(vec2(letter, sizes.control), eframe::egui::Label::new(text).selectable(false));
            let one = Field { label: &name, ..*field };
            let component = f64::from(value[i]);
            if let Some(e) = number_box(ui, &NumberBox { id, width, field: &one, number }, component) {
                let mut changed = value;
                changed[i] = e.value as f32;
                edit = Some(Edit { value: changed, gesture: e.gesture, finished: e.finished });
            }
            if i < 2 {
                ui.add_space(gap);
            }
        }
    });
    ids.into_iter().for_each(|id| field::show_fault(ui, id));
    edit
}
