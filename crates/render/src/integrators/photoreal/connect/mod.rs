//! Refracted next-event estimation: all the ways by which light from a point y comes to a point x through and off the clear surfaces
//! of simple forms, each solved exactly.
//!
//! Which ways are tried follows from x, y and the wavelength alone, never from luck. So a path that was found by chance can be told to
//! be among them or not, and both ways of finding one share its light without counting it twice; what is not tried stays with
//! chance: it costs noise, never light.

mod balls;
mod block;
mod crossings;
mod detours;
mod flat;
mod found;
mod metal;
mod mirrors;
mod mixed;
mod solve;
mod transmittance;

use super::chain::{Chain, Face};
use super::media::Media;
use crate::compile::{AIR, Solids};
use balls::Around;
use crossings::Crossings;
use vitrine_math::{DVec3, Vec3};
use vitrine_optics::connect::Chains;

pub use crossings::face_of;
pub use found::{Connection, Found, Node};
pub use transmittance::transmittance;

/// The longest way that is solved.
pub const MOST_STEPS: usize = 8;

/// Ways whose directions' cosine is above this are one, found twice: single precision turns them by less.
const SAME: f64 = 0.9999;

/// A surface on the way from x to y.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The solid whose surface it is.
    pub solid: u16,
    /// Its face.
    pub face: Face,
    /// Whether light is reflected there.
    pub reflects: bool,
    /// A unit normal of a flat face, to either side; zero on a ball.
    n: DVec3,
    /// What is before it, or [`AIR`].
    pub before: u16,
    /// What is on its other side, or [`AIR`].
    pub beyond: u16,
    /// ⟨n, p⟩ on a flat face.
    offset: f64,
}

impl Step {
    const NONE: Self =
        Self { solid: AIR, face: 0, reflects: false, n: DVec3::ZERO, before: AIR, beyond: AIR, offset: 0.0 };

    /// What is behind it for the light's way.
    pub const fn after(&self) -> u16 {
        if self.reflects { self.before } else { self.beyond }
    }
}

/// Surfaces in order.
#[derive(Clone, Copy, Debug)]
pub struct Steps {
    all: [Step; MOST_STEPS],
    len: usize,
}

impl Default for Steps {
    fn default() -> Self {
        Self { all: [Step::NONE; MOST_STEPS], len: 0 }
    }
}

impl Steps {
    /// Them all.
    #[inline]
    pub fn all(&self) -> &[Step] {
        &self.all[..self.len]
    }

    /// False when there is no room.
    fn push(&mut self, step: Step) -> bool {
        let has_room = self.len < MOST_STEPS;
        if has_room {
            self.all[self.len] = step;
            self.len += 1;
        }
        has_room
    }

    fn chain(&self) -> Chain {
        let mut chain = Chain::default();
        for step in self.all() {
            chain.push(step.solid, step.face, step.reflects);
        }
        chain
    }
}

/// The two ends of connections.
#[derive(Clone, Copy, Debug)]
pub struct Ends {
    /// Where the light arrives.
    pub x: DVec3,
    /// Where it comes from.
    pub y: DVec3,
    /// What holds x, on the side where the light arrives.
    pub media: Media,
    /// Nanometres; 0: in the middle of the spectrum.
    pub wavelength: f32,
}

/// Finds connections; keeps its tools from one pair of points to the next.
#[derive(Debug, Default)]
pub struct Connector {
    line: Crossings,
    bent: Crossings,
    chains: Chains,
    /// What has been found.
    pub found: Found,
    /// How many of those, the first, are not rare.
    pub plain: usize,
}

impl Connector {
    /// All connections, the rare ones only if they are wanted. Where there is no clear solid the straight line is all, and this need
    /// not be called.
    pub fn connect(&mut self, solids: &Solids, ends: &Ends, with_rare: bool) {
        self.line.find(solids, ends);
        self.found.clear();
        let mut search = Search {
            solids,
            ends,
            there: self.line.there(),
            only: None,
            kinds: Kinds { plain: true, rare: false },
        };
        self.look(&search);
        self.plain = self.found.len();
        if with_rare {
            search.kinds = Kinds { plain: false, rare: true };
            self.look(&search);
        }
    }

    fn look(&mut self, search: &Search) {
        flat::connect(search, [&mut self.line, &mut self.bent], &mut self.found);
        for nest in search.solids.nests() {
            if let Some(around) = Around::new(search, nest) {
                around.connect(search, &mut self.chains, &mut self.found);
            }
            mixed::connect(search, nest, (&mut self.bent, &mut self.chains), &mut self.found);
        }
        metal::connect(search, &mut self.chains, &mut self.found);
    }

    /// The spread of the way through that chain of surfaces which leaves x along `wx`; None if it is not one that
    /// [`Self::connect`] looks for.
    pub fn spread_of(&mut self, solids: &Solids, ends: &Ends, chain: &Chain, wx: DVec3) -> Option<f64> {
        if !chain.is_solvable() {
            return None;
        }
        self.line.find(solids, ends);
        let search = Search {
            solids,
            ends,
            there: self.line.there(),
            only: Some(chain),
            kinds: Kinds { plain: true, rare: true },
        };
        self.found.clear();
        if chain.solids().any(|s| solids.mirror(s).is_some()) {
            return metal::spread_of(&search, chain, wx);
        }
        match solids.nests().iter().find(|nest| chain.solids().any(|s| nest.holds(s))) {
            None => flat::connect(&search, [&mut self.line, &mut self.bent], &mut self.found),
            Some(nest) if chain.solids().all(|s| nest.holds(s)) => {
                return Around::new(&search, nest)?.spread_of(&search, wx);
            }
            Some(nest) => mixed::connect(&search, nest, (&mut self.bent, &mut self.chains), &mut self.found),
        }
        // Several ways may lead through one ball: this is the one that starts as the path did.
        let cos = |way: &Connection<'_>| way.ends.wx.dot(wx);
        let found = self.found.iter().max_by(|a, b| cos(a).total_cmp(&cos(b)));
        found.filter(|way| cos(way) > SAME).map(|way| way.ends.spread)
    }
}

/// Kinds of ways: those that the straight line shows, and through balls and off metal, bring most of the light. The others take most of the
/// time to look for.
#[derive(Clone, Copy, Debug)]
struct Kinds {
    /// Through the surfaces that the straight line crosses, through balls and off metal.
    plain: bool,
    /// With reflections in glass, and through other faces.
    rare: bool,
}

/// What is searched for.
pub(super) struct Search<'a> {
    solids: &'a Solids,
    ends: &'a Ends,
    /// What holds y.
    there: Media,
    only: Option<&'a Chain>,
    kinds: Kinds,
}

impl Search<'_> {
    fn wants(&self, chain: &Chain) -> bool {
        self.only.is_none_or(|only| only == chain)
    }

    /// The index of what is in a place.
    fn index(&self, solid: u16) -> f64 {
        self.solids.substance(solid).map_or(1.0, |s| f64::from(s.index_at(self.ends.wavelength)))
    }
}

/// A point in double precision.
pub fn double(p: Vec3) -> DVec3 {
    p.as_dvec3()
}
