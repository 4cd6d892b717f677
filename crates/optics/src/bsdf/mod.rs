//! How a surface scatters light: the bidirectional scattering distribution function of OpenPBR's materials.
//!
//! A [`Surface`] says what a material is at one point; [`Bsdf::new`] makes of it, once a hit, what can be sampled and
//! evaluated. Everything is in a local frame: z is the shading normal on the side of `wo`, so wo.z > 0 always, and wi.z <
//! 0 where light comes through. Both directions have unit length and point away from the surface.
//!
//! **Radiance.** Values are for radiance that is traced from the camera. Light that comes from a medium of index n₂ into
//! one of index n₁ is thinned out by (n₁/n₂)² = 1/η², η being the index beyond over the index here. So a lossless solid
//! surface has R + η²·T = 1, where T is what [`Bsdf::sample`] weighs what crosses with. Thin walls have air on both sides
//! and no such factor.
//!
//! From outside in, a surface is a coat over a film over a base, which is a mix of metal, clear dielectric and dielectric
//! over a diffuse ground (OpenPBR 1.1, Academy Software Foundation, 2024).

mod bounced;
mod coat;
mod conductor;
mod dielectric;
mod diffuse;
mod ground;
mod interface;
mod layered;
mod surface;
#[cfg(test)]
mod tests;
mod thin_dielectric;

pub use dielectric::Smooth;
pub use diffuse::Lambert;
pub use layered::Layered;
pub use surface::Surface;

use interface::Interface;
use vitrine_math::{Rgb, Vec3};

/// What happened to a ray at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// It went on in the one direction that a smooth surface allows.
    pub is_delta: bool,
    /// It went to the other side.
    pub is_transmission: bool,
}

/// A direction drawn from a [`Bsdf`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// f·|cos θi|/pdf; for a delta lobe its value over its probability.
    pub weight: Rgb,
    /// Where the light comes from.
    pub wi: Vec3,
    /// The density of `wi` per steradian, as [`Bsdf::pdf`] gives it; for a delta lobe its probability.
    pub pdf: f32,
    /// What happened.
    pub event: Event,
}

/// How one surface scatters at one hit.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant, reason = "lives on the stack for one hit; a box would allocate")]
pub enum Bsdf {
    /// Plainly matte.
    Lambert(Lambert),
    /// Smooth throughout: glass, panes, mirrors.
    Smooth(Smooth),
    /// Anything else.
    Layered(Layered),
}

impl Bsdf {
    /// What scatters at a hit of a surface seen at an angle with the cosine `cos_wo`, above 0.
    #[must_use]
    pub fn new(surface: &Surface, cos_wo: f32) -> Self {
        if surface.is_plainly_matte() {
            return Self::Lambert(Lambert { albedo: surface.base_color });
        }
        let cos_wo = cos_wo.clamp(MIN_COS, 1.0);
        if surface.is_plain_glass() {
            return Self::Smooth(Smooth::plain_glass(surface.eta, cos_wo));
        }
        let interface = Interface::new(surface);
        if surface.is_smooth() {
            return Self::Smooth(Smooth::new(surface, &interface, cos_wo));
        }
        Self::Layered(Layered::new(surface, interface, cos_wo))
    }

    /// Draws a direction that light comes from. `u_lobe` chooses what scatters, `u` the direction; all in [0, 1). None
    /// where nothing comes back.
    #[inline]
    #[must_use]
    pub fn sample(&self, wo: Vec3, u_lobe: f32, u: [f32; 2]) -> Option<BsdfSample> {
        match self {
            Self::Lambert(lambert) => lambert.sample(u),
            Self::Smooth(smooth) => smooth.sample(wo, u_lobe),
            Self::Layered(layered) => layered.sample(wo, u_lobe, u),
        }
    }

    /// f·|cos θi| and the density per steradian with which [`Self::sample`] draws `wi`, both of all that is not delta.
    #[inline]
    #[must_use]
    pub fn eval(&self, wo: Vec3, wi: Vec3) -> (Rgb, f32) {
        match self {
            Self::Lambert(lambert) => lambert.eval(wi),
            Self::Smooth(_) => (Rgb::BLACK, 0.0),
            Self::Layered(layered) => layered.eval(wo, wi),
        }
    }

    /// f·|cos θi| of all that is not delta.
    #[inline]
    #[must_use]
    pub fn f_cos(&self, wo: Vec3, wi: Vec3) -> Rgb {
        self.eval(wo, wi).0
    }

    /// The density per steradian with which [`Self::sample`] draws `wi` from what is not delta; it integrates to the
    /// probability that what it draws is not delta.
    #[inline]
    #[must_use]
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        self.eval(wo, wi).1
    }

    /// Whether anything is not delta, so that light chosen at a lamp can be scattered here.
    #[inline]
    #[must_use]
    pub fn has_smooth_part(&self) -> bool {
        match self {
            Self::Lambert(_) => true,
            Self::Smooth(_) => false,
            Self::Layered(layered) => layered.has_smooth_part(),
        }
    }

    /// The share of light that goes straight on, not bent and not scattered, at the angle for which this was made: that through a smooth
    /// thin wall. Black where there is none.
    #[must_use]
    pub fn passed_straight(&self) -> Rgb {
        match self {
            Self::Lambert(_) => Rgb::BLACK,
            Self::Smooth(smooth) => smooth.passed_straight(),
            Self::Layered(layered) => layered.passed_straight(),
        }
    }

    /// The surface's colour as a denoiser should see it, each channel 0 to 1.
    #[must_use]
    pub fn albedo(&self) -> Rgb {
        let albedo = match self {
            Self::Lambert(lambert) => lambert.albedo,
            Self::Smooth(smooth) => smooth.albedo(),
            Self::Layered(layered) => layered.albedo(),
        };
        Rgb::new(albedo.r.clamp(0.0, 1.0), albedo.g.clamp(0.0, 1.0), albedo.b.clamp(0.0, 1.0))
    }
}

/// Cosines below this count as this: a ray along the surface.
const MIN_COS: f32 = 1e-6;

/// The mean of the channels: by it lobes are chosen.
#[inline]
fn mean(color: Rgb) -> f32 {
    (color.r + color.g + color.b) * (1.0 / 3.0)
}

/// One over, channel by channel, held away from 0.
#[inline]
fn recip(color: Rgb) -> Rgb {
    Rgb::new(1.0 / color.r.max(1e-6), 1.0 / color.g.max(1e-6), 1.0 / color.b.max(1e-6))
}

/// 1 − c, channel by channel, not below 0.
#[inline]
fn rest(color: Rgb) -> Rgb {
    Rgb::new((1.0 - color.r).max(0.0), (1.0 - color.g).max(0.0), (1.0 - color.b).max(0.0))
}
