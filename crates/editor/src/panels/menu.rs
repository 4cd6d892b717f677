//! The menu bar: everything that the window can do, by name.

use super::{Around, RenderState};
use crate::action::{Action, Actions, NewThing, Screen};
use crate::document::EditCommand;
use crate::files::{Config, file_name};
use crate::shortcuts;
use crate::text::{Language, tr};
use crate::theme;
use crate::widgets::describe;
use eframe::egui::{Button, MenuBar, Ui};
use vitrine::scene::{LightSource, ListName, Shape};

/// Draws the menu bar.
pub fn menu_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    MenuBar::new().ui(ui, |ui| {
        menu(ui, "menu-file", |ui| file_ui(ui, around, actions));
        menu(ui, "menu-edit", |ui| edit_ui(ui, around, actions));
        menu(ui, "menu-add", |ui| add_entries_ui(ui, actions));
        menu(ui, "menu-view", |ui| view_ui(ui, around, actions));
        menu(ui, "menu-render", |ui| render_ui(ui, around, actions));
        menu(ui, "menu-help", |ui| help_ui(ui, actions));
        right_ui(ui, around, actions);
    });
}

fn menu(ui: &mut Ui, key: &str, contents: impl FnOnce(&mut Ui)) {
    let name = tr!(key);
    let tooltip = tr!("menu-open-tooltip", name = name.as_str());
    let response = ui.menu_button(name.as_str(), contents).response;
    describe(response, &name, &tooltip);
}

/// An entry: its text, its tooltip (`key.tooltip`) and its keys. True when it was chosen.
fn entry(ui: &mut Ui, key: &str, shortcut: &str, is_enabled: bool) -> bool {
    let keys = shortcuts::shortcut(shortcut).map(|s| s.keys_text(ui.ctx())).unwrap_or_default();
    let name = tr!(key);
    let button = Button::new(name.as_str()).shortcut_text(keys);
    let response = ui.add_enabled(is_enabled, button);
    let clicked = response.clicked();
    describe(response, &name, &tr!(&format!("{key}.tooltip")));
    if clicked {
        ui.close();
    }
    clicked
}

fn file_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let mut on = |clicked: bool, action: Action| {
        if clicked {
            actions.push(action);
        }
    };
    on(entry(ui, "menu-new", "new", true), Action::New);
    on(entry(ui, "menu-open", "open", true), Action::Open);
    let recent = tr!("menu-recent");
    let response = ui.menu_button(recent.as_str(), |ui| {
        if around.recent.is_empty() {
            ui.label(tr!("menu-recent-none"));
        }
        for path in &around.recent {
            let name = file_name(path);
            let response = ui.button(&name);
            on(response.clicked(), Action::OpenFile(path.clone()));
            if response.clicked() {
                ui.close();
            }
            describe(response, &name, &path.display().to_string());
        }
    });
    describe(response.response, &recent, &tr!("menu-recent.tooltip"));
    ui.separator();
    on(entry(ui, "menu-save", "save", true), Action::Save);
    on(entry(ui, "menu-save-as", "save-as", true), Action::SaveAs);
    on(entry(ui, "menu-save-picture", "save-picture", true), Action::SavePicture);
    ui.separator();
    on(entry(ui, "menu-quit", "quit", true), Action::Quit);
}

fn edit_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let document = around.document;
    let history = document.history();
    let things = around.selected_items();
    let has = !things.is_empty();
    let has_group = things.iter().any(|t| t.list() == Some(ListName::Group));
    let mut on = |clicked: bool, action: Action| {
        if clicked {
            actions.push(action);
        }
    };
    on(entry(ui, "menu-undo", "undo", history.undoable() > 0), Action::Undo);
    on(entry(ui, "menu-redo", "redo", history.redoable() > 0), Action::Redo);
    ui.separator();
    on(entry(ui, "menu-cut", "cut", has), Action::Cut);
    on(entry(ui, "menu-copy", "copy", has), Action::Copy);
    on(entry(ui, "menu-paste", "paste", true), Action::Paste);
    let edit = |command: fn(Vec<_>) -> EditCommand| Action::Edit(command(things.clone()));
    on(entry(ui, "menu-duplicate", "duplicate", has), edit(EditCommand::Duplicate));
    on(entry(ui, "menu-delete", "delete", has), edit(EditCommand::Delete));
    on(entry(ui, "menu-select-all", "select-all", true), Action::SelectAll);
    ui.separator();
    on(entry(ui, "menu-group", "group", has), edit(EditCommand::Group));
    on(entry(ui, "menu-ungroup", "ungroup", has_group), edit(EditCommand::Ungroup));
    on(entry(ui, "menu-drop", "drop", has), edit(EditCommand::DropToFloor));
    ui.separator();
    let last = document.selection().last().cloned();
    let change = last.clone().map_or(Action::SelectAll, Action::EditDialog);
    on(entry(ui, "menu-change", "", has), change);
    let model = last.filter(|_| around.has_model_selected());
    on(
        entry(ui, "menu-model-settings", "", model.is_some()),
        model.map_or(Action::LoadModel, Action::ModelSettings),
    );
    ui.separator();
    on(entry(ui, "menu-settings", "settings", true), Action::Show(Screen::Settings));
}

/// Every kind of object and light, in the order of their registers, each opening its dialog.
pub fn add_entries_ui(ui: &mut Ui, actions: &mut Actions) {
    let objects = Shape::KINDS.iter().map(|k| NewThing { list: ListName::Object, kind: k.name });
    for new in objects {
        kind_entry_ui(ui, new, Action::AddDialog, actions);
    }
    ui.separator();
    lights_ui(ui, Action::AddDialog, actions);
}

/// Every kind of light, each doing what `action` says.
pub fn lights_ui(ui: &mut Ui, action: fn(NewThing) -> Action, actions: &mut Actions) {
    for kind in LightSource::KINDS {
        kind_entry_ui(ui, NewThing { list: ListName::Light, kind: kind.name }, action, actions);
    }
}

fn kind_entry_ui(ui: &mut Ui, new: NewThing, action: fn(NewThing) -> Action, actions: &mut Actions) {
    let name = new.name();
    let response = ui.add(Button::new(format!("{}  {name}", new.icon())));
    if response.clicked() {
        actions.push(new.action(action));
        ui.close();
    }
    describe(response, &name, &tr!("menu-add-tooltip", name = name.as_str()));
}

/// What a switch does to the settings.
type Change = fn(&mut Config);

fn view_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    if entry(ui, "menu-frame-all", "frame-all", true) {
        actions.push(Action::Frame(Vec::new()));
    }
    let things = around.document.selection().things();
    if entry(ui, "menu-focus", "frame", !things.is_empty()) {
        actions.push(Action::Frame(things.to_vec()));
    }
    ui.separator();
    let config = around.config;
    let switches: [(&str, bool, Change); 2] = [
        ("menu-large-text", config.large_text, |c| c.large_text = !c.large_text),
        ("menu-high-contrast", config.high_contrast, |c| c.high_contrast = !c.high_contrast),
    ];
    for (key, is_on, change) in switches {
        let name = tr!(key);
        let response = ui.add(Button::selectable(is_on, name.as_str()));
        if response.clicked() {
            actions.push(configure(config, change));
            ui.close();
        }
        describe(response, &name, &tr!(&format!("{key}.tooltip")));
    }
}

fn configure(config: &Config, change: impl FnOnce(&mut Config)) -> Action {
    let mut config = config.clone();
    change(&mut config);
    Action::Configure(Box::new(config))
}

fn render_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let mut on = |clicked: bool, action: Action| {
        if clicked {
            actions.push(action);
        }
    };
    let state = around.render;
    on(entry(ui, "menu-start", "start", state != RenderState::Running), Action::StartRender);
    on(entry(ui, "menu-stop", "stop", state == RenderState::Running), Action::StopRender);
    on(entry(ui, "menu-continue", "", state == RenderState::Stopped), Action::ContinueRender);
    ui.separator();
    on(entry(ui, "menu-save-picture", "save-picture", true), Action::SavePicture);
    on(entry(ui, "menu-problems", "", true), Action::Show(Screen::Problems));
}

fn help_ui(ui: &mut Ui, actions: &mut Actions) {
    for (key, shortcut, screen) in [
        ("menu-tour", "", Screen::Tour),
        ("menu-shortcuts", "help", Screen::Shortcuts),
        ("menu-glossary", "", Screen::Glossary),
        ("menu-about", "", Screen::About),
    ] {
        if entry(ui, key, shortcut, true) {
            actions.push(Action::Show(screen));
        }
    }
}

/// The scene's name in the middle, the languages at the right end.
fn right_ui(ui: &mut Ui, around: &Around, actions: &mut Actions) {
    let layout = eframe::egui::Layout::right_to_left(eframe::egui::Align::Center);
    ui.with_layout(layout, |ui| {
        for language in Language::ALL.into_iter().rev() {
            let tag = language.tag().to_uppercase();
            let response = ui.add(Button::selectable(around.config.language == language, tag));
            if response.clicked() {
                actions.push(configure(around.config, |c| c.language = language));
            }
            let name = tr!("menu-language", name = language.own_name());
            describe(response, &name, &tr!("menu-language.tooltip"));
        }
        ui.add_space(theme::of(ui).sizes.gap_l);
        let theme = theme::of(ui);
        let changed = if around.document.is_changed() { " •" } else { "" };
        let title = eframe::egui::RichText::new(format!("{}{changed}", around.title)).color(theme.text_muted);
        ui.add(eframe::egui::Label::new(title).truncate().selectable(false));
    });
}
