//! What the pointer does in the picture: select, drag, look around.

use super::asking::WHEEL_RESTS;
use super::drag::{Drag, Pointer};
use super::{Frame, Viewport};
use crate::action::{Action, Actions};
use crate::document::{CameraMove, EditCommand, Gesture, Thing};
use eframe::egui::{DragAndDrop, Key, Modifiers, PointerButton, Pos2, Response, Ui};
use vitrine::math::Vec3;
use vitrine::scene::{ListName, Shape};

/// A point of scrolling brings the camera nearer by this power of e.
const ZOOM: f32 = 0.002;
/// How far the middle of things is taken to be when nothing is seen in the middle of the picture, metres.
const SOMEWHERE: f32 = 5.0;

impl Viewport {
    pub(super) fn point(&mut self, ui: &Ui, response: &Response, frame: &Frame, actions: &mut Actions) {
        let (modifiers, moved) = ui.input(|i| (i.modifiers, i.pointer.delta()));
        if self.drag.is_none() {
            self.begin(ui, response, frame, actions);
        }
        self.follow(ui, frame, (modifiers, moved), actions);
        if response.clicked() {
            click(response, frame, modifiers, actions);
        }
        self.turn_wheel(ui, response, frame, actions);
    }

    /// Begins a drag where the pointer was pressed, once it has moved: a long press is no drag.
    fn begin(&mut self, ui: &Ui, response: &Response, frame: &Frame, actions: &mut Actions) {
        let (origin, now, modifiers) =
            ui.input(|i| (i.pointer.press_origin(), i.pointer.interact_pos(), i.modifiers));
        let (Some(at), Some(now)) = (origin.filter(|_| response.dragged()), now) else {
            self.is_idle_press = false;
            return;
        };
        let is_far = (now - at).length() > frame.theme.sizes.gap_s;
        if self.is_idle_press || !is_far || DragAndDrop::has_any_payload(ui.ctx()) {
            return;
        }
        let is_by = |button| response.dragged_by(button);
        let gesture = self.new_gesture();
        self.drag = if is_by(PointerButton::Middle) || is_by(PointerButton::Secondary) && modifiers.shift {
            Some(Drag::pan(middle(frame), gesture))
        } else if is_by(PointerButton::Secondary) || is_by(PointerButton::Primary) && modifiers.alt {
            Some(Drag::orbit(middle(frame), gesture))
        } else if let Some(held) = frame.handle_at(at) {
            Some(Drag::handle(held, frame.movable(), (&frame.projection, at), gesture))
        } else {
            slide(frame, (at, modifiers), gesture, actions)
        };
        self.is_idle_press = self.drag.is_none();
    }

    /// Goes on with the drag, ends it, or takes it back.
    fn follow(
        &mut self,
        ui: &Ui,
        frame: &Frame,
        keys: (Modifiers, eframe::egui::Vec2),
        actions: &mut Actions,
    ) {
        let Some(drag) = &mut self.drag else { return };
        let (at, is_down) = ui.input(|i| (i.pointer.interact_pos(), i.pointer.any_down()));
        if !drag.is_cancelled && ui.input(|i| i.key_pressed(Key::Escape)) {
            drag.is_cancelled = true;
            if drag.has_changed {
                actions.push(Action::Undo);
            }
        }
        if let Some(at) = at {
            let pointer = Pointer { at, moved: keys.1, modifiers: keys.0 };
            if let Some(command) = drag.follow(&frame.projection, pointer) {
                actions.push(Action::Drag(command, drag.gesture));
            }
        }
        if !is_down {
            self.drag = None;
        }
    }

    /// The wheel goes nearer and farther; all of one turn is one step.
    fn turn_wheel(&mut self, ui: &Ui, response: &Response, frame: &Frame, actions: &mut Actions) {
        if !response.hovered() || self.drag.is_some() {
            return;
        }
        let (scroll, pinch, time) = ui.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta(), i.time));
        let factor = (scroll * ZOOM).exp() * pinch;
        if (factor - 1.0).abs() < 1e-6 {
            return;
        }
        let going_on = self.wheel.filter(|(_, last)| time - last < WHEEL_RESTS);
        let gesture = going_on.map_or_else(|| self.new_gesture(), |(gesture, _)| gesture);
        self.wheel = Some((gesture, time));
        let zoom = CameraMove::Zoom { toward: middle(frame), factor };
        actions.push(Action::Drag(EditCommand::Camera(zoom), gesture));
    }
}

/// Things slide along the floor: what is selected, or what lies under the pointer, which is selected then.
fn slide(
    frame: &Frame,
    (at, modifiers): (Pos2, Modifiers),
    gesture: Gesture,
    actions: &mut Actions,
) -> Option<Drag> {
    let (thing, point) = frame.thing_at(at)?;
    // A plane has no end: it would only be moved by mistake.
    let scene = frame.document.scene();
    let object =
        thing.name().filter(|_| thing.list() == Some(ListName::Object)).and_then(|n| scene.object(n));
    if thing == Thing::Camera || object.is_some_and(|o| matches!(o.shape, Shape::Plane(_))) {
        return None;
    }
    let is_of_selected_group = || {
        let group = object.and_then(|o| o.group.as_deref());
        group.is_some_and(|group| frame.document.selection().contains(&Thing::group(group)))
    };
    let things = if frame.document.selection().contains(&thing) || is_of_selected_group() {
        frame.movable()
    } else {
        actions.push(Action::Select(vec![thing.clone()]));
        vec![thing]
    };
    Some(Drag::slide(things, point, modifiers, gesture))
}

/// A click selects, and with Ctrl or Shift adds or takes away; a double click brings to the middle.
fn click(response: &Response, frame: &Frame, modifiers: Modifiers, actions: &mut Actions) {
    let Some(at) = response.interact_pointer_pos() else { return };
    let thing = frame.thing_at(at).map(|(thing, _)| thing);
    if response.double_clicked() {
        actions.extend(thing.map(|thing| Action::Frame(vec![thing])));
        return;
    }
    let is_adding = modifiers.command || modifiers.shift;
    match thing {
        Some(thing) if is_adding => actions.push(Action::ToggleSelect(thing)),
        Some(thing) => actions.push(Action::Select(vec![thing])),
        None if is_adding || frame.handle_at(at).is_some() => {}
        None => actions.push(Action::Select(Vec::new())),
    }
}

/// The point around which the camera goes: the one that it looks at, else what is seen in the middle of the picture.
fn middle(frame: &Frame) -> Vec3 {
    let camera = &frame.document.scene().camera;
    let seen = || frame.live.pick(0.5, 0.5).map(|picked| picked.point);
    let somewhere = || camera.position + frame.projection.forward() * SOMEWHERE;
    camera.look_at.or_else(seen).unwrap_or_else(somewhere)
}
