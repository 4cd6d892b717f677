//! A finished picture in linear light.

use vitrine_math::Rgb;

/// Linear radiance, row by row from the top, each row from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// `size[0] · size[1]` pixels.
    pub pixels: Vec<Rgb>,
}

impl Image {
    /// A picture of one colour.
    #[must_use]
    pub fn filled(size: [u32; 2], color: Rgb) -> Self {
        Self { size, pixels: vec![color; size[0] as usize * size[1] as usize] }
    }

    /// A pixel; `x` counts from the left, `y` from the top.
    ///
    /// # Panics
    /// When the pixel lies outside the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Rgb {
        assert!(x < self.size[0] && y < self.size[1], "pixel ({x}, {y}) of a picture of {:?}", self.size);
        self.pixels[y as usize * self.size[0] as usize + x as usize]
    }
}
