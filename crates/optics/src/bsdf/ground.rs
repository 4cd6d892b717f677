//! The diffuse ground below a dielectric's surface: plastic, paint, wood.

use super::diffuse::Diffuse;
use super::interface::Interface;
use super::{Surface, recip, rest};
use crate::energy::{self, Lookup};
use crate::microfacet::Ggx;
use vitrine_math::{Rgb, Vec3};

/// The diffuse ground below the base's surface, which gets what that does not reflect:
///
///   f = ρ/π·(1 − E(μo))(1 − E(μi))/(1 − Ē)
///
/// (Kelemen and Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001).
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    diffuse: Diffuse,
    /// Its share, (1 − E(μo))/(1 − Ē).
    front: Rgb,
    gloss: Gloss,
    /// About what it scatters to `wo`.
    pub(super) albedo: Rgb,
    /// What rough facets above it reflect to `wo` in all; None of a smooth surface.
    pub(super) glossed: Option<f32>,
}

/// What the surface above a ground reflects in all.
#[derive(Clone, Copy, Debug)]
enum Gloss {
    Smooth,
    Rough(Lookup),
}

impl Ground {
    pub(super) fn new(
        surface: &Surface,
        interface: &Interface,
        facets: Option<&Ggx>,
        cos_o: f32,
    ) -> Option<Self> {
        let share = surface.diffuse_share();
        if share <= 0.0 || surface.base_color == Rgb::BLACK {
            return None;
        }
        let gloss = match facets {
            Some(facets) => Gloss::Rough(energy::glossy(facets.alpha(), interface.eta_fresnel)),
            None => Gloss::Smooth,
        };
        let average = match &gloss {
            _ if interface.has_film() || interface.is_coated() => gloss.average(interface),
            Gloss::Rough(lookup) => Rgb::splat(lookup.average()),
            Gloss::Smooth => Rgb::splat(energy::fresnel_average(interface.eta_fresnel)),
        };
        let diffuse = Diffuse::new(surface.base_color, surface.diffuse_roughness, cos_o);
        let passes = gloss.passes(interface, cos_o) * share;
        let glossed = match &gloss {
            Gloss::Rough(lookup) => Some(lookup.at(cos_o)),
            Gloss::Smooth => None,
        };
        let (albedo, front) = (surface.base_color * passes, passes * recip(rest(average)));
        Some(Self { diffuse, front, gloss, albedo, glossed })
    }

    /// π·f.
    #[inline]
    pub(super) fn pi_f(&self, interface: &Interface, wo: Vec3, wi: Vec3) -> Rgb {
        self.diffuse.pi_f(wo, wi) * self.front * self.gloss.passes(interface, wi.z)
    }
}

impl Gloss {
    /// What the surface above the ground does not reflect.
    #[inline]
    fn passes(&self, interface: &Interface, cos: f32) -> Rgb {
        let cos = interface.cos_above(cos);
        match self {
            Self::Smooth => rest(interface.face(cos)),
            Self::Rough(lookup) if interface.has_film() => {
                // No table knows films: what the film changes of a facet that is not quite along the ray.
                let facet = cos.max(0.3);
                let bare = Rgb::splat(1.0 - lookup.at(cos) + interface.bare_face(facet));
                rest(rest(bare + interface.face(facet) * -1.0))
            }
            Self::Rough(lookup) => Rgb::splat(1.0 - lookup.at(cos)),
        }
    }

    /// 2∫E(μ)μ dμ of what it reflects, by the five points of Gauss and Legendre in μ².
    fn average(&self, interface: &Interface) -> Rgb {
        const POINTS: [(f32, f32); 5] = [
            (0.046_910_08, 0.118_463_44),
            (0.230_765_34, 0.239_314_34),
            (0.5, 0.284_444_45),
            (0.769_234_7, 0.239_314_34),
            (0.953_089_9, 0.118_463_44),
        ];
        let passes =
            |sum: Rgb, (square, weight): (f32, f32)| sum + self.passes(interface, square.sqrt()) * weight;
        rest(POINTS.into_iter().fold(Rgb::BLACK, passes))
    }
}
