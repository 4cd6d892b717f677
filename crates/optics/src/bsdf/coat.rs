//! A clear layer over the base: varnish, lacquer, the coating of a pane.
//!
//! The coat reflects F_c and lets 1 − F_c pass, in and out, tinted along its way. Over a smooth base the sum over all
//! bounces between both is exact; over a rough or matte one it is that of OpenPBR 1.1, "Coat darkening". Seen from
//! inside, a coat is on the far side of the base: exact over a smooth base, left out over a rough one.

use super::interface::{Interface, Split};
use super::{Surface, recip, rest};
use crate::energy::{self, Lookup};
use crate::fresnel::dielectric;
use crate::microfacet::Ggx;
use vitrine_math::{Rgb, Vec3};

/// A coat as one hit sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coat {
    weight: f32,
    ior: f32,
    /// None where it is smooth.
    pub(super) facets: Option<Ggx>,
    albedo: Option<Lookup>,
    /// Half the logarithm of its colour; None if it is clear.
    half_log: Option<Rgb>,
    /// 1 − what it reflects, towards `wo`, and the same on average.
    pass_o: f32,
    pass_average: f32,
    cos_o: f32,
    /// How much darker the base looks for light that is caught below the coat: where it is matte, and where it shines.
    matte_darkening: Rgb,
    base_albedo: Rgb,
}

impl Coat {
    /// None where there is no coat on the side of `wo`. `base_albedo` is about what the base reflects.
    pub(super) fn new(surface: &Surface, base_albedo: Rgb, cos_o: f32) -> Option<Self> {
        if surface.coat_weight <= 0.0 || (surface.eta < 1.0 && !surface.thin_walled) {
            return None;
        }
        let (weight, ior) = (surface.coat_weight, surface.coat_ior.max(1.0 + 1e-4));
        let facets = Ggx::from_roughness(surface.coat_roughness);
        let albedo = facets.map(|f| energy::glossy(f.alpha(), ior));
        let average = albedo.map_or_else(|| energy::fresnel_average(ior), |a| a.average());
        let c = surface.coat_color;
        let half_log = (c != Rgb::WHITE).then(|| {
            let log = |c: f32| 0.5 * libm::logf(c.clamp(1e-4, 1.0));
            Rgb::new(log(c.r), log(c.g), log(c.b))
        });
        // Δ = (1 − K)/(1 − E_b·K), K = 1 − (1 − F̄)/η²   (OpenPBR 1.1)
        let caught = weight * (1.0 - (1.0 - average) / (ior * ior));
        let matte_darkening = recip(rest(base_albedo * caught)) * (1.0 - caught);
        let mut coat = Self {
            weight,
            ior,
            facets,
            albedo,
            half_log,
            pass_o: 0.0,
            pass_average: 1.0 - weight * average,
            cos_o,
            matte_darkening,
            base_albedo,
        };
        coat.pass_o = coat.pass(cos_o);
        Some(coat)
    }

    /// The factor of a matte lobe below the coat: T(i)·T(o)/T̄·Δ, tinted. A white ground then gives back all that comes.
    #[inline]
    pub(super) fn over_matte(&self, cos_i: f32) -> Rgb {
        let pass = self.pass_o * self.pass(cos_i) / self.pass_average;
        self.matte_darkening * self.tint_both(cos_i) * pass
    }

    /// The factor of a shining, rough lobe of width `alpha` below the coat: s(i)·s(o) with s(μ) = T(μ)/√T(μ̃), where μ̃ is
    /// about where the lobe around μ looks. That is T for a mirror and T(i)T(o)/T̄ for what is as good as matte.
    #[inline]
    pub(super) fn over_facets(&self, cos_i: f32, alpha: f32) -> Rgb {
        let one = |cos: f32, pass: f32| {
            let square = cos * cos;
            pass / self.pass((square + alpha * (0.2 - square)).sqrt()).sqrt()
        };
        let pass = one(self.cos_o, self.pass_o) * one(cos_i, self.pass(cos_i));
        // Caught between two mirrors: T/(1 − E_b(1 − T))
        let darkening = recip(rest(self.base_albedo * (1.0 - pass))) * pass;
        darkening * self.tint_both(cos_i) * pass
    }

    /// The factor of light that crosses the coat and then the base.
    #[inline]
    pub(super) fn over_crossing(&self) -> Rgb {
        self.tint_once(self.cos_o) * self.pass_o
    }

    /// f·cos and density of the coat's own rough reflection at the half vector `h`.
    #[inline]
    pub(super) fn eval(&self, wo: Vec3, wi: Vec3, h: Vec3) -> (f32, f32) {
        let Some(facets) = &self.facets else { return (0.0, 0.0) };
        let cos_h = wo.dot(h);
        if cos_h <= 0.0 {
            return (0.0, 0.0);
        }
        let (value, pdf) = facets.reflect(wo, wi, h);
        (value * self.weight * dielectric(cos_h, self.ior), pdf)
    }

    /// What it reflects towards `wo`.
    pub(super) fn reflects(&self) -> f32 {
        1.0 - self.pass_o
    }

    /// What a smooth coat mirrors by itself; None of a rough one.
    pub(super) fn own(&self) -> Option<Split> {
        self.facets.is_none().then(|| Split { reflected: Rgb::splat(self.reflects()), crossing: Rgb::BLACK })
    }

    /// What a rough coat reflects towards `wo`; 0 of a smooth one.
    pub(super) fn rough_albedo(&self) -> f32 {
        if self.facets.is_some() { 1.0 - self.pass_o } else { 0.0 }
    }

    /// Both a smooth base's share of light and the smooth coat's over it.
    ///
    ///   R = F_c + T_c²R_b/(1 − F_c·R_b), T = T_c·T_b/(1 − F_c·R_b)
    pub(super) fn over_smooth(&self, base: Split) -> Split {
        let reflect = 1.0 - self.pass_o;
        let bounced = recip(rest(base.reflected * reflect)) * self.pass_o;
        let own = if self.facets.is_some() { 0.0 } else { reflect };
        Split {
            reflected: Rgb::splat(own) + base.reflected * bounced * self.pass_o * self.tint_both(self.cos_o),
            crossing: base.crossing * bounced * self.tint_once(self.cos_o),
        }
    }

    /// What passes at an angle with the cosine `cos`.
    #[inline]
    fn pass(&self, cos: f32) -> f32 {
        let reflect = match &self.albedo {
            Some(albedo) => albedo.at(cos),
            None => dielectric(cos, self.ior),
        };
        1.0 - self.weight * reflect
    }

    /// The colour after the way in and out.
    #[inline]
    fn tint_both(&self, cos_i: f32) -> Rgb {
        let Some(log) = self.half_log else { return Rgb::WHITE };
        self.tint(log, 1.0 / self.cos_inside(self.cos_o) + 1.0 / self.cos_inside(cos_i))
    }

    /// The colour after the way in.
    fn tint_once(&self, cos: f32) -> Rgb {
        let Some(log) = self.half_log else { return Rgb::WHITE };
        self.tint(log, 1.0 / self.cos_inside(cos))
    }

    fn tint(&self, half_log: Rgb, way: f32) -> Rgb {
        let channel = |l: f32| 1.0 - self.weight + self.weight * libm::expf(l * way);
        Rgb::new(channel(half_log.r), channel(half_log.g), channel(half_log.b))
    }

    #[inline]
    fn cos_inside(&self, cos: f32) -> f32 {
        (1.0 - (1.0 - cos * cos).max(0.0) / (self.ior * self.ior)).max(1e-4).sqrt()
    }
}

/// A smooth coat on the far side of a smooth base, which we look at from inside:
///
///   R = R_b + T_b²F_c/(1 − R_b·F_c), T = T_b·T_c/(1 − R_b·F_c)
pub(super) fn beyond(surface: &Surface, interface: &Interface, base: Split, cos_o: f32) -> Split {
    // Snell: the cosine in the air outside; none at total internal reflection.
    let sin2 = (1.0 - cos_o * cos_o).max(0.0) / (interface.eta * interface.eta);
    let outside = if sin2 < 1.0 { dielectric((1.0 - sin2).sqrt(), surface.coat_ior) } else { 1.0 };
    let reflect = surface.coat_weight * outside;
    let c = surface.coat_color;
    let tint = if c == Rgb::WHITE || sin2 >= 1.0 {
        Rgb::WHITE
    } else {
        let way = 0.5 / (1.0 - sin2 / (surface.coat_ior * surface.coat_ior)).max(1e-4).sqrt();
        let channel = |c: f32| libm::powf(c.clamp(1e-4, 1.0), way);
        Rgb::WHITE.lerp(Rgb::new(channel(c.r), channel(c.g), channel(c.b)), surface.coat_weight)
    };
    let bounced = recip(rest(base.reflected * reflect));
    Split {
        reflected: base.reflected + base.crossing * base.crossing * bounced * (tint * tint) * reflect,
        crossing: base.crossing * bounced * tint * (1.0 - reflect),
    }
}
