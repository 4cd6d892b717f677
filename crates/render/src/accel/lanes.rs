//! Packets at the leaves: many rays against blocks of triangles and balls.

use super::beam::{Beam, greatest};
use super::packet::{Entry, Packet, splat3};
use super::packet_walk::walk_together;
use super::primitives::sphere;
use super::primitives::triangle::{BLOCK_TRIANGLES, Crossing, ORDER, Sheared, fastest_axis, inside, normal};
use super::rays::{Bundle, Level, Rays, Receive, SphereLeaf, TriangleLeaf};
#[cfg(target_arch = "x86_64")]
use super::simd::{Avx2, Avx512};
use super::simd::{Portable, Simd};
use super::tree::Node;
use super::wide::Pair;

/// So many rays are tested against a block one by one, more of them all at once against one triangle after the other.
const FEW: u32 = 4;
/// The most rays in a packet.
const MOST_LANES: usize = 32;

macro_rules! packets {
    ($unit:ty, $eight:ty, $wide:ty, |$s:ident| $token:expr, $wider:expr) => {
        impl Rays for $unit {
            type Eight = $eight;
            type Beam = Beam<$eight>;
            type Wide = $wide;

            #[inline(always)]
            fn eight(self) -> $eight {
                let $s = self;
                $token
            }

            #[inline(always)]
            fn wide(self) -> $wide {
                let $s = self;
                $wider
            }

            #[inline(always)]
            fn triangles<R: Receive<Self>>(
                self,
                rays: &Bundle<Self>,
                leaf: &TriangleLeaf,
                entry: Entry<Self>,
                receive: &mut R,
            ) {
                triangles(self, rays, leaf, entry, receive);
            }

            #[inline(always)]
            fn spheres<R: Receive<Self>>(
                self,
                packet: &Packet<Self>,
                leaf: &SphereLeaf,
                entry: Entry<Self>,
                receive: &mut R,
            ) {
                spheres(self, packet, leaf, entry, receive);
            }

            #[inline(always)]
            fn walk<L: Level<Self>>(self, nodes: &[Node], packet: &Packet<Self>, level: &mut L) {
                walk_together(self, nodes, packet, level);
            }
        }
    };
}

packets!(Portable, Self, Pair<Pair<Self>>, |s| s, Pair(Pair(s)));
#[cfg(target_arch = "x86_64")]
packets!(Avx2, Self, Pair<Pair<Self>>, |s| s, Pair(Pair(s)));
#[cfg(target_arch = "x86_64")]
packets!(Avx512, Avx2, Pair<Self>, |s| s.narrow(), Pair(s));

/// Many rays, or few, against a block of triangles.
#[inline(always)]
pub fn triangles<S, R>(s: S, rays: &Bundle<S>, leaf: &TriangleLeaf, entry: Entry<S>, receive: &mut R)
where
    S: Rays<Beam = Beam<<S as Rays>::Eight>>,
    R: Receive<S>,
{
    if s.bits(entry.mask).count_ones() <= FEW {
        one_by_one(s, rays.packet, leaf, entry, receive);
        return;
    }
    let e = s.eight();
    let [a, b, c] = &leaf.block.corners;
    let (mut low, mut high) = ([e.splat(0.0); 3], [e.splat(0.0); 3]);
    for k in 0..3 {
        let (a, b, c) = (e.load(&a[k]), e.load(&b[k]), e.load(&c[k]));
        (low[k], high[k]) = (e.min(e.min(a, b), c), e.max(e.max(a, b), c));
    }
    let t_max = greatest(s, receive.t_max(s), entry.mask);
    let near = rays.beam.meets_boxes(e, [low, high], t_max) & ((1 << leaf.count) - 1);
    let fastest = rays.packet.fastest(s);
    for (axis, &fastest) in fastest.iter().enumerate() {
        let mask = s.and(entry.mask, fastest);
        if !s.any(mask) {
            continue;
        }
        let ray = rays.packet.sheared(s, axis);
        let mut near = near;
        while near != 0 {
            let place = near.trailing_zeros() as usize;
            near &= near - 1;
            let corners = [corner(s, a, axis, place), corner(s, b, axis, place), corner(s, c, axis, place)];
            if let Some(inside) = inside(s, &ray, &corners, mask) {
                let hit = inside.crossing(s, &ray, &normal(s, &corners));
                receive.crossing(s, &hit, entry.near, leaf.surface(place));
            }
        }
    }
}

/// One corner of a triangle for all rays, its components in the order of an axis.
#[inline(always)]
fn corner<S: Simd>(s: S, corners: &[[f32; BLOCK_TRIANGLES]; 3], axis: usize, place: usize) -> [S::F; 3] {
    let [x, y, z] = ORDER[axis];
    let place = place % BLOCK_TRIANGLES;
    [s.splat(corners[x][place]), s.splat(corners[y][place]), s.splat(corners[z][place])]
}

/// Each ray against all triangles at once.
#[inline(always)]
fn one_by_one<S: Rays, R: Receive<S>>(
    s: S,
    packet: &Packet<S>,
    leaf: &TriangleLeaf,
    entry: Entry<S>,
    receive: &mut R,
) {
    let e = s.eight();
    let mut o = [[0.0; MOST_LANES]; 3];
    let mut d = [[0.0; MOST_LANES]; 3];
    let mut inv = [[0.0; MOST_LANES]; 3];
    for k in 0..3 {
        s.store(packet.o[k], &mut o[k]);
        s.store(packet.d[k], &mut d[k]);
        s.store(packet.inv[k], &mut inv[k]);
    }
    let mut lanes = s.bits(entry.mask);
    while lanes != 0 {
        let lane = lanes.trailing_zeros() as usize % MOST_LANES;
        lanes &= lanes - 1;
        let axis = fastest_axis([d[0][lane], d[1][lane], d[2][lane]]);
        let [x, y, z] = ORDER[axis];
        let slope = inv[z][lane];
        let ray = Sheared {
            o: splat3(e, [o[x][lane], o[y][lane], o[z][lane]]),
            d: splat3(e, [d[x][lane], d[y][lane], d[z][lane]]),
            slope: [e.splat(d[x][lane] * slope), e.splat(d[y][lane] * slope)],
            inv: splat3(e, [inv[x][lane], inv[y][lane], slope]),
        };
        let Some((mut bits, hits)) = leaf.crossed(e, &ray, axis, s.lane(receive.t_max(s), lane)) else {
            continue;
        };
        let mask = s.only(lane);
        while bits != 0 {
            let place = bits.trailing_zeros() as usize % BLOCK_TRIANGLES;
            bits &= bits - 1;
            let [t, u, v] = [s.splat(hits[0][place]), s.splat(hits[1][place]), s.splat(hits[2][place])];
            receive.crossing(s, &Crossing { mask, t, u, v }, entry.near, leaf.surface(place));
        }
    }
}

/// Many rays against the balls of a block, one after the other.
#[inline(always)]
pub fn spheres<S: Rays, R: Receive<S>>(
    s: S,
    packet: &Packet<S>,
    leaf: &SphereLeaf,
    entry: Entry<S>,
    receive: &mut R,
) {
    for place in 0..leaf.count {
        let [x, y, z] = &leaf.block.centers;
        let center = splat3(s, [x[place], y[place], z[place]]);
        let radius = s.splat(leaf.block.radii[place]);
        if let Some(span) = sphere::span(s, packet, &center, radius, entry.mask) {
            receive.span(s, &span, entry.near, leaf.block.primitives[place]);
        }
    }
}
