//! Where a thing stands: turned, scaled and moved.

use crate::Bounds3;
use glam::{Affine3A, Mat3, Vec3};

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// To the right.
    X,
    /// Up.
    Y,
    /// Towards a camera that is not turned.
    Z,
}

impl Axis {
    /// The rotation about this axis by an angle in degrees, right-handed (course work, section 1.5).
    #[must_use]
    pub fn rotation_deg(self, angle_deg: f32) -> Mat3 {
        let (s, c) = sin_cos_deg(angle_deg);
        match self {
            Self::X => Mat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, c, s, 0.0, -s, c]),
            Self::Y => Mat3::from_cols_array(&[c, 0.0, -s, 0.0, 1.0, 0.0, s, 0.0, c]),
            Self::Z => Mat3::from_cols_array(&[c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0]),
        }
    }
}

/// Sine and cosine of an angle in degrees; multiples of 90° are exact, so a quarter turn leaves no crumbs.
fn sin_cos_deg(angle_deg: f32) -> (f32, f32) {
    let turn = angle_deg % 360.0;
    let quarters = libm::roundf(turn / 90.0);
    let (s, c) = libm::sincosf((turn - 90.0 * quarters).to_radians());
    match (quarters as i32).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// The rotation that turns about the world's X axis, then Y, then Z, by degrees.
#[must_use]
pub fn rotation_from_turn(turn_deg: Vec3) -> Mat3 {
    Axis::Z.rotation_deg(turn_deg.z) * Axis::Y.rotation_deg(turn_deg.y) * Axis::X.rotation_deg(turn_deg.x)
}

/// The angles, in degrees, whose turns about the world's X axis, then Y, then Z make this rotation: [`rotation_from_turn`]
/// the other way round.
#[must_use]
pub fn turn_from_rotation(r: Mat3) -> Vec3 {
    // R = Rz·Ry·Rx, so the first column is (cz·cy, sz·cy, −sy).
    let (x, y, z) = (r.x_axis, r.y_axis, r.z_axis);
    let sin_y = (-x.z).clamp(-1.0, 1.0);
    let turn = if sin_y.abs() < 0.999_999 {
        Vec3::new(libm::atan2f(y.z, z.z), libm::asinf(sin_y), libm::atan2f(x.y, x.x))
    } else {
        // Turned along the axis of the first turn: the third can take its part.
        Vec3::new(libm::atan2f(-z.y, y.y), libm::asinf(sin_y), 0.0)
    };
    turn * 180.0 / std::f32::consts::PI
}

/// An affine map from an object's own space to the world, with its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// From object space to world space.
    pub world_from_object: Affine3A,
    /// From world space to object space.
    pub object_from_world: Affine3A,
}

impl Default for Transform {
    fn default() -> Self {
        Self { world_from_object: Affine3A::IDENTITY, object_from_world: Affine3A::IDENTITY }
    }
}

impl Transform {
    /// Scaled along its own axes, turned about the world's axes (X, then Y, then Z, degrees), moved to `position`.
    ///
    /// No component of `scale` may be zero.
    #[must_use]
    pub fn from_place(position: Vec3, turn_deg: Vec3, scale: Vec3) -> Self {
        let rotation = rotation_from_turn(turn_deg);
        let forward = rotation * Mat3::from_diagonal(scale);
        // (R·S)⁻¹ = S⁻¹·Rᵀ: exact where a general inverse would lose digits.
        let back = Mat3::from_diagonal(scale.recip()) * rotation.transpose();
        Self {
            world_from_object: Affine3A::from_mat3_translation(forward, position),
            object_from_world: Affine3A::from_mat3_translation(back, -(back * position)),
        }
    }

    /// First `inner`, then `self`: `world_from_group ∘ group_from_object`.
    #[must_use]
    pub fn after(&self, inner: &Self) -> Self {
        Self {
            world_from_object: self.world_from_object * inner.world_from_object,
            object_from_world: inner.object_from_world * self.object_from_world,
        }
    }

    /// A point of object space in world space.
    #[must_use]
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.world_from_object.transform_point3(p)
    }

    /// A direction of object space in world space; its length changes with the scale.
    #[must_use]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        self.world_from_object.transform_vector3(v)
    }

    /// A normal of object space in world space, of unit length: by the inverse transpose.
    #[must_use]
    pub fn normal(&self, n: Vec3) -> Vec3 {
        let across = self.object_from_world.matrix3.transpose() * glam::Vec3A::from(n);
        let largest = across.abs().max_element();
        // Squares of numbers much smaller than this would not be there.
        let across = if largest < 1e-15 { across / largest } else { across };
        across.normalize().into()
    }

    /// The box in world space around a box of object space.
    #[must_use]
    pub fn bounds(&self, b: &Bounds3) -> Bounds3 {
        if b.is_empty() {
            return *b;
        }
        Bounds3::around(b.corners().map(|c| self.point(c)))
    }

    /// How many times longer every length becomes, or None when that depends on the direction.
    #[must_use]
    pub fn uniform_scale(&self) -> Option<f32> {
        let m = self.world_from_object.matrix3;
        let (x, y, z) = (m.x_axis.length(), m.y_axis.length(), m.z_axis.length());
        let near = |a: f32, b: f32| (a - b).abs() <= 1e-5 * a.max(b);
        let perpendicular = |a: glam::Vec3A, b: glam::Vec3A| a.dot(b).abs() <= 1e-5 * x * x;
        (near(x, y)
            && near(y, z)
            && perpendicular(m.x_axis, m.y_axis)
            && perpendicular(m.y_axis, m.z_axis)
            && perpendicular(m.z_axis, m.x_axis))
        .then_some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact_and_right_handed() {
        assert_eq!(Axis::X.rotation_deg(90.0) * Vec3::Y, Vec3::Z);
        assert_eq!(Axis::Y.rotation_deg(90.0) * Vec3::Z, Vec3::X);
        assert_eq!(Axis::Z.rotation_deg(90.0) * Vec3::X, Vec3::Y);
        assert_eq!(Axis::Y.rotation_deg(-450.0) * Vec3::Z, Vec3::NEG_X);
        assert_eq!(Axis::Z.rotation_deg(180.0) * Vec3::X, Vec3::NEG_X);
    }

    #[test]
    fn turns_apply_x_then_y_then_z() {
        let r = rotation_from_turn(Vec3::new(90.0, 90.0, 0.0));
        // Y →(X) Z →(Y) X
        assert_eq!(r * Vec3::Y, Vec3::X);
    }

    #[test]
    fn angles_are_found_again_from_the_rotation() {
        for turn in [Vec3::new(10.0, 35.0, -20.0), Vec3::new(-170.0, 80.0, 3.0), Vec3::new(40.0, 90.0, 30.0)]
        {
            let r = rotation_from_turn(turn);
            let again = rotation_from_turn(turn_from_rotation(r));
            assert!(again.abs_diff_eq(r, 2e-6), "{turn}: {again} instead of {r}");
        }
    }

    #[test]
    fn place_goes_there_and_back() {
        let t = Transform::from_place(
            Vec3::new(1.0, -2.0, 3.0),
            Vec3::new(20.0, 130.0, -75.0),
            Vec3::new(2.0, 0.5, 3.0),
        );
        let p = Vec3::new(0.3, 0.7, -1.1);
        let back = t.object_from_world.transform_point3(t.point(p));
        assert!((back - p).length() < 1e-5, "{back}");
        assert_eq!(t.uniform_scale(), None);
    }

    #[test]
    fn normals_stay_perpendicular_under_uneven_scale() {
        let t = Transform::from_place(Vec3::ZERO, Vec3::new(0.0, 30.0, 0.0), Vec3::new(1.0, 4.0, 1.0));
        let (tangent, normal) = (Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, -1.0, 0.0));
        assert!(t.vector(tangent).dot(t.normal(normal)).abs() < 1e-6);
    }

    #[test]
    fn normals_have_a_length_at_any_scale() {
        for scale in [1e-18_f32, 1e-9, 1e9, 1e18, 1e25, 3e38] {
            let t =
                Transform::from_place(Vec3::ZERO, Vec3::new(20.0, 30.0, 40.0), Vec3::new(1.0, scale, -2.0));
            assert!(t.normal(Vec3::Y).is_normalized(), "{scale:e}");
        }
    }

    #[test]
    fn uniform_scale_is_seen_through_a_turn() {
        let t = Transform::from_place(Vec3::ONE, Vec3::new(10.0, 20.0, 30.0), Vec3::splat(2.5));
        assert!((t.uniform_scale().unwrap() - 2.5).abs() < 1e-5);
    }
}
