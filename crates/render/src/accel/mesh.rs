//! Meshes made ready for rays.

use super::primitives::triangle::TriangleBlock;
use super::tree::{Item, Tree};
use super::{LEAVES, huge, leaf};
use rayon::prelude::*;
use std::sync::OnceLock;
use vitrine_math::{Bounds3, Vec3};

/// A mesh ready for rays, in its own space.
#[derive(Clone, Debug)]
pub struct MeshAccel {
    pub(super) tree: Tree,
    pub(super) blocks: Vec<TriangleBlock>,
    /// Which material slot each triangle has, by its index in the model; empty when all have slot 0.
    slots: Vec<u16>,
    bounds: Bounds3,
    /// How many triangles the model has.
    pub(super) triangles: usize,
    /// Whether the model is closed, once somebody has asked.
    is_closed: OnceLock<bool>,
}

impl MeshAccel {
    /// Builds the tree over triangles, given by the places of their corners among the positions, on all threads of the machine.
    ///
    /// # Panics
    /// When a triangle has a corner that is not there.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]], slots: Vec<u16>) -> Self {
        let corners = |t: u32| triangles[t as usize].map(|corner| positions[corner as usize]);
        let mut items = huge::with_capacity(triangles.len());
        items.par_extend(
            (0..triangles.len() as u32)
                .into_par_iter()
                .map(|t| Item::new(&Bounds3::around(corners(t)), t, leaf::TRIANGLE)),
        );
        let mut contents: Vec<([u32; 8], u8)> = Vec::with_capacity(triangles.len() / 6);
        let tree = Tree::build(items, LEAVES, &mut |_, items| {
            let mut ids = [0; 8];
            ids.iter_mut().zip(items).for_each(|(id, item)| *id = item.index());
            contents.push((ids, items.len() as u8));
            contents.len() as u32 - 1
        });
        let block = |(ids, count): &([u32; 8], u8)| {
            TriangleBlock::new(ids[..usize::from(*count)].iter().map(|&id| (corners(id), id)))
        };
        let mut blocks = huge::with_capacity(contents.len());
        blocks.par_extend(contents.par_iter().map(block));
        let bounds = Bounds3::around(positions.iter().copied());
        Self { tree, blocks, slots, bounds, triangles: triangles.len(), is_closed: OnceLock::new() }
    }

    /// Whether the model is closed, found out once: it takes time.
    pub(crate) fn is_closed(&self, find_out: impl FnOnce() -> bool) -> bool {
        *self.is_closed.get_or_init(find_out)
    }

    /// About how many bytes building a tree over so many triangles takes at most, and the tree afterwards.
    #[must_use]
    pub const fn bytes_to_build(triangles: usize) -> u64 {
        // An item of the builder is 32 bytes. Of the binary tree, the nodes and their copies, and later of the blocks with their
        // nodes, some 54 bytes belong to each triangle; the rest is for leaves that are not full.
        const EACH: u64 = 110;
        const FEW: u64 = 4096;
        EACH * triangles as u64 + FEW
    }

    /// The box around all positions, in the mesh's own space.
    #[must_use]
    pub const fn bounds(&self) -> Bounds3 {
        self.bounds
    }

    /// The material slot of a triangle, by its place in the model.
    #[inline(always)]
    #[must_use]
    pub fn slot(&self, triangle: u32) -> u32 {
        self.slots.get(triangle as usize).map_or(0, |&s| u32::from(s))
    }

    /// Bytes of the arrays.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.tree.memory() + size_of_val(&*self.blocks) + size_of_val(&*self.slots)
    }
}
