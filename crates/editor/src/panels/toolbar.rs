//! The row of tools: files, undo, what can be added with one click, the render.

use super::menu::lights_ui;
use super::{Around, RenderState};
use crate::action::{Action, Actions, NewThing};
use crate::dialogs::tour;
use crate::shortcuts;
use crate::text::{tr, try_tr};
use crate::theme::{self, icons};
use crate::widgets::{describe, icon_button, tool_button};
use eframe::egui::containers::menu::MenuButton;
use eframe::egui::{Button, RichText, Ui, vec2};
use vitrine::scene::{ListName, Shape};

/// Draws the row of tools.
pub fn toolbar_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = theme::of(ui).sizes.gap_xs;
        files_ui(ui, actions);
        ui.separator();
        history_ui(ui, around, actions);
        ui.separator();
        add_ui(ui, actions);
        ui.separator();
        render_ui(ui, around, actions);
    });
}

fn keys(ui: &Ui, id: &str) -> String {
    shortcuts::shortcut(id).map(|s| s.keys_text(ui.ctx())).unwrap_or_default()
}

fn files_ui(ui: &mut Ui, actions: &mut Actions) {
    let tools = [
        (icons::NEW, "toolbar-new", "menu-new", "new", Action::New),
        (icons::OPEN, "toolbar-open", "menu-open", "open", Action::Open),
        (icons::SAVE, "toolbar-save", "menu-save", "save", Action::Save),
    ];
    for (icon, name, about, id, action) in tools {
        let (tooltip, keys) = (tr!(&format!("{about}.tooltip")), keys(ui, id));
        if icon_button(ui, icon, &tr!(name), &tooltip, &keys).clicked() {
            actions.push(action);
        }
    }
}

fn history_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let history = around.document.history();
    let tools = [
        (icons::UNDO, "menu-undo", "undo", history.undoable() > 0, Action::Undo),
        (icons::REDO, "menu-redo", "redo", history.redoable() > 0, Action::Redo),
    ];
    for (icon, key, id, is_enabled, action) in tools {
        ui.add_enabled_ui(is_enabled, |ui| {
            let (tooltip, keys) = (tr!(&format!("{key}.tooltip")), keys(ui, id));
            if icon_button(ui, icon, &tr!(key), &tooltip, &keys).clicked() {
                actions.push(action);
            }
        });
    }
}

/// One tool for each kind of object; the lights share one, with a menu.
fn add_ui(ui: &mut Ui, actions: &mut Actions) {
    for kind in Shape::KINDS {
        let new = NewThing { list: ListName::Object, kind: kind.name };
        let word = new.kind;
        let name = try_tr(&format!("toolbar-{word}")).unwrap_or_else(|| new.name());
        let tooltip = try_tr(&format!("toolbar-{word}.tooltip"));
        let tooltip = tooltip.unwrap_or_else(|| tr!("menu-add-tooltip", name = name.as_str()));
        let response = tool_button(ui, new.icon(), &name, &tooltip, "");
        if word == "sphere" {
            tour::mark(ui.ctx(), "add-sphere", response.rect);
        }
        if response.clicked() {
            actions.push(new.action(Action::AddQuick));
        }
    }
    let name = tr!("toolbar-light");
    let sizes = &theme::of(ui).sizes;
    let icon = RichText::new(icons::POINT).font(theme::icon_font(sizes.icon_tool));
    let button = Button::new((icon, RichText::new(name.as_str()))).gap(sizes.gap_s + sizes.gap_xs);
    let button = button.frame_when_inactive(false).min_size(vec2(sizes.tool, sizes.tool));
    let (response, _) = MenuButton::from_button(button).ui(ui, |ui| lights_ui(ui, Action::AddQuick, actions));
    describe(response, &name, &tr!("toolbar-light.tooltip"));
}

fn render_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let (icon, name, about, id, action) = match around.render {
        RenderState::Running => (icons::STOP, "toolbar-stop", "menu-stop", "stop", Action::StopRender),
        RenderState::Idle | RenderState::Stopped => {
            (icons::START, "toolbar-start", "menu-start", "start", Action::StartRender)
        }
    };
    let (tooltip, shortcut) = (tr!(&format!("{about}.tooltip")), keys(ui, id));
    let response = tool_button(ui, icon, &tr!(name), &tooltip, &shortcut);
    tour::mark(ui.ctx(), "start-render", response.rect);
    if response.clicked() {
        actions.push(action);
    }
    if around.render == RenderState::Stopped
        && tool_button(ui, icons::OPEN_RIGHT, &tr!("toolbar-continue"), &tr!("menu-continue.tooltip"), "")
            .clicked()
    {
        actions.push(Action::ContinueRender);
    }
    let (tooltip, shortcut) = (tr!("menu-save-picture.tooltip"), keys(ui, "save-picture"));
    let response = tool_button(ui, icons::SAVE_PICTURE, &tr!("toolbar-picture"), &tooltip, &shortcut);
    tour::mark(ui.ctx(), "save-picture", response.rect);
    if response.clicked() {
        actions.push(Action::SavePicture);
    }
}
