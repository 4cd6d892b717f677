//! Which ways over flat faces are looked for: the one that the straight line shows, light that goes to and fro inside its panes,
//! and light that is reflected ([`mirrors`]).

use super::crossings::Crossings;
use super::found::{Found, Leaving};
use super::solve::solve;
use super::{Search, Step, Steps, detours, mirrors};
use crate::compile::Piece;

/// The most reflections to and fro inside a pane that are solved: the rest carries a millionth of the light.
const MOST_ECHOES: usize = 2;

/// Adds them all.
pub fn connect(search: &Search, [line, bent]: [&mut Crossings; 2], found: &mut Found) {
    let kinds = search.kinds;
    if let Some(steps) = line.steps() {
        if kinds.plain {
            if steps.all().is_empty() { straight(search, found) } else { offer(search, steps, found) }
        }
        if kinds.rare {
            echoes(search, steps, found);
        }
    }
    if kinds.rare {
        detours::connect(search, line.steps().map(Steps::chain).as_ref(), bent, found);
        mirrors::connect(search, bent, found);
    }
}

/// Adds the way through these faces, if it is wanted.
pub fn offer(search: &Search, steps: &Steps, found: &mut Found) {
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
