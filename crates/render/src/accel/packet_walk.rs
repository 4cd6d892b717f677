//! Packets on their way through a tree. The children of a node are tested at once against the whole packet, by interval
//! arithmetic; those that it may meet are tested ray by ray; where few rays are left, each goes on alone.
//!
//! Boulos, Wald and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006; Benthin, Wald, Woop,
//! Ernst and Mark, "Combining Single and Packet-Ray Tracing for Arbitrary Ray Distributions on the Intel MIC Architecture", 2012.

use super::packet::{FAR_ROUNDED_UP, Packet};
use super::rays::{Level, Rays, Receive};
use super::simd::{Kernel, Simd};
use super::single::{One, walk_alone};
use super::stack::{Room, Stack};
use super::tree::{Node, WIDTH};

/// Of so many lanes one ray may be left before it goes on alone.
const LANES_FOR_ONE: usize = 4;

/// Bounds of a packet's rays, each in all lanes.
struct Beam<E: Simd> {
    /// For each axis the origin from which boxes seem nearest, and that from which they seem farthest.
    near_o: [E::F; 3],
    far_o: [E::F; 3],
    /// The least and the greatest inverse of the directions; both 0 where the rays do not agree on the sign.
    inv: [[E::F; 2]; 3],
    /// What is added to the far sides: ∞ where the rays do not agree on the sign.
    slack: [E::F; 3],
    /// The rows of the near sides; their neighbours are the far sides.
    near_rows: [usize; 3],
    t_min: E::F,
}

impl<E: Simd> Beam<E> {
    #[inline(always)]
    fn new<S: Rays<Eight = E>>(s: S, packet: &Packet<S>, active: S::M, t_min: S::F) -> Self {
        let e = s.eight();
        let zero = e.splat(0.0);
        let mut beam = Self {
            near_o: [zero; 3],
            far_o: [zero; 3],
            inv: [[zero; 2]; 3],
            slack: [zero; 3],
            near_rows: [0; 3],
            t_min: e.splat(least(s, t_min, active)),
        };
        for k in 0..3 {
            let (low, high) = (least(s, packet.o[k], active), greatest(s, packet.o[k], active));
            let (slow, fast) = (least(s, packet.inv[k], active), greatest(s, packet.inv[k], active));
            if slow > 0.0 {
                (beam.near_o[k], beam.far_o[k]) = (e.splat(high), e.splat(low));
            } else {
                (beam.near_o[k], beam.far_o[k]) = (e.splat(low), e.splat(high));
            }
            beam.near_rows[k] = 2 * k + usize::from(slow <= 0.0);
            if slow > 0.0 || fast < 0.0 {
                beam.inv[k] = [e.splat(slow), e.splat(fast)];
            } else {
                beam.slack[k] = e.splat(f32::INFINITY);
            }
        }
        beam
    }

    /// The children that some ray may meet before `t_max`, a bit for each, and where none can enter them earlier. Rounding
    /// keeps order, so the bounds hold for what [`Packet::meets_box`] computes.
    #[inline(always)]
    fn meets(&self, e: E, node: &Node, t_max: f32) -> (u32, E::F) {
        let mut near = self.t_min;
        let mut far = e.splat(f32::INFINITY);
        for k in 0..3 {
            let [slow, fast] = self.inv[k];
            let to_near = e.sub(e.load(&node.rows[self.near_rows[k] % WIDTH]), self.near_o[k]);
            let to_far = e.sub(e.load(&node.rows[(self.near_rows[k] ^ 1) % WIDTH]), self.far_o[k]);
            near = e.max(near, e.min(e.mul(to_near, slow), e.mul(to_near, fast)));
            let farthest = e.max(e.mul(to_far, slow), e.mul(to_far, fast));
            far = e.min(far, e.add(farthest, self.slack[k]));
        }
        let far = e.min(e.mul(far, e.splat(FAR_ROUNDED_UP)), e.splat(t_max));
        (e.bits(e.le(near, far)), near)
    }
}

#[inline(always)]
fn least<S: Simd>(s: S, v: S::F, active: S::M) -> f32 {
    s.least(s.select(active, v, s.splat(f32::INFINITY)))
}

#[inline(always)]
fn greatest<S: Simd>(s: S, v: S::F, active: S::M) -> f32 {
    s.greatest(s.select(active, v, s.splat(f32::NEG_INFINITY)))
}

/// A child that the packet may meet: a node and a place in it.
#[derive(Clone, Copy)]
struct Waiting {
    near: f32,
    node: u32,
    place: u32,
}

/// Takes a packet through a tree.
#[inline(always)]
pub fn walk_together<S: Rays, L: Level<S>>(s: S, nodes: &[Node], packet: &Packet<S>, level: &mut L) {
    let active = level.receive().active(s);
    if nodes.is_empty() || !s.any(active) {
        return;
    }
    let beam = Beam::new(s, packet, active, level.receive().t_min(s));
    let mut room = Room::<Waiting>::new();
    let mut stack = room.stack();
    let mut node = 0_u32;
    loop {
        let t_max = greatest(s, level.receive().t_max(s), level.receive().active(s));
        let (bits, near) = beam.meets(s.eight(), &nodes[node as usize], t_max);
        let mut distances = [0.0; WIDTH];
        s.eight().store(near, &mut distances);
        push::<S, L::Receive>(node, bits, &distances, &mut stack);
        node = loop {
            let Some(next) = stack.pop() else { return };
            let (from, place) = (&nodes[next.node as usize], next.place as usize);
            let receive = level.receive();
            let mut entry = packet.meets_box(s, from, place, [receive.t_min(s), receive.t_max(s)]);
            entry.mask = s.and(receive.active(s), entry.mask);
            let lanes = s.bits(entry.mask);
            if lanes == 0 {
                continue;
            }
            let child = from.child(place);
            if child.is_leaf() {
                level.leaf(s, packet, child, entry);
            } else if lanes.count_ones() as usize * LANES_FOR_ONE <= S::LANES {
                s.eight().call(Alone { s, nodes, packet, level, lanes, root: child.first });
            } else {
                break child.first;
            }
            if !s.any(level.receive().active(s)) {
                return;
            }
        };
    }
}

/// Puts children onto the stack, the first to be visited on top.
#[inline(always)]
fn push<S: Rays, R: Receive<S>>(
    node: u32,
    mut bits: u32,
    distances: &[f32; WIDTH],
    stack: &mut Stack<Waiting>,
) {
    let bottom = stack.len();
    while bits != 0 {
        let place = 31 - bits.leading_zeros();
        bits &= !(1 << place);
        let near = distances[place as usize % WIDTH];
        stack.push(Waiting { near, node, place });
        if R::NEAREST_FIRST {
            stack.sink(bottom, |below, value| below.near < value.near);
        }
    }
}

/// Some rays of a packet, each on its own from a node on.
struct Alone<'a, S: Rays, L> {
    s: S,
    nodes: &'a [Node],
    packet: &'a Packet<S>,
    level: &'a mut L,
    lanes: u32,
    root: u32,
}

impl<S: Rays, L: Level<S>> Kernel for Alone<'_, S, L> {
    type Output = ();

    #[inline(always)]
    fn run<E: Simd>(self, _: E) {
        let Self { s, nodes, packet, level, mut lanes, root } = self;
        let one = One(s.eight());
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize;
            lanes &= lanes - 1;
            let ray = Packet::new(one, lane3(s, &packet.o, lane), lane3(s, &packet.d, lane));
            let mut single = level.single(s, lane);
            walk_alone(one, nodes, &ray, &mut single, root);
            level.take_single(s, lane, &single);
        }
    }
}

#[inline(always)]
fn lane3<S: Simd>(s: S, v: &[S::F; 3], lane: usize) -> [f32; 3] {
    [s.lane(v[0], lane), s.lane(v[1], lane), s.lane(v[2], lane)]
}
