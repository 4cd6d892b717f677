//! Balls. The discriminant comes from the closest approach, which keeps its digits for small and distant balls: Haines,
//! Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7.

use super::Span;
use crate::accel::packet::{Packet, along3, dot, sub3};
use crate::accel::simd::Simd;

/// A ball in world space.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// The centre.
    pub center: [f32; 3],
    /// The radius.
    pub radius: f32,
    /// Its place among the scene's primitives.
    pub primitive: u32,
}

/// Balls in a block.
pub const BLOCK_SPHERES: usize = 8;

/// Eight balls, component by component. Places without one have a radius that is no number, which no ray meets.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct SphereBlock {
    /// The centres: axes × balls.
    pub centers: [[f32; BLOCK_SPHERES]; 3],
    /// The radii.
    pub radii: [f32; BLOCK_SPHERES],
    /// Each ball's place among the scene's primitives.
    pub primitives: [u32; BLOCK_SPHERES],
}

impl SphereBlock {
    /// Up to eight balls.
    #[must_use]
    pub fn new<'a>(spheres: impl IntoIterator<Item = &'a Sphere>) -> Self {
        let none = [f32::NAN; BLOCK_SPHERES];
        let mut block = Self { centers: [none; 3], radii: none, primitives: [u32::MAX; BLOCK_SPHERES] };
        for (place, ball) in spheres.into_iter().take(BLOCK_SPHERES).enumerate() {
            for axis in 0..3 {
                block.centers[axis][place] = ball.center[axis];
            }
            block.radii[place] = ball.radius;
            block.primitives[place] = ball.primitive;
        }
        block
    }
}

/// Where the rays cross the surface, or None when no lane does.
#[inline(always)]
pub fn span<S: Simd>(s: S, p: &Packet<S>, center: &[S::F; 3], radius: S::F, mask: S::M) -> Option<Span<S>> {
    let f = sub3(s, &p.o, center);
    let zero = s.splat(0.0);
    // b = −⟨f, d⟩; the closest approach to the centre is l = f + d·b/⟨d, d⟩
    let b = s.sub(zero, dot(s, &f, &p.d));
    let along = s.mul(b, p.inv_dd);
    let l = along3(s, &f, &p.d, along);
    let r2 = s.mul(radius, radius);
    // Δ/⟨d, d⟩ = r² − ⟨l, l⟩
    let discriminant = s.sub(r2, dot(s, &l, &l));
    let mask = s.and(mask, s.le(zero, discriminant));
    if !s.any(mask) {
        return None;
    }
    let root = s.sqrt(s.mul(p.dd, discriminant));
    // q has the sign of b, so nothing cancels: the roots are c/q and q/⟨d, d⟩.
    let q = s.add(b, s.select(s.lt(b, zero), s.sub(zero, root), root));
    let c = s.sub(dot(s, &f, &f), r2);
    let (t0, t1) = (s.div(c, q), s.mul(q, p.inv_dd));
    Some(Span { mask, near: s.min(t0, t1), far: s.max(t0, t1) })
}
