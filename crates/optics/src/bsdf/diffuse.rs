//! Matte grounds: Lambert's, and the rough one that looks flat like the moon.
//!
//! The rough one is the energy-preserving Oren–Nayar model of Portsmouth, Kutz and Hill, "EON: A Practical
//! Energy-Preserving Rough Diffuse BRDF", JCGT 14(1), 2025. It is reciprocal.

use super::{BsdfSample, Event};
use crate::sampling::{cosine_hemisphere, cosine_pdf};
use std::f32::consts::{FRAC_1_PI, PI};
use vitrine_math::{Rgb, Vec3};

/// A ground that looks the same from everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Lambert {
    /// What it scatters.
    pub(super) albedo: Rgb,
}

impl Lambert {
    #[inline]
    pub(super) fn sample(&self, u: [f32; 2]) -> Option<BsdfSample> {
        let wi = cosine_hemisphere(u);
        if wi.z <= 0.0 {
            return None;
        }
        let event = Event { is_delta: false, is_transmission: false };
        Some(BsdfSample { weight: self.albedo, wi, pdf: cosine_pdf(wi.z), event })
    }

    #[inline]
    pub(super) fn eval(&self, wi: Vec3) -> (Rgb, f32) {
        let pdf = cosine_pdf(wi.z.max(0.0));
        (self.albedo * pdf, pdf)
    }
}

/// ½ − 2/(3π) and 2/3 − 28/(15π), of the model's normalisation.
const SINGLE: f32 = 0.5 - 2.0 / (3.0 * PI);
const AVERAGE: f32 = 2.0 / 3.0 - 28.0 / (15.0 * PI);

/// A ground of the given roughness, seen from one direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Diffuse {
    color: Rgb,
    roughness: f32,
    /// A of Fujii's form of the model, 1/(1 + (½ − 2/3π)·r).
    a: f32,
    /// Factor of the light that bounced more than once, but for what depends on `wi`.
    multiple: Rgb,
}

impl Diffuse {
    pub(super) fn new(color: Rgb, roughness: f32, cos_o: f32) -> Self {
        let roughness = roughness.clamp(0.0, 1.0);
        if roughness == 0.0 {
            return Self { color, roughness, a: 1.0, multiple: Rgb::BLACK };
        }
        let a = 1.0 / (1.0 + SINGLE * roughness);
        // ρ_ms = ρ²·Ē/(1 − ρ(1 − Ē)), f_ms = ρ_ms/π·(1 − E(μo))(1 − E(μi))/(1 − Ē)
        let mean = a * (1.0 + AVERAGE * roughness);
        let lost = 1.0 - mean;
        let front = (1.0 - albedo(cos_o, roughness, a)) / lost.max(1e-6);
        let channel = |c: f32| c * c * mean / (1.0 - c * lost) * front;
        Self { color, roughness, a, multiple: Rgb::new(channel(color.r), channel(color.g), channel(color.b)) }
    }

    /// π·f.
    #[inline]
    pub(super) fn pi_f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        if self.roughness == 0.0 {
            return self.color;
        }
        // s/t: s = ⟨wo, wi⟩ − μo·μi, t = max(μo, μi) where s > 0, else 1
        let s = wo.x * wi.x + wo.y * wi.y;
        let s_over_t = if s > 0.0 { s / wo.z.max(wi.z) } else { s };
        let single = self.color * (self.a * (1.0 + self.roughness * s_over_t));
        single + self.multiple * (1.0 - albedo(wi.z, self.roughness, self.a))
    }
}

/// What a white ground scatters with a single bounce, by the polynomial of the paper.
#[inline]
fn albedo(cos: f32, roughness: f32, a: f32) -> f32 {
    let x = 1.0 - cos;
    let g_over_pi = x * (0.057_108_53 + x * (0.491_881_87 + x * (-0.332_181_44 + x * 0.071_442_99)));
    a * (1.0 + roughness * g_over_pi)
}

/// f·cos of a value of π·f.
#[inline]
pub(super) fn f_cos(pi_f: Rgb, cos: f32) -> Rgb {
    pi_f * (cos * FRAC_1_PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomial_is_the_albedo_of_the_single_bounce() {
        for i in 1..=40_u8 {
            let mu = f64::from(i) / 40.0;
            let sin = (1.0 - mu * mu).max(0.0).sqrt();
            // G(μ) = sin θ(θ − sin θ cos θ) + 2/3·(tan θ(1 − sin³θ) − sin θ)
            let g = sin * (mu.acos() - sin * mu) + 2.0 / 3.0 * (sin / mu * (1.0 - sin.powi(3)) - sin);
            for roughness in [0.3_f32, 1.0] {
                let a = 1.0 / (1.0 + SINGLE * roughness);
                let exact = f64::from(a) * (1.0 + f64::from(roughness) * g / std::f64::consts::PI);
                let ours = f64::from(albedo(mu as f32, roughness, a));
                assert!((exact - ours).abs() < 1e-3, "{mu} {roughness}: {exact} {ours}");
            }
        }
    }
}
