//! Refracted next-event estimation: all the ways by which light from a point y comes to a point x through and off the clear surfaces
//! of simple forms, each solved exactly.
//!
//! Which ways are tried follows from x, y and the wavelength alone, never from luck. So a path that was found by chance can be told to
//! be among them or not, and both ways of finding one share its light without counting it twice; what is not tried stays with
//! chance: it costs noise, never light.

mod crossings;
mod solve;
mod transmittance;

use super::chain::{Chain, Face};
use super::media::Media;
use crate::compile::{AIR, Piece, Solids};
use crossings::Crossings;
use vitrine_math::{DVec3, Vec3};
use vitrine_optics::connect::Chains;

pub use crossings::face_of;
pub use transmittance::transmittance;

/// The longest way that is solved.
pub const MOST_STEPS: usize = 8;
/// The most reflections to and fro inside a pane that are solved: the rest carries a millionth of the light.
const MOST_ECHOES: usize = 2;
/// The most balls that are tried from each point.
const MOST_BALLS: usize = 8;

/// A surface on the way from x to y.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The solid whose surface it is.
    pub solid: u16,
    /// Its face.
    pub face: Face,
    /// Whether light is reflected there.
    pub reflects: bool,
    /// A unit normal of it, to either side.
    pub n: DVec3,
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

/// One way from x to y.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    /// The surfaces, from x on.
    pub steps: Steps,
    /// Where the way meets them.
    pub vertices: [DVec3; MOST_STEPS],
    /// The unit direction at x.
    pub wx: DVec3,
    /// The unit direction at y, back along the way.
    pub wy: DVec3,
    /// dω_x/dA⊥: the solid angle at x for each square metre across the way at y.
    pub spread: f64,
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
    crossings: Crossings,
    chains: Chains,
    /// What has been found.
    pub found: Vec<Connection>,
}

impl Connector {
    /// All connections, or those along one chain of surfaces alone. Where there is no clear solid the straight line is all, and this need
    /// not be called.
    pub fn connect(&mut self, solids: &Solids, ends: &Ends, only: Option<&Chain>) {
        self.found.clear();
        let search = Search { solids, ends, only };
        self.crossings.find(solids, ends);
        match self.crossings.steps() {
            Some(steps) if steps.all().is_empty() => {
                self.found.extend(straight(&search));
                self.reflections(&search);
            }
            Some(steps) => {
                let steps = *steps;
                self.flat(&search, &steps);
                self.echoes(&search, &steps);
            }
            None => {}
        }
        self.balls(&search);
    }

    /// Through flat faces.
    fn flat(&mut self, search: &Search, steps: &Steps) {
        if search.wants(&steps.chain()) {
            self.found.extend(solve::flat(search, steps));
        }
    }

    /// The same with light that goes to and fro inside one of the panes.
    fn echoes(&mut self, search: &Search, steps: &Steps) {
        let all = steps.all();
        for at in 1..all.len() {
            let (enter, leave) = (all[at - 1], all[at]);
            let is_pane = enter.solid == leave.solid
                && enter.face ^ 1 == leave.face
                && matches!(search.solids.get(enter.solid).piece, Some(Piece::Block { .. }));
            if !is_pane {
                continue;
            }
            for echoes in 1..=MOST_ECHOES {
                let mut longer = Steps::default();
                let mut fits = all[..at].iter().all(|s| longer.push(*s));
                for _ in 0..echoes {
                    // Off the far face and off the near one, from inside.
                    let back = Step { reflects: true, ..leave };
                    let forth = Step { reflects: true, before: enter.beyond, beyond: enter.before, ..enter };
                    fits &= longer.push(back) && longer.push(forth);
                }
                fits &= all[at..].iter().all(|s| longer.push(*s));
                if fits && search.wants(&longer.chain()) {
                    self.found.extend(solve::flat(search, &longer));
                }
            }
        }
    }

    /// Off the faces of panes and off water, where x and y are on one side of them.
    fn reflections(&mut self, search: &Search) {
        let Search { solids, ends, .. } = search;
        for &solid in solids.clear() {
            match solids.get(solid).piece {
                Some(Piece::Below { n, offset }) => {
                    self.reflection(search, (solid, 0, n.as_dvec3(), f64::from(offset)));
                }
                Some(Piece::Block { center, axes, half }) => {
                    for (k, (axis, half)) in axes.iter().zip(half).enumerate() {
                        let n = axis.as_dvec3();
                        let middle = n.dot(center.as_dvec3());
                        let [x, y] = [ends.x, ends.y].map(|p| n.dot(p) - middle);
                        let half = f64::from(half);
                        // From outside both are beyond one face; from inside both are between the two.
                        for (side, sign) in [(0, -1.0), (1, 1.0)] {
                            let (x, y) = (x * sign, y * sign);
                            if (x > half) == (y > half) {
                                let face = 2 * k as Face + side;
                                let offset = middle * sign + half;
                                self.reflection(search, (solid, face, n * sign, offset));
                            }
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// Off one face with that outward normal.
    fn reflection(&mut self, search: &Search, face: (u16, Face, DVec3, f64)) {
        let (solid, face, n, offset) = face;
        let Search { solids, ends, .. } = search;
        let is_outside = n.dot(ends.x) > offset;
        let sides = ends.media.across(solids, solid, is_outside);
        // A face that something else hides in its place, or that is not where x is.
        if sides.before == sides.beyond || sides.before != ends.media.top(solids) {
            return;
        }
        let step =
            Step { solid, face, reflects: true, n, before: sides.before, beyond: sides.beyond, offset };
        let mut steps = Steps::default();
        steps.push(step);
        if search.wants(&steps.chain()) {
            self.found.extend(solve::flat(search, &steps));
        }
        // Into the pane, off its far face and out again.
        let Some(Piece::Block { half, .. }) = solids.get(solid).piece else { return };
        if !is_outside || sides.beyond != solid {
            return;
        }
        let thickness = 2.0 * f64::from(half[usize::from(face / 2)]);
        let far = Step {
            solid,
            face: face ^ 1,
            reflects: true,
            n,
            before: solid,
            beyond: sides.before,
            offset: offset - thickness,
        };
        let mut steps = Steps::default();
        steps.push(Step { reflects: false, ..step });
        steps.push(far);
        steps.push(Step { reflects: false, before: solid, beyond: sides.before, ..step });
        if search.wants(&steps.chain()) {
            self.found.extend(solve::flat(search, &steps));
        }
    }

    /// Through balls and off them.
    fn balls(&mut self, search: &Search) {
        let Search { solids, ends, .. } = search;
        let here = ends.media.top(solids);
        let is_ball = |s: &u16| matches!(solids.get(*s).piece, Some(Piece::Ball { .. }));
        for &solid in solids.clear().iter().filter(|s| is_ball(s)).take(MOST_BALLS) {
            let Some(Piece::Ball { center, radius }) = solids.get(solid).piece else { continue };
            let ball = solve::Ball { solid, center: center.as_dvec3(), radius: f64::from(radius), here };
            solve::ball(search, &ball, &mut self.chains, &mut self.found);
        }
    }
}

/// The straight way, through nothing.
fn straight(search: &Search) -> Option<Connection> {
    let way = search.ends.y - search.ends.x;
    let distance = way.length();
    if distance == 0.0 || !search.wants(&Chain::default()) {
        return None;
    }
    let (wx, spread) = (way / distance, 1.0 / (distance * distance));
    let (steps, vertices) = (Steps::default(), [DVec3::ZERO; MOST_STEPS]);
    Some(Connection { steps, vertices, wx, wy: -wx, spread })
}

/// What is searched for.
pub(super) struct Search<'a> {
    solids: &'a Solids,
    ends: &'a Ends,
    only: Option<&'a Chain>,
}

impl Search<'_> {
    fn wants(&self, chain: &Chain) -> bool {
        chain.is_solvable() && self.only.is_none_or(|only| only == chain)
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
