//! The picture in the window: shows what [`crate::live`] renders, and lets a person point at things, move, turn and size them,
//! paint them, and move the camera. It changes nothing itself, it says what was asked for.

mod asking;
mod bar;
mod drag;
mod handles;
mod marks;
mod pointing;
mod projection;
mod surface;

pub use handles::Tool;

use crate::action::{Action, Actions};
use crate::document::{Document, EditCommand, Gesture, Paint, Thing};
use crate::live::{Live, LiveError, Picked};
use crate::theme::{self, Theme};
use crate::tr;
use asking::Asking;
use drag::Drag;
use eframe::egui::{
    Align2, CursorIcon, DragAndDrop, FontId, Painter, Pos2, Rect, Response, Sense, Ui, WidgetInfo,
    WidgetType, vec2,
};
use handles::{Handle, Handles};
use marks::{Mark, mark_at, marks};
use projection::{Projection, letterbox};
use surface::{Outline, Surface, flags};
use vitrine::math::Vec3;
use vitrine::scene::ListName;

/// Gestures in the picture are numbered from here on, so that they are never taken for those of a panel.
const FIRST_GESTURE: Gesture = 1 << 48;
/// A picture that is not there after so many seconds is said to be on its way.
const SLOW: f64 = 0.6;

/// What the picture remembers from frame to frame.
pub struct Viewport {
    /// What a drag of a handle does.
    pub tool: Tool,
    /// Threads that compute the picture; 0: all of the machine's.
    pub threads: usize,
    asking: Asking,
    surface: Surface,
    drag: Option<Drag>,
    last_gesture: Gesture,
    /// Whether the press that goes on can drag nothing.
    is_idle_press: bool,
    /// The gesture of the wheel, and when it was turned last.
    wheel: Option<(Gesture, f64)>,
}

impl Default for Viewport {
    fn default() -> Self {
        Self {
            tool: Tool::Move,
            threads: 0,
            asking: Asking::default(),
            surface: Surface::default(),
            drag: None,
            last_gesture: FIRST_GESTURE,
            is_idle_press: false,
            wheel: None,
        }
    }
}

impl Viewport {
    fn new_gesture(&mut self) -> Gesture {
        self.last_gesture += 1;
        self.last_gesture
    }

    /// Whether something is being dragged: then keys belong to the drag.
    #[must_use]
    pub const fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// What is asked of the final render: the scene as it is.
    #[must_use]
    pub fn final_request(&self, document: &Document) -> crate::live::Request {
        self.asking.request(document, self.threads)
    }
}

/// What all parts of one frame look at.
struct Frame<'a> {
    document: &'a Document,
    live: &'a Live,
    theme: &'static Theme,
    projection: Projection,
    marks: Vec<Mark>,
    handles: Option<Handles>,
    rect: Rect,
}

impl Frame<'_> {
    /// What is seen at a point of the window, the nearest first: an icon, or objects, one behind the other as far as they are
    /// transparent. Each with its point in the scene.
    fn things_at(&self, at: Pos2) -> Vec<(Thing, Vec3)> {
        if !self.rect.contains(at) {
            return Vec::new();
        }
        let mark = mark_at(&self.marks, at, self.theme).map(|mark| (mark.thing.clone(), mark.point));
        if let Some(mark) = mark.clone().filter(|(thing, _)| *thing != Thing::Camera) {
            return vec![mark];
        }
        let share = self.projection.share(at);
        let picked = self.live.pick_through(share.x, share.y).into_iter();
        let is_there = |picked: &Picked| self.document.scene().object(&picked.name).is_some();
        let objects = picked.filter(is_there).map(|p| (Thing::object(p.name), p.point));
        objects.chain(mark).collect()
    }

    /// What is seen first at a point of the window.
    fn thing_at(&self, at: Pos2) -> Option<(Thing, Vec3)> {
        self.things_at(at).into_iter().next()
    }

    /// The handle at a point of the window.
    fn handle_at(&self, at: Pos2) -> Option<(Handles, Handle)> {
        let handles = self.handles?;
        Some((handles, handles.under(&self.projection, at, self.theme.sizes.handle_grab)?))
    }

    /// What is selected and can be moved.
    fn movable(&self) -> Vec<Thing> {
        let has_place = |thing: &&Thing| handles::place_of(self.document.scene(), thing).is_some();
        self.document.selection().things().iter().filter(has_place).cloned().collect()
    }
}

/// Draws the picture in what room there is, and says what was asked for in it.
pub fn viewport_ui(
    ui: &mut Ui,
    document: &Document,
    live: &mut Live,
    viewport: &mut Viewport,
    actions: &mut Actions,
) {
    let theme = theme::of(ui.ctx());
    let outer = ui.available_rect_before_wrap();
    ui.allocate_rect(outer, Sense::hover());
    ui.painter().rect_filled(outer, 0.0, theme.surround);
    let rect = letterbox(outer, document.scene().settings.size, ui.ctx().pixels_per_point());
    let response = ui.interact(rect, ui.id().with("picture"), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(WidgetType::Image, true, tr!("viewport-picture")));
    viewport.ask(ui, document, live, rect);

    let projection = Projection::new(&document.scene().camera, rect);
    let marks = marks(document.scene(), document.selection(), &projection);
    let mut frame = Frame { document, live, theme, projection, marks, handles: None, rect };
    frame.handles = frame.movable().last().and_then(|thing| {
        Handles::at(viewport.tool, document.scene(), thing, (&projection, theme.sizes.handle_arm))
    });
    viewport.point(ui, &response, &frame, actions);
    viewport.drop_paint(&response, &frame, actions);
    viewport.paint(ui, &response, &frame);
    bar::bar_ui(ui, &frame, viewport, actions);
}

impl Viewport {
    /// A material that is let go over a thing becomes that thing's.
    fn drop_paint(&self, response: &Response, frame: &Frame, actions: &mut Actions) {
        if response.dnd_hover_payload::<Paint>().is_none() {
            return;
        }
        let under = response.ctx.pointer_interact_pos().and_then(|at| frame.thing_at(at));
        let Some((thing, _)) = under.filter(|(t, _)| t.list() == Some(ListName::Object)) else { return };
        if let Some(paint) = response.dnd_release_payload::<Paint>() {
            let material = Box::new(Paint::clone(&paint));
            actions.push(Action::Edit(EditCommand::Paint { things: vec![thing], material }));
        }
    }

    fn paint(&mut self, ui: &Ui, response: &Response, frame: &Frame) {
        let painter = ui.painter().with_clip_rect(frame.rect);
        let (theme, rect) = (frame.theme, frame.rect);
        self.surface.paint_picture(&painter, rect, frame.live.picture());
        self.surface.paint_outline(&painter, rect, outline(ui, response, frame));
        let is_free = response.hovered() && self.drag.is_none();
        let pointer = response.hover_pos().filter(|_| is_free);
        let hovered = pointer.and_then(|at| frame.handle_at(at)).map(|(_, handle)| handle);
        let mark = pointer.filter(|_| hovered.is_none()).and_then(|at| mark_at(&frame.marks, at, theme));
        for each in &frame.marks {
            let is_selected = frame.document.selection().contains(&each.thing);
            each.paint(&painter, theme, is_selected, mark.is_some_and(|m| m.thing == each.thing));
        }
        let held = self.drag.as_ref().and_then(Drag::held);
        if let Some(handles) = frame.handles.filter(|_| self.drag.as_ref().is_none_or(|d| !d.is_of_camera()))
        {
            handles.paint(&painter, &frame.projection, theme, held.or(hovered));
        }
        if hovered.is_some() || held.is_some() {
            ui.ctx().set_cursor_icon(CursorIcon::Grab);
        }
        if let Some(name) = mark.and_then(|m| m.thing.name()) {
            response.clone().on_hover_text_at_pointer(name);
        }
        if let (Some(angle), Some(at)) = (self.drag.as_ref().and_then(Drag::turned_deg), response.hover_pos())
        {
            let place = at + vec2(theme.sizes.gap_xl, -theme.sizes.gap_xl);
            note(&painter, theme, place, &tr!("viewport-degrees", angle = format!("{angle:.0}")));
        }
        self.paint_texts(ui, &painter, frame);
    }

    /// What is wrong, or that the picture takes its time.
    fn paint_texts(&self, ui: &Ui, painter: &Painter, frame: &Frame) {
        let status = frame.live.status();
        let place = frame.rect.left_top() + vec2(frame.theme.sizes.gap_l, frame.theme.sizes.gap_l);
        let error = status.error.map(|error| match error {
            LiveError::Panic { message } => tr!("viewport-panic", message = message),
            error => tr!("viewport-error", message = error.to_string()),
        });
        if let Some(text) = error {
            let width = frame.rect.width() - 4.0 * frame.theme.sizes.gap_l;
            let font = FontId::proportional(frame.theme.sizes.text);
            let galley = painter.layout(text, font, frame.theme.error_text, width);
            let back = Rect::from_min_size(place, galley.size()).expand(frame.theme.sizes.gap_m);
            painter.rect_filled(back, frame.theme.sizes.radius, frame.theme.raised);
            painter.galley(place, galley, frame.theme.error_text);
        } else if status.is_busy && self.asking.is_slow(ui, frame.live, SLOW) {
            note(painter, frame.theme, place, &tr!("viewport-rendering"));
        }
    }
}

/// A short text on a quiet ground.
fn note(painter: &Painter, theme: &Theme, at: Pos2, text: &str) {
    let galley =
        painter.layout_no_wrap(text.to_owned(), FontId::proportional(theme.sizes.text_small), theme.text);
    let rect = Align2::LEFT_TOP.anchor_size(at, galley.size());
    painter.rect_filled(rect.expand(theme.sizes.gap_s), theme.sizes.radius, theme.veil);
    painter.galley(rect.min, galley, theme.text);
}

/// The outline: around what is selected, or around what a material would be dropped on.
fn outline<'a>(ui: &Ui, response: &Response, frame: &Frame<'a>) -> Option<Outline<'a>> {
    let map = frame.live.objects()?;
    let scene = map.scene.clone();
    let theme: &'a Theme = frame.theme;
    if DragAndDrop::has_payload_of_type::<Paint>(ui.ctx()) && response.contains_pointer() {
        let at = ui.ctx().pointer_interact_pos()?;
        let (thing, _) = frame.thing_at(at)?;
        let chosen = flags(&scene, &|name| thing == Thing::object(name), &|_| false);
        return Some(Outline { map, chosen, theme });
    }
    let selection = frame.document.selection();
    let is_chosen = |name: &str| selection.contains(&Thing::object(name));
    let is_group_chosen = |name: &str| selection.contains(&Thing::group(name));
    Some(Outline { chosen: flags(&scene, &is_chosen, &is_group_chosen), map, theme })
}

#[cfg(test)]
mod tests;
