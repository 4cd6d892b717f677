//! The forms of what shines from a place: the register of their kinds.

use super::bound::Bound;
use super::cuboid::Cuboid;
use super::disc::Plate;
use super::ellipsoid::Ellipsoid;
use super::sphere::Ball;
use super::triangle::Facet;
use std::f32::consts::PI;
use vitrine_math::Vec3;

/// A point of a surface that was chosen.
#[derive(Clone, Copy, Debug)]
pub struct Chosen {
    /// World space, metres.
    pub y: Vec3,
    /// The unit normal on a side that shines.
    pub n: Vec3,
    /// Per m².
    pub pdf: f32,
}

/// The form of a light that has a place. Those that are large stand apart, for a mesh has many of the small ones.
#[derive(Clone, Debug)]
pub enum Form {
    /// A point.
    Point(Vec3),
    /// A ball.
    Ball(Ball),
    /// A ball that was stretched unevenly.
    Ellipsoid(Box<Ellipsoid>),
    /// A box.
    Cuboid(Box<Cuboid>),
    /// A disc.
    Plate(Plate),
    /// A triangle.
    Facet(Facet),
}

impl Form {
    /// A point of the surface, in sight of `p` as far as the form alone decides it. None where no light reaches `p`. Not for
    /// [`Form::Point`].
    #[inline]
    pub fn choose(&self, p: Vec3, u: [f32; 2], is_two_sided: bool) -> Option<Chosen> {
        let mut chosen = match self {
            Self::Point(_) => return None,
            Self::Ball(ball) => return ball.choose(p, u),
            Self::Ellipsoid(ellipsoid) => ellipsoid.choose(p, u)?,
            Self::Cuboid(cuboid) => cuboid.choose(p, u)?,
            Self::Plate(plate) => plate.choose(u),
            Self::Facet(facet) => facet.choose(u),
        };
        let side = chosen.n.dot(p - chosen.y);
        let is_turned = side < 0.0 && is_two_sided && self.is_flat();
        if is_turned {
            chosen.n = -chosen.n;
        }
        (side > 0.0 || is_turned).then_some(chosen)
    }

    /// Whether it has two sides that may shine.
    const fn is_flat(&self) -> bool {
        matches!(self, Self::Plate(_) | Self::Facet(_))
    }

    /// The density, 1/m², with which [`Self::choose`] finds `y`, a point of it: 0 where it does not face `p`, though its light may
    /// come to `p` by a mirror.
    #[inline]
    pub fn pdf(&self, p: Vec3, y: Vec3, is_two_sided: bool) -> f32 {
        let flat = |n: Vec3, area: f32| if is_two_sided || n.dot(p - y) > 0.0 { 1.0 / area } else { 0.0 };
        match self {
            Self::Point(_) => 0.0,
            Self::Ball(ball) => ball.pdf(p, y),
            Self::Ellipsoid(ellipsoid) => ellipsoid.pdf(p, y),
            Self::Cuboid(cuboid) => cuboid.pdf(p, y),
            Self::Plate(plate) => flat(plate.n, plate.area),
            Self::Facet(facet) => flat(facet.n, facet.area),
        }
    }

    /// What is known of its light from afar, for a luminance of 1 (of a point: an intensity of 1).
    pub fn bound(&self, is_two_sided: bool) -> Bound {
        // Radiant intensity is the radiance times the area that is seen: of a convex form a quarter of its surface in the mean (Cauchy).
        let all_around = |(center, radius), power| Bound::all_around(center, radius, power);
        match self {
            Self::Point(position) => all_around((*position, 0.0), 1.0),
            Self::Ball(ball) => all_around((ball.center, ball.radius), PI * ball.radius * ball.radius),
            Self::Ellipsoid(ellipsoid) => all_around(ellipsoid.around(), 0.25 * ellipsoid.area()),
            Self::Cuboid(cuboid) => all_around(cuboid.around(), 0.25 * cuboid.area()),
            Self::Plate(plate) => {
                // The longest half axis of an ellipse is no longer than √(a² + b²).
                let reach2 = plate.a.length_squared().max(plate.b.length_squared());
                let skew = plate.a.dot(plate.b).abs();
                Bound::flat(plate.center, (reach2 + skew).sqrt(), plate.n, plate.area, is_two_sided)
            }
            Self::Facet(facet) => {
                let middle = facet.corner + (facet.a + facet.b) / 3.0;
                let corners = [facet.corner, facet.corner + facet.a, facet.corner + facet.b];
                let radius = corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f32::max);
                Bound::flat(middle, radius, facet.n, facet.area, is_two_sided)
            }
        }
    }
}
