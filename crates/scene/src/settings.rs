//! How the picture is made.

use crate::{ParamKind, Range};
use vitrine_math::Rgb;

crate::choices! {
    /// The way to make the picture.
    pub enum Renderer {
        /// Recursive ray tracing with mirrors, transparency and shadows.
        Classic = "classic",
        /// Ray casting: the nearest surface alone, lit without shadows.
        Cast = "cast",
    }
}

crate::params! {
    /// How the picture is made.
    pub struct Settings {
        /// Width and height of the picture.
        size: [u32; 2] = [960, 720] => ParamKind::Size { min: 1, max: 32_768 }, Pixels;
        /// How the picture is made: with mirrors, transparency and shadows, or by ray casting without any of them.
        renderer: Renderer = Renderer::Classic => ParamKind::Choice(Renderer::WORDS), None;
        /// How many times a mirror image may be mirrored again.
        depth: u32 = 3 => ParamKind::Integer { min: 0, max: 32 }, None;
        /// Rays through each pixel; more smooth the edges. One goes through the pixel's middle.
        samples: u32 = 1 => ParamKind::Integer { min: 1, max: 65_536 }, None;
        /// The most points of a disc lamp that are tried for each soft shadow.
        shadow_points: u32 = 64 => ParamKind::Integer { min: 1, max: 4096 }, None;
        /// A soft shadow is good enough, and no more points are tried, once its standard error is this small. 0 tries them all.
        shadow_error: f32 = 0.03 => ParamKind::Number(Range::UNIT), None;
        /// The colour where there is nothing.
        background: Rgb = Rgb::new(0.05, 0.07, 0.1) => ParamKind::Color, None;
        /// Another number gives other random points of the same quality.
        seed: u32 = 0 => ParamKind::Integer { min: 0, max: 4_294_967_295 }, None;
    }
}

impl Settings {
    /// The most pixels that a picture may have: beyond it, memory for the film alone passes 2 GB.
    pub const MAX_PIXELS: u64 = 1 << 27;
}
