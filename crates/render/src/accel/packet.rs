//! A packet of rays, one in each lane.

use super::primitives::triangle::{ORDER, Sheared};
use super::simd::Simd;
use super::stream::{Column, RayBlock};
use super::tree::{Node, WIDTH};
use vitrine_math::Affine3A;

/// Rays in lanes.
#[derive(Clone, Copy)]
pub struct Packet<S: Simd> {
    /// Origins.
    pub o: [S::F; 3],
    /// Directions.
    pub d: [S::F; 3],
    /// 1 / direction, finite always.
    pub inv: [S::F; 3],
    /// The square of the direction's length.
    pub dd: S::F,
    /// 1 / `dd`
    pub inv_dd: S::F,
}

impl<S: Simd> Packet<S> {
    #[inline(always)]
    pub(super) fn load(s: S, rays: &RayBlock, start: usize) -> Self {
        Self::new(s, load3(s, &rays.origin, start), load3(s, &rays.direction, start))
    }

    /// Rays by their origins and directions.
    #[inline(always)]
    pub fn new(s: S, o: [S::F; 3], d: [S::F; 3]) -> Self {
        let dd = dot(s, &d, &d);
        let inv = [inverse(s, d[0]), inverse(s, d[1]), inverse(s, d[2])];
        Self { o, d, inv, dd, inv_dd: s.div(s.splat(1.0), dd) }
    }

    /// The same rays in another space; distances keep their meaning.
    #[inline(always)]
    pub fn transformed(&self, s: S, to: &Affine3A) -> Self {
        Self::new(s, moved(s, to, &self.o), turned(s, to, &self.d))
    }

    /// The rays whose numbers are in the range of floats. The others are no rays and must not go with them: what is bounded for all
    /// rays of a packet at once would not hold.
    #[inline(always)]
    pub fn in_range(&self, s: S) -> S::M {
        let ([a, b, c], [x, y, z]) = (self.o, self.d);
        let origin = s.add(s.add(s.abs(a), s.abs(b)), s.abs(c));
        let direction = s.add(s.add(s.abs(x), s.abs(y)), s.abs(z));
        // Infinite or NaN as soon as one of them is.
        s.lt(s.add(origin, direction), s.splat(f32::INFINITY))
    }

    /// Which rays pass a child's box between `t_min` and `t_max`, and where they enter it, which may be behind their origins.
    /// Never misses for want of precision: the far side is rounded up (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
    ///
    /// Rounding keeps order, so a ray never enters a box before the boxes around it.
    #[inline(always)]
    pub fn meets_box(&self, s: S, node: &Node, place: usize, [t_min, t_max]: [S::F; 2]) -> Entry<S> {
        let mut near = s.splat(f32::NEG_INFINITY);
        let mut far = s.splat(f32::INFINITY);
        for k in 0..3 {
            let (low, high) = (node.rows[2 * k][place % WIDTH], node.rows[2 * k + 1][place % WIDTH]);
            let t0 = s.mul(s.sub(s.splat(low), self.o[k]), self.inv[k]);
            let t1 = s.mul(s.sub(s.splat(high), self.o[k]), self.inv[k]);
            near = s.max(near, s.min(t0, t1));
            far = s.min(far, s.max(t0, t1));
        }
        let far = s.min(s.mul(far, s.splat(FAR_ROUNDED_UP)), t_max);
        Entry { mask: s.le(s.max(near, t_min), far), near }
    }

    /// Which rays go fastest along each axis; of equal axes the first counts.
    #[inline(always)]
    pub fn fastest(&self, s: S) -> [S::M; 3] {
        let [x, y, z] = [s.abs(self.d[0]), s.abs(self.d[1]), s.abs(self.d[2])];
        let along_x = s.and(s.le(y, x), s.le(z, x));
        let along_y = s.and_not(s.le(z, y), along_x);
        let along_z = s.and_not(s.and_not(s.le(x, x), along_x), along_y);
        [along_x, along_y, along_z]
    }

    /// The rays sheared onto an axis, for tests of triangles.
    #[inline(always)]
    pub fn sheared(&self, s: S, axis: usize) -> Sheared<S> {
        let [x, y, z] = ORDER[axis % 3];
        let slope = self.inv[z];
        Sheared {
            o: [self.o[x], self.o[y], self.o[z]],
            d: [self.d[x], self.d[y], self.d[z]],
            slope: [s.mul(self.d[x], slope), s.mul(self.d[y], slope)],
            inv: [self.inv[x], self.inv[y], slope],
        }
    }
}

/// What makes up for rounding at a box's far side: eight units in the last place, 2⁻²⁰.
///
/// It must do for two things. Where a ray passes a box by its exact numbers, the two distances that are compared are off by two
/// roundings each. And where it crosses a triangle by the test of areas, the triangle's box must not be missed: that test
/// compares across an axis what a box compares along it, which takes three roundings more for each of two axes; twelve roundings
/// of 2⁻²⁴ in all, three quarters of this.
pub const FAR_ROUNDED_UP: f32 = 1.000_001;

/// 1/d. A component of zero would make ∞ and then NaN on the face of a box: a tiny one takes its place.
#[inline(always)]
fn inverse<S: Simd>(s: S, d: S::F) -> S::F {
    let tiny = s.lt(s.abs(d), s.splat(1e-20));
    s.div(s.splat(1.0), s.select(tiny, s.splat(1e-20), d))
}

// The kernels below spell out all three components: closures over lanes would not be inlined into the functions that have
// the instruction set switched on.

/// A map of points in each lane.
#[inline(always)]
pub fn moved<S: Simd>(s: S, to: &Affine3A, p: &[S::F; 3]) -> [S::F; 3] {
    let [x, y, z] = turned(s, to, p);
    let by = to.translation;
    [s.add(x, s.splat(by.x)), s.add(y, s.splat(by.y)), s.add(z, s.splat(by.z))]
}

/// The linear part of a map in each lane.
#[inline(always)]
pub fn turned<S: Simd>(s: S, to: &Affine3A, v: &[S::F; 3]) -> [S::F; 3] {
    let m = to.matrix3.to_cols_array();
    [
        dot(s, &[s.splat(m[0]), s.splat(m[3]), s.splat(m[6])], v),
        dot(s, &[s.splat(m[1]), s.splat(m[4]), s.splat(m[7])], v),
        dot(s, &[s.splat(m[2]), s.splat(m[5]), s.splat(m[8])], v),
    ]
}

/// Three components from columns.
#[inline(always)]
pub fn load3<S: Simd>(s: S, from: &[Column; 3], start: usize) -> [S::F; 3] {
    [s.load(&from[0][start..]), s.load(&from[1][start..]), s.load(&from[2][start..])]
}

/// ⟨a, b⟩ in each lane.
#[inline(always)]
pub fn dot<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> S::F {
    s.add(s.add(s.mul(a[0], b[0]), s.mul(a[1], b[1])), s.mul(a[2], b[2]))
}

/// a × b in each lane.
#[inline(always)]
pub fn cross<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> [S::F; 3] {
    [
        s.sub(s.mul(a[1], b[2]), s.mul(a[2], b[1])),
        s.sub(s.mul(a[2], b[0]), s.mul(a[0], b[2])),
        s.sub(s.mul(a[0], b[1]), s.mul(a[1], b[0])),
    ]
}

/// The same vector in each lane.
#[inline(always)]
pub fn splat3<S: Simd>(s: S, v: [f32; 3]) -> [S::F; 3] {
    [s.splat(v[0]), s.splat(v[1]), s.splat(v[2])]
}

/// a − b in each lane.
#[inline(always)]
pub fn sub3<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> [S::F; 3] {
    [s.sub(a[0], b[0]), s.sub(a[1], b[1]), s.sub(a[2], b[2])]
}

/// a + b·t in each lane.
#[inline(always)]
pub fn along3<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3], t: S::F) -> [S::F; 3] {
    [s.add(a[0], s.mul(b[0], t)), s.add(a[1], s.mul(b[1], t)), s.add(a[2], s.mul(b[2], t))]
}

/// a·t in each lane.
#[inline(always)]
pub fn scale3<S: Simd>(s: S, a: &[S::F; 3], t: S::F) -> [S::F; 3] {
    [s.mul(a[0], t), s.mul(a[1], t), s.mul(a[2], t)]
}

/// a/|a| in each lane.
#[inline(always)]
pub fn unit3<S: Simd>(s: S, a: &[S::F; 3]) -> [S::F; 3] {
    scale3(s, a, s.div(s.splat(1.0), s.sqrt(dot(s, a, a))))
}

/// `yes` in lanes of the mask, else `no`.
#[inline(always)]
pub fn select3<S: Simd>(s: S, mask: S::M, yes: &[S::F; 3], no: &[S::F; 3]) -> [S::F; 3] {
    [s.select(mask, yes[0], no[0]), s.select(mask, yes[1], no[1]), s.select(mask, yes[2], no[2])]
}

/// Into columns.
#[inline(always)]
pub fn store3<S: Simd>(s: S, v: &[S::F; 3], to: &mut [Column; 3], start: usize) {
    s.store(v[0], &mut to[0][start..]);
    s.store(v[1], &mut to[1][start..]);
    s.store(v[2], &mut to[2][start..]);
}

/// Where rays enter a box.
#[derive(Clone, Copy)]
pub struct Entry<S: Simd> {
    /// The rays that do.
    pub mask: S::M,
    /// Where; may be behind their origins.
    pub near: S::F,
}
