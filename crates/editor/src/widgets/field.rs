//! What all controls share: their names, how an edit goes on, where the label stands.

use crate::document::Gesture;
use crate::theme;
use eframe::egui::text::LayoutJob;
use crate::tr;
use eframe::egui::{
    Align, FontId, Id, Label, Layout, Response, RichText, Sense, TextFormat, Ui, vec2,
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

/// Draws the label and beside it, or below when the label is long, the control. The control gets its width.
pub(super) fn labelled<R>(
    ui: &mut Ui,
    field: &Field<'_>,
    width: f32,
    control: impl FnOnce(&mut Ui, f32) -> R,
) -> R {
    let sizes = &theme::of(ui).sizes;
    let text = ui.painter().layout_job(label_job(ui, field));
    let all = ui.available_width();
    if text.size().x + sizes.gap_m + width > all {
        return ui
            .vertical(|ui| {
                ui.spacing_mut().item_spacing.y = sizes.gap_s;
                label(ui, field);
                control(ui, all)
            })
            .inner;
    }
    ui.allocate_ui_with_layout(vec2(all, sizes.control), Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        ui.set_min_height(sizes.control);
        label(ui, field);
        ui.add_space((ui.available_width() - width).max(0.0));
        control(ui, width)
    })
    .inner
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
