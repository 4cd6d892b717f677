//! Packets on their way through a tree. The children of a node are tested at once against the beam around the packet; those
//! that it may meet are tested ray by ray; where few rays are left, each goes on alone.
//!
//! Benthin, Wald, Woop, Ernst and Mark, "Combining Single and Packet-Ray Tracing for Arbitrary Ray Distributions on the Intel
//! MIC Architecture", 2012.

use super::beam::{Beam, greatest};
use super::packet::Packet;
use super::rays::{Bundle, Level, Rays, Receive};
use super::simd::{Kernel, Simd};
use super::single::{One, walk_alone};
use super::stack::{Room, Stack};
use super::tree::{Node, WIDTH};

/// What it costs to test a box against sixteen rays, and a node with its eight boxes against one ray.
const BOX_COST: usize = 3;
const NODE_COST: usize = 4;
/// In smaller trees rays stay together whatever they do: there is little to be missed.
const SMALL: usize = 24;

/// A child that the packet may meet: a node and a place in it.
#[derive(Clone, Copy)]
struct Waiting {
    near: f32,
    node: u32,
    place: u32,
}

/// Takes a packet through a tree.
#[inline(always)]
pub fn walk_together<S, L>(s: S, nodes: &[Node], packet: &Packet<S>, level: &mut L)
where
    S: Rays<Beam = Beam<<S as Rays>::Eight>>,
    L: Level<S>,
{
    let active = level.receive().active(s);
    if nodes.is_empty() || !s.any(active) {
        return;
    }
    let mut lanes = s.bits(active);
    let beam = Beam::new(s, packet, active, level.receive().t_min(s));
    let is_small = nodes.len() <= SMALL;
    if beam.is_scattered() && !is_small {
        s.call(Alone { s, nodes, packet, level, lanes, root: 0 });
        return;
    }
    let mut room = Room::<Waiting>::new();
    let mut stack = room.stack();
    let mut node = 0_u32;
    loop {
        let t_max = greatest(s, level.receive().t_max(s), level.receive().active(s));
        let (bits, near) = beam.meets_children(s.eight(), &nodes[node as usize], t_max);
        let (boxes, rays) = (bits.count_ones() as usize, lanes.count_ones() as usize);
        if !is_small && (boxes + 1) * BOX_COST * S::LANES > rays * NODE_COST * 16 {
            s.call(Alone { s, nodes, packet, level, lanes, root: node });
            if !s.any(level.receive().active(s)) {
                return;
            }
        } else {
            let mut distances = [0.0; WIDTH];
            s.eight().store(near, &mut distances);
            push::<S, L::Receive>(node, bits, &distances, &mut stack);
        }
        node = loop {
            let Some(next) = stack.pop() else { return };
            let (from, place) = (&nodes[next.node as usize], next.place as usize);
            let receive = level.receive();
            let times = [receive.t_min(s), receive.t_max(s)];
            let mut entry = beam.enters(s, packet, (from, place), times);
            entry.mask = s.and(receive.active(s), entry.mask);
            lanes = s.bits(entry.mask);
            if lanes == 0 {
                continue;
            }
            let child = from.child(place);
            if !child.is_leaf() {
                break child.first;
            }
            level.leaf(s, &Bundle { packet, beam: &beam }, child, entry);
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
