//! The lights. A new one is a file beside these and a line in the register below.

mod ambient;
mod directional;
mod disc;
mod point;

pub use ambient::Ambient;
pub use directional::Directional;
pub use disc::Disc;
pub use point::Point;

use crate::{ParamKind, Params, Range};
use vitrine_math::{Rgb, Vec3};

crate::kinds! {
    /// The kind of a light with that kind's own parameters.
    pub enum LightSource as LightKind {
        Ambient(Ambient) = "ambient",
        Point(Point) = "point",
        Directional(Directional) = "directional",
        Disc(Disc) = "disc",
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
    }
}

/// What every light can do.
pub trait LightKind: Params {
    /// Where the light comes from, in terms that the renderer samples.
    fn emission(&self) -> Emission;
}

/// The ways of shining that the renderer knows.
#[derive(Clone, Copy, Debug, PartialEq)]
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
}
