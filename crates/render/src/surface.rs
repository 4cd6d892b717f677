//! What shading needs to know of the points where rays meet surfaces, worked out once a hit, sixteen at a time.

use crate::accel::packet::{along3, dot, load3, sub3};
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, Hit, HitStream, NOTHING, RayStream};
use crate::compile::{CompiledScene, Form, Primitive, unit_normal};
use std::f32::consts::PI;
use vitrine_math::{Ray, Vec2, Vec3, offset_origin};
use vitrine_scene::TriangleMesh;

/// Points of surfaces, each seen along a ray. Places without a hit mean nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct SurfaceBlock {
    /// The points, put back onto the surface where rounding took them off. World space.
    p: [Column; 3],
    /// Where rays start that leave on the viewer's side.
    pub origin: [Column; 3],
    /// The unit normals of the forms, on the viewer's side.
    pub n: [Column; 3],
    /// The unit normals for shading, on the viewer's side of the form.
    pub ns: [Column; 3],
    /// The unit directions to the viewer.
    pub wo: [Column; 3],
    /// 1 where the viewer is on the outer side, else −1.
    side: Column,
}

impl SurfaceBlock {
    pub const EMPTY: Self = {
        let zero3 = [[0.0; BLOCK]; 3];
        Self { p: zero3, origin: zero3, n: zero3, ns: zero3, wo: zero3, side: [0.0; BLOCK] }
    };

    /// One of the points.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> SurfaceInteraction {
        let at = |v: &[Column; 3]| Vec3::new(v[0][lane], v[1][lane], v[2][lane]);
        SurfaceInteraction {
            p: at(&self.p),
            n: at(&self.n),
            ns: at(&self.ns),
            wo: at(&self.wo),
            is_outside: self.side[lane] > 0.0,
        }
    }

    fn put(&mut self, lane: usize, surface: &SurfaceInteraction) {
        let origin = offset_origin(surface.p, surface.n);
        for k in 0..3 {
            self.p[k][lane] = surface.p[k];
            self.origin[k][lane] = origin[k];
            self.n[k][lane] = surface.n[k];
            self.ns[k][lane] = surface.ns[k];
        }
        self.side[lane] = if surface.is_outside { 1.0 } else { -1.0 };
    }
}

/// A point of a surface, seen along a ray.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceInteraction {
    /// The point. World space.
    pub p: Vec3,
    /// The unit normal of the form, on the viewer's side.
    pub n: Vec3,
    /// The unit normal for shading, on the viewer's side of the form.
    pub ns: Vec3,
    /// The unit direction to the viewer.
    pub wo: Vec3,
    /// Whether the viewer is on the outer side.
    pub is_outside: bool,
}

/// A ball's or a flat form's normals in one formula, so that lanes need not part ways: n = (p − center)/radius + flat. A
/// flat form has 1/radius = 0, a ball flat = 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct NormalField {
    center: [f32; 3],
    flat: [f32; 3],
    radius: f32,
    inv_radius: f32,
    /// Whether the formula does not hold: boxes, ellipsoids, meshes.
    is_other: bool,
}

impl NormalField {
    /// Of a primitive.
    pub fn new(form: &Form) -> Self {
        match form {
            Form::Sphere { center, radius } => Self {
                center: (*center).into(),
                radius: *radius,
                inv_radius: 1.0 / radius,
                ..Self::default()
            },
            Form::Plane { point, n } | Form::Triangle { points: [point, ..], n, .. } => {
                Self { center: (*point).into(), flat: (*n).into(), ..Self::default() }
            }
            Form::Box { .. } | Form::Ellipsoid { .. } | Form::Mesh { .. } => {
                Self { is_other: true, ..Self::default() }
            }
        }
    }
}

impl CompiledScene {
    /// The points that rays of unit direction hit.
    pub(crate) fn surfaces(&self, rays: &RayStream, hits: &HitStream, surfaces: &mut Vec<SurfaceBlock>) {
        surfaces.resize(rays.len().div_ceil(BLOCK), SurfaceBlock::EMPTY);
        self.accel.instructions.run(Surfaces { scene: self, rays, hits, surfaces });
    }

    /// The same for one hit on a form that needs more than the one formula.
    fn other_surface(&self, ray: &Ray, hit: &Hit) -> SurfaceInteraction {
        let wo = -ray.direction;
        let (p, outward, smooth) = self.primitives[hit.primitive as usize].point_of_other(ray.at(hit.t), hit);
        let is_outside = outward.dot(wo) >= 0.0;
        let n = if is_outside { outward } else { -outward };
        let ns = if smooth.dot(n) >= 0.0 { smooth } else { -smooth };
        // A smooth normal that the viewer sees from behind would turn the shading inside out.
        let ns = if ns.dot(wo) > 0.0 { ns } else { n };
        SurfaceInteraction { p, n, ns, wo, is_outside }
    }

    /// Where on its surface's pictures a point lies: u to the right, v up.
    pub(crate) fn texture_point(&self, p: Vec3, hit: &Hit) -> [f32; 2] {
        let primitive = &self.primitives[hit.primitive as usize];
        let local = || primitive.transform.object_from_world.transform_point3(p);
        match &primitive.form {
            Form::Sphere { .. } | Form::Ellipsoid { .. } => spherical(local()),
            Form::Plane { .. } => [local().x, -local().z],
            Form::Box { unit } => face(unit.object_from_world.transform_point3(p)),
            Form::Triangle { uvs, .. } => mix(uvs.map(Vec2::from), hit.uv).into(),
            Form::Mesh { mesh, center, .. } if mesh.uvs.is_empty() => spherical(local() - *center),
            Form::Mesh { mesh, .. } => {
                let corners = mesh.triangles[hit.triangle as usize];
                mix(corners.map(|i| mesh.uvs[i as usize]), hit.uv).into()
            }
        }
    }
}

struct Surfaces<'a> {
    scene: &'a CompiledScene,
    rays: &'a RayStream,
    hits: &'a HitStream,
    surfaces: &'a mut [SurfaceBlock],
}

impl Kernel for Surfaces<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let scene = self.scene;
        for (index, (rays, surface)) in self.rays.blocks().iter().zip(self.surfaces).enumerate() {
            let hits = self.hits.block(index);
            let (mut fields, mut others) = (Fields::EMPTY, 0_u32);
            for lane in 0..BLOCK {
                let primitive = hits.primitive[lane].to_bits();
                if primitive != NOTHING {
                    let field = &scene.normals[primitive as usize];
                    fields.put(lane, field);
                    others |= u32::from(field.is_other) << lane;
                }
            }
            for start in (0..BLOCK).step_by(S::LANES) {
                let d = load3(s, &rays.direction, start);
                let p = along3(s, &load3(s, &rays.origin, start), &d, s.load(&hits.t[start..]));
                fields.surface(s, surface, start, [p, d]);
            }
            for lane in 0..BLOCK {
                let [p, n] = [&surface.p, &surface.n].map(|v| Vec3::new(v[0][lane], v[1][lane], v[2][lane]));
                let origin = offset_origin(p, n);
                for k in 0..3 {
                    surface.origin[k][lane] = origin[k];
                }
            }
            while others != 0 {
                let lane = others.trailing_zeros() as usize;
                others &= others - 1;
                let i = index * BLOCK + lane;
                if let Some(hit) = self.hits.get(i) {
                    surface.put(lane, &scene.other_surface(&self.rays.get(i), &hit));
                }
            }
        }
    }
}

/// The normal fields of sixteen hits.
struct Fields {
    center: [Column; 3],
    flat: [Column; 3],
    radius: Column,
    inv_radius: Column,
}

impl Fields {
    const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        Self { center: [zero; 3], flat: [zero; 3], radius: zero, inv_radius: zero }
    };

    #[inline(always)]
    fn put(&mut self, lane: usize, field: &NormalField) {
        for k in 0..3 {
            self.center[k][lane] = field.center[k];
            self.flat[k][lane] = field.flat[k];
        }
        self.radius[lane] = field.radius;
        self.inv_radius[lane] = field.inv_radius;
    }

    /// The points of the surface near points p, seen along d.
    #[inline(always)]
    fn surface<S: Simd>(&self, s: S, to: &mut SurfaceBlock, start: usize, [p, d]: [[S::F; 3]; 2]) {
        let zero = s.splat(0.0);
        let from_center = sub3(s, &p, &load3(s, &self.center, start));
        let n = along3(s, &load3(s, &self.flat, start), &from_center, s.load(&self.inv_radius[start..]));
        // One Newton step towards unit length, which it is but for rounding: n·(3 − ⟨n, n⟩)/2
        let correction = s.mul(s.sub(s.splat(3.0), dot(s, &n, &n)), s.splat(0.5));
        let n = along3(s, &[zero; 3], &n, correction);
        // Back onto the surface: p − n·(⟨n, p − center⟩ − radius)
        let off = s.sub(s.load(&self.radius[start..]), dot(s, &n, &from_center));
        let p = along3(s, &p, &n, off);
        let wo = sub3(s, &[zero; 3], &d);
        let outside = s.le(zero, dot(s, &n, &wo));
        let side = s.select(outside, s.splat(1.0), s.splat(-1.0));
        let n = along3(s, &[zero; 3], &n, side);
        s.store(side, &mut to.side[start..]);
        for k in 0..3 {
            s.store(p[k], &mut to.p[k][start..]);
            s.store(n[k], &mut to.n[k][start..]);
            s.store(n[k], &mut to.ns[k][start..]);
            s.store(wo[k], &mut to.wo[k][start..]);
        }
    }
}

impl Primitive {
    /// The index of the material where it is hit.
    #[inline(always)]
    pub(crate) fn material_of(&self, hit: &Hit) -> u32 {
        match &self.form {
            Form::Mesh { accel, .. } if self.by_triangle => self.material + accel.slot(hit.triangle),
            _ => self.material,
        }
    }

    /// The point on the surface, the outward normal and the normal for shading, of boxes, ellipsoids and meshes.
    fn point_of_other(&self, p: Vec3, hit: &Hit) -> (Vec3, Vec3, Vec3) {
        match &self.form {
            Form::Ellipsoid { unit } => {
                let local = unit.object_from_world.transform_point3(p).normalize();
                let n = unit.normal(local);
                (unit.point(local), n, n)
            }
            Form::Box { unit } => {
                let local = unit.object_from_world.transform_point3(p);
                let (axis, side) = face_of(local);
                let mut on_face = local.clamp(Vec3::NEG_ONE, Vec3::ONE);
                on_face[axis] = side;
                let n = unit.normal(Vec3::AXES[axis] * side);
                (unit.point(on_face), n, n)
            }
            Form::Sphere { .. } | Form::Plane { .. } | Form::Triangle { .. } => {
                unreachable!("its normals follow the one formula")
            }
            Form::Mesh { mesh, .. } => {
                let corners = mesh.triangles[hit.triangle as usize];
                let points = corners.map(|i| mesh.positions[i as usize]);
                let flat = unit_normal(points);
                let smooth = smooth_normal(mesh, corners, hit.uv).unwrap_or(flat);
                let to_world = |n| self.transform.normal(n);
                (self.transform.point(mix3(points, hit.uv)), to_world(flat), to_world(smooth))
            }
        }
    }
}

/// The normal between a triangle's corners, or None where the model has none.
fn smooth_normal(mesh: &TriangleMesh, corners: [u32; 3], uv: [f32; 2]) -> Option<Vec3> {
    if mesh.normals.is_empty() {
        return None;
    }
    let normals = corners.map(|i| mesh.normals[i as usize]);
    if normals.contains(&Vec3::ZERO) {
        return None;
    }
    mix3(normals, uv).try_normalize()
}

fn mix3([a, b, c]: [Vec3; 3], [u, v]: [f32; 2]) -> Vec3 {
    a * (1.0 - u - v) + b * u + c * v
}

fn mix([a, b, c]: [Vec2; 3], [u, v]: [f32; 2]) -> Vec2 {
    a * (1.0 - u - v) + b * u + c * v
}

/// Longitude and latitude: the picture's middle towards +Z, its upper edge at +Y.
fn spherical(p: Vec3) -> [f32; 2] {
    let r = p.length();
    if r == 0.0 {
        return [0.5, 0.5];
    }
    [0.5 + libm::atan2f(p.x, p.z) / (2.0 * PI), 0.5 + libm::asinf((p.y / r).clamp(-1.0, 1.0)) / PI]
}

/// The face of the cube from −1 to 1 on which a point lies: its axis and side.
fn face_of(p: Vec3) -> (usize, f32) {
    let a = p.abs();
    let axis = if a.x >= a.y && a.x >= a.z {
        0
    } else if a.y >= a.z {
        1
    } else {
        2
    };
    (axis, if p[axis] < 0.0 { -1.0 } else { 1.0 })
}

/// Each face of the cube shows the whole picture upright, the top and bottom as seen from the front.
fn face(p: Vec3) -> [f32; 2] {
    let [u, v] = match face_of(p) {
        (0, side) => [-side * p.z, p.y],
        (1, side) => [p.x, -side * p.z],
        (_, side) => [side * p.x, p.y],
    };
    [0.5 * (u + 1.0), 0.5 * (v + 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn c7_spherical_coordinates() {
        assert_eq!(spherical(Vec3::Z), [0.5, 0.5]);
        let [u, v] = spherical(Vec3::X);
        assert!((u - 0.75).abs() < 1e-6 && v == 0.5, "to the right of the middle");
        assert!((spherical(Vec3::Y)[1] - 1.0).abs() < 1e-6);
    }

    #[test]
    fn c7_faces_are_upright_seen_from_outside() {
        assert_eq!(face(Vec3::new(0.5, 0.0, 1.0)), [0.75, 0.5], "front: right is +x");
        assert_eq!(face(Vec3::new(-0.5, 0.0, -1.0)), [0.75, 0.5], "back: right is −x");
        assert_eq!(face(Vec3::new(1.0, 0.5, -0.5)), [0.75, 0.75], "right side: right is −z");
        assert_eq!(face(Vec3::new(0.5, 1.0, -0.5)), [0.75, 0.75], "top: up is −z");
    }

    #[test]
    fn c7_barycentric_coordinates_mix_the_corners() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        assert_eq!(mix3(corners, [0.0, 0.0]), Vec3::ZERO);
        assert_eq!(mix3(corners, [0.25, 0.5]), Vec3::new(0.25, 0.5, 0.0));
    }
}
