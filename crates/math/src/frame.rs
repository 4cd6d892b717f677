//! A right-handed frame of three unit vectors around a normal.

use glam::Vec3;

/// Axes that are perpendicular to each other, of unit length. The third is the normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Along the surface.
    pub x: Vec3,
    /// Along the surface.
    pub y: Vec3,
    /// The normal.
    pub z: Vec3,
}

impl Frame {
    /// Around a unit normal; x and y are any that fit. Without a branch that would jump as the normal turns (Duff et al., "Building an
    /// Orthonormal Basis, Revisited", JCGT 6(1), 2017).
    #[inline]
    #[must_use]
    pub fn around(n: Vec3) -> Self {
        let sign = if n.z < 0.0 { -1.0 } else { 1.0 };
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        let x = Vec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
        let y = Vec3::new(b, sign + n.y * n.y * a, -n.y);
        Self { x, y, z: n }
    }

    /// A vector of the world in this frame.
    #[inline]
    #[must_use]
    pub fn local(&self, v: Vec3) -> Vec3 {
        Vec3::new(self.x.dot(v), self.y.dot(v), self.z.dot(v))
    }

    /// A vector of this frame in the world.
    #[inline]
    #[must_use]
    pub fn world(&self, v: Vec3) -> Vec3 {
        self.x * v.x + self.y * v.y + self.z * v.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hash;

    #[test]
    fn axes_are_unit_and_perpendicular_for_any_normal() {
        let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
        let random =
            (0..2000).map(|i| Vec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2)).normalize());
        for n in random.chain([Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z]) {
            let f = Frame::around(n);
            assert!((f.x.length() - 1.0).abs() < 1e-5 && (f.y.length() - 1.0).abs() < 1e-5);
            assert!(f.x.dot(f.y).abs() < 1e-5 && f.x.dot(n).abs() < 1e-5 && f.y.dot(n).abs() < 1e-5);
            assert!((f.x.cross(f.y) - n).length() < 1e-5, "right-handed");
            let v = Vec3::new(0.3, -0.5, 0.8);
            assert!((f.local(f.world(v)) - v).length() < 1e-5);
        }
    }
}
