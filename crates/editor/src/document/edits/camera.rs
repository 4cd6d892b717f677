//! Ways to move the camera. None of them tilts a camera that stands upright.

use super::Draft;
use super::stand::tidy_turn;
use crate::document::{CameraMove, EditError};
use vitrine::math::{Axis, Mat3, Vec3, turn_from_rotation};
use vitrine::scene::{Camera, Owner, Value};

/// How near to straight up or down an orbit goes, degrees.
const STEEPEST_DEG: f32 = 89.0;

impl Draft<'_> {
    /// Moves the camera.
    pub(super) fn move_camera(&mut self, change: CameraMove) -> Result<(), EditError> {
        match change {
            CameraMove::Orbit { around, right_deg, up_deg } => self.orbit(around, right_deg, up_deg),
            CameraMove::Pan { right, up } => {
                let by = self.scene.camera.rotation() * Vec3::new(right, up, 0.0);
                self.shift_camera(by)
            }
            CameraMove::Zoom { toward, factor } => self.zoom(toward, factor),
            CameraMove::Turn { axis, angle_deg } => {
                if !angle_deg.is_finite() {
                    return Err(EditError::BadNumbers);
                }
                let camera = &mut self.scene.camera;
                camera.turn(axis, angle_deg);
                camera.turn_deg = camera.turn_deg.map(tidy_turn);
                Ok(())
            }
            CameraMove::LookAt(target) => self.set_one(Owner::Camera, "look_at", Value::Vector(target)),
            CameraMove::Frame { center, radius } => self.frame(center, radius),
        }
    }

    fn shift_camera(&mut self, by: Vec3) -> Result<(), EditError> {
        let Camera { position, look_at, .. } = self.scene.camera;
        self.set_one(Owner::Camera, "position", Value::Vector(position + by))?;
        match look_at {
            Some(target) => self.set_one(Owner::Camera, "look_at", Value::Vector(target + by)),
            None => Ok(()),
        }
    }

    /// Turns place and direction of the camera about a point, so that the point stays where it is in the picture.
    fn orbit(&mut self, around: Vec3, right_deg: f32, up_deg: f32) -> Result<(), EditError> {
        if !(around.is_finite() && right_deg.is_finite() && up_deg.is_finite()) {
            return Err(EditError::BadNumbers);
        }
        let camera = self.scene.camera.clone();
        let rotation = camera.rotation();
        let forward = rotation * Vec3::NEG_Z;
        let elevation = forward.y.clamp(-1.0, 1.0).asin().to_degrees();
        // Going up the camera looks down more. One that is steeper already may stay so.
        let steepest = STEEPEST_DEG.max(elevation.abs());
        let down_deg = elevation - (elevation - up_deg).clamp(-steepest, steepest);
        let heading_deg = heading_deg(rotation);
        let turned_back = Axis::Y.rotation_deg(heading_deg);
        let pitch = turned_back * Axis::X.rotation_deg(-down_deg) * turned_back.transpose();
        let turn = Axis::Y.rotation_deg(right_deg) * pitch;

        let position = around + turn * (camera.position - around);
        self.set_one(Owner::Camera, "position", Value::Vector(position))?;
        match camera.look_at {
            Some(target) if target == around => Ok(()),
            Some(target) => {
                let target = around + turn * (target - around);
                self.set_one(Owner::Camera, "look_at", Value::Vector(target))
            }
            None => {
                let turn_deg = tidy_turn(turn_from_rotation(turn * rotation));
                self.set_one(Owner::Camera, "turn_deg", Value::Vector(turn_deg))
            }
        }
    }

    /// Comes so many times nearer to a point without turning, so that the point stays where it is in the picture.
    fn zoom(&mut self, toward: Vec3, factor: f32) -> Result<(), EditError> {
        if !(factor.is_finite() && factor > 0.0) {
            return Err(EditError::BadNumbers);
        }
        let Camera { position, look_at, .. } = self.scene.camera;
        let nearer = |p: Vec3| toward + (p - toward) / factor;
        self.set_one(Owner::Camera, "position", Value::Vector(nearer(position)))?;
        match look_at {
            Some(target) => self.set_one(Owner::Camera, "look_at", Value::Vector(nearer(target))),
            None => Ok(()),
        }
    }

    /// Steps back or forth and aside, without turning, until a ball fills the picture.
    fn frame(&mut self, center: Vec3, radius: f32) -> Result<(), EditError> {
        if !(center.is_finite() && radius.is_finite() && radius > 0.0) {
            return Err(EditError::BadNumbers);
        }
        let camera = &self.scene.camera;
        let [width, height] = self.scene.settings.size.map(|v| v as f32);
        let half_up = (camera.view_angle_deg / 2.0).to_radians();
        let half_aside = (half_up.tan() * width / height).atan();
        // A little air around it.
        let distance = 1.1 * radius / half_up.min(half_aside).sin();
        let position = center - camera.rotation() * Vec3::NEG_Z * distance;
        let has_target = camera.look_at.is_some();
        self.set_one(Owner::Camera, "position", Value::Vector(position))?;
        if has_target {
            self.set_one(Owner::Camera, "look_at", Value::Vector(center))?;
        }
        Ok(())
    }
}

/// How far a camera is turned about Y, degrees.
fn heading_deg(rotation: Mat3) -> f32 {
    let right = rotation.x_axis;
    (-right.z).atan2(right.x).to_degrees()
}
