//! Where a point lies on the pictures of its surface.

use super::{HitPoints, Spot, lanes_of};
use crate::accel::packet::{dot, moved, splat3, store3};
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Hit};
use crate::compile::{CompiledScene, Form, Primitive};
use std::f32::consts::PI;
use vitrine_math::{Frame, Transform, Vec2, Vec3};

impl CompiledScene {
    /// Where on their surface's pictures points lie, in lanes that all hit the same thing or others of its material: u to the
    /// right, v up.
    #[inline(always)]
    pub(super) fn texture_points<S: Simd>(&self, s: S, mask: S::M, points: &HitPoints<S>) -> [S::F; 2] {
        let at = points.at;
        let primitives = s.load(&at.hits.primitive[at.start..]);
        let mut uv = [s.splat(0.0); 2];
        let mut left = s.bits(mask);
        while left != 0 {
            let id = at.hits.primitive[at.start + left.trailing_zeros() as usize];
            let same = s.and(mask, s.eq(primitives, s.splat(id)));
            left &= !s.bits(same);
            let [u, v] = self.primitives[id.to_bits() as usize].points_on(s, same, points);
            uv = [s.select(same, u, uv[0]), s.select(same, v, uv[1])];
        }
        uv
    }
}

impl Primitive {
    /// Where points lie on the pictures of this thing, in the lanes that hit it.
    #[inline(always)]
    fn points_on<S: Simd>(&self, s: S, mask: S::M, points: &HitPoints<S>) -> [S::F; 2] {
        let HitPoints { at, p, .. } = points;
        match &self.form {
            Form::Plane { .. } => {
                let local = moved(s, &self.transform.object_from_world, p);
                [local[0], s.sub(s.splat(0.0), local[2])]
            }
            // The square around it, seen from above: right is +x, up is −z.
            Form::Disc { unit, .. } => {
                let [x, _, z] = moved(s, &unit.object_from_world, p);
                let (half, one, minus) = (s.splat(0.5), s.splat(1.0), s.splat(-1.0));
                // On the rim rounding must not reach the picture's other side.
                let (x, z) = (s.max(s.min(x, one), minus), s.max(s.min(z, one), minus));
                [s.mul(half, s.add(one, x)), s.mul(half, s.sub(one, z))]
            }
            Form::Triangle { uvs, .. } => {
                let (b, c) = (s.load(&at.hits.u[at.start..]), s.load(&at.hits.v[at.start..]));
                let shares = [s.sub(s.sub(s.splat(1.0), b), c), b, c];
                let at_corners = |k: usize| uvs.map(|uv| uv[k]);
                [dot(s, &splat3(s, at_corners(0)), &shares), dot(s, &splat3(s, at_corners(1)), &shares)]
            }
            _ => {
                let mut world = [[0.0; BLOCK]; 3];
                let mut uv = [[0.0; BLOCK]; 2];
                store3(s, p, &mut world, 0);
                for lane in lanes_of(s.bits(mask)) {
                    let p = Vec3::new(world[0][lane], world[1][lane], world[2][lane]);
                    let [u, v] = self.texture_point(p, &at.hits.get(at.start + lane));
                    (uv[0][lane], uv[1][lane]) = (u, v);
                }
                [s.load(&uv[0]), s.load(&uv[1])]
            }
        }
    }

    /// Where a point lies on the pictures of a ball, a box or a mesh.
    fn texture_point(&self, p: Vec3, hit: &Hit) -> [f32; 2] {
        let local = || self.transform.object_from_world.transform_point3(p);
        match &self.form {
            Form::Sphere { .. } | Form::Ellipsoid { .. } => spherical(local()),
            Form::Box { unit } => face(unit.object_from_world.transform_point3(p), unit),
            Form::Mesh { mesh, bounds, .. } if mesh.uvs.is_empty() => spherical(local() - bounds.center()),
            Form::Mesh { mesh, .. } => {
                let corners = mesh.triangles[hit.triangle as usize];
                mix(corners.map(|i| mesh.uvs[i as usize]), hit.uv).into()
            }
            Form::Plane { .. } | Form::Disc { .. } | Form::Triangle { .. } => {
                unreachable!("lanes have their own formula")
            }
        }
    }
}

impl Primitive {
    /// The ways over the surface in which u and v grow, in metres for each 1 of u and v.
    pub(super) fn tangents(&self, spot: &Spot) -> [Vec3; 2] {
        let place = &self.transform;
        let local = || place.object_from_world.transform_point3(spot.p);
        match &self.form {
            Form::Plane { .. } => [place.vector(Vec3::X), place.vector(Vec3::NEG_Z)],
            Form::Disc { unit, .. } => [unit.vector(Vec3::X) * 2.0, unit.vector(Vec3::NEG_Z) * 2.0],
            Form::Triangle { points, uvs, .. } => slopes(*points, uvs.map(Vec2::from), spot.ns),
            Form::Box { unit } => {
                let p = unit.object_from_world.transform_point3(spot.p);
                let [u, v] = match face_of(p, unit) {
                    (0, side) => [Vec3::Z * -side, Vec3::Y],
                    (1, side) => [Vec3::X, Vec3::Z * -side],
                    (_, side) => [Vec3::X * side, Vec3::Y],
                };
                [unit.vector(u) * 2.0, unit.vector(v) * 2.0]
            }
            Form::Sphere { .. } | Form::Ellipsoid { .. } => round_tangents(local()).map(|t| place.vector(t)),
            Form::Mesh { mesh, bounds, .. } if mesh.uvs.is_empty() => {
                round_tangents(local() - bounds.center()).map(|t| place.vector(t))
            }
            Form::Mesh { mesh, .. } => {
                let corners = mesh.triangles[spot.hit.triangle as usize];
                let points = corners.map(|i| place.point(mesh.positions[i as usize]));
                slopes(points, corners.map(|i| mesh.uvs[i as usize]), spot.ns)
            }
        }
    }
}

/// Along the circles of latitude and of longitude.
fn round_tangents(p: Vec3) -> [Vec3; 2] {
    let (r, across) = (p.length(), Vec3::new(p.z, 0.0, -p.x));
    let ring = across.length();
    // At the poles any direction will do.
    let u = if ring > 1e-6 * r { across * (2.0 * PI) } else { Vec3::X * (2.0 * PI * r) };
    let up = if ring > 1e-6 * r {
        (Vec3::Y * (ring * ring) - Vec3::new(p.x, 0.0, p.z) * p.y) / ring
    } else {
        Vec3::Z * r
    };
    [u, up * PI]
}

/// How a point moves as u and v grow over a triangle; any two ways along it where its pictures have no area.
fn slopes([a, b, c]: [Vec3; 3], [ta, tb, tc]: [Vec2; 3], n: Vec3) -> [Vec3; 2] {
    let ([p, q], [s, t]) = ([b - a, c - a], [tb - ta, tc - ta]);
    let area = s.x * t.y - s.y * t.x;
    if area.abs() <= f32::MIN_POSITIVE {
        let frame = Frame::around(n);
        return [frame.x, frame.y];
    }
    [(p * t.y - q * s.y) / area, (q * s.x - p * t.x) / area]
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

/// The face on which a point of the surface lies, of a box that is the cube from −1 to 1 of a space of its own: its axis and
/// side. It is the nearest one in the world, where rounding is the same along all axes; a thin box's own space stretches it.
fn face_of(p: Vec3, unit: &Transform) -> (usize, f32) {
    let m = unit.world_from_object.matrix3;
    let away = |k: usize| {
        let d = p[k].abs() - 1.0;
        d * d * m.col(k).length_squared()
    };
    let away = [away(0), away(1), away(2)];
    let axis = if away[0] <= away[1] && away[0] <= away[2] {
        0
    } else if away[1] <= away[2] {
        1
    } else {
        2
    };
    (axis, if p[axis] < 0.0 { -1.0 } else { 1.0 })
}

/// Each face of the cube shows the whole picture upright, the top and bottom as seen from the front.
fn face(p: Vec3, unit: &Transform) -> [f32; 2] {
    let [u, v] = match face_of(p, unit) {
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
        let face = |p| face(p, &Transform::default());
        assert_eq!(face(Vec3::new(0.5, 0.0, 1.0)), [0.75, 0.5], "front: right is +x");
        assert_eq!(face(Vec3::new(-0.5, 0.0, -1.0)), [0.75, 0.5], "back: right is −x");
        assert_eq!(face(Vec3::new(1.0, 0.5, -0.5)), [0.75, 0.75], "right side: right is −z");
        assert_eq!(face(Vec3::new(0.5, 1.0, -0.5)), [0.75, 0.75], "top: up is −z");
    }
}
