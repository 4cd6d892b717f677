//! Flat round or elliptic things that shine: lamps and discs of a glowing material. Points are chosen evenly by area.

use super::form::Chosen;
use std::f32::consts::PI;
use vitrine_math::{Vec2, Vec3, warp};

/// The points `center + a·x + b·y` with x² + y² ≤ 1.
#[derive(Clone, Copy, Debug)]
pub struct Plate {
    /// World space, metres.
    pub center: Vec3,
    /// Half axes, metres.
    pub a: Vec3,
    /// Half axes, metres.
    pub b: Vec3,
    /// The unit normal of the side that shines.
    pub n: Vec3,
    /// Metres².
    pub area: f32,
}

impl Plate {
    /// None without any area, or where it is too large to compute with.
    pub fn new(center: Vec3, a: Vec3, b: Vec3) -> Option<Self> {
        let scale = a.abs().max_element().max(b.abs().max_element());
        let n = (a / scale).cross(b / scale).try_normalize()?;
        let area = PI * a.cross(b).length();
        (area > 0.0 && area.is_finite()).then_some(Self { center, a, b, n, area })
    }

    /// The same, shining to the other side.
    pub fn turned(self) -> Self {
        Self { n: -self.n, ..self }
    }

    /// Any of its points.
    #[inline]
    pub fn choose(&self, u: [f32; 2]) -> Chosen {
        let s = warp::concentric_disk(Vec2::from(u));
        Chosen { y: self.center + self.a * s.x + self.b * s.y, n: self.n, pdf: 1.0 / self.area }
    }
}
