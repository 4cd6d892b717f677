//! One ray or many: how rays are tested against blocks, and how they walk through a tree.

use super::MeshAccel;
use super::packet::{Entry, Packet, splat3};
use super::packet_walk::walk_together;
use super::primitives::Span;
use super::primitives::sphere::{self, SphereBlock};
use super::primitives::triangle::{BLOCK_TRIANGLES, Crossing, ORDER, TriangleBlock, crossing};
use super::simd::Simd;
use super::single::One;
use super::tree::{Child, Node};

/// Rays in lanes, as far as single rays and packets differ.
///
/// What a ray meets does not depend on which of them does it: tests have the same digits, and a hit counts exactly if the ray
/// enters the leaf's box by [`Packet::meets_box`].
pub trait Rays: Simd {
    /// A vector unit of eight lanes.
    type Eight: Simd;

    /// Eight lanes to test one ray against eight things.
    fn eight(self) -> Self::Eight;

    /// Tells which rays of a packet cross the triangles of a leaf, in their order.
    #[inline(always)]
    fn triangles<R: Receive<Self>>(
        self,
        packet: &Packet<Self>,
        leaf: &TriangleLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        let fastest = packet.fastest(self);
        for place in 0..leaf.count {
            let [a, b, c] = &leaf.block.corners;
            for (axis, &fastest) in fastest.iter().enumerate() {
                let mask = self.and(entry.mask, fastest);
                if !self.any(mask) {
                    continue;
                }
                let corners = [
                    corner(self, a, axis, place),
                    corner(self, b, axis, place),
                    corner(self, c, axis, place),
                ];
                if let Some(hit) = crossing(self, &packet.sheared(self, axis), &corners, mask) {
                    receive.crossing(self, &hit, entry.near, leaf.surface(place));
                }
            }
        }
    }

    /// Tells which rays of a packet cross the balls of a leaf, in their order.
    #[inline(always)]
    fn spheres<R: Receive<Self>>(
        self,
        packet: &Packet<Self>,
        leaf: &SphereLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        for place in 0..leaf.count {
            let [x, y, z] = &leaf.block.centers;
            let center = splat3(self, [x[place], y[place], z[place]]);
            let radius = self.splat(leaf.block.radii[place]);
            if let Some(span) = sphere::span(self, packet, &center, radius, entry.mask) {
                receive.span(self, &span, entry.near, leaf.block.primitives[place]);
            }
        }
    }

    /// Takes the rays through a tree.
    #[inline(always)]
    fn walk<L: Level<Self>>(self, nodes: &[Node], packet: &Packet<Self>, level: &mut L) {
        walk_together(self, nodes, packet, level);
    }
}

/// One corner of a triangle for all rays, its components in the order of an axis.
#[inline(always)]
fn corner<S: Simd>(s: S, corners: &[[f32; BLOCK_TRIANGLES]; 3], axis: usize, place: usize) -> [S::F; 3] {
    let [x, y, z] = ORDER[axis];
    let place = place % BLOCK_TRIANGLES;
    [s.splat(corners[x][place]), s.splat(corners[y][place]), s.splat(corners[z][place])]
}

/// Triangles of a leaf.
pub struct TriangleLeaf<'a> {
    /// The block.
    pub block: &'a TriangleBlock,
    /// How many triangles it holds.
    pub count: usize,
    /// The mesh and its primitive; None where each triangle is a primitive of its own.
    pub mesh: Option<(&'a MeshAccel, u32)>,
}

impl<'a> TriangleLeaf<'a> {
    /// Which surface a triangle is.
    #[inline(always)]
    pub fn surface(&self, place: usize) -> Surface<'a> {
        let id = self.block.ids[place % 8];
        match self.mesh {
            Some((mesh, primitive)) => Surface { primitive, triangle: id, mesh: Some(mesh) },
            None => Surface { primitive: id, triangle: 0, mesh: None },
        }
    }
}

/// Balls of a leaf.
pub struct SphereLeaf<'a> {
    /// The block.
    pub block: &'a SphereBlock,
    /// How many balls it holds.
    pub count: usize,
}

/// Which surface a ray crosses.
#[derive(Clone, Copy)]
pub struct Surface<'a> {
    /// Its place among the scene's primitives.
    pub primitive: u32,
    /// The triangle of a mesh; 0 for other forms.
    pub triangle: u32,
    /// The mesh.
    pub mesh: Option<&'a MeshAccel>,
}

/// What is done with the surfaces that rays cross.
pub trait Receive<S: Rays>: Sized {
    /// Whether nearer boxes go first. Without it each ray meets its leaves in one order, whatever rays are beside it.
    const NEAREST_FIRST: bool;
    /// The same for one ray.
    type Single: Receive<One<S::Eight>>;

    /// Rays that still look for something.
    fn active(&self, s: S) -> S::M;
    /// Hits before these distances are of no use; 0 or more.
    fn t_min(&self, s: S) -> S::F;
    /// Hits beyond these distances are of no use.
    fn t_max(&self, s: S) -> S::F;
    /// Rays enter and leave a closed form in a box that they enter at `from`.
    fn span(&mut self, s: S, span: &Span<S>, from: S::F, primitive: u32);
    /// Rays cross a surface in a box that they enter at `from`.
    fn crossing(&mut self, s: S, hit: &Crossing<S>, from: S::F, surface: Surface);
    /// The same for the rays of the mask alone.
    fn narrowed(&self, s: S, mask: S::M) -> Self;
    /// Takes over what has been found with the rays of the mask alone.
    fn widen(&mut self, s: S, inner: Self, mask: S::M);
    /// The same for the ray of one lane.
    fn single(&self, s: S, lane: usize) -> Self::Single;
    /// Takes over what has been found for the ray of one lane.
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single);
}

/// A level of trees: the scene's, or a mesh's.
pub trait Level<S: Rays> {
    /// What is done with the surfaces.
    type Receive: Receive<S>;
    /// The same level for one ray.
    type Single: Level<One<S::Eight>>;

    /// What is done with the surfaces.
    fn receive(&self) -> &Self::Receive;
    /// A leaf, for the rays that enter its box.
    fn leaf(&mut self, s: S, packet: &Packet<S>, leaf: Child, entry: Entry<S>);
    /// The same for the ray of one lane.
    fn single(&self, s: S, lane: usize) -> Self::Single;
    /// Takes over what has been found for the ray of one lane.
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single);
}
