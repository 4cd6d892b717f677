//! The binary tree, by the surface area heuristic over bins.

use super::SAH_LEVELS;
use super::cut::Cut;
use super::item::{Item, Leaves, Span};
use super::sorted;
use std::ops::Range;
use vitrine_math::Vec4;

/// The most bins along an axis. Small runs get fewer.
const BINS: usize = 32;
/// So many items more for each bin.
const ITEMS_PER_BIN: usize = 16;
/// What it costs to visit a node, in tests of full blocks.
const NODE_COST: f32 = 1.0;
/// Runs with fewer items are not worth a thread.
const FORK: usize = 8192;

/// A part of the tree with its box.
#[derive(Debug)]
pub struct Branch {
    pub bounds: Span,
    pub content: Content,
    /// How it is best cut into children of nodes.
    pub cut: Cut,
}

/// What a part of the tree is.
#[derive(Debug)]
pub enum Content {
    /// Items by their places in the order that the builder has brought them into.
    Leaf(Range<usize>),
    Inner(Box<[Branch; 2]>),
}

/// Brings the items into the order of the leaves; gives the tree over them, or None when there is nothing.
pub fn split_all(items: &mut [Item], leaves: Leaves) -> Option<Branch> {
    let mut centers = Span::EMPTY;
    let mut bounds = Span::EMPTY;
    for item in items.iter() {
        bounds.join(&item.span());
        centers.with_point(item.center());
    }
    let kind = items.first()?.kind();
    let is_mixed = items.iter().any(|i| i.kind() != kind);
    Some(Run { items, first: 0, bounds, centers, depth: 0, is_mixed }.branch(leaves))
}

/// A run of items that becomes a part of the tree.
struct Run<'a> {
    items: &'a mut [Item],
    /// The place of the first item among all.
    first: usize,
    bounds: Span,
    /// The box around the items' middles.
    centers: Span,
    depth: usize,
    /// Whether the items are of several kinds.
    is_mixed: bool,
}

impl<'a> Run<'a> {
    fn branch(self, leaves: Leaves) -> Branch {
        let (bounds, count) = (self.bounds, self.items.len());
        let range = self.first..self.first + count;
        match self.split(leaves) {
            None => Branch { bounds, content: Content::Leaf(range), cut: Cut::LEAF },
            Some([left, right]) => {
                let children = if count > FORK {
                    let (left, right) = rayon::join(|| left.branch(leaves), || right.branch(leaves));
                    [left, right]
                } else {
                    [left.branch(leaves), right.branch(leaves)]
                };
                let cut = Cut::new(bounds.half_area(), [&children[0].cut, &children[1].cut]);
                Branch { bounds, content: Content::Inner(Box::new(children)), cut }
            }
        }
    }

    /// Parts the run in two, or gives None when it is a leaf.
    fn split(self, leaves: Leaves) -> Option<[Self; 2]> {
        let kind = self.items[0].kind();
        let may_be_leaf = !self.is_mixed && leaves.fits(kind, self.items.len());
        if self.items.len() == 1 {
            return None;
        }
        if !may_be_leaf && self.items.len() <= sorted::LONGEST && !self.is_mixed && leaves.is_block(kind) {
            let middle = sorted::split(self.items);
            return Some(self.measured_halves(middle));
        }
        let best = if self.depth < SAH_LEVELS { Bins::new(&self, leaves).best_split() } else { None };
        if let Some(best) = best {
            if may_be_leaf {
                let weight = leaves.weight(kind) * self.items.len() as u32;
                let area = self.bounds.half_area();
                if blocks(weight) * area <= NODE_COST * area + best.cost {
                    return None;
                }
            }
            let (middle, centers) = partition(self.items, |c| best.is_first(c));
            return Some(self.halves(middle, [best.left, best.right], centers));
        }
        if may_be_leaf {
            return None;
        }
        if self.is_mixed {
            self.items.sort_unstable_by_key(|i| (i.kind(), i.index()));
            let middle = self.items.partition_point(|i| i.kind() == self.items[0].kind());
            return Some(self.measured_halves(middle));
        }
        // All in one place, or the numbers leave the range of the heuristic: halve, so that the tree stays shallow.
        let size = self.centers.high - self.centers.low;
        let axis = if size.x >= size.y && size.x >= size.z { 0 } else { 2 - usize::from(size.y >= size.z) };
        let middle = self.items.len() / 2;
        self.items.select_nth_unstable_by(middle, |a, b| {
            a.center()[axis].total_cmp(&b.center()[axis]).then(a.index().cmp(&b.index()))
        });
        Some(self.measured_halves(middle))
    }

    fn measured_halves(self, middle: usize) -> [Self; 2] {
        let measure = |items: &[Item]| {
            items.iter().fold((Span::EMPTY, Span::EMPTY), |(mut bounds, mut centers), item| {
                bounds.join(&item.span());
                centers.with_point(item.center());
                (bounds, centers)
            })
        };
        let (left, right) = (measure(&self.items[..middle]), measure(&self.items[middle..]));
        self.halves(middle, [left.0, right.0], [left.1, right.1])
    }

    fn halves(self, middle: usize, bounds: [Span; 2], centers: [Span; 2]) -> [Self; 2] {
        let (left, right) = self.items.split_at_mut(middle);
        let half = |items: &'a mut [Item], first, bounds, centers| {
            let is_mixed = self.is_mixed && items.iter().any(|i| i.kind() != items[0].kind());
            Self { items, first, bounds, centers, depth: self.depth + 1, is_mixed }
        };
        [
            half(left, self.first, bounds[0], centers[0]),
            half(right, self.first + middle, bounds[1], centers[1]),
        ]
    }
}

/// How many blocks of eight a weight fills.
#[inline(always)]
fn blocks(weight: u32) -> f32 {
    weight.div_ceil(8) as f32
}

/// A split between two bins.
struct Split {
    places: Places,
    axis: usize,
    /// The first bin of the second part.
    bin: u32,
    /// Σ blocks · half area of the two parts.
    cost: f32,
    left: Span,
    right: Span,
}

impl Split {
    #[inline(always)]
    fn is_first(&self, center: Vec4) -> bool {
        self.places.bin(center, self.axis) < self.bin
    }
}

/// From middles to bins.
#[derive(Clone, Copy)]
struct Places {
    low: Vec4,
    scale: Vec4,
}

impl Places {
    fn new(centers: &Span, bins: usize) -> Self {
        let size = centers.high - centers.low;
        let last = (bins - 1) as f32;
        let scale = |s: f32| if s > 0.0 && s.is_finite() && (last / s).is_finite() { last / s } else { 0.0 };
        Self { low: centers.low, scale: Vec4::new(scale(size.x), scale(size.y), scale(size.z), 0.0) }
    }

    /// The bins on all axes: numbers from 0 to the last are rounded to whole ones by adding a number whose last digit is 1.
    #[inline(always)]
    fn bins(&self, center: Vec4) -> [usize; 3] {
        let place = (center - self.low) * self.scale + Vec4::splat(8_388_608.0);
        [place.x, place.y, place.z].map(|v| v.to_bits() as usize % BINS)
    }

    #[inline(always)]
    fn bin(&self, center: Vec4, axis: usize) -> u32 {
        let place = (center - self.low) * self.scale + Vec4::splat(8_388_608.0);
        place[axis].to_bits() % BINS as u32
    }
}

/// The items of a run, sorted into bins on each axis.
struct Bins {
    places: Places,
    count: usize,
    spans: [[Span; BINS]; 3],
    weights: [[u32; BINS]; 3],
}

impl Bins {
    fn new(run: &Run, leaves: Leaves) -> Self {
        let count = (4 + run.items.len() / ITEMS_PER_BIN).min(BINS);
        let places = Places::new(&run.centers, count);
        let mut bins = Self { places, count, spans: [[Span::EMPTY; BINS]; 3], weights: [[0; BINS]; 3] };
        for item in run.items.iter() {
            let (span, weight) = (item.span(), leaves.weight(item.kind()));
            let at = places.bins(item.center());
            for (axis, bin) in at.into_iter().enumerate() {
                bins.spans[axis][bin].join(&span);
                bins.weights[axis][bin] += weight;
            }
        }
        bins
    }

    /// The cheapest of all splits between bins, or None when every item falls into one bin.
    fn best_split(&self) -> Option<Split> {
        let mut best: Option<(f32, usize, usize)> = None;
        for axis in 0..3 {
            if self.places.scale[axis] == 0.0 {
                continue;
            }
            let (spans, weights) = (&self.spans[axis], &self.weights[axis]);
            let mut above = [0.0_f32; BINS];
            let (mut span, mut weight) = (Span::EMPTY, 0);
            for bin in (1..self.count).rev() {
                span.join(&spans[bin]);
                weight += weights[bin];
                above[bin] = if weight == 0 { f32::INFINITY } else { span.half_area() * blocks(weight) };
            }
            let (mut span, mut weight) = (Span::EMPTY, 0);
            for bin in 1..self.count {
                span.join(&spans[bin - 1]);
                weight += weights[bin - 1];
                if weight == 0 {
                    continue;
                }
                let cost = span.half_area() * blocks(weight) + above[bin];
                if cost.is_finite() && best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, bin));
                }
            }
        }
        best.map(|(cost, axis, bin)| {
            let join = |range: Range<usize>| {
                self.spans[axis][range].iter().fold(Span::EMPTY, |mut all, span| {
                    all.join(span);
                    all
                })
            };
            let (left, right) = (join(0..bin), join(bin..self.count));
            Split { places: self.places, axis, bin: bin as u32, cost, left, right }
        })
    }
}

/// Moves the items whose middles belong to the first part to the front; gives their number and the boxes around the middles
/// of both parts. Without branches: which part an item belongs to cannot be foretold.
#[inline(always)]
fn partition(items: &mut [Item], is_first: impl Fn(Vec4) -> bool) -> (usize, [Span; 2]) {
    let mut middle = 0;
    let mut centers = [Span::EMPTY; 2];
    for i in 0..items.len() {
        let center = items[i].center();
        let first = is_first(center);
        centers[usize::from(!first)].with_point(center);
        items.swap(i, middle);
        middle += usize::from(first);
    }
    (middle, centers)
}
