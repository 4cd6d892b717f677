//! From the binary tree to nodes of eight: the largest child is opened until the node is full.

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
        Content::Inner(children) => {
            all.node(children);
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
    fn node(&mut self, children: &[Branch; 2]) -> u32 {
        let index = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let mut open: Vec<&Branch> = Vec::with_capacity(WIDTH);
        open.extend(children);
        while open.len() < WIDTH {
            let mut largest: Option<(f32, usize)> = None;
            for (place, branch) in open.iter().enumerate() {
                let area = branch.bounds.half_area();
                if matches!(branch.content, Content::Inner(_)) && largest.is_none_or(|(a, _)| area > a) {
                    largest = Some((area, place));
                }
            }
            let Some((_, place)) = largest else { break };
            let Content::Inner(children) = &open[place].content else { break };
            open[place] = &children[0];
            open.insert(place + 1, &children[1]);
        }
        for (place, branch) in open.into_iter().enumerate() {
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
            Content::Inner(children) => Child::node(self.node(children)),
        }
    }
}
