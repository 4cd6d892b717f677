//! A tree over many lights, to choose one in proportion to about what it brings to a point, in steps that grow with the depth of the
//! tree only (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018).
//!
//! What a group of lights brings is told well from afar only. So groups near the point are split first, up to a fixed number; among
//! those that this cut through the tree leaves, one is chosen, and from there on down one child of each node (the cut is that of
//! Walter et al., "Lightcuts", 2005, made from the root down).

use super::bound::Bound;
use vitrine_math::{Bounds3, Vec3};

/// Between how many places a node is cut.
const BINS: usize = 12;
/// Below this depth nodes are cut in the middle, so that no tree gets deeper than about 70.
const DEEP: u32 = 40;
/// No more groups than these are compared at once.
const CUT: usize = 48;
/// A group is split where the point is no farther from it than this many of its radii.
const NEAR: f32 = 3.0;
/// No node.
const NONE: u32 = u32::MAX;

/// Nodes over lights; the first is the root.
#[derive(Clone, Debug)]
pub struct LightTree {
    nodes: Vec<Node>,
    /// The leaf of each light; [`NONE`] of lights without power.
    leaves: Vec<u32>,
}

/// Groups of lights that hold each light once, for one point.
#[derive(Clone, Debug)]
pub struct Cut {
    nodes: [u32; CUT],
    /// About what each group brings.
    weights: [f32; CUT],
    count: usize,
    /// About what all of them bring: an irradiance.
    pub sum: f32,
}

#[derive(Clone, Debug)]
struct Node {
    bound: Bound,
    parent: u32,
    /// Of a node with children, the second one (the first comes right after the node); 0 of a leaf.
    second: u32,
    /// Of a leaf.
    light: u32,
}

impl LightTree {
    /// Over lights, by what is known of them.
    pub fn new(bounds: &[Bound]) -> Self {
        let mut lights: Vec<u32> =
            (0..bounds.len() as u32).filter(|&light| bounds[light as usize].power > 0.0).collect();
        let mut tree = Self { nodes: Vec::with_capacity(2 * lights.len()), leaves: vec![NONE; bounds.len()] };
        if !lights.is_empty() {
            tree.build(bounds, &mut lights, [NONE, 0]);
        }
        tree
    }

    /// The groups that are compared for `p`.
    #[inline]
    pub fn cut(&self, p: Vec3, n: Option<Vec3>) -> Cut {
        let mut cut = Cut { nodes: [0; CUT], weights: [0.0; CUT], count: 0, sum: 0.0 };
        // Groups wait in a ring, so that splitting goes level by level.
        let mut waiting = [0_u32; CUT];
        let (mut first, mut count) = (0, usize::from(!self.nodes.is_empty()));
        while count > 0 {
            let at = waiting[first];
            let node = &self.nodes[at as usize];
            (first, count) = ((first + 1) % CUT, count - 1);
            if node.second != 0 && cut.count + count + 2 <= CUT && node.bound.is_near(p, NEAR) {
                waiting[(first + count) % CUT] = at + 1;
                waiting[(first + count + 1) % CUT] = node.second;
                count += 2;
            } else {
                let weight = node.bound.importance(p, n);
                (cut.nodes[cut.count], cut.weights[cut.count]) = (at, weight);
                cut.count += 1;
                cut.sum += weight;
            }
        }
        cut
    }

    /// Chooses a light by a number in [0, 1), below the cut for `p`; gives the probability of that. None where a part of the tree was
    /// chosen of which nothing arrives.
    pub fn choose(&self, cut: &Cut, p: Vec3, n: Option<Vec3>, u: f64) -> Option<(u32, f32)> {
        // f64: each step takes digits of the number away.
        let mut rest = u * f64::from(cut.sum);
        let mut found = None;
        for (&at, weight) in
            cut.nodes[..cut.count].iter().zip(cut.weights).filter(|(_, weight)| *weight > 0.0)
        {
            found = Some((at as usize, weight));
            if rest < f64::from(weight) {
                break;
            }
            rest -= f64::from(weight);
        }
        let (mut at, weight) = found?;
        let mut probability = weight / cut.sum;
        let mut u = (rest / f64::from(weight)).min(1.0 - f64::EPSILON);
        loop {
            let node = &self.nodes[at];
            if node.second == 0 {
                return Some((node.light, probability));
            }
            let first = self.share_of_first(at, p, n)?;
            if u < f64::from(first) {
                u /= f64::from(first);
                probability *= first;
                at += 1;
            } else {
                u = (u - f64::from(first)) / (1.0 - f64::from(first));
                probability *= 1.0 - first;
                at = node.second as usize;
            }
            u = u.min(1.0 - f64::EPSILON);
        }
    }

    /// The probability with which [`Self::choose`] gives this light.
    pub fn probability(&self, cut: &Cut, light: u32, p: Vec3, n: Option<Vec3>) -> f32 {
        let leaf = self.leaves.get(light as usize).copied().unwrap_or(NONE);
        // A node comes right before all that is below it: the group of a leaf is the last one that does not come after it.
        let groups = cut.nodes[..cut.count].iter().zip(cut.weights);
        let group = groups.filter(|(at, _)| **at <= leaf).max_by_key(|(at, _)| **at);
        let Some((&top, weight)) = group.filter(|_| leaf != NONE) else { return 0.0 };
        if weight <= 0.0 {
            return 0.0;
        }
        let (mut at, mut probability) = (leaf, weight / cut.sum);
        while at != top {
            let parent = self.nodes[at as usize].parent;
            let Some(first) = self.share_of_first(parent as usize, p, n) else { return 0.0 };
            probability *= if at == parent + 1 { first } else { 1.0 - first };
            at = parent;
        }
        probability
    }

    /// The probability of the first child; None where nothing arrives from either.
    #[inline]
    fn share_of_first(&self, at: usize, p: Vec3, n: Option<Vec3>) -> Option<f32> {
        let second = self.nodes[at].second as usize;
        let [a, b] = [at + 1, second].map(|child| self.nodes[child].bound.importance(p, n));
        (a + b > 0.0).then(|| a / (a + b))
    }

    /// Adds the node over these lights below `[parent, depth]`.
    fn build(&mut self, bounds: &[Bound], lights: &mut [u32], [parent, depth]: [u32; 2]) {
        let at = self.nodes.len();
        let bound_of = |light: &u32| bounds[*light as usize];
        if let [light] = lights {
            self.leaves[*light as usize] = at as u32;
            self.nodes.push(Node { bound: bound_of(light), parent, second: 0, light: *light });
            return;
        }
        let middle = cut(bounds, lights, depth);
        let (first, second) = lights.split_at_mut(middle);
        // Its own bound is known once its children's are.
        self.nodes.push(Node { bound: bound_of(&first[0]), parent, second: 0, light: NONE });
        self.build(bounds, first, [at as u32, depth + 1]);
        let place = self.nodes.len();
        self.build(bounds, second, [at as u32, depth + 1]);
        self.nodes[at].second = place as u32;
        self.nodes[at].bound = self.nodes[at + 1].bound.union(&self.nodes[place].bound);
    }
}

/// Sorts lights into two parts, neither empty; gives the size of the first.
fn cut(bounds: &[Bound], lights: &mut [u32], depth: u32) -> usize {
    let center = |light: u32| bounds[light as usize].center();
    let centers = Bounds3::around(lights.iter().map(|&light| center(light)));
    let size = centers.size();
    let place = if depth < DEEP { best_place(bounds, lights, &centers) } else { None };
    if let Some((axis, last)) = place {
        let is_first = |light: u32| bin_of(center(light), &centers, axis) <= last;
        // Stable, so that the tree is the same on every machine.
        lights.sort_by_key(|&light| !is_first(light));
        let first = lights.iter().take_while(|&&light| is_first(light)).count();
        if 0 < first && first < lights.len() {
            return first;
        }
    }
    let axis = if size.x >= size.y.max(size.z) { 0 } else { 1 + usize::from(size.z > size.y) };
    lights.sort_by(|&a, &b| center(a)[axis].total_cmp(&center(b)[axis]));
    lights.len() / 2
}

/// The bin of a centre along an axis.
fn bin_of(center: Vec3, centers: &Bounds3, axis: usize) -> usize {
    let share = (center[axis] - centers.min[axis]) / (centers.max[axis] - centers.min[axis]);
    ((share * BINS as f32) as usize).min(BINS - 1)
}

/// The axis and the last bin of the first part where the choice among lights costs least: the surface area orientation heuristic.
fn best_place(bounds: &[Bound], lights: &[u32], centers: &Bounds3) -> Option<(usize, usize)> {
    let size = centers.size();
    let mut best: Option<(f32, usize, usize)> = None;
    for axis in (0..3).filter(|&axis| size[axis] > 0.0) {
        let mut bins: [Option<Bound>; BINS] = [None; BINS];
        for &light in lights {
            let bound = &bounds[light as usize];
            let bin = &mut bins[bin_of(bound.center(), centers, axis)];
            *bin = Some(bin.map_or(*bound, |held| held.union(bound)));
        }
        let join = |a: Option<Bound>, b: Option<Bound>| match (a, b) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (one, other) => one.or(other),
        };
        // What lies from each bin on to the end.
        let mut rest = [None; BINS];
        for i in (0..BINS).rev() {
            rest[i] = join(bins[i], rest.get(i + 1).copied().flatten());
        }
        // Thin nodes are dear: they are cut across.
        let stretch = size.max_element() / size[axis];
        let mut first = None;
        for last in 0..BINS - 1 {
            first = join(first, bins[last]);
            if let (Some(a), Some(b)) = (first, rest[last + 1]) {
                let cost = stretch * (a.cost() + b.cost());
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, last));
                }
            }
        }
    }
    best.map(|(_, axis, last)| (axis, last))
}
