//! The nearest hit of each ray of a stream.

use super::Accel;
use super::level::SceneLevel;
use super::packet::Packet;
use super::primitives::triangle::Crossing;
use super::primitives::{Span, plane};
use super::rays::{Rays, Receive, Surface};
use super::simd::{Kernel, Simd};
use super::single::One;
use super::stream::{BLOCK, Column, Hit, HitBlock, HitStream, NOTHING, RayBlock, RayStream};
use vitrine_math::Ray;

impl Accel {
    /// Finds the nearest hit of each ray after its start and before its end.
    ///
    /// Of surfaces at the same distance the one counts that comes first among the scene's primitives, and then among its
    /// mesh's triangles. A hit that rounding puts before the box that holds it counts as at the box. So a hit never depends on
    /// the way through the tree or on the rays beside it: a box is passed over only when all in it is farther.
    pub fn closest(&self, rays: &RayStream, hits: &mut HitStream) {
        hits.blocks.resize(rays.blocks().len(), HitBlock::EMPTY);
        self.instructions.run(Closest { accel: self, rays: rays.blocks(), hits: &mut hits.blocks });
    }

    /// The same for rays each on its own, which is faster where neighbours go different ways. One place in `hits` for each
    /// ray; those beyond stay as they are.
    pub fn closest_each(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        // Eight lanes are all that a single ray can use.
        self.instructions.eight().run(ClosestEach { accel: self, rays, hits });
    }

    /// Finds the nearest hits of rays in lanes.
    #[inline(always)]
    fn find<S: Rays>(&self, s: S, rays: &Packet<S>, mut nearest: Nearest<S>) -> Nearest<S> {
        nearest.active = s.and(nearest.active, rays.in_range(s));
        let mut level = SceneLevel { accel: self, receive: nearest };
        let anywhere = s.splat(f32::NEG_INFINITY);
        for p in &self.planes {
            let hit = Crossing::at(s, level.receive.active, plane::distance(s, rays, p));
            let surface = Surface { primitive: p.primitive, triangle: 0, mesh: None };
            level.receive.crossing(s, &hit, anywhere, surface);
        }
        s.walk(&self.tree.nodes, rays, &mut level);
        level.receive
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
    fn run<S: Rays>(self, s: S) {
        let wide = s.wide();
        for (rays, hits) in self.rays.chunks(2).zip(self.hits.chunks_mut(2)) {
            if let (true, [a, b], [c, e]) = (self.accel.is_coarse, rays, &mut *hits) {
                let o = load_both3(wide, [&a.origin, &b.origin]);
                let d = load_both3(wide, [&a.direction, &b.direction]);
                let nearest = Nearest::load_both(wide, [a, b]);
                self.accel.find(wide, &Packet::new(wide, o, d), nearest).store_both(wide, [c, e]);
                continue;
            }
            for (rays, hits) in rays.iter().zip(hits) {
                for start in (0..BLOCK).step_by(S::LANES) {
                    let packet = Packet::load(s, rays, start);
                    self.accel.find(s, &packet, Nearest::load(s, rays, start)).store(s, hits, start);
                }
            }
        }
    }
}

struct ClosestEach<'a> {
    accel: &'a Accel,
    rays: &'a [Ray],
    hits: &'a mut [Option<Hit>],
}

impl Kernel for ClosestEach<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Rays>(self, s: S) {
        let one = One(s.eight());
        for (ray, hit) in self.rays.iter().zip(self.hits) {
            let alone = Packet::new(one, ray.origin.into(), ray.direction.into());
            *hit = self.accel.find(one, &alone, Nearest::new(one, ray.t_max)).hit();
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
    /// Nothing yet, for rays that start at their origins.
    #[inline(always)]
    fn new(s: S, t_max: S::F) -> Self {
        let (zero, nothing) = (s.splat(0.0), s.splat(f32::from_bits(NOTHING)));
        Self {
            t: t_max,
            primitive: nothing,
            triangle: zero,
            u: zero,
            v: zero,
            start_t: zero,
            start_primitive: nothing,
            start_triangle: nothing,
            active: s.lt(zero, t_max),
        }
    }

    #[inline(always)]
    fn load(s: S, rays: &RayBlock, start: usize) -> Self {
        Self {
            start_t: s.load(&rays.start_t[start..]),
            start_primitive: s.load(&rays.start_primitive[start..]),
            start_triangle: s.load(&rays.start_triangle[start..]),
            ..Self::new(s, s.load(&rays.t_max[start..]))
        }
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

/// The columns of two blocks, side by side.
#[inline(always)]
fn load_both<S: Simd>(s: S, [a, b]: [&Column; 2]) -> S::F {
    let mut lanes = [0.0; 2 * BLOCK];
    lanes[..BLOCK].copy_from_slice(a);
    lanes[BLOCK..].copy_from_slice(b);
    s.load(&lanes)
}

/// Three components of two blocks.
#[inline(always)]
fn load_both3<S: Simd>(s: S, [a, b]: [&[Column; 3]; 2]) -> [S::F; 3] {
    [load_both(s, [&a[0], &b[0]]), load_both(s, [&a[1], &b[1]]), load_both(s, [&a[2], &b[2]])]
}

impl<S: Simd> Nearest<S> {
    #[inline(always)]
    fn load_both(s: S, [a, b]: [&RayBlock; 2]) -> Self {
        Self {
            start_t: load_both(s, [&a.start_t, &b.start_t]),
            start_primitive: load_both(s, [&a.start_primitive, &b.start_primitive]),
            start_triangle: load_both(s, [&a.start_triangle, &b.start_triangle]),
            ..Self::new(s, load_both(s, [&a.t_max, &b.t_max]))
        }
    }

    #[inline(always)]
    fn store_both(&self, s: S, [c, d]: [&mut HitBlock; 2]) {
        store_split(s, self.t, &mut c.t, &mut d.t);
        store_split(s, self.primitive, &mut c.primitive, &mut d.primitive);
        store_split(s, self.triangle, &mut c.triangle, &mut d.triangle);
        store_split(s, self.u, &mut c.u, &mut d.u);
        store_split(s, self.v, &mut c.v, &mut d.v);
    }
}

/// Into the columns of two blocks.
#[inline(always)]
fn store_split<S: Simd>(s: S, v: S::F, a: &mut Column, b: &mut Column) {
    let mut lanes = [0.0; 2 * BLOCK];
    s.store(v, &mut lanes);
    a.copy_from_slice(&lanes[..BLOCK]);
    b.copy_from_slice(&lanes[BLOCK..]);
}

/// Whether one triangle of a primitive comes before another.
#[inline(always)]
fn precedes<S: Simd>(s: S, [primitive, triangle]: [S::F; 2], [of_primitive, of_triangle]: [S::F; 2]) -> S::M {
    let same = s.and(s.eq(primitive, of_primitive), s.lt(triangle, of_triangle));
    s.or(s.lt(primitive, of_primitive), same)
}

impl<E: Simd> Nearest<One<E>> {
    #[inline(always)]
    fn hit(&self) -> Option<Hit> {
        (self.primitive.to_bits() != NOTHING).then(|| Hit {
            t: self.t,
            primitive: self.primitive.to_bits(),
            triangle: self.triangle.to_bits(),
            uv: [self.u, self.v],
        })
    }
}

impl<S: Rays> Receive<S> for Nearest<S> {
    const NEAREST_FIRST: bool = true;
    type Single = Nearest<One<S::Eight>>;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.active
    }

    #[inline(always)]
    fn t_min(&self, _: S) -> S::F {
        self.start_t
    }

    #[inline(always)]
    fn t_max(&self, _: S) -> S::F {
        self.t
    }

    /// Offers the first crossing after the start.
    #[inline(always)]
    fn span(&mut self, s: S, span: &Span<S>, from: S::F, primitive: u32) {
        let id = s.splat(f32::from_bits(primitive));
        let entry = s.max(from, span.near);
        let enters = s.and(s.lt(s.splat(0.0), span.near), self.is_after_start(s, entry, id, s.splat(0.0)));
        let t = s.select(enters, span.near, span.far);
        self.offer(s, &Crossing::at(s, span.mask, t), from, [primitive, 0]);
    }

    #[inline(always)]
    fn crossing(&mut self, s: S, hit: &Crossing<S>, from: S::F, surface: Surface) {
        self.offer(s, hit, from, [surface.primitive, surface.triangle]);
    }

    #[inline(always)]
    fn narrowed(&self, _: S, mask: S::M) -> Self {
        Self { active: mask, ..*self }
    }

    #[inline(always)]
    fn widen(&mut self, _: S, inner: Self, _: S::M) {
        *self = Self { active: self.active, ..inner };
    }

    #[inline(always)]
    fn single(&self, s: S, lane: usize) -> Self::Single {
        Nearest {
            t: s.lane(self.t, lane),
            primitive: s.lane(self.primitive, lane),
            triangle: s.lane(self.triangle, lane),
            u: s.lane(self.u, lane),
            v: s.lane(self.v, lane),
            start_t: s.lane(self.start_t, lane),
            start_primitive: s.lane(self.start_primitive, lane),
            start_triangle: s.lane(self.start_triangle, lane),
            active: true,
        }
    }

    #[inline(always)]
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single) {
        self.t = s.with_lane(self.t, lane, single.t);
        self.primitive = s.with_lane(self.primitive, lane, single.primitive);
        self.triangle = s.with_lane(self.triangle, lane, single.triangle);
        self.u = s.with_lane(self.u, lane, single.u);
        self.v = s.with_lane(self.v, lane, single.v);
    }
}
