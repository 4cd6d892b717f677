//! Ways with a reflection at a flat face: off panes and water, and off the inside of a pane's faces, where light that came in by another
//! face is often reflected totally, as at the edges of a shelf.
//!
//! The straight line from x to the mirror image of y says where the light is reflected. Folded back, it is a bent line from x over the
//! mirror to y, and what that crosses are the surfaces of the way, as the straight line says those of a way without a mirror.

use super::super::chain::Face;
use super::block::{Block, Side};
use super::crossings::{Corner, Crossings};
use super::flat::offer;
use super::found::Found;
use super::solve::PARALLEL;
use super::{Search, Step};
use crate::compile::Piece;
use vitrine_math::DVec3;

/// So many bent lines are tried from each point.
const MOST_LINES: usize = 16;

/// Adds all such ways.
pub fn connect(search: &Search, bent: &mut Crossings, found: &mut Found) {
    let mut mirrors = Mirrors { search, bent, found, left: MOST_LINES };
    for &solid in search.solids.clear() {
        match search.solids.get(solid).piece {
            Some(Piece::Below { n, offset }) => mirrors.plane(solid, n.as_dvec3(), offset.into()),
            _ => {
                if let Some(block) = Block::new(search, solid) {
                    mirrors.block(&block);
                }
            }
        }
        if mirrors.left == 0 {
            return;
        }
    }
}

impl Block {
    fn corner(&self, side: Side, p: DVec3, is_outside: bool) -> Corner {
        let Side { axis, sign } = side;
        let n = self.axes[axis] * sign;
        let p = self.world(p);
        let offset = n.dot(self.center) + self.half[axis];
        Corner {
            p,
            solid: self.solid,
            face: 2 * axis as Face + Face::from(sign > 0.0),
            n,
            offset,
            is_outside,
        }
    }

    /// Where the light is reflected at one face.
    fn at(&self, side: Side) -> Option<Corner> {
        let [hx, hy] = self.heights(side);
        // On one side of it.
        if hx * hy <= 0.0 {
            return None;
        }
        let mut p = self.x + (self.y - self.x) * (hx / (hx + hy));
        p[side.axis] = side.sign * self.half[side.axis];
        self.covers(p, side.axis).then(|| self.corner(side, p, hx > 0.0))
    }
}

struct Mirrors<'a, 's> {
    search: &'a Search<'s>,
    bent: &'a mut Crossings,
    found: &'a mut Found,
    left: usize,
}

impl Mirrors<'_, '_> {
    fn plane(&mut self, solid: u16, n: DVec3, offset: f64) {
        let ends = self.search.ends;
        let [hx, hy] = [ends.x, ends.y].map(|p| n.dot(p) - offset);
        if hx * hy > 0.0 {
            let (x, y) = (ends.x - n * hx, ends.y - n * hy);
            let p = x + (y - x) * (hx / (hx + hy));
            self.over(&Corner { p, solid, face: 0, n, offset, is_outside: hx > 0.0 });
        }
    }

    fn block(&mut self, block: &Block) {
        for side in Side::all() {
            if let Some(corner) = block.at(side) {
                self.over(&corner);
            }
        }
    }

    /// The way over this mirror.
    fn over(&mut self, corner: &Corner) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        let Search { solids, ends, only, .. } = self.search;
        if only.is_some_and(|only| !only.holds(corner.solid, corner.face, true)) {
            return;
        }
        self.bent.bend(solids, ends, corner);
        if let Some(steps) = self.bent.steps()
            && is_worth_it(self.search, steps.all())
        {
            offer(self.search, steps, self.found);
        }
    }
}

/// Whether a way over a mirror is cheap to solve, for all faces are parallel, or likely to bring much light, for it may be reflected totally.
///
/// Between parallel faces n·sin θ stays as it is, so light that crosses one of them next to the mirror from or to a medium no denser than
/// what is behind the mirror is never reflected totally.
fn is_worth_it(search: &Search, all: &[Step]) -> bool {
    let is_parallel = |a: &Step, b: &Step| a.n.dot(b.n).abs() > 1.0 - PARALLEL;
    if all.iter().all(|step| is_parallel(step, &all[0])) {
        return true;
    }
    let Some(at) = all.iter().position(|step| step.reflects) else { return true };
    let mirror = &all[at];
    let behind = search.index(mirror.beyond);
    let is_denser = |solid: u16| search.index(solid) > behind;
    let mut before = all[..at].iter().rev().take_while(|step| is_parallel(step, mirror));
    let mut after = all[at + 1..].iter().take_while(|step| is_parallel(step, mirror));
    is_denser(mirror.before)
        && before.all(|step| is_denser(step.before))
        && after.all(|step| is_denser(step.beyond))
}

impl Corner {
    /// The mirror as a surface of the way.
    pub fn step(&self, before: u16, beyond: u16) -> Step {
        let &Self { solid, face, n, offset, .. } = self;
        Step { solid, face, reflects: true, n, before, beyond, offset }
    }
}
