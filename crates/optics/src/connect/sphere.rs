//! Connections through a ball: a lens, a marble, a drop, a bubble; every bend of the light, rainbows too.

use vitrine_math::DVec3;

use super::around::{Around, Legs, Run, on_side};
use super::{Chains, Target};

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre, in metres.
    pub center: DVec3,
    /// Its radius, in metres, above 0.
    pub radius: f64,
    /// The index inside over the index outside, above 0; below 1 for a bubble.
    pub eta: f64,
}

/// What the light does at a ball, on the way between the receiver and the light. The numbers count the reflections
/// inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Reflected at the outside: both ends are outside (Alhazen's problem).
    Off,
    /// Both ends are outside: 0 straight through, 1 the primary rainbow, up to 14.
    Across(u32),
    /// The receiver is inside, the light outside; up to 15.
    Out(u32),
    /// The receiver is outside, the light inside; up to 15.
    In(u32),
    /// Both ends are inside: at least 1, up to 16.
    Within(u32),
}

impl Way {
    /// Whether the receiver is inside, whether the light is, and the number of reflections inside.
    #[inline]
    fn sides(self) -> (bool, bool, u32) {
        match self {
            Way::Off => (false, false, 0),
            Way::Across(k) => (false, false, k),
            Way::Out(k) => (true, false, k),
            Way::In(k) => (false, true, k),
            Way::Within(k) => (true, true, k),
        }
    }
}

/// Adds every chain that goes the given way between `x` and the light to `out`.
///
/// All solutions are found: at most 1 for reflection, 3 straight through, 4 and 5 for the first two rainbows are what
/// tens of thousands of random places showed. An end on the wrong side of the surface gives none. With the ends and the
/// centre in one line, of the solutions only the straight one counts: the others are rings, which have no finite spread.
pub fn connect(x: DVec3, target: Target, ball: &Ball, way: Way, out: &mut Chains) {
    let Some(mut around) = Around::new(x, target, ball.center, ball.radius) else { return };
    let (x_inside, y_inside, order) = way.sides();
    let (Some(rx), Some(ry)) =
        (on_side(around.rx, ball.radius, x_inside), on_side(around.ry, ball.radius, y_inside))
    else {
        return;
    };
    (around.rx, around.ry) = (rx, ry);
    // Inside, a path can leave an end outwards or towards the middle first.
    let firsts: &[Run] = if x_inside { &[Run::Out, Run::Through] } else { &[Run::In] };
    let lasts: &[Run] = if y_inside { &[Run::In, Run::Through] } else { &[Run::Out] };
    for &first in firsts {
        for &last in lasts {
            if let Some(legs) = legs(ball, way, order, (first, last), ry) {
                around.connect(&legs, 0.0, out);
            }
        }
    }
}

/// A path that a ray has found: how it leaves the receiver and how it comes to the light.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// The receiver.
    pub x: DVec3,
    /// The unit direction there towards the first vertex.
    pub wx: DVec3,
    /// The light.
    pub target: Target,
    /// The unit direction at the light towards the last vertex.
    pub wy: DVec3,
}

/// The spread of a path through a ball that is known already, in 1/m² (without a unit for a distant light): no root is
/// searched. None where it is not finite, at the caustic.
#[must_use]
pub fn spread_of(known: &Known, ball: &Ball, way: Way) -> Option<f64> {
    let mut around = Around::new(known.x, known.target, ball.center, ball.radius)?;
    let (x_inside, y_inside, order) = way.sides();
    around.rx = if x_inside { around.rx.min(ball.radius) } else { around.rx.max(ball.radius) };
    around.ry = if y_inside { around.ry.min(ball.radius) } else { around.ry.max(ball.radius) };
    // Inside, the path leaves an end outwards or towards the middle first.
    let leaves = |p: DVec3, w: DVec3| w.dot(p - ball.center) > 0.0;
    let first = match (x_inside, leaves(known.x, known.wx)) {
        (false, _) => Run::In,
        (true, true) => Run::Out,
        (true, false) => Run::Through,
    };
    let last = match (y_inside, known.target) {
        (true, Target::Point(y)) if leaves(y, known.wy) => Run::In,
        (true, _) => Run::Through,
        (false, _) => Run::Out,
    };
    let legs = legs(ball, way, order, (first, last), around.ry)?;
    let n = if x_inside { ball.eta } else { 1.0 };
    // Bouguer: b = n ρ sin(angle with the radius)
    let b = n * (known.x - ball.center).cross(known.wx).length();
    let spread = around.known_spread(&legs, b);
    (spread.is_finite() && spread >= 0.0).then_some(spread)
}

/// The legs of one way; None if it has too many.
fn legs(ball: &Ball, way: Way, order: u32, (first, last): (Run, Run), ry: f64) -> Option<Legs> {
    let (n, r) = (ball.eta, ball.radius);
    let mut legs = Legs::new();
    let mut chords = order;
    match way {
        Way::Off => {
            legs.push(1.0, r, first);
            legs.push(1.0, ry, last);
            return Some(legs);
        }
        Way::Across(_) | Way::In(_) => {
            legs.push(1.0, r, first);
        }
        Way::Out(_) | Way::Within(_) => {
            legs.push(n, r, first);
        }
    }
    match way {
        Way::Across(_) => chords = order.checked_add(1)?,
        // The last reflection is followed by the light.
        Way::Within(_) => chords = chords.checked_sub(1)?,
        _ => {}
    }
    for _ in 0..chords {
        if !legs.push(n, r, Run::Through) {
            return None;
        }
    }
    let index = if matches!(way, Way::In(_) | Way::Within(_)) { n } else { 1.0 };
    legs.push(index, ry, last).then_some(legs)
}

#[cfg(test)]
mod tests;
