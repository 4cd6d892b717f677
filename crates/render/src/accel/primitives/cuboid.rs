//! Boxes with right angles, as the cube from −1 to 1 in a space of their own.

use super::Span;
use crate::accel::packet::Packet;
use crate::accel::simd::Simd;
use vitrine_math::Affine3A;

/// A form that is simple in a space of its own: the cube from −1 to 1, or the ball of radius 1.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// From the world to that space.
    pub unit_from_world: Affine3A,
    /// Its place among the scene's primitives.
    pub primitive: u32,
}

/// Where the rays, given in the cube's space, cross its surface; None when no lane does.
#[inline(always)]
pub fn span<S: Simd>(s: S, p: &Packet<S>, mask: S::M) -> Option<Span<S>> {
    let mut near = s.splat(f32::NEG_INFINITY);
    let mut far = s.splat(f32::INFINITY);
    for k in 0..3 {
        let t0 = s.mul(s.sub(s.splat(-1.0), p.o[k]), p.inv[k]);
        let t1 = s.mul(s.sub(s.splat(1.0), p.o[k]), p.inv[k]);
        near = s.max(near, s.min(t0, t1));
        far = s.min(far, s.max(t0, t1));
    }
    let mask = s.and(mask, s.le(near, far));
    s.any(mask).then_some(Span { mask, near, far })
}
