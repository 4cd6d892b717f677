//! A slider with a box for its number.

use super::field::{self, Edit, Field, Shown};
use super::number::{Number, NumberBox, box_id, number_box, value_width};
use super::{describe, new_gesture};
use crate::document::Gesture;
use crate::theme;
use crate::tr;
use eframe::egui::{
    CursorIcon, EventFilter, Key, Modifiers, Rect, Response, Sense, Stroke, Ui, WidgetInfo, pos2, remap, vec2,
};

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
    let id = box_id(ui, field.label);
    let edit = ui
        .vertical(|ui| {
            ui.spacing_mut().item_spacing = vec2(sizes.gap_m, 0.0);
            field::label(ui, field);
            ui.add_space(sizes.gap_xs);
            ui.horizontal(|ui| {
                let width = value_width(ui);
                let size = vec2(ui.available_width() - width - sizes.gap_m, sizes.control);
                let rail = Rail { field, number, scale: Scale { from, to } };
                let moved = rail.show(ui, size, value);
                let typed = number_box(ui, &NumberBox { id, width, field, number }, value);
                typed.or(moved)
            })
            .inner
        })
        .inner;
    field::show_fault(ui, id);
    edit
}

/// How values lie along the rail: evenly, or in equal factors where the ends are far apart.
#[derive(Clone, Copy)]
struct Scale {
    from: f64,
    to: f64,
}

impl Scale {
    fn is_wide(self) -> bool {
        self.from > 0.0 && self.to / self.from > 50.0
    }

    /// Where a value lies, 0 to 1.
    fn place(self, value: f64) -> f64 {
        let at = |v: f64| if self.is_wide() { v.max(self.from).ln() } else { v };
        ((at(value) - at(self.from)) / (at(self.to) - at(self.from))).clamp(0.0, 1.0)
    }

    /// The value at a place, rounded as a person would say it: to hundredths of the rail.
    fn value(self, place: f64) -> f64 {
        let place = place.clamp(0.0, 1.0);
        if !self.is_wide() {
            let grain = 0.01_f64.min((self.to - self.from) / 100.0);
            return ((self.from + place * (self.to - self.from)) / grain).round() * grain;
        }
        let value = self.from * (self.to / self.from).powf(place);
        let grain = 10_f64.powf((value.log10() - 1.0).floor());
        (value / grain).round() * grain
    }
}

/// The slider without its box.
struct Rail<'a> {
    field: &'a Field<'a>,
    number: &'a Number,
    scale: Scale,
}

impl Rail<'_> {
    fn show(&self, ui: &mut Ui, size: eframe::egui::Vec2, value: f64) -> Option<Edit<f64>> {
        let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let knob = theme::of(ui).sizes.knob;
        let reach = rect.shrink2(vec2(knob, 0.0));
        let id = response.id.with("gesture");
        let is_held = response.is_pointer_button_down_on();
        if is_held && ui.input(|i| i.pointer.any_pressed()) {
            ui.data_mut(|d| d.insert_temp(id, new_gesture()));
        }
        let gesture: Option<Gesture> = ui.data(|d| d.get_temp(id));
        let pointed = response.interact_pointer_pos().filter(|_| is_held || response.clicked());
        let edit = match (pointed, self.keys(ui, &response)) {
            (Some(at), _) => {
                let place = remap(at.x, reach.x_range(), 0.0..=1.0);
                let wanted = self.number.clamped(self.scale.value(f64::from(place)));
                Some(Edit { value: wanted, gesture, finished: !is_held })
            }
            (None, steps) if steps != 0.0 => {
                let place = self.scale.place(value) + steps * 0.01;
                Some(Edit::at_once(self.number.clamped(self.scale.value(place))))
            }
            _ => None,
        };
        self.draw(ui, &response, reach, value);
        response.widget_info(|| WidgetInfo::slider(response.enabled(), value, self.field.label));
        let response = response.on_hover_cursor(CursorIcon::PointingHand);
        describe(response, &tr!("widgets-slider", name = self.field.label), self.field.tooltip);
        edit.filter(|e| e.value != value)
    }

    /// Steps asked for by arrow keys or a screen reader.
    fn keys(&self, ui: &Ui, response: &Response) -> f64 {
        use eframe::egui::accesskit::Action;
        let mut steps = ui.input(|i| {
            i.num_accesskit_action_requests(response.id, Action::Increment) as f64
                - i.num_accesskit_action_requests(response.id, Action::Decrement) as f64
        });
        if response.has_focus() {
            let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
            steps += ui.input_mut(|i| {
                i.count_and_consume_key(Modifiers::NONE, Key::ArrowRight) as f64
                    - i.count_and_consume_key(Modifiers::NONE, Key::ArrowLeft) as f64
            });
        }
        steps
    }

    fn draw(&self, ui: &Ui, response: &Response, reach: Rect, value: f64) {
        let theme = theme::of(ui);
        let sizes = &theme.sizes;
        let at = |place: f64| pos2(reach.left() + reach.width() * place as f32, reach.center().y);
        let knob_at = at(self.scale.place(value));
        let painter = ui.painter();
        let half = sizes.gap_xs;
        let bar = |from: f32, to: f32| {
            Rect::from_min_max(pos2(from, reach.center().y - half), pos2(to, reach.center().y + half))
        };
        let fill = if self.field.shown == Shown::Stated { theme.accent } else { theme.border };
        let (left, right) = (reach.left() - sizes.knob, reach.right() + sizes.knob);
        painter.rect_filled(bar(left, right), sizes.radius, theme.field);
        if self.field.shown != Shown::Mixed {
            painter.rect_filled(bar(left, knob_at.x), sizes.radius, fill);
        }
        let is_hot = response.hovered() || response.is_pointer_button_down_on() || response.has_focus();
        let color = if is_hot { theme.text_strong } else { theme.knob };
        let color = if self.field.shown == Shown::Stated { color } else { theme.text_muted };
        painter.circle(knob_at, sizes.knob, color, Stroke::new(sizes.line_bold, theme.panel));
        if response.has_focus() {
            painter.circle_stroke(knob_at, sizes.knob + sizes.line, Stroke::new(sizes.line, theme.accent));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_on_the_rail_and_its_value_belong_together() {
        for scale in
            [Scale { from: 0.0, to: 1.0 }, Scale { from: 1.0, to: 1000.0 }, Scale { from: 10.0, to: 110.0 }]
        {
            assert_eq!([scale.value(0.0), scale.value(1.0)], [scale.from, scale.to]);
            for place in [0.1, 0.25, 0.5, 0.9] {
                let back = scale.place(scale.value(place));
                assert!((back - place).abs() < 0.02, "{place} came back as {back}");
            }
        }
    }
}
