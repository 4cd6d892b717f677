//! Drags: what the way of the pointer since the press means for what is selected, or for the camera.

use super::handles::{Handle, Handles, Tool, axis_of};
use super::projection::Projection;
use crate::document::{CameraMove, EditCommand, Gesture, Thing};
use eframe::egui::{Modifiers, Pos2, Vec2};
use vitrine::math::Vec3;

/// Steps while Ctrl is held: metres, degrees, parts of the size.
const SNAP_METRES: f32 = 0.25;
const SNAP_DEG: f32 = 15.0;
const SNAP_SIZE: f32 = 0.25;
/// Degrees that the camera goes around for each point of the window.
const ORBIT_DEG: f32 = 0.4;
/// Nothing is dragged farther away than so many times its distance from the camera.
const FARTHEST: f32 = 30.0;
/// Nothing is made smaller than this part of itself in one drag.
const SMALLEST: f32 = 0.01;
/// Points of the window that double the size, when all axes are sized alike.
const DOUBLE: f32 = 100.0;

/// A drag that goes on.
pub struct Drag {
    kind: Kind,
    /// All its edits are one step.
    pub gesture: Gesture,
    /// What is dragged.
    pub things: Vec<Thing>,
    /// Whether it has changed anything yet.
    pub has_changed: bool,
    /// Whether Esc has taken it back; then the rest of it does nothing.
    pub is_cancelled: bool,
}

/// The pointer as a drag sees it.
#[derive(Clone, Copy)]
pub struct Pointer {
    /// Where it is.
    pub at: Pos2,
    /// How far it has come since the last frame.
    pub moved: Vec2,
    /// Keys that are held.
    pub modifiers: Modifiers,
}

/// What is dragged, and how far it has come.
enum Kind {
    /// Along the floor, or up and down.
    Slide(Slide),
    /// Along an axis: where on it the pointer was, and metres so far.
    Along { point: Vec3, axis: Vec3, start: Option<f32>, applied: f32 },
    /// About an axis: the angle of the pointer, degrees as dragged and as applied.
    About { handles: Handles, k: usize, last: Option<f32>, total: f32, applied: f32 },
    /// Larger or smaller: along an axis or all alike.
    Grow { handles: Handles, handle: Handle, start: Option<f32>, from: Pos2, applied: f32 },
    /// The camera around a point.
    Orbit(Vec3),
    /// The camera sideways; a point keeps under the pointer.
    Pan(Vec3),
}

/// A slide. It starts anew, from where it has come, whenever Shift is pressed or released.
struct Slide {
    /// The point that was taken hold of.
    start: Vec3,
    /// How far it had come when Shift changed last, and where the pointer pointed then.
    base: Vec3,
    from: Option<Vec3>,
    is_upright: bool,
    applied: Vec3,
}

impl Drag {
    fn new(kind: Kind, things: Vec<Thing>, gesture: Gesture) -> Self {
        Self { kind, gesture, things, has_changed: false, is_cancelled: false }
    }

    /// Things, held at a point, slide along the floor, or with Shift up and down.
    #[must_use]
    pub fn slide(things: Vec<Thing>, start: Vec3, modifiers: Modifiers, gesture: Gesture) -> Self {
        // Both planes go through that point.
        let from = Some(start);
        let is_upright = modifiers.shift;
        let slide = Slide { start, base: Vec3::ZERO, from, is_upright, applied: Vec3::ZERO };
        Self::new(Kind::Slide(slide), things, gesture)
    }

    /// A handle is dragged, taken hold of at a point of the window.
    #[must_use]
    pub fn handle(
        (handles, handle): (Handles, Handle),
        things: Vec<Thing>,
        (projection, at): (&Projection, Pos2),
        gesture: Gesture,
    ) -> Self {
        let ray = projection.ray(at);
        let along = |axis| Projection::along_line(&ray, handles.pivot, axis);
        let kind = match (handles.tool, handle) {
            (Tool::Move, Handle::Axis(k)) => {
                let axis = handles.axes[k];
                Kind::Along { point: handles.pivot, axis, start: along(axis), applied: 0.0 }
            }
            (Tool::Turn, Handle::Axis(k)) => {
                let last = angle(&handles, k, projection, at);
                Kind::About { handles, k, last, total: 0.0, applied: 0.0 }
            }
            (_, handle) => {
                let start = match handle {
                    Handle::Axis(k) => along(handles.axes[k]),
                    Handle::All => None,
                };
                Kind::Grow { handles, handle, start, from: at, applied: 1.0 }
            }
        };
        Self::new(kind, things, gesture)
    }

    /// The camera goes around a point.
    #[must_use]
    pub fn orbit(around: Vec3, gesture: Gesture) -> Self {
        Self::new(Kind::Orbit(around), Vec::new(), gesture)
    }

    /// The camera goes sideways, so that a point keeps under the pointer.
    #[must_use]
    pub fn pan(point: Vec3, gesture: Gesture) -> Self {
        Self::new(Kind::Pan(point), Vec::new(), gesture)
    }

    /// Whether it moves the camera.
    #[must_use]
    pub const fn is_of_camera(&self) -> bool {
        matches!(self.kind, Kind::Orbit(_) | Kind::Pan(_))
    }

    /// The handle that is in the hand.
    #[must_use]
    pub fn held(&self) -> Option<Handle> {
        match &self.kind {
            Kind::Along { axis, .. } => {
                let k = [Vec3::X, Vec3::Y, Vec3::Z].iter().position(|v| v == axis);
                k.map(Handle::Axis)
            }
            Kind::About { k, .. } => Some(Handle::Axis(*k)),
            Kind::Grow { handle, .. } => Some(*handle),
            Kind::Slide(_) | Kind::Orbit(_) | Kind::Pan(_) => None,
        }
    }

    /// How far things have been turned, degrees.
    #[must_use]
    pub const fn turned_deg(&self) -> Option<f32> {
        match self.kind {
            Kind::About { applied, .. } => Some(applied),
            _ => None,
        }
    }

    /// The edit that the pointer's way since the last one asks for; None when there is nothing to change.
    pub fn follow(&mut self, projection: &Projection, pointer: Pointer) -> Option<EditCommand> {
        if self.is_cancelled {
            return None;
        }
        let things = self.things.clone();
        let snaps = pointer.modifiers.command;
        let command = match &mut self.kind {
            Kind::Slide(slide) => {
                let by = slide.follow(projection, pointer)?;
                EditCommand::Move { things, by }
            }
            Kind::Along { point, axis, start, applied } => {
                let now = Projection::along_line(&projection.ray(pointer.at), *point, *axis)?;
                let total = snapped(now - *start.get_or_insert(now), SNAP_METRES, snaps);
                let by = *axis * change(applied, total)?;
                EditCommand::Move { things, by }
            }
            Kind::About { handles, k, last, total, applied } => {
                let now = angle(handles, *k, projection, pointer.at)?;
                let step = now - last.replace(now).unwrap_or(now);
                // The short way round.
                *total += (step + 540.0).rem_euclid(360.0) - 180.0;
                let angle_deg = change(applied, snapped(*total, SNAP_DEG, snaps))?;
                EditCommand::Turn { things, axis: axis_of(*k), angle_deg }
            }
            Kind::Grow { handles, handle, start, from, applied } => {
                let total = match handle {
                    Handle::Axis(k) => {
                        let ray = projection.ray(pointer.at);
                        let now = Projection::along_line(&ray, handles.pivot, handles.axes[*k])?;
                        let start = *start.get_or_insert(now);
                        if start.abs() > f32::EPSILON { now / start } else { 1.0 }
                    }
                    Handle::All => {
                        let way = pointer.at - *from;
                        1.0 + (way.x - way.y) / DOUBLE
                    }
                };
                let least = if snaps { SNAP_SIZE } else { SMALLEST };
                let wanted = snapped(total, SNAP_SIZE, snaps).max(least);
                let before = *applied;
                change(applied, wanted)?;
                let factor = wanted / before;
                let mut by = Vec3::splat(factor);
                if let Handle::Axis(k) = handle {
                    by = Vec3::ONE;
                    by[*k] = factor;
                }
                EditCommand::Resize { things, by }
            }
            Kind::Orbit(around) => {
                let turn = pointer.moved * ORBIT_DEG;
                let (right_deg, up_deg) = (-turn.x, turn.y);
                EditCommand::Camera(CameraMove::Orbit { around: *around, right_deg, up_deg })
            }
            Kind::Pan(point) => {
                let way = pointer.moved * projection.metres_a_point(*point);
                EditCommand::Camera(CameraMove::Pan { right: -way.x, up: way.y })
            }
        };
        if self.is_of_camera() && pointer.moved == Vec2::ZERO {
            return None;
        }
        self.has_changed = true;
        Some(command)
    }
}

impl Slide {
    /// How much farther it goes.
    fn follow(&mut self, projection: &Projection, pointer: Pointer) -> Option<Vec3> {
        let is_upright = pointer.modifiers.shift;
        if is_upright != self.is_upright {
            (self.is_upright, self.base) = (is_upright, self.applied);
            self.from = self.pointed(projection, pointer.at);
        }
        let now = self.pointed(projection, pointer.at)?;
        let way = now - *self.from.get_or_insert(now);
        let way = if is_upright { Vec3::Y * way.y } else { Vec3::new(way.x, 0.0, way.z) };
        let total = self.base + way;
        let total =
            Vec3::from_array(total.to_array().map(|v| snapped(v, SNAP_METRES, pointer.modifiers.command)));
        let by = total - self.applied;
        self.applied = total;
        (by != Vec3::ZERO).then_some(by)
    }

    /// Where the pointer points: on the level plane, or on the upright one that faces the camera.
    fn pointed(&self, projection: &Projection, at: Pos2) -> Option<Vec3> {
        let held = self.start + self.base;
        let forward = projection.forward();
        let level = Vec3::new(forward.x, 0.0, forward.z).try_normalize().unwrap_or(Vec3::Z);
        let n = if self.is_upright { level } else { Vec3::Y };
        let point = Projection::on_plane(&projection.ray(at), held, n)?;
        let eye = projection.eye();
        ((point - eye).length() <= FARTHEST * (held - eye).length()).then_some(point)
    }
}

/// The pointer's angle on a ring, degrees.
fn angle(handles: &Handles, k: usize, projection: &Projection, at: Pos2) -> Option<f32> {
    let (ray, axis) = (projection.ray(at), handles.axes[k]);
    let [u, v] = handles.across(k);
    if ray.direction.dot(axis).abs() > 0.15 {
        let out = Projection::on_plane(&ray, handles.pivot, axis)? - handles.pivot;
        return Some(out.dot(v).atan2(out.dot(u)).to_degrees());
    }
    // A ring seen from its edge turns like a wheel under the finger: by the way along it.
    let along = axis.cross(projection.forward()).try_normalize()?;
    let metres = (at - projection.project(handles.pivot)?) * projection.metres_a_point(handles.pivot);
    let way = metres.x * along.dot(projection.right()) - metres.y * along.dot(projection.up());
    Some((way / handles.arm()).to_degrees())
}

/// To the nearest step, if at all.
fn snapped(value: f32, step: f32, snaps: bool) -> f32 {
    if snaps { (value / step).round() * step } else { value }
}

/// What is to be added to what was applied; None when that is nothing.
fn change(applied: &mut f32, wanted: f32) -> Option<f32> {
    let step = wanted - *applied;
    *applied = wanted;
    (step != 0.0).then_some(step)
}
