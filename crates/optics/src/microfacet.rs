//! Rough surfaces as many small mirrors: the distribution GGX of Walter, Marschner, Li and Torrance ("Microfacet Models
//! for Refraction through Rough Surfaces", EGSR 2007), with the height-correlated shadowing of Heitz ("Understanding the
//! Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014).
//!
//! Directions are in the local frame with z as the surface's normal; `wo` is above it.

use crate::sampling::sin_cos_turn;
use std::f32::consts::FRAC_1_PI;
use vitrine_math::Vec3;

/// Facets distributed by GGX, equally in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ggx {
    alpha: f32,
}

impl Ggx {
    /// Narrower facets than this count as a smooth surface.
    pub const SMOOTH: f32 = 1e-3;

    /// By a roughness of 0 to 1; None where that is as good as smooth.
    ///
    ///   α = r²   (OpenPBR 1.1, "Microfacet model")
    #[inline]
    #[must_use]
    pub fn from_roughness(roughness: f32) -> Option<Self> {
        let alpha = (roughness * roughness).min(1.0);
        (alpha >= Self::SMOOTH).then_some(Self { alpha })
    }

    /// The width α, 0.001 to 1.
    #[inline]
    #[must_use]
    pub fn alpha(&self) -> f32 {
        self.alpha
    }

    /// The density of facets with the normal `m`, per steradian of `m` and area of the surface.
    ///
    ///   D(m) = 1/(πα²(sin²θ/α² + cos²θ)²)
    #[inline]
    #[must_use]
    pub fn d(&self, m: Vec3) -> f32 {
        if m.z <= 0.0 {
            return 0.0;
        }
        let alpha2 = self.alpha * self.alpha;
        let e = (m.x * m.x + m.y * m.y) / alpha2 + m.z * m.z;
        FRAC_1_PI / (alpha2 * e * e)
    }

    /// Smith's Λ of a direction, (√(1 + α²tan²θ) − 1)/2.
    #[inline]
    #[must_use]
    pub fn lambda(&self, w: Vec3) -> f32 {
        let tan2 = (w.x * w.x + w.y * w.y) / (w.z * w.z).max(1e-14);
        0.5 * ((1.0 + self.alpha * self.alpha * tan2).sqrt() - 1.0)
    }

    /// f·cos θi of mirrors that reflect everything, D·G₂/(4 cos θo), and the density with which `wi` is drawn by
    /// [`Self::sample_visible`] and a mirror, D·G₁/(4 cos θo). `h` is the half vector.
    #[inline]
    #[must_use]
    pub fn reflect(&self, wo: Vec3, wi: Vec3, h: Vec3) -> (f32, f32) {
        let (lambda_o, lambda_i) = (self.lambda(wo), self.lambda(wi));
        let front = self.d(h) / (4.0 * wo.z.max(1e-7));
        (front / (1.0 + lambda_o + lambda_i), front / (1.0 + lambda_o))
    }

    /// A facet's normal, drawn from those that `wo` sees (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical
    /// Caps", CGF 42(8), 2023).
    #[inline]
    #[must_use]
    pub fn sample_visible(&self, wo: Vec3, u: [f32; 2]) -> Vec3 {
        // To the half sphere, where what is seen of it is a cap around the direction.
        let stretched = Vec3::new(wo.x * self.alpha, wo.y * self.alpha, wo.z).normalize_or(Vec3::Z);
        let z = (1.0 - u[1]) * (1.0 + stretched.z) - stretched.z;
        let radius = (1.0 - z * z).max(0.0).sqrt();
        let (sin, cos) = sin_cos_turn(u[0]);
        let m = Vec3::new(radius * cos, radius * sin, z) + stretched;
        // Back, the normal by the inverse transpose.
        Vec3::new(m.x * self.alpha, m.y * self.alpha, m.z.max(1e-9)).normalize_or(Vec3::Z)
    }

    /// The share of the facets that look at `w` and are seen by it, G₁ = 1/(1 + Λ).
    #[inline]
    #[must_use]
    pub fn g1(&self, w: Vec3) -> f32 {
        1.0 / (1.0 + self.lambda(w))
    }

    /// The share of facets seen by both directions, G₂ = 1/(1 + Λo + Λi).
    #[inline]
    #[must_use]
    pub fn g2(&self, wo: Vec3, wi: Vec3) -> f32 {
        1.0 / (1.0 + self.lambda(wo) + self.lambda(wi))
    }
}
