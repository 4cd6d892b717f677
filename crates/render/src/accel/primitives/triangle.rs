//! Triangles in blocks of eight, tested without gaps: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1),
//! 2013.
//!
//! The ray is sheared onto an axis, the corners with it, and then only the signs of three areas count. An area belongs to
//! an edge and has the same digits for both triangles at that edge, so a ray passes between no two of them. (Products
//! are not fused with differences: that would give the two triangles different digits.)

use crate::accel::packet::{FAR_ROUNDED_UP, cross, dot, sub3};
use crate::accel::simd::Simd;
use vitrine_math::Vec3;

/// Triangles in a block.
pub const BLOCK_TRIANGLES: usize = 8;

/// Eight triangles, component by component; 320 bytes. Places without one hold NaN, which no ray meets.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct TriangleBlock {
    /// Corners × axes × triangles.
    pub corners: [[[f32; BLOCK_TRIANGLES]; 3]; 3],
    /// Each triangle's place among the scene's primitives, or among its mesh's triangles.
    pub ids: [u32; BLOCK_TRIANGLES],
}

impl TriangleBlock {
    /// Up to eight triangles, each with its id.
    #[must_use]
    pub fn new(triangles: impl IntoIterator<Item = ([Vec3; 3], u32)>) -> Self {
        let mut block =
            Self { corners: [[[f32::NAN; BLOCK_TRIANGLES]; 3]; 3], ids: [u32::MAX; BLOCK_TRIANGLES] };
        for (place, (corners, id)) in triangles.into_iter().take(BLOCK_TRIANGLES).enumerate() {
            for (to, corner) in block.corners.iter_mut().zip(corners) {
                for axis in 0..3 {
                    to[axis][place] = corner[axis];
                }
            }
            block.ids[place] = id;
        }
        block
    }

    /// The corners of a triangle.
    #[must_use]
    pub fn corners_of(&self, place: usize) -> [Vec3; 3] {
        self.corners.map(|c| Vec3::from_array(c.map(|axis| axis[place])))
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

/// Rays sheared onto an axis. Components stand in the order of that axis: the two across it first.
#[derive(Clone, Copy)]
pub struct Sheared<S: Simd> {
    /// Origins.
    pub o: [S::F; 3],
    /// Directions.
    pub d: [S::F; 3],
    /// d\[0\]/d\[2\], d\[1\]/d\[2\]
    pub slope: [S::F; 2],
    /// 1/d, as for boxes.
    pub inv: [S::F; 3],
}

/// The order of the components for an axis.
pub const ORDER: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

/// The axis along which a ray goes fastest; of equal ones the first.
#[inline(always)]
pub fn fastest_axis([x, y, z]: [f32; 3]) -> usize {
    let (x, y, z) = (x.abs(), y.abs(), z.abs());
    if y <= x && z <= x {
        0
    } else if z <= y {
        1
    } else {
        2
    }
}

/// Rays that pass a triangle's edges on one side. Only for lanes of the mask.
#[derive(Clone, Copy)]
pub struct Inside<S: Simd> {
    mask: S::M,
    /// The corners, from the rays' origins.
    corners: [[S::F; 3]; 3],
    /// Twice the areas of the triangles between the ray and each edge.
    areas: [S::F; 3],
}

/// Which rays pass the edges of a triangle on one side, from either side; None when no lane does. The corners' components stand
/// in the order of the shear.
#[inline(always)]
pub fn inside<S: Simd>(s: S, ray: &Sheared<S>, corners: &[[S::F; 3]; 3], mask: S::M) -> Option<Inside<S>> {
    let a = sub3(s, &corners[0], &ray.o);
    let b = sub3(s, &corners[1], &ray.o);
    let c = sub3(s, &corners[2], &ray.o);
    let ax = s.sub(a[0], s.mul(ray.slope[0], a[2]));
    let ay = s.sub(a[1], s.mul(ray.slope[1], a[2]));
    let bx = s.sub(b[0], s.mul(ray.slope[0], b[2]));
    let by = s.sub(b[1], s.mul(ray.slope[1], b[2]));
    let cx = s.sub(c[0], s.mul(ray.slope[0], c[2]));
    let cy = s.sub(c[1], s.mul(ray.slope[1], c[2]));
    let u = s.sub(s.mul(cx, by), s.mul(cy, bx));
    let v = s.sub(s.mul(ax, cy), s.mul(ay, cx));
    let w = s.sub(s.mul(bx, ay), s.mul(by, ax));
    let zero = s.splat(0.0);
    let inside = s.or(s.le(zero, s.min(s.min(u, v), w)), s.le(s.max(s.max(u, v), w), zero));
    let mask = s.and(mask, inside);
    s.any(mask).then_some(Inside { mask, corners: [a, b, c], areas: [u, v, w] })
}

/// A normal of any length, its components in the order of the corners'.
#[inline(always)]
pub fn normal<S: Simd>(s: S, corners: &[[S::F; 3]; 3]) -> [S::F; 3] {
    cross(s, &sub3(s, &corners[1], &corners[0]), &sub3(s, &corners[2], &corners[0]))
}

impl<S: Simd> Inside<S> {
    /// Where the rays cross the triangle with this [`normal`]. A ray in its plane divides 0 by 0: comparisons with what comes of it are
    /// false.
    ///
    /// A triangle seen nearly from its edge has areas and a distance that are all rounding. So a crossing counts only within the
    /// triangle's own box, whose test has the same digits as that of boxes in trees. A packet may thus leave out triangles whose
    /// boxes it does not meet: no ray of it would have hit them alone.
    #[inline(always)]
    pub fn crossing(&self, s: S, ray: &Sheared<S>, n: &[S::F; 3]) -> Crossing<S> {
        let [u, v, w] = self.areas;
        let area = s.add(s.add(u, v), w);
        let [near, far] = self.passage(s, ray);
        let in_box = s.le(near, s.mul(far, s.splat(FAR_ROUNDED_UP)));
        let mask = s.and(self.mask, s.and(in_box, s.lt(s.splat(0.0), s.abs(area))));
        let inverse = s.div(s.splat(1.0), area);
        // The distance to the triangle's plane, ⟨n, a⟩/⟨n, d⟩: of a large triangle near the ray's start it has more digits than
        // the corners' depths, mixed, would give.
        let t = s.div(dot(s, n, &self.corners[0]), dot(s, n, &ray.d));
        // No nearer than where the ray enters the box and no farther than where it leaves. In this order NaN stays.
        let t = s.max(near, s.min(far, t));
        Crossing { mask, t, u: s.mul(v, inverse), v: s.mul(w, inverse) }
    }

    /// Where the rays enter and leave the box around the triangle.
    #[inline(always)]
    fn passage(&self, s: S, ray: &Sheared<S>) -> [S::F; 2] {
        let (mut near, mut far) = (s.splat(f32::NEG_INFINITY), s.splat(f32::INFINITY));
        let [a, b, c] = &self.corners;
        for k in 0..3 {
            // Rounding keeps order: the least of these products is that of the side of the box.
            let (a, b, c) = (s.mul(a[k], ray.inv[k]), s.mul(b[k], ray.inv[k]), s.mul(c[k], ray.inv[k]));
            near = s.max(near, s.min(s.min(a, b), c));
            far = s.min(far, s.max(s.max(a, b), c));
        }
        [near, far]
    }
}
