//! Ways through a nest of balls and flat faces: a ball behind a pane, in a display case, in water.
//!
//! Nothing counts these ways. Flat faces bend them a little only, so they are looked for from the ways that would lead through the
//! nest without the faces; which faces there are, the line by way of the nest's centre says.

use super::balls::Around;
use super::crossings::Crossings;
use super::found::{Found, Leaving, Node};
use super::solve::is_met;
use super::{MOST_STEPS, Search, Step, Steps};
use crate::compile::Nest;
use vitrine_math::DVec3;
use vitrine_optics::connect::shells::{Course, Pair};
use vitrine_optics::connect::walk::{self, Interface, Surface};
use vitrine_optics::connect::{Chains, Target};

/// Ways from two starts whose directions' cosine differs from 1 by less are the same.
const TWICE: f64 = 1e-12;

/// Adds them all.
pub fn connect(search: &Search, nest: &Nest, tools: (&mut Crossings, &mut Chains), found: &mut Found) {
    let (bent, chains) = tools;
    let Search { solids, ends, .. } = search;
    if solids.clear().len() == nest.balls.len() {
        return;
    }
    let Some((before, media)) = bent.by_way_of(solids, ends, nest) else { return };
    let Some(faces) = bent.steps().filter(|steps| !steps.all().is_empty()) else { return };
    let Some(around) = Around::within(search, nest, media.top(solids)) else { return };
    let optical = around.optical();
    let Some(pair) = Pair::new(ends.x, Target::Point(ends.y), &optical) else { return };
    let [i, j] = around.within;
    let (deepest, count) = (i.max(j), nest.balls.len());
    let through = (deepest..=count).filter_map(|depth| Course::through(around.within, depth));
    let off = (deepest..count).filter_map(|mirror| Course::back(around.within, mirror));
    let through = through.filter(|_| search.kinds.plain);
    let off = off.filter(|_| search.kinds.rare);
    for course in through.chain(off).filter(|course| !course.meetings().is_empty()) {
        let Some(steps) = around.steps(&course).and_then(|steps| spliced(faces, before, &steps)) else {
            continue;
        };
        if !search.wants(&steps.chain()) {
            continue;
        }
        chains.clear();
        pair.connect(&course, chains);
        let mut last = DVec3::ZERO;
        for start in chains.as_slice() {
            if let Some((ends, vertices)) = refined(search, &steps, nest, start.wx)
                && 1.0 - ends.wx.dot(last) > TWICE
            {
                last = ends.wx;
                add(search, nest, (ends, &steps, &vertices), found);
            }
        }
    }
}

/// The surfaces of the nest among the faces, after so many of them.
fn spliced(faces: &Steps, before: usize, nest: &Steps) -> Option<Steps> {
    let (first, last) = faces.all().split_at(before);
    let mut steps = Steps::default();
    first.iter().chain(nest.all()).chain(last).all(|step| steps.push(*step)).then_some(steps)
}

type Vertices = [DVec3; MOST_STEPS];

/// The way to which the direction of another one leads.
fn refined(search: &Search, steps: &Steps, nest: &Nest, start: DVec3) -> Option<(Leaving, Vertices)> {
    let none = Interface {
        surface: Surface::Plane { point: DVec3::ZERO, n: DVec3::Z },
        before: 1.0,
        behind: 1.0,
        is_mirror: false,
    };
    let mut interfaces = [none; MOST_STEPS];
    for (interface, step) in interfaces.iter_mut().zip(steps.all()) {
        *interface = Interface {
            surface: match radius_of(nest, step) {
                Some(radius) => Surface::Ball { center: nest.center.as_dvec3(), radius },
                None => Surface::Plane { point: step.n * step.offset, n: step.n },
            },
            before: search.index(step.before),
            behind: search.index(step.after()),
            is_mirror: step.reflects,
        };
    }
    let target = Target::Point(search.ends.y);
    let way = walk::connect_from(search.ends.x, target, &interfaces[..steps.all().len()], start)?;
    let mut vertices = [DVec3::ZERO; MOST_STEPS];
    for (to, from) in vertices.iter_mut().zip(way.vertices()) {
        *to = *from;
    }
    Some((Leaving { wx: way.wx, wy: way.wy, spread: way.spread }, vertices))
}

/// The radius of the ball whose surface it is; None for a flat face.
fn radius_of(nest: &Nest, step: &Step) -> Option<f64> {
    nest.balls.iter().find(|ball| ball.0 == step.solid).map(|ball| f64::from(ball.1))
}

fn add(search: &Search, nest: &Nest, way: (Leaving, &Steps, &Vertices), found: &mut Found) {
    let (ends, steps, vertices) = way;
    let met = || steps.all().iter().zip(vertices);
    if met().all(|(step, p)| is_met(search, step, *p)) {
        let center = nest.center.as_dvec3();
        found.push(
            ends,
            met().map(|(step, &p)| {
                let n = radius_of(nest, step).map_or(step.n, |radius| (p - center) / radius);
                Node { step: *step, n, p }
            }),
        );
    }
}
