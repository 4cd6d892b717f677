//! Planes without end (course work, section 2.2.4). They have no box, so every ray is tested against each.

use crate::accel::packet::{Packet, dot, splat3};
use crate::accel::simd::Simd;

/// The points with ⟨n, p⟩ = offset.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// The unit normal.
    pub n: [f32; 3],
    /// Its distance from the origin along the normal.
    pub offset: f32,
    /// Its place among the scene's primitives.
    pub primitive: u32,
}

/// Where the rays cross the plane: (offset − ⟨n, o⟩)/⟨n, d⟩. Infinite or NaN for rays along it.
#[inline(always)]
pub fn distance<S: Simd>(s: S, p: &Packet<S>, plane: &Plane) -> S::F {
    let n = splat3(s, plane.n);
    s.div(s.sub(s.splat(plane.offset), dot(s, &n, &p.o)), dot(s, &n, &p.d))
}
