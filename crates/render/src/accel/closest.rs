//! The nearest hit of each ray of a stream.

use super::bvh::Node;
use super::packet::{Entry, Packet, Visitor, traverse};
use super::primitives::triangle::Crossing;
use super::primitives::{Span, cuboid, plane, sphere, triangle};
use super::simd::{Kernel, Simd};
use super::stream::{BLOCK, HitBlock, HitStream, NOTHING, RayBlock, RayStream};
use super::{Accel, Instance, leaf};

impl Accel {
    /// Finds the nearest hit of each ray after its start and before its end.
    ///
    /// Of surfaces at the same distance the one counts that comes first among the scene's primitives, and then among its
    /// mesh's triangles. A hit that rounding puts before the box that holds it counts as at the box. So a hit never depends on
    /// the way through the tree or on the rays beside it: a box is passed over only when all in it is farther.
    pub fn closest(&self, rays: &RayStream, hits: &mut HitStream) {
        hits.blocks.resize(rays.blocks.len(), HitBlock::EMPTY);
        self.instructions.run(Closest { accel: self, rays: &rays.blocks, hits: &mut hits.blocks });
    }
}

struct Closest<'a> {
    accel: &'a Accel,
    rays: &'a [RayBlock],
    hits: &'a mut [HitBlock],
}

impl Kernel for Closest<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        for (rays, hits) in self.rays.iter().zip(self.hits) {
            for start in (0..BLOCK).step_by(S::LANES) {
                let packet = Packet::load(s, rays, start);
                let mut nearest = Nearest::new(s, rays, start);
                let anywhere = s.splat(f32::NEG_INFINITY);
                for p in &self.accel.planes {
                    let t = plane::distance(s, &packet, p);
                    let hit = Crossing::at(s, nearest.active, t);
                    nearest.offer(s, &hit, anywhere, [p.primitive, 0]);
                }
                let mut walk = Walk { accel: self.accel, nearest };
                traverse(s, &self.accel.bvh.nodes, &packet, &mut walk);
                walk.nearest.store(s, hits, start);
            }
        }
    }
}

/// The nearest hits so far, in lanes. Integers travel as the bits of floats: they are only moved, and compared when two
/// distances are equal; the bits of positive floats order as the integers do.
#[derive(Clone, Copy)]
struct Nearest<S: Simd> {
    t: S::F,
    primitive: S::F,
    triangle: S::F,
    u: S::F,
    v: S::F,
    start_t: S::F,
    start_primitive: S::F,
    start_triangle: S::F,
    active: S::M,
}

impl<S: Simd> Nearest<S> {
    #[inline(always)]
    fn new(s: S, rays: &RayBlock, start: usize) -> Self {
        let zero = s.splat(0.0);
        let t = s.load(&rays.t_max[start..]);
        Self {
            t,
            primitive: s.splat(f32::from_bits(NOTHING)),
            triangle: zero,
            u: zero,
            v: zero,
            start_t: s.load(&rays.start_t[start..]),
            start_primitive: s.load(&rays.start_primitive[start..]),
            start_triangle: s.load(&rays.start_triangle[start..]),
            active: s.lt(zero, t),
        }
    }

    /// Offers the first crossing of a closed form after the start.
    #[inline(always)]
    fn offer_span(&mut self, s: S, span: &Span<S>, from: S::F, primitive: u32) {
        let id = s.splat(f32::from_bits(primitive));
        let entry = s.max(from, span.near);
        let enters = s.and(s.lt(s.splat(0.0), span.near), self.is_after_start(s, entry, id, s.splat(0.0)));
        let t = s.select(enters, span.near, span.far);
        self.offer(s, &Crossing::at(s, span.mask, t), from, [primitive, 0]);
    }

    /// Takes a hit of a triangle of a primitive in the lanes of its mask where it is nearer, or as near and of an earlier
    /// primitive. It counts as no nearer than `from`.
    #[inline(always)]
    fn offer(&mut self, s: S, hit: &Crossing<S>, from: S::F, [primitive, triangle]: [u32; 2]) {
        let id = s.splat(f32::from_bits(primitive));
        let sub = s.splat(f32::from_bits(triangle));
        // In this order of the two a NaN stays one.
        let t = s.max(from, hit.t);
        let mask = s.and(hit.mask, s.lt(s.splat(0.0), hit.t));
        let mut take = s.and(mask, s.lt(t, self.t));
        let ties = s.and(mask, s.eq(t, self.t));
        if s.any(ties) {
            // A ray's own end, with nothing hit, is no tie.
            let something = s.lt(self.primitive, s.splat(f32::from_bits(NOTHING)));
            let earlier = precedes(s, [id, sub], [self.primitive, self.triangle]);
            take = s.or(take, s.and(ties, s.and(something, earlier)));
        }
        if !s.any(take) {
            return;
        }
        let take = s.and(take, self.is_after_start(s, t, id, sub));
        self.t = s.select(take, t, self.t);
        self.primitive = s.select(take, id, self.primitive);
        self.triangle = s.select(take, sub, self.triangle);
        self.u = s.select(take, hit.u, self.u);
        self.v = s.select(take, hit.v, self.v);
    }

    /// Whether hits lie after the rays' starts.
    #[inline(always)]
    fn is_after_start(&self, s: S, t: S::F, primitive: S::F, triangle: S::F) -> S::M {
        let after = s.lt(self.start_t, t);
        let ties = s.eq(self.start_t, t);
        if !s.any(ties) {
            return after;
        }
        let later = precedes(s, [self.start_primitive, self.start_triangle], [primitive, triangle]);
        s.or(after, s.and(ties, later))
    }

    #[inline(always)]
    fn store(&self, s: S, hits: &mut HitBlock, start: usize) {
        s.store(self.t, &mut hits.t[start..]);
        s.store(self.primitive, &mut hits.primitive[start..]);
        s.store(self.triangle, &mut hits.triangle[start..]);
        s.store(self.u, &mut hits.u[start..]);
        s.store(self.v, &mut hits.v[start..]);
    }
}

/// Whether one triangle of a primitive comes before another.
#[inline(always)]
fn precedes<S: Simd>(s: S, [primitive, triangle]: [S::F; 2], [of_primitive, of_triangle]: [S::F; 2]) -> S::M {
    let same = s.and(s.eq(primitive, of_primitive), s.lt(triangle, of_triangle));
    s.or(s.lt(primitive, of_primitive), same)
}

/// The way through the scene's tree.
struct Walk<'a, S: Simd> {
    accel: &'a Accel,
    nearest: Nearest<S>,
}

impl<S: Simd> Visitor<S> for Walk<'_, S> {
    const NEAREST_FIRST: bool = true;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.nearest.active
    }

    #[inline(always)]
    fn t_min(&self, _: S) -> S::F {
        self.nearest.start_t
    }

    #[inline(always)]
    fn t_max(&self) -> S::F {
        self.nearest.t
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, packet: &Packet<S>, node: &Node, Entry { mask, near }: Entry<S>) {
        let run = node.first as usize..(node.first + node.count()) as usize;
        let (accel, nearest) = (self.accel, &mut self.nearest);
        match node.kind_or_axis() {
            leaf::SPHERE => {
                for ball in &accel.spheres[run] {
                    if let Some(span) = sphere::span(s, packet, ball.center, ball.radius, mask) {
                        nearest.offer_span(s, &span, near, ball.primitive);
                    }
                }
            }
            leaf::BOX => {
                for unit in &accel.boxes[run] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    if let Some(span) = cuboid::span(s, &inside, mask) {
                        nearest.offer_span(s, &span, near, unit.primitive);
                    }
                }
            }
            leaf::ELLIPSOID => {
                for unit in &accel.ellipsoids[run] {
                    let inside = packet.transformed(s, &unit.unit_from_world);
                    if let Some(span) = sphere::span(s, &inside, [0.0; 3], 1.0, mask) {
                        nearest.offer_span(s, &span, near, unit.primitive);
                    }
                }
            }
            leaf::TRIANGLE => {
                for t in &accel.triangles[run] {
                    if let Some(hit) = triangle::crossing(s, packet, t, mask) {
                        nearest.offer(s, &hit, near, [t.id, 0]);
                    }
                }
            }
            _ => {
                for instance in &accel.instances[run] {
                    let inside = packet.transformed(s, &instance.mesh_from_world);
                    let mut walk = MeshWalk { instance, from: near, nearest: *nearest };
                    walk.nearest.active = mask;
                    traverse(s, &instance.mesh.bvh.nodes, &inside, &mut walk);
                    let active = nearest.active;
                    *nearest = Nearest { active, ..walk.nearest };
                }
            }
        }
    }
}

/// The way through a mesh's tree.
struct MeshWalk<'a, S: Simd> {
    instance: &'a Instance,
    /// Where the rays enter the instance's box.
    from: S::F,
    nearest: Nearest<S>,
}

impl<S: Simd> Visitor<S> for MeshWalk<'_, S> {
    const NEAREST_FIRST: bool = true;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.nearest.active
    }

    #[inline(always)]
    fn t_min(&self, _: S) -> S::F {
        self.nearest.start_t
    }

    #[inline(always)]
    fn t_max(&self) -> S::F {
        self.nearest.t
    }

    #[inline(always)]
    fn leaf(&mut self, s: S, packet: &Packet<S>, node: &Node, Entry { mask, near }: Entry<S>) {
        let run = node.first as usize..(node.first + node.count()) as usize;
        for t in &self.instance.mesh.triangles[run] {
            if let Some(hit) = triangle::crossing(s, packet, t, mask) {
                let from = s.max(self.from, near);
                self.nearest.offer(s, &hit, from, [self.instance.primitive, t.id]);
            }
        }
    }
}
