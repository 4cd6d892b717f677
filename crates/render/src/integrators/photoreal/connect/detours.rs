//! Ways through other faces than those that the straight line crosses. Under water light comes steeply through the surface while the
//! straight line to the lamp leaves by a wall; beside the edge of a thick pane it comes through the pane though the line misses it.
//!
//! Each block is tried as if it were alone: where would the light go in and out? Folded over that place, the line from x to y crosses the
//! faces of such a way. It is no matter if the block is not alone, for the way is then solved as it is, or not met.

use super::super::chain::Chain;
use super::Search;
use super::block::{Block, Side};
use super::crossings::Crossings;
use super::flat::offer;
use super::found::Found;
use vitrine_math::DVec3;
use vitrine_optics::connect::Target;
use vitrine_optics::connect::planes::{self, Stack};

/// So many are tried at most.
const MOST: usize = 8;
/// How far beyond a face the line is folded, as a share of the block's thickness.
const BEYOND: f64 = 1e-3;

/// Adds them all; `straight` are the surfaces that the straight line crosses.
pub fn connect(search: &Search, straight: Option<&Chain>, bent: &mut Crossings, found: &mut Found) {
    let (mut tried, mut count) = ([Chain::default(); MOST], 0);
    for &solid in search.solids.clear() {
        let Some(block) = Block::new(search, solid) else { continue };
        for side in Side::all() {
            let Some(fold) = fold(search, &block, side) else { continue };
            if !bent.via(search.solids, search.ends, fold) {
                continue;
            }
            let Some(steps) = bent.steps() else { continue };
            let chain = steps.chain();
            if chain.is_empty() || straight == Some(&chain) || tried[..count].contains(&chain) {
                continue;
            }
            if count == MOST {
                return;
            }
            tried[count] = chain;
            count += 1;
            offer(search, steps, found);
        }
    }
}

/// Where the line is folded for the way through a face, and through the opposite one if both ends lie outside; None if the straight line
/// goes there, too, or nothing does.
fn fold(search: &Search, block: &Block, side: Side) -> Option<DVec3> {
    let Side { axis, sign } = side;
    let (x, y, half) = (block.x, block.y, block.half[axis]);
    let [hx, hy] = block.heights(side);
    let at = |p: DVec3, q: DVec3, height: f64| p + (q - p) * ((height - p[axis]) / (q[axis] - p[axis]));
    let [of_x, of_y] = [search.ends.media, search.there].map(|media| search.index(media.top(search.solids)));
    let inside = search.index(block.solid);
    let n = DVec3::AXES[axis] * sign;
    let (from_x, from_y) = (block.holds(x) && hy > 0.0, block.holds(y) && hx > 0.0);
    if from_x || from_y {
        if block.covers(at(x, y, sign * half), axis) {
            return None;
        }
        // Seen from the end that is inside.
        let (start, end, outside) = if from_x { (x, y, of_y) } else { (y, x, of_x) };
        let stack = Stack { n, offsets: &[half], indices: &[inside, outside] };
        let way = planes::connect(start, Target::Point(end), &stack)?;
        let p = *way.vertices().first()?;
        return block.covers(p, axis).then(|| block.world(p + n * (BEYOND * half)));
    }
    // From beyond the opposite face.
    if hy <= 0.0 || x[axis] * sign >= -half {
        return None;
    }
    let (enter, leave) = (at(x, y, -sign * half), at(x, y, sign * half));
    if block.covers(enter, axis) && block.covers(leave, axis) {
        return None;
    }
    // Light is bent by no more than the straight line goes sideways in the block.
    let sideways = (leave - enter).abs();
    let is_near = |p: DVec3| (0..3).all(|k| k == axis || p[k].abs() <= block.half[k] + sideways[k]);
    if !is_near(enter) || !is_near(leave) {
        return None;
    }
    let stack = Stack { n, offsets: &[-half, half], indices: &[of_x, inside, of_y] };
    let way = planes::connect(x, Target::Point(y), &stack)?;
    let [first, last] = way.vertices() else { return None };
    let is_met = block.covers(*first, axis) && block.covers(*last, axis);
    is_met.then(|| block.world((*first + *last) * 0.5))
}
