//! How much light passes along each shadow ray: every surface that it crosses lets its material's transparency through.

use super::Accel;
use super::level::SceneLevel;
use super::packet::Packet;
use super::primitives::triangle::Crossing;
use super::primitives::{Span, plane};
use super::rays::{Rays, Receive, Surface};
use super::simd::{Kernel, Simd};
use super::single::One;
use super::stream::{BLOCK, RayBlock, RayStream};

impl Accel {
    /// The product of the transparencies of all surfaces that each ray crosses at `0 < t < t_max`; 0 as soon as one is
    /// opaque, 1 when there is none. Rays go straight on. One number a ray; places beyond the last ray mean nothing.
    pub fn transmittance(&self, rays: &RayStream, passes: &mut Vec<f32>) {
        passes.clear();
        passes.resize(rays.blocks().len() * BLOCK, 0.0);
        self.instructions.run(Transmittance { accel: self, rays: rays.blocks(), passes });
    }

    /// The same for rays in lanes, inside a kernel. Lanes with `t_max ≤ 0` shoot no ray; their result means nothing.
    #[inline(always)]
    pub fn packet_transmittance<S: Rays>(&self, s: S, packet: &Packet<S>, t_max: S::F) -> S::F {
        // In a function of its own: its loops need all the registers.
        s.call(PacketTransmittance { accel: self, s, packet, t_max })
    }
}

struct PacketTransmittance<'a, S: Rays> {
    accel: &'a Accel,
    s: S,
    packet: &'a Packet<S>,
    t_max: S::F,
}

impl<S: Rays> Kernel for PacketTransmittance<'_, S> {
    type Output = S::F;

    #[inline(always)]
    fn run<E: Rays>(self, _: E) -> S::F {
        let Self { accel, s, packet, t_max } = self;
        let alive = s.and(s.lt(s.splat(0.0), t_max), packet.in_range(s));
        let mut receive = Light { accel, passes: s.splat(1.0), t_max, alive };
        for p in &accel.planes {
            let t = plane::distance(s, packet, p);
            receive.cross(s, receive.alive, t, accel.transparency(p.primitive, 0));
        }
        let mut level = SceneLevel { accel, receive };
        s.walk(&accel.tree.nodes, packet, &mut level);
        level.receive.passes
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
    fn run<S: Rays>(self, s: S) {
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
struct Light<'a, S: Simd> {
    accel: &'a Accel,
    passes: S::F,
    t_max: S::F,
    /// Lanes with light left.
    alive: S::M,
}

impl<S: Simd> Light<'_, S> {
    /// Lets the light of the mask's lanes cross a surface at `t`.
    #[inline(always)]
    fn cross(&mut self, s: S, mask: S::M, t: S::F, transparency: f32) {
        let meets = s.and(mask, s.and(s.lt(s.splat(0.0), t), s.lt(t, self.t_max)));
        self.passes = s.select(meets, s.mul(self.passes, s.splat(transparency)), self.passes);
        if transparency == 0.0 {
            self.alive = s.and_not(self.alive, meets);
        }
    }
}

impl<'a, S: Rays> Receive<S> for Light<'a, S> {
    /// Products must come in one order.
    const NEAREST_FIRST: bool = false;
    type Single = Light<'a, One<S::Eight>>;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.alive
    }

    #[inline(always)]
    fn t_min(&self, s: S) -> S::F {
        s.splat(0.0)
    }

    #[inline(always)]
    fn t_max(&self, _: S) -> S::F {
        self.t_max
    }

    #[inline(always)]
    fn span(&mut self, s: S, span: &Span<S>, _: S::F, primitive: u32) {
        let transparency = self.accel.transparency(primitive, 0);
        self.cross(s, span.mask, span.near, transparency);
        self.cross(s, span.mask, span.far, transparency);
    }

    #[inline(always)]
    fn crossing(&mut self, s: S, hit: &Crossing<S>, _: S::F, surface: Surface) {
        let slot = surface.mesh.map_or(0, |mesh| mesh.slot(surface.triangle));
        self.cross(s, hit.mask, hit.t, self.accel.transparency(surface.primitive, slot));
    }

    #[inline(always)]
    fn narrowed(&self, s: S, mask: S::M) -> Self {
        Self { alive: s.and(self.alive, mask), ..*self }
    }

    #[inline(always)]
    fn widen(&mut self, s: S, inner: Self, mask: S::M) {
        // Lanes that went dark inside are dark; those that stayed out keep what they had.
        let dark = s.and_not(s.and(self.alive, mask), inner.alive);
        self.passes = inner.passes;
        self.alive = s.and_not(self.alive, dark);
    }

    #[inline(always)]
    fn single(&self, s: S, lane: usize) -> Self::Single {
        Light {
            accel: self.accel,
            passes: s.lane(self.passes, lane),
            t_max: s.lane(self.t_max, lane),
            alive: true,
        }
    }

    #[inline(always)]
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single) {
        self.passes = s.with_lane(self.passes, lane, single.passes);
        self.alive = s.and(self.alive, s.lt(s.splat(0.0), self.passes));
    }
}
