//! Where scattered light goes in fog, milk or frosted glass: the phase function of Henyey and Greenstein ("Diffuse
//! radiation in the galaxy", Astrophysical Journal 93, 1941).
//!
//! Here, too, `wo` and `wi` both point away from the point, so light that goes straight on has wi = −wo.

use crate::sampling::sin_cos_turn;
use std::f32::consts::PI;
use vitrine_math::Vec3;

/// Below this, scattering is as good as even, and the formula for the angle would divide by nearly 0.
const EVEN: f32 = 1e-3;

/// The phase function, per steradian; its integral over the sphere is 1.
///
/// `cos` is ⟨−wo, wi⟩, 1 straight on. `g`, −1 to 1 (both excluded), is its mean: 0 scatters evenly, above 0 forward.
///
///   p(cos θ) = (1 − g²)/(4π(1 + g² − 2g cos θ)^{3/2})
#[inline]
#[must_use]
pub fn henyey_greenstein(cos: f32, g: f32) -> f32 {
    let bottom = (1.0 + g * g - 2.0 * g * cos).max(1e-7);
    (1.0 - g * g) / (4.0 * PI * bottom * bottom.sqrt())
}

/// A direction drawn from [`henyey_greenstein`], and the density there, per steradian.
#[must_use]
pub fn sample_hg(wo: Vec3, g: f32, u: [f32; 2]) -> (Vec3, f32) {
    let cos = if g.abs() < EVEN {
        1.0 - 2.0 * u[0]
    } else {
        // cos θ = (1 + g² − ((1 − g²)/(1 − g + 2gξ))²)/(2g)
        let ratio = (1.0 - g * g) / (1.0 - g + 2.0 * g * u[0]);
        ((1.0 + g * g - ratio * ratio) / (2.0 * g)).clamp(-1.0, 1.0)
    };
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    let (sin_phi, cos_phi) = sin_cos_turn(u[1]);
    let (x, y) = wo.any_orthonormal_pair();
    let wi = x * (sin * cos_phi) + y * (sin * sin_phi) - wo * cos;
    let pdf = if g.abs() < EVEN { 0.25 / PI } else { henyey_greenstein(cos, g) };
    (wi, pdf)
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine_math::hash;

    #[test]
    fn it_integrates_to_one_and_has_the_mean_g() {
        const N: u16 = 20_000;
        for g in [-0.8_f32, -0.3, 0.0, 0.5, 0.9] {
            let (mut total, mut mean) = (0.0_f64, 0.0_f64);
            for i in 0..N {
                let cos = 2.0 * (f64::from(i) + 0.5) / f64::from(N) - 1.0;
                let p = std::f64::consts::TAU * f64::from(henyey_greenstein(cos as f32, g));
                total += p * 2.0 / f64::from(N);
                mean += p * cos * 2.0 / f64::from(N);
            }
            assert!((total - 1.0).abs() < 1e-4, "{g}: {total}");
            assert!((mean - f64::from(g)).abs() < 1e-4, "{g}: {mean}");
        }
    }

    #[test]
    fn samples_follow_it() {
        const N: u32 = 40_000;
        const BINS: usize = 50;
        let wo = Vec3::new(0.48, -0.6, 0.64);
        let (x, y) = wo.any_orthonormal_pair();
        for g in [-0.5_f32, 0.0, 0.7] {
            let mut bins = [[0_u32; BINS]; 2];
            for i in 0..N {
                let u = [hash::unit(hash::mix(2 * i)), hash::unit(hash::mix(2 * i + 1))];
                let (wi, pdf) = sample_hg(wo, g, u);
                assert!((wi.length() - 1.0).abs() < 1e-5);
                let cos = -wo.dot(wi);
                assert!((pdf - henyey_greenstein(cos, g)).abs() <= 2e-3 * pdf, "{g}: {pdf}");
                // ∫p from −1 to cos: (1 − g²)/(2g)·(1/√(1 + g² − 2g cos θ) − 1/(1 + g))
                let below = if g == 0.0 {
                    0.5 * (cos + 1.0)
                } else {
                    let root = (1.0 + g * g - 2.0 * g * cos).sqrt();
                    (1.0 - g * g) / (2.0 * g) * (1.0 / root - 1.0 / (1.0 + g))
                };
                let turn = (wi.dot(y).atan2(wi.dot(x)) / std::f32::consts::TAU).rem_euclid(1.0);
                for (bins, share) in bins.iter_mut().zip([below, turn]) {
                    bins[((share * BINS as f32) as usize).min(BINS - 1)] += 1;
                }
            }
            // Chi-squared with 49 degrees of freedom: 106 once in 200,000.
            let expected = f64::from(N) / BINS as f64;
            for bins in bins {
                let chi2: f64 = bins.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
                assert!(chi2 < 106.0, "{g}: chi² = {chi2}");
            }
        }
    }
}
