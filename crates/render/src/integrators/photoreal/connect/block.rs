//! A box between the two ends of connections, seen in its own space.

use super::Search;
use super::crossings::unit;
use crate::compile::Piece;
use vitrine_math::DVec3;

/// A block with the ends in its own space, where its middle is the origin.
pub struct Block {
    /// Its number.
    pub solid: u16,
    /// The middle, metres.
    pub center: DVec3,
    /// The unit normals of its faces.
    pub axes: [DVec3; 3],
    /// Half of each edge, metres.
    pub half: [f64; 3],
    /// Where the light arrives.
    pub x: DVec3,
    /// Where it comes from.
    pub y: DVec3,
}

/// One of its faces.
#[derive(Clone, Copy)]
pub struct Side {
    /// The axis across which it lies.
    pub axis: usize,
    /// On which end of it: 1 or −1.
    pub sign: f64,
}

impl Side {
    /// All six.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..3).flat_map(|axis| [-1.0, 1.0].map(|sign| Self { axis, sign }))
    }
}

impl Block {
    /// None if the solid is no block.
    pub fn new(search: &Search, solid: u16) -> Option<Self> {
        let Some(Piece::Block { center, axes, half }) = search.solids.get(solid).piece else { return None };
        let (center, axes) = (center.as_dvec3(), axes.map(unit));
        let local = |p: DVec3| DVec3::from_array(axes.map(|axis| axis.dot(p - center)));
        let (x, y) = (local(search.ends.x), local(search.ends.y));
        Some(Self { solid, center, axes, half: half.map(f64::from), x, y })
    }

    /// A point of its own space in world space.
    pub fn world(&self, p: DVec3) -> DVec3 {
        self.center + self.axes[0] * p.x + self.axes[1] * p.y + self.axes[2] * p.z
    }

    /// How far beyond a face the two ends are.
    pub fn heights(&self, side: Side) -> [f64; 2] {
        let Side { axis, sign } = side;
        [self.x, self.y].map(|p| p[axis] * sign - self.half[axis])
    }

    /// Whether a point is on the block, seen along an axis.
    pub fn covers(&self, p: DVec3, axis: usize) -> bool {
        (0..3).filter(|k| *k != axis).all(|k| p[k].abs() <= self.half[k])
    }

    /// Whether a point is in the block.
    pub fn holds(&self, p: DVec3) -> bool {
        (0..3).all(|k| p[k].abs() < self.half[k])
    }
}
