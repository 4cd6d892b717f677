//! Bounds of a packet's rays, so that boxes are tested against the whole packet at once, by interval arithmetic: Boulos, Wald
//! and Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006.

use super::packet::{Entry, FAR_ROUNDED_UP, Packet};
use super::rays::Rays;
use super::simd::Simd;
use super::tree::{Node, WIDTH};

/// Bounds of a packet's rays, each in all of eight lanes.
pub struct Beam<E: Simd> {
    /// For each axis the origin from which boxes seem nearest, and that from which they seem farthest.
    near_o: [E::F; 3],
    far_o: [E::F; 3],
    /// The least and the greatest inverse of the directions; both 0 where the rays do not agree on the sign.
    inv: [[E::F; 2]; 3],
    /// What is added to the far sides: ∞ where the rays do not agree on the sign.
    slack: [E::F; 3],
    /// The rows of the near sides; their neighbours are the far sides.
    near_rows: [usize; 3],
    /// The axes on which the rays do not agree on the sign.
    is_mixed: [bool; 3],
    t_min: E::F,
}

impl<E: Simd> Beam<E> {
    /// Around the active rays, of which there must be one.
    #[inline(always)]
    pub fn new<S: Rays<Eight = E>>(s: S, packet: &Packet<S>, active: S::M, t_min: S::F) -> Self {
        let e = s.eight();
        let zero = e.splat(0.0);
        let mut beam = Self {
            near_o: [zero; 3],
            far_o: [zero; 3],
            inv: [[zero; 2]; 3],
            slack: [zero; 3],
            near_rows: [0; 3],
            is_mixed: [false; 3],
            t_min: e.splat(least(s, t_min, active)),
        };
        for k in 0..3 {
            let (low, high) = (least(s, packet.o[k], active), greatest(s, packet.o[k], active));
            let (slow, fast) = (least(s, packet.inv[k], active), greatest(s, packet.inv[k], active));
            let (near, far) = if slow > 0.0 { (high, low) } else { (low, high) };
            (beam.near_o[k], beam.far_o[k]) = (e.splat(near), e.splat(far));
            beam.near_rows[k] = 2 * k + usize::from(slow <= 0.0);
            beam.is_mixed[k] = slow <= 0.0 && fast >= 0.0;
            if beam.is_mixed[k] {
                beam.slack[k] = e.splat(f32::INFINITY);
            } else {
                beam.inv[k] = [e.splat(slow), e.splat(fast)];
            }
        }
        beam
    }

    /// Whether the rays have too little in common to go together.
    #[inline(always)]
    pub fn is_scattered(&self) -> bool {
        self.is_mixed.into_iter().filter(|mixed| *mixed).count() >= 2
    }

    /// The children that some ray may meet before `t_max`, a bit for each, and where none can enter them earlier.
    #[inline(always)]
    pub fn meets_children(&self, e: E, node: &Node, t_max: f32) -> (u32, E::F) {
        let [x, y, z] = self.near_rows;
        let row = |r: usize| &node.rows[r % WIDTH];
        let near = [e.load(row(x)), e.load(row(y)), e.load(row(z))];
        let far = [e.load(row(x ^ 1)), e.load(row(y ^ 1)), e.load(row(z ^ 1))];
        self.meets(e, &near, &far, t_max)
    }

    /// The boxes between lower and upper corners that some ray may meet before `t_max`, a bit for each. A triangle whose box is not
    /// among them is met by no ray: its own test asks for its box, too.
    #[inline(always)]
    pub fn meets_boxes(&self, e: E, [mut near, mut far]: [[E::F; 3]; 2], t_max: f32) -> u32 {
        for k in 0..3 {
            if self.near_rows[k] & 1 == 1 {
                (near[k], far[k]) = (far[k], near[k]);
            }
        }
        self.meets(e, &near, &far, t_max).0
    }

    /// Rounding keeps order, so the bounds hold for what [`Packet::meets_box`] computes.
    #[inline(always)]
    fn meets(&self, e: E, near_sides: &[E::F; 3], far_sides: &[E::F; 3], t_max: f32) -> (u32, E::F) {
        let mut near = self.t_min;
        let mut far = e.splat(f32::INFINITY);
        for k in 0..3 {
            let [slow, fast] = self.inv[k];
            let to_near = e.sub(near_sides[k], self.near_o[k]);
            let to_far = e.sub(far_sides[k], self.far_o[k]);
            near = e.max(near, e.min(e.mul(to_near, slow), e.mul(to_near, fast)));
            let farthest = e.max(e.mul(to_far, slow), e.mul(to_far, fast));
            far = e.min(far, e.add(farthest, self.slack[k]));
        }
        let far = e.min(e.mul(far, e.splat(FAR_ROUNDED_UP)), e.splat(t_max));
        (e.bits(e.le(near, far)), near)
    }

    /// [`Packet::meets_box`], with fewer steps where the rays agree on the sign.
    #[inline(always)]
    pub fn enters<S: Rays<Eight = E>>(
        &self,
        s: S,
        packet: &Packet<S>,
        (node, place): (&Node, usize),
        [t_min, t_max]: [S::F; 2],
    ) -> Entry<S> {
        let mut near = s.splat(f32::NEG_INFINITY);
        let mut far = s.splat(f32::INFINITY);
        for k in 0..3 {
            let row = self.near_rows[k];
            let side = |row: usize| node.rows[row % WIDTH][place % WIDTH];
            let t0 = s.mul(s.sub(s.splat(side(row)), packet.o[k]), packet.inv[k]);
            let t1 = s.mul(s.sub(s.splat(side(row ^ 1)), packet.o[k]), packet.inv[k]);
            if self.is_mixed[k] {
                near = s.max(near, s.min(t0, t1));
                far = s.min(far, s.max(t0, t1));
            } else {
                near = s.max(near, t0);
                far = s.min(far, t1);
            }
        }
        let far = s.min(s.mul(far, s.splat(FAR_ROUNDED_UP)), t_max);
        Entry { mask: s.le(s.max(near, t_min), far), near }
    }
}

/// The least value of the active lanes.
#[inline(always)]
pub fn least<S: Simd>(s: S, v: S::F, active: S::M) -> f32 {
    s.least(s.select(active, v, s.splat(f32::INFINITY)))
}

/// The greatest value of the active lanes.
#[inline(always)]
pub fn greatest<S: Simd>(s: S, v: S::F, active: S::M) -> f32 {
    s.greatest(s.select(active, v, s.splat(f32::NEG_INFINITY)))
}
