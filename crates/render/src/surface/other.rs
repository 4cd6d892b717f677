//! Points and normals of forms that need more than the one formula of [`NormalField`](super::NormalField).

use super::{LIFT, Points};
use crate::accel::packet::{load3, select3};
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column, Hit};
use crate::compile::{CompiledScene, Form, Primitive, unit_normal};
use vitrine_math::{Ray, Transform, Vec3};
use vitrine_scene::TriangleMesh;

/// Points of such forms, worked out one by one.
pub struct Others {
    p: [Column; 3],
    n: [Column; 3],
    ns: [Column; 3],
    lift: Column,
    /// 1 where the viewer is on the outer side, −1 where on the inner, 0 in lanes without such a point.
    side: Column,
}

impl Others {
    pub const NONE: Self = {
        let zero = [0.0; BLOCK];
        Self { p: [zero; 3], n: [zero; 3], ns: [zero; 3], lift: zero, side: zero }
    };

    /// Works out the point of a hit.
    pub fn put(&mut self, lane: usize, scene: &CompiledScene, ray: &Ray, hit: &Hit) {
        let wo = -ray.direction;
        let primitive = hit.primitive as usize;
        let (p, outward, smooth) = scene.primitives[primitive].point_of_other(ray, hit);
        let is_outside = outward.dot(wo) >= 0.0;
        let n = if is_outside { outward } else { -outward };
        let ns = if smooth.dot(n) >= 0.0 { smooth } else { -smooth };
        // A smooth normal that the viewer sees from behind would turn the shading inside out.
        let ns = if ns.dot(wo) > 0.0 { ns } else { n };
        for k in 0..3 {
            (self.p[k][lane], self.n[k][lane], self.ns[k][lane]) = (p[k], n[k], ns[k]);
        }
        self.lift[lane] = LIFT * scene.normals[primitive].reach.max(p.abs().max_element());
        self.side[lane] = if is_outside { 1.0 } else { -1.0 };
    }

    /// Puts them in the place of those that the formula gave.
    #[inline(always)]
    pub fn replace<S: Simd>(&self, s: S, points: &mut Points<S>) {
        let (zero, side) = (s.splat(0.0), s.load(&self.side));
        let outside = s.lt(zero, side);
        let mask = s.or(outside, s.lt(side, zero));
        points.p = select3(s, mask, &load3(s, &self.p, 0), &points.p);
        points.n = select3(s, mask, &load3(s, &self.n, 0), &points.n);
        points.ns = select3(s, mask, &load3(s, &self.ns, 0), &points.ns);
        points.lift = s.select(mask, s.load(&self.lift), points.lift);
        points.is_outside = s.or(outside, s.and_not(points.is_outside, mask));
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
