//! Where an object or a group stands: position, turn and scale, and what becomes of them in another space.

use vitrine::math::{Affine3A, Mat3, Transform, Vec3, turn_from_rotation};
use vitrine::scene::{Owner, Scene, Value};

/// Where an object or a group stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::document) struct Stand {
    /// In the space of its group.
    pub(in crate::document) position: Vec3,
    /// About X, then Y, then Z.
    pub(in crate::document) turn_deg: Vec3,
    /// Along its own axes.
    pub(in crate::document) scale: Vec3,
}

impl Stand {
    /// Where something stands; None when it is neither object nor group.
    pub(in crate::document) fn of(scene: &Scene, owner: Owner) -> Option<Self> {
        let vector = |key| match scene.value(owner, key)? {
            Value::Vector(v) => Some(v),
            _ => None,
        };
        Some(Self { position: vector("position")?, turn_deg: vector("turn_deg")?, scale: vector("scale")? })
    }

    /// As a map from its own space.
    pub(in crate::document) fn place(&self) -> Transform {
        Transform::from_place(self.position, self.turn_deg, self.scale)
    }

    /// The same stand told in the space to which `outer` leads. None when there it is askew: not a turn after a scale.
    pub(in crate::document) fn out_of(&self, outer: &Affine3A) -> Option<Self> {
        let position = outer.transform_point3(self.position);
        if outer.matrix3 == Affine3A::IDENTITY.matrix3 {
            return Some(Self { position, ..*self });
        }
        let m = Mat3::from(outer.matrix3 * self.place().world_from_object.matrix3);
        let columns = [m.x_axis, m.y_axis, m.z_axis];
        let lengths = columns.map(Vec3::length);
        let is_square =
            |i: usize, j: usize| columns[i].dot(columns[j]).abs() <= ASKEW * lengths[i] * lengths[j];
        if !(is_square(0, 1) && is_square(1, 2) && is_square(2, 0)) {
            return None;
        }
        let mut scale = Vec3::from_array(lengths).copysign(self.scale);
        if m.determinant() * scale.x * scale.y * scale.z < 0.0 {
            scale = -scale;
        }
        let rotation = Mat3::from_cols(m.x_axis / scale.x, m.y_axis / scale.y, m.z_axis / scale.z);
        let turn_deg = tidy_turn(turn_from_rotation(rotation));
        Some(Self { position, turn_deg, scale: scale.map(tidy_factor) })
    }
}

/// The greatest cosine between axes that still counts as a right angle.
const ASKEW: f32 = 1e-5;

/// The same turn in the angles that a person would write: as little as possible about X and Z, and without the crumbs of
/// rounding.
pub(in crate::document) fn tidy_turn(turn_deg: Vec3) -> Vec3 {
    let wrap = |v: f32| {
        if v > 180.0 {
            v - 360.0
        } else if v <= -180.0 {
            v + 360.0
        } else {
            v
        }
    };
    let tidy = turn_deg.map(|v| wrap(tidy_angle(v)));
    let other = Vec3::new(wrap(tidy.x + 180.0), wrap(180.0 - tidy.y), wrap(tidy.z + 180.0));
    if other.x.abs() + other.z.abs() < tidy.x.abs() + tidy.z.abs() { other } else { tidy }
}

/// An angle of few decimals, if it is one but for rounding.
fn tidy_angle(v: f32) -> f32 {
    let round = (v * 100.0).round() / 100.0;
    // Zero has one sign.
    if (v - round).abs() < 1e-4 { round + 0.0 } else { v }
}

/// A factor of few decimals, if it is one but for rounding.
fn tidy_factor(v: f32) -> f32 {
    let round = (v * 1000.0).round() / 1000.0;
    if round != 0.0 && (v - round).abs() < 2e-6 * v.abs() { round } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::math::rotation_from_turn;

    #[test]
    fn a_turn_stays_the_turn_and_reads_well() {
        for (turn, wanted) in [
            (Vec3::new(180.0, 60.0, 180.0), Vec3::new(0.0, 120.0, 0.0)),
            (Vec3::new(-180.0, -29.999_99, -180.0), Vec3::new(0.0, -150.0, 0.0)),
            (Vec3::new(10.0, 20.000_01, 30.0), Vec3::new(10.0, 20.0, 30.0)),
            (Vec3::new(170.0, 80.0, 100.0), Vec3::new(-10.0, 100.0, -80.0)),
        ] {
            let tidy = tidy_turn(turn);
            assert!((tidy - wanted).abs().max_element() < 1e-3, "{turn} became {tidy}");
            assert!(rotation_from_turn(tidy).abs_diff_eq(rotation_from_turn(turn), 1e-5));
        }
    }

    #[test]
    fn out_of_a_group_it_is_the_same_place_or_askew() {
        let stand = Stand {
            position: Vec3::new(1.0, 2.0, 3.0),
            turn_deg: Vec3::new(10.0, 20.0, 30.0),
            scale: Vec3::new(1.0, -2.0, 0.5),
        };
        for scale in [Vec3::splat(2.0), Vec3::splat(-0.5), Vec3::ONE] {
            let outer = Transform::from_place(Vec3::X, Vec3::new(40.0, -70.0, 5.0), scale);
            let alone = stand.out_of(&outer.world_from_object).unwrap();
            let (a, b) = (alone.place().world_from_object, outer.after(&stand.place()).world_from_object);
            assert!(a.abs_diff_eq(b, 1e-4), "{scale}: {a} instead of {b}");
        }
        let uneven = Transform::from_place(Vec3::X, Vec3::ZERO, Vec3::new(1.0, 2.0, 1.0));
        assert_eq!(stand.out_of(&uneven.world_from_object), None);
        let level = Stand { turn_deg: Vec3::new(0.0, 90.0, 0.0), ..stand };
        assert!(level.out_of(&uneven.world_from_object).is_some(), "quarter turns keep right angles");
    }
}
