//! Points and normals of forms that need more than the one formula of [`NormalField`](super::NormalField): boxes, ellipsoids
//! and meshes, in the lanes that hit the same thing.

use super::{HitLanes, Points, lanes_of};
use crate::accel::packet::{along3, cross, dot, load3, moved, scale3, select3, splat3, sub3, turned, unit3};
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column};
use crate::compile::{CompiledScene, Form, Primitive};
use vitrine_math::{Transform, Vec3};
use vitrine_scene::TriangleMesh;

/// A point of a surface, its unit normal outwards and that for shading, all in lanes. World space.
struct Outward<S: Simd> {
    p: [S::F; 3],
    n: [S::F; 3],
    smooth: [S::F; 3],
}

/// Rays in lanes and where they have hit, but for rounding.
pub struct Arrival<'a, S: Simd> {
    pub at: &'a HitLanes<'a>,
    /// The points.
    pub p: [S::F; 3],
    /// The unit directions.
    pub d: [S::F; 3],
}

impl CompiledScene {
    /// Puts the points of such forms in the place of those that the one formula gave. `others` are the bits of their lanes.
    #[inline(always)]
    pub(super) fn replace_others<S: Simd>(
        &self,
        s: S,
        others: u32,
        arrival: &Arrival<S>,
        points: &mut Points<S>,
    ) {
        let at = arrival.at;
        let primitives = s.load(&at.hits.primitive[at.start..]);
        let mut left = others;
        while left != 0 {
            let id = at.hits.primitive[at.start + left.trailing_zeros() as usize];
            let same = s.eq(primitives, s.splat(id));
            let index = id.to_bits() as usize;
            let outward = self.primitives[index].outward(s, left & s.bits(same), arrival);
            let seen = outward.seen(s, points.wo, self.normals[index].reach);
            points.p = select3(s, same, &seen.p, &points.p);
            points.n = select3(s, same, &seen.n, &points.n);
            points.ns = select3(s, same, &seen.ns, &points.ns);
            points.reach = s.select(same, seen.reach, points.reach);
            points.is_outside = s.or(s.and(same, seen.is_outside), s.and_not(points.is_outside, same));
            left &= !s.bits(same);
        }
    }
}

impl<S: Simd> Outward<S> {
    /// As it is seen from wo. `reach` is the largest number that takes part in finding the form.
    #[inline(always)]
    fn seen(&self, s: S, wo: [S::F; 3], reach: f32) -> Points<S> {
        let (zero, one) = (s.splat(0.0), s.splat(1.0));
        let p = self.p;
        let is_outside = s.le(zero, dot(s, &self.n, &wo));
        let n = scale3(s, &self.n, s.select(is_outside, one, s.splat(-1.0)));
        let same_side = s.le(zero, dot(s, &self.smooth, &n));
        let ns = scale3(s, &self.smooth, s.select(same_side, one, s.splat(-1.0)));
        // A smooth normal that the viewer sees from behind would turn the shading inside out.
        let ns = select3(s, s.lt(zero, dot(s, &ns, &wo)), &ns, &n);
        let reach = s.max(s.max(s.abs(p[0]), s.abs(p[1])), s.max(s.abs(p[2]), s.splat(reach)));
        Points { p, n, ns, wo, is_outside, reach }
    }
}

impl Primitive {
    /// The index of the material of a triangle.
    pub(crate) fn material_of(&self, triangle: u32) -> u32 {
        match &self.form {
            Form::Mesh { accel, .. } if self.by_triangle => self.material + accel.slot(triangle),
            _ => self.material,
        }
    }

    /// The points where rays have hit it, in the lanes of those bits.
    #[inline(always)]
    fn outward<S: Simd>(&self, s: S, lanes: u32, arrival: &Arrival<S>) -> Outward<S> {
        match &self.form {
            Form::Ellipsoid { unit } => {
                let local = unit3(s, &moved(s, &unit.object_from_world, &arrival.p));
                let n = world_normal(s, unit, &local);
                Outward { p: moved(s, &unit.world_from_object, &local), n, smooth: n }
            }
            Form::Box { unit } => on_box(s, unit, arrival),
            Form::Mesh { mesh, is_smooth, .. } => {
                let smooth = on_mesh(s, mesh, &self.transform, lanes, arrival.at);
                if *is_smooth { smooth } else { Outward { smooth: smooth.n, ..smooth } }
            }
            Form::Sphere { .. } | Form::Plane { .. } | Form::Disc { .. } | Form::Triangle { .. } => {
                unreachable!("its normals follow the one formula")
            }
        }
    }
}

/// A normal of a form's own space in the world, of unit length: by the inverse transpose.
#[inline(always)]
fn world_normal<S: Simd>(s: S, transform: &Transform, n: &[S::F; 3]) -> [S::F; 3] {
    let m = &transform.object_from_world.matrix3;
    let column = |k: usize| m.col(k).to_array();
    let [x, y, z] = [splat3(s, column(0)), splat3(s, column(1)), splat3(s, column(2))];
    unit3(s, &[dot(s, &x, n), dot(s, &y, n), dot(s, &z, n)])
}

/// On a box, which is the cube from −1 to 1 of a space of its own. Its face is that which the ray crosses, not that on which the
/// point lies: on an edge that could be one that is turned away from the ray.
#[inline(always)]
fn on_box<S: Simd>(s: S, unit: &Transform, arrival: &Arrival<S>) -> Outward<S> {
    let HitLanes { rays, hits, start } = *arrival.at;
    let (zero, one, minus) = (s.splat(0.0), s.splat(1.0), s.splat(-1.0));
    let o = moved(s, &unit.object_from_world, &load3(s, &rays.origin, start));
    let d = turned(s, &unit.object_from_world, &arrival.d);
    let (mut entry, mut exit) = (s.splat(f32::NEG_INFINITY), s.splat(f32::INFINITY));
    // The outward normals of the faces where the ray enters and leaves.
    let (mut into, mut out) = ([zero; 3], [zero; 3]);
    for k in 0..3 {
        // A negative zero counts as zero, so that signs agree.
        let d = s.add(d[k], zero);
        let side = s.select(s.lt(d, zero), minus, one);
        let against = s.sub(zero, side);
        let (near, far) = (s.div(s.sub(against, o[k]), d), s.div(s.sub(side, o[k]), d));
        let (later, sooner) = (s.lt(entry, near), s.lt(far, exit));
        entry = s.select(later, near, entry);
        exit = s.select(sooner, far, exit);
        let (mut face, mut opposite) = ([zero; 3], [zero; 3]);
        (face[k], opposite[k]) = (against, side);
        into = select3(s, later, &face, &into);
        out = select3(s, sooner, &opposite, &out);
    }
    let t = s.load(&hits.t[start..]);
    let enters = s.le(s.abs(s.sub(t, entry)), s.abs(s.sub(t, exit)));
    let n = select3(s, enters, &into, &out);
    let mut on_face = moved(s, &unit.object_from_world, &arrival.p);
    for k in 0..3 {
        let inside = s.max(s.min(on_face[k], one), minus);
        on_face[k] = s.select(s.eq(n[k], zero), inside, n[k]);
    }
    let n = world_normal(s, unit, &n);
    Outward { p: moved(s, &unit.world_from_object, &on_face), n, smooth: n }
}

/// On triangles of a mesh.
#[inline(always)]
fn on_mesh<S: Simd>(
    s: S,
    mesh: &TriangleMesh,
    transform: &Transform,
    lanes: u32,
    at: &HitLanes,
) -> Outward<S> {
    let mut corners = Corners::EMPTY;
    for lane in lanes_of(lanes) {
        let triangle = mesh.triangles[at.hits.triangle[at.start + lane].to_bits() as usize];
        corners.put(lane, mesh, triangle);
    }
    let (u, v) = (s.load(&at.hits.u[at.start..]), s.load(&at.hits.v[at.start..]));
    let shares = [s.sub(s.sub(s.splat(1.0), u), v), u, v];
    let [a, b, c] =
        [load3(s, &corners.points[0], 0), load3(s, &corners.points[1], 0), load3(s, &corners.points[2], 0)];
    let (ab, ac) = (sub3(s, &b, &a), sub3(s, &c, &a));
    // Scaled first, so that tiny triangles do not underflow.
    let largest = s.max(largest3(s, &ab), largest3(s, &ac));
    let by = [largest; 3];
    let across = cross(s, &div3(s, &ab, &by), &div3(s, &ac, &by));
    let up = splat3(s, [0.0, 1.0, 0.0]);
    let flat = unit_or(s, &across, &up);
    let p = moved(s, &transform.world_from_object, &mix3(s, &[a, b, c], &shares));
    let n = world_normal(s, transform, &flat);
    if mesh.normals.is_empty() {
        return Outward { p, n, smooth: n };
    }
    let normals = [
        load3(s, &corners.normals[0], 0),
        load3(s, &corners.normals[1], 0),
        load3(s, &corners.normals[2], 0),
    ];
    let smooth = unit_or(s, &mix3(s, &normals, &shares), &flat);
    // Where the model has none at a corner, there is none between.
    let has_all = s.lt(s.splat(0.0), s.load(&corners.has_normals));
    let smooth = select3(s, has_all, &smooth, &flat);
    Outward { p, n, smooth: world_normal(s, transform, &smooth) }
}

/// The corners of triangles and their normals.
struct Corners {
    points: [[Column; 3]; 3],
    normals: [[Column; 3]; 3],
    /// 1 where every corner has a normal.
    has_normals: Column,
}

impl Corners {
    const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        Self { points: [[zero; 3]; 3], normals: [[zero; 3]; 3], has_normals: zero }
    };

    #[inline(always)]
    fn put(&mut self, lane: usize, mesh: &TriangleMesh, triangle: [u32; 3]) {
        let mut has_all = !mesh.normals.is_empty();
        for (corner, index) in triangle.into_iter().enumerate() {
            let p = mesh.positions[index as usize];
            for k in 0..3 {
                self.points[corner][k][lane] = p[k];
            }
            if let Some(&n) = mesh.normals.get(index as usize) {
                has_all &= n != Vec3::ZERO;
                for k in 0..3 {
                    self.normals[corner][k][lane] = n[k];
                }
            }
        }
        self.has_normals[lane] = if has_all { 1.0 } else { 0.0 };
    }
}

/// The largest component without its sign.
#[inline(always)]
fn largest3<S: Simd>(s: S, v: &[S::F; 3]) -> S::F {
    s.max(s.max(s.abs(v[0]), s.abs(v[1])), s.abs(v[2]))
}

#[inline(always)]
fn div3<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> [S::F; 3] {
    [s.div(a[0], b[0]), s.div(a[1], b[1]), s.div(a[2], b[2])]
}

/// The corners mixed by their shares.
#[inline(always)]
fn mix3<S: Simd>(s: S, [a, b, c]: &[[S::F; 3]; 3], shares: &[S::F; 3]) -> [S::F; 3] {
    along3(s, &along3(s, &scale3(s, a, shares[0]), b, shares[1]), c, shares[2])
}

/// v/|v|, or `otherwise` where v has no direction.
#[inline(always)]
fn unit_or<S: Simd>(s: S, v: &[S::F; 3], otherwise: &[S::F; 3]) -> [S::F; 3] {
    let by = s.div(s.splat(1.0), s.sqrt(dot(s, v, v)));
    let has = s.and(s.lt(s.splat(0.0), by), s.lt(by, s.splat(f32::INFINITY)));
    select3(s, has, &scale3(s, v, by), otherwise)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::packet::store3;
    use crate::accel::simd::{Instructions, Kernel};

    struct Mix([Vec3; 3], [f32; 2]);

    impl Kernel for Mix {
        type Output = Vec3;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Vec3 {
            let Self([a, b, c], [u, v]) = self;
            let corners = [splat3(s, a.into()), splat3(s, b.into()), splat3(s, c.into())];
            let shares = splat3(s, [1.0 - u - v, u, v]);
            let mut out = [[0.0; BLOCK]; 3];
            store3(s, &mix3(s, &corners, &shares), &mut out, 0);
            Vec3::from(out.map(|column| column[0]))
        }
    }

    #[test]
    fn c7_barycentric_coordinates_mix_the_corners() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for set in Instructions::available() {
            assert_eq!(set.run(Mix(corners, [0.0, 0.0])), Vec3::ZERO);
            assert_eq!(set.run(Mix(corners, [0.25, 0.5])), Vec3::new(0.25, 0.5, 0.0));
        }
    }
}
