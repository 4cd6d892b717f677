//! How a binary tree is best cut into nodes of eight: the way of least cost, found from the leaves up. Ylitie, Karras and Laine,
//! "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, section 3.

use super::node::WIDTH;

/// What a part of the tree costs as so many children of a node, and how it is divided then.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// The least cost as 1 to `k + 1` children: the areas of all nodes below.
    costs: [f32; WIDTH],
    /// How many of those children come from the first half; 0 where one child less does as well.
    firsts: [u8; WIDTH],
    /// How many of a node's children come from the first half when this part is a node.
    as_node: u8,
}

impl Cut {
    /// Leaves are children as they are.
    pub const LEAF: Self = Self { costs: [0.0; WIDTH], firsts: [0; WIDTH], as_node: 0 };

    /// Of two halves in a box of that half area.
    pub fn new(area: f32, [first, second]: [&Self; 2]) -> Self {
        let mut cut = Self::LEAF;
        let mut shared = [f32::INFINITY; WIDTH];
        for (k, (shared, firsts)) in shared.iter_mut().zip(&mut cut.firsts).enumerate().skip(1) {
            for j in 0..k {
                let cost = first.costs[j] + second.costs[k - 1 - j];
                if cost < *shared || *firsts == 0 {
                    (*shared, *firsts) = (cost, j as u8 + 1);
                }
            }
        }
        cut.as_node = cut.firsts[WIDTH - 1];
        cut.costs[0] = area + shared[WIDTH - 1];
        for (k, shared) in shared.into_iter().enumerate().skip(1) {
            if shared < cut.costs[k - 1] {
                cut.costs[k] = shared;
            } else {
                (cut.costs[k], cut.firsts[k]) = (cut.costs[k - 1], 0);
            }
        }
        cut
    }

    /// How many of a node's children come from the first half.
    pub fn as_node(&self) -> usize {
        usize::from(self.as_node)
    }

    /// How many of so many children come from the first half; None when the part is one child whole.
    pub fn first_share(&self, children: usize) -> Option<(usize, usize)> {
        let k = (1..children.min(WIDTH)).rev().find(|k| self.firsts[*k] != 0)?;
        let first = usize::from(self.firsts[k]);
        Some((first, k + 1 - first))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_leaves_are_one_node() {
        let two = Cut::new(1.0, [&Cut::LEAF; 2]);
        let four = Cut::new(2.0, [&two; 2]);
        let eight = Cut::new(4.0, [&four; 2]);
        assert_eq!((eight.as_node(), eight.costs[0]), (4, 4.0));
        assert_eq!(four.first_share(4), Some((2, 2)));
        assert_eq!(four.first_share(1), None);
        assert_eq!(two.first_share(8), Some((1, 1)), "no more children than leaves");
    }

    #[test]
    fn a_small_part_stays_whole_where_room_is_short() {
        let small = Cut::new(0.1, [&Cut::LEAF; 2]);
        let large = Cut::new(5.0, [&Cut::LEAF; 2]);
        let both = Cut::new(6.0, [&small, &large]);
        assert_eq!(both.first_share(3), Some((1, 2)), "the large one is opened");
    }
}
