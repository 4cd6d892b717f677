//! The picker of colours: a square of strength and lightness, and a bar of hues.

use super::describe;
use crate::theme;
use crate::tr;
use eframe::egui::ecolor::HsvaGamma;
use eframe::egui::{
    Color32, Mesh, Pos2, Response, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, WidgetType, vec2,
};

/// Draws the picker; true when the colour has been changed.
pub(super) fn picker_ui(ui: &mut Ui, color: &mut HsvaGamma) -> bool {
    let sizes = &theme::of(ui).sizes;
    let width = sizes.control * 8.0;
    let before = *color;
    let hue = before.h;
    let shade = |x: f32, y: f32| Color32::from(HsvaGamma { h: hue, s: x, v: 1.0 - y, a: 1.0 });
    let (square, at) = area(ui, vec2(width, sizes.control * 5.0), [12, 12], &shade);
    if let Some(at) = at {
        (color.s, color.v) = (at.x, 1.0 - at.y);
    }
    mark(ui, square.rect.lerp_inside(vec2(color.s, 1.0 - color.v)), shade(color.s, 1.0 - color.v));
    finish(square, &tr!("widgets-picker-shade"), &tr!("widgets-picker-shade.tooltip"));
    let rainbow = |x: f32, _: f32| Color32::from(HsvaGamma { h: x, s: 1.0, v: 1.0, a: 1.0 });
    let (bar, at) = area(ui, vec2(width, sizes.icon), [36, 1], &rainbow);
    if let Some(at) = at {
        // The bar's end is the hue of its beginning.
        color.h = at.x.min(0.999);
    }
    mark(ui, bar.rect.lerp_inside(vec2(color.h, 0.5)), rainbow(color.h, 0.0));
    finish(bar, &tr!("widgets-picker-hue"), &tr!("widgets-picker-hue.tooltip"));
    *color != before
}

/// An area of colours, and the place in it that is pointed at, each direction 0 to 1.
fn area(
    ui: &mut Ui,
    size: Vec2,
    [columns, rows]: [usize; 2],
    color: &dyn Fn(f32, f32) -> Color32,
) -> (Response, Option<Vec2>) {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let mut mesh = Mesh::default();
    let place = |i: usize, n: usize| i as f32 / n as f32;
    for y in 0..=rows {
        for x in 0..=columns {
            let (u, v) = (place(x, columns), place(y, rows));
            mesh.colored_vertex(rect.lerp_inside(vec2(u, v)), color(u, v));
        }
    }
    let corner = |x: usize, y: usize| (y * (columns + 1) + x) as u32;
    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
        mesh.add_triangle(corner(x, y), corner(x + 1, y), corner(x, y + 1));
        mesh.add_triangle(corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1));
    }
    ui.painter().add(Shape::mesh(mesh));
    let is_held = response.is_pointer_button_down_on() || response.clicked();
    let pointed = response.interact_pointer_pos().filter(|_| is_held);
    let at = pointed.map(|p| ((p - rect.min) / rect.size()).clamp(Vec2::ZERO, Vec2::splat(1.0)));
    (response, at)
}

/// A ring around the colour that is chosen.
fn mark(ui: &Ui, at: Pos2, color: Color32) {
    let theme = theme::of(ui);
    let ring = Stroke::new(theme.sizes.line_bold, theme.handle);
    ui.painter().circle(at, theme.sizes.knob, theme.outline_seam, Stroke::NONE);
    ui.painter().circle(at, theme.sizes.knob - theme.sizes.line, color, ring);
}

fn finish(response: Response, name: &str, tooltip: &str) {
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Slider, response.enabled(), name));
    describe(response, name, tooltip);
}
