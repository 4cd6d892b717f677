//! How much light passes along each shadow ray: every surface that it crosses lets its material's transparency through.

use super::bvh::Node;
use super::packet::{Entry, Packet, Visitor, traverse};
use super::primitives::{Span, cuboid, plane, sphere, triangle};
use super::simd::{Kernel, Simd};
use super::stream::{BLOCK, RayBlock, RayStream};
use super::{Accel, Instance, leaf};

impl Accel {
    /// The product of the transparencies of all surfaces that each ray crosses at `0 < t < t_max`; 0 as soon as one is
    /// opaque, 1 when there is none. Rays go straight on. One number a ray; places beyond the last ray mean nothing.
    pub fn transmittance(&self, rays: &RayStream, passes: &mut Vec<f32>) {
        passes.clear();
        passes.resize(rays.blocks.len() * BLOCK, 0.0);
        self.instructions.run(Transmittance { accel: self, rays: &rays.blocks, passes });
    }

    /// The same for a packet, inside a kernel. Lanes with `t_max ≤ 0` shoot no ray; their result means nothing.
    #[inline(always)]
    pub fn packet_transmittance<S: Simd>(&self, s: S, packet: &Packet<S>, t_max: S::F) -> S::F {
        let mut light = Light { passes: s.splat(1.0), t_max, alive: s.lt(s.splat(0.0), t_max) };
        for p in &self.planes {
            let t = plane::distance(s, packet, p);
            light.cross(s, light.alive, t, self.transparency(p.primitive, 0));
        }
        let mut walk = Walk { accel: self, light };
        traverse(s, &self.bvh.nodes, packet, &mut walk);
        walk.light.passes
    }
}

struct Transmittance<'a> {
    accel: &'a Accel,
    rays: &'a [RayBlock],
    passes: &'a mut [f32],
}

impl Kernel for Transmittance<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        for (rays, passes) in self.rays.iter().zip(self.passes.chunks_exact_mut(BLOCK)) {
            for start in (0..BLOCK).step_by(S::LANES) {
                let packet = Packet::load(s, rays, start);
                let t_max = s.load(&rays.t_max[start..]);
                s.store(self.accel.packet_transmittance(s, &packet, t_max), &mut passes[start..]);
            }
        }
    }
}

/// What is left of the light, in lanes.
#[derive(Clone, Copy)]
struct Light<S: Simd> {
    passes: S::F,
    t_max: S::F,
    /// Lanes with light left.
    alive: S::M,
}

impl<S: Simd> Light<S> {
    /// Lets the light of the mask's lanes cross a surface at `t`.
    #[inline(always)]
    fn cross(&mut self, s: S, mask: S::M, t: S::F, transparency: f32) {
        let meets = s.and(mask, s.and(s.lt(s.splat(0.0), t), s.lt(t, self.t_max)));
        self.passes = s.select(meets, s.mul(self.passes, s.splat(transparency)), self.passes);
        if transparency == 0.0 {
            self.alive = s.and_not(self.alive, meets);
        }
    }

    #[inline(always)]
    fn cross_both(&mut self, s: S, span: &Span<S>, transparency: f32) {
        self.cross(s, span.mask, span.near, transparency);
        self.cross(s, span.mask, span.far, transparency);
    }
}

/// The way through the scene's tree.
struct Walk<'a, S: Simd> {
    accel: &'a Accel,
    light: Light<S>,
}

impl<S: Simd> Visitor<S> for Walk<'_, S> {
    const NEAREST_FIRST: bool = false;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.light.alive
    }

    #[inline(always)]
    fn t_min(&self, s: S) -> S::F {
        s.splat(0.0)
    }

    #[inline(always)]
    fn t_max(&self) -> S::F {
        self.light.t_max
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, packet: &Packet<S>, node: &Node, Entry { mask, .. }: Entry<S>) {
        let run = node.first as usize..(node.first + node.count()) as usize;
        let (accel, light) = (self.accel, &mut self.light);
        match node.kind_or_axis() {
            leaf::SPHERE => {
                for ball in &accel.spheres[run] {
                    if let Some(span) = sphere::span(s, packet, ball.center, ball.radius, mask) {
                        light.cross_both(s, &span, accel.transparency(ball.primitive, 0));
                    }
                }
            }
            leaf::BOX => {
                for unit in &accel.boxes[run] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    if let Some(span) = cuboid::span(s, &inside, mask) {
                        light.cross_both(s, &span, accel.transparency(unit.primitive, 0));
                    }
                }
            }
            leaf::ELLIPSOID => {
                for unit in &accel.ellipsoids[run] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    if let Some(span) = sphere::span(s, &inside, [0.0; 3], 1.0, mask) {
                        light.cross_both(s, &span, accel.transparency(unit.primitive, 0));
                    }
                }
            }
            leaf::TRIANGLE => {
                for t in &accel.triangles[run] {
                    if let Some(hit) = triangle::crossing(s, packet, t, mask) {
                        light.cross(s, hit.mask, hit.t, accel.transparency(t.id, 0));
                    }
                }
            }
            _ => {
                for instance in &accel.instances[run] {
                    let inside = packet.transformed(s, &instance.mesh_from_world);
                    let alive = s.and(light.alive, mask);
                    let mut walk = MeshWalk { accel, instance, light: Light { alive, ..*light } };
                    traverse(s, &instance.mesh.bvh.nodes, &inside, &mut walk);
                    // Lanes that went dark inside are dark; those that stayed out keep what they had.
                    let dark = s.and_not(alive, walk.light.alive);
                    light.passes = walk.light.passes;
                    light.alive = s.and_not(light.alive, dark);
                }
            }
        }
    }
}

/// The way through a mesh's tree.
struct MeshWalk<'a, S: Simd> {
    accel: &'a Accel,
    instance: &'a Instance,
    light: Light<S>,
}

impl<S: Simd> Visitor<S> for MeshWalk<'_, S> {
    const NEAREST_FIRST: bool = false;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.light.alive
    }

    #[inline(always)]
    fn t_min(&self, s: S) -> S::F {
        s.splat(0.0)
    }

    #[inline(always)]
    fn t_max(&self) -> S::F {
        self.light.t_max
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, packet: &Packet<S>, node: &Node, Entry { mask, .. }: Entry<S>) {
        let run = node.first as usize..(node.first + node.count()) as usize;
        for t in &self.instance.mesh.triangles[run] {
            if let Some(hit) = triangle::crossing(s, packet, t, mask) {
                let slot = self.instance.mesh.slot(t.id);
                self.light.cross(s, hit.mask, hit.t, self.accel.transparency(self.instance.primitive, slot));
            }
        }
    }
}
