//! The tools at the lower edge of the picture: Move, Turn, Size and Focus.

use super::{Frame, Tool, Viewport};
use crate::action::{Action, Actions};
use crate::tr;
use crate::widgets::describe;
use eframe::egui::{Align, Button, Key, Layout, Modifiers, Rect, Ui, UiBuilder, pos2};

const TOOLS: [(Tool, &str, Key); 3] = [
    (Tool::Move, "viewport-move", Key::W),
    (Tool::Turn, "viewport-turn", Key::E),
    (Tool::Size, "viewport-size", Key::R),
];

/// Draws the tools, and takes their keys.
pub fn bar_ui(ui: &mut Ui, frame: &Frame, viewport: &mut Viewport, actions: &mut Actions) {
    let sizes = &frame.theme.sizes;
    let row = frame.rect.shrink(sizes.gap_m);
    let row = Rect::from_min_max(pos2(row.left(), row.bottom() - sizes.control), row.max);
    if !ui.ctx().egui_wants_keyboard_input() {
        for (tool, _, key) in TOOLS {
            if ui.input_mut(|i| i.consume_key(Modifiers::NONE, key)) {
                viewport.tool = tool;
            }
        }
    }
    let left = UiBuilder::new().max_rect(row).layout(Layout::left_to_right(Align::Center));
    ui.scope_builder(left, |ui| {
        ui.spacing_mut().item_spacing.x = sizes.gap_s;
        for (tool, key, _) in TOOLS {
            let name = tr!(key);
            let button = ui.add(Button::new(name.as_str()).selected(viewport.tool == tool));
            if describe(button, &name, &tr!(&format!("{key}.tooltip"))).clicked() {
                viewport.tool = tool;
            }
        }
    });
    let right = UiBuilder::new().max_rect(row).layout(Layout::right_to_left(Align::Center));
    ui.scope_builder(right, |ui| {
        let name = tr!("viewport-focus");
        if describe(ui.button(name.as_str()), &name, &tr!("viewport-focus.tooltip")).clicked() {
            actions.push(Action::Frame(frame.movable()));
        }
    });
}
