//! A wall so thin that light leaves it where it came in: window panes, bubbles. Both faces are in it, with all that is
//! reflected between them.

use super::interface::Split;
use crate::fresnel;
use vitrine_math::Rgb;

/// A thin wall in air.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    /// The index of the inside, and the one by which its faces reflect.
    eta: f32,
    eta_fresnel: f32,
    /// ln A, where A is what the inside leaves of light that crosses straight; None if that is all.
    log_absorption: Option<Rgb>,
}

impl Wall {
    /// `absorption` is what the inside leaves of light that crosses straight.
    pub(super) fn new(eta: f32, eta_fresnel: f32, absorption: Rgb) -> Self {
        let log = |a: f32| libm::logf(a.clamp(1e-4, 1.0));
        let a = absorption;
        let log_absorption = (a != Rgb::WHITE).then(|| Rgb::new(log(a.r), log(a.g), log(a.b)));
        Self { eta: eta.max(1.0), eta_fresnel: eta_fresnel.max(1.0), log_absorption }
    }

    /// What it reflects and lets through, unpolarised light in air at an angle with the cosine `cos`.
    ///
    /// Both faces reflect F, the inside leaves A each way (light-tight sums of the geometric series):
    ///
    ///   T = (1 − F)²A/(1 − F²A²), R = F·(1 + A·T)
    ///
    /// For each polarisation by itself, then the mean: light is polarised by the first face that it meets.
    pub(super) fn split(&self, cos: f32) -> Split {
        let (s, p) = fresnel::dielectric_sp(cos, self.eta_fresnel);
        let Some(a) = self.inside(cos) else {
            // A = 1: T = (1 − F)/(1 + F), R = 2F/(1 + F)
            let through = 0.5 * ((1.0 - s) / (1.0 + s) + (1.0 - p) / (1.0 + p));
            return Split { reflected: Rgb::splat(1.0 - through), crossing: Rgb::splat(through) };
        };
        let channel = |a: f32| {
            let one = |f: f32| {
                let t = (1.0 - f) * (1.0 - f) * a / (1.0 - f * f * a * a).max(1e-7);
                (f * (1.0 + a * t), t)
            };
            let ((r_s, t_s), (r_p, t_p)) = (one(s), one(p));
            (0.5 * (r_s + r_p), 0.5 * (t_s + t_p))
        };
        Split::from_channels(channel(a.r), channel(a.g), channel(a.b))
    }

    /// The same where the first face reflects `first` because of a film.
    ///
    ///   R = F₁ + (1 − F₁)²F₂A²/(1 − F₁F₂A²), T = (1 − F₁)(1 − F₂)A/(1 − F₁F₂A²)
    pub(super) fn split_below(&self, first: Rgb, cos: f32) -> Split {
        let second = fresnel::dielectric(cos, self.eta_fresnel);
        let a = self.inside(cos).unwrap_or(Rgb::WHITE);
        let channel = |first: f32, a: f32| {
            let bounced = (1.0 - first * second * a * a).max(1e-7);
            let in_and_out = (1.0 - first) * (1.0 - first) * second * a * a / bounced;
            (first + in_and_out, (1.0 - first) * (1.0 - second) * a / bounced)
        };
        Split::from_channels(channel(first.r, a.r), channel(first.g, a.g), channel(first.b, a.b))
    }

    /// What the inside leaves along the slanting way through it, A^(1/cos θt); None if that is all.
    fn inside(&self, cos: f32) -> Option<Rgb> {
        let log = self.log_absorption?;
        let cos_t = (1.0 - (1.0 - cos * cos).max(0.0) / (self.eta * self.eta)).max(1e-6).sqrt();
        let channel = |log: f32| libm::expf(log / cos_t);
        Some(Rgb::new(channel(log.r), channel(log.g), channel(log.b)))
    }
}
