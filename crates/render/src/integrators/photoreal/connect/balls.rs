//! Through balls, nests of them, and off them.

use super::super::media::Media;
use super::found::{Found, Leaving, Node};
use super::{Kinds, MOST_STEPS, Search, Step, Steps};
use crate::compile::{AIR, MOST_SHELLS, Nest};
use vitrine_math::DVec3;
use vitrine_optics::connect::shells::{self, Course, Pair, Shell};
use vitrine_optics::connect::{Chains, Target};

/// A point so near to a ball, as a share of the coordinates, lies on it: what single precision can tell apart.
const ON: f64 = 4e-6;

/// What holds a place apart from the balls of a nest.
pub fn outside(nest: &Nest, media: Media) -> Media {
    nest.balls.iter().fold(media, |media, ball| media.without(ball.0))
}

/// A nest between two ends.
pub struct Around<'a> {
    nest: &'a Nest,
    pub center: DVec3,
    pub shells: [Shell; MOST_SHELLS],
    /// Within how many of the balls x and y lie.
    pub within: [usize; 2],
    /// What is outside of all balls.
    here: u16,
}

impl<'a> Around<'a> {
    /// None where something else is in the place of a ball, or around one end but not around the other.
    pub fn new(search: &Search, nest: &'a Nest) -> Option<Self> {
        let Search { solids, ends, there, .. } = search;
        let [here, at_y] = [ends.media, *there].map(|media| outside(nest, media).top(solids));
        if at_y == here { Self::within(search, nest, here) } else { None }
    }

    /// The same where it is known what is around the nest.
    pub fn within(search: &Search, nest: &'a Nest, here: u16) -> Option<Self> {
        let Search { solids, ends, .. } = search;
        if here != AIR && solids.get(nest.balls[0].0).rank > solids.get(here).rank {
            return None;
        }
        let is_in = |ball: &&(u16, f32)| ends.media.holds(ball.0);
        let of_x = nest.balls.iter().take_while(is_in).count();
        if nest.balls[of_x..].iter().any(|ball| is_in(&ball)) {
            return None;
        }
        let center = nest.center.as_dvec3();
        let r = (ends.y - center).length();
        let own = ON * (center.abs().max_element() + f64::from(nest.balls[0].1));
        let of_y = nest.balls.iter().take_while(|ball| r < f64::from(ball.1) - own).count();
        let mut outside = search.index(here);
        let shells = std::array::from_fn(|k| {
            let (solid, radius) = nest.balls.get(k).copied().unwrap_or((AIR, 0.0));
            let shell = Shell { radius: radius.into(), outside, inside: search.index(solid) };
            outside = shell.inside;
            shell
        });
        Some(Self { nest, center, shells, within: [of_x, of_y], here })
    }

    pub fn optical(&self) -> shells::Nest<'_> {
        let Self { center, within, .. } = *self;
        shells::Nest { center, shells: &self.shells[..self.nest.balls.len()], within }
    }

    /// The surfaces of a course; None if they are too many.
    pub fn steps(&self, course: &Course) -> Option<Steps> {
        let medium = |within: usize| within.checked_sub(1).map_or(self.here, |k| self.nest.balls[k].0);
        let mut steps = Steps::default();
        for meeting in course.meetings() {
            let shell = usize::from(meeting.shell);
            let (inside, outside) = (medium(shell + 1), medium(shell));
            let (before, beyond) =
                if meeting.deed.is_from_inside() { (inside, outside) } else { (outside, inside) };
            let solid = self.nest.balls[shell].0;
            let reflects = meeting.deed.reflects();
            if !steps.push(Step { solid, reflects, before, beyond, ..Step::NONE }) {
                return None;
            }
        }
        Some(steps)
    }

    /// Calls `try_one` with all courses of which connections are looked for: through, to any depth, and with one reflection at
    /// any surface, from outside or inside.
    fn each_course(&self, kinds: Kinds, mut try_one: impl FnMut(&Course, &Steps)) {
        let (count, within) = (self.nest.balls.len(), self.within);
        let [i, j] = within;
        let deepest = i.max(j);
        let mut offer = |course: Option<Course>| {
            if let Some(course) = course.filter(|c| (1..=MOST_STEPS).contains(&c.meetings().len()))
                && let Some(steps) = self.steps(&course)
            {
                try_one(&course, &steps);
            }
        };
        if kinds.plain {
            for depth in deepest..=count {
                offer(Course::through(within, depth));
            }
        }
        if !kinds.rare {
            return;
        }
        for mirror in deepest..count {
            offer(Course::back(within, mirror));
        }
        // What is outside decides how much is reflected inside.
        for mirror in usize::from(self.nest.is_cut)..count {
            for first in i.max(mirror + 1)..=count {
                for second in j.max(mirror + 1)..=count {
                    // A path is as near to the centre on both sides of the mirror, unless it has its end on the way there.
                    let is_end = |end: usize, depth: usize| end > mirror && end == depth;
                    if first == second || is_end(i, first) || is_end(j, second) {
                        offer(Course::echo(within, mirror, [first, second]));
                    }
                }
            }
        }
    }

    /// All ways.
    pub fn connect(&self, search: &Search, chains: &mut Chains, found: &mut Found) {
        let optical = self.optical();
        let ends = search.ends;
        let Some(pair) = Pair::new(ends.x, Target::Point(ends.y), &optical) else { return };
        self.each_course(search.kinds, |course, steps| {
            if !search.wants(&steps.chain()) {
                return;
            }
            chains.clear();
            pair.connect(course, chains);
            for chain in chains.as_slice() {
                let ends = Leaving { wx: chain.wx, wy: chain.wy, spread: chain.spread };
                let nodes = steps.all().iter().zip(course.meetings()).zip(chain.vertices());
                found.push(
                    ends,
                    nodes.map(|((step, meeting), &p)| {
                        let radius = self.shells[usize::from(meeting.shell)].radius;
                        Node { step: *step, n: (p - self.center) / radius, p }
                    }),
                );
            }
        });
    }

    /// The spread of the way that has been found by chance and leaves x along `wx`; None if it would not be looked for.
    pub fn spread_of(&self, search: &Search, wx: DVec3) -> Option<f64> {
        let optical = self.optical();
        let ends = search.ends;
        let pair = Pair::new(ends.x, Target::Point(ends.y), &optical)?;
        let mut spread = None;
        self.each_course(search.kinds, |course, steps| {
            if search.wants(&steps.chain()) {
                spread = pair.spread_of(wx, course);
            }
        });
        spread
    }
}
