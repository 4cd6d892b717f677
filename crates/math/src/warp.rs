//! Maps from the unit square to where samples are wanted.

use glam::Vec2;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

/// The unit disc, area for area, keeping strata compact (Shirley and Chiu, "A Low Distortion Map Between Disk and
/// Square", 1997). `u` is in [0, 1)².
#[must_use]
pub fn concentric_disk(u: Vec2) -> Vec2 {
    let p = u * 2.0 - Vec2::ONE;
    if p == Vec2::ZERO {
        return Vec2::ZERO;
    }
    let (radius, angle) = if p.x.abs() > p.y.abs() {
        (p.x, FRAC_PI_4 * (p.y / p.x))
    } else {
        (p.y, FRAC_PI_2 - FRAC_PI_4 * (p.x / p.y))
    };
    let (sin, cos) = libm::sincosf(angle);
    Vec2::new(cos, sin) * radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hash;

    #[test]
    fn disk_is_covered_evenly() {
        // Rings of equal area and sectors of equal angle: chi-squared, 63 degrees of freedom.
        const N: u32 = 64_000;
        let mut bins = [0_u32; 64];
        for i in 0..N {
            let u = Vec2::new(hash::unit(hash::mix(2 * i)), hash::unit(hash::mix(2 * i + 1)));
            let p = concentric_disk(u);
            assert!(p.length_squared() <= 1.0 + 1e-6);
            let ring = (p.length_squared() * 8.0).min(7.0) as usize;
            let turn = (p.y.atan2(p.x) / std::f32::consts::TAU).rem_euclid(1.0);
            bins[ring * 8 + (turn * 8.0).min(7.0) as usize] += 1;
        }
        let expected = f64::from(N) / 64.0;
        let chi2: f64 = bins.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
        assert!(chi2 < 114.0, "chi² = {chi2}");
    }
}
