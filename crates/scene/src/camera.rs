//! The camera: where it stands, where it looks.

use crate::{ParamKind, Range};
use vitrine_math::{Axis, Mat3, Vec3, rotation_from_turn, turn_from_rotation};

crate::params! {
    /// The eye. Not turned, it looks along −Z with Y up.
    pub struct Camera {
        /// Where it stands.
        position: Vec3 = Vec3::new(0.0, 1.2, 6.0) => ParamKind::Vector(Range::ANY), Metres;
        /// How it is turned about the world's X axis, then Y, then Z. Not together with look_at.
        turn_deg: Option<Vec3> = None => ParamKind::Vector(Range::ANY), Degrees;
        /// The point that it looks at, the picture's middle; Y stays up. Not together with turn_deg.
        look_at: Option<Vec3> = None => ParamKind::Vector(Range::ANY), Metres;
        /// The angle that the picture's height spans.
        view_angle_deg: f32 = 50.0 => ParamKind::Number(Range::from_to(1.0, 170.0)), Degrees;
        /// How far away things are sharp, if f_stop is stated. Where nothing is stated, as far as look_at is, else 2 m.
        focus_distance: Option<f32> = None => ParamKind::Number(Range::POSITIVE), Metres;
        /// The aperture's number, as on a camera for 35 mm film: 1.4 blurs what is not in focus, 16 hardly. Where nothing is stated, everything is sharp. Photoreal only.
        f_stop: Option<f32> = None => ParamKind::Number(Range::from_to(0.5, 128.0)), None;
        /// How many blades form the aperture, the corners of blurred points of light: 0 is round, else 3 or more.
        blades: u32 = 0 => ParamKind::Integer { min: 0, max: 16 }, None;
    }
}

/// A fault of several parameters taken together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The parameter to blame.
    pub key: &'static str,
    /// What is wrong.
    pub message: &'static str,
    /// How to mend it.
    pub help: &'static str,
}

impl Camera {
    /// From camera space (−Z forward, Y up) to world space. Its columns are the camera's right, up and back.
    #[must_use]
    pub fn rotation(&self) -> Mat3 {
        match (self.look_at, self.turn_deg) {
            (Some(target), _) => looking_along(target - self.position),
            (None, turn) => rotation_from_turn(turn.unwrap_or(Vec3::ZERO)),
        }
    }

    /// How far away things are sharp, metres: as stated, else as far as the point is that it looks at, else 2.
    #[must_use]
    pub fn focus(&self) -> f32 {
        let to_target = self.look_at.map(|target| (target - self.position).length());
        self.focus_distance.or(to_target.filter(|d| *d > 0.0 && d.is_finite())).unwrap_or(2.0)
    }

    /// Turns the camera about an axis of the world through itself (course work, section 3.3). What was aimed by
    /// `look_at` is aimed by `turn_deg` afterwards.
    pub fn turn(&mut self, axis: Axis, angle_deg: f32) {
        self.turn_deg = Some(turn_from_rotation(axis.rotation_deg(angle_deg) * self.rotation()));
        self.look_at = None;
    }

    /// What is wrong with the parameters taken together.
    #[must_use]
    pub fn fault(&self) -> Option<Fault> {
        if self.look_at.is_some() && self.turn_deg.is_some() {
            return Some(Fault {
                key: "look_at",
                message: "the camera has both `turn_deg` and `look_at`",
                help: "keep the one that you mean and remove the other",
            });
        }
        if matches!(self.blades, 1 | 2) {
            return Some(Fault {
                key: "blades",
                message: "an aperture of one or two blades has no opening",
                help: "0 is round; otherwise 3 blades or more",
            });
        }
        let target = self.look_at?;
        let offset = target - self.position;
        (!offset.is_finite() || offset.abs().max_element() <= f32::MIN_POSITIVE).then_some(Fault {
            key: "look_at",
            message: "the camera cannot look at the point where it stands",
            help: "give `look_at` a point at some distance from `position`",
        })
    }
}

/// The rotation of a camera that looks along `forward` with Y up.
fn looking_along(forward: Vec3) -> Mat3 {
    let longest = forward.abs().max_element();
    if !(longest > 0.0 && longest.is_finite()) {
        return Mat3::IDENTITY;
    }
    let back = -(forward / longest).normalize();
    let right = Vec3::Y.cross(back);
    // Straight up or down leaves "right" open: keep the world's X.
    let right = if right.length_squared() > 1e-12 { right.normalize() } else { Vec3::X };
    Mat3::from_cols(right, back.cross(right), back)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn forward(camera: &Camera) -> Vec3 {
        camera.rotation() * Vec3::NEG_Z
    }

    #[test]
    fn not_turned_it_looks_along_minus_z() {
        assert_eq!(forward(&Camera::default()), Vec3::NEG_Z);
    }

    #[test]
    fn look_at_puts_the_target_in_the_middle_and_up_is_up() {
        let camera = Camera {
            position: Vec3::new(3.0, 2.0, 1.0),
            look_at: Some(Vec3::new(-1.0, 0.5, -4.0)),
            ..Camera::default()
        };
        let wanted = Vec3::new(-4.0, -1.5, -5.0).normalize();
        assert!((forward(&camera) - wanted).length() < 1e-6);
        assert!((camera.rotation() * Vec3::Y).y > 0.0);
        assert!((camera.rotation() * Vec3::X).y.abs() < 1e-6);
    }

    #[test]
    fn straight_down_has_no_nan() {
        let camera = Camera { look_at: Some(Vec3::new(0.0, 0.0, 6.0)), ..Camera::default() };
        assert_eq!(forward(&camera), Vec3::NEG_Y);
    }

    /// C13: turned by a given angle about a given axis.
    #[test]
    fn c13_turning_about_an_axis_is_the_world_rotation() {
        for (axis, angle) in [(Axis::X, 30.0), (Axis::Y, -110.0), (Axis::Z, 75.0), (Axis::Y, 90.0)] {
            let mut camera = Camera { turn_deg: Some(Vec3::new(10.0, 35.0, -20.0)), ..Camera::default() };
            let wanted = axis.rotation_deg(angle) * camera.rotation();
            camera.turn(axis, angle);
            let (a, b) = (camera.rotation().to_cols_array(), wanted.to_cols_array());
            let off = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(off < 2e-6, "{axis:?} {angle}: {off}");
        }
    }

    #[test]
    fn it_focuses_on_what_it_looks_at_unless_a_distance_is_stated() {
        assert_eq!(Camera::default().focus(), 2.0);
        let aimed = Camera { look_at: Some(Vec3::new(0.0, 1.2, 1.0)), ..Camera::default() };
        assert_eq!(aimed.focus(), 5.0);
        assert_eq!(Camera { focus_distance: Some(0.5), ..aimed }.focus(), 0.5);
    }

    #[test]
    fn both_aims_and_two_blades_are_faults() {
        let both = Camera { turn_deg: Some(Vec3::ZERO), look_at: Some(Vec3::ZERO), ..Camera::default() };
        assert_eq!(both.fault().map(|f| f.key), Some("look_at"));
        let two_blades = Camera { blades: 2, ..Camera::default() };
        assert_eq!(two_blades.fault().map(|f| f.key), Some("blades"));
        let nowhere = Camera { look_at: Some(Camera::default().position), ..Camera::default() };
        assert!(nowhere.fault().is_some());
    }
}
