//! Triangles, by Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997 (course work, section 2.2.2).

use crate::accel::packet::{Packet, cross, dot, splat3, sub3};
use crate::accel::simd::Simd;
use vitrine_math::Vec3;

/// A corner and the two edges from it.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// The first corner.
    pub a: [f32; 3],
    /// From the first corner to the second.
    pub e1: [f32; 3],
    /// From the first corner to the third.
    pub e2: [f32; 3],
    /// Its place among the scene's primitives, or among its mesh's triangles.
    pub id: u32,
}

impl Triangle {
    /// By its corners.
    pub fn new([a, b, c]: [Vec3; 3], id: u32) -> Self {
        Self { a: a.into(), e1: (b - a).into(), e2: (c - a).into(), id }
    }
}

/// Where rays cross a triangle. Only for lanes of the mask.
#[derive(Clone, Copy)]
pub struct Crossing<S: Simd> {
    /// Lanes whose line meets the triangle.
    pub mask: S::M,
    /// The distance.
    pub t: S::F,
    /// The barycentric coordinate of the second corner.
    pub u: S::F,
    /// The barycentric coordinate of the third corner.
    pub v: S::F,
}

impl<S: Simd> Crossing<S> {
    /// A crossing of another form, without barycentric coordinates.
    #[inline(always)]
    pub fn at(s: S, mask: S::M, t: S::F) -> Self {
        let zero = s.splat(0.0);
        Self { mask, t, u: zero, v: zero }
    }
}

/// Where the rays cross the triangle, from either side; None when no lane does.
#[inline(always)]
pub fn crossing<S: Simd>(s: S, p: &Packet<S>, triangle: &Triangle, mask: S::M) -> Option<Crossing<S>> {
    let (e1, e2) = (splat3(s, triangle.e1), splat3(s, triangle.e2));
    let (zero, one) = (s.splat(0.0), s.splat(1.0));
    // [t u v] = 1/(P·E1) · [Q·E2  P·T  Q·D],  P = D × E2,  T = O − A,  Q = T × E1
    let pv = cross(s, &p.d, &e2);
    let inv_det = s.div(one, dot(s, &pv, &e1));
    let tv = sub3(s, &p.o, &splat3(s, triangle.a));
    let u = s.mul(dot(s, &pv, &tv), inv_det);
    // A ray along the triangle's plane divides by 0; comparisons with what comes of it are false.
    let mask = s.and(mask, s.and(s.le(zero, u), s.le(u, one)));
    if !s.any(mask) {
        return None;
    }
    let qv = cross(s, &tv, &e1);
    let v = s.mul(dot(s, &qv, &p.d), inv_det);
    let mask = s.and(mask, s.and(s.le(zero, v), s.le(s.add(u, v), one)));
    if !s.any(mask) {
        return None;
    }
    let t = s.mul(dot(s, &qv, &e2), inv_det);
    Some(Crossing { mask, t, u, v })
}
