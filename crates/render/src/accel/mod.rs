//! Ray casting: what is the nearest thing along a ray, and how much light passes along a shadow ray.
//!
//! Two levels: one tree over the scene's primitives, one over each mesh, so that moving an object never touches its
//! triangles. Leaves are typed: spheres, boxes, ellipsoids, discs and triangles stay exact, meshes are entered through their own
//! space. Planes have no box and are tested first. Rays go in packets, a ray a lane ([`simd`]).

mod beam;
mod closest;
pub(crate) mod huge;
mod lanes;
mod level;
mod mesh;
mod occluded;
pub(crate) mod packet;
mod packet_walk;
pub mod primitives;
pub(crate) mod rays;
pub mod simd;
pub(crate) mod single;
mod stack;
mod stream;
mod transmittance;
pub mod tree;
mod validate;
mod wide;

pub use packet::Packet;
pub use stream::{BLOCK, Column, Hit, HitBlock, HitStream, NOTHING, RayBlock, RayStream};

pub use mesh::MeshAccel;
pub use validate::AccelFlaw;

use primitives::cuboid::Unit;
use primitives::disc::Disc;
use primitives::plane::Plane;
use primitives::sphere::{Sphere, SphereBlock};
use primitives::triangle::TriangleBlock;
use simd::Instructions;
use std::sync::Arc;
use tree::{Item, Leaves, Tree};
use vitrine_math::{Affine3A, Bounds3, Vec3};

/// The kinds of leaves.
mod leaf {
    pub const SPHERE: u8 = 0;
    pub const BOX: u8 = 1;
    pub const ELLIPSOID: u8 = 2;
    pub const TRIANGLE: u8 = 3;
    pub const MESH: u8 = 4;
    pub const DISC: u8 = 5;
}

/// A mesh of more blocks of triangles is so fine that packets of 32 camera rays fall apart in it, and those of 16 are faster.
const COARSE: usize = 100_000;

/// How many of each kind a leaf holds: balls and triangles stand in blocks, the others cost more.
const LEAVES: Leaves = Leaves { most: [2, 1, 1, 8, 1, 1, 1, 1] };

/// A mesh at a place in the world.
#[derive(Clone, Debug)]
pub struct Instance {
    /// From the world to the mesh's own space.
    pub mesh_from_world: Affine3A,
    /// The mesh.
    pub mesh: Arc<MeshAccel>,
    /// Its place among the scene's primitives.
    pub primitive: u32,
}

/// Adds the items of a leaf; gives the place of the first.
fn append<T>(to: &mut Vec<T>, items: impl Iterator<Item = T>) -> u32 {
    let first = to.len() as u32;
    to.extend(items);
    first
}

impl Instance {
    /// Whether the mesh's own space is the world: then rays need not be moved.
    #[inline(always)]
    fn is_in_place(&self) -> bool {
        self.mesh_from_world == Affine3A::IDENTITY
    }
}

/// The materials of a primitive: that of slot k is `first + k`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialSlots {
    /// The material of slot 0.
    pub first: u32,
    /// Whether a mesh's triangles choose among slots; otherwise all have slot 0.
    pub by_triangle: bool,
}

/// The scene's primitives while they are being collected, each with its box.
#[derive(Debug, Default)]
pub struct Primitives {
    /// Planes.
    pub planes: Vec<Plane>,
    /// Balls.
    pub spheres: Vec<(Sphere, Bounds3)>,
    /// Cubes of side 2 in a space of their own.
    pub boxes: Vec<(Unit, Bounds3)>,
    /// Balls of radius 1 in a space of their own.
    pub ellipsoids: Vec<(Unit, Bounds3)>,
    /// Discs.
    pub discs: Vec<(Disc, Bounds3)>,
    /// Single triangles: their corners, and their places among the scene's primitives.
    pub triangles: Vec<([Vec3; 3], u32)>,
    /// Meshes.
    pub instances: Vec<(Instance, Bounds3)>,
    /// Each primitive's materials, by its place among the scene's primitives.
    pub materials: Vec<MaterialSlots>,
}

/// Everything that a ray can hit.
#[derive(Debug)]
pub struct Accel {
    tree: Tree,
    planes: Vec<Plane>,
    spheres: Vec<SphereBlock>,
    boxes: Vec<Unit>,
    ellipsoids: Vec<Unit>,
    discs: Vec<Disc>,
    triangles: Vec<TriangleBlock>,
    instances: Vec<Instance>,
    materials: Vec<MaterialSlots>,
    /// Each material's transparency, 0 to 1.
    transparencies: Vec<f32>,
    /// Whether triangles are so large that many neighbouring rays meet the same.
    is_coarse: bool,
    pub(crate) instructions: Instructions,
}

impl Accel {
    /// Builds the tree over the scene's primitives. `transparencies` holds one for each material, 0 to 1.
    #[must_use]
    pub fn new(primitives: Primitives, transparencies: Vec<f32>) -> Self {
        fn items<T>(kind: u8, all: &[(T, Bounds3)]) -> impl Iterator<Item = Item> {
            all.iter().enumerate().map(move |(i, (_, bounds))| Item::new(bounds, i as u32, kind))
        }
        let p = primitives;
        let single = |(i, (corners, _)): (usize, &([Vec3; 3], u32))| {
            Item::new(&Bounds3::around(*corners), i as u32, leaf::TRIANGLE)
        };
        let all = items(leaf::SPHERE, &p.spheres)
            .chain(items(leaf::BOX, &p.boxes))
            .chain(items(leaf::ELLIPSOID, &p.ellipsoids))
            .chain(items(leaf::DISC, &p.discs))
            .chain(p.triangles.iter().enumerate().map(single))
            .chain(items(leaf::MESH, &p.instances));
        let blocks = p.instances.iter().map(|(i, _)| i.mesh.blocks.len()).max().unwrap_or(0);
        let is_coarse = blocks <= COARSE;
        let (mut spheres, mut triangles) = (Vec::new(), Vec::new());
        let (mut boxes, mut ellipsoids, mut discs) = (Vec::new(), Vec::new(), Vec::new());
        let mut instances = Vec::new();
        let tree = Tree::build(all.collect(), LEAVES, &mut |kind, items| {
            let of = |i: &Item| i.index() as usize;
            match kind {
                leaf::SPHERE => {
                    spheres.push(SphereBlock::new(items.iter().map(|i| &p.spheres[of(i)].0)));
                    spheres.len() as u32 - 1
                }
                leaf::TRIANGLE => {
                    triangles.push(TriangleBlock::new(items.iter().map(|i| p.triangles[of(i)])));
                    triangles.len() as u32 - 1
                }
                leaf::BOX => append(&mut boxes, items.iter().map(|i| p.boxes[of(i)].0)),
                leaf::ELLIPSOID => append(&mut ellipsoids, items.iter().map(|i| p.ellipsoids[of(i)].0)),
                leaf::DISC => append(&mut discs, items.iter().map(|i| p.discs[of(i)].0)),
                _ => append(&mut instances, items.iter().map(|i| p.instances[of(i)].0.clone())),
            }
        });
        Self {
            tree,
            spheres,
            boxes,
            ellipsoids,
            discs,
            triangles,
            instances,
            planes: p.planes,
            materials: p.materials,
            transparencies,
            is_coarse,
            instructions: Instructions::detect(),
        }
    }

    /// The same with other instructions. The hits are the same bits.
    #[must_use]
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.instructions = instructions;
        self
    }

    /// The material slot of a triangle of a primitive.
    #[inline(always)]
    fn material(&self, primitive: u32, slot: u32) -> u32 {
        let slots = self.materials[primitive as usize];
        slots.first + if slots.by_triangle { slot } else { 0 }
    }

    /// The transparency of a surface.
    #[inline(always)]
    fn transparency(&self, primitive: u32, slot: u32) -> f32 {
        self.transparencies[self.material(primitive, slot) as usize]
    }

    /// Bytes of the arrays, those of meshes apart.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.tree.memory()
            + size_of_val(&*self.spheres)
            + size_of_val(&*self.boxes)
            + size_of_val(&*self.ellipsoids)
            + size_of_val(&*self.discs)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.instances)
    }
}

#[cfg(test)]
mod tests;
