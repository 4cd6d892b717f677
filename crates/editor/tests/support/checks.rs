//! Checks that hold for every window: nothing is clipped, everything is named.

use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{Context, Rect, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;

/// Texts of the last frame that are cut short with "…", or that stick out of the screen or sideways out of the part in which
/// they are drawn. What can be scrolled to, up or down, is not cut.
pub fn labels_clipped<State>(harness: &Harness<'_, State>) -> Vec<String> {
    let screen = harness.ctx.content_rect();
    let mut found = Vec::new();
    for ClippedShape { clip_rect, shape } in &harness.output().shapes {
        texts(shape, &mut |text| {
            if let Some(why) = fault(&harness.ctx, text, *clip_rect, screen) {
                found.push(format!("{:?} {why}", text.galley.text()));
            }
        });
    }
    found
}

fn texts(shape: &Shape, each: &mut dyn FnMut(&TextShape)) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|s| texts(s, each)),
        Shape::Text(text) if !text.galley.text().trim().is_empty() => each(text),
        _ => {}
    }
}

fn fault(ctx: &Context, text: &TextShape, clip: Rect, screen: Rect) -> Option<String> {
    if text.galley.elided {
        return Some("is cut short".into());
    }
    // Rounding to pixels and the overhang of letters.
    let slack = 1.5 / ctx.pixels_per_point();
    let bounds = text.visual_bounding_rect();
    let is_scrolled_away = bounds.bottom() <= clip.top() || bounds.top() >= clip.bottom();
    if is_scrolled_away || !bounds.is_positive() {
        return None;
    }
    let sideways = clip.intersect(screen).expand(slack);
    if bounds.left() < sideways.left() || bounds.right() > sideways.right() {
        return Some(format!("sticks out sideways: {bounds:?} in {sideways:?}"));
    }
    let screen = screen.expand(slack);
    let is_outside = bounds.top() < screen.top() || bounds.bottom() > screen.bottom();
    let is_scrolled = clip.top() > screen.top() + slack || clip.bottom() < screen.bottom() - slack;
    (is_outside && !is_scrolled).then(|| format!("sticks out of the screen: {bounds:?}"))
}

/// Controls of the last frame that have no accessible name or no tooltip (which screen readers know as the description).
pub fn controls_without_name_or_tooltip<State>(harness: &Harness<'_, State>) -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![harness.root().accesskit_node()];
    while let Some(node) = open.pop() {
        open.extend(node.children());
        if !is_control(node.role()) || node.is_hidden() {
            continue;
        }
        let name = node.label().unwrap_or_default();
        let description = node.description().unwrap_or_default();
        if name.trim().is_empty() || description.trim().is_empty() {
            found.push(format!(
                "{:?} named {name:?}, described {description:?}, value {:?}",
                node.role(),
                node.value()
            ));
        }
    }
    found
}

/// What a person can use. A link is named by its text.
fn is_control(role: Role) -> bool {
    matches!(
        role,
        Role::Button
            | Role::CheckBox
            | Role::ColorWell
            | Role::ComboBox
            | Role::DefaultButton
            | Role::MultilineTextInput
            | Role::RadioButton
            | Role::Slider
            | Role::SpinButton
            | Role::TextInput
            | Role::SearchInput
    )
}
