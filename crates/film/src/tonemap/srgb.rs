//! The sRGB curve alone.

use vitrine_math::{Rgb, srgb_from_linear};

/// Each channel on its own, clamped to 0..1.
pub fn display(color: Rgb) -> [f32; 3] {
    color.to_array().map(srgb_from_linear)
}
