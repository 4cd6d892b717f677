//! The sun: a small round patch of the sky.

use std::f32::consts::{PI, TAU};
use vitrine_math::{Frame, Rgb, Vec3};

/// Half of the angle under which the sun is seen, radians: 0.533° in the mean of the year (IAU: radius 695 700 km, distance 1
/// astronomical unit).
const HALF_ANGLE: f32 = 0.533 / 2.0 * PI / 180.0;

/// The sun's disc, of the same radiance all over.
#[derive(Clone, Copy, Debug)]
pub struct Sun {
    /// Of unit length.
    toward: Vec3,
    le: Rgb,
    /// One less the cosine of [`HALF_ANGLE`].
    rest: f32,
    /// The irradiance on a surface that faces it, as a luminance.
    irradiance: f32,
}

impl Sun {
    /// In a direction of unit length; with the irradiance on a surface that faces it.
    pub fn new(toward: Vec3, irradiance: Rgb) -> Self {
        // 1 − cos a = 2·sin²(a/2);  Ω = 2π(1 − cos a)
        let half = libm::sinf(0.5 * HALF_ANGLE);
        let rest = 2.0 * half * half;
        // E = L·π·sin²a on a surface that faces it
        let sin = libm::sinf(HALF_ANGLE);
        Self { toward, le: irradiance / (PI * sin * sin), rest, irradiance: irradiance.luminance() }
    }

    /// The irradiance on a surface of normal `n`, or on one that faces it, as a luminance. Zero only where nothing of it is seen.
    #[inline]
    pub fn irradiance(&self, n: Option<Vec3>) -> f32 {
        // sin a more, for the part of the disc that stands above the horizon
        self.irradiance * n.map_or(1.0, |n| (n.dot(self.toward) + HALF_ANGLE).clamp(0.0, 1.0))
    }

    /// The radiance from a direction of unit length.
    #[inline]
    pub fn le(&self, toward: Vec3) -> Rgb {
        if self.holds(toward) { self.le } else { Rgb::BLACK }
    }

    /// A direction of the disc.
    #[inline]
    pub fn choose(&self, u: [f32; 2]) -> Vec3 {
        let rest = u[0] * self.rest;
        let sin = (rest * (2.0 - rest)).sqrt();
        let (sin_turn, cos_turn) = libm::sincosf(TAU * u[1]);
        Frame::around(self.toward).world(Vec3::new(sin * cos_turn, sin * sin_turn, 1.0 - rest))
    }

    /// The density per steradian with which [`Self::choose`] finds a direction.
    #[inline]
    pub fn pdf(&self, toward: Vec3) -> f32 {
        if self.holds(toward) { 1.0 / (TAU * self.rest) } else { 0.0 }
    }

    /// Whether a direction lies in the disc: by the chord, |a − b|² = 2(1 − cos), which keeps digits that the cosine would lose.
    #[inline]
    fn holds(&self, toward: Vec3) -> bool {
        // A hair more, so that rounding puts no direction of its own outside.
        (toward - self.toward).length_squared() <= 2.0 * self.rest * 1.0001
    }
}
