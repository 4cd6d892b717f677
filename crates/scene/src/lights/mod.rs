//! The lights. A new one is a file beside these and a line in the register below.

mod ambient;
mod directional;
mod disc;
mod environment;
mod point;
mod sky;
mod sphere;

pub use ambient::Ambient;
pub use directional::Directional;
pub use disc::Disc;
pub use environment::Environment;
pub use point::Point;
pub use sky::Sky;
pub use sphere::Sphere;

use crate::{Assets, ParamKind, Params, RadianceMap, Range};
use std::path::Path;
use std::sync::Arc;
use vitrine_math::{Rgb, Vec3, black_body_color};

crate::kinds! {
    /// The kind of a light with that kind's own parameters.
    pub enum LightSource as LightKind {
        Ambient(Ambient) = "ambient",
        Point(Point) = "point",
        Directional(Directional) = "directional",
        Disc(Disc) = "disc",
        Sphere(Sphere) = "sphere",
        Environment(Environment) = "environment",
        Sky(Sky) = "sky",
    }
}

crate::params! {
    /// Something that shines.
    pub struct Light {
        @plain {
            /// Its name, unique among the lights.
            name: String = "light".to_owned();
            /// Its kind.
            source: LightSource = LightSource::Point(Point::default());
        }
        /// Whether it shines at all.
        visible: bool = true => ParamKind::Flag, None;
        /// How bright it is. The classic renderer adds it as it is: 1 lights a white surface that faces it fully.
        intensity: f32 = 0.7 => ParamKind::Number(Range::NOT_NEGATIVE), None;
        /// Its colour.
        color: Rgb = Rgb::WHITE => ParamKind::Color, None;
        /// The colour of what glows as hot as this, times the light's colour: a candle 1900, a bulb 2900, daylight 6500. As bright as without.
        temperature: Option<f32> = None => ParamKind::Number(Range::from_to(1000.0, 40_000.0)), Kelvin;
        /// At this distance the photoreal renderer shows it as bright as the classic one does at any. Where nothing is stated: the distance from the lamp to the middle of all things. For bulbs and disc lamps.
        full_at: Option<f32> = None => ParamKind::Number(Range::POSITIVE), Metres;
    }
}

impl Light {
    /// Intensity times colour, that of its temperature included.
    #[must_use]
    pub fn radiance(&self) -> Rgb {
        let glow = self.temperature.map_or(Rgb::WHITE, black_body_color);
        self.color * glow * self.intensity
    }
}

/// What every light can do.
pub trait LightKind: Params {
    /// Where the light comes from, in terms that the renderer samples. None when a file it needs is not among the assets.
    fn emission(&self, assets: &Assets) -> Option<Emission>;

    /// The panorama that it needs, relative to the scene file.
    fn file(&self) -> Option<&Path> {
        None
    }
}

/// The ways of shining that the renderer knows.
#[derive(Clone, Debug, PartialEq)]
pub enum Emission {
    /// The same in every point, without shadow.
    Everywhere,
    /// From one point in all directions.
    Point {
        /// Metres.
        position: Vec3,
    },
    /// From one direction, without end.
    Direction {
        /// The way the light travels, of unit length.
        travels: Vec3,
    },
    /// From all over a disc parallel to XOZ.
    Disc {
        /// The centre, metres.
        position: Vec3,
        /// Metres.
        radius: f32,
    },
    /// From all over a ball.
    Sphere {
        /// The centre, metres.
        position: Vec3,
        /// Metres.
        radius: f32,
    },
    /// From all around, without end, as a panorama says.
    Environment {
        /// The radiance from each direction.
        map: Arc<RadianceMap>,
        /// By how much the map is turned about Y, radians; more than 0 takes −Z towards −X.
        turn: f32,
    },
    /// From all around, without end: a clear sky.
    Sky {
        /// The direction to the sun, of unit length.
        to_sun: Vec3,
        /// How hazy the air is, 2 to 10.
        turbidity: f32,
        /// Whether the sun's disc shines, too.
        sun: bool,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_temperature_gives_colour_and_takes_no_brightness() {
        let light = Light { intensity: 2.0, color: Rgb::new(0.5, 0.25, 0.125), ..Light::default() };
        assert_eq!(light.radiance(), Rgb::new(1.0, 0.5, 0.25));
        let white = Light { intensity: 2.0, ..Light::default() };
        let candle = Light { temperature: Some(1900.0), ..white.clone() };
        assert!((candle.radiance().luminance() - white.radiance().luminance()).abs() < 1e-5);
        assert!(candle.radiance().r > 3.0 * candle.radiance().b, "{:?}", candle.radiance());
    }
}
