//! Linear colour, and the sRGB curve at the edges.

use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Sub};

/// A colour or a radiance: linear Rec. 709 red, green and blue. Not clamped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red, linear.
    pub r: f32,
    /// Green, linear.
    pub g: f32,
    /// Blue, linear.
    pub b: f32,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::splat(0.0);
    /// One in every channel.
    pub const WHITE: Self = Self::splat(1.0);

    /// A colour by its linear channels.
    #[inline]
    #[must_use]
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// A grey.
    #[inline]
    #[must_use]
    pub const fn splat(v: f32) -> Self {
        Self::new(v, v, v)
    }

    /// From 8-bit sRGB, as "#rrggbb" writes it.
    #[must_use]
    pub fn from_srgb8(rgb: [u8; 3]) -> Self {
        let [r, g, b] = rgb.map(|c| linear_from_srgb(f32::from(c) / 255.0));
        Self { r, g, b }
    }

    /// To 8-bit sRGB, clamped and rounded.
    #[must_use]
    pub fn to_srgb8(self) -> [u8; 3] {
        // A cast of a float to an integer saturates and maps NaN to 0.
        self.to_array().map(|c| (srgb_from_linear(c) * 255.0 + 0.5) as u8)
    }

    /// The channels as an array: red, green, blue.
    #[inline]
    #[must_use]
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// Relative luminance (Rec. 709 weights).
    #[inline]
    #[must_use]
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// Whether no channel is NaN or infinite.
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.to_array().iter().all(|c| c.is_finite())
    }

    /// `(1 − t) · self + t · other`.
    #[inline]
    #[must_use]
    pub fn lerp(self, other: Self, t: f32) -> Self {
        self * (1.0 - t) + other * t
    }

    /// Reads "#rrggbb" (sRGB).
    ///
    /// # Errors
    /// When the text is not a hash sign and six hexadecimal digits.
    pub fn from_hex(text: &str) -> Result<Self, ParseColorError> {
        let digits = text.strip_prefix('#').ok_or(ParseColorError)?;
        if digits.len() != 6 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(ParseColorError);
        }
        let n = u32::from_str_radix(digits, 16).map_err(|_| ParseColorError)?;
        Ok(Self::from_srgb8([(n >> 16) as u8, (n >> 8) as u8, n as u8]))
    }

    /// "#rrggbb" when that names this colour exactly, else None.
    #[must_use]
    pub fn to_hex(self) -> Option<String> {
        let [r, g, b] = self.to_srgb8();
        (Self::from_srgb8([r, g, b]) == self).then(|| format!("#{r:02x}{g:02x}{b:02x}"))
    }
}

impl From<[f32; 3]> for Rgb {
    #[inline]
    fn from([r, g, b]: [f32; 3]) -> Self {
        Self { r, g, b }
    }
}

impl Add for Rgb {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Sub for Rgb {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.r - o.r, self.g - o.g, self.b - o.b)
    }
}

impl Mul for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn mul(self, s: f32) -> Self {
        Self::new(self.r * s, self.g * s, self.b * s)
    }
}

impl MulAssign<f32> for Rgb {
    #[inline]
    fn mul_assign(&mut self, s: f32) {
        *self = *self * s;
    }
}

impl Div<f32> for Rgb {
    type Output = Self;
    #[inline]
    fn div(self, s: f32) -> Self {
        Self::new(self.r / s, self.g / s, self.b / s)
    }
}

/// A text that is not "#rrggbb".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParseColorError;

impl fmt::Display for ParseColorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a colour is \"#rrggbb\", six hexadecimal digits")
    }
}

impl std::error::Error for ParseColorError {}

/// The sRGB curve undone (IEC 61966-2-1). `v` is 0 to 1.
#[must_use]
pub fn linear_from_srgb(v: f32) -> f32 {
    if v <= 0.04045 { v / 12.92 } else { libm::powf((v + 0.055) / 1.055, 2.4) }
}

/// The sRGB curve (IEC 61966-2-1), clamped to 0..1. NaN becomes 0.
#[must_use]
pub fn srgb_from_linear(v: f32) -> f32 {
    if v.is_nan() {
        return 0.0;
    }
    let v = v.clamp(0.0, 1.0);
    if v <= 0.003_130_8 { v * 12.92 } else { (1.055 * libm::powf(v, 1.0 / 2.4) - 0.055).min(1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_8_bit_value_survives_the_curve_both_ways() {
        for v in 0..=255_u8 {
            assert_eq!(Rgb::from_srgb8([v; 3]).to_srgb8(), [v; 3]);
        }
    }

    #[test]
    fn srgb_curve_has_its_textbook_values() {
        assert!((linear_from_srgb(0.5) - 0.214_041).abs() < 1e-6);
        assert!((srgb_from_linear(0.18) - 0.461_356).abs() < 1e-6);
        assert_eq!(srgb_from_linear(f32::NAN), 0.0);
        assert!((srgb_from_linear(7.0) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn hex_names_exactly_the_colours_it_can() {
        let red = Rgb::from_hex("#c8281e").unwrap();
        assert_eq!(red.to_hex().as_deref(), Some("#c8281e"));
        assert_eq!(Rgb::new(0.123, 0.5, 0.5).to_hex(), None);
        for bad in ["", "#", "c8281e", "#c8281", "#c8281e0", "#gggggg", "#c8 81e", "#+c8281"] {
            assert!(Rgb::from_hex(bad).is_err(), "{bad}");
        }
    }
}
