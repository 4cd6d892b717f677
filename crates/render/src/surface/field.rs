//! What the points and normals of each primitive are worked out from, in lanes.

use super::Points;
use crate::accel::packet::{along3, dot, scale3, sub3, unit3};
use crate::accel::simd::Simd;
use crate::compile::{Form, Primitive, reach_of};
use vitrine_math::Vec3;

/// A ball's or a flat form's normals in one formula, so that lanes need not part ways: n = (p − center)/radius + flat. A
/// flat form has 1/radius = 0, a ball flat = 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct NormalField {
    center: [f32; 3],
    flat: [f32; 3],
    radius: f32,
    inv_radius: f32,
    /// The largest number that takes part in finding the form, whatever point of it is hit. Rounding is a part of it.
    pub reach: f32,
    /// Whether the formula does not hold: boxes, ellipsoids, meshes.
    pub is_other: bool,
    /// The index of the first material.
    pub material: u32,
    /// Whether a mesh's triangles choose among materials from the first on.
    pub by_triangle: bool,
}

impl NormalField {
    /// Of a primitive.
    pub fn new(primitive: &Primitive) -> Self {
        let &Primitive { material, by_triangle, .. } = primitive;
        Self { material, by_triangle, ..Self::of_form(primitive) }
    }

    fn of_form(primitive: &Primitive) -> Self {
        let flat = |points: &[Vec3], n: &Vec3| Self {
            center: points[0].into(),
            flat: (*n).into(),
            reach: points.iter().map(|p| p.abs().max_element()).fold(0.0, f32::max),
            ..Self::default()
        };
        let other = |reach: f32| Self { reach, is_other: true, ..Self::default() };
        match &primitive.form {
            Form::Sphere { center, radius } => Self {
                center: (*center).into(),
                radius: *radius,
                inv_radius: 1.0 / radius,
                reach: center.abs().max_element() + radius,
                ..Self::default()
            },
            Form::Plane { point, n } => flat(&[*point], n),
            Form::Disc { unit, n } => {
                let reach = reach_of(unit, Vec3::new(1.0, 0.0, 1.0));
                Self { reach, ..flat(&[unit.point(Vec3::ZERO)], n) }
            }
            Form::Triangle { points, n, .. } => flat(points, n),
            Form::Box { unit } | Form::Ellipsoid { unit } => other(reach_of(unit, Vec3::ONE)),
            Form::Mesh { bounds, .. } => {
                let size =
                    if bounds.is_empty() { Vec3::ZERO } else { bounds.min.abs().max(bounds.max.abs()) };
                other(reach_of(&primitive.transform, size))
            }
        }
    }
}

/// The normal fields of hits in lanes.
#[derive(Clone, Copy)]
pub struct Fields<S: Simd> {
    center: [S::F; 3],
    flat: [S::F; 3],
    radius: S::F,
    inv_radius: S::F,
    reach: S::F,
}

impl<S: Simd> Fields<S> {
    /// Of nothing.
    #[inline(always)]
    pub fn empty(s: S) -> Self {
        let zero = s.splat(0.0);
        Self { center: [zero; 3], flat: [zero; 3], radius: zero, inv_radius: zero, reach: zero }
    }

    /// Puts a field into the lanes of the mask.
    #[inline(always)]
    pub fn put(&mut self, s: S, mask: S::M, field: &NormalField) {
        for k in 0..3 {
            self.center[k] = s.select(mask, s.splat(field.center[k]), self.center[k]);
            self.flat[k] = s.select(mask, s.splat(field.flat[k]), self.flat[k]);
        }
        self.radius = s.select(mask, s.splat(field.radius), self.radius);
        self.inv_radius = s.select(mask, s.splat(field.inv_radius), self.inv_radius);
        self.reach = s.select(mask, s.splat(field.reach), self.reach);
    }

    /// The points of the surface near points p, seen along d.
    #[inline(always)]
    pub fn points(&self, s: S, p: &[S::F; 3], d: &[S::F; 3]) -> Points<S> {
        let zero = s.splat(0.0);
        let from_center = sub3(s, p, &self.center);
        let n = along3(s, &self.flat, &from_center, self.inv_radius);
        // Of unit length but for rounding, which is much where the ball is small and far away.
        let n = unit3(s, &n);
        // Back onto the surface: p − n·(⟨n, p − center⟩ − radius)
        let off = s.sub(self.radius, dot(s, &n, &from_center));
        let p = along3(s, p, &n, off);
        let wo = sub3(s, &[zero; 3], d);
        let is_outside = s.le(zero, dot(s, &n, &wo));
        let n = scale3(s, &n, s.select(is_outside, s.splat(1.0), s.splat(-1.0)));
        let reach = s.max(s.max(s.abs(p[0]), s.abs(p[1])), s.max(s.abs(p[2]), self.reach));
        Points { p, n, ns: n, wo, is_outside, reach }
    }
}
