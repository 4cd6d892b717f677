//! Connections through a ball: a lens, a marble, a drop, a bubble; every bend of the light, rainbows too. It is a nest of one
//! shell ([`super::shells`]).

use vitrine_math::DVec3;

use super::shells::{Course, Deed, Meeting, Nest, Pair, Shell};
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
    /// Within how many surfaces the receiver and the light are, and the number of reflections inside.
    #[inline]
    fn sides(self) -> ([usize; 2], u32) {
        match self {
            Self::Off => ([0, 0], 0),
            Self::Across(k) => ([0, 0], k),
            Self::Out(k) => ([1, 0], k),
            Self::In(k) => ([0, 1], k),
            Self::Within(k) => ([1, 1], k),
        }
    }

    fn course(self) -> Option<Course> {
        let at = |deed| Meeting { shell: 0, deed };
        if self == Self::Off {
            return Course::new([at(Deed::Off)]);
        }
        let ([i, j], inside) = self.sides();
        let enter = (i == 0).then_some(at(Deed::Enter));
        let leave = (j == 0).then_some(at(Deed::Leave));
        Course::new(enter.into_iter().chain((0..inside).map(|_| at(Deed::Echo))).chain(leave))
    }
}

/// Adds every chain that goes the given way between `x` and the light to `out`.
///
/// All solutions are found: at most 1 for reflection, 3 straight through, 4 and 5 for the first two rainbows are what
/// tens of thousands of random places showed. An end on the wrong side of the surface gives none.
pub fn connect(x: DVec3, target: Target, ball: &Ball, way: Way, out: &mut Chains) {
    with(x, target, ball, way, |pair, course| pair.connect(course, out));
}

/// The spread of a path through a ball that is known already; see [`Pair::spread_of`].
#[must_use]
pub fn spread_of(x: DVec3, wx: DVec3, target: Target, ball: &Ball, way: Way) -> Option<f64> {
    with(x, target, ball, way, |pair, course| pair.spread_of(wx, course)).flatten()
}

fn with<T>(
    x: DVec3,
    target: Target,
    ball: &Ball,
    way: Way,
    act: impl FnOnce(&Pair<'_>, &Course) -> T,
) -> Option<T> {
    let shells = [Shell { radius: ball.radius, outside: 1.0, inside: ball.eta }];
    let nest = Nest { center: ball.center, shells: &shells, within: way.sides().0 };
    Some(act(&Pair::new(x, target, &nest)?, &way.course()?))
}

#[cfg(test)]
mod tests;
