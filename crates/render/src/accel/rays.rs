//! One ray or many: how rays are tested against blocks, and how they walk through a tree.

use super::MeshAccel;
use super::packet::{Entry, Packet};
use super::primitives::Span;
use super::primitives::sphere::SphereBlock;
use super::primitives::triangle::{BLOCK_TRIANGLES, Crossing, ORDER, Sheared, TriangleBlock, inside, normal};
use super::simd::Simd;
use super::single::One;
use super::tree::{Child, Node};

/// Rays in lanes, as far as single rays and packets differ.
///
/// What a ray meets does not depend on which of them does it: tests have the same digits, and a hit counts exactly if the ray
/// enters the leaf's box, and a triangle's own box, by [`Packet::meets_box`].
pub trait Rays: Simd {
    /// A vector unit of eight lanes.
    type Eight: Simd;
    /// What is known of all rays together.
    type Beam;

    /// Two or four packets as one of 32 rays.
    type Wide: Rays;

    /// Lanes for 32 rays; the same for single rays.
    fn wide(self) -> Self::Wide;
    /// Eight lanes to test one ray against eight things.
    fn eight(self) -> Self::Eight;

    /// Tells which rays cross the triangles of a leaf, each in their order.
    fn triangles<R: Receive<Self>>(
        self,
        rays: &Bundle<Self>,
        leaf: &TriangleLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    );

    /// Tells which rays cross the balls of a leaf, each in their order.
    fn spheres<R: Receive<Self>>(
        self,
        packet: &Packet<Self>,
        leaf: &SphereLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    );

    /// Takes the rays through a tree.
    fn walk<L: Level<Self>>(self, nodes: &[Node], packet: &Packet<Self>, level: &mut L);
}

/// Rays at a leaf.
#[derive(Clone, Copy)]
pub struct Bundle<'a, S: Rays> {
    /// The rays.
    pub packet: &'a Packet<S>,
    /// What is known of them all.
    pub beam: &'a S::Beam,
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

impl TriangleLeaf<'_> {
    /// The triangles that one ray crosses before `t_max`, a bit for each, with the distances and the barycentric coordinates;
    /// None when there is none. The ray is sheared onto the axis.
    #[inline(always)]
    pub fn crossed<E: Simd>(
        &self,
        e: E,
        ray: &Sheared<E>,
        axis: usize,
        t_max: f32,
    ) -> Option<(u32, [[f32; BLOCK_TRIANGLES]; 3])> {
        let [a, b, c] = &self.block.corners;
        let zero = e.splat(0.0);
        let corners = [corner(e, a, axis), corner(e, b, axis), corner(e, c, axis)];
        let hit = inside(e, ray, &corners, e.le(zero, zero))?.crossing(e, ray, &normal(e, &corners));
        let in_time = e.and(e.lt(zero, hit.t), e.le(hit.t, e.splat(t_max)));
        let bits = e.bits(e.and(hit.mask, in_time));
        if bits == 0 {
            return None;
        }
        let mut lanes = [[0.0; BLOCK_TRIANGLES]; 3];
        e.store(hit.t, &mut lanes[0]);
        e.store(hit.u, &mut lanes[1]);
        e.store(hit.v, &mut lanes[2]);
        Some((bits, lanes))
    }
}

/// The corners of eight triangles, their components in the order of an axis.
#[inline(always)]
fn corner<E: Simd>(e: E, corners: &[[f32; BLOCK_TRIANGLES]; 3], axis: usize) -> [E::F; 3] {
    let [x, y, z] = ORDER[axis];
    [e.load(&corners[x]), e.load(&corners[y]), e.load(&corners[z])]
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
    fn leaf(&mut self, s: S, rays: &Bundle<S>, leaf: Child, entry: Entry<S>);
    /// The same for the ray of one lane.
    fn single(&self, s: S, lane: usize) -> Self::Single;
    /// Takes over what has been found for the ray of one lane.
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single);
}
