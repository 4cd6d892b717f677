//! Parts of a panel: sections that fold, and what an empty place says.

use super::describe;
use crate::theme::{self, icon_font, icons};
use crate::tr;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{Align2, FontId, Label, RichText, Sense, Stroke, Ui, WidgetInfo, WidgetType, vec2};

/// A title with its contents, which fold away under it. `open` is how it is first. Gives the contents' answer when they
/// are seen. A line divides it from what stands above.
pub fn section<R>(ui: &mut Ui, title: &str, open: bool, contents: impl FnOnce(&mut Ui) -> R) -> Option<R> {
    let theme = theme::of(ui);
    ui.add_space(theme.sizes.gap_s);
    let stroke = Stroke::new(theme.sizes.line, theme.separator);
    ui.painter().hline(ui.max_rect().x_range(), ui.cursor().top(), stroke);
    ui.add_space(theme.sizes.gap_s);
    subsection(ui, title, open, contents)
}

/// The same inside another: without the line.
pub fn subsection<R>(ui: &mut Ui, title: &str, open: bool, contents: impl FnOnce(&mut Ui) -> R) -> Option<R> {
    let id = ui.make_persistent_id(("section", title));
    let mut state = CollapsingState::load_with_default_open(ui, id, open);
    let theme = theme::of(ui);
    let sizes = &theme.sizes;
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), sizes.control), Sense::click());
    if response.clicked() {
        state.toggle(ui);
    }
    let color = if response.hovered() || response.has_focus() { theme.accent } else { theme.text_strong };
    let icon = if state.is_open() { icons::OPEN_DOWN } else { icons::OPEN_RIGHT };
    let painter = ui.painter();
    painter.text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        icon,
        icon_font(sizes.text_small),
        theme.text_muted,
    );
    let at = rect.left_center() + vec2(sizes.icon + sizes.gap_xs, 0.0);
    painter.text(at, Align2::LEFT_CENTER, title, FontId::proportional(sizes.text_section), color);
    response.widget_info(|| {
        WidgetInfo::selected(WidgetType::CollapsingHeader, ui.is_enabled(), state.is_open(), title)
    });
    let tooltip = if state.is_open() { tr!("widgets-fold") } else { tr!("widgets-unfold") };
    describe(response, title, &tooltip);
    state.show_body_unindented(ui, contents).map(|inner| inner.inner)
}

/// What a place says that has nothing to show.
pub fn empty_hint(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    ui.add_space(theme.sizes.gap_xl);
    ui.vertical_centered(|ui| {
        ui.add(Label::new(RichText::new(text).color(theme.text_muted)).wrap());
    });
    ui.add_space(theme.sizes.gap_xl);
}
