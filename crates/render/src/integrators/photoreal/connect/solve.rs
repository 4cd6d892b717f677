//! From a chain of surfaces to the way through them.

use super::{Connection, MOST_STEPS, Search, Step, Steps};
use crate::compile::Piece;
use vitrine_math::DVec3;
use vitrine_optics::connect::faces::{self, Face as FlatFace};
use vitrine_optics::connect::planes::{self, Stack};
use vitrine_optics::connect::sphere::{self, Way};
use vitrine_optics::connect::{Chain, Chains, Target};

/// Faces whose normals' cosine differs from 1 by less are parallel.
const PARALLEL: f64 = 1e-9;
/// The most reflections inside a ball that are solved: one makes the rainbow's bright side.
const MOST_INSIDE: u32 = 1;

/// The way through flat faces, if there is one that meets them inside their edges.
pub fn flat(search: &Search, steps: &Steps) -> Option<Connection> {
    let all = steps.all();
    let n = all.first()?.n;
    let is_parallel = all.iter().all(|s| 1.0 - s.n.dot(n).abs() < PARALLEL);
    let connection = if is_parallel { parallel(search, steps, n)? } else { slanted(search, steps)? };
    let is_inside = all.iter().zip(&connection.vertices).all(|(s, v)| is_on_face(search, s, *v));
    is_inside.then_some(connection)
}

/// Through parallel faces. Where light is reflected, the rest of the way is unfolded: a mirror image of it goes straight on.
fn parallel(search: &Search, steps: &Steps, n: DVec3) -> Option<Connection> {
    let (all, ends) = (steps.all(), search.ends);
    let heights = all.iter().map(|s| s.offset * s.n.dot(n).signum());
    let mut height = n.dot(ends.x);
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
    let last = (n.dot(ends.y) - height) * side;
    if last <= 0.0 {
        return None;
    }
    let way = ends.y - ends.x;
    let along = n * start;
    let lateral = way - n * n.dot(way);
    let y = lateral + along * (unfolded + last);
    let stack = Stack { n: along, offsets: &offsets[..all.len()], indices: &indices[..=all.len()] };
    let way = planes::connect(DVec3::ZERO, Target::Point(y), &stack)?;
    let mut connection = Connection {
        steps: *steps,
        vertices: [DVec3::ZERO; MOST_STEPS],
        wx: way.wx,
        wy: way.wy,
        spread: way.spread,
    };
    for (k, vertex) in way.vertices().iter().enumerate() {
        // Folded back: as far along the faces, at its face's own height.
        let across = *vertex - n * n.dot(*vertex);
        let foot = ends.x - n * n.dot(ends.x);
        connection.vertices[k] = foot + across + n * at[k];
    }
    if side * start < 0.0 {
        connection.wy -= n * (2.0 * n.dot(connection.wy));
    }
    Some(connection)
}

/// Through faces that are not parallel.
fn slanted(search: &Search, steps: &Steps) -> Option<Connection> {
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
    let way = faces::connect(search.ends.x, Target::Point(search.ends.y), &flat[..all.len()])?;
    Some(taken(&way, *steps))
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

fn taken(way: &Chain, steps: Steps) -> Connection {
    let mut vertices = [DVec3::ZERO; MOST_STEPS];
    for (to, from) in vertices.iter_mut().zip(way.vertices()) {
        *to = *from;
    }
    Connection { steps, vertices, wx: way.wx, wy: way.wy, spread: way.spread }
}

/// A clear ball.
pub struct Ball {
    /// The solid.
    pub solid: u16,
    /// Metres.
    pub center: DVec3,
    /// Metres.
    pub radius: f64,
    /// What is at x.
    pub here: u16,
}

/// All ways off a ball and through it.
pub fn ball(search: &Search, ball: &Ball, chains: &mut Chains, found: &mut Vec<Connection>) {
    let ends = search.ends;
    let is_in = |p: DVec3| (p - ball.center).length() < ball.radius * (1.0 - 1e-6);
    match (is_in(ends.x), is_in(ends.y)) {
        (false, false) => through(search, ball, chains, found),
        (true, false) if ends.media.holds(ball.solid) => out_of(search, ball, chains, found),
        _ => {}
    }
}

fn through(search: &Search, ball: &Ball, chains: &mut Chains, found: &mut Vec<Connection>) {
    let ends = search.ends;
    let outside = ends.media.without(ball.solid);
    let sides = outside.across(search.solids, ball.solid, true);
    // Something else is there in its place.
    if sides.before != ball.here || sides.beyond != ball.solid {
        return;
    }
    let eta = search.index(ball.solid) / search.index(ball.here);
    let target = Target::Point(ends.y);
    let form = sphere::Ball { center: ball.center, radius: ball.radius, eta };
    for way in std::iter::once(Way::Off).chain((0..=MOST_INSIDE).map(Way::Across)) {
        let steps = steps_through(ball, way);
        if !search.wants(&steps.chain()) {
            continue;
        }
        chains.clear();
        sphere::connect(ends.x, target, &form, way, chains);
        found.extend(chains.as_slice().iter().map(|c| with_normals(ball, taken(c, steps))));
    }
}

/// Off a ball, or in, some reflections inside, and out again.
fn steps_through(ball: &Ball, way: Way) -> Steps {
    let &Ball { solid, here, .. } = ball;
    let off = Step { solid, reflects: true, before: here, beyond: solid, ..Step::NONE };
    let echo = Step { before: solid, beyond: here, ..off };
    let mut steps = Steps::default();
    let Way::Across(inside) = way else {
        steps.push(off);
        return steps;
    };
    steps.push(Step { reflects: false, ..off });
    for _ in 0..inside {
        steps.push(echo);
    }
    steps.push(Step { reflects: false, ..echo });
    steps
}

fn out_of(search: &Search, ball: &Ball, chains: &mut Chains, found: &mut Vec<Connection>) {
    let ends = search.ends;
    let sides = ends.media.across(search.solids, ball.solid, false);
    if sides.before != ball.solid || sides.beyond == ball.solid {
        return;
    }
    let mut steps = Steps::default();
    steps.push(Step { solid: ball.solid, before: ball.solid, beyond: sides.beyond, ..Step::NONE });
    if !search.wants(&steps.chain()) {
        return;
    }
    let eta = search.index(ball.solid) / search.index(sides.beyond);
    chains.clear();
    let form = sphere::Ball { center: ball.center, radius: ball.radius, eta };
    sphere::connect(ends.x, Target::Point(ends.y), &form, Way::Out(0), chains);
    found.extend(chains.as_slice().iter().map(|c| with_normals(ball, taken(c, steps))));
}

/// With the ball's normals where the way meets it.
fn with_normals(ball: &Ball, mut connection: Connection) -> Connection {
    for k in 0..connection.steps.len {
        connection.steps.all[k].n = (connection.vertices[k] - ball.center) / ball.radius;
    }
    connection
}
