//! What all controls share: their names, how an edit goes on, where the label stands.

use crate::document::Gesture;
use crate::theme;
use eframe::egui::text::LayoutJob;
use eframe::egui::{Align, FontId, Label, Layout, Response, TextFormat, Ui, vec2};
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

/// A visible label; what stands in brackets is less important and drawn so.
pub(super) fn label(ui: &mut Ui, text: &str, tooltip: &str) -> Response {
    let job = label_job(ui, text);
    let response = ui.add(Label::new(job).selectable(false).wrap());
    if tooltip.is_empty() { response } else { response.on_hover_text(tooltip) }
}

fn label_job(ui: &Ui, text: &str) -> LayoutJob {
    let theme = theme::of(ui);
    let format = |color| TextFormat::simple(FontId::proportional(theme.sizes.text), color);
    let (main, rest) = text.find(" (").map_or((text, ""), |at| text.split_at(at));
    let mut job = LayoutJob::default();
    job.append(main, 0.0, format(theme.text));
    job.append(rest, 0.0, format(theme.text_muted));
    job
}

/// Draws the label and beside it, or below when the label is long, the control. The control gets its width.
pub(super) fn labelled<R>(
    ui: &mut Ui,
    field: &Field<'_>,
    width: f32,
    control: impl FnOnce(&mut Ui, f32) -> R,
) -> R {
    let gap = theme::of(ui).sizes.gap_m;
    let font = FontId::proportional(theme::of(ui).sizes.text);
    let text = ui.painter().layout_no_wrap(field.label.to_owned(), font, theme::of(ui).text);
    let all = ui.available_width();
    if text.size().x + gap + width > all {
        label(ui, field.label, field.tooltip);
        let inner = control(ui, all);
        return inner;
    }
    let height = theme::of(ui).sizes.control;
    ui.allocate_ui_with_layout(vec2(all, height), Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_height(height);
        label(ui, field.label, field.tooltip);
        ui.add_space((ui.available_width() - width).max(0.0));
        control(ui, width)
    })
    .inner
}
