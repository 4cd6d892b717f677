//! Ray casting: what is the nearest thing along a ray, and how much light passes along a shadow ray.
//!
//! Two levels: one tree over the scene's primitives, one over each mesh, so that moving an object never touches its
//! triangles. Leaves are typed: spheres, boxes, ellipsoids and triangles stay exact, meshes are entered through their own
//! space. Planes have no box and are tested first. Rays go in packets, a ray a lane ([`simd`]).

pub mod bvh;
mod closest;
pub(crate) mod packet;
pub mod primitives;
pub mod simd;
mod stream;
mod transmittance;

pub use packet::Packet;
pub use stream::{BLOCK, Column, Hit, HitBlock, HitStream, NOTHING, RayBlock, RayStream};

use bvh::{Bvh, Item};
use primitives::cuboid::Unit;
use primitives::plane::Plane;
use primitives::sphere::Sphere;
use primitives::triangle::Triangle;
use simd::Instructions;
use std::sync::Arc;
use vitrine_math::{Affine3A, Bounds3};

/// The kinds of leaves.
mod leaf {
    pub const SPHERE: u8 = 0;
    pub const BOX: u8 = 1;
    pub const ELLIPSOID: u8 = 2;
    pub const TRIANGLE: u8 = 3;
    pub const MESH: u8 = 4;
}

/// A mesh ready for rays, in its own space.
#[derive(Debug)]
pub struct MeshAccel {
    bvh: Bvh,
    triangles: Vec<Triangle>,
    /// Which material slot each triangle has, by its index in the model; empty when all have slot 0.
    slots: Vec<u16>,
}

impl MeshAccel {
    /// Builds the tree over triangles, whose `id` is their place in the model.
    #[must_use]
    pub fn new(triangles: &[Triangle], bounds: impl Fn(&Triangle) -> Bounds3, slots: Vec<u16>) -> Self {
        let item =
            |(i, t): (usize, &Triangle)| Item { bounds: bounds(t), index: i as u32, kind: leaf::TRIANGLE };
        let (bvh, order) = bvh::build(triangles.iter().enumerate().map(item).collect());
        let triangles = order.iter().map(|i| triangles[i.index as usize]).collect();
        Self { bvh, triangles, slots }
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
        size_of_val(&*self.bvh.nodes) + size_of_val(&*self.triangles) + size_of_val(&*self.slots)
    }
}

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
    /// Single triangles.
    pub triangles: Vec<(Triangle, Bounds3)>,
    /// Meshes.
    pub instances: Vec<(Instance, Bounds3)>,
    /// Each primitive's materials, by its place among the scene's primitives.
    pub materials: Vec<MaterialSlots>,
}

/// Everything that a ray can hit.
#[derive(Debug)]
pub struct Accel {
    bvh: Bvh,
    planes: Vec<Plane>,
    spheres: Vec<Sphere>,
    boxes: Vec<Unit>,
    ellipsoids: Vec<Unit>,
    triangles: Vec<Triangle>,
    instances: Vec<Instance>,
    materials: Vec<MaterialSlots>,
    /// Each material's transparency, 0 to 1.
    transparencies: Vec<f32>,
    pub(crate) instructions: Instructions,
}

impl Accel {
    /// Builds the tree over the scene's primitives. `transparencies` holds one for each material, 0 to 1.
    #[must_use]
    pub fn new(primitives: Primitives, transparencies: Vec<f32>) -> Self {
        fn items<T>(kind: u8, all: &[(T, Bounds3)]) -> impl Iterator<Item = Item> {
            all.iter().enumerate().map(move |(i, (_, bounds))| Item {
                bounds: *bounds,
                index: i as u32,
                kind,
            })
        }
        let p = primitives;
        let all = items(leaf::SPHERE, &p.spheres)
            .chain(items(leaf::BOX, &p.boxes))
            .chain(items(leaf::ELLIPSOID, &p.ellipsoids))
            .chain(items(leaf::TRIANGLE, &p.triangles))
            .chain(items(leaf::MESH, &p.instances));
        let (bvh, order) = bvh::build(all.collect());
        fn ordered<T: Clone>(kind: u8, all: &[(T, Bounds3)], order: &[Item]) -> Vec<T> {
            order.iter().filter(|i| i.kind == kind).map(|i| all[i.index as usize].0.clone()).collect()
        }
        Self {
            bvh,
            spheres: ordered(leaf::SPHERE, &p.spheres, &order),
            boxes: ordered(leaf::BOX, &p.boxes, &order),
            ellipsoids: ordered(leaf::ELLIPSOID, &p.ellipsoids, &order),
            triangles: ordered(leaf::TRIANGLE, &p.triangles, &order),
            instances: ordered(leaf::MESH, &p.instances, &order),
            planes: p.planes,
            materials: p.materials,
            transparencies,
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
        size_of_val(&*self.bvh.nodes)
            + size_of_val(&*self.spheres)
            + size_of_val(&*self.boxes)
            + size_of_val(&*self.ellipsoids)
            + size_of_val(&*self.triangles)
            + size_of_val(&*self.instances)
    }
}

#[cfg(test)]
mod tests;
