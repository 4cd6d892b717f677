//! A slider with a box for its number.

use super::field::{self, Edit, Field, Shown};
use super::number::{Number, NumberBox, box_id, number_box};
use super::{describe, new_gesture};
use crate::document::Gesture;
use crate::theme;
use crate::tr;
use eframe::egui::{Slider, SliderClamping, Ui};

/// A label, a slider for quick changes and a box for exact ones. The slider covers what is usual: `from` to `to`; the box
/// takes all that is allowed.
pub fn slider_with_value(
    ui: &mut Ui,
    field: &Field<'_>,
    number: &Number,
    [from, to]: [f64; 2],
    value: f64,
) -> Option<Edit<f64>> {
    let sizes = &theme::of(ui).sizes;
    let (width, gap) = (sizes.control * 2.3, sizes.gap_m);
    let id = box_id(ui, field.label);
    let edit = ui
        .vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            field::label(ui, field);
            ui.horizontal(|ui| {
                ui.spacing_mut().slider_width = ui.available_width() - width - gap;
                let moved = rail(ui, field, number, [from, to], value);
                let typed = number_box(ui, &NumberBox { id, width, field, number }, value);
                typed.or(moved)
            })
            .inner
        })
        .inner;
    field::show_fault(ui, id);
    edit
}

fn rail(
    ui: &mut Ui,
    field: &Field<'_>,
    number: &Number,
    [from, to]: [f64; 2],
    value: f64,
) -> Option<Edit<f64>> {
    let mut moved = value;
    let theme = theme::of(ui);
    if field.shown != Shown::Stated {
        let visuals = &mut ui.visuals_mut().selection;
        visuals.bg_fill = theme.border;
    } else {
        ui.visuals_mut().selection.bg_fill = theme.accent;
    }
    let is_wide = from > 0.0 && to / from > 50.0;
    let slider = Slider::new(&mut moved, from..=to)
        .show_value(false)
        .clamping(SliderClamping::Edits)
        .logarithmic(is_wide);
    let response = ui.add(slider.step_by(if is_wide || number.whole { 1.0 } else { 0.01 }));
    let id = response.id.with("gesture");
    if response.drag_started() || (response.changed() && !response.dragged()) {
        ui.data_mut(|d| d.insert_temp(id, new_gesture()));
    }
    let gesture: Option<Gesture> = ui.data(|d| d.get_temp(id));
    let finished = response.drag_stopped() || !response.dragged();
    let edit = response.changed().then(|| Edit { value: number.clamped(moved), gesture, finished });
    describe(response, &tr!("widgets-slider", name = field.label), field.tooltip);
    edit
}
