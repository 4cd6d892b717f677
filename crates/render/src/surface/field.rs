//! What the points and normals of each primitive are worked out from, in lanes.

use super::{LIFT, SurfaceBlock};
use crate::accel::packet::{along3, dot, load3, sub3};
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column};
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
}

impl NormalField {
    /// Of a primitive.
    pub fn new(primitive: &Primitive) -> Self {
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

/// The normal fields of sixteen hits.
pub struct Fields {
    center: [Column; 3],
    flat: [Column; 3],
    radius: Column,
    inv_radius: Column,
    reach: Column,
}

impl Fields {
    pub const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        Self { center: [zero; 3], flat: [zero; 3], radius: zero, inv_radius: zero, reach: zero }
    };

    #[inline(always)]
    pub fn put(&mut self, lane: usize, field: &NormalField) {
        for k in 0..3 {
            self.center[k][lane] = field.center[k];
            self.flat[k][lane] = field.flat[k];
        }
        self.radius[lane] = field.radius;
        self.inv_radius[lane] = field.inv_radius;
        self.reach[lane] = field.reach;
    }

    /// The points of the surface near points p, seen along d.
    #[inline(always)]
    pub fn surface<S: Simd>(&self, s: S, to: &mut SurfaceBlock, start: usize, [p, d]: [[S::F; 3]; 2]) {
        let zero = s.splat(0.0);
        let from_center = sub3(s, &p, &load3(s, &self.center, start));
        let n = along3(s, &load3(s, &self.flat, start), &from_center, s.load(&self.inv_radius[start..]));
        // Of unit length but for rounding, which is much where the ball is small and far away.
        let n = along3(s, &[zero; 3], &n, s.div(s.splat(1.0), s.sqrt(dot(s, &n, &n))));
        // Back onto the surface: p − n·(⟨n, p − center⟩ − radius)
        let off = s.sub(s.load(&self.radius[start..]), dot(s, &n, &from_center));
        let p = along3(s, &p, &n, off);
        let wo = sub3(s, &[zero; 3], &d);
        let outside = s.le(zero, dot(s, &n, &wo));
        let side = s.select(outside, s.splat(1.0), s.splat(-1.0));
        let n = along3(s, &[zero; 3], &n, side);
        let largest =
            s.max(s.max(s.abs(p[0]), s.abs(p[1])), s.max(s.abs(p[2]), s.load(&self.reach[start..])));
        let lift = s.mul(largest, s.splat(LIFT));
        let origin = along3(s, &p, &n, lift);
        s.store(side, &mut to.side[start..]);
        s.store(lift, &mut to.lift[start..]);
        for k in 0..3 {
            s.store(origin[k], &mut to.origin[k][start..]);
            s.store(p[k], &mut to.p[k][start..]);
            s.store(n[k], &mut to.n[k][start..]);
            s.store(n[k], &mut to.ns[k][start..]);
            s.store(wo[k], &mut to.wo[k][start..]);
        }
    }
}
