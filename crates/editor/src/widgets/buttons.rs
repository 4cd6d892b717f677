//! Buttons and switches.

use super::describe;
use crate::theme::{self, icon_font};
use eframe::egui::{
    Button, Color32, CornerRadius, IntoAtoms, Response, RichText, Sense, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, WidgetType, vec2,
};

/// A button that is an icon. `shortcut` is the key that does the same, or empty.
pub fn icon_button(ui: &mut Ui, icon: &str, name: &str, tooltip: &str, shortcut: &str) -> Response {
    let sizes = &theme::of(ui).sizes;
    let text = RichText::new(icon).font(icon_font(sizes.icon));
    let button = Button::new(text).frame_when_inactive(false).min_size(Vec2::splat(sizes.control));
    describe(ui.add(button), name, &with_shortcut(tooltip, shortcut))
}

/// An icon that is on or off, such as the eye of a row. What it looks like when on is the caller's choice of icon.
pub fn icon_toggle(ui: &mut Ui, icon: &str, on: bool, name: &str, tooltip: &str) -> Response {
    let theme = theme::of(ui);
    let color = if on { theme.text } else { theme.text_muted };
    let text = RichText::new(icon).font(icon_font(theme.sizes.icon)).color(color);
    let button = Button::new(text).frame_when_inactive(false).min_size(Vec2::splat(theme.sizes.control));
    let response = ui.add(button);
    response.widget_info(|| WidgetInfo::selected(WidgetType::Checkbox, ui.is_enabled(), on, name));
    describe(response, name, tooltip)
}

/// A button of the toolbar: an icon and a word.
pub fn tool_button(ui: &mut Ui, icon: &str, name: &str, tooltip: &str, shortcut: &str) -> Response {
    let sizes = &theme::of(ui).sizes;
    let icon = RichText::new(icon).font(icon_font(sizes.icon_tool));
    let atoms = (icon, RichText::new(name)).into_atoms();
    let button = Button::new(atoms).gap(sizes.gap_s + sizes.gap_xs).frame_when_inactive(false);
    let response = ui.add(button.min_size(vec2(sizes.tool, sizes.tool)));
    describe(response, name, &with_shortcut(tooltip, shortcut))
}

/// A button with a word.
pub fn text_button(ui: &mut Ui, name: &str, tooltip: &str) -> Response {
    let sizes = &theme::of(ui).sizes;
    let button = Button::new(name).min_size(vec2(0.0, sizes.control));
    describe(ui.add(button), name, tooltip)
}

/// The button that a dialog is there for.
pub fn primary_button(ui: &mut Ui, name: &str, tooltip: &str) -> Response {
    let theme = theme::of(ui);
    let text = RichText::new(name).color(theme.on_accent);
    let button = Button::new(text).fill(theme.accent).stroke(Stroke::NONE);
    describe(ui.add(button.min_size(vec2(0.0, theme.sizes.control))), name, tooltip)
}

/// A word that does something, without a frame, in the accent's colour.
pub fn link_button(ui: &mut Ui, name: &str, tooltip: &str) -> Response {
    let theme = theme::of(ui);
    let text = RichText::new(name).color(theme.accent);
    let button = Button::new(text).frame(false);
    describe(ui.add(button), name, tooltip)
}

/// A switch with its label; the response tells whether `on` has been changed.
pub fn toggle(ui: &mut Ui, on: &mut bool, name: &str, tooltip: &str) -> Response {
    let theme = theme::of(ui);
    let height = theme.sizes.control;
    let track = vec2(height * 1.25, height * 0.7);
    let font = eframe::egui::FontId::proportional(theme.sizes.text);
    let room = ui.available_width() - track.x - theme.sizes.gap_m;
    let galley = ui.painter().layout(name.to_owned(), font, theme.text, room);
    let size = vec2(ui.available_width(), galley.size().y.max(height));
    let (rect, mut response) = ui.allocate_exact_size(size, Sense::click());
    if response.clicked() {
        *on = !*on;
        response.mark_changed();
    }
    response.widget_info(|| WidgetInfo::selected(WidgetType::Checkbox, ui.is_enabled(), *on, name));
    let text_at = rect.left_center() - vec2(0.0, galley.size().y / 2.0);
    ui.painter().galley(text_at, galley, theme.text);
    let place = eframe::egui::Align2::RIGHT_CENTER.align_size_within_rect(track, rect);
    let how_far = ui.animate_bool_responsive(response.id, *on);
    let fill = if *on { theme.accent } else { theme.field };
    let border = if response.has_focus() { theme.accent } else { theme.border };
    let radius = CornerRadius::same((track.y / 2.0) as u8);
    ui.painter().rect(place, radius, fill, Stroke::new(theme.sizes.line, border), StrokeKind::Inside);
    let knob_radius = track.y / 2.0 - theme.sizes.gap_xs - theme.sizes.line;
    let reach = place.shrink2(vec2(track.y / 2.0, 0.0));
    let knob = eframe::egui::pos2(reach.left() + reach.width() * how_far, place.center().y);
    let color: Color32 = if *on { theme.on_accent } else { theme.text_muted };
    ui.painter().circle_filled(knob, knob_radius, color);
    describe(response, name, tooltip)
}

fn with_shortcut(tooltip: &str, shortcut: &str) -> String {
    if shortcut.is_empty() { tooltip.to_owned() } else { format!("{tooltip} ({shortcut})") }
}
