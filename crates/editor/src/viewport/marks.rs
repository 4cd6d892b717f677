//! Small icons in the picture for what the camera does not see: lights, and the point that the camera looks at.

use super::handles::position_of;
use super::projection::Projection;
use crate::document::{Selection, Thing};
use crate::theme::{Theme, icons};
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Stroke, Vec2, vec2};
use vitrine::math::Vec3;
use vitrine::scene::{ListName, Scene};

/// An icon in the picture.
#[derive(Clone, Debug)]
pub struct Mark {
    /// What it stands for.
    pub thing: Thing,
    /// Where in the scene.
    pub point: Vec3,
    /// Where in the window.
    pub at: Pos2,
    icon: &'static str,
    is_off: bool,
}

/// The icons of all lights that have a place, and of the camera's target while the camera is selected.
#[must_use]
pub fn marks(scene: &Scene, selection: &Selection, projection: &Projection) -> Vec<Mark> {
    let light = |light: &vitrine::scene::Light| {
        let point = position_of(light)?;
        Some(Mark {
            thing: Thing::light(&light.name),
            point,
            at: projection.project(point)?,
            icon: icons::of_item(ListName::Light, light.source.kind()),
            is_off: !light.visible,
        })
    };
    let target = |point: Vec3| {
        let at = projection.project(point)?;
        Some(Mark { thing: Thing::Camera, point, at, icon: icons::FOCUS, is_off: false })
    };
    let target = scene.camera.look_at.filter(|_| selection.contains(&Thing::Camera)).and_then(target);
    scene.lights.iter().filter_map(light).chain(target).collect()
}

/// The icon under a point of the window.
#[must_use]
pub fn mark_at<'a>(marks: &'a [Mark], at: Pos2, theme: &Theme) -> Option<&'a Mark> {
    let distance = |mark: &&Mark| (mark.at - at).length();
    let nearest = marks.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.filter(|mark| distance(mark) <= theme.sizes.icon)
}

impl Mark {
    /// Draws it.
    pub fn paint(&self, painter: &Painter, theme: &Theme, is_selected: bool, is_hot: bool) {
        let color = match (is_hot, is_selected, self.is_off) {
            (true, ..) => theme.handle_hover,
            (_, true, _) => theme.outline,
            (.., true) => theme.text_muted,
            _ => theme.handle,
        };
        painter.circle_filled(self.at, theme.sizes.icon * 0.75, theme.outline_seam);
        let font = FontId::proportional(theme.sizes.icon);
        painter.text(self.at, Align2::CENTER_CENTER, self.icon, font, color);
        if is_selected {
            brackets(
                painter,
                Rect::from_center_size(self.at, Vec2::splat(2.0 * theme.sizes.icon)),
                theme,
                color,
            );
        }
    }
}

/// The four corners of a rectangle.
fn brackets(painter: &Painter, rect: Rect, theme: &Theme, color: Color32) {
    let arm = rect.width() * 0.25;
    let corners = [
        (rect.left_top(), vec2(1.0, 1.0)),
        (rect.right_top(), vec2(-1.0, 1.0)),
        (rect.left_bottom(), vec2(1.0, -1.0)),
        (rect.right_bottom(), vec2(-1.0, -1.0)),
    ];
    for (corner, inwards) in corners {
        let line = vec![corner + vec2(inwards.x * arm, 0.0), corner, corner + vec2(0.0, inwards.y * arm)];
        painter.line(line, Stroke::new(theme.sizes.line_bold, color));
    }
}
