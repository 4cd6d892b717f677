//! View transforms: from linear light to what a display shows. A new one is a file beside these and a line in the register.

mod srgb;

use crate::Image;
use vitrine_math::Rgb;

/// A way to show linear light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ViewTransform {
    /// The sRGB curve, brighter values clamped. What the classic renderer means by a colour.
    #[default]
    Srgb,
}

impl ViewTransform {
    /// Display values of a colour, each from 0 to 1.
    #[must_use]
    pub fn display(self, color: Rgb) -> [f32; 3] {
        match self {
            Self::Srgb => srgb::display(color),
        }
    }

    /// The picture in 8 bits a channel: red, green, blue, row by row.
    #[must_use]
    pub fn to_u8(self, image: &Image) -> Vec<u8> {
        let bytes: Vec<[u8; 3]> = match self {
            Self::Srgb => {
                let display = srgb::display_u8();
                image.pixels.iter().map(|p| [display(p.r), display(p.g), display(p.b)]).collect()
            }
        };
        bytes.into_flattened()
    }

    /// The picture in 16 bits a channel: red, green, blue, row by row.
    #[must_use]
    pub fn to_u16(self, image: &Image) -> Vec<u16> {
        self.channels(image).map(|v| (v * 65_535.0 + 0.5) as u16).collect()
    }

    fn channels(self, image: &Image) -> impl Iterator<Item = f32> {
        image.pixels.iter().flat_map(move |p| self.display(*p))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_white_and_overbright() {
        let image = Image { size: [3, 1], pixels: vec![Rgb::BLACK, Rgb::WHITE, Rgb::splat(9.0)] };
        assert_eq!(ViewTransform::Srgb.to_u8(&image), [0, 0, 0, 255, 255, 255, 255, 255, 255]);
        assert_eq!(ViewTransform::Srgb.to_u16(&image)[3..], [65_535; 6]);
    }
}
