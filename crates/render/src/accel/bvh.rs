//! Bounding volume hierarchies: flat nodes over typed leaves, built by the binned surface area heuristic.
//!
//! Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007. One tree stands over a whole scene and one
//! over each mesh; both use these nodes.

use vitrine_math::{Bounds3, Vec3};

/// The deepest stack that a traversal needs: `MAX_DEPTH` levels of surface area splits and then halvings, which end
/// after 32 levels for any number of items that fits 32 bits, with room for leaves split by kind.
pub const STACK: usize = MAX_DEPTH + 32 + 8;
const MAX_DEPTH: usize = 56;
const BINS: usize = 16;

/// A node: its box, and either two children side by side or a run of primitives of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// The box's corner with the smallest coordinates.
    pub min: [f32; 3],
    /// Inner node: the index of the first child, the second follows. Leaf: the first primitive among those of its kind.
    pub first: u32,
    /// The box's corner with the largest coordinates.
    pub max: [f32; 3],
    /// Leaf: how many primitives (not 0), with the kind in the upper byte. Inner node: 0 with the split axis there.
    tag: u32,
}

const COUNT_BITS: u32 = 24;

impl Node {
    fn inner(bounds: &Bounds3, first: u32, axis: u8) -> Self {
        Self { min: bounds.min.into(), first, max: bounds.max.into(), tag: u32::from(axis) << COUNT_BITS }
    }

    fn leaf(bounds: &Bounds3, first: u32, count: u32, kind: u8) -> Self {
        let tag = count | u32::from(kind) << COUNT_BITS;
        Self { min: bounds.min.into(), first, max: bounds.max.into(), tag }
    }

    /// How many primitives a leaf holds; 0 for an inner node.
    #[inline(always)]
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.tag & ((1 << COUNT_BITS) - 1)
    }

    /// A leaf's kind of primitive; an inner node's split axis, 0 to 2, its first child on the lower side.
    #[inline(always)]
    #[must_use]
    pub const fn kind_or_axis(&self) -> u8 {
        (self.tag >> COUNT_BITS) as u8
    }

    /// The box.
    #[must_use]
    pub fn bounds(&self) -> Bounds3 {
        Bounds3 { min: self.min.into(), max: self.max.into() }
    }
}

/// Something to be put into a tree.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// Its box: finite and not empty.
    pub bounds: Bounds3,
    /// Which primitive of its kind.
    pub index: u32,
    /// The kind of primitive. A leaf holds one kind alone.
    pub kind: u8,
}

/// A finished tree.
#[derive(Debug, Default)]
pub struct Bvh {
    /// The nodes, the root first; none for an empty tree.
    pub nodes: Vec<Node>,
}

/// Builds the tree. Gives back the items in the order of the leaves: the primitives of each kind must be stored in the order
/// in which that kind's items stand there.
#[must_use]
pub fn build(mut items: Vec<Item>) -> (Bvh, Vec<Item>) {
    let mut nodes = Vec::new();
    if items.is_empty() {
        return (Bvh { nodes }, items);
    }
    nodes.reserve(items.len());
    nodes.push(Node::leaf(&Bounds3::EMPTY, 0, 0, 0));
    let mut todo = vec![(0_usize, 0..items.len(), 0_usize)];
    while let Some((node, range, depth)) = todo.pop() {
        let run = &mut items[range.clone()];
        let bounds = run.iter().fold(Bounds3::EMPTY, |b, i| b.union(i.bounds));
        let Some((middle, axis)) = split(run, &bounds, depth) else {
            nodes[node] = Node::leaf(&bounds, range.start as u32, run.len() as u32, run[0].kind);
            continue;
        };
        let first = nodes.len();
        nodes[node] = Node::inner(&bounds, first as u32, axis);
        nodes.extend([Node::leaf(&Bounds3::EMPTY, 0, 0, 0); 2]);
        todo.push((first + 1, range.start + middle..range.end, depth + 1));
        todo.push((first, range.start..range.start + middle, depth + 1));
    }
    number_by_kind(&mut nodes, &items);
    nodes.shrink_to_fit();
    (Bvh { nodes }, items)
}

/// Turns leaves' places among all items into places among the items of their kind.
fn number_by_kind(nodes: &mut [Node], items: &[Item]) {
    let mut counts = [0_u32; 256];
    let places: Vec<u32> = items
        .iter()
        .map(|item| {
            let count = &mut counts[usize::from(item.kind)];
            *count += 1;
            *count - 1
        })
        .collect();
    for node in nodes.iter_mut().filter(|n| n.count() > 0) {
        node.first = places[node.first as usize];
    }
}

/// The most primitives in a leaf.
const MAX_LEAF: usize = 4;
/// What it costs to visit a node, in tests of primitives.
const NODE_COST: f32 = 1.0;

/// Parts the items in two. Gives where the second part begins and the axis, or None for a leaf.
fn split(items: &mut [Item], bounds: &Bounds3, depth: usize) -> Option<(usize, u8)> {
    let kind = items[0].kind;
    let is_mixed = items.iter().any(|i| i.kind != kind);
    if items.len() == 1 {
        return None;
    }
    let centers = items.iter().fold(Bounds3::EMPTY, |b, i| b.with_point(i.bounds.center()));
    let best = if depth < MAX_DEPTH { best_split(items, &centers) } else { None };
    if let Some(best) = best {
        let leaf_cost = items.len() as f32 * bounds.half_area();
        let split_cost = NODE_COST * bounds.half_area() + best.cost;
        if !is_mixed && items.len() <= MAX_LEAF && leaf_cost <= split_cost {
            return None;
        }
        let middle = partition(items, |i| bin_of(i, &centers, best.axis) < best.bin);
        return Some((middle, best.axis as u8));
    }
    if is_mixed {
        let middle = partition(items, |i| i.kind == kind);
        return Some((middle, 0));
    }
    if items.len() <= MAX_LEAF {
        return None;
    }
    // All in one place, or the numbers leave the range of the heuristic: halve, so that the tree stays shallow.
    let axis = longest_axis(centers.size());
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        let key = |i: &Item| (i.bounds.center()[axis], i.index);
        let ((a, i), (b, j)) = (key(a), key(b));
        a.total_cmp(&b).then(i.cmp(&j))
    });
    Some((middle, axis as u8))
}

struct Split {
    axis: usize,
    /// The first bin of the second part.
    bin: usize,
    /// Σ count · half area of the two parts.
    cost: f32,
}

fn longest_axis(size: Vec3) -> usize {
    if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    }
}

fn bin_of(item: &Item, centers: &Bounds3, axis: usize) -> usize {
    let (from, to) = (centers.min[axis], centers.max[axis]);
    let place = (item.bounds.center()[axis] - from) / (to - from) * BINS as f32;
    // A cast of a float to an integer saturates and maps NaN to 0.
    (place as usize).min(BINS - 1)
}

/// The cheapest of all splits between bins, or None when every item falls into one bin.
fn best_split(items: &[Item], centers: &Bounds3) -> Option<Split> {
    let mut best: Option<Split> = None;
    for axis in 0..3 {
        let extent = centers.max[axis] - centers.min[axis];
        if !(extent > 0.0 && extent.is_finite()) {
            continue;
        }
        let mut bins = [(Bounds3::EMPTY, 0_u32); BINS];
        for item in items {
            let bin = &mut bins[bin_of(item, centers, axis)];
            *bin = (bin.0.union(item.bounds), bin.1 + 1);
        }
        let mut above = [(0.0_f32, 0_u32); BINS];
        let (mut bounds, mut count) = (Bounds3::EMPTY, 0);
        for bin in (1..BINS).rev() {
            bounds = bounds.union(bins[bin].0);
            count += bins[bin].1;
            above[bin] = (bounds.half_area(), count);
        }
        let (mut bounds, mut count) = (Bounds3::EMPTY, 0);
        for bin in 1..BINS {
            bounds = bounds.union(bins[bin - 1].0);
            count += bins[bin - 1].1;
            let (area, rest) = above[bin];
            if count == 0 || rest == 0 {
                continue;
            }
            let cost = count as f32 * bounds.half_area() + rest as f32 * area;
            if cost.is_finite() && best.as_ref().is_none_or(|b| cost < b.cost) {
                best = Some(Split { axis, bin, cost });
            }
        }
    }
    best
}

/// Moves the items that belong to the first part to the front; gives their number.
fn partition(items: &mut [Item], is_first: impl Fn(&Item) -> bool) -> usize {
    let mut middle = 0;
    for i in 0..items.len() {
        if is_first(&items[i]) {
            items.swap(i, middle);
            middle += 1;
        }
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine_math::hash;

    /// Every item stands in exactly one leaf of its kind, inside all boxes above it; the stack suffices.
    fn validate(bvh: &Bvh, ordered: &[Item], given: usize) {
        assert_eq!(ordered.len(), given);
        let mut seen = vec![0_u32; given];
        let by_kind = |kind: u8| ordered.iter().filter(move |i| i.kind == kind).collect::<Vec<_>>();
        let kinds: Vec<_> = (0..4).map(by_kind).collect();
        let mut stack = if given > 0 { vec![(0_usize, 1_usize)] } else { Vec::new() };
        while let Some((index, depth)) = stack.pop() {
            assert!(depth < STACK, "depth {depth}");
            let node = bvh.nodes[index];
            let (from, count) = (node.first as usize, node.count() as usize);
            if count == 0 {
                for child in [from, from + 1] {
                    let b = bvh.nodes[child].bounds();
                    assert!(node.bounds().contains(b.min) && node.bounds().contains(b.max));
                    stack.push((child, depth + 1));
                }
            } else {
                for item in &kinds[usize::from(node.kind_or_axis())][from..from + count] {
                    assert!(
                        node.bounds().contains(item.bounds.min) && node.bounds().contains(item.bounds.max)
                    );
                    seen[item.index as usize] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&n| n == 1), "each item once");
    }

    fn random_items(n: u32, spread: f32, size: f32) -> Vec<Item> {
        let number = |i| hash::unit(hash::mix(i)) - 0.5;
        (0..n)
            .map(|i| {
                let p = Vec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2)) * spread;
                let bounds = Bounds3 { min: p, max: p + Vec3::splat(size) };
                Item { bounds, index: i, kind: (i % 3) as u8 }
            })
            .collect()
    }

    #[test]
    fn holds_every_item_of_any_scene() {
        for items in [
            vec![],
            random_items(1, 1.0, 0.1),
            random_items(2, 1.0, 0.0),
            random_items(5000, 10.0, 0.2),
            random_items(3000, 0.0, 1.0),
            random_items(1000, 1e30, 1e28),
            random_items(1000, 1e-30, 1e-32),
            random_items(1000, f32::MAX, 0.0),
        ] {
            let given = items.len();
            let (bvh, ordered) = build(items);
            validate(&bvh, &ordered, given);
        }
    }

    #[test]
    fn a_hundred_thousand_identical_items_make_a_shallow_tree() {
        let items: Vec<_> = random_items(1, 1.0, 1.0)
            .into_iter()
            .cycle()
            .take(100_000)
            .enumerate()
            .map(|(i, item)| Item { index: i as u32, kind: 0, ..item })
            .collect();
        let (bvh, ordered) = build(items);
        validate(&bvh, &ordered, 100_000);
    }

    #[test]
    fn exponentially_spaced_items_stay_within_the_stack() {
        // Each split by area takes off few items: the worst case for depth.
        let items: Vec<_> = (0..240_u32)
            .map(|i| {
                let x = 2.0_f32.powi(i as i32 / 2 - 60);
                let bounds = Bounds3 { min: Vec3::splat(x), max: Vec3::splat(x * 1.01) };
                Item { bounds, index: i, kind: 0 }
            })
            .collect();
        let (bvh, ordered) = build(items);
        validate(&bvh, &ordered, 240);
    }
}
