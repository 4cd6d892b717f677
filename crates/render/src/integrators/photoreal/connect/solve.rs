//! From a chain of flat faces to the way through them.

use super::super::chain::Face;
use super::found::{Found, Leaving, Node};
use super::{MOST_STEPS, Search, Step, Steps};
use crate::compile::{AIR, Piece};
use vitrine_math::DVec3;
use vitrine_optics::connect::Target;
use vitrine_optics::connect::faces::{self, Care, Face as FlatFace};
use vitrine_optics::connect::planes::{self, Stack};

/// Faces whose normals' cosine differs from 1 by less are parallel.
pub const PARALLEL: f64 = 1e-9;

/// Where a way meets its faces.
type Vertices = [DVec3; MOST_STEPS];

/// Adds the way through flat faces, if there is one that meets them inside their edges.
pub fn solve(search: &Search, steps: &Steps, found: &mut Found) {
    let all = steps.all();
    let Some(first) = all.first().filter(|_| is_possible(search, all)) else { return };
    let is_parallel = all.iter().all(|s| 1.0 - s.n.dot(first.n).abs() < PARALLEL);
    let way = if is_parallel { parallel(search, steps, first.n) } else { slanted(search, steps) };
    let Some((ends, vertices)) = way else { return };
    if all.iter().zip(&vertices).all(|(s, v)| is_met(search, s, *v)) {
        let nodes = all.iter().zip(&vertices).map(|(step, p)| Node { step: *step, n: step.n, p: *p });
        found.push(ends, nodes);
    }
}

/// Through parallel faces. Where light is reflected, the rest of the way is unfolded: a mirror image of it goes straight on.
fn parallel(search: &Search, steps: &Steps, n: DVec3) -> Option<(Leaving, Vertices)> {
    let (all, x, y) = (steps.all(), search.ends.x, search.ends.y);
    let heights = all.iter().map(|s| s.offset * s.n.dot(n).signum());
    let mut height = n.dot(x);
    let first = heights.clone().next()?;
    let start = if first > height { 1.0 } else { -1.0 };
    let (mut side, mut unfolded) = (start, 0.0);
    let (mut offsets, mut indices) = ([0.0; MOST_STEPS], [1.0; MOST_STEPS + 1]);
    indices[0] = search.index(all[0].before);
    let mut at = [0.0; MOST_STEPS];
    for (k, (step, next)) in all.iter().zip(heights).enumerate() {
        let thickness = (next - height) * side;
        // Not in that order on the way.
        if thickness <= 0.0 {
            return None;
        }
        unfolded += thickness;
        (height, offsets[k], at[k]) = (next, unfolded, next);
        indices[k + 1] = search.index(step.after());
        if step.reflects {
            side = -side;
        }
    }
    let last = (n.dot(y) - height) * side;
    if last <= 0.0 {
        return None;
    }
    let way = y - x;
    let along = n * start;
    let lateral = way - n * n.dot(way);
    let y = lateral + along * (unfolded + last);
    let stack = Stack { n: along, offsets: &offsets[..all.len()], indices: &indices[..=all.len()] };
    let way = planes::connect(DVec3::ZERO, Target::Point(y), &stack)?;
    let mut ends = Leaving { wx: way.wx, wy: way.wy, spread: way.spread };
    let mut vertices = [DVec3::ZERO; MOST_STEPS];
    let foot = x - n * n.dot(x);
    for (k, vertex) in way.vertices().iter().enumerate() {
        // Folded back: as far along the faces, at its face's own height.
        let across = *vertex - n * n.dot(*vertex);
        vertices[k] = foot + across + n * at[k];
    }
    if side * start < 0.0 {
        ends.wy -= n * (2.0 * n.dot(ends.wy));
    }
    Some((ends, vertices))
}

/// Through faces that are not parallel.
fn slanted(search: &Search, steps: &Steps) -> Option<(Leaving, Vertices)> {
    let all = steps.all();
    let none = FlatFace { point: DVec3::ZERO, n: DVec3::Z, before: 1.0, behind: 1.0, is_mirror: false };
    let mut flat = [none; MOST_STEPS];
    for (face, step) in flat.iter_mut().zip(all) {
        *face = FlatFace {
            point: step.n * step.offset,
            n: step.n,
            before: search.index(step.before),
            behind: search.index(step.after()),
            is_mirror: step.reflects,
        };
    }
    // Many ways are not there, and to make sure of that takes long.
    let way = faces::connect(search.ends.x, Target::Point(search.ends.y), &flat[..all.len()], Care::Quick)?;
    let mut vertices = [DVec3::ZERO; MOST_STEPS];
    for (to, from) in vertices.iter_mut().zip(way.vertices()) {
        *to = *from;
    }
    Some((Leaving { wx: way.wx, wy: way.wy, spread: way.spread }, vertices))
}

/// Whether no block is entered and left by faces between which light cannot pass.
///
/// Inside, |cos|² between the way and each of the two normals is at least 1 − (n_outside/n)², mirrors at other faces of it keep both, and
/// at right angles the squares add up to 1 at most: between two sides of glass that meet none passes if n² > 2.
fn is_possible(search: &Search, all: &[Step]) -> bool {
    let least = |step: &Step, outside: u16| {
        let ratio = search.index(outside) / search.index(step.solid);
        (1.0 - ratio * ratio).max(0.0)
    };
    let mut entered: Option<(u16, Face, f64)> = None;
    for step in all {
        if step.reflects {
            entered = entered.filter(|(solid, ..)| *solid == step.solid);
        } else if step.beyond == step.solid {
            entered = Some((step.solid, step.face / 2, least(step, step.before)));
        } else if let Some((solid, axis, of_entry)) = entered.take()
            && solid == step.solid
            && axis != step.face / 2
            && of_entry + least(step, step.beyond) > 1.0
        {
            return false;
        }
    }
    true
}

/// Whether a way meets a surface in a point: it lies inside the edges of its face, and nothing else is there.
pub fn is_met(search: &Search, step: &Step, vertex: DVec3) -> bool {
    is_on_face(search, step, vertex) && is_as_assumed(search, step, vertex)
}

/// Whether a vertex lies inside the edges of its face.
fn is_on_face(search: &Search, step: &Step, vertex: DVec3) -> bool {
    match search.solids.get(step.solid).piece {
        Some(Piece::Block { center, axes, half }) => {
            let local = vertex - center.as_dvec3();
            let across = usize::from(step.face / 2);
            (0..3).filter(|k| *k != across).all(|k| axes[k].as_dvec3().dot(local).abs() <= f64::from(half[k]))
        }
        _ => true,
    }
}

/// Whether a vertex lies between what the line that showed the way has found there: the way goes beside the line, and surfaces that
/// are hidden may end in between.
fn is_as_assumed(search: &Search, step: &Step, vertex: DVec3) -> bool {
    let Search { solids, ends, .. } = search;
    let p = vertex.as_vec3();
    let holds = |solid: u16| match &solids.get(solid).piece {
        Some(piece) => piece.holds(p),
        None => true,
    };
    let rank = |solid: &u16| solids.get(*solid).rank;
    let others = solids.clear().iter().copied().chain(ends.media.unclear(solids));
    let outside = others.filter(|s| *s != step.solid && holds(*s)).min_by_key(rank).unwrap_or(AIR);
    let [inside, around] =
        if step.before == step.solid { [step.before, step.beyond] } else { [step.beyond, step.before] };
    inside == step.solid && around == outside
}
