//! From the binary tree to nodes of eight.

use super::binary::{Branch, Content};
use super::item::Item;
use super::node::{Child, Node, WIDTH};
use crate::accel::huge;

/// Nodes over the binary tree, the root first, each before what is below it.
pub fn collapse(root: &Branch, items: &[Item], leaf: &mut dyn FnMut(u8, &[Item]) -> u32) -> Vec<Node> {
    let mut all = Collapse { items, leaf, nodes: Vec::new() };
    match &root.content {
        Content::Leaf(_) => {
            let child = all.child(root);
            all.nodes.push(Node::EMPTY);
            all.nodes[0].put(0, &root.bounds, child);
        }
        Content::Inner(_) => {
            all.node(root);
        }
    }
    huge::settled(&all.nodes)
}

struct Collapse<'a> {
    items: &'a [Item],
    leaf: &'a mut dyn FnMut(u8, &[Item]) -> u32,
    nodes: Vec<Node>,
}

impl Collapse<'_> {
    /// Adds a node and all below it; gives its index.
    fn node(&mut self, branch: &Branch) -> u32 {
        let index = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let Content::Inner(halves) = &branch.content else { return index as u32 };
        let mut children = Vec::with_capacity(WIDTH);
        let first = branch.cut.as_node();
        gather(&halves[0], first, &mut children);
        gather(&halves[1], WIDTH - first, &mut children);
        for (place, branch) in children.into_iter().enumerate() {
            let child = self.child(branch);
            self.nodes[index].put(place, &branch.bounds, child);
        }
        index as u32
    }

    fn child(&mut self, branch: &Branch) -> Child {
        match &branch.content {
            Content::Leaf(range) => {
                let items = &self.items[range.clone()];
                let kind = items[0].kind();
                Child::leaf((self.leaf)(kind, items), items.len() as u32, kind)
            }
            Content::Inner(_) => Child::node(self.node(branch)),
        }
    }
}

/// The children of a node that a part of the tree becomes, so many at most.
fn gather<'a>(branch: &'a Branch, most: usize, children: &mut Vec<&'a Branch>) {
    match (&branch.content, branch.cut.first_share(most)) {
        (Content::Inner(halves), Some((first, second))) => {
            gather(&halves[0], first, children);
            gather(&halves[1], second, children);
        }
        _ => children.push(branch),
    }
}
