//! What has been found: connections of any length, one behind the other in one list.

use super::Step;
use vitrine_math::DVec3;

/// A surface on the way from x to y, with the place where the way meets it.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// The surface.
    pub step: Step,
    /// A unit normal there, to either side.
    pub n: DVec3,
    /// The place.
    pub p: DVec3,
}

/// How a way leaves its ends.
#[derive(Clone, Copy, Debug)]
pub struct Leaving {
    /// The unit direction at x.
    pub wx: DVec3,
    /// The unit direction at y, back along the way.
    pub wy: DVec3,
    /// dω_x/dA⊥: the solid angle at x for each square metre across the way at y.
    pub spread: f64,
}

/// One way from x to y.
#[derive(Clone, Copy, Debug)]
pub struct Connection<'a> {
    /// The surfaces, from x on.
    pub nodes: &'a [Node],
    /// Its ends.
    pub ends: Leaving,
}

/// All that has been found; keeps its room from one search to the next.
#[derive(Debug, Default)]
pub struct Found {
    nodes: Vec<Node>,
    /// Each way's ends, and where its nodes end.
    ways: Vec<(Leaving, usize)>,
}

impl Found {
    /// Forgets all.
    pub fn clear(&mut self) {
        self.nodes.clear();
        self.ways.clear();
    }

    /// Adds a way.
    pub fn push(&mut self, ends: Leaving, nodes: impl Iterator<Item = Node>) {
        self.nodes.extend(nodes);
        self.ways.push((ends, self.nodes.len()));
    }

    /// How many there are.
    pub const fn len(&self) -> usize {
        self.ways.len()
    }

    /// The ways.
    pub fn iter(&self) -> impl Iterator<Item = Connection<'_>> {
        let mut from = 0;
        self.ways.iter().map(move |&(ends, to)| {
            let nodes = &self.nodes[from..to];
            from = to;
            Connection { nodes, ends }
        })
    }
}
