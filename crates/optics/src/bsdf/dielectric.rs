//! Surfaces that are smooth throughout: glass, water, panes, mirrors, lacquered ones. There are two directions at most.

use super::coat::{self, Coat};
use super::interface::{Interface, Split};
use super::{BsdfSample, Event, Surface, mean};
use crate::fresnel;
use crate::refraction::refract;
use vitrine_math::{Rgb, Vec3};

/// What is mirrored and what goes through.
#[derive(Clone, Copy, Debug)]
pub struct Smooth {
    /// What is mirrored, and how likely it is chosen.
    mirrored: Rgb,
    chance: f32,
    /// What crosses, for radiance, over how likely it is chosen.
    weight: Rgb,
    /// The index by which it bends; None where it goes straight on.
    eta: Option<f32>,
}

impl Smooth {
    /// Solid glass that absorbs nothing at its surface.
    #[inline]
    pub(super) fn plain_glass(eta: f32, cos_o: f32) -> Self {
        let chance = fresnel::dielectric(cos_o, eta);
        Self {
            mirrored: Rgb::splat(chance),
            chance,
            weight: Rgb::splat(1.0 / (eta * eta)),
            eta: (eta != 1.0).then_some(eta),
        }
    }

    pub(super) fn new(surface: &Surface, interface: &Interface, cos_o: f32) -> Self {
        let base = interface.split(cos_o);
        let split = match Coat::new(surface, base.reflected, cos_o) {
            Some(coat) => coat.over_smooth(base),
            None if surface.coat_weight > 0.0 => coat::beyond(surface, interface, base, cos_o),
            None => base,
        };
        Self::of(split, interface)
    }

    /// Of what is mirrored and crosses at one interface, energies.
    pub(super) fn of(split: Split, interface: &Interface) -> Self {
        let (r, t) = (mean(split.reflected), mean(split.crossing));
        let chance = if r + t > 0.0 { r / (r + t) } else { 1.0 };
        let goes_straight = interface.is_thin_walled() || interface.eta == 1.0;
        // Radiance that enters from index n₂ into n₁ counts (n₁/n₂)² = 1/η².
        let radiance = if goes_straight { 1.0 } else { 1.0 / (interface.eta * interface.eta) };
        let weight = if chance < 1.0 { split.crossing * (radiance / (1.0 - chance)) } else { Rgb::BLACK };
        Self { mirrored: split.reflected, chance, weight, eta: (!goes_straight).then_some(interface.eta) }
    }

    #[inline]
    pub(super) fn sample(&self, wo: Vec3, u: f32) -> Option<BsdfSample> {
        if wo.z <= 0.0 {
            None
        } else if u < self.chance {
            self.mirror(wo)
        } else {
            self.cross(wo)
        }
    }

    #[inline]
    fn mirror(&self, wo: Vec3) -> Option<BsdfSample> {
        if self.chance <= 0.0 {
            return None;
        }
        let event = Event { is_delta: true, is_transmission: false };
        let wi = Vec3::new(-wo.x, -wo.y, wo.z);
        Some(BsdfSample { weight: self.mirrored / self.chance, wi, pdf: self.chance, event })
    }

    #[inline]
    fn cross(&self, wo: Vec3) -> Option<BsdfSample> {
        let wi = match self.eta {
            None => -wo,
            Some(eta) => refract(wo, Vec3::Z, eta)?,
        };
        if wi.z >= 0.0 || self.chance >= 1.0 {
            return None;
        }
        let event = Event { is_delta: true, is_transmission: true };
        Some(BsdfSample { weight: self.weight, wi, pdf: 1.0 - self.chance, event })
    }

    /// What crosses without being bent.
    pub(super) fn passed_straight(&self) -> Rgb {
        if self.eta.is_none() { self.weight * (1.0 - self.chance) } else { Rgb::BLACK }
    }

    pub(super) fn albedo(&self) -> Rgb {
        let straight = self.eta.map_or(1.0, |eta| eta * eta);
        self.mirrored + self.weight * ((1.0 - self.chance) * straight)
    }
}
