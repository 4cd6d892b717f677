//! Whether anything at all stands between two points.

use super::Accel;
use super::level::SceneLevel;
use super::packet::Packet;
use super::primitives::triangle::Crossing;
use super::primitives::{Span, plane};
use super::rays::{Rays, Receive, Surface};
use super::simd::{Kernel, Simd};
use super::single::One;
use super::stream::{BLOCK, RayBlock, RayStream};
use vitrine_math::Ray;

impl Accel {
    /// Whether each ray meets a surface at `0 < t < t_max`. One answer a ray.
    pub fn occluded(&self, rays: &RayStream, answers: &mut Vec<bool>) {
        answers.clear();
        answers.resize(rays.blocks().len() * BLOCK, false);
        self.instructions.run(Occluded { accel: self, rays: rays.blocks(), answers });
        answers.truncate(rays.len());
    }

    /// The same for rays each on its own. One place in `answers` for each ray; those beyond stay as they are.
    pub fn occluded_each(&self, rays: &[Ray], answers: &mut [bool]) {
        // Eight lanes are all that a single ray can use.
        self.instructions.eight().run(OccludedEach { accel: self, rays, answers });
    }

    /// Which rays in lanes meet a surface. Lanes with `t_max ≤ 0` shoot no ray.
    #[inline(always)]
    fn blocked<S: Rays>(&self, s: S, rays: &Packet<S>, t_max: S::F) -> S::M {
        let all = s.and(s.lt(s.splat(0.0), t_max), rays.in_range(s));
        let mut level = SceneLevel { accel: self, receive: Open { t_max, open: all } };
        for p in &self.planes {
            let t = plane::distance(s, rays, p);
            level.receive.cross(s, all, t);
        }
        s.walk(&self.tree.nodes, rays, &mut level);
        s.and_not(all, level.receive.open)
    }
}

struct Occluded<'a> {
    accel: &'a Accel,
    rays: &'a [RayBlock],
    answers: &'a mut [bool],
}

impl Kernel for Occluded<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Rays>(self, s: S) {
        for (rays, answers) in self.rays.iter().zip(self.answers.chunks_exact_mut(BLOCK)) {
            for start in (0..BLOCK).step_by(S::LANES) {
                let packet = Packet::load(s, rays, start);
                let blocked = self.accel.blocked(s, &packet, s.load(&rays.t_max[start..]));
                let bits = s.bits(blocked);
                for (lane, answer) in answers[start..start + S::LANES].iter_mut().enumerate() {
                    *answer = bits >> lane & 1 != 0;
                }
            }
        }
    }
}

struct OccludedEach<'a> {
    accel: &'a Accel,
    rays: &'a [Ray],
    answers: &'a mut [bool],
}

impl Kernel for OccludedEach<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Rays>(self, s: S) {
        let one = One(s.eight());
        for (ray, answer) in self.rays.iter().zip(self.answers) {
            let alone = Packet::new(one, ray.origin.into(), ray.direction.into());
            *answer = self.accel.blocked(one, &alone, ray.t_max);
        }
    }
}

/// The rays that nothing has stopped yet.
#[derive(Clone, Copy)]
struct Open<S: Simd> {
    t_max: S::F,
    open: S::M,
}

impl<S: Simd> Open<S> {
    #[inline(always)]
    fn cross(&mut self, s: S, mask: S::M, t: S::F) {
        let meets = s.and(mask, s.and(s.lt(s.splat(0.0), t), s.lt(t, self.t_max)));
        self.open = s.and_not(self.open, meets);
    }
}

impl<S: Rays> Receive<S> for Open<S> {
    /// Any surface will do: sorting would take longer than it saves.
    const NEAREST_FIRST: bool = false;
    type Single = Open<One<S::Eight>>;

    #[inline(always)]
    fn active(&self, _: S) -> S::M {
        self.open
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
    fn span(&mut self, s: S, span: &Span<S>, _: S::F, _: u32) {
        self.cross(s, span.mask, span.near);
        self.cross(s, span.mask, span.far);
    }

    #[inline(always)]
    fn crossing(&mut self, s: S, hit: &Crossing<S>, _: S::F, _: Surface) {
        self.cross(s, hit.mask, hit.t);
    }

    #[inline(always)]
    fn narrowed(&self, s: S, mask: S::M) -> Self {
        Self { open: s.and(self.open, mask), ..*self }
    }

    #[inline(always)]
    fn widen(&mut self, s: S, inner: Self, mask: S::M) {
        self.open = s.or(s.and_not(self.open, mask), inner.open);
    }

    #[inline(always)]
    fn single(&self, s: S, lane: usize) -> Self::Single {
        Open { t_max: s.lane(self.t_max, lane), open: true }
    }

    #[inline(always)]
    fn take_single(&mut self, s: S, lane: usize, single: &Self::Single) {
        if !single.open {
            self.open = s.and_not(self.open, s.only(lane));
        }
    }
}
