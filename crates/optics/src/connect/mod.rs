//! Refracted connections: every way in which light gets from a lamp through smooth glass to a point.
//!
//! A smooth surface has no chance to scatter into a direction that was chosen from outside, so a shadow ray that meets
//! glass says nothing. These solvers find the bent paths instead: all of them through parallel planes ([`planes`]), planes
//! that are not parallel ([`faces`]), a ball from outside and inside ([`sphere`]) and concentric shells ([`shells`]); one
//! of them through any sequence of planes and balls ([`walk`]). What is found depends on the input alone, never on luck.
//!
//! They are pure geometry. Fresnel, absorption, what stands in the way and how far a pane extends are the caller's: it
//! knows the surfaces and gets the points on them.
//!
//! Numbers are f64, for the path is the small difference of long lengths and the light that it carries is a derivative
//! of that; single precision would leave one to three digits. Nothing is allocated.
//!
//! What a chain is worth: a light of radiance `L` behind glass, chosen with the density `p` per square metre, brings
//! `f · cos θ · τ · (n_x/n_y)² · L · spread · |n_y·wy| / p`, where τ are the losses and n_x, n_y the indices of the media
//! at the two ends. The factor (n_x/n_y)² belongs to radiance, not to geometry: [`Chain::spread`] does not contain it.
//!
//! Walter, Zhao, Holzschuch, Bala, "Single Scattering in Refractive Media with Triangle Mesh Boundaries", SIGGRAPH 2009,
//! has the problem and the role of the Jacobian.

use vitrine_math::DVec3;

mod around;
pub mod faces;
pub mod planes;
mod radial;
pub mod shells;
pub mod sphere;
#[cfg(test)]
mod trial;
pub mod walk;

/// The most surface points that a chain can have.
pub const MAX_VERTICES: usize = 16;

/// The most chains that one search returns; of what goes beyond that nothing is kept.
pub const MAX_CHAINS: usize = 8;

/// Where the light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// A point of a lamp.
    Point(DVec3),
    /// A light infinitely far away, in this direction: a unit vector from the last surface towards the light, in the
    /// medium that is there.
    Distant(DVec3),
}

/// One way of the light, seen from the receiver.
#[derive(Clone, Copy, Debug)]
pub struct Chain {
    points: [DVec3; MAX_VERTICES],
    len: usize,
    /// The direction at the receiver towards the first vertex, or towards the light if there is none; of unit length.
    pub wx: DVec3,
    /// The direction at the light towards the last vertex, or towards the receiver; of unit length. For a distant light
    /// it is the opposite of the direction towards it.
    pub wy: DVec3,
    /// dω_x/dA⊥: the solid angle at the receiver for each square metre at the light that is perpendicular to `wy`, in
    /// 1/m²; 1/distance² in free space. For a distant light dω_x/dω_y, which has no unit. Finite and not negative.
    /// Pure geometry: radiance changes by (n_x/n_y)² besides.
    pub spread: f64,
}

/// What a path is at its two ends: the fields of [`Chain`].
#[derive(Clone, Copy)]
pub(crate) struct PathEnds {
    pub wx: DVec3,
    pub wy: DVec3,
    pub spread: f64,
}

impl Chain {
    /// A chain that has no vertices yet.
    #[inline]
    pub(crate) fn new(ends: PathEnds) -> Self {
        let PathEnds { wx, wy, spread } = ends;
        Self { points: [DVec3::ZERO; MAX_VERTICES], len: 0, wx, wy, spread }
    }

    /// Adds the next point on the way to the light. The caller keeps to [`MAX_VERTICES`].
    #[inline]
    pub(crate) fn push(&mut self, p: DVec3) {
        self.points[self.len] = p;
        self.len += 1;
    }

    /// The points on the surfaces, in order from the receiver to the light, in the space of the input.
    #[inline]
    #[must_use]
    pub fn vertices(&self) -> &[DVec3] {
        &self.points[..self.len]
    }

    /// Whether every number is one that can be used.
    #[inline]
    pub(crate) fn is_sound(&self) -> bool {
        self.spread.is_finite()
            && self.spread >= 0.0
            && self.wx.is_finite()
            && self.wy.is_finite()
            && self.vertices().iter().all(|p| p.is_finite())
    }
}

/// The chains of one search. Keep one and use it again: it is a few kilobytes.
#[derive(Clone, Debug)]
pub struct Chains {
    chains: [Chain; MAX_CHAINS],
    len: usize,
}

impl Default for Chains {
    fn default() -> Self {
        let none = PathEnds { wx: DVec3::ZERO, wy: DVec3::ZERO, spread: 0.0 };
        Self { chains: [Chain::new(none); MAX_CHAINS], len: 0 }
    }
}

impl Chains {
    /// The chains that were found.
    #[inline]
    #[must_use]
    pub fn as_slice(&self) -> &[Chain] {
        &self.chains[..self.len]
    }

    /// Forgets all chains. The searches add to what is there.
    #[inline]
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds a chain with these ends and vertices if it is sound and there is room.
    #[inline]
    pub(crate) fn push(&mut self, ends: PathEnds, vertices: impl Iterator<Item = DVec3>) {
        let Some(chain) = self.chains.get_mut(self.len) else { return };
        (chain.wx, chain.wy, chain.spread, chain.len) = (ends.wx, ends.wy, ends.spread, 0);
        for p in vertices {
            chain.push(p);
        }
        if chain.is_sound() {
            self.len += 1;
        }
    }
}
