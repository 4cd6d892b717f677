//! Light that bounces more than once between the facets of a rough surface, which the facets' own lobes leave out (Kulla
//! and Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH course 2017).

use super::Surface;
use super::interface::Interface;
use crate::energy::{self, Lookup};
use crate::microfacet::Ggx;
use vitrine_math::Rgb;

/// Light that bounced between facets, which one bounce loses: π·f = c·M(μo)·M(μi)/M̄ with M = 1 − E.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bounced {
    /// Of metal and thin walls: what stays above and what goes below, c·M(μo)/M̄.
    mirrors: Option<(Lookup, Rgb, Rgb)>,
    /// Of clear glass, what stays above.
    above: Option<(Lookup, Rgb)>,
    /// Of clear glass, what goes below, for radiance; M is that of the other side.
    below: Option<(Lookup, Rgb)>,
}

impl Bounced {
    pub(super) fn new(surface: &Surface, interface: &Interface, facets: &Ggx, cos_o: f32) -> Self {
        let mut bounced = Self::default();
        let clear = surface.clear_share();
        let (mut stays, mut goes) = (Rgb::BLACK, Rgb::BLACK);
        let mirrors = energy::mirrors(facets.alpha());
        if surface.metalness > 0.0 {
            stays = energy::bounced_color(interface.metal_average(), mirrors.average()) * surface.metalness;
        }
        if clear > 0.0 && interface.is_thin_walled() {
            // At this angle a wall does what it does on average.
            let typical = interface.dielectric(0.55);
            let share = 1.0 - surface.metalness;
            goes = typical.crossing * share;
            stays += typical.reflected * (share * surface.transmission);
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
            // The table knows surfaces that reflect by the index that they bend by; one that reflects less loses less.
            let (f, own) = (energy::fresnel_average(outward(interface.eta_fresnel)), outward(eta));
            let reflects = (f / energy::fresnel_average(own).max(1e-6)).min(1.0);
            let front = reflects * clear * (1.0 - here.at(cos_o));
            bounced.above = Some((here, surface.specular_color * ((1.0 - sent) * front / lost.max(1e-6))));
            let radiance = sent * front / (eta * eta * lost_there.max(1e-6));
            bounced.below = Some((there, surface.transmission_tint * radiance));
        }
        bounced
    }

    /// π·f of what stays above.
    #[inline]
    pub(super) fn above(&self, cos_i: f32) -> Rgb {
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
    pub(super) fn below(&self, cos_i: f32) -> Rgb {
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
    pub(super) fn albedos(&self) -> (Rgb, Rgb) {
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

/// The index as it is from outside.
fn outward(eta: f32) -> f32 {
    if eta < 1.0 { 1.0 / eta } else { eta }
}
