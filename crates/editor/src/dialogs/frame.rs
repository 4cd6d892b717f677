//! What all dialogs share: the frame with its title and its row of buttons, Enter and Esc, and where the focus begins.

use crate::text::tr;
use crate::theme;
use crate::widgets::{Field, Shown, choice_field, primary_button, text_button};
use eframe::egui::{
    Align, Context, FocusDirection, Frame, Id, Key, Label, Layout, Margin, Modal, Modifiers, Rect, RichText,
    ScrollArea, Stroke, Ui, UiBuilder, pos2, vec2,
};

/// How a dialog looks before anything is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shell<'a> {
    /// A word that no other dialog has.
    pub id: &'static str,
    /// Its title.
    pub title: &'a str,
    /// Points.
    pub width: f32,
}

/// The buttons below a dialog, from left to right: the other one, «Cancel», the default one.
#[derive(Clone, Debug, Default)]
pub(super) struct Buttons {
    /// What Enter does; None when there is only «Close».
    pub accept: Option<Caption>,
    /// Whether it can be pressed.
    pub is_ready: bool,
    /// A third way.
    pub other: Option<Caption>,
    /// What Esc does; None: «Cancel», or «Close» where nothing can be accepted.
    pub cancel: Option<Caption>,
}

/// The words of a button.
#[derive(Clone, Debug)]
pub(super) struct Caption {
    name: String,
    tooltip: String,
}

impl Caption {
    /// The text of a key and its tooltip.
    pub fn of(key: &str) -> Self {
        Self { name: tr!(key), tooltip: tr!(&format!("{key}.tooltip")) }
    }
}

impl Buttons {
    /// A default button, and «Cancel».
    pub fn accept(key: &str, is_ready: bool) -> Self {
        Self { accept: Some(Caption::of(key)), is_ready, ..Self::default() }
    }

    /// «Close» alone.
    pub fn close() -> Self {
        Self::default()
    }
}

/// What a person wants of a dialog in this frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Go on.
    Open,
    /// Enter or the default button.
    Accept,
    /// The third button.
    Other,
    /// Esc, «Cancel» or «Close».
    Cancel,
}

/// Keys that belong to the dialog and not to what is in it.
struct Keys {
    enter: bool,
    escape: bool,
}

impl Keys {
    fn pressed(ctx: &Context) -> Self {
        // Enter in a field accepts; Enter on a button presses that button.
        let has_button_focus =
            ctx.memory(eframe::egui::Memory::focused).is_some() && !ctx.text_edit_focused();
        let is_popup_open = eframe::egui::Popup::is_any_open(ctx);
        let pressed = |key| ctx.input(|i| i.key_pressed(key) && i.modifiers.is_none());
        Self {
            enter: pressed(Key::Enter) && !has_button_focus && !is_popup_open,
            escape: pressed(Key::Escape) && !is_popup_open,
        }
    }
}

/// Draws a dialog over a veil. `body` draws what is in it and says which buttons it has.
pub(super) fn show(ctx: &Context, shell: Shell<'_>, body: impl FnOnce(&mut Ui) -> Buttons) -> Verdict {
    let keys = Keys::pressed(ctx);
    let theme = theme::of(ctx);
    let id = Id::new(("dialog", shell.id));
    begin_focus(ctx, id);
    let frame = Frame::window(&ctx.global_style())
        .inner_margin(Margin::same(theme.sizes.gap_xl as i8))
        .fill(theme.raised);
    let modal = Modal::new(id).frame(frame).backdrop_color(theme.veil);
    let response = modal.show(ctx, |ui| {
        ui.set_width(shell.width);
        name_window(ui, shell.title);
        ui.spacing_mut().item_spacing.y = theme.sizes.gap_m;
        let title = RichText::new(shell.title).size(theme.sizes.text_title).color(theme.text_strong);
        ui.add(Label::new(title).wrap().selectable(false));
        ui.add_space(theme.sizes.gap_m);
        // Title, buttons and margins take the rest.
        let room = ctx.content_rect().height() - 5.0 * theme.sizes.control - 4.0 * theme.sizes.gap_xl;
        let area = ScrollArea::vertical().id_salt(id).max_height(room).auto_shrink([false, true]);
        let buttons = area.show(ui, body).inner;
        ui.add_space(theme.sizes.gap_l);
        let pressed = button_row(ui, &buttons);
        match pressed {
            Verdict::Open if keys.enter && buttons.accept.is_some() && buttons.is_ready => Verdict::Accept,
            Verdict::Open if keys.enter && buttons.accept.is_none() => Verdict::Cancel,
            pressed => pressed,
        }
    });
    if keys.escape && response.is_top_modal {
        ctx.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape));
        return Verdict::Cancel;
    }
    if response.inner != Verdict::Open {
        ctx.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Enter));
    }
    response.inner
}

/// Takes the focus from whatever had it when the dialog opened, and gives it to the dialog's first field.
fn begin_focus(ctx: &Context, id: Id) {
    let pass = ctx.cumulative_pass_nr();
    let seen: Option<[u64; 2]> = ctx.data(|d| d.get_temp(id));
    // First and latest pass in which it was shown; a gap means that it was closed in between.
    let [first, latest] = seen.filter(|[_, latest]| pass <= latest + 1).unwrap_or([pass, pass]);
    ctx.data_mut(|d| d.insert_temp(id, [first, pass.max(latest)]));
    if first == pass {
        if let Some(focused) = ctx.memory(eframe::egui::Memory::focused) {
            ctx.memory_mut(|m| m.surrender_focus(focused));
        }
        ctx.request_repaint();
    } else if first + 1 == pass {
        // By now, what lies under the dialog is out of reach.
        ctx.memory_mut(|m| m.move_focus(FocusDirection::Next));
    }
}

/// Names the dialog for screen readers.
fn name_window(ui: &mut Ui, title: &str) {
    let id = ui.unique_id();
    ui.ctx().accesskit_node_builder(id, |node| {
        node.set_role(eframe::egui::accesskit::Role::Dialog);
        node.set_label(title);
        node.set_modal();
    });
}

fn button_row(ui: &mut Ui, buttons: &Buttons) -> Verdict {
    let mut verdict = Verdict::Open;
    let room = vec2(ui.available_width(), theme::of(ui).sizes.control);
    ui.allocate_ui_with_layout(room, Layout::right_to_left(Align::Center), |ui| {
        ui.spacing_mut().button_padding.x = theme::of(ui).sizes.gap_l;
        if let Some(Caption { name, tooltip }) = &buttons.accept {
            let response = ui.add_enabled_ui(buttons.is_ready, |ui| primary_button(ui, name, tooltip));
            if response.inner.clicked() {
                verdict = Verdict::Accept;
            }
        }
        let usual = if buttons.accept.is_some() { "dialog-cancel" } else { "dialog-close" };
        let Caption { name, tooltip } = buttons.cancel.clone().unwrap_or_else(|| Caption::of(usual));
        if text_button(ui, &name, &tooltip).clicked() {
            verdict = Verdict::Cancel;
        }
        if let Some(Caption { name, tooltip }) = &buttons.other {
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                if text_button(ui, name, tooltip).clicked() {
                    verdict = Verdict::Other;
                }
            });
        }
    });
    verdict
}

/// A title over a part of a dialog.
pub(super) fn heading(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    let text = RichText::new(text).size(theme.sizes.text_section).color(theme.text_strong).strong();
    ui.add(Label::new(text).wrap().selectable(false));
}

/// A text of several words that may take several lines.
pub(super) fn paragraph(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    ui.add(Label::new(RichText::new(text).color(theme.text)).wrap());
}

/// Less important words.
pub(super) fn hint(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    let text = RichText::new(text).size(theme.sizes.text_small).color(theme.text_muted);
    ui.add(Label::new(text).wrap());
}

/// Words about something that stands in the way.
pub(super) fn fault(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    let text = RichText::new(text).size(theme.sizes.text_small).color(theme.error_text);
    ui.add(Label::new(text).wrap());
}

/// A name and a value, in a line.
pub(super) fn fact(ui: &mut Ui, name: &str, value: &str) {
    let theme = theme::of(ui);
    let room = vec2(ui.available_width(), theme.sizes.text + theme.sizes.gap_m);
    ui.allocate_ui_with_layout(room, Layout::right_to_left(Align::Center), |ui| {
        ui.add(Label::new(RichText::new(value).color(theme.text)).truncate());
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add(Label::new(RichText::new(name).color(theme.text_muted)).selectable(false));
        });
    });
}

/// Two columns of equal width with a gap between them.
pub(super) fn columns<R>(ui: &mut Ui, contents: impl FnOnce(&mut Ui, &mut Ui) -> R) -> R {
    let sizes = &theme::of(ui).sizes;
    let room = ui.available_rect_before_wrap();
    let width = (room.width() - sizes.gap_xl) / 2.0;
    let column = |ui: &mut Ui, left: f32| {
        let rect = Rect::from_min_size(pos2(left, room.top()), vec2(width, room.height()));
        let layout = Layout::top_down(Align::Min);
        let mut column = ui.new_child(UiBuilder::new().id_salt(left as i32).max_rect(rect).layout(layout));
        column.set_width(width);
        column.spacing_mut().item_spacing = vec2(sizes.gap_m, sizes.gap_s + sizes.gap_xs);
        column
    };
    let mut left = column(ui, room.left());
    let mut right = column(ui, room.left() + width + sizes.gap_xl);
    let inner = contents(&mut left, &mut right);
    ui.advance_cursor_after_rect(left.min_rect().union(right.min_rect()));
    inner
}

/// A darker box in a dialog, for text of a file and lists.
pub(super) fn sunken(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let theme = theme::of(ui);
    let frame = Frame::new()
        .fill(theme.field)
        .stroke(Stroke::new(theme.sizes.line, theme.separator))
        .corner_radius(theme.sizes.radius)
        .inner_margin(Margin::same(theme.sizes.gap_m as i8));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        contents(ui);
    });
}

/// A list to choose from, with its label and tooltip from the texts.
pub(super) fn choice<T: Clone + PartialEq>(
    ui: &mut Ui,
    key: &str,
    now: &T,
    choices: &[(T, String)],
) -> Option<T> {
    let (label, tooltip) = (tr!(key), tr!(&format!("{key}.tooltip")));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    choice_field(ui, &field, Some(now), choices)
}
