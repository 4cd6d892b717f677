//! Boxes that shine outward: a point is chosen evenly on the faces that are seen, of which there are three at most.

use super::form::Chosen;
use vitrine_math::{Transform, Vec3};

/// The cube from −1 to 1 of a space of its own.
#[derive(Clone, Copy, Debug)]
pub struct Cuboid {
    unit: Transform,
    /// Of the faces across x, y and z; metres².
    areas: Vec3,
}

impl Cuboid {
    /// None without any area, or where it is too large to compute with.
    pub fn new(unit: &Transform) -> Option<Self> {
        let m = &unit.world_from_object.matrix3;
        let face = |a: glam::Vec3A, b: glam::Vec3A| 4.0 * a.cross(b).length();
        let areas = Vec3::new(face(m.y_axis, m.z_axis), face(m.z_axis, m.x_axis), face(m.x_axis, m.y_axis));
        let sum = areas.element_sum();
        (sum > 0.0 && sum.is_finite()).then_some(Self { unit: *unit, areas })
    }

    /// The centre and the radius of a ball around it.
    pub fn around(&self) -> (Vec3, f32) {
        let corners = [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]];
        let reach = corners.map(|corner| self.unit.vector(Vec3::from(corner)).length());
        (self.unit.point(Vec3::ZERO), reach.into_iter().fold(0.0, f32::max))
    }

    /// Metres².
    pub fn area(&self) -> f32 {
        2.0 * self.areas.element_sum()
    }

    /// A point that is seen from `p`; None from inside.
    pub fn choose(&self, p: Vec3, u: [f32; 2]) -> Option<Chosen> {
        let (q, seen) = self.seen_from(p);
        let whole = seen.element_sum();
        if whole <= 0.0 {
            return None;
        }
        // The share of the first number that chose the face is stretched to choose within it.
        let mut rest = u[0] * whole;
        let mut face = if seen.z > 0.0 { 2 } else { usize::from(seen.y > 0.0) };
        for k in 0..3 {
            if rest < seen[k] {
                face = k;
                break;
            }
            if k != face {
                rest -= seen[k];
            }
        }
        let across = (rest / seen[face]).clamp(0.0, 1.0);
        let (mut s, mut n) = (Vec3::ZERO, Vec3::ZERO);
        n[face] = if q[face] > 0.0 { 1.0 } else { -1.0 };
        s[face] = n[face];
        s[(face + 1) % 3] = 2.0 * across - 1.0;
        s[(face + 2) % 3] = 2.0 * u[1] - 1.0;
        Some(Chosen { y: self.unit.point(s), n: self.unit.normal(n), pdf: 1.0 / whole })
    }

    /// The density, 1/m², with which [`Self::choose`] finds `y`, a point of it: 0 on a face that is not seen.
    pub fn pdf(&self, p: Vec3, y: Vec3) -> f32 {
        let (q, seen) = self.seen_from(p);
        let s = self.unit.object_from_world.transform_point3(y);
        let face = s.abs().max_position();
        let is_seen = seen[face] > 0.0 && q[face] * s[face] > 0.0;
        if is_seen { 1.0 / seen.element_sum() } else { 0.0 }
    }

    /// `p` in the space of the cube, and the areas of the faces that are seen from there.
    fn seen_from(&self, p: Vec3) -> (Vec3, Vec3) {
        let q = self.unit.object_from_world.transform_point3(p);
        (q, Vec3::select(q.abs().cmpgt(Vec3::ONE), self.areas, Vec3::ZERO))
    }
}
