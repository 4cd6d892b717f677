//! A field for a number: drag over it to change, click or focus it to type, arrow keys to step. What is no number, or is
//! not allowed, leaves the value as it was, and the field says why until the next edit.

use super::field::{self, Edit, Field, Shown};
use super::{describe, new_gesture, number_text};
use crate::document::Gesture;
use crate::theme;
use crate::tr;
use eframe::egui::{
    Align, Align2, CursorIcon, FontId, Frame, Id, Key, Margin, Modifiers, Rect, Response, Sense, Stroke,
    StrokeKind, TextEdit, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};
use vitrine::scene::{ParamKind, ParamSpec, Range, Unit};

/// Which numbers a field takes and how it shows them.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// What is allowed.
    pub range: Range,
    /// Whole numbers alone.
    pub whole: bool,
    /// The most decimals that are shown.
    pub decimals: usize,
    /// The change for one point of dragging, and ten times less than for an arrow key.
    pub step: f64,
    /// The unit's sign in the current language, or empty.
    pub unit: String,
}

impl Number {
    /// What a parameter takes; for vectors and pairs, each of its numbers.
    #[must_use]
    pub fn of(spec: &ParamSpec) -> Self {
        let (range, whole) = match spec.kind {
            ParamKind::Number(range) | ParamKind::Pair(range) | ParamKind::Vector(range) => (range, false),
            ParamKind::Integer { min, max } | ParamKind::Size { min, max } => {
                (Range::from_to(min as f32, max as f32), true)
            }
            _ => (Range::ANY, false),
        };
        let (decimals, step) = match (whole, spec.unit) {
            (true, _) => (0, 0.2),
            (_, Unit::Degrees) => (2, 0.5),
            (_, Unit::Metres) => (3, 0.01),
            (_, Unit::Kelvin) => (0, 50.0),
            (_, Unit::Seconds) => (1, 1.0),
            _ if range.max <= 1.0 => (3, 0.005),
            _ => (3, 0.01),
        };
        Self { range, whole, decimals, step, unit: unit_sign(spec.unit) }
    }

    /// As near as the parameter can hold it.
    fn rounded(&self, value: f64) -> f64 {
        if self.whole { value.round() } else { f64::from(value as f32) }
    }

    /// The nearest that is allowed.
    pub(super) fn clamped(&self, value: f64) -> f64 {
        let least = f64::from(self.range.min) + if self.range.above_min { self.step } else { 0.0 };
        self.rounded(value.clamp(least, f64::from(self.range.max)))
    }

    /// The number that a text says.
    ///
    /// # Errors
    /// Why it is not taken, in the current language.
    fn read(&self, text: &str) -> Result<f64, String> {
        let value = number_text::parse(text, &self.unit)
            .ok_or_else(|| tr!("widgets-no-number", text = text.trim()))?;
        if self.whole && value.fract() != 0.0 {
            return Err(tr!("widgets-whole-only"));
        }
        let value = self.rounded(value);
        if self.range.contains(value as f32) { Ok(value) } else { Err(self.allowed()) }
    }

    fn allowed(&self) -> String {
        let show = |v: f32| number_text::format(f64::from(v), self.decimals);
        let Range { min, max, above_min } = self.range;
        match (min > f32::MIN, max < f32::MAX) {
            (true, true) => tr!("widgets-from-to", min = show(min), max = show(max)),
            (true, false) if above_min => tr!("widgets-more-than", min = show(min)),
            (true, false) => tr!("widgets-at-least", min = show(min)),
            (false, true) => tr!("widgets-at-most", max = show(max)),
            (false, false) => tr!("widgets-too-large"),
        }
    }

    fn show(&self, value: f64) -> String {
        number_text::format(value, self.decimals)
    }
}

/// The sign of a unit in the current language.
pub(super) fn unit_sign(unit: Unit) -> String {
    match unit {
        Unit::None => String::new(),
        Unit::Metres => tr!("unit-metres"),
        Unit::Degrees => tr!("unit-degrees"),
        Unit::Pixels => tr!("unit-pixels"),
        Unit::Micrometres => tr!("unit-micrometres"),
        Unit::Kelvin => tr!("unit-kelvin"),
        Unit::Seconds => tr!("unit-seconds"),
    }
}

/// A label and a field for a number.
pub fn number_field(ui: &mut Ui, field: &Field<'_>, number: &Number, value: f64) -> Option<Edit<f64>> {
    let width = box_width(ui);
    let id = box_id(ui, field.label);
    let edit = field::labelled(ui, field, width, |ui, _| {
        number_box(ui, &NumberBox { id, width, field, number }, value)
    });
    field::show_fault(ui, id);
    edit
}

/// How wide a box for one number is.
pub(super) fn box_width(ui: &Ui) -> f32 {
    theme::of(ui).sizes.control * 3.5
}

/// How wide it is beside a slider.
pub(super) fn value_width(ui: &Ui) -> f32 {
    theme::of(ui).sizes.control * 2.3
}

pub(super) fn box_id(ui: &Ui, label: &str) -> Id {
    ui.make_persistent_id(("number", label))
}

/// The box alone, without a label.
pub(super) struct NumberBox<'a> {
    pub id: Id,
    pub width: f32,
    pub field: &'a Field<'a>,
    pub number: &'a Number,
}

/// What is being typed into a box.
#[derive(Clone, Default)]
struct Typing {
    text: String,
    /// The value to which the text belongs: when another edit changes it, the text is out of date.
    of: f64,
    /// The value before, for Esc.
    before: f64,
    gesture: Gesture,
}

/// A drag over a box.
#[derive(Clone, Copy)]
struct Dragging {
    start: f64,
    points: f64,
    gesture: Gesture,
}

pub(super) fn number_box(ui: &mut Ui, b: &NumberBox<'_>, value: f64) -> Option<Edit<f64>> {
    let size = vec2(b.width, theme::of(ui).sizes.control);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let mut edit = None;
    let response = if ui.is_enabled() && ui.memory(|m| m.has_focus(b.id)) {
        type_into(ui, b, rect, value, &mut edit)
    } else {
        edit = end_typing(ui, b, value);
        let response = ui.interact(rect, b.id, Sense::click_and_drag());
        if let Some(dragged) = drag(ui, b, &response, value) {
            edit = Some(dragged);
        }
        draw(ui, b, &response, value);
        if response.clicked() {
            response.request_focus();
        }
        response.on_hover_cursor(CursorIcon::ResizeHorizontal)
    };
    if let Some(assisted) = asked_by_assistant(ui, b, value) {
        edit = Some(assisted);
    }
    if edit.as_ref().is_some_and(|e| e.value != value) {
        ui.data_mut(|d| d.remove::<String>(b.id.with("fault")));
    }
    tell_assistants(&response, b, value);
    describe(response, b.field.label, b.field.tooltip);
    edit
}

fn type_into(
    ui: &mut Ui,
    b: &NumberBox<'_>,
    rect: Rect,
    value: f64,
    edit: &mut Option<Edit<f64>>,
) -> Response {
    let kept: Option<Typing> = ui.data(|d| d.get_temp(b.id));
    let begins = kept.is_none();
    let text = if b.field.shown == Shown::Mixed { String::new() } else { b.number.show(value) };
    let mut typing = match kept {
        Some(typing) if typing.of == value => typing,
        Some(typing) => Typing { text, of: value, ..typing },
        None => Typing { text, of: value, before: value, gesture: new_gesture() },
    };
    let arrows = ui.input_mut(|i| {
        i.count_and_consume_key(Modifiers::NONE, Key::ArrowUp) as f64
            - i.count_and_consume_key(Modifiers::NONE, Key::ArrowDown) as f64
    });
    let mut wanted = None;
    if arrows != 0.0 {
        let stepped = b.number.clamped(value + arrows * arrow_step(b.number));
        typing.text = b.number.show(stepped);
        wanted = Some(stepped);
    }
    let theme = theme::of(ui);
    let mut child = ui.new_child(UiBuilder::new().max_rect(rect));
    let response = child.put(
        rect,
        TextEdit::singleline(&mut typing.text)
            .id(b.id)
            .frame(Frame::NONE)
            .background_color(theme.field)
            .margin(Margin::symmetric(theme.sizes.gap_s as i8, 0))
            .vertical_align(Align::Center)
            .min_size(rect.size())
            .desired_width(rect.width()),
    );
    let is_bad = b.number.read(&typing.text).is_err() && !typing.text.trim().is_empty();
    let border = if is_bad { theme.error_text } else { theme.accent };
    let radius = theme.sizes.radius;
    ui.painter().rect_stroke(rect, radius, Stroke::new(theme.sizes.line, border), StrokeKind::Inside);
    if begins {
        field::select_all(ui, b.id, &typing.text);
        ui.data_mut(|d| d.remove::<String>(b.id.with("fault")));
    }
    if response.changed() {
        ui.data_mut(|d| d.remove::<String>(b.id.with("fault")));
        wanted = b.number.read(&typing.text).ok();
    }
    if let Some(wanted) = wanted.filter(|w| *w != value || b.field.shown != Shown::Stated) {
        typing.of = wanted;
        *edit = Some(Edit { value: wanted, gesture: Some(typing.gesture), finished: false });
    }
    ui.data_mut(|d| d.insert_temp(b.id, typing));
    response
}

fn arrow_step(number: &Number) -> f64 {
    if number.whole { 1.0 } else { number.step * 10.0 }
}

/// Once the focus has gone: Esc brings the old value back, nonsense is explained.
fn end_typing(ui: &Ui, b: &NumberBox<'_>, value: f64) -> Option<Edit<f64>> {
    let typing: Typing = ui.data_mut(|d| d.remove_temp(b.id))?;
    if ui.input(|i| i.key_pressed(Key::Escape)) {
        let is_changed = typing.before != value;
        return is_changed.then_some(Edit {
            value: typing.before,
            gesture: Some(typing.gesture),
            finished: true,
        });
    }
    if !typing.text.trim().is_empty()
        && let Err(fault) = b.number.read(&typing.text)
    {
        ui.data_mut(|d| d.insert_temp(b.id.with("fault"), fault));
        return None;
    }
    let is_changed = typing.before != value;
    is_changed.then_some(Edit { value, gesture: Some(typing.gesture), finished: true })
}

fn drag(ui: &Ui, b: &NumberBox<'_>, response: &Response, value: f64) -> Option<Edit<f64>> {
    let id = b.id.with("drag");
    if response.drag_started() {
        let begin = Dragging { start: value, points: 0.0, gesture: new_gesture() };
        ui.data_mut(|d| d.insert_temp(id, begin));
    }
    let mut dragging: Dragging = ui.data(|d| d.get_temp(id))?;
    if response.drag_stopped() || !response.dragged() {
        ui.data_mut(|d| d.remove::<Dragging>(id));
        return Some(Edit { value, gesture: Some(dragging.gesture), finished: true });
    }
    let is_fine = ui.input(|i| i.modifiers.shift);
    let delta = f64::from(response.drag_delta().x - response.drag_delta().y);
    dragging.points += if is_fine { delta / 10.0 } else { delta };
    ui.data_mut(|d| d.insert_temp(id, dragging));
    // A long number changes in proportion: a hundredth of itself for a point.
    let step =
        if b.number.whole { b.number.step } else { b.number.step.max(dragging.start.abs() * b.number.step) };
    let raw = dragging.start + dragging.points * step;
    let grain = if is_fine { b.number.step / 10.0 } else { b.number.step };
    let wanted = if b.number.whole { raw.round() } else { (raw / grain).round() * grain };
    let wanted = b.number.clamped(wanted);
    (wanted != value).then_some(Edit { value: wanted, gesture: Some(dragging.gesture), finished: false })
}

fn draw(ui: &Ui, b: &NumberBox<'_>, response: &Response, value: f64) {
    let theme = theme::of(ui);
    let (rect, sizes) = (response.rect, &theme.sizes);
    let is_hot = response.hovered() || response.dragged();
    let fill = if is_hot { theme.button_press } else { theme.field };
    let border = match (response.dragged(), is_hot) {
        (true, _) => theme.accent,
        (_, true) => theme.border,
        _ => theme.separator,
    };
    ui.painter().rect(rect, sizes.radius, fill, Stroke::new(sizes.line, border), StrokeKind::Inside);
    let (text, color) = match b.field.shown {
        Shown::Stated => (b.number.show(value), theme.text),
        Shown::Derived => (b.number.show(value), theme.text_muted),
        Shown::Mixed => (tr!("widgets-mixed"), theme.text_muted),
    };
    let inside = rect.shrink2(vec2(sizes.gap_s + sizes.gap_xs, 0.0));
    let painter = ui.painter().with_clip_rect(inside.intersect(ui.clip_rect()));
    let font = FontId::proportional(sizes.text);
    let shown = painter.text(inside.left_center(), Align2::LEFT_CENTER, text, font, color);
    let unit_font = FontId::proportional(sizes.text_small);
    let unit = ui.painter().layout_no_wrap(b.number.unit.clone(), unit_font, theme.text_muted);
    let fits = shown.right() + sizes.gap_xs + unit.size().x <= inside.right();
    if fits && b.field.shown != Shown::Mixed {
        let at = pos2(inside.right() - unit.size().x, rect.center().y - unit.size().y / 2.0);
        ui.painter().galley(at, unit, theme.text_muted);
    }
}

fn asked_by_assistant(ui: &Ui, b: &NumberBox<'_>, value: f64) -> Option<Edit<f64>> {
    use eframe::egui::accesskit::{Action, ActionData};
    let steps = ui.input(|i| {
        i.num_accesskit_action_requests(b.id, Action::Increment) as f64
            - i.num_accesskit_action_requests(b.id, Action::Decrement) as f64
    });
    let set = ui.input(|i| {
        i.accesskit_action_requests(b.id, Action::SetValue).find_map(|request| match request.data {
            Some(ActionData::NumericValue(v)) => Some(v),
            _ => None,
        })
    });
    let wanted = set.or((steps != 0.0).then(|| value + steps * arrow_step(b.number)))?;
    Some(Edit::at_once(b.number.clamped(wanted)))
}

fn tell_assistants(response: &Response, b: &NumberBox<'_>, value: f64) {
    use eframe::egui::accesskit::Action;
    response.widget_info(|| WidgetInfo::drag_value(response.enabled(), value));
    let text = format!("{} {}", b.number.show(value), b.number.unit);
    response.ctx.accesskit_node_builder(response.id, |node| {
        node.set_value(text.trim());
        node.set_numeric_value_step(arrow_step(b.number));
        [Action::SetValue, Action::Increment, Action::Decrement].into_iter().for_each(|a| node.add_action(a));
    });
}
