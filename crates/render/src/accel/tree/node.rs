//! A node: eight boxes side by side, so that one ray is tested against all of them at once.

use super::item::Span;
use vitrine_math::{Bounds3, Vec3};

/// Boxes in a node.
pub const WIDTH: usize = 8;

/// Eight children with their boxes; 256 bytes.
///
/// Rows 0 to 5 are the boxes' bounds: lower x, upper x, lower y, upper y, lower z, upper z. Rows 6 and 7 hold integers, as
/// the bits of floats: what each child is. Places without a child have a box that no ray meets, and are leaves of nothing: a ray
/// whose numbers leave the range of floats may enter any box, and must still come to an end.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Node {
    pub(in crate::accel) rows: [[f32; WIDTH]; 8],
}

/// What a child is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Child {
    /// Another node's index, or the number that the leaf was given.
    pub first: u32,
    /// A leaf: how many primitives (0 in a place without a child), with the kind in the upper byte. Another node: 0.
    pub tag: u32,
}

const FIRST: usize = 6;
const TAG: usize = 7;
const COUNT_BITS: u32 = 24;

impl Child {
    /// What stands where there is no child: a leaf of nothing, whatever its kind.
    pub(super) const NONE: Self = Self::leaf(0, 0, u8::MAX);

    /// Another node.
    pub(super) const fn node(index: u32) -> Self {
        Self { first: index, tag: 0 }
    }

    /// A leaf of so many primitives of a kind.
    pub(super) const fn leaf(first: u32, count: u32, kind: u8) -> Self {
        Self { first, tag: count | (kind as u32) << COUNT_BITS }
    }

    /// Whether it is a leaf.
    #[inline(always)]
    #[must_use]
    pub const fn is_leaf(self) -> bool {
        self.tag != 0
    }

    /// How many primitives a leaf holds.
    #[inline(always)]
    #[must_use]
    pub const fn count(self) -> u32 {
        self.tag & ((1 << COUNT_BITS) - 1)
    }

    /// A leaf's kind of primitive.
    #[inline(always)]
    #[must_use]
    pub const fn kind(self) -> u8 {
        (self.tag >> COUNT_BITS) as u8
    }
}

impl Node {
    /// A node without children.
    pub(in crate::accel) const EMPTY: Self = {
        let (low, high) = ([f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]);
        let (first, tag) = (f32::from_bits(Child::NONE.first), f32::from_bits(Child::NONE.tag));
        Self { rows: [low, high, low, high, low, high, [first; WIDTH], [tag; WIDTH]] }
    };

    /// Puts a child into a place.
    pub(super) fn put(&mut self, place: usize, bounds: &Span, child: Child) {
        for axis in 0..3 {
            self.rows[2 * axis][place] = bounds.low[axis];
            self.rows[2 * axis + 1][place] = bounds.high[axis];
        }
        self.rows[FIRST][place] = f32::from_bits(child.first);
        self.rows[TAG][place] = f32::from_bits(child.tag);
    }

    /// What a child is.
    #[inline(always)]
    #[must_use]
    pub fn child(&self, place: usize) -> Child {
        Child {
            first: self.rows[FIRST][place % WIDTH].to_bits(),
            tag: self.rows[TAG][place % WIDTH].to_bits(),
        }
    }

    /// Whether a place is as it is without a child.
    pub(super) fn is_vacant(&self, place: usize) -> bool {
        self.bounds(place) == Bounds3::EMPTY && self.child(place) == Child::NONE
    }

    /// A child's box; empty where there is none.
    #[must_use]
    pub fn bounds(&self, place: usize) -> Bounds3 {
        let corner =
            |upper: usize| Vec3::from_array([0, 1, 2].map(|k| self.rows[2 * k + upper][place % WIDTH]));
        Bounds3 { min: corner(0), max: corner(1) }
    }
}
