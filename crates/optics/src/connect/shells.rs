//! Connections through concentric shells: a light bulb, a hollow ball, a fish bowl, a snow globe with its water.

use vitrine_math::DVec3;

use super::around::{Around, Legs, Run, on_side};
use super::{Chains, Target};

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

/// What the light does at the shells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// It passes every surface that it reaches. Chains that reach different depths are all found.
    Through,
    /// It passes the surfaces before this one, counted from 0 at the outermost, and is reflected at the outside of it:
    /// totally, where a shell of glass holds air and the path is flat enough, else in part. Neither end lies within it.
    Back(usize),
}

/// Adds every chain of this course between `x` and the light to `out`; a distant light is outside of all shells.
///
/// The vertices of a chain lie on the surfaces in the order in which a path crosses them that goes in and comes out:
/// from the receiver's own medium inwards, and from the deepest one outwards to the light's. With `Back` the one between
/// is the mirror.
pub fn connect(x: DVec3, target: Target, nest: &Nest<'_>, course: Course, out: &mut Chains) {
    let (shells, [i, j]) = (nest.shells, nest.within);
    let (Some(outer), true) = (shells.first(), i.max(j) <= shells.len()) else { return };
    let Some(mut around) = Around::new(x, target, nest.center, outer.radius) else { return };
    let (Some(rx), Some(ry)) = (on_place(around.rx, shells, i), on_place(around.ry, shells, j)) else {
        return;
    };
    (around.rx, around.ry) = (rx, ry);
    let way = Nested { shells, within: nest.within, ry };
    match course {
        Course::Back(k) => {
            if k < shells.len()
                && k >= i.max(j)
                && let Some(legs) = way.back(k)
            {
                around.connect(&legs, 0.0, out);
            }
        }
        Course::Through => {
            if i != j
                && let Some(legs) = way.direct()
            {
                around.connect(&legs, 0.0, out);
            }
            // In the same medium without a surface between there is nothing to bend the path.
            let first = if i == j { i + 1 } else { i.max(j) };
            for depth in first..=shells.len() {
                // What passes by the next surface is at least this far from the centre: b ≥ n R.
                let low = shells.get(depth).map_or(0.0, |s| s.outside * s.radius);
                if let Some(legs) = way.through(depth) {
                    around.connect(&legs, low, out);
                }
            }
        }
    }
}

/// The distance from the centre, if it is within just `within` of the surfaces.
fn on_place(r: f64, shells: &[Shell], within: usize) -> Option<f64> {
    let r = if within > 0 { on_side(r, shells[within - 1].radius, true)? } else { r };
    shells.get(within).map_or(Some(r), |s| on_side(r, s.radius, false))
}

/// The ways through a nest.
struct Nested<'a> {
    shells: &'a [Shell],
    within: [usize; 2],
    ry: f64,
}

impl Nested<'_> {
    /// The index of the medium within this many surfaces.
    fn index(&self, within: usize) -> f64 {
        if within == 0 { self.shells[0].outside } else { self.shells[within - 1].inside }
    }

    /// Inwards across the surfaces from the receiver's down to before `depth`.
    fn go_in(&self, legs: &mut Legs, depth: usize) -> bool {
        (self.within[0]..depth).all(|k| legs.push(self.index(k), self.shells[k].radius, Run::In))
    }

    /// Outwards from `depth`, where the next leg runs as `first` says, to the light.
    fn go_out(&self, legs: &mut Legs, depth: usize, first: Run) -> bool {
        let mut run = first;
        for k in (self.within[1]..depth).rev() {
            if !legs.push(self.index(k + 1), self.shells[k].radius, run) {
                return false;
            }
            run = Run::Out;
        }
        legs.push(self.index(self.within[1]), self.ry, run)
    }

    fn through(&self, depth: usize) -> Option<Legs> {
        let mut legs = Legs::new();
        (self.go_in(&mut legs, depth) && self.go_out(&mut legs, depth, Run::Through)).then_some(legs)
    }

    fn back(&self, k: usize) -> Option<Legs> {
        let mut legs = Legs::new();
        // The leg up to the mirror, which lies in the medium within k surfaces.
        (self.go_in(&mut legs, k)
            && legs.push(self.index(k), self.shells[k].radius, Run::In)
            && self.go_out(&mut legs, k, Run::Out))
        .then_some(legs)
    }

    /// Without a point closest to the centre: inwards all the way, or outwards.
    fn direct(&self) -> Option<Legs> {
        let [i, j] = self.within;
        let mut legs = Legs::new();
        let whole = if i < j {
            self.go_in(&mut legs, j) && legs.push(self.index(j), self.ry, Run::In)
        } else {
            self.go_out(&mut legs, i, Run::Out)
        };
        whole.then_some(legs)
    }
}

#[cfg(test)]
mod tests;
