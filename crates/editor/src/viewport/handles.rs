//! The handles at what is selected: arrows to move, rings to turn, boxes to size.

use super::projection::Projection;
use crate::document::Thing;
use crate::theme::Theme;
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2};
use vitrine::math::{Axis, Transform, Vec3};
use vitrine::scene::lights::Emission;
use vitrine::scene::{Assets, Light, ListName, Object, Scene};

/// Points on a ring.
const RING: usize = 64;
/// Where on its arm a handle begins: the middle stays free.
const ARM_START: f32 = 0.25;
/// An arm that is seen so much from its end, as a part of its length, has no handle.
const SHORTEST: f32 = 0.12;

/// What a drag of a handle does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Moves.
    #[default]
    Move,
    /// Turns.
    Turn,
    /// Makes larger or smaller.
    Size,
}

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Along or about an axis, 0 to 2 for X, Y, Z.
    Axis(usize),
    /// All axes alike.
    All,
}

/// The handles of a thing.
#[derive(Clone, Copy, Debug)]
pub struct Handles {
    /// What they do.
    pub tool: Tool,
    /// The middle, world space.
    pub pivot: Vec3,
    /// Unit directions: of the world, to size those of the thing itself.
    pub axes: [Vec3; 3],
    /// The length of an arm, metres.
    arm: f32,
}

/// The axis of that number.
#[must_use]
pub const fn axis_of(index: usize) -> Axis {
    match index {
        0 => Axis::X,
        1 => Axis::Y,
        _ => Axis::Z,
    }
}

/// Where a thing is; None for what has no place in the picture.
#[must_use]
pub fn place_of(scene: &Scene, thing: &Thing) -> Option<Transform> {
    match thing {
        Thing::Item(ListName::Object, name) => Some(scene.world_from_object(scene.object(name)?)),
        Thing::Item(ListName::Group, name) => {
            scene.group(name)?;
            Some(scene.world_from_object(&Object { group: Some(name.clone()), ..Object::default() }))
        }
        Thing::Item(ListName::Light, name) => {
            let light = scene.lights.iter().find(|l| l.name == *name)?;
            let at = position_of(light)?;
            Some(Transform::from_place(at, Vec3::ZERO, Vec3::ONE))
        }
        Thing::Item(..) | Thing::Settings | Thing::Camera => None,
    }
}

/// Where a light hangs; None for light without a place.
#[must_use]
pub fn position_of(light: &Light) -> Option<Vec3> {
    // What has a place needs no file.
    match light.source.as_kind().emission(&Assets::default())? {
        Emission::Point { position }
        | Emission::Disc { position, .. }
        | Emission::Sphere { position, .. } => Some(position),
        Emission::Everywhere
        | Emission::Direction { .. }
        | Emission::Environment { .. }
        | Emission::Sky { .. } => None,
    }
}

impl Handles {
    /// The handles of a tool at a thing, their arms so many points long. None when it cannot be handled so.
    #[must_use]
    pub fn at(
        tool: Tool,
        scene: &Scene,
        thing: &Thing,
        (projection, arm): (&Projection, f32),
    ) -> Option<Self> {
        let place = place_of(scene, thing)?;
        if tool != Tool::Move && thing.list() == Some(ListName::Light) {
            return None;
        }
        let pivot = place.point(Vec3::ZERO);
        projection.project(pivot)?;
        let world = [Vec3::X, Vec3::Y, Vec3::Z];
        let axes = match tool {
            Tool::Move | Tool::Turn => world,
            Tool::Size => world.map(|axis| place.vector(axis).try_normalize().unwrap_or(axis)),
        };
        Some(Self { tool, pivot, axes, arm: arm * projection.metres_a_point(pivot) })
    }

    /// The length of an arm, metres.
    #[must_use]
    pub const fn arm(&self) -> f32 {
        self.arm
    }

    /// The handle under a point of the window, no farther than so many points.
    #[must_use]
    pub fn under(&self, projection: &Projection, at: Pos2, grab: f32) -> Option<Handle> {
        let middle = projection.project(self.pivot)?;
        if self.tool == Tool::Size && (at - middle).length() <= grab {
            return Some(Handle::All);
        }
        let distance = |k: usize| {
            let line = self.line(projection, k);
            let pieces = line.windows(2).map(|ends| from_segment(at, [ends[0], ends[1]]));
            (pieces.fold(f32::INFINITY, f32::min), k)
        };
        let nearest = (0..3).map(distance).min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.filter(|(distance, _)| *distance <= grab).map(|(_, k)| Handle::Axis(k))
    }

    /// A handle as a line in the window; empty when it cannot be seen.
    fn line(&self, projection: &Projection, k: usize) -> Vec<Pos2> {
        let at = |point: Vec3| projection.project(point);
        if self.tool == Tool::Turn {
            return self.ring(k).into_iter().filter_map(at).collect();
        }
        let along = self.axes[k] * self.arm;
        let arm = at(self.pivot + along * ARM_START).zip(at(self.pivot + along)).zip(at(self.pivot));
        let Some(((start, end), middle)) = arm else { return Vec::new() };
        let whole = self.arm / projection.metres_a_point(self.pivot);
        if (end - middle).length() < SHORTEST * whole { Vec::new() } else { vec![start, end] }
    }

    /// The points of the ring about an axis, the last the same as the first.
    fn ring(&self, k: usize) -> Vec<Vec3> {
        let [u, v] = self.across(k);
        let turn = |i: usize| std::f32::consts::TAU * i as f32 / RING as f32;
        let point = |angle: f32| self.pivot + (u * angle.cos() + v * angle.sin()) * self.arm;
        (0..=RING).map(|i| point(turn(i))).collect()
    }

    /// Two directions across an axis, so that a turn about it goes from the first to the second.
    #[must_use]
    pub fn across(&self, k: usize) -> [Vec3; 2] {
        [self.axes[(k + 1) % 3], self.axes[(k + 2) % 3]]
    }

    /// Draws them; the one under the pointer or in the hand stands out.
    pub fn paint(&self, painter: &Painter, projection: &Projection, theme: &Theme, hot: Option<Handle>) {
        let Some(middle) = projection.project(self.pivot) else { return };
        for k in 0..3 {
            let is_hot = hot == Some(Handle::Axis(k));
            let color = if is_hot { theme.handle_hover } else { theme.axis(k) };
            let line = self.line(projection, k);
            let (Some(start), Some(end)) = (line.first().copied(), line.last().copied()) else { continue };
            for (width, color) in [(3.0, theme.outline_seam), (if is_hot { 2.0 } else { 1.0 }, color)] {
                painter.line(line.clone(), Stroke::new(width * theme.sizes.line_bold, color));
            }
            match self.tool {
                Tool::Move => tip(painter, theme, [start, end], color),
                Tool::Size => knob(painter, theme, end, color),
                Tool::Turn => {}
            }
        }
        let color = if hot == Some(Handle::All) { theme.handle_hover } else { theme.handle };
        match self.tool {
            Tool::Size => knob(painter, theme, middle, color),
            Tool::Move | Tool::Turn => {
                painter.circle(
                    middle,
                    theme.sizes.gap_s,
                    color,
                    Stroke::new(theme.sizes.line, theme.outline_seam),
                );
            }
        }
    }
}

fn tip(painter: &Painter, theme: &Theme, [start, end]: [Pos2; 2], color: Color32) {
    let along = (end - start).normalized() * theme.sizes.gap_l;
    let across = Vec2::new(-along.y, along.x) * 0.45;
    let corners = vec![end + along * 0.5, end - along * 0.5 + across, end - along * 0.5 - across];
    painter.add(Shape::convex_polygon(corners, color, Stroke::new(theme.sizes.line, theme.outline_seam)));
}

fn knob(painter: &Painter, theme: &Theme, at: Pos2, color: Color32) {
    let rect = Rect::from_center_size(at, Vec2::splat(theme.sizes.gap_l));
    painter.rect_filled(rect.expand(theme.sizes.line), theme.sizes.gap_xs, theme.outline_seam);
    painter.rect_filled(rect, theme.sizes.gap_xs, color);
}

/// How far a point is from a piece of a line.
fn from_segment(at: Pos2, [a, b]: [Pos2; 2]) -> f32 {
    let along = b - a;
    let share = if along == Vec2::ZERO { 0.0 } else { (at - a).dot(along) / along.length_sq() };
    (at - (a + along * share.clamp(0.0, 1.0))).length()
}
