//! The list: what is in the scene, with its switches, names and groups.

mod rows;

pub use rows::{Row, rows};

use crate::action::{Action, Actions};
use crate::document::{Document, EditCommand, Thing};
use crate::panels::menu::add_entries_ui;
use crate::shortcuts;
use crate::text::tr;
use crate::theme::{self, icons};
use crate::widgets::{describe, empty_hint, icon_button, icon_toggle, search_field};
use eframe::egui::{
    self, Align, Align2, Button, FontId, Key, Layout, Modifiers, Popup, Rect, Response, ScrollArea, Sense,
    TextEdit, Ui, WidgetInfo, WidgetType, pos2, vec2,
};
use std::collections::HashSet;
use vitrine::scene::ListName;

/// What the list remembers between frames.
#[derive(Debug, Default)]
pub struct ListState {
    search: String,
    /// Names of groups whose rows are folded.
    closed: HashSet<String>,
    /// What is being renamed, and the text so far.
    renaming: Option<(Thing, String)>,
    /// Where a range of rows began: the last one that was clicked without Shift.
    anchor: Option<Thing>,
}

impl ListState {
    /// Begins to rename a thing.
    pub fn rename(&mut self, thing: &Thing) {
        if let Some(name) = thing.name() {
            self.renaming = Some((thing.clone(), name.to_owned()));
        }
    }
}

/// Draws the list.
pub fn list_ui(ui: &mut Ui, document: &Document, state: &mut ListState, actions: &mut Actions) {
    let sizes = &theme::of(ui).sizes;
    search_field(ui, &mut state.search, &tr!("list-search"), &tr!("list-search.tooltip"));
    ui.add_space(sizes.gap_s);
    let foot = sizes.control + sizes.gap_l;
    let rows = rows(document.scene(), &state.closed, &state.search);
    let room = ui.available_height() - foot;
    ScrollArea::vertical()
        .id_salt("list")
        .max_height(room)
        .min_scrolled_height(room)
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            if rows.is_empty() {
                empty_hint(ui, &tr!("list-nothing-found"));
            }
            for row in &rows {
                row_ui(ui, document, row, &rows, (state, actions));
            }
        });
    foot_ui(ui, document, actions);
    // F2 belongs to the list unless something is being typed.
    let wants = !ui.ctx().text_edit_focused() && ui.ctx().memory(|m| m.top_modal_layer().is_none());
    if wants
        && ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::F2))
        && let Some(last) = document.selection().last()
    {
        state.rename(last);
    }
}

/// One row: eye, icon, name.
fn row_ui(
    ui: &mut Ui,
    document: &Document,
    row: &Row,
    rows: &[Row],
    (state, actions): (&mut ListState, &mut Actions),
) {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), sizes.row), Sense::hover());
    if !ui.is_rect_visible(rect) {
        return;
    }
    let is_selected = document.selection().contains(&row.thing);
    let name = row.thing.name().map_or_else(|| tr!("list-camera"), str::to_owned);
    let eye_width = sizes.control;
    let body = Rect::from_min_max(pos2(rect.left() + eye_width, rect.top()), rect.max);
    let response =
        ui.interact(body, ui.id().with(("row", &row.thing.list().map(ListName::key), &name)), Sense::click());
    let fill = match (is_selected, response.hovered()) {
        (true, _) => Some(theme.selection),
        (false, true) => Some(theme.raised),
        (false, false) => None,
    };
    if let Some(fill) = fill {
        ui.painter().rect_filled(rect, sizes.radius, fill);
    }
    eye_ui(ui, rect, row, &name, actions);
    let mut left = body.left() + row.depth as f32 * sizes.gap_l;
    if row.thing.list() == Some(ListName::Group) {
        fold_ui(ui, pos2(left, body.center().y), row, &name, state);
        left += sizes.icon;
    }
    let shown = row.visible != Some(false);
    let color = match (is_selected, shown) {
        (true, _) => theme.on_selection,
        (false, true) => theme.text,
        (false, false) => theme.text_muted,
    };
    let icon_at = pos2(left + sizes.gap_s, body.center().y);
    ui.painter().text(icon_at, Align2::LEFT_CENTER, row.icon(), theme::icon_font(sizes.icon), color);
    let text_left = left + sizes.gap_s + sizes.icon + sizes.gap_s + sizes.gap_xs;
    let text_rect = Rect::from_min_max(pos2(text_left, body.top()), body.max);
    if state.renaming.as_ref().is_some_and(|(thing, _)| *thing == row.thing) {
        rename_ui(ui, text_rect, state, actions);
        return;
    }
    let font = FontId::proportional(sizes.text);
    let mut job = egui::text::LayoutJob::simple_singleline(name.clone(), font, color);
    job.wrap = egui::text::TextWrapping::truncate_at_width(text_rect.width() - sizes.gap_s);
    let galley = ui.painter().layout_job(job);
    let at = pos2(text_rect.left(), text_rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
    let is_enabled = ui.is_enabled();
    response.widget_info(|| {
        WidgetInfo::selected(WidgetType::SelectableLabel, is_enabled, is_selected, name.as_str())
    });
    let tooltip = if row.thing == Thing::Camera { tr!("list-row-camera") } else { tr!("list-select") };
    answer(ui, &response, row, rows, (state, actions));
    context_ui(&response, document, row, (state, actions));
    describe(response, &name, &tooltip);
}

/// The switch that shows and hides.
fn eye_ui(ui: &mut Ui, rect: Rect, row: &Row, name: &str, actions: &mut Actions) {
    let Some(visible) = row.visible else { return };
    let sizes = &theme::of(ui).sizes;
    let place = Rect::from_min_size(rect.min, vec2(sizes.control, rect.height()));
    let mut eye =
        ui.new_child(egui::UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center)));
    let (icon, key) = if visible { (icons::SHOWN, "list-hide") } else { (icons::HIDDEN, "list-show") };
    let tooltip = tr!(&format!("{key}.tooltip"));
    if icon_toggle(&mut eye, icon, visible, &tr!(key, name = name), &tooltip).clicked() {
        let things = vec![row.thing.clone()];
        actions.push(Action::Edit(EditCommand::Show { things, visible: !visible }));
    }
}

/// The arrow before a group.
fn fold_ui(ui: &mut Ui, at: egui::Pos2, row: &Row, name: &str, state: &mut ListState) {
    let sizes = &theme::of(ui).sizes;
    let place = Rect::from_center_size(pos2(at.x + sizes.icon / 2.0, at.y), egui::Vec2::splat(sizes.icon));
    let (icon, key) = if row.is_closed {
        (icons::OPEN_RIGHT, "list-open-group")
    } else {
        (icons::OPEN_DOWN, "list-close-group")
    };
    let response = ui.interact(place, ui.id().with(("fold", name)), Sense::click());
    let color = theme::of(ui).text_muted;
    ui.painter().text(place.center(), Align2::CENTER_CENTER, icon, theme::icon_font(sizes.text_small), color);
    let label = tr!(key, name = name);
    let is_enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, is_enabled, label.as_str()));
    if response.clicked() && !state.closed.remove(name) {
        state.closed.insert(name.to_owned());
    }
    describe(response, &label, &tr!(&format!("{key}.tooltip")));
}

/// The field in place of a name that is being changed.
fn rename_ui(ui: &mut Ui, rect: Rect, state: &mut ListState, actions: &mut Actions) {
    let Some((thing, text)) = &mut state.renaming else { return };
    let old = thing.name().unwrap_or_default().to_owned();
    let id = ui.id().with("rename");
    let is_new = ui.ctx().data(|d| d.get_temp::<String>(id)) != Some(old.clone());
    let edit = TextEdit::singleline(text).id(id.with(&old)).margin(egui::Margin::symmetric(4, 2));
    let response = ui.put(rect, edit);
    if is_new {
        ui.ctx().data_mut(|d| d.insert_temp(id, old.clone()));
        response.request_focus();
    }
    let (escape, enter) = ui.input(|i| (i.key_pressed(Key::Escape), i.key_pressed(Key::Enter)));
    let name = text.trim().to_owned();
    let is_done = enter || escape || (!is_new && !response.has_focus());
    if is_done {
        if !escape && !name.is_empty() && name != old {
            actions.push(Action::Edit(EditCommand::Rename { thing: thing.clone(), name }));
        }
        state.renaming = None;
        ui.ctx().data_mut(|d| d.remove::<String>(id));
    }
    let label = tr!("list-new-name", name = old.as_str());
    describe(response, &label, &tr!("list-new-name.tooltip"));
}

/// What clicks on a row mean.
fn answer(
    ui: &Ui,
    response: &Response,
    row: &Row,
    rows: &[Row],
    (state, actions): (&mut ListState, &mut Actions),
) {
    if response.double_clicked() && row.thing != Thing::Camera {
        state.rename(&row.thing);
        return;
    }
    if !response.clicked() && !response.secondary_clicked() {
        return;
    }
    let modifiers = ui.input(|i| i.modifiers);
    if response.secondary_clicked() {
        actions.push(Action::Select(vec![row.thing.clone()]));
    } else if modifiers.command {
        actions.push(Action::ToggleSelect(row.thing.clone()));
        state.anchor = Some(row.thing.clone());
    } else if modifiers.shift {
        let place = |thing: &Thing| rows.iter().position(|r| r.thing == *thing);
        let to = place(&row.thing).unwrap_or(0);
        let from = state.anchor.as_ref().and_then(place).unwrap_or(to);
        let range = rows[from.min(to)..=from.max(to)].iter().map(|r| r.thing.clone());
        actions.push(Action::Select(range.filter(|t| *t != Thing::Camera).collect()));
    } else {
        actions.push(Action::Select(vec![row.thing.clone()]));
        state.anchor = Some(row.thing.clone());
    }
}

/// The menu of a row.
fn context_ui(
    response: &Response,
    document: &Document,
    row: &Row,
    (state, actions): (&mut ListState, &mut Actions),
) {
    if row.thing == Thing::Camera {
        return;
    }
    let selection = document.selection();
    let things =
        if selection.contains(&row.thing) { selection.things().to_vec() } else { vec![row.thing.clone()] };
    Popup::context_menu(response).show(|ui| {
        let mut entry = |ui: &mut Ui, key: &str, id: &str, action: Option<Action>| {
            let keys = shortcuts::shortcut(id).map(|s| s.keys_text(ui.ctx())).unwrap_or_default();
            let name = tr!(key);
            let response = ui.add(Button::new(name.as_str()).shortcut_text(keys));
            let clicked = response.clicked();
            describe(response, &name, &tr!(&format!("{key}.tooltip")));
            if clicked {
                actions.extend(action);
                ui.close();
            }
            clicked
        };
        let edit = |command: fn(Vec<Thing>) -> EditCommand| Some(Action::Edit(command(things.clone())));
        entry(ui, "menu-change", "", Some(Action::EditDialog(row.thing.clone())));
        entry(ui, "menu-focus", "frame", Some(Action::Frame(things.clone())));
        if entry(ui, "menu-rename", "rename", None) {
            state.rename(&row.thing);
        }
        ui.separator();
        entry(ui, "menu-duplicate", "duplicate", edit(EditCommand::Duplicate));
        entry(ui, "menu-delete", "delete", edit(EditCommand::Delete));
        entry(ui, "menu-drop", "drop", edit(EditCommand::DropToFloor));
        ui.separator();
        entry(ui, "menu-group", "group", edit(EditCommand::Group));
        if row.thing.list() == Some(ListName::Group) {
            entry(ui, "menu-ungroup", "ungroup", edit(EditCommand::Ungroup));
        }
    });
}

/// «Add», «Edit», duplicate, «Delete».
fn foot_ui(ui: &mut Ui, document: &Document, actions: &mut Actions) {
    let sizes = &theme::of(ui).sizes;
    ui.add_space(sizes.gap_s);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = sizes.gap_xs;
        let name = tr!("list-add");
        let add = egui::RichText::new(format!("{}  {name}", icons::ADD));
        let response = ui.menu_button(add, |ui| {
            add_entries_ui(ui, actions);
        });
        describe(response.response, &name, &tr!("list-add.tooltip"));
        let selection = document.selection();
        let things: Vec<_> = selection.things().iter().filter(|t| t.list().is_some()).cloned().collect();
        ui.add_enabled_ui(!things.is_empty(), |ui| {
            let tools = [
                (icons::EDIT, "list-edit", things.last().cloned().map(Action::EditDialog)),
                (
                    icons::DUPLICATE,
                    "list-duplicate",
                    Some(Action::Edit(EditCommand::Duplicate(things.clone()))),
                ),
                (icons::DELETE, "list-delete", Some(Action::Edit(EditCommand::Delete(things.clone())))),
            ];
            for (icon, key, action) in tools {
                if icon_button(ui, icon, &tr!(key), &tr!(&format!("{key}.tooltip")), "").clicked() {
                    actions.extend(action);
                }
            }
        });
    });
}
