//! What a clear but coloured inside, glass or water, leaves of the light that crosses it.

use vitrine_math::Rgb;

/// No colour counts as darker than this, so that black has a coefficient, too.
const DARKEST: f32 = 1e-4;

/// The absorption coefficient, per metre, of a medium in which white light has become `color` after `depth` metres.
///
///   σ = −ln(c)/d   (Beer and Lambert)
///
/// Colours are taken as 0.0001 to 1. A depth of 0 gives a medium that absorbs nothing: such a colour tints the surface.
#[must_use]
pub fn coefficient(color: Rgb, depth: f32) -> Rgb {
    if depth <= 0.0 {
        return Rgb::BLACK;
    }
    let channel = |c: f32| -libm::logf(c.clamp(DARKEST, 1.0)) / depth;
    Rgb::new(channel(color.r), channel(color.g), channel(color.b))
}

/// What is left of light after `length` metres through a medium with the absorption coefficient `sigma`, exp(−σℓ).
#[inline]
#[must_use]
pub fn transmittance(sigma: Rgb, length: f32) -> Rgb {
    // Most of a scene is clear, and 0·∞ must not become NaN.
    let channel = |s: f32| if s == 0.0 { 1.0 } else { libm::expf(-s * length) };
    Rgb::new(channel(sigma.r), channel(sigma.g), channel(sigma.b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_has_the_colour_after_the_depth_and_its_square_after_twice_that() {
        let color = Rgb::new(0.9, 0.5, 0.1);
        let sigma = coefficient(color, 0.2);
        let (once, twice) = (transmittance(sigma, 0.2), transmittance(sigma, 0.4));
        for ((c, a), b) in color.to_array().into_iter().zip(once.to_array()).zip(twice.to_array()) {
            assert!((a - c).abs() < 1e-6);
            assert!((b - c * c).abs() < 1e-6);
        }
    }

    #[test]
    fn white_absorbs_nothing_and_black_is_finite() {
        assert_eq!(transmittance(coefficient(Rgb::WHITE, 0.01), f32::INFINITY), Rgb::WHITE);
        assert!(coefficient(Rgb::BLACK, 0.01).is_finite());
        assert_eq!(coefficient(Rgb::BLACK, 0.0), Rgb::BLACK);
    }
}
