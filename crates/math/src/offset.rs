//! Where rays start that leave a surface: a little beside it, counted in floats. Wächter and Binder, "A Fast and Robust Method for
//! Avoiding Self-Intersection", Ray Tracing Gems, chapter 6. There numbers below a fixed threshold are moved by a fixed
//! length; here both follow from the size of the numbers, so that tiny and huge scenes do as well.

use glam::Vec3;

/// By how many floats a coordinate is moved where the normal is along its axis: some times what rounding can move a point, and
/// far less than can be seen.
pub const OFFSET_STEPS: f32 = 16.0;

/// The same length for coordinates that are small beside the largest number, as a part of that.
pub const OFFSET_SHARE: f32 = OFFSET_STEPS * f32::EPSILON;

/// Where a ray starts that leaves a surface at the point `p` towards the side to which the unit vector `n` points.
///
/// `reach` is the largest number that took part in finding the point, or the largest of its coordinates if that is larger:
/// rounding is a part of it.
#[inline]
#[must_use]
pub fn offset_origin(p: Vec3, n: Vec3, reach: f32) -> Vec3 {
    Vec3::new(offset(p.x, n.x, reach), offset(p.y, n.y, reach), offset(p.z, n.z, reach))
}

#[inline]
fn offset(p: f32, n: f32, reach: f32) -> f32 {
    // Below the smallest normal number there are too few floats to count on.
    if p.abs() <= (0.5 * reach).max(f32::MIN_POSITIVE) {
        return p + n * (OFFSET_SHARE * reach);
    }
    // The bits of a float order as its size does, so a step is the next float, away from 0 or towards it.
    let steps = (OFFSET_STEPS * n) as i32;
    let outwards = if p < 0.0 { -steps } else { steps };
    f32::from_bits(p.to_bits().wrapping_add_signed(outwards))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hash;

    fn number(i: u32) -> f32 {
        2.0 * hash::unit(hash::mix(i)) - 1.0
    }

    #[test]
    fn it_moves_along_the_normal_and_no_farther_than_the_share() {
        for scale in [1e-30_f32, 1e-6, 1.0, 77.0, 1e12] {
            for i in 0..3000 {
                let p = Vec3::new(number(6 * i), number(6 * i + 1), number(6 * i + 2)) * scale;
                let n = Vec3::new(number(6 * i + 3), number(6 * i + 4), number(6 * i + 5)).normalize();
                for reach in [p.abs().max_element(), 3.0 * scale] {
                    let by = (offset_origin(p, n, reach) - p) / (OFFSET_SHARE * reach);
                    assert!(by.dot(n) > 0.2, "{p} {n}: off the surface by {by}");
                    assert!(by.length() < 1.1, "{p} {n}: {by} is too far");
                }
            }
        }
    }

    #[test]
    fn numbers_as_large_as_the_reach_move_by_floats() {
        let steps = |p: f32, n: f32| {
            let moved = offset(p, n, p.abs());
            i64::from(moved.to_bits()) - i64::from(p.to_bits())
        };
        for p in [1.0, -1.0, 3e-38, -2.5e-20, 1e30] {
            assert_eq!(steps(p, 1.0).abs(), 16, "{p}");
            assert!(offset(p, 1.0, p.abs()) > p && offset(p, -1.0, p.abs()) < p);
        }
        assert_eq!(steps(5.0, 0.5), 8);
    }

    #[test]
    fn across_a_power_of_two_steps_only_get_smaller() {
        let below = offset(1.0, -1.0, 1.0);
        assert_eq!(below, 1.0 - 8.0 * f32::EPSILON);
    }

    #[test]
    fn at_the_origin_of_the_world_the_reach_decides() {
        assert_eq!(offset_origin(Vec3::ZERO, Vec3::Y, 2.0), Vec3::Y * (2.0 * OFFSET_SHARE));
        assert_eq!(offset_origin(Vec3::ZERO, -Vec3::Y, 0.0), Vec3::ZERO);
        let least = f32::from_bits(3);
        assert!(offset_origin(Vec3::splat(least), -Vec3::ONE, least).is_finite());
    }
}
