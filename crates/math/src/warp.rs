//! Maps from the unit square to where samples are wanted.

use glam::Vec2;
use std::f32::consts::FRAC_PI_4;

/// The unit disc, area for area, keeping strata compact (Shirley and Chiu, "A Low Distortion Map Between Disk and
/// Square", 1997). `u` is in [0, 1)².
///
/// Without branches, so that a loop over lanes vectorises.
#[inline(always)]
#[must_use]
pub fn concentric_disk(u: Vec2) -> Vec2 {
    let (x, y) = (2.0 * u.x - 1.0, 2.0 * u.y - 1.0);
    let is_wide = x.abs() > y.abs();
    let (long, short) = if is_wide { (x, y) } else { (y, x) };
    // In the middle the ratio is 0/0; any angle will do there, for the radius is 0.
    let ratio = short / if long == 0.0 { 1.0 } else { long };
    let (sin, cos) = sin_cos_eighth(ratio);
    if is_wide { Vec2::new(long * cos, long * sin) } else { Vec2::new(long * sin, long * cos) }
}

/// Sine and cosine of π/4·x for |x| ≤ 1, by their Taylor series; off by 3e-7 at most.
#[inline(always)]
fn sin_cos_eighth(x: f32) -> (f32, f32) {
    let a = FRAC_PI_4 * x;
    let a2 = a * a;
    let sin = a * (1.0 + a2 * (-1.0 / 6.0 + a2 * (1.0 / 120.0 + a2 * (-1.0 / 5040.0))));
    let cos = 1.0 + a2 * (-0.5 + a2 * (1.0 / 24.0 + a2 * (-1.0 / 720.0 + a2 * (1.0 / 40_320.0))));
    (sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hash;

    #[test]
    fn sine_and_cosine_are_right_to_single_precision() {
        for i in -1000..=1000_i16 {
            let x = f32::from(i) / 1000.0;
            let (sin, cos) = sin_cos_eighth(x);
            let angle = std::f64::consts::FRAC_PI_4 * f64::from(x);
            assert!((f64::from(sin) - angle.sin()).abs() < 4e-7, "sin at {x}");
            assert!((f64::from(cos) - angle.cos()).abs() < 4e-7, "cos at {x}");
        }
    }

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
