//! Triangles that shine, alone or in a mesh. Points are chosen evenly by area.

use super::form::Chosen;
use vitrine_math::Vec3;

/// The points `corner + a·x + b·y` with x, y ≥ 0 and x + y ≤ 1.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    /// World space, metres.
    pub corner: Vec3,
    /// An edge, metres.
    pub a: Vec3,
    /// The other edge, metres.
    pub b: Vec3,
    /// The unit normal of the side that shines: from there the corners go round counter-clockwise.
    pub n: Vec3,
    /// Metres².
    pub area: f32,
}

impl Facet {
    /// None without any area, or where it is too large to compute with.
    pub fn new(points: [Vec3; 3]) -> Option<Self> {
        let (a, b) = (points[1] - points[0], points[2] - points[0]);
        let scale = a.abs().max_element().max(b.abs().max_element());
        let n = (a / scale).cross(b / scale).try_normalize()?;
        let area = 0.5 * a.cross(b).length();
        (area > 0.0 && area.is_finite()).then_some(Self { corner: points[0], a, b, n, area })
    }

    /// Any of its points (Heitz, "A Low-Distortion Map Between Triangle and Square", 2019).
    #[inline]
    pub fn choose(&self, u: [f32; 2]) -> Chosen {
        let [mut x, mut y] = u;
        if y > x {
            x *= 0.5;
            y -= x;
        } else {
            y *= 0.5;
            x -= y;
        }
        Chosen { y: self.corner + self.a * x + self.b * y, n: self.n, pdf: 1.0 / self.area }
    }
}
