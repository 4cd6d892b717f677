//! Light from without end: sunlight, a sky with its sun, panoramas, light that is everywhere. All of it that has a width counts as one
//! light, the sum of its parts: a direction is chosen by one part, and its density is that of all parts together.

use super::environment::Panorama;
use super::sky::SkyModel;
use super::sun::Sun;
use std::f32::consts::{FRAC_1_PI, PI, TAU};
use vitrine_math::{Frame, Rgb, Vec2, Vec3, warp};
use vitrine_scene::lights::Emission;

/// A direction that was chosen.
#[derive(Clone, Copy, Debug)]
pub struct ChosenDirection {
    /// Of unit length.
    pub toward: Vec3,
    /// Radiance; of sunlight without a width, the irradiance on a surface that faces it.
    pub le: Rgb,
    /// Per steradian; of sunlight without a width, the probability.
    pub pdf: f32,
    /// Whether it is sunlight without a width.
    pub is_delta: bool,
}

/// All light from without end.
#[derive(Clone, Debug, Default)]
pub struct DistantLights {
    /// Sunlight without a width: its direction and its irradiance.
    beams: Vec<(Vec3, Rgb)>,
    /// Suns with a width.
    suns: Vec<Sun>,
    /// Panoramas and skies.
    panoramas: Vec<Panorama>,
    /// The sum of what is everywhere alike.
    uniform: Rgb,
}

impl DistantLights {
    /// Adds a light, if it is a distant one and shines.
    pub fn add(&mut self, emission: &Emission, radiance: Rgb) {
        if radiance.luminance() <= 0.0 {
            return;
        }
        match emission {
            Emission::Everywhere => self.uniform += radiance,
            Emission::Direction { travels } => self.beams.push((-*travels, radiance * PI)),
            Emission::Environment { map, turn } => self.panoramas.extend(Panorama::new(map, *turn, radiance)),
            Emission::Sky { to_sun, turbidity, sun } => {
                let sky = SkyModel::new(*to_sun, *turbidity);
                self.panoramas.extend(Panorama::new(&sky.map(*sun), 0.0, radiance));
                let irradiance = sky.sun() * radiance;
                if *sun && irradiance.luminance() > 0.0 {
                    self.suns.push(Sun::new(*to_sun, irradiance));
                }
            }
            Emission::Point { .. } | Emission::Disc { .. } | Emission::Sphere { .. } => {}
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.beams.is_empty() && !self.has_width()
    }

    /// Whether light comes from more than single directions.
    pub fn has_width(&self) -> bool {
        !self.suns.is_empty() || !self.panoramas.is_empty() || self.uniform != Rgb::BLACK
    }

    /// About how much light it brings to a surface of that normal, or to one that faces it: an irradiance.
    #[inline]
    pub fn importance(&self, n: Option<Vec3>) -> f32 {
        let beams: f32 = self.beams.iter().map(|&beam| beam_importance(beam, n)).sum();
        beams + self.width_importance(n)
    }

    #[inline]
    fn width_importance(&self, n: Option<Vec3>) -> f32 {
        let suns: f32 = self.suns.iter().map(|sun| sun.irradiance(n)).sum();
        let panoramas: f32 = self.panoramas.iter().map(Panorama::irradiance).sum();
        suns + panoramas + self.uniform.luminance() * PI
    }

    /// Chooses a direction, where `of_choice` chooses the part.
    pub fn choose(&self, n: Option<Vec3>, of_choice: f32, u: [f32; 2]) -> Option<ChosenDirection> {
        let whole = self.importance(n);
        let mut rest = of_choice * whole;
        for &beam in &self.beams {
            let share = beam_importance(beam, n);
            if rest < share {
                let (toward, le) = beam;
                return Some(ChosenDirection { toward, le, pdf: share / whole, is_delta: true });
            }
            rest -= share;
        }
        let toward = self.direction(n, rest, u)?;
        let (le, pdf) = (self.le(toward), self.pdf(n, toward));
        (pdf > 0.0).then_some(ChosenDirection { toward, le, pdf, is_delta: false })
    }

    /// A direction of the part in whose share of the importance the number `rest` lies.
    fn direction(&self, n: Option<Vec3>, mut rest: f32, u: [f32; 2]) -> Option<Vec3> {
        for sun in &self.suns {
            let share = sun.irradiance(n);
            if rest < share {
                return Some(sun.choose(u));
            }
            rest -= share;
        }
        for panorama in &self.panoramas {
            if rest < panorama.irradiance() {
                return Some(panorama.choose(u));
            }
            rest -= panorama.irradiance();
        }
        if self.uniform != Rgb::BLACK {
            return Some(uniform_direction(n, u));
        }
        // Rounding went past the last part.
        self.panoramas.last().map(|panorama| panorama.choose(u))
    }

    /// The density per steradian with which [`Self::choose`] finds a direction.
    #[inline]
    pub fn pdf(&self, n: Option<Vec3>, toward: Vec3) -> f32 {
        if !self.has_width() {
            return 0.0;
        }
        let whole = self.importance(n);
        let mut sum = 0.0;
        for sun in &self.suns {
            sum += sun.irradiance(n) * sun.pdf(toward);
        }
        for panorama in &self.panoramas {
            sum += panorama.irradiance() * panorama.pdf(toward);
        }
        if self.uniform != Rgb::BLACK {
            sum += self.uniform.luminance() * PI * uniform_pdf(n, toward);
        }
        if whole > 0.0 { sum / whole } else { 0.0 }
    }

    /// The radiance from a direction of unit length, without the light that has no width.
    #[inline]
    pub fn le(&self, toward: Vec3) -> Rgb {
        let mut le = self.uniform;
        for panorama in &self.panoramas {
            le += panorama.le(toward);
        }
        for sun in &self.suns {
            le += sun.le(toward);
        }
        le
    }
}

#[inline]
fn beam_importance((toward, irradiance): (Vec3, Rgb), n: Option<Vec3>) -> f32 {
    irradiance.luminance() * n.map_or(1.0, |n| n.dot(toward).max(0.0))
}

/// Any direction, alike; over a surface in proportion to the cosine.
fn uniform_direction(n: Option<Vec3>, u: [f32; 2]) -> Vec3 {
    if let Some(n) = n {
        // Malley's method: evenly on the disc, up to the half ball.
        let s = warp::concentric_disk(Vec2::from(u));
        let up = (1.0 - s.length_squared()).max(0.0).sqrt();
        return Frame::around(n).world(Vec3::new(s.x, s.y, up));
    }
    let rest = 2.0 * u[0];
    let ground = (rest * (2.0 - rest)).max(0.0).sqrt();
    let (sin, cos) = libm::sincosf(TAU * u[1]);
    Vec3::new(ground * sin, 1.0 - rest, ground * cos)
}

#[inline]
fn uniform_pdf(n: Option<Vec3>, toward: Vec3) -> f32 {
    n.map_or(0.25 * FRAC_1_PI, |n| n.dot(toward).max(0.0) * FRAC_1_PI)
}
