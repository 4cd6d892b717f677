//! Rays.

use glam::Vec3;

/// A half-line: the points `origin + t · direction` for `0 < t < t_max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts, in world space, metres.
    pub origin: Vec3,
    /// Where it goes. Need not be of unit length; `t` counts in its lengths.
    pub direction: Vec3,
    /// Hits at this distance or beyond do not count. Infinite for a ray without an end.
    pub t_max: f32,
}

impl Ray {
    /// A ray without an end.
    #[must_use]
    pub const fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction, t_max: f32::INFINITY }
    }

    /// The point at the distance `t`.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_counts_in_lengths_of_the_direction() {
        let ray = Ray::new(Vec3::X, Vec3::Y * 2.0);
        assert_eq!(ray.at(1.5), Vec3::new(1.0, 3.0, 0.0));
    }
}
