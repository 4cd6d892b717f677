//! The general surface: whatever is not plainly matte or smooth throughout. Lobes, each sampled by itself, summed where
//! light is evaluated: what a smooth part mirrors and lets through, the rough coat, the base's facets with the light that
//! they mirror and bend, and two matte ones, above (the diffuse ground, and light that bounced between facets) and below
//! (bounced light that came through).

use super::coat::{self, Coat};
use super::dielectric::Smooth;
use super::diffuse::{Diffuse, f_cos};
use super::interface::{Interface, Split};
use super::{BsdfSample, Event, Surface, mean, recip, rest};
use crate::energy::{self, Lookup};
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

/// The diffuse ground below the base's surface, which gets what that does not reflect:
///
///   f = ρ/π·(1 − E(μo))(1 − E(μi))/(1 − Ē)
///
/// (Kelemen and Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001).
#[derive(Clone, Copy, Debug)]
struct Ground {
    diffuse: Diffuse,
    /// Its share, (1 − E(μo))/(1 − Ē).
    front: Rgb,
    gloss: Gloss,
}

/// What the surface above a ground reflects in all.
#[derive(Clone, Copy, Debug)]
enum Gloss {
    Smooth,
    Rough(Lookup),
}

/// Light that bounced between facets, which one bounce loses: π·f = c·M(μo)·M(μi)/M̄ with M = 1 − E.
#[derive(Clone, Copy, Debug, Default)]
struct Bounced {
    /// Of metal and thin walls: what stays above and what goes below, c·M(μo)/M̄.
    mirrors: Option<(Lookup, Rgb, Rgb)>,
    /// Of clear glass, what stays above.
    above: Option<(Lookup, Rgb)>,
    /// Of clear glass, what goes below, for radiance; M is that of the other side.
    below: Option<(Lookup, Rgb)>,
}

impl Bounced {
    fn new(surface: &Surface, interface: &Interface, facets: &Ggx, cos_o: f32) -> Self {
        let mut bounced = Self::default();
        let clear = surface.clear_share();
        let (mut stays, mut goes) = (Rgb::BLACK, Rgb::BLACK);
        let mirrors = energy::mirrors(facets.alpha());
        if surface.metalness > 0.0 {
            stays = energy::bounced_color(interface.metal_average(), mirrors.average()) * surface.metalness;
        }
        if clear > 0.0 && interface.is_thin_walled() {
            // At this angle a wall does what it does on average.
            let typical = interface.split(0.55);
            let dielectric = 1.0 - surface.metalness;
            goes = typical.crossing;
            stays = stays + rest(typical.crossing * (1.0 / clear)) * (clear * dielectric.min(1.0));
        }
        if stays != Rgb::BLACK || goes != Rgb::BLACK {
            let front = (1.0 - mirrors.at(cos_o)) / (1.0 - mirrors.average()).max(1e-6);
            bounced.mirrors = Some((mirrors, stays * front, goes * front));
        }
        if clear > 0.0 && !interface.is_thin_walled() {
            let eta = interface.eta;
            let (here, there) =
                (energy::glass(facets.alpha(), eta), energy::glass(facets.alpha(), 1.0 / eta));
            let (lost, lost_there) = (1.0 - here.average(), 1.0 - there.average());
            let sent = energy::sent_on(eta, lost, lost_there);
            let front = clear * (1.0 - here.at(cos_o));
            bounced.above = Some((here, surface.specular_color * ((1.0 - sent) * front / lost.max(1e-6))));
            let radiance = sent * front / (eta * eta * lost_there.max(1e-6));
            bounced.below = Some((there, surface.transmission_tint * radiance));
        }
        bounced
    }

    /// π·f of what stays above.
    #[inline]
    fn above(&self, cos_i: f32) -> Rgb {
        let mut sum = Rgb::BLACK;
        if let Some((lookup, stays, _)) = &self.mirrors {
            sum = *stays * (1.0 - lookup.at(cos_i));
        }
        if let Some((lookup, stays)) = &self.above {
            sum += *stays * (1.0 - lookup.at(cos_i));
        }
        sum
    }

    /// π·f of what goes below.
    #[inline]
    fn below(&self, cos_i: f32) -> Rgb {
        let mut sum = Rgb::BLACK;
        if let Some((lookup, _, goes)) = &self.mirrors {
            sum = *goes * (1.0 - lookup.at(cos_i));
        }
        if let Some((lookup, goes)) = &self.below {
            sum += *goes * (1.0 - lookup.at(cos_i));
        }
        sum
    }

    /// All that stays above and all that goes below, as radiance.
    fn albedos(&self) -> (Rgb, Rgb) {
        let (mut above, mut below) = (Rgb::BLACK, Rgb::BLACK);
        if let Some((lookup, stays, goes)) = &self.mirrors {
            let lost = 1.0 - lookup.average();
            (above, below) = (*stays * lost, *goes * lost);
        }
        if let Some((lookup, stays)) = &self.above {
            above += *stays * (1.0 - lookup.average());
        }
        if let Some((lookup, goes)) = &self.below {
            below += *goes * (1.0 - lookup.average());
        }
        (above, below)
    }
}

impl Ground {
    fn new(surface: &Surface, interface: &Interface, facets: Option<&Ggx>, cos_o: f32) -> Option<Self> {
        let share = surface.diffuse_share();
        if share <= 0.0 || surface.base_color == Rgb::BLACK {
            return None;
        }
        let eta = interface.eta_fresnel;
        // A film reflects in colours; its light is shared out as if its surface were smooth.
        let gloss = match facets {
            Some(facets) if !interface.has_film() => Gloss::Rough(energy::glossy(facets.alpha(), eta)),
            _ => Gloss::Smooth,
        };
        let average = match &gloss {
            Gloss::Rough(lookup) => Rgb::splat(lookup.average()),
            Gloss::Smooth if interface.has_film() => film_average(interface),
            Gloss::Smooth => Rgb::splat(energy::fresnel_average(eta)),
        };
        let diffuse = Diffuse::new(surface.base_color, surface.diffuse_roughness, cos_o);
        let front = gloss.passes(interface, cos_o) * recip(rest(average)) * share;
        Some(Self { diffuse, front, gloss })
    }

    /// π·f.
    #[inline]
    fn pi_f(&self, interface: &Interface, wo: Vec3, wi: Vec3) -> Rgb {
        self.diffuse.pi_f(wo, wi) * self.front * self.gloss.passes(interface, wi.z)
    }
}

impl Gloss {
    /// What the surface above the ground does not reflect.
    #[inline]
    fn passes(&self, interface: &Interface, cos: f32) -> Rgb {
        match self {
            Self::Rough(lookup) => Rgb::splat(1.0 - lookup.at(cos)),
            Self::Smooth => rest(interface.face(cos)),
        }
    }
}

/// 2∫F(μ)μ dμ of a film, by Gauss and Legendre's five points in μ².
fn film_average(interface: &Interface) -> Rgb {
    const POINTS: [(f32, f32); 5] = [
        (0.046_910_08, 0.118_463_44),
        (0.230_765_34, 0.239_314_34),
        (0.5, 0.284_444_45),
        (0.769_234_7, 0.239_314_34),
        (0.953_089_9, 0.118_463_44),
    ];
    POINTS.iter().fold(Rgb::BLACK, |sum, (square, weight)| sum + interface.face(square.sqrt()) * *weight)
}

impl Layered {
    /// What crosses without being bent or scattered.
    pub(super) fn passed_straight(&self) -> Rgb {
        self.smooth.map_or(Rgb::BLACK, |smooth| smooth.passed_straight())
    }

    pub(super) fn new(surface: &Surface, interface: Interface, cos_o: f32) -> Self {
        let facets = surface.facets();
        let base = interface.split(cos_o);
        let ground = Ground::new(surface, &interface, facets.as_ref(), cos_o);
        let ground_albedo = ground.as_ref().map_or(Rgb::BLACK, |g| {
            g.diffuse.color() * g.gloss.passes(&interface, cos_o) * surface.diffuse_share()
        });
        let coat = Coat::new(surface, ground_albedo + base.reflected, cos_o);
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
        let faced = match (&facets, &ground) {
            (None, _) => Rgb::BLACK,
            // Rough plastic mirrors less along its surface than a facet does.
            (Some(_), Some(Ground { gloss: Gloss::Rough(lookup), .. })) if surface.metalness <= 0.0 => {
                surface.specular_color * lookup.at(cos_o) + base.crossing
            }
            (Some(_), _) => base.reflected + base.crossing,
        };
        let weights = [
            smooth.map_or(Rgb::BLACK, |s| s.reflected + s.crossing),
            Rgb::splat(coat.as_ref().map_or(0.0, Coat::rough_albedo)),
            faced * pass,
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
                let inside = (u - below) / chance;
                if inside < 1.0 {
                    return Some((lobe, chance, inside.max(0.0)));
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
        if u_lobe < chance_mirrored(&self.interface.split(cos.min(1.0))) {
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
