//! Fields for text, files and searching.

use super::field::{self, Edit, Field, Shown};
use super::{describe, icon_button, new_gesture};
use crate::document::Gesture;
use crate::theme::{self, icons};
use crate::tr;
use eframe::egui::{Align, Id, Key, Margin, Response, TextEdit, Ui, WidgetInfo, WidgetType, vec2};

/// What is being typed.
#[derive(Clone)]
struct Typing {
    text: String,
    of: String,
    gesture: Gesture,
}

/// A label and a line of text. The value comes once typing has ended, with Enter or elsewhere; Esc keeps the old.
pub fn text_field(ui: &mut Ui, field: &Field<'_>, value: &str) -> Option<Edit<String>> {
    if field.label.is_empty() {
        let width = ui.available_width();
        return line(ui, field, width, value);
    }
    let width = (ui.available_width() * 0.72).floor();
    field::labelled(ui, field, width, |ui, width| line(ui, field, width, value))
}

fn line(ui: &mut Ui, field: &Field<'_>, width: f32, value: &str) -> Option<Edit<String>> {
    let id = ui.make_persistent_id(("text", field.label));
    let shown = if field.shown == Shown::Mixed { "" } else { value };
    let kept: Option<Typing> = ui.data(|d| d.get_temp(id));
    let fresh = || Typing { text: shown.to_owned(), of: value.to_owned(), gesture: new_gesture() };
    let mut typing = kept.filter(|t| t.of == value).unwrap_or_else(fresh);
    let hint = if field.shown == Shown::Mixed { tr!("widgets-mixed") } else { String::new() };
    let response = edit_line(ui, id, width, &mut typing.text, &hint);
    if response.gained_focus() {
        field::select_all(ui, id, &typing.text);
    }
    let mut edit = None;
    if response.has_focus() {
        ui.data_mut(|d| d.insert_temp(id, typing));
    } else {
        ui.data_mut(|d| d.remove::<Typing>(id));
        let is_kept = ui.input(|i| i.key_pressed(Key::Escape)) || typing.text == shown;
        if response.lost_focus() && !is_kept {
            edit = Some(Edit { value: typing.text, gesture: Some(typing.gesture), finished: true });
        }
    }
    describe(response, field.label, field.tooltip);
    edit
}

fn edit_line(ui: &mut Ui, id: Id, width: f32, text: &mut String, hint: &str) -> Response {
    let sizes = &theme::of(ui).sizes;
    let size = vec2(width, sizes.control);
    let edit = TextEdit::singleline(text).id(id).hint_text(hint.to_owned()).vertical_align(Align::Center);
    let margin = Margin::symmetric(sizes.gap_m as i8, 0);
    ui.add_sized(size, edit.margin(margin).min_size(size).desired_width(width))
}

/// What a person asks of a field for a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileAnswer {
    /// This path.
    Path(Edit<String>),
    /// Let me choose.
    Choose,
}

/// A label and below it a path, with a button that opens the list of files.
pub fn file_field(ui: &mut Ui, field: &Field<'_>, path: &str) -> Option<FileAnswer> {
    let mut answer = None;
    let contents = |ui: &mut Ui| {
        let sizes = &theme::of(ui).sizes;
        let width = ui.available_width() - sizes.control - sizes.gap_s;
        ui.spacing_mut().item_spacing.x = sizes.gap_s;
        answer = line(ui, field, width, path).map(FileAnswer::Path);
        let name = tr!("widgets-choose-file");
        if icon_button(ui, icons::OPEN, &name, &tr!("widgets-choose-file.tooltip"), "").clicked() {
            answer = Some(FileAnswer::Choose);
        }
    };
    field::stacked(ui, field, |ui| ui.horizontal(contents));
    answer
}

/// A line to search in; the response tells whether `text` has been changed.
pub fn search_field(ui: &mut Ui, text: &mut String, name: &str, tooltip: &str) -> Response {
    let sizes = &theme::of(ui).sizes;
    let id = ui.make_persistent_id(("search", name));
    let width = ui.available_width();
    let hint = format!("{}  {name}", icons::SEARCH);
    let room = vec2(width, sizes.control);
    let response = ui
        .allocate_ui_with_layout(room, eframe::egui::Layout::left_to_right(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            let clear_width = if text.is_empty() { 0.0 } else { sizes.control };
            let mut response = edit_line(ui, id, width - clear_width, text, &hint);
            if !text.is_empty() {
                let name = tr!("widgets-clear");
                if icon_button(ui, icons::CLOSE, &name, &tr!("widgets-clear.tooltip"), "").clicked() {
                    text.clear();
                    response.mark_changed();
                }
            }
            response
        })
        .inner;
    response.widget_info(|| WidgetInfo::labeled(WidgetType::TextEdit, true, name));
    describe(response, name, tooltip)
}
