//! A path from the camera, between two of its vertices.

use super::chain::Chain;
use super::media::Media;
use super::polarisation::Polarisation;
use crate::samplers::PathSampler;
use vitrine_math::{Rgb, Vec3};

/// The dimensions of the samples that a vertex takes.
#[derive(Clone, Copy, Debug)]
pub enum Draw {
    /// Which lobe, or whether light is reflected or passes.
    Lobe = 0,
    /// The direction, two numbers.
    Direction = 1,
    /// Which light.
    Light = 2,
    /// The point of the light, two numbers.
    LightPoint = 3,
    /// Whether the path goes on.
    Roulette = 4,
    /// The wavelength of a path.
    Wavelength = 5,
    /// The wavelength of a connection.
    ConnectionWavelength = 6,
    /// How far light goes in milky glass.
    Distance = 7,
    /// Whether rare ways of light are looked for.
    Rare = 8,
    /// Whether faint light is worth a shadow ray: this one and those after it, one for each connection.
    Faint = 9,
}

/// How many there are.
const DRAWS: u32 = 16;
/// Those of the camera come first: the place in the pixel, the place in the lens.
const OF_CAMERA: u32 = 2;

/// The last point at which a path was scattered other than by a smooth surface.
#[derive(Clone, Copy, Debug, Default)]
pub struct Origin {
    /// The point.
    pub x: Vec3,
    /// The unit normal; zero inside milky glass.
    pub n: Vec3,
    /// The density with which the direction was chosen, 1/sr; 0 where no light was looked for: at the camera.
    pub pdf: f32,
    /// The direction, of unit length.
    pub wi: Vec3,
    /// What holds the point, on the side to which the path went.
    pub media: Media,
}

/// A path.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// The pixel's place in the tile's order.
    pub pixel: u32,
    /// The samples.
    pub sampler: PathSampler,
    /// How much of the light that arrives here reaches the pixel.
    pub beta: Rgb,
    /// By how much radiance has been condensed on the way: the square of the index.
    pub condensed: f32,
    /// How many surfaces it has met.
    pub bounce: u32,
    /// What it is inside of.
    pub media: Media,
    /// The state of its light.
    pub polarisation: Polarisation,
    /// Nanometres; 0: all wavelengths.
    pub wavelength: f32,
    /// Where on its ray this part of the path begins.
    pub start_t: f32,
    /// Where it was scattered last.
    pub origin: Origin,
    /// The smooth surfaces met since.
    pub chain: Chain,
    /// Whether the camera sees what it meets, straight or by smooth surfaces alone.
    pub is_seen: bool,
    /// The way from the camera to where the first surface was met, metres; 0 before.
    pub depth: f32,
}

impl Path {
    /// A path that starts at the camera.
    pub fn new(pixel: u32, sampler: PathSampler, media: Media) -> Self {
        Self {
            pixel,
            sampler,
            beta: Rgb::WHITE,
            condensed: 1.0,
            bounce: 0,
            media,
            polarisation: Polarisation::default(),
            wavelength: 0.0,
            start_t: 0.0,
            origin: Origin::default(),
            chain: Chain::default(),
            is_seen: true,
            depth: 0.0,
        }
    }

    /// A number from 0 to 1 for a purpose at this vertex.
    #[inline]
    pub fn one(&self, draw: Draw) -> f32 {
        self.sampler.one(OF_CAMERA + self.bounce * DRAWS + draw as u32)
    }

    /// Another number for the same purpose.
    #[inline]
    pub fn one_of(&self, draw: Draw, number: usize) -> f32 {
        let last = DRAWS - 1 - draw as u32;
        self.sampler.one(OF_CAMERA + self.bounce * DRAWS + draw as u32 + (number as u32).min(last))
    }

    /// Two of them.
    #[inline]
    pub fn two(&self, draw: Draw) -> [f32; 2] {
        self.sampler.two(OF_CAMERA + self.bounce * DRAWS + draw as u32)
    }
}
