//! The general surface: whatever is not plainly matte or smooth throughout. Lobes, each sampled by itself, summed where
//! light is evaluated: what a smooth part mirrors and lets through, the rough coat, the base's facets with the light that
//! they mirror and bend, and two matte ones, above (the diffuse ground, and light that bounced between facets) and below
//! (bounced light that came through).

use super::bounced::Bounced;
use super::coat::{self, Coat};
use super::dielectric::Smooth;
use super::diffuse::f_cos;
use super::ground::Ground;
use super::interface::{Interface, Split};
use super::{BsdfSample, Event, Surface, mean};
use crate::microfacet::Ggx;
use crate::refraction::refract;
use crate::sampling::{cosine_hemisphere, cosine_pdf};
use vitrine_math::{Rgb, Vec3};

/// The general surface at a hit.
#[derive(Clone, Copy, Debug)]
pub struct Layered {
    interface: Interface,
    /// The base's facets; None where it is smooth.
    facets: Option<Ggx>,
    coat: Option<Coat>,
    /// What is delta; None where nothing is.
    smooth: Option<Smooth>,
    ground: Option<Ground>,
    bounced: Bounced,
    /// How likely each lobe is chosen, in the order of [`Lobe`].
    chances: [f32; 5],
    albedo: Rgb,
}

/// The lobes, in the order of their probabilities.
#[derive(Clone, Copy)]
enum Lobe {
    Smooth,
    Coat,
    Facets,
    Above,
    Below,
}

const LOBES: [Lobe; 5] = [Lobe::Smooth, Lobe::Coat, Lobe::Facets, Lobe::Above, Lobe::Below];

impl Layered {
    /// What crosses without being bent or scattered.
    pub(super) fn passed_straight(&self) -> Rgb {
        self.smooth.map_or(Rgb::BLACK, |smooth| smooth.passed_straight())
    }

    pub(super) fn new(surface: &Surface, interface: Interface, cos_o: f32) -> Self {
        let facets = surface.facets();
        let base = interface.split(cos_o);
        let ground = Ground::new(surface, &interface, facets.as_ref(), cos_o);
        let ground_albedo = ground.as_ref().map_or(Rgb::BLACK, |g| g.albedo);
        // Light that is caught below the coat is lost only to what the base absorbs.
        let coat = Coat::new(surface, ground_albedo + base.reflected + base.crossing, cos_o);
        let smooth = match (&facets, &coat) {
            (None, Some(coat)) => Some(coat.over_smooth(base)),
            (None, None) if surface.coat_weight > 0.0 => Some(coat::beyond(surface, &interface, base, cos_o)),
            (None, None) => Some(base),
            (Some(_), Some(coat)) => coat.own(),
            (Some(_), None) => None,
        };
        let bounced = facets.map_or_else(Bounced::default, |f| Bounced::new(surface, &interface, &f, cos_o));
        let pass = coat.as_ref().map_or(1.0, |c| 1.0 - c.reflects());
        let (above, below) = bounced.albedos();
        let clear_below = if interface.is_thin_walled() { 1.0 } else { interface.eta * interface.eta };
        let faced = match (&facets, ground.as_ref().and_then(|g| g.glossed)) {
            (None, _) => Rgb::BLACK,
            // Rough plastic mirrors less along its surface than a facet does.
            (Some(_), Some(glossed)) if surface.metalness <= 0.0 => {
                surface.specular_color * glossed + base.crossing
            }
            (Some(_), _) => base.reflected + base.crossing,
        };
        let weights = [
            smooth.map_or(Rgb::BLACK, |s| s.reflected + s.crossing),
            Rgb::splat(coat.as_ref().map_or(0.0, Coat::rough_albedo)),
            // Black facets still shine along the surface: they are never left out.
            faced * pass + Rgb::splat(if facets.is_some() { 0.01 } else { 0.0 }),
            (ground_albedo + above) * pass,
            below * (clear_below * pass),
        ];
        let total: f32 = weights.iter().map(|w| mean(*w)).sum();
        let scale = if total > 0.0 { 1.0 / total } else { 0.0 };
        let chances = weights.map(|w| mean(w) * scale);
        let albedo = weights.iter().fold(Rgb::BLACK, |sum, w| sum + *w);
        let smooth = smooth.map(|split| Smooth::of(split, &interface));
        Self { interface, facets, coat, smooth, ground, bounced, chances, albedo }
    }

    pub(super) fn has_smooth_part(&self) -> bool {
        self.chances[1..].iter().any(|c| *c > 0.0)
    }

    pub(super) fn albedo(&self) -> Rgb {
        self.albedo
    }

    pub(super) fn sample(&self, wo: Vec3, u_lobe: f32, u: [f32; 2]) -> Option<BsdfSample> {
        if wo.z <= 0.0 {
            return None;
        }
        let (lobe, chance, u_lobe) = self.choose(u_lobe)?;
        let wi = match lobe {
            Lobe::Smooth => {
                let sample = self.smooth.as_ref()?.sample(wo, u_lobe)?;
                return Some(BsdfSample {
                    weight: sample.weight / chance,
                    pdf: sample.pdf * chance,
                    ..sample
                });
            }
            Lobe::Coat => {
                let m = self.coat.as_ref()?.facets.as_ref()?.sample_visible(wo, u);
                mirrored(wo, m)?
            }
            Lobe::Facets => self.sample_facets(wo, u_lobe, u)?,
            Lobe::Above => cosine_hemisphere(u),
            Lobe::Below => -cosine_hemisphere(u),
        };
        let (f, pdf) = self.eval(wo, wi);
        if pdf <= 0.0 || wi.z == 0.0 {
            return None;
        }
        let event = Event { is_delta: false, is_transmission: wi.z < 0.0 };
        Some(BsdfSample { weight: f / pdf, wi, pdf, event })
    }

    /// A lobe, its probability, and what is left of the random number.
    #[inline]
    fn choose(&self, u: f32) -> Option<(Lobe, f32, f32)> {
        let mut below = 0.0;
        let mut last = None;
        for (lobe, chance) in LOBES.into_iter().zip(self.chances) {
            if chance > 0.0 {
                if u < below + chance {
                    return Some((lobe, chance, ((u - below) / chance).clamp(0.0, ALMOST_ONE)));
                }
                // Rounding can leave a little beyond the last.
                last = Some((lobe, chance, ALMOST_ONE));
            }
            below += chance;
        }
        last
    }

    /// A direction by a facet that mirrors or lets through.
    fn sample_facets(&self, wo: Vec3, u_lobe: f32, u: [f32; 2]) -> Option<Vec3> {
        let m = self.facets.as_ref()?.sample_visible(wo, u);
        let cos = wo.dot(m);
        if cos <= 0.0 {
            return None;
        }
        if !self.interface.is_clear() || u_lobe < chance_mirrored(&self.interface.split(cos.min(1.0))) {
            return mirrored(wo, m);
        }
        if self.interface.is_thin_walled() {
            let wi = mirrored(wo, m)?;
            return Some(Vec3::new(wi.x, wi.y, -wi.z));
        }
        refract(wo, m, self.interface.eta).filter(|wi| wi.z < 0.0)
    }

    /// f·|cos θi| and the density of `wi`, of all that is not delta.
    pub(super) fn eval(&self, wo: Vec3, wi: Vec3) -> (Rgb, f32) {
        if wo.z <= 0.0 {
            (Rgb::BLACK, 0.0)
        } else if wi.z > 0.0 {
            self.eval_above(wo, wi)
        } else if wi.z < 0.0 && self.interface.is_clear() {
            self.eval_below(wo, wi)
        } else {
            (Rgb::BLACK, 0.0)
        }
    }

    fn eval_above(&self, wo: Vec3, wi: Vec3) -> (Rgb, f32) {
        let [_, coat_chance, facets_chance, above_chance, _] = self.chances;
        let (mut f, mut pdf) = (Rgb::BLACK, 0.0);
        if above_chance > 0.0 {
            let mut matte = self.bounced.above(wi.z);
            if let Some(ground) = &self.ground {
                matte += ground.pi_f(&self.interface, wo, wi);
            }
            if let Some(coat) = &self.coat {
                matte = matte * coat.over_matte(wi.z);
            }
            f = f_cos(matte, wi.z);
            pdf = above_chance * cosine_pdf(wi.z);
        }
        if coat_chance <= 0.0 && facets_chance <= 0.0 {
            return (f, pdf);
        }
        let h = (wo + wi).normalize_or(Vec3::Z);
        if let Some(coat) = &self.coat {
            let (value, density) = coat.eval(wo, wi, h);
            f += Rgb::splat(value);
            pdf += coat_chance * density;
        }
        let cos_h = wo.dot(h);
        if let Some(facets) = &self.facets
            && cos_h > 0.0
        {
            let split = self.interface.split(cos_h.min(1.0));
            let (value, density) = facets.reflect(wo, wi, h);
            let over = self.coat.as_ref().map_or(Rgb::WHITE, |c| c.over_facets(wi.z, facets.alpha()));
            f += split.reflected * over * value;
            pdf += facets_chance * chance_mirrored(&split) * density;
        }
        (f, pdf)
    }

    fn eval_below(&self, wo: Vec3, wi: Vec3) -> (Rgb, f32) {
        let [_, _, facets_chance, _, below_chance] = self.chances;
        let (mut f, mut pdf) = (Rgb::BLACK, 0.0);
        if below_chance > 0.0 {
            f = f_cos(self.bounced.below(-wi.z), -wi.z);
            pdf = below_chance * cosine_pdf(-wi.z);
        }
        if let Some(facets) = &self.facets
            && let Some((split, value, density)) = self.bent(facets, wo, wi)
        {
            f += split.crossing * value;
            pdf += facets_chance * (1.0 - chance_mirrored(&split)) * density;
        }
        if let Some(coat) = &self.coat {
            f = f * coat.over_crossing();
        }
        (f, pdf)
    }

    /// What facets let through from `wi`, below, to `wo`: the facet's shares, and f·|cos θi| and density were all to cross.
    #[inline]
    fn bent(&self, facets: &Ggx, wo: Vec3, wi: Vec3) -> Option<(Split, f32, f32)> {
        if self.interface.is_thin_walled() {
            // A thin wall bends nothing: what a facet mirrors, on the other side.
            let flipped = Vec3::new(wi.x, wi.y, -wi.z);
            let h = (wo + flipped).normalize_or(Vec3::Z);
            let cos = wo.dot(h);
            let (value, density) = facets.reflect(wo, flipped, h);
            return (cos > 0.0).then(|| (self.interface.split(cos.min(1.0)), value, density));
        }
        let eta = self.interface.eta;
        // Walter et al., (16): h = −(wo + η·wi), made to point up.
        let h = (wo + wi * eta).normalize_or_zero();
        let h = if h.z < 0.0 { -h } else { h };
        let (cos_o, cos_i) = (wo.dot(h), wi.dot(h));
        if h.z <= 0.0 || cos_o <= 0.0 || cos_i >= 0.0 {
            return None;
        }
        let bottom = cos_o + eta * cos_i;
        // f·|cos θi| = |wo·h||wi·h|·D·G₂/(cos θo·(wo·h + η·wi·h)²)   (Walter et al., (21), times 1/η² for radiance)
        let front = cos_o * -cos_i * facets.d(h) / (wo.z * bottom * bottom).max(1e-20);
        let value = front * facets.g2(wo, wi);
        let density = front * eta * eta * facets.g1(wo);
        Some((self.interface.split(cos_o.min(1.0)), value, density))
    }
}

/// The greatest number below 1.
const ALMOST_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// How likely a facet is taken to mirror.
#[inline]
fn chance_mirrored(split: &Split) -> f32 {
    let (r, t) = (mean(split.reflected), mean(split.crossing));
    if t <= 0.0 { 1.0 } else { r / (r + t) }
}

/// The direction that a facet with the normal `m` mirrors to `wo`, if that is above the surface.
#[inline]
fn mirrored(wo: Vec3, m: Vec3) -> Option<Vec3> {
    let wi = m * (2.0 * wo.dot(m)) - wo;
    (wi.z > 0.0).then_some(wi)
}
