//! Balls that were stretched unevenly and shine outward.
//!
//! What is seen from a point stays seen when space is stretched: so a point is chosen evenly on the cap that is seen of the unit
//! ball, and its density is divided by how much the surface is stretched there.

use super::form::Chosen;
use std::f32::consts::TAU;
use vitrine_math::{Frame, Transform, Vec3};

/// The unit ball of a space of its own.
#[derive(Clone, Copy, Debug)]
pub struct Ellipsoid {
    unit: Transform,
    /// |det| of the way to the world.
    volume: f32,
}

impl Ellipsoid {
    /// None where it is too thin to compute with.
    pub fn new(unit: &Transform) -> Option<Self> {
        let volume = unit.world_from_object.matrix3.determinant().abs();
        (volume > 0.0 && volume.is_finite()).then_some(Self { unit: *unit, volume })
    }

    /// The centre and the radius of a ball around it.
    pub fn around(&self) -> (Vec3, f32) {
        let m = &self.unit.world_from_object.matrix3;
        let reach2 = [m.x_axis, m.y_axis, m.z_axis].map(glam::Vec3A::length_squared);
        // No axis is longer than all columns together.
        (self.unit.point(Vec3::ZERO), (reach2[0] + reach2[1] + reach2[2]).sqrt())
    }

    /// Metres².
    pub fn area(&self) -> f32 {
        // Thomsen's formula, p = 1.6075: off by 1 % at most; it only says how much light there is.
        let m = &self.unit.world_from_object.matrix3;
        let faces = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
        let sum: f32 = faces.map(|face| libm::powf(face.length(), 1.6075)).iter().sum();
        2.0 * TAU * libm::powf(sum / 3.0, 1.0 / 1.6075)
    }

    /// A point that is seen from `p`; None from inside.
    pub fn choose(&self, p: Vec3, u: [f32; 2]) -> Option<Chosen> {
        let q = self.unit.object_from_world.transform_point3(p);
        let distance = q.length();
        if !(distance > 1.0 && distance < f32::INFINITY) {
            return None;
        }
        // The cap is 1/|q| ≤ cos α ≤ 1, and area is even in cos α.
        let rest = u[0] * (1.0 - 1.0 / distance);
        let sin = (rest * (2.0 - rest)).max(0.0).sqrt();
        let (sin_turn, cos_turn) = libm::sincosf(TAU * u[1]);
        let s = Frame::around(q / distance).world(Vec3::new(sin * cos_turn, sin * sin_turn, 1.0 - rest));
        let pdf = self.pdf_at(distance, s)?;
        Some(Chosen { y: self.unit.point(s), n: self.unit.normal(s), pdf })
    }

    /// The density, 1/m², with which [`Self::choose`] finds `y`.
    pub fn pdf(&self, p: Vec3, y: Vec3) -> f32 {
        let to_unit = &self.unit.object_from_world;
        let (q, s) = (to_unit.transform_point3(p), to_unit.transform_point3(y));
        let is_seen = q.length_squared() > 1.0 && q.dot(s) > 1.0;
        if is_seen { self.pdf_at(q.length(), s).unwrap_or(0.0) } else { 0.0 }
    }

    /// Area is stretched by |det M|·|M⁻ᵀs|.
    fn pdf_at(&self, distance: f32, s: Vec3) -> Option<f32> {
        let covector = self.unit.object_from_world.matrix3.transpose() * s;
        let pdf = 1.0 / (TAU * (1.0 - 1.0 / distance) * self.volume * covector.length());
        (pdf > 0.0 && pdf.is_finite()).then_some(pdf)
    }
}
