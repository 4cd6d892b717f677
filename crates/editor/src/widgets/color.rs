//! A colour: a swatch that opens a picker, and its #rrggbb to type.

use super::field::{self, Edit, Field, Shown};
use super::picker::picker_ui;
use super::{describe, new_gesture};
use crate::document::Gesture;
use crate::theme;
use crate::tr;
use eframe::egui::ecolor::{Hsva, HsvaGamma};
use eframe::egui::{
    Align, Color32, Id, Key, Margin, Popup, PopupCloseBehavior, Response, Sense, Stroke, StrokeKind,
    TextEdit, Ui, Vec2, WidgetInfo, WidgetType, vec2,
};
use vitrine::math::Rgb;

/// A label, a swatch and a line for #rrggbb.
pub fn color_field(ui: &mut Ui, field: &Field<'_>, value: Rgb) -> Option<Edit<Rgb>> {
    let sizes = &theme::of(ui).sizes;
    let (swatch_width, gap) = (sizes.control * 1.5, sizes.gap_s);
    let hex_width = sizes.control * 3.0;
    let id = ui.make_persistent_id(("color", field.label));
    let edit = field::labelled(ui, field, swatch_width + gap + hex_width, |ui, width| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            let size = vec2((width - gap - hex_width).max(swatch_width), sizes.control);
            let response = swatch(ui, size, value, field.shown);
            let picked = picker(id, &response, value);
            let name = tr!("widgets-open-picker", name = field.label);
            describe(response, &name, field.tooltip);
            hex(ui, id, field, hex_width, value).or(picked)
        })
        .inner
    });
    field::show_fault(ui, id);
    edit
}

/// A colour as a small area that can be clicked. Mixed colours show none.
pub fn swatch(ui: &mut Ui, size: Vec2, color: Rgb, shown: Shown) -> Response {
    let theme = theme::of(ui);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(WidgetType::ColorButton, ui.is_enabled(), ""));
    let fill = if shown == Shown::Mixed { theme.field } else { display(color) };
    let border = if response.hovered() || response.has_focus() { theme.accent } else { theme.border };
    let stroke = Stroke::new(theme.sizes.line, border);
    ui.painter().rect(rect, theme.sizes.radius, fill, stroke, StrokeKind::Inside);
    if shown == Shown::Mixed {
        ui.painter().line_segment(
            [rect.left_bottom(), rect.right_top()],
            Stroke::new(theme.sizes.line, theme.border),
        );
    }
    response
}

fn display(color: Rgb) -> Color32 {
    theme::shown(color.to_srgb8().map(|v| f32::from(v) / 255.0))
}

/// A picker that is being dragged in: the colour as hue, saturation and value, so that greys keep their hue.
#[derive(Clone, Copy)]
struct Picking {
    color: HsvaGamma,
    of: Rgb,
    gesture: Gesture,
}

fn picker(id: Id, button: &Response, value: Rgb) -> Option<Edit<Rgb>> {
    let [r, g, b] = value.to_array();
    let mut edit = None;
    let popup = Popup::menu(button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    popup.show(|ui| {
        let kept: Option<Picking> = ui.data(|d| d.get_temp(id));
        let fresh = || Picking { color: Hsva::from_rgb([r, g, b]).into(), of: value, gesture: new_gesture() };
        let mut picking = kept.filter(|p| p.of == value).unwrap_or_else(fresh);
        if ui.input(|i| i.pointer.any_pressed()) {
            picking.gesture = new_gesture();
        }
        if picker_ui(ui, &mut picking.color) {
            let [r, g, b] = Hsva::from(picking.color).to_rgb();
            picking.of = Rgb::new(r, g, b);
            let finished = !ui.input(|i| i.pointer.any_down());
            edit = Some(Edit { value: picking.of, gesture: Some(picking.gesture), finished });
        }
        ui.data_mut(|d| d.insert_temp(id, picking));
    });
    edit
}

/// The line with #rrggbb. What is no colour leaves the value as it was and says why.
fn hex(ui: &mut Ui, id: Id, field: &Field<'_>, width: f32, value: Rgb) -> Option<Edit<Rgb>> {
    let theme = theme::of(ui);
    let (sizes, text_id) = (&theme.sizes, id.with("hex"));
    let shown = if field.shown == Shown::Mixed { tr!("widgets-mixed") } else { hex_of(value) };
    let mut text = ui.data(|d| d.get_temp::<String>(text_id)).unwrap_or_else(|| shown.clone());
    let size = vec2(width, sizes.control);
    let color = if field.shown == Shown::Stated { theme.text } else { theme.text_muted };
    let edit = TextEdit::singleline(&mut text).id(text_id).text_color(color).vertical_align(Align::Center);
    let margin = Margin::symmetric((sizes.gap_s + sizes.gap_xs) as i8, 0);
    let response = ui.add_sized(size, edit.margin(margin).min_size(size).desired_width(width));
    let mut answer = None;
    if response.gained_focus() {
        field::select_all(ui, text_id, &text);
    }
    if response.has_focus() {
        if response.changed() {
            ui.data_mut(|d| d.remove::<String>(id.with("fault")));
        }
        ui.data_mut(|d| d.insert_temp(text_id, text));
    } else {
        ui.data_mut(|d| d.remove::<String>(text_id));
        let is_kept = ui.input(|i| i.key_pressed(Key::Escape)) || text == shown;
        if response.lost_focus() && !is_kept {
            match Rgb::from_hex(&with_hash(&text)) {
                Ok(color) => answer = Some(Edit::at_once(color)),
                Err(_) => {
                    ui.data_mut(|d| d.insert_temp(id.with("fault"), tr!("widgets-no-color", text = text)));
                }
            }
        }
    }
    describe(response, field.label, field.tooltip);
    answer
}

/// The nearest "#rrggbb", also of a colour brighter than the display's white.
fn hex_of(color: Rgb) -> String {
    let [r, g, b] = color.to_srgb8();
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn with_hash(text: &str) -> String {
    format!("#{}", text.trim().trim_start_matches('#').to_lowercase())
}
