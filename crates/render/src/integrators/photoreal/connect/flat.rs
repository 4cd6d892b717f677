//! Which ways over flat faces are looked for: the one that the straight line shows, light that goes to and fro inside its panes,
//! and light that is reflected.

use super::super::chain::Face;
use super::crossings::Crossings;
use super::found::{Found, Leaving};
use super::solve::solve;
use super::{Search, Step, Steps};
use crate::compile::Piece;
use vitrine_math::DVec3;

/// The most reflections to and fro inside a pane that are solved: the rest carries a millionth of the light.
const MOST_ECHOES: usize = 2;

/// Adds them all.
pub fn connect(search: &Search, crossings: &Crossings, found: &mut Found) {
    match crossings.steps() {
        Some(steps) if steps.all().is_empty() => {
            straight(search, found);
            reflections(search, found);
        }
        Some(steps) => {
            offer(search, steps, found);
            echoes(search, steps, found);
        }
        None => {}
    }
}

/// Adds the way through these faces, if it is wanted.
fn offer(search: &Search, steps: &Steps, found: &mut Found) {
    if search.wants(&steps.chain()) {
        solve(search, steps, found);
    }
}

/// The straight way, through nothing.
fn straight(search: &Search, found: &mut Found) {
    let way = search.ends.y - search.ends.x;
    let distance = way.length();
    if distance > 0.0 && search.only.is_none() {
        let (wx, spread) = (way / distance, 1.0 / (distance * distance));
        found.push(Leaving { wx, wy: -wx, spread }, std::iter::empty());
    }
}

/// The way that the straight line shows, with light that goes to and fro inside one of the panes.
fn echoes(search: &Search, steps: &Steps, found: &mut Found) {
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
            if fits {
                offer(search, &longer, found);
            }
        }
    }
}

/// Off the faces of panes and off water, where x and y are on one side of them.
fn reflections(search: &Search, found: &mut Found) {
    let Search { solids, ends, .. } = search;
    for &solid in solids.clear() {
        match solids.get(solid).piece {
            Some(Piece::Below { n, offset }) => {
                reflection(search, (solid, 0, n.as_dvec3(), f64::from(offset)), found);
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
                            reflection(search, (solid, face, n * sign, offset), found);
                        }
                    }
                }
            }
            _ => {}
        }
    }
}

/// Off one face with that outward normal.
fn reflection(search: &Search, face: (u16, Face, DVec3, f64), found: &mut Found) {
    let (solid, face, n, offset) = face;
    let Search { solids, ends, .. } = search;
    let is_outside = n.dot(ends.x) > offset;
    let sides = ends.media.across(solids, solid, is_outside);
    // A face that something else hides in its place, or that is not where x is.
    if sides.before == sides.beyond || sides.before != ends.media.top(solids) {
        return;
    }
    let step = Step { solid, face, reflects: true, n, before: sides.before, beyond: sides.beyond, offset };
    let mut steps = Steps::default();
    steps.push(step);
    offer(search, &steps, found);
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
    offer(search, &steps, found);
}
