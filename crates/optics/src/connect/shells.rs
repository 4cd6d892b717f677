//! Connections through concentric shells: a ball, a light bulb, a fish bowl, a snow globe with its water. A path is told by
//! what it does at the surfaces that it meets, one after the other; all of its solutions are found.

use vitrine_math::DVec3;

use super::around::{Around, Legs, Run, on_side};
use super::{Chains, MAX_VERTICES, Target};

/// One surface of a nest of shells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shell {
    /// In metres, above 0.
    pub radius: f64,
    /// The index of the medium around it.
    pub outside: f64,
    /// The index of the medium within.
    pub inside: f64,
}

/// Concentric surfaces, and the media in which the ends of the path are.
#[derive(Clone, Copy, Debug)]
pub struct Nest<'a> {
    /// The common centre, in metres.
    pub center: DVec3,
    /// The surfaces from the outermost to the innermost, at most 8; the inside of each is the outside of the next.
    pub shells: &'a [Shell],
    /// Within how many of the surfaces the receiver and the light lie: 0 is outside of all.
    pub within: [usize; 2],
}

/// What the light does at a surface, on the way from the receiver to the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deed {
    /// It passes inwards.
    Enter,
    /// It passes outwards.
    Leave,
    /// It is reflected at the outside: totally, where a shell of glass holds air and the path is flat enough, else in part.
    Off,
    /// It is reflected at the inside.
    Echo,
}

impl Deed {
    /// Whether the path comes to the surface from within, and whether it goes on within.
    const fn sides(self) -> (bool, bool) {
        match self {
            Self::Enter => (false, true),
            Self::Leave => (true, false),
            Self::Off => (false, false),
            Self::Echo => (true, true),
        }
    }

    /// Whether the path comes to the surface from within.
    #[must_use]
    pub const fn is_from_inside(self) -> bool {
        self.sides().0
    }

    /// Whether the light is reflected.
    #[must_use]
    pub const fn reflects(self) -> bool {
        matches!(self, Self::Off | Self::Echo)
    }
}

/// A surface that a path meets, counted from 0 at the outermost, and what happens there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meeting {
    /// Which one.
    pub shell: u8,
    /// What happens.
    pub deed: Deed,
}

/// What a path meets, in order from the receiver to the light.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    meetings: [Meeting; MAX_VERTICES],
    len: usize,
}

impl Course {
    /// A path that meets these surfaces; None if they are too many.
    pub fn new(meetings: impl IntoIterator<Item = Meeting>) -> Option<Self> {
        let none = Meeting { shell: 0, deed: Deed::Enter };
        let mut course = Self { meetings: [none; MAX_VERTICES], len: 0 };
        for meeting in meetings {
            *course.meetings.get_mut(course.len)? = meeting;
            course.len += 1;
        }
        Some(course)
    }

    /// Through all surfaces that it reaches: where it is closest to the centre it is within `depth` of them.
    #[must_use]
    pub fn through([i, j]: [usize; 2], depth: usize) -> Option<Self> {
        Self::new(inwards(i, depth).chain(outwards(depth, j)))
    }

    /// Through the surfaces around this one, and off its outside. Neither end lies within it.
    #[must_use]
    pub fn back([i, j]: [usize; 2], mirror: usize) -> Option<Self> {
        let off = meeting(mirror, Deed::Off);
        Self::new(inwards(i, mirror).chain([off]).chain(outwards(mirror, j)))
    }

    /// To the inside of a mirror and from there to the light, on both sides of it within so many of the surfaces where it is
    /// closest to the centre, or as many as the end is.
    #[must_use]
    pub fn echo([i, j]: [usize; 2], mirror: usize, [first, second]: [usize; 2]) -> Option<Self> {
        let echo = meeting(mirror, Deed::Echo);
        let to = inwards(i, first).chain(outwards(first, mirror + 1));
        Self::new(to.chain([echo]).chain(inwards(mirror + 1, second)).chain(outwards(second, j)))
    }

    /// What it meets.
    #[inline]
    #[must_use]
    pub fn meetings(&self) -> &[Meeting] {
        &self.meetings[..self.len]
    }
}

const fn meeting(shell: usize, deed: Deed) -> Meeting {
    Meeting { shell: shell as u8, deed }
}

/// From within `from` surfaces inwards until within `to`.
fn inwards(from: usize, to: usize) -> impl Iterator<Item = Meeting> {
    (from..to).map(|shell| meeting(shell, Deed::Enter))
}

/// From within `from` surfaces outwards until within `to`.
fn outwards(from: usize, to: usize) -> impl Iterator<Item = Meeting> {
    (to..from).rev().map(|shell| meeting(shell, Deed::Leave))
}

/// Adds every chain of this course between `x` and the light to `out`; a distant light is outside of all shells.
pub fn connect(x: DVec3, target: Target, nest: &Nest<'_>, course: &Course, out: &mut Chains) {
    if let Some(pair) = Pair::new(x, target, nest) {
        pair.connect(course, out);
    }
}

/// A receiver and a light around a nest.
pub struct Pair<'a> {
    nest: &'a Nest<'a>,
    around: Around,
}

impl<'a> Pair<'a> {
    /// None where an end lies on the wrong side of a surface, or something is not finite.
    #[must_use]
    pub fn new(x: DVec3, target: Target, nest: &'a Nest<'a>) -> Option<Self> {
        let (shells, [i, j]) = (nest.shells, nest.within);
        let outer = shells.first().filter(|_| i.max(j) <= shells.len())?;
        let mut around = Around::new(x, target, nest.center, outer.radius)?;
        around.rx = on_place(around.rx, shells, i)?;
        around.ry = on_place(around.ry, shells, j)?;
        Some(Self { nest, around })
    }

    /// Adds every chain of this course to `out`. Its vertices are where it meets the surfaces.
    ///
    /// With the ends and the centre in one line, of the solutions only the straight one counts: the others are rings, which
    /// have no finite spread. A course without surfaces is a straight line, which is not added.
    pub fn connect(&self, course: &Course, out: &mut Chains) {
        let [Some(first), Some(last)] = [course.meetings().first(), course.meetings().last()] else { return };
        // Inside, a path can leave an end outwards or towards the middle first.
        let firsts: &[Run] = if first.deed.sides().0 { &[Run::Out, Run::Through] } else { &[Run::In] };
        let lasts: &[Run] = if last.deed.sides().1 { &[Run::In, Run::Through] } else { &[Run::Out] };
        for &first in firsts {
            for &last in lasts {
                if let Some((legs, low)) = self.legs(course, (first, last)) {
                    self.around.connect(&legs, low, out);
                }
            }
        }
    }

    /// The index of the medium within this many surfaces.
    fn index(&self, within: usize) -> f64 {
        let shells = self.nest.shells;
        if within == 0 { shells[0].outside } else { shells[within - 1].inside }
    }

    /// The legs of a course whose first and last leg run so, and the least b that it can have; None if it cannot be.
    fn legs(&self, course: &Course, (first, last): (Run, Run)) -> Option<(Legs, f64)> {
        let Nest { shells, within: [i, j], .. } = *self.nest;
        let mut legs = Legs::new();
        let (mut within, mut run_of, mut low) = (i, [first, first], 0.0_f64);
        let mut push = |within: usize, to: f64, run: Run| {
            // What passes by the next surface is at least this far from the centre: b ≥ n R.
            if let (Run::Through, Some(next)) = (run, shells.get(within)) {
                low = low.max(next.outside * next.radius);
            }
            legs.push(self.index(within), to, run).then_some(())
        };
        for meeting in course.meetings() {
            let number = usize::from(meeting.shell);
            let shell = shells.get(number)?;
            let (from_inside, on_inside) = meeting.deed.sides();
            if within != number + usize::from(from_inside) {
                return None;
            }
            push(within, shell.radius, run_of[usize::from(from_inside)])?;
            within = number + usize::from(on_inside);
            // From the inside of a surface to a smaller one or to its own inside; from the outside outwards only.
            run_of = if on_inside { [Run::In, Run::Through] } else { [Run::Out, Run::Out] };
        }
        push(within, self.around.ry, last)?;
        (within == j).then_some((legs, low))
    }
}

/// The distance from the centre, if it is within just `within` of the surfaces.
fn on_place(r: f64, shells: &[Shell], within: usize) -> Option<f64> {
    let r = if within > 0 { on_side(r, shells[within - 1].radius, true)? } else { r };
    shells.get(within).map_or(Some(r), |s| on_side(r, s.radius, false))
}

impl Pair<'_> {
    /// The spread of a path of this course that is known already and leaves the receiver along the unit vector `wx`, in 1/m²
    /// (without a unit for a distant light): no root is searched. None where it is not finite, at the caustic.
    #[must_use]
    pub fn spread_of(&self, wx: DVec3, course: &Course) -> Option<f64> {
        let [first, last] = [course.meetings().first()?, course.meetings().last()?];
        let around = &self.around;
        let first_run = match first.deed.sides().0 {
            false => Run::In,
            true if around.leaves(wx) => Run::Out,
            true => Run::Through,
        };
        let lasts: &[Run] = if last.deed.sides().1 { &[Run::In, Run::Through] } else { &[Run::Out] };
        let b = around.bouguer(self.index(self.nest.within[0]), wx);
        let mut best = (f64::INFINITY, None);
        for &last_run in lasts {
            let Some((legs, _)) = self.legs(course, (first_run, last_run)) else { continue };
            // Where there are two, the one that comes to the light.
            let off = if lasts.len() > 1 { around.off_light(&legs, b, wx) } else { 0.0 };
            if off < best.0 {
                best = (off, Some(around.known_spread(&legs, b)));
            }
        }
        best.1.filter(|spread| spread.is_finite() && *spread >= 0.0)
    }
}

#[cfg(test)]
mod tests;
