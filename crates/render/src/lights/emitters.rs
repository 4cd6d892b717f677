//! Objects that shine, and which light the triangle of an object is.

use super::cuboid::Cuboid;
use super::disc::Plate;
use super::ellipsoid::Ellipsoid;
use super::form::Form;
use super::sphere::Ball;
use super::triangle::Facet;
use vitrine_math::{Rgb, Transform, Vec3};

/// The form of a part of an object that shines.
#[derive(Clone, Copy, Debug)]
pub enum EmitterForm {
    /// A ball in world space.
    Sphere {
        /// The centre, metres.
        center: Vec3,
        /// Metres.
        radius: f32,
    },
    /// The unit ball of a space of its own.
    Ellipsoid {
        /// From that space to the world.
        unit: Transform,
    },
    /// The cube from −1 to 1 of a space of its own.
    Box {
        /// From that space to the world.
        unit: Transform,
    },
    /// The disc y = 0, x² + z² ≤ 1 of a space of its own.
    Disc {
        /// From that space to the world.
        unit: Transform,
        /// The unit normal of the side that shines, world space.
        n: Vec3,
    },
    /// A triangle in world space.
    Triangle {
        /// The corners: counter-clockwise seen from the side that shines.
        points: [Vec3; 3],
    },
}

/// A part of an object that shines.
#[derive(Clone, Copy, Debug)]
pub struct Emitter {
    /// The form.
    pub form: EmitterForm,
    /// The radiance that leaves it.
    pub radiance: Rgb,
    /// Whether discs and triangles shine to both sides; balls and boxes shine outward only.
    pub is_two_sided: bool,
    /// The primitive of the compiled scene that it is part of.
    pub primitive: u32,
    /// The triangle of the primitive; 0 where it has none.
    pub triangle: u32,
}

impl EmitterForm {
    /// The form that points are chosen on; None without any area.
    pub fn form(&self) -> Option<Form> {
        match self {
            Self::Sphere { center, radius } => {
                let is_round = *radius > 0.0 && radius.is_finite();
                is_round.then_some(Form::Ball(Ball { center: *center, radius: *radius }))
            }
            Self::Ellipsoid { unit } => Ellipsoid::new(unit).map(|form| Form::Ellipsoid(Box::new(form))),
            Self::Box { unit } => Cuboid::new(unit).map(|form| Form::Cuboid(Box::new(form))),
            Self::Disc { unit, n } => {
                let plate = Plate::new(unit.point(Vec3::ZERO), unit.vector(Vec3::Z), unit.vector(Vec3::X))?;
                let turn = plate.n.dot(*n) < 0.0;
                Some(Form::Plate(if turn { plate.turned() } else { plate }))
            }
            Self::Triangle { points } => Facet::new(*points).map(Form::Facet),
        }
    }
}

/// The light of each triangle of each primitive that shines.
#[derive(Clone, Debug, Default)]
pub struct EmitterTable {
    /// In ascending order.
    rows: Vec<(Place, u32)>,
    /// Primitives that shine, in ascending order: where their rows begin.
    starts: Vec<(u32, u32)>,
}

/// Primitive and triangle.
type Place = (u32, u32);

impl EmitterTable {
    /// By the primitive, the triangle and the light of each.
    pub fn new(mut rows: Vec<(Place, u32)>) -> Self {
        rows.sort_unstable();
        let mut starts: Vec<(u32, u32)> = Vec::new();
        for (i, ((primitive, _), _)) in rows.iter().enumerate() {
            if starts.last().is_none_or(|(last, _)| last != primitive) {
                starts.push((*primitive, i as u32));
            }
        }
        Self { rows, starts }
    }

    /// The light that a triangle of a primitive is.
    #[inline]
    pub fn light(&self, primitive: u32, triangle: u32) -> Option<u32> {
        let at = self.starts.binary_search_by_key(&primitive, |(held, _)| *held).ok()?;
        let start = self.starts[at].1 as usize;
        let end = self.starts.get(at + 1).map_or(self.rows.len(), |(_, end)| *end as usize);
        let rows = &self.rows[start..end];
        // A mesh whose triangles all shine has each at its place.
        let is_there = |row: &&(Place, u32)| row.0.1 == triangle;
        if let Some(row) = rows.get(triangle as usize).filter(is_there) {
            return Some(row.1);
        }
        rows.binary_search_by_key(&triangle, |row| row.0.1).ok().map(|i| rows[i].1)
    }
}
