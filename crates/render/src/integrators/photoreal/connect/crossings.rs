//! The faces of clear solids that the straight line from x to y crosses: they say through which a connection is looked for.

use super::super::chain::Face;
use super::super::media::Media;
use super::balls::outside;
use super::{Ends, Step, Steps};
use crate::compile::{Nest, Piece, Solids};
use vitrine_math::{DVec3, Vec3};

/// Crossings nearer to an end than this share of the coordinates are the end's own surface.
const OWN: f64 = 4e-6;

/// Where the line crosses a solid's surface.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    /// From 0 at x to 1 at y.
    t: f64,
    solid: u16,
    face: Face,
    enters: bool,
    /// The outward unit normal of a flat face; zero on a ball.
    n: DVec3,
    /// ⟨n, p⟩ on a flat face; how far a ball reaches from the origin.
    offset: f64,
}

/// The crossings of one line.
#[derive(Debug, Default)]
pub struct Crossings {
    all: Vec<Crossing>,
    steps: Option<Steps>,
    there: Media,
}

/// Where a bent line is reflected.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// The place.
    pub p: DVec3,
    /// The solid whose face reflects.
    pub solid: u16,
    /// The face.
    pub face: Face,
    /// Its outward unit normal.
    pub n: DVec3,
    /// ⟨n, p⟩ on it.
    pub offset: f64,
    /// Whether the light comes from outside of the solid.
    pub is_outside: bool,
}

impl Crossings {
    /// Finds those of the straight line.
    pub fn find(&mut self, solids: &Solids, ends: &Ends) {
        (self.steps, self.there) = (Some(Steps::default()), ends.media);
        self.add(solids, ends.x, ends.y, None);
    }

    /// Finds those of the line by way of the centre of a nest, without those of the nest. Gives the number of surfaces before
    /// the centre, and what is around the nest.
    pub fn by_way_of(&mut self, solids: &Solids, ends: &Ends, nest: &Nest) -> Option<(usize, Media)> {
        (self.steps, self.there) = (Some(Steps::default()), outside(nest, ends.media));
        let center = nest.center.as_dvec3();
        self.add(solids, ends.x, center, Some(nest));
        let (before, media) = (self.steps.as_ref()?.all().len(), self.there);
        self.add(solids, center, ends.y, Some(nest));
        self.steps.is_some().then_some((before, media))
    }

    /// Finds those of the line that is folded in one place, which lies on no surface. Whether connections may be solved through them.
    pub fn via(&mut self, solids: &Solids, ends: &Ends, fold: DVec3) -> bool {
        (self.steps, self.there) = (Some(Steps::default()), ends.media);
        self.add(solids, ends.x, fold, None);
        self.add(solids, fold, ends.y, None);
        self.steps.is_some()
    }

    /// Finds those of the line that is reflected in one place.
    pub fn bend(&mut self, solids: &Solids, ends: &Ends, corner: &Corner) {
        (self.steps, self.there) = (Some(Steps::default()), ends.media);
        self.add(solids, ends.x, corner.p, None);
        let sides = self.there.across(solids, corner.solid, corner.is_outside);
        // A face that something else hides, or at which the light does not arrive from that side.
        let is_there = sides.before != sides.beyond && sides.before == self.there.top(solids);
        let step = corner.step(sides.before, sides.beyond);
        if is_there && self.steps.as_mut().is_some_and(|steps| steps.push(step)) {
            self.add(solids, corner.p, ends.y, None);
        } else {
            self.steps = None;
        }
    }

    /// Adds those of a part of the line; the balls of one nest can be left out.
    fn add(&mut self, solids: &Solids, from: DVec3, to: DVec3, without: Option<&Nest>) {
        self.all.clear();
        for &solid in solids.clear() {
            if without.is_some_and(|nest| nest.holds(solid)) {
                continue;
            }
            if let Some(piece) = &solids.get(solid).piece {
                self.cross(solid, piece, from, to);
            }
        }
        self.all.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.solid.cmp(&b.solid)));
        self.walk(solids);
    }

    /// The surfaces, one behind the other, at which light is bent; None when one of them is round or there are too many.
    pub const fn steps(&self) -> Option<&Steps> {
        self.steps.as_ref()
    }

    /// What holds y, seen from the side from which the line comes.
    pub const fn there(&self) -> Media {
        self.there
    }

    fn walk(&mut self, solids: &Solids) {
        for crossing in &self.all {
            let sides = self.there.across(solids, crossing.solid, crossing.enters);
            self.there = sides.media;
            if sides.before == sides.beyond {
                continue;
            }
            let step = Step {
                solid: crossing.solid,
                face: crossing.face,
                reflects: false,
                n: crossing.n,
                before: sides.before,
                beyond: sides.beyond,
                offset: crossing.offset,
            };
            let is_flat = crossing.n != DVec3::ZERO;
            if !self.steps.as_mut().is_some_and(|steps| is_flat && steps.push(step)) {
                self.steps = None;
            }
        }
    }

    fn cross(&mut self, solid: u16, piece: &Piece, x: DVec3, y: DVec3) {
        let way = y - x;
        // Each end by what its own coordinates and the surface's are rounded to: the sun is a million times as far as the glass is.
        let length = way.length();
        let [of_x, of_y] = [x, y].map(|p| p.abs().max_element());
        let mut add = |t: f64, enters: bool, face: Face, n: DVec3, offset: f64| {
            let [near, far] = [of_x, of_y].map(|p| OWN * p.max(offset.abs()) / length);
            if t > near && t < 1.0 - far {
                self.all.push(Crossing { t, solid, face, enters, n, offset });
            }
        };
        match piece {
            Piece::Below { n, offset } => {
                let (n, offset) = (n.as_dvec3(), f64::from(*offset));
                let slope = n.dot(way);
                if slope != 0.0 {
                    add((offset - n.dot(x)) / slope, slope < 0.0, 0, n, offset);
                }
            }
            Piece::Ball { center, radius } => {
                let from = x - center.as_dvec3();
                let (a, b) = (way.length_squared(), from.dot(way));
                let off = from - way * (b / a);
                let discriminant = f64::from(*radius) * f64::from(*radius) - off.length_squared();
                if discriminant > 0.0 {
                    let half = (discriminant / a).sqrt();
                    let reach = center.as_dvec3().length() + f64::from(*radius);
                    add(-b / a - half, true, 0, DVec3::ZERO, reach);
                    add(-b / a + half, false, 0, DVec3::ZERO, reach);
                }
            }
            Piece::Block { center, axes, half } => {
                let center = center.as_dvec3();
                let (mut near, mut far) = ((f64::NEG_INFINITY, 0_usize, 0.0), (f64::INFINITY, 0_usize, 0.0));
                for (k, (axis, half)) in axes.iter().zip(half).enumerate() {
                    let axis = unit(*axis);
                    let (at, slope, half) = (axis.dot(x - center), axis.dot(way), f64::from(*half));
                    if slope == 0.0 {
                        if at.abs() > half {
                            return;
                        }
                        continue;
                    }
                    let sign = if slope > 0.0 { 1.0 } else { -1.0 };
                    let (enter, leave) = ((-half * sign - at) / slope, (half * sign - at) / slope);
                    if enter > near.0 {
                        near = (enter, k, -sign);
                    }
                    if leave < far.0 {
                        far = (leave, k, sign);
                    }
                }
                if near.0 < far.0 {
                    for ((t, k, sign), enters) in [(near, true), (far, false)] {
                        let n = unit(axes[k]) * sign;
                        let face = 2 * k as Face + Face::from(sign > 0.0);
                        add(t, enters, face, n, n.dot(center) + f64::from(half[k]));
                    }
                }
            }
        }
    }
}

/// A vector of unit length in single precision, so long in double precision, too.
#[inline]
pub fn unit(axis: Vec3) -> DVec3 {
    let axis = axis.as_dvec3();
    // 1/√(1+ε) = 1 − ε/2 + O(ε²)
    axis * (1.5 - 0.5 * axis.length_squared())
}

/// The face of a piece with that outward normal.
#[inline]
pub fn face_of(piece: &Piece, outward: Vec3) -> Face {
    let Piece::Block { axes, .. } = piece else { return 0 };
    let along = axes.map(|axis| axis.dot(outward));
    let k = (0..3).max_by(|&a: &usize, &b| along[a].abs().total_cmp(&along[b].abs())).unwrap_or(0);
    2 * k as Face + Face::from(along[k] > 0.0)
}
