//! Single rays: one ray against eight boxes, eight triangles or eight balls at a time.

use super::packet::{Entry, FAR_ROUNDED_UP, Packet, splat3};
use super::primitives::Span;
use super::primitives::sphere;
use super::primitives::triangle::{Crossing, Sheared, fastest_axis};
use super::rays::{Bundle, Level, Rays, Receive, SphereLeaf, TriangleLeaf};
use super::simd::{Kernel, Simd, prefetch};
use super::stack::{Room, Stack};
use super::tree::{Child, Node, WIDTH};

/// One ray as a packet with one lane, beside a vector unit of eight lanes.
#[derive(Clone, Copy, Debug)]
pub struct One<E>(pub E);

macro_rules! plainly {
    ($($name:ident($($arg:ident),*) -> $out:ty = $value:expr;)*) => {$(
        #[inline(always)]
        fn $name(self, $($arg: f32),*) -> $out {
            $value
        }
    )*};
}

impl<E: Simd> Simd for One<E> {
    const LANES: usize = 1;
    type F = f32;
    type M = bool;
    type Order = ();

    plainly! {
        splat(v) -> f32 = v;
        add(a, b) -> f32 = a + b;
        sub(a, b) -> f32 = a - b;
        mul(a, b) -> f32 = a * b;
        div(a, b) -> f32 = a / b;
        sqrt(a) -> f32 = a.sqrt();
        abs(a) -> f32 = a.abs();
        floor(a) -> f32 = a.floor();
        min(a, b) -> f32 = if a < b { a } else { b };
        max(a, b) -> f32 = if a > b { a } else { b };
        step(a, count) -> f32 = f32::from_bits(a.to_bits().wrapping_add_signed(count as i32));
        lt(a, b) -> bool = a < b;
        le(a, b) -> bool = a <= b;
        eq(a, b) -> bool = a == b;
    }

    #[inline(always)]
    fn load(self, from: &[f32]) -> f32 {
        from[0]
    }
    #[inline(always)]
    fn store(self, v: f32, to: &mut [f32]) {
        to[0] = v;
    }
    #[inline(always)]
    fn and(self, a: bool, b: bool) -> bool {
        a & b
    }
    #[inline(always)]
    fn or(self, a: bool, b: bool) -> bool {
        a | b
    }
    #[inline(always)]
    fn and_not(self, a: bool, b: bool) -> bool {
        a & !b
    }
    #[inline(always)]
    fn select(self, mask: bool, yes: f32, no: f32) -> f32 {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn bits(self, mask: bool) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn packed(self, _: bool, _: usize) {}
    #[inline(always)]
    fn permute(self, v: f32, (): ()) -> f32 {
        v
    }
    fn call<K: Kernel>(self, kernel: K) -> K::Output {
        self.0.call(kernel)
    }
}

impl<E: Simd> Rays for One<E> {
    type Eight = E;
    type Beam = ();
    type Wide = Self;

    #[inline(always)]
    fn wide(self) -> Self {
        self
    }

    #[inline(always)]
    fn eight(self) -> E {
        self.0
    }

    #[inline(always)]
    fn triangles<R: Receive<Self>>(
        self,
        ray: &Bundle<Self>,
        leaf: &TriangleLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        let e = self.0;
        let axis = fastest_axis(ray.packet.d);
        let Sheared { o, d, slope: [x, y], inv } = ray.packet.sheared(self, axis);
        let slope = [e.splat(x), e.splat(y)];
        let sheared = Sheared { o: splat3(e, o), d: splat3(e, d), slope, inv: splat3(e, inv) };
        let t_max = receive.t_max(self);
        let Some((mut bits, hits)) = leaf.crossed(e, &sheared, axis, t_max) else { return };
        while bits != 0 {
            let place = bits.trailing_zeros() as usize % WIDTH;
            bits &= bits - 1;
            let hit = Crossing { mask: true, t: hits[0][place], u: hits[1][place], v: hits[2][place] };
            receive.crossing(self, &hit, entry.near, leaf.surface(place));
        }
    }

    #[inline(always)]
    fn spheres<R: Receive<Self>>(
        self,
        ray: &Packet<Self>,
        leaf: &SphereLeaf,
        entry: Entry<Self>,
        receive: &mut R,
    ) {
        let e = self.0;
        let eight = Packet {
            o: splat3(e, ray.o),
            d: splat3(e, ray.d),
            inv: splat3(e, ray.inv),
            dd: e.splat(ray.dd),
            inv_dd: e.splat(ray.inv_dd),
        };
        let [x, y, z] = &leaf.block.centers;
        let centers = [e.load(x), e.load(y), e.load(z)];
        let radii = e.load(&leaf.block.radii);
        let all = e.le(e.splat(0.0), e.splat(0.0));
        let Some(span) = sphere::span(e, &eight, &centers, radii, all) else { return };
        let (mut near, mut far) = ([0.0; WIDTH], [0.0; WIDTH]);
        e.store(span.near, &mut near);
        e.store(span.far, &mut far);
        let mut bits = e.bits(span.mask);
        while bits != 0 {
            let place = bits.trailing_zeros() as usize % WIDTH;
            bits &= bits - 1;
            let span = Span { mask: true, near: near[place], far: far[place] };
            receive.span(self, &span, entry.near, leaf.block.primitives[place]);
        }
    }

    #[inline(always)]
    fn walk<L: Level<Self>>(self, nodes: &[Node], ray: &Packet<Self>, level: &mut L) {
        if !nodes.is_empty() && level.receive().active(self) {
            walk_alone(self, nodes, ray, level, 0);
        }
    }
}

/// Where a ray crosses one side of each of eight boxes.
#[inline(always)]
fn side<E: Simd>(e: E, node: &Node, row: usize, o: E::F, inv: E::F) -> E::F {
    e.mul(e.sub(e.load(&node.rows[row % WIDTH]), o), inv)
}

/// A box that a ray has still to enter.
#[derive(Clone, Copy)]
struct Waiting {
    near: f32,
    child: Child,
}

/// Takes a ray through a tree from a node on.
#[inline(always)]
pub fn walk_alone<E: Simd, L: Level<One<E>>>(
    s: One<E>,
    nodes: &[Node],
    ray: &Packet<One<E>>,
    level: &mut L,
    root: u32,
) {
    let e = s.0;
    let (o, inv) = (splat3(e, ray.o), splat3(e, ray.inv));
    // The rows of the near sides; their neighbours are the far sides.
    let near_rows = [0, 1, 2].map(|k: usize| 2 * k + usize::from(ray.inv[k] < 0.0));
    let t_min = e.splat(level.receive().t_min(s));
    let mut room = Room::<Waiting>::new();
    let mut stack = room.stack();
    let mut now = Waiting { near: 0.0, child: Child { first: root, tag: 0 } };
    loop {
        if now.child.is_leaf() {
            level.leaf(
                s,
                &Bundle { packet: ray, beam: &() },
                now.child,
                Entry { mask: true, near: now.near },
            );
            if !level.receive().active(s) {
                return;
            }
        } else {
            let node = &nodes[now.child.first as usize];
            let mut near = side(e, node, near_rows[0], o[0], inv[0]);
            let mut far = side(e, node, near_rows[0] ^ 1, o[0], inv[0]);
            for k in 1..3 {
                near = e.max(near, side(e, node, near_rows[k], o[k], inv[k]));
                far = e.min(far, side(e, node, near_rows[k] ^ 1, o[k], inv[k]));
            }
            let t_max = e.splat(level.receive().t_max(s));
            let far = e.min(e.mul(far, e.splat(FAR_ROUNDED_UP)), t_max);
            let bits = e.bits(e.le(e.max(near, t_min), far));
            if bits != 0 {
                let mut distances = [0.0; WIDTH];
                e.store(near, &mut distances);
                now = open::<L::Receive, One<E>>(node, bits, &distances, &mut stack);
                continue;
            }
        }
        loop {
            let Some(next) = stack.pop() else { return };
            if next.near <= level.receive().t_max(s) {
                now = next;
                if let Some(after) = stack.peek().filter(|after| !after.child.is_leaf()) {
                    prefetch(&nodes[after.child.first as usize]);
                }
                break;
            }
        }
    }
}

/// Puts the children that the ray enters onto the stack, but for the first to be visited.
#[inline(always)]
fn open<R: Receive<S>, S: Rays>(
    node: &Node,
    mut bits: u32,
    distances: &[f32; WIDTH],
    stack: &mut Stack<Waiting>,
) -> Waiting {
    let waiting = |place: usize| Waiting { near: distances[place % WIDTH], child: node.child(place) };
    if !R::NEAREST_FIRST {
        // The first place first.
        loop {
            let place = 31 - bits.leading_zeros();
            bits &= !(1 << place);
            if bits == 0 {
                return waiting(place as usize);
            }
            stack.push(waiting(place as usize));
        }
    }
    let mut next = || {
        let place = bits.trailing_zeros() as usize;
        bits &= bits - 1;
        (waiting(place), bits != 0)
    };
    let (mut nearest, more) = next();
    if !more {
        return nearest;
    }
    let bottom = stack.len();
    loop {
        let (mut other, more) = next();
        if other.near < nearest.near {
            std::mem::swap(&mut other, &mut nearest);
        }
        // The stack stays sorted, the nearest on top.
        stack.push(other);
        stack.sink(bottom, |below, value| below.near < value.near);
        if !more {
            return nearest;
        }
    }
}
