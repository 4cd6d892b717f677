//! Discs: flat and round, or ellipses where they are scaled unevenly.

use super::triangle::Crossing;
use crate::accel::packet::{Packet, dot, scale3, splat3, sub3};
use crate::accel::simd::Simd;
use vitrine_math::{Transform, Vec3};

/// The points p of a plane with ⟨u, p − c⟩² + ⟨v, p − c⟩² ≤ 1.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// The centre c.
    pub center: [f32; 3],
    /// The unit normal.
    pub n: [f32; 3],
    /// What makes two coordinates of a point, which are the cosine and the sine of an angle on the rim.
    pub across: [[f32; 3]; 2],
    /// Its place among the scene's primitives.
    pub primitive: u32,
}

impl Disc {
    /// The disc y = 0, x² + z² ≤ 1 of a space of its own.
    #[must_use]
    pub fn new(unit: &Transform, primitive: u32) -> Self {
        let rows = &unit.object_from_world.matrix3;
        Self {
            center: unit.point(Vec3::ZERO).into(),
            n: unit.normal(Vec3::Y).into(),
            across: [0, 2].map(|k| rows.row(k).to_array()),
            primitive,
        }
    }
}

/// Where the rays cross the disc, from either side; None when no lane does. A ray along its plane divides by 0: comparisons with what
/// comes of it are false, and it passes.
#[inline(always)]
pub fn crossing<S: Simd>(s: S, p: &Packet<S>, disc: &Disc, mask: S::M) -> Option<Crossing<S>> {
    let n = splat3(s, disc.n);
    let f = sub3(s, &splat3(s, disc.center), &p.o);
    // t = ⟨n, c − o⟩/⟨n, d⟩
    let t = s.div(dot(s, &n, &f), dot(s, &n, &p.d));
    let from_center = sub3(s, &scale3(s, &p.d, t), &f);
    let u = dot(s, &splat3(s, disc.across[0]), &from_center);
    let v = dot(s, &splat3(s, disc.across[1]), &from_center);
    let mask = s.and(mask, s.le(s.add(s.mul(u, u), s.mul(v, v)), s.splat(1.0)));
    s.any(mask).then_some(Crossing::at(s, mask, t))
}
