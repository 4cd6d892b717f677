//! Rays, and how one leaves a surface without hitting it again.

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

/// Where a ray must start so that it leaves the surface at `p` on the side of `n` and does not hit it again.
///
/// `n` is the unit geometric normal on the side to which the ray leaves. The point moves by integer
/// ulps, so the step fits the size of the coordinates: Wächter and Binder, "A Fast and Robust Method for
/// Avoiding Self-Intersection", Ray Tracing Gems, chapter 6.
#[must_use]
pub fn offset_origin(p: Vec3, n: Vec3) -> Vec3 {
    Vec3::new(offset_axis(p.x, n.x), offset_axis(p.y, n.y), offset_axis(p.z, n.z))
}

fn offset_axis(p: f32, n: f32) -> f32 {
    // The paper's constants: below 1/32 an ulp is too short, a fixed step takes over.
    const ORIGIN: f32 = 1.0 / 32.0;
    const FLOAT_SCALE: f32 = 1.0 / 65_536.0;
    const INT_SCALE: f32 = 256.0;
    if p.abs() < ORIGIN {
        return p + FLOAT_SCALE * n;
    }
    let steps = (INT_SCALE * n) as i32;
    let moved = p.to_bits() as i32 + if p < 0.0 { -steps } else { steps };
    f32::from_bits(moved as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_counts_in_lengths_of_the_direction() {
        let ray = Ray::new(Vec3::X, Vec3::Y * 2.0);
        assert_eq!(ray.at(1.5), Vec3::new(1.0, 3.0, 0.0));
    }

    #[test]
    fn offset_moves_to_the_side_of_the_normal_at_every_scale() {
        for scale in [1e-6_f32, 1e-3, 0.5, 1.0, 77.0, 1e6] {
            for sign in [-1.0, 1.0] {
                let p = Vec3::splat(sign * scale);
                let up = offset_origin(p, Vec3::Y);
                let down = offset_origin(p, Vec3::NEG_Y);
                assert!(up.y > p.y && down.y < p.y, "at {p}");
                assert_eq!((up.x, up.z), (p.x, p.z));
                assert!(up.y - p.y <= scale * 1e-4 + 2e-5, "step {} at {p}", up.y - p.y);
            }
        }
    }
}
