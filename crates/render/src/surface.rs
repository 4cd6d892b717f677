//! What shading needs to know of the point where a ray meets a surface, worked out once a hit.

use crate::accel::Hit;
use crate::compile::unit_normal;
use crate::compile::{CompiledMaterial, CompiledScene, Form, Primitive};
use std::f32::consts::PI;
use vitrine_math::{Ray, Vec2, Vec3};
use vitrine_scene::TriangleMesh;

/// A point of a surface, seen along a ray.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceInteraction {
    /// The point, put back onto the surface where rounding took it off. World space.
    pub p: Vec3,
    /// The unit normal of the form, on the viewer's side.
    pub n: Vec3,
    /// The unit normal for shading, on the viewer's side of the form.
    pub ns: Vec3,
    /// The unit direction to the viewer.
    pub wo: Vec3,
    /// Whether the viewer is on the outer side.
    pub is_outside: bool,
    /// The index of the material.
    pub material: u32,
}

impl CompiledScene {
    /// The point that a ray of unit direction hits.
    #[inline(always)]
    pub(crate) fn surface(&self, ray: &Ray, hit: &Hit) -> SurfaceInteraction {
        let primitive = &self.primitives[hit.primitive as usize];
        let wo = -ray.direction;
        let p = ray.at(hit.t);
        let (p, outward, smooth) = match &primitive.form {
            Form::Sphere { center, inv_radius } => {
                let n = ((p - *center) * *inv_radius).normalize();
                (*center + n / *inv_radius, n, n)
            }
            Form::Plane { n } => (p, *n, *n),
            _ => primitive.point_of_other(p, hit),
        };
        let is_outside = outward.dot(wo) >= 0.0;
        let n = if is_outside { outward } else { -outward };
        let ns = if smooth.dot(n) >= 0.0 { smooth } else { -smooth };
        // A smooth normal that the viewer sees from behind would turn the shading inside out.
        let ns = if ns.dot(wo) > 0.0 { ns } else { n };
        SurfaceInteraction { p, n, ns, wo, is_outside, material: primitive.material_of(hit) }
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

    pub(crate) fn material(&self, surface: &SurfaceInteraction) -> &CompiledMaterial {
        &self.materials[surface.material as usize]
    }
}

impl Primitive {
    #[inline(always)]
    fn material_of(&self, hit: &Hit) -> u32 {
        match &self.form {
            Form::Mesh { accel, .. } if self.by_triangle => self.material + accel.slot(hit.triangle),
            _ => self.material,
        }
    }

    /// The point on the surface, the outward normal and the normal for shading, of forms other than balls and planes.
    fn point_of_other(&self, p: Vec3, hit: &Hit) -> (Vec3, Vec3, Vec3) {
        match &self.form {
            Form::Sphere { .. } | Form::Plane { .. } => (p, Vec3::Y, Vec3::Y),
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
            Form::Triangle { points, n, .. } => (mix3(*points, hit.uv), *n, *n),
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
