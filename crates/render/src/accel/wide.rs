//! Two packets as one with twice the lanes: what is worked out once for a packet, such as its beam and its way through the tree,
//! is worked out half as often.

use super::beam::Beam;
use super::lanes;
use super::packet::{Entry, Packet};
use super::packet_walk::walk_together;
use super::rays::{Bundle, Level, Rays, Receive, SphereLeaf, TriangleLeaf};
use super::simd::{Kernel, Simd};
use super::tree::Node;

/// Lanes of two packets, those of the first first; 32 at most.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S>(pub S);

macro_rules! both {
    ($($name:ident($($arg:ident),*) -> $out:ident;)*) => {$(
        #[inline(always)]
        fn $name(self, $($arg: Self::F),*) -> Self::$out {
            (self.0.$name($($arg.0),*), self.0.$name($($arg.1),*))
        }
    )*};
    ($($name:ident of masks;)*) => {$(
        #[inline(always)]
        fn $name(self, a: Self::M, b: Self::M) -> Self::M {
            (self.0.$name(a.0, b.0), self.0.$name(a.1, b.1))
        }
    )*};
}

impl<S: Simd> Simd for Pair<S> {
    const LANES: usize = 2 * S::LANES;
    type F = (S::F, S::F);
    type M = (S::M, S::M);
    type Order = [u8; 32];

    both! {
        add(a, b) -> F;
        sub(a, b) -> F;
        mul(a, b) -> F;
        div(a, b) -> F;
        sqrt(a) -> F;
        abs(a) -> F;
        floor(a) -> F;
        min(a, b) -> F;
        max(a, b) -> F;
        step(a, b) -> F;
        lt(a, b) -> M;
        le(a, b) -> M;
        eq(a, b) -> M;
        pow_unit(a, b) -> F;
    }
    both! {
        and of masks;
        or of masks;
        and_not of masks;
    }

    #[inline(always)]
    fn splat(self, v: f32) -> Self::F {
        (self.0.splat(v), self.0.splat(v))
    }
    #[inline(always)]
    fn load(self, from: &[f32]) -> Self::F {
        (self.0.load(from), self.0.load(&from[S::LANES..]))
    }
    #[inline(always)]
    fn store(self, v: Self::F, to: &mut [f32]) {
        self.0.store(v.0, to);
        self.0.store(v.1, &mut to[S::LANES..]);
    }
    #[inline(always)]
    fn select(self, mask: Self::M, yes: Self::F, no: Self::F) -> Self::F {
        (self.0.select(mask.0, yes.0, no.0), self.0.select(mask.1, yes.1, no.1))
    }
    #[inline(always)]
    fn bits(self, mask: Self::M) -> u32 {
        self.0.bits(mask.0) | self.0.bits(mask.1) << S::LANES
    }
    #[inline(always)]
    fn packed(self, mask: Self::M, shift: usize) -> [u8; 32] {
        let mut bits = self.bits(mask);
        let mut order = [0; 32];
        let mut rank = shift;
        while bits != 0 {
            order[rank % Self::LANES] = bits.trailing_zeros() as u8;
            bits &= bits - 1;
            rank += 1;
        }
        order
    }
    #[inline(always)]
    fn permute(self, v: Self::F, order: [u8; 32]) -> Self::F {
        let mut lanes = [0.0; 32];
        self.store(v, &mut lanes);
        self.load(&order.map(|lane| lanes[usize::from(lane % 32)]))
    }
    #[inline(always)]
    fn call<K: Kernel>(self, kernel: K) -> K::Output {
        self.0.call(kernel)
    }
    #[inline(always)]
    fn least(self, v: Self::F) -> f32 {
        self.0.least(self.0.min(v.0, v.1))
    }
    #[inline(always)]
    fn greatest(self, v: Self::F) -> f32 {
        self.0.greatest(self.0.max(v.0, v.1))
    }
    #[inline(always)]
    fn lane(self, v: Self::F, lane: usize) -> f32 {
        self.0.lane(if lane < S::LANES { v.0 } else { v.1 }, lane % S::LANES)
    }
    #[inline(always)]
    fn only(self, lane: usize) -> Self::M {
        let (one, none) = (self.0.only(lane % S::LANES), self.0.lt(self.0.splat(0.0), self.0.splat(0.0)));
        if lane < S::LANES { (one, none) } else { (none, one) }
    }
}

impl<S: Rays<Beam = Beam<<S as Rays>::Eight>>> Rays for Pair<S> {
    type Eight = S::Eight;
    type Beam = S::Beam;
    type Wide = Self;

    #[inline(always)]
    fn eight(self) -> S::Eight {
        self.0.eight()
    }

    #[inline(always)]
    fn wide(self) -> Self {
        self
    }

    #[inline(always)]
    fn triangles<R: Receive<Self>>(
        self,
        rays: &Bundle<Self>,
        leaf: &TriangleLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        lanes::triangles(self, rays, leaf, entry, receive);
    }

    #[inline(always)]
    fn spheres<R: Receive<Self>>(
        self,
        packet: &Packet<Self>,
        leaf: &SphereLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        lanes::spheres(self, packet, leaf, entry, receive);
    }

    #[inline(always)]
    fn walk<L: Level<Self>>(self, nodes: &[Node], packet: &Packet<Self>, level: &mut L) {
        walk_together(self, nodes, packet, level);
    }
}
