//! Checks of finished trees.

use super::node::{Node, WIDTH};
use super::{STACK, Tree};
use vitrine_math::Bounds3;

/// What can be wrong with a tree.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TreeFlaw {
    /// A child that is no node of the tree, or one that has been met before.
    #[error("node {node} has a child {child} that is outside the tree or in it twice")]
    BadChild {
        /// The node.
        node: usize,
        /// What it calls its child.
        child: usize,
    },
    /// Something that reaches out of the box that must hold it.
    #[error("what lies below place {place} of node {node} reaches out of its box")]
    OutsideBox {
        /// The node.
        node: usize,
        /// The place in the node.
        place: usize,
    },
    /// A box with numbers that are none, or a child in an empty place.
    #[error("place {place} of node {node} has no proper box")]
    BadBox {
        /// The node.
        node: usize,
        /// The place in the node.
        place: usize,
    },
    /// A leaf that points at primitives that are not there, at some that another leaf holds, or at numbers that are none.
    #[error(
        "place {place} of node {node} holds primitives that are not there, held twice, or no proper forms"
    )]
    BadLeaf {
        /// The node.
        node: usize,
        /// The place in the node.
        place: usize,
    },
    /// Nodes or primitives that no way leads to.
    #[error("{count} nodes or primitives cannot be reached")]
    Unreachable {
        /// How many.
        count: usize,
    },
    /// A walk through the tree would have to remember too much.
    #[error("the tree is {depth} levels deep")]
    TooDeep {
        /// Levels.
        depth: usize,
    },
}

/// A leaf as the check meets it.
#[derive(Clone, Copy, Debug)]
pub struct LeafFound {
    /// The kind of its primitives.
    pub kind: u8,
    /// Its number.
    pub first: u32,
    /// How many primitives it has.
    pub count: u32,
}

impl Tree {
    /// Checks that every node is reached once, that boxes hold what is below them, and that no walk is too deep. `leaf` tells
    /// the box around a leaf's primitives, an empty one where it does not know, or None when something is wrong with them.
    ///
    /// # Errors
    /// The first [`TreeFlaw`] that is found.
    pub fn validate(&self, leaf: &mut dyn FnMut(LeafFound) -> Option<Bounds3>) -> Result<(), TreeFlaw> {
        if self.nodes.is_empty() {
            return Ok(());
        }
        let mut seen = vec![false; self.nodes.len()];
        seen[0] = true;
        let mut todo = vec![(0_usize, 1_usize)];
        while let Some((index, depth)) = todo.pop() {
            if depth * (WIDTH - 1) >= STACK {
                return Err(TreeFlaw::TooDeep { depth });
            }
            let node = &self.nodes[index];
            for place in 0..WIDTH {
                let bounds = node.bounds(place);
                if node.is_vacant(place) {
                    continue;
                }
                if bounds.is_empty() || !(bounds.min.is_finite() && bounds.max.is_finite()) {
                    return Err(TreeFlaw::BadBox { node: index, place });
                }
                let child = node.child(place);
                let below = if child.is_leaf() {
                    let found = LeafFound { kind: child.kind(), first: child.first, count: child.count() };
                    leaf(found).ok_or(TreeFlaw::BadLeaf { node: index, place })?
                } else {
                    let child = child.first as usize;
                    if child >= seen.len() || std::mem::replace(&mut seen[child], true) {
                        return Err(TreeFlaw::BadChild { node: index, child });
                    }
                    todo.push((child, depth + 1));
                    around(&self.nodes[child])
                };
                let holds = below.is_empty() || bounds.contains(below.min) && bounds.contains(below.max);
                if !holds {
                    return Err(TreeFlaw::OutsideBox { node: index, place });
                }
            }
        }
        match seen.iter().filter(|s| !**s).count() {
            0 => Ok(()),
            count => Err(TreeFlaw::Unreachable { count }),
        }
    }
}

/// The box around all of a node's boxes.
fn around(node: &Node) -> Bounds3 {
    (0..WIDTH).map(|place| node.bounds(place)).filter(|b| !b.is_empty()).fold(Bounds3::EMPTY, Bounds3::union)
}
