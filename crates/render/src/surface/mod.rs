//! What shading needs to know of the points where rays meet surfaces, worked out once a hit, sixteen at a time.

mod coordinates;
mod field;

pub use field::NormalField;

use crate::accel::packet::{along3, load3};
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, Hit, HitStream, NOTHING, RayStream};
use crate::compile::{CompiledScene, Form, Primitive, unit_normal};
use field::Fields;
use vitrine_math::{Ray, Transform, Vec3};
use vitrine_scene::TriangleMesh;

/// How far rays start from the surface that they leave, as a part of the largest number that took part in finding it: some
/// times what rounding can move, and far less than can be seen.
pub const LIFT: f32 = 16.0 * f32::EPSILON;

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
    /// How far from the surface rays start that leave it.
    lift: Column,
}

impl SurfaceBlock {
    pub const EMPTY: Self = {
        let zero3 = [[0.0; BLOCK]; 3];
        Self {
            p: zero3,
            origin: zero3,
            n: zero3,
            ns: zero3,
            wo: zero3,
            side: [0.0; BLOCK],
            lift: [0.0; BLOCK],
        }
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
            lift: self.lift[lane],
        }
    }

    fn put(&mut self, lane: usize, surface: &SurfaceInteraction) {
        let origin = surface.origin();
        for k in 0..3 {
            self.p[k][lane] = surface.p[k];
            self.origin[k][lane] = origin[k];
            self.n[k][lane] = surface.n[k];
            self.ns[k][lane] = surface.ns[k];
        }
        self.side[lane] = if surface.is_outside { 1.0 } else { -1.0 };
        self.lift[lane] = surface.lift;
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
    /// How far from the surface rays start that leave it.
    pub lift: f32,
}

impl SurfaceInteraction {
    /// Where rays start that leave on the viewer's side.
    #[inline(always)]
    pub fn origin(&self) -> Vec3 {
        self.p + self.n * self.lift
    }

    /// Where rays start that leave on the other side.
    #[inline(always)]
    pub fn origin_beyond(&self) -> Vec3 {
        self.p - self.n * self.lift
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
        let primitive = hit.primitive as usize;
        let (p, outward, smooth) = self.primitives[primitive].point_of_other(ray, hit);
        let is_outside = outward.dot(wo) >= 0.0;
        let n = if is_outside { outward } else { -outward };
        let ns = if smooth.dot(n) >= 0.0 { smooth } else { -smooth };
        // A smooth normal that the viewer sees from behind would turn the shading inside out.
        let ns = if ns.dot(wo) > 0.0 { ns } else { n };
        let lift = LIFT * self.normals[primitive].reach.max(p.abs().max_element());
        SurfaceInteraction { p, n, ns, wo, is_outside, lift }
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
    fn point_of_other(&self, ray: &Ray, hit: &Hit) -> (Vec3, Vec3, Vec3) {
        match &self.form {
            Form::Ellipsoid { unit } => {
                let local = unit.object_from_world.transform_point3(ray.at(hit.t)).normalize();
                let n = unit.normal(local);
                (unit.point(local), n, n)
            }
            Form::Box { unit } => {
                let (axis, side) = face_hit(ray, hit.t, unit);
                let local = unit.object_from_world.transform_point3(ray.at(hit.t));
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

/// The face on which a ray has hit a box, which is the cube from −1 to 1 of a space of its own: its axis and side. Not by
/// where the point lies: on an edge that could be a face that is turned away from the ray.
fn face_hit(ray: &Ray, t: f32, unit: &Transform) -> (usize, f32) {
    let o = unit.object_from_world.transform_point3(ray.origin);
    let d = unit.object_from_world.transform_vector3(ray.direction);
    let (mut entry, mut exit) = ((f32::NEG_INFINITY, 0), (f32::INFINITY, 0));
    for k in 0..3 {
        let (near, far) = ((-d[k].signum() - o[k]) / d[k], (d[k].signum() - o[k]) / d[k]);
        if near > entry.0 {
            entry = (near, k);
        }
        if far < exit.0 {
            exit = (far, k);
        }
    }
    if (t - entry.0).abs() <= (t - exit.0).abs() {
        (entry.1, -d[entry.1].signum())
    } else {
        (exit.1, d[exit.1].signum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn c7_barycentric_coordinates_mix_the_corners() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        assert_eq!(mix3(corners, [0.0, 0.0]), Vec3::ZERO);
        assert_eq!(mix3(corners, [0.25, 0.5]), Vec3::new(0.25, 0.5, 0.0));
    }
}
