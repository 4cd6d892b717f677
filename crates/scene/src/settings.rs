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
        /// Light as it is: glass that bends it, metals, lamps behind panes, every surface lit by all others.
        Photoreal = "photoreal",
    }
}

crate::choices! {
    /// How light becomes the colours of a display.
    pub enum View {
        /// Colours as they are as long as they can be shown, brighter ones softly drawn in.
        Neutral = "neutral",
        /// As film does: high contrasts fit in, bright colours fade to white.
        Agx = "agx",
        /// Nothing but the sRGB curve; what is too bright is cut off.
        Srgb = "srgb",
    }
}

crate::params! {
    /// How the picture is made.
    pub struct Settings {
        /// Width and height of the picture.
        size: [u32; 2] = [960, 720] => ParamKind::Size { min: 1, max: 32_768 }, Pixels;
        /// How the picture is made: with mirrors, transparency and shadows, by ray casting without any of them, or photoreal.
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
        /// How many surfaces light may meet on its way to the camera. Photoreal only.
        bounces: u32 = 64 => ParamKind::Integer { min: 1, max: 1024 }, None;
        /// How much brighter the picture is shown, in stops: each doubles it, less than 0 darkens it.
        exposure: f32 = 0.0 => ParamKind::Number(Range::from_to(-20.0, 20.0)), None;
        /// The light that is shown as white: 6500 is daylight, 2900 the light of a bulb.
        white_balance: f32 = 6500.0 => ParamKind::Number(Range::from_to(1000.0, 40_000.0)), Kelvin;
        /// How light becomes the colours of the display. Where nothing is stated, neutral if photoreal, else srgb.
        view: Option<View> = None => ParamKind::Choice(View::WORDS), None;
        /// No more rays are traced once the picture's noise, as a share of its brightness, is this small; 0 traces them all.
        noise: f32 = 0.0 => ParamKind::Number(Range::UNIT), None;
        /// The picture is done after so long, whatever is missing; 0 sets no limit.
        time_limit: f32 = 0.0 => ParamKind::Number(Range::NOT_NEGATIVE), Seconds;
        /// Takes light for unpolarised at each surface, as other renderers do; several panes are then a little too dark. Photoreal only.
        unpolarised: bool = false => ParamKind::Flag, None;
        /// Removes the noise that is left when the picture is done. Photoreal only.
        denoise: bool = false => ParamKind::Flag, None;
    }
}

impl Settings {
    /// The most pixels that a picture may have: beyond it, memory for the film alone passes 2 GB.
    pub const MAX_PIXELS: u64 = 1 << 27;

    /// How light becomes the colours of the display: as stated, else neutral for photoreal pictures and srgb for others.
    #[must_use]
    pub fn view(&self) -> View {
        self.view.unwrap_or(match self.renderer {
            Renderer::Photoreal => View::Neutral,
            Renderer::Classic | Renderer::Cast => View::Srgb,
        })
    }
}
