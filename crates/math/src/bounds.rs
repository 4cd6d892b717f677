//! Axis-aligned boxes.

use glam::Vec3;

/// The points with `min ≤ p ≤ max` on every axis. [`Bounds3::EMPTY`] holds none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds3 {
    /// The corner with the smallest coordinates, metres.
    pub min: Vec3,
    /// The corner with the largest coordinates, metres.
    pub max: Vec3,
}

impl Default for Bounds3 {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Bounds3 {
    /// Holds no point; the neutral element of [`Bounds3::union`].
    pub const EMPTY: Self = Self { min: Vec3::splat(f32::INFINITY), max: Vec3::splat(f32::NEG_INFINITY) };

    /// The smallest box around the points.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::with_point)
    }

    /// The smallest box that holds this one and the point.
    #[must_use]
    pub fn with_point(self, p: Vec3) -> Self {
        Self { min: self.min.min(p), max: self.max.max(p) }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether it holds no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.min.cmpgt(self.max).any()
    }

    /// Whether the point lies inside or on the surface.
    #[must_use]
    pub fn contains(&self, p: Vec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }

    /// The middle.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// The lengths of the edges; negative infinity when empty.
    #[must_use]
    pub fn size(&self) -> Vec3 {
        self.max - self.min
    }

    /// Half of the surface's area, the measure of the surface area heuristic; zero when empty.
    #[must_use]
    pub fn half_area(&self) -> f32 {
        if self.is_empty() {
            return 0.0;
        }
        let e = self.size();
        e.x * e.y + e.y * e.z + e.z * e.x
    }

    /// The eight corners.
    #[must_use]
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            Vec3::new(
                if i & 1 == 0 { self.min.x } else { self.max.x },
                if i & 2 == 0 { self.min.y } else { self.max.y },
                if i & 4 == 0 { self.min.z } else { self.max.z },
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_is_neutral_and_has_no_area() {
        let unit = Bounds3 { min: Vec3::ZERO, max: Vec3::ONE };
        assert_eq!(Bounds3::EMPTY.union(unit), unit);
        assert_eq!(Bounds3::EMPTY.half_area(), 0.0);
        assert!(Bounds3::EMPTY.is_empty() && !unit.is_empty());
    }

    #[test]
    fn corners_span_the_box() {
        let b = Bounds3 { min: Vec3::new(-1.0, 0.0, 2.0), max: Vec3::new(1.0, 5.0, 3.0) };
        assert_eq!(Bounds3::around(b.corners()), b);
        assert_eq!(b.half_area(), 2.0 * 5.0 + 5.0 + 2.0);
        assert!(b.contains(b.center()));
    }
}
