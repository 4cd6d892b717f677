//! What all controls share: their names, how an edit goes on, where the label stands.

use crate::document::Gesture;
use crate::theme;
use crate::tr;
use eframe::egui::text::{CCursor, CCursorRange, LayoutJob};
use eframe::egui::{
    Align, FontId, Id, Label, Layout, Response, RichText, Sense, TextEdit, TextFormat, Ui, UiBuilder, vec2,
};
use std::sync::atomic::{AtomicU64, Ordering};

/// The words of a control, and what its value stands for.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// The visible label, which is its accessible name, too.
    pub label: &'a str,
    /// What it does, in plain words.
    pub tooltip: &'a str,
    /// What the shown value stands for.
    pub shown: Shown,
}

/// What a shown value stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// The value itself.
    #[default]
    Stated,
    /// Nothing is stated; this is what follows from the rest.
    Derived,
    /// One of several things' values, which differ.
    Mixed,
}

/// A new value, and whether it belongs to something that goes on.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit<T> {
    /// The value.
    pub value: T,
    /// The drag or typing that it is a part of; None when it is done in one go.
    pub gesture: Option<Gesture>,
    /// Whether that ends here.
    pub finished: bool,
}

impl<T> Edit<T> {
    /// An edit that is done in one go.
    pub const fn at_once(value: T) -> Self {
        Self { value, gesture: None, finished: true }
    }

    /// The same edit of something else.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Edit<U> {
        Edit { value: f(self.value), gesture: self.gesture, finished: self.finished }
    }
}

/// A gesture that no other has the number of.
#[must_use]
pub fn new_gesture() -> Gesture {
    static LAST: AtomicU64 = AtomicU64::new(0);
    LAST.fetch_add(1, Ordering::Relaxed) + 1
}

/// Gives a control its accessible name and its tooltip, which screen readers say as its description.
pub fn describe(response: Response, name: &str, tooltip: &str) -> Response {
    response.ctx.accesskit_node_builder(response.id, |node| {
        node.set_label(name);
        node.set_description(tooltip);
    });
    if tooltip.is_empty() {
        return response;
    }
    response.on_hover_text(tooltip).on_disabled_hover_text(tooltip)
}

/// A visible label; what stands in brackets is less important and drawn so. It is the control's name already, so screen
/// readers do not hear it twice.
pub(super) fn label(ui: &mut Ui, field: &Field<'_>) -> Response {
    let mut job = label_job(ui, field);
    job.wrap.max_width = ui.available_width();
    let galley = ui.painter().layout_job(job);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    ui.painter().galley(rect.min, galley, theme::of(ui).text);
    if field.tooltip.is_empty() { response } else { response.on_hover_text(field.tooltip) }
}

fn label_job(ui: &Ui, field: &Field<'_>) -> LayoutJob {
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let format = |size, color| TextFormat::simple(FontId::proportional(size), color);
    let (main, rest) = field.label.find(" (").map_or((field.label, ""), |at| field.label.split_at(at));
    let mut job = LayoutJob::default();
    job.append(main, 0.0, format(sizes.text, theme.text));
    job.append(rest, 0.0, format(sizes.text, theme.text_muted));
    if field.shown == Shown::Derived {
        job.append(&tr!("widgets-auto"), sizes.gap_m, format(sizes.text_small, theme.text_muted));
    }
    job
}

/// Draws the label and beside it, or below when the label is long, the control. The control gets its width. Beside a narrow
/// control a long label takes several lines.
pub(super) fn labelled<R>(
    ui: &mut Ui,
    field: &Field<'_>,
    width: f32,
    control: impl FnOnce(&mut Ui, f32) -> R,
) -> R {
    let sizes = &theme::of(ui).sizes;
    let text = ui.painter().layout_job(label_job(ui, field));
    let all = ui.available_width();
    let room = all - width - sizes.gap_m;
    if text.size().x > room && width > 0.5 * all {
        return stacked(ui, field, |ui| control(ui, all));
    }
    ui.allocate_ui_with_layout(vec2(all, sizes.control), Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        ui.set_min_height(sizes.control);
        let mut column =
            ui.new_child(UiBuilder::new().max_rect(ui.max_rect().with_max_x(ui.max_rect().left() + room)));
        label(&mut column, field);
        let used = column.min_rect();
        ui.allocate_rect(used.with_max_x(used.left() + room + sizes.gap_m), Sense::hover());
        control(ui, width)
    })
    .inner
}

/// Draws the label and the control below it.
pub(super) fn stacked<R>(ui: &mut Ui, field: &Field<'_>, control: impl FnOnce(&mut Ui) -> R) -> R {
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = theme::of(ui).sizes.gap_s;
        if !field.label.is_empty() {
            label(ui, field);
        }
        control(ui)
    })
    .inner
}

/// Selects all of a line's text, so that typing replaces it.
pub(super) fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut state = TextEdit::load_state(ui, id).unwrap_or_default();
    let range = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(range));
    state.store(ui, id);
}

/// Says why what was typed has not been taken, if a control with this id has noted that.
pub(super) fn show_fault(ui: &mut Ui, id: Id) {
    let fault: Option<String> = ui.data(|d| d.get_temp(id.with("fault")));
    if let Some(fault) = fault {
        let theme = theme::of(ui);
        let text = RichText::new(fault).color(theme.error_text).size(theme.sizes.text_small);
        ui.add(Label::new(text).wrap());
    }
}
