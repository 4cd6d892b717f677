//! The two levels of trees: the scene's, whose leaves hold forms of every kind, and a mesh's, whose leaves hold triangles.

use super::packet::Entry;
use super::primitives::{cuboid, disc, sphere};
use super::rays::{Bundle, Level, Rays, Receive, SphereLeaf, Surface, TriangleLeaf};
use super::simd::Simd;
use super::tree::Child;
use super::{Accel, Instance, leaf};

/// The scene's tree.
pub struct SceneLevel<'a, R> {
    /// The scene.
    pub accel: &'a Accel,
    /// What is done with the surfaces.
    pub receive: R,
}

impl<'a, S: Rays, R: Receive<S>> Level<S> for SceneLevel<'a, R> {
    type Receive = R;
    type Single = SceneLevel<'a, R::Single>;

    #[inline(always)]
    fn receive(&self) -> &R {
        &self.receive
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, rays: &Bundle<S>, child: Child, entry: Entry<S>) {
        let packet = rays.packet;
        let (first, count) = (child.first as usize, child.count() as usize);
        let (accel, receive) = (self.accel, &mut self.receive);
        match child.kind() {
            leaf::SPHERE => {
                s.spheres(packet, &SphereLeaf { block: &accel.spheres[first], count }, entry, receive);
            }
            leaf::TRIANGLE => {
                let leaf = TriangleLeaf { block: &accel.triangles[first], count, mesh: None };
                s.triangles(rays, &leaf, entry, receive);
            }
            leaf::BOX => {
                for unit in &accel.boxes[first..first + count] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    if let Some(span) = cuboid::span(s, &inside, entry.mask) {
                        receive.span(s, &span, entry.near, unit.primitive);
                    }
                }
            }
            leaf::ELLIPSOID => {
                for unit in &accel.ellipsoids[first..first + count] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    let (middle, radius) = ([s.splat(0.0); 3], s.splat(1.0));
                    if let Some(span) = sphere::span(s, &inside, &middle, radius, entry.mask) {
                        receive.span(s, &span, entry.near, unit.primitive);
                    }
                }
            }
            leaf::DISC => {
                for disc in &accel.discs[first..first + count] {
                    if let Some(hit) = disc::crossing(s, packet, disc, entry.mask) {
                        let surface = Surface { primitive: disc.primitive, triangle: 0, mesh: None };
                        receive.crossing(s, &hit, entry.near, surface);
                    }
                }
            }
            _ => {
                for instance in &accel.instances[first..first + count] {
                    let (inside, mask) = if instance.is_in_place() {
                        (*packet, entry.mask)
                    } else {
                        let inside = packet.transformed(s, &instance.mesh_from_world);
                        (inside, s.and(entry.mask, inside.in_range(s)))
                    };
                    let inner = receive.narrowed(s, mask);
                    let mut level = MeshLevel { instance, from: entry.near, receive: inner };
                    s.walk(&instance.mesh.tree.nodes, &inside, &mut level);
                    receive.widen(s, level.receive, mask);
                }
            }
        }
    }

    #[inline(always)]
    fn single(&self, s: S, lane: usize) -> Self::Single {
        SceneLevel { accel: self.accel, receive: self.receive.single(s, lane) }
    }

    #[inline(always)]
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single) {
        self.receive.take_single(s, lane, &single.receive);
    }
}

/// A mesh's tree.
pub struct MeshLevel<'a, S: Simd, R> {
    /// The mesh at its place.
    pub instance: &'a Instance,
    /// Where the rays enter the instance's box.
    pub from: S::F,
    /// What is done with the surfaces.
    pub receive: R,
}

impl<'a, S: Rays, R: Receive<S>> Level<S> for MeshLevel<'a, S, R> {
    type Receive = R;
    type Single = MeshLevel<'a, super::single::One<S::Eight>, R::Single>;

    #[inline(always)]
    fn receive(&self) -> &R {
        &self.receive
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, rays: &Bundle<S>, child: Child, entry: Entry<S>) {
        let mesh = &*self.instance.mesh;
        let leaf = TriangleLeaf {
            block: &mesh.blocks[child.first as usize],
            count: child.count() as usize,
            mesh: Some((mesh, self.instance.primitive)),
        };
        let entry = Entry { near: s.max(self.from, entry.near), ..entry };
        s.triangles(rays, &leaf, entry, &mut self.receive);
    }

    #[inline(always)]
    fn single(&self, s: S, lane: usize) -> Self::Single {
        let from = s.lane(self.from, lane);
        MeshLevel { instance: self.instance, from, receive: self.receive.single(s, lane) }
    }

    #[inline(always)]
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single) {
        self.receive.take_single(s, lane, &single.receive);
    }
}
