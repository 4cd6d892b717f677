//! From linear light to what a display shows: exposure and white balance, then a view transform. A new one is a file beside these
//! and a line in the register.

mod agx;
mod neutral;
mod srgb;
mod white;

use crate::Image;
use vitrine_math::Rgb;

/// A way to show linear light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ViewTransform {
    /// The sRGB curve, brighter values clamped. What the classic renderer means by a colour.
    #[default]
    Srgb,
    /// Khronos PBR Neutral: colours as they are, highlights compressed.
    Neutral,
    /// AgX: very bright and saturated light without clipping, at the price of paler colours.
    Agx,
}

impl ViewTransform {
    /// Linear display light; only the plain view goes beyond 0 to 1.
    fn linear(self, color: Rgb) -> Rgb {
        match self {
            Self::Srgb => color,
            Self::Neutral => neutral::map(color),
            Self::Agx => agx::map(color),
        }
    }

    /// Display values of a colour, each from 0 to 1.
    #[must_use]
    pub fn display(self, color: Rgb) -> [f32; 3] {
        srgb::curve(self.linear(color))
    }
}

/// How linear light is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Display {
    /// The transform at the end.
    pub view: ViewTransform,
    /// In stops: 1 shows everything twice as bright. Any finite number.
    pub exposure: f32,
    /// The temperature of the light that shows as white, kelvin: 1000 to 25 000. 6500 changes nothing.
    pub white_balance: f32,
}

impl Default for Display {
    fn default() -> Self {
        Self { view: ViewTransform::default(), exposure: 0.0, white_balance: 6500.0 }
    }
}

impl Display {
    /// A view transform alone.
    #[must_use]
    pub fn of_view(view: ViewTransform) -> Self {
        Self { view, ..Self::default() }
    }

    /// Display values of a colour, each from 0 to 1. For many colours see [`Display::to_u8`].
    #[must_use]
    pub fn display(&self, color: Rgb) -> [f32; 3] {
        self.view.display(self.correction().apply(color))
    }

    /// The picture as the display shows it, in linear light again: each channel from 0 to 1.
    #[must_use]
    pub fn shown(&self, image: &Image) -> Image {
        let correction = self.correction();
        // NaN is not greater than 0 either.
        let clamp = |p: Rgb| Rgb::from(p.to_array().map(|v| if v > 0.0 { v.min(1.0) } else { 0.0 }));
        let show = |p: &Rgb| clamp(self.view.linear(correction.apply(*p)));
        Image { size: image.size, pixels: image.pixels.iter().map(show).collect() }
    }

    /// The picture in 8 bits a channel: red, green, blue, row by row.
    #[must_use]
    pub fn to_u8(&self, image: &Image) -> Vec<u8> {
        let (correction, curve) = (self.correction(), srgb::curve_u8());
        let show = |p: &Rgb| self.view.linear(correction.apply(*p)).to_array().map(&curve);
        image.pixels.iter().map(show).collect::<Vec<_>>().into_flattened()
    }

    /// The picture in 16 bits a channel: red, green, blue, row by row.
    #[must_use]
    pub fn to_u16(&self, image: &Image) -> Vec<u16> {
        let correction = self.correction();
        let show = |p: &Rgb| self.view.display(correction.apply(*p)).map(|v| (v * 65_535.0 + 0.5) as u16);
        image.pixels.iter().map(show).collect::<Vec<_>>().into_flattened()
    }

    fn correction(&self) -> Correction {
        if self.exposure == 0.0 && self.white_balance == 6500.0 {
            return Correction(None);
        }
        let scale = libm::exp2f(self.exposure);
        Correction(Some(white::matrix(self.white_balance).map(|row| row.map(|v| v * scale))))
    }
}

/// Exposure and white balance in one matrix, row by row; None changes no bit.
#[derive(Clone, Copy)]
struct Correction(Option<[[f32; 3]; 3]>);

impl Correction {
    #[inline]
    fn apply(self, p: Rgb) -> Rgb {
        let Some(matrix) = self.0 else { return p };
        let [r, g, b] = matrix.map(|[x, y, z]| x * p.r + y * p.g + z * p.b);
        Rgb::new(r, g, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEWS: [ViewTransform; 3] = [ViewTransform::Srgb, ViewTransform::Neutral, ViewTransform::Agx];

    #[test]
    fn black_white_and_overbright() {
        let image = Image { size: [3, 1], pixels: vec![Rgb::BLACK, Rgb::WHITE, Rgb::splat(9.0)] };
        let plain = Display::default();
        assert_eq!(plain.to_u8(&image), [0, 0, 0, 255, 255, 255, 255, 255, 255]);
        assert_eq!(plain.to_u16(&image)[3..], [65_535; 6]);
        for view in VIEWS {
            let shown = Display::of_view(view).to_u8(&image);
            assert_eq!(shown[..3], [0; 3], "{view:?}");
            assert!(shown[3] > 180 && shown[6] > 245, "{view:?} {shown:?}");
        }
    }

    #[test]
    fn whatever_the_light_display_values_are_from_0_to_1() {
        let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 0.0, 1e-40, 0.5, 1e30, f32::MAX];
        let display = Display { exposure: 3.0, white_balance: 3000.0, ..Display::default() };
        for view in VIEWS {
            for (r, g, b) in odd.iter().flat_map(|r| odd.iter().map(move |g| (*r, *g, 0.3))) {
                for display in [Display::of_view(view), Display { view, ..display }] {
                    let shown = display.display(Rgb::new(r, g, b));
                    assert!(shown.iter().all(|v| (0.0..=1.0).contains(v)), "{view:?} {r} {g}: {shown:?}");
                }
            }
        }
    }

    #[test]
    fn one_stop_is_twice_the_light() {
        let image = Image { size: [1, 1], pixels: vec![Rgb::new(0.1, 0.2, 0.3)] };
        let doubled = Image { size: [1, 1], pixels: vec![Rgb::new(0.2, 0.4, 0.6)] };
        for view in VIEWS {
            let brighter = Display { exposure: 1.0, ..Display::of_view(view) };
            assert_eq!(brighter.to_u16(&image), Display::of_view(view).to_u16(&doubled));
        }
    }

    #[test]
    fn eight_bits_are_the_display_values_rounded() {
        let color = Rgb::new(0.1, 2.0, 0.5);
        let image = Image { size: [1, 1], pixels: vec![color] };
        for view in VIEWS {
            let display = Display { view, exposure: 0.5, white_balance: 4200.0 };
            let rounded = display.display(color).map(|v| (v * 255.0 + 0.5) as u8);
            assert_eq!(display.to_u8(&image), rounded);
        }
    }

    #[test]
    fn a_warm_light_turns_neutral_when_the_balance_is_set_to_it() {
        // About the colour of a black body of 3000 K in Rec. 709.
        let warm = Rgb::new(1.8, 0.91, 0.25);
        let [r, _, b] = Display { white_balance: 3000.0, ..Display::default() }.display(warm * 0.3);
        let [plain_r, _, plain_b] = Display::default().display(warm * 0.3);
        assert!((r - b).abs() < 0.1 * (plain_r - plain_b), "{r} {b}");
    }
}
