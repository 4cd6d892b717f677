//! Directions drawn around the z axis, and the sines that they need.

use std::f32::consts::{FRAC_1_PI, FRAC_PI_2, TAU};
use vitrine_math::{Vec2, Vec3, warp};

/// Sine and cosine of 2πu for u in [0, 1), by Taylor series about the nearest quarter turn; off by 4e-7 at most.
#[inline]
pub(crate) fn sin_cos_turn(u: f32) -> (f32, f32) {
    let quarter = (4.0 * u + 0.5) as i32;
    let a = TAU * u - FRAC_PI_2 * quarter as f32;
    let a2 = a * a;
    let sin = a * (1.0 + a2 * (-1.0 / 6.0 + a2 * (1.0 / 120.0 + a2 * (-1.0 / 5040.0))));
    let cos = 1.0 + a2 * (-0.5 + a2 * (1.0 / 24.0 + a2 * (-1.0 / 720.0 + a2 * (1.0 / 40_320.0))));
    match quarter & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// A direction above the surface with the density cos θ/π (Malley's method).
#[inline]
pub(crate) fn cosine_hemisphere(u: [f32; 2]) -> Vec3 {
    let p = warp::concentric_disk(Vec2::from_array(u));
    Vec3::new(p.x, p.y, (1.0 - p.length_squared()).max(0.0).sqrt())
}

/// The density of [`cosine_hemisphere`], per steradian. `cos` is 0 to 1.
#[inline]
pub(crate) fn cosine_pdf(cos: f32) -> f32 {
    cos * FRAC_1_PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_has_its_sines() {
        for i in 0..4096_u16 {
            let u = f32::from(i) / 4096.0;
            let (sin, cos) = sin_cos_turn(u);
            let (s, c) = (std::f64::consts::TAU * f64::from(u)).sin_cos();
            assert!((f64::from(sin) - s).abs() < 6e-7 && (f64::from(cos) - c).abs() < 6e-7, "{u}");
        }
    }
}
