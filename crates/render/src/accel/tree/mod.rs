//! Bounding volume hierarchies: a binary tree by the binned surface area heuristic, collapsed to nodes of eight boxes.
//!
//! Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007; Wald, Benthin and Boulos, "Getting Rid of
//! Packets", 2008. One tree stands over a whole scene and one over each mesh; both use these nodes.

mod binary;
mod collapse;
mod cut;
mod item;
mod node;
mod sorted;
mod validate;

pub use item::{Item, Leaves};
pub use node::{Child, Node, WIDTH};
pub use validate::{LeafFound, TreeFlaw};

/// Levels of splits by surface area before the builder halves instead, which ends after 32 levels for any number of items
/// that fits 32 bits.
const SAH_LEVELS: usize = 48;
/// The deepest binary tree, with room for runs that give off a block at a time at their end and for leaves split by kind. The
/// tree of eight boxes a node is no deeper.
const MAX_DEPTH: usize = SAH_LEVELS + 32 + sorted::LONGEST / WIDTH + 8;
/// How many boxes a walk may have to remember: seven of each node on its way.
pub const STACK: usize = MAX_DEPTH * (WIDTH - 1) + 1;

/// A finished tree.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// The nodes, the root first; none for an empty tree.
    pub nodes: Vec<Node>,
}

impl Tree {
    /// Builds the tree, on all threads of the machine. `leaf` is told the kind and the items of each leaf, in the order of
    /// the tree, and says what number the leaf shall carry. The tree does not depend on the number of threads.
    #[must_use]
    pub fn build(mut items: Vec<Item>, leaves: Leaves, leaf: &mut dyn FnMut(u8, &[Item]) -> u32) -> Self {
        let Some(root) = binary::split_all(&mut items, leaves) else { return Self::default() };
        Self { nodes: collapse::collapse(&root, &items, leaf) }
    }

    /// Bytes of the nodes.
    #[must_use]
    pub fn memory(&self) -> usize {
        size_of_val(&*self.nodes)
    }
}
