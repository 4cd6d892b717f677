//! Balls that shine outward: lamps and spheres of a glowing material.
//!
//! A point is chosen evenly among the directions in which the ball is seen (Shirley, Wang and Zimmerman, "Monte Carlo Techniques for
//! Direct Lighting Calculations", 1996; written so that nothing cancels for small and far balls: Pharr, Jakob and Humphreys,
//! "Physically Based Rendering", 4th edition, 6.2.4).

use super::form::Chosen;
use std::f32::consts::TAU;
use vitrine_math::{Frame, Vec3};

/// A ball that shines outward.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// World space, metres.
    pub center: Vec3,
    /// Metres.
    pub radius: f32,
}

impl Ball {
    /// A point that is seen from `p`; None from inside, where no light goes.
    #[inline]
    pub fn choose(&self, p: Vec3, u: [f32; 2]) -> Option<Chosen> {
        let cone = Cone::around(self, p)?;
        // cosθ is even in [cosθmax, 1].
        let rest = u[0] * cone.rest;
        let (cos, sin2) = (1.0 - rest, rest * (2.0 - rest));
        // The angle α at the centre between the axis and the point: cos α = sin²θ/sinθmax + cosθ·√(1 − sin²θ/sin²θmax)
        let cos_a = sin2 / cone.sin + cos * (1.0 - sin2 / (cone.sin * cone.sin)).max(0.0).sqrt();
        let sin_a = (1.0 - cos_a * cos_a).max(0.0).sqrt();
        let (sin_turn, cos_turn) = libm::sincosf(TAU * u[1]);
        let n = Frame::around(cone.toward_p).world(Vec3::new(sin_a * cos_turn, sin_a * sin_turn, cos_a));
        let y = self.center + n * self.radius;
        let pdf = cone.pdf(p, y, n);
        (pdf > 0.0).then_some(Chosen { y, n, pdf })
    }

    /// The density, 1/m², with which [`Self::choose`] finds `y`.
    #[inline]
    pub fn pdf(&self, p: Vec3, y: Vec3) -> f32 {
        Cone::around(self, p).map_or(0.0, |cone| cone.pdf(p, y, (y - self.center) / self.radius))
    }
}

/// The directions in which a ball is seen.
struct Cone {
    /// The sine of half its angle.
    sin: f32,
    /// One less the cosine of half its angle.
    rest: f32,
    /// From the centre to who sees it, of unit length.
    toward_p: Vec3,
}

impl Cone {
    #[inline]
    fn around(ball: &Ball, p: Vec3) -> Option<Self> {
        let v = p - ball.center;
        let distance2 = v.length_squared();
        let radius2 = ball.radius * ball.radius;
        if !(distance2 > radius2 && distance2 < f32::INFINITY) {
            return None;
        }
        // sin²θmax = R²/d²;  1 − cosθmax = sin²θmax/(1 + cosθmax)
        let sin2 = radius2 / distance2;
        let rest = sin2 / (1.0 + (1.0 - sin2).sqrt());
        (rest > 0.0).then(|| Self { sin: sin2.sqrt(), rest, toward_p: v / distance2.sqrt() })
    }

    /// p_A = p_ω·cosθ_y/ℓ², p_ω = 1/(2π(1 − cosθmax))
    #[inline]
    fn pdf(&self, p: Vec3, y: Vec3, n: Vec3) -> f32 {
        let v = p - y;
        let length2 = v.length_squared();
        let along = n.dot(v);
        if along > 0.0 && length2 > 0.0 { along / length2.sqrt() / (length2 * TAU * self.rest) } else { 0.0 }
    }
}
