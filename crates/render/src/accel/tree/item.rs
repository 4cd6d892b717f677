//! What trees are built over.

use vitrine_math::{Bounds3, Vec4};

/// Something to be put into a tree: its box, which one of its kind it is, and the kind.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// The box's lower corner; the bits of the last component are the index.
    low: Vec4,
    /// The box's upper corner; the bits of the last component are the kind.
    high: Vec4,
}

impl Item {
    /// An item with its box, which must be finite and not empty.
    #[must_use]
    pub fn new(bounds: &Bounds3, index: u32, kind: u8) -> Self {
        Self {
            low: bounds.min.extend(f32::from_bits(index)),
            high: bounds.max.extend(f32::from_bits(u32::from(kind))),
        }
    }

    /// Which primitive of its kind.
    #[inline(always)]
    #[must_use]
    pub fn index(&self) -> u32 {
        self.low.w.to_bits()
    }

    /// The kind of primitive. A leaf holds one kind alone.
    #[inline(always)]
    #[must_use]
    pub fn kind(&self) -> u8 {
        self.high.w.to_bits() as u8
    }

    /// Its box.
    #[inline(always)]
    pub(super) fn span(&self) -> Span {
        Span { low: self.low, high: self.high }
    }

    /// The box's middle; halved first, so that large numbers stay numbers.
    #[inline(always)]
    pub(super) fn center(&self) -> Vec4 {
        // The last components hold integers, whose bits are slow to compute with on some processors.
        self.low.with_w(0.0) * 0.5 + self.high.with_w(0.0) * 0.5
    }
}

/// A box in vector registers. The last components mean nothing.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    pub low: Vec4,
    pub high: Vec4,
}

impl Span {
    pub const EMPTY: Self = Self { low: Vec4::INFINITY, high: Vec4::NEG_INFINITY };

    #[inline(always)]
    pub fn join(&mut self, other: &Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
    }

    #[inline(always)]
    pub fn with_point(&mut self, p: Vec4) {
        self.low = self.low.min(p);
        self.high = self.high.max(p);
    }

    /// Half of the surface's area, the measure of the surface area heuristic; not for empty boxes.
    #[inline(always)]
    pub fn half_area(&self) -> f32 {
        let e = self.high - self.low;
        e.x * e.y + e.y * e.z + e.z * e.x
    }
}

/// How many items of each kind a leaf may hold, and what they cost.
#[derive(Clone, Copy, Debug)]
pub struct Leaves {
    /// The most items of a kind in a leaf, 1 to 8.
    pub most: [u8; Leaves::KINDS],
}

impl Leaves {
    /// How many kinds there may be.
    pub const KINDS: usize = 8;

    /// What it costs to test an item, in eighths of the test of a full block.
    #[inline(always)]
    pub(super) fn weight(&self, kind: u8) -> u32 {
        8 / u32::from(self.most[usize::from(kind) % Self::KINDS].max(1))
    }

    /// Whether items of a kind stand in blocks, which cost the same full or not.
    #[inline(always)]
    pub(super) fn is_block(&self, kind: u8) -> bool {
        self.most[usize::from(kind) % Self::KINDS] == 8
    }

    /// Whether so many items of a kind may be a leaf.
    #[inline(always)]
    pub(super) fn fits(&self, kind: u8, count: usize) -> bool {
        count <= usize::from(self.most[usize::from(kind) % Self::KINDS].max(1))
    }
}
