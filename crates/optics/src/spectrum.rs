//! How wavelengths look: the eye's response, turned into linear Rec. 709, in steps of a nanometre.
//!
//! Even white, the same radiance at every wavelength, is made (1, 1, 1): renderers trace colours in which white is the
//! white of the display.

use std::sync::OnceLock;
use vitrine_math::Rgb;

/// The shortest wavelength that counts, in nanometres.
pub(crate) const FIRST_NM: f32 = 380.0;
/// The steps of one nanometre, to 780 nm.
pub(crate) const STEPS: usize = 400;

/// One nanometre of the spectrum.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    /// Its share in the colour of even white. Summed over all steps, each channel is 1. Some shares are negative: pure
    /// colours of the spectrum lie outside Rec. 709.
    pub(crate) share: Rgb,
    /// How likely it is drawn: proportional to the sum of the channels' absolute values.
    pub(crate) probability: f32,
    /// The sum of the probabilities up to and with it; 1 at the last.
    pub(crate) cumulative: f32,
}

/// The middle of a step, in nanometres.
pub(crate) fn middle_nm(step: usize) -> f32 {
    FIRST_NM + step as f32 + 0.5
}

/// The spectrum's steps, worked out at the first call.
pub(crate) fn steps() -> &'static [Step] {
    static STEPS_ONCE: OnceLock<Vec<Step>> = OnceLock::new();
    STEPS_ONCE.get_or_init(make_steps)
}

/// Widths beside double precision: sums over 400 steps must be 1 to the last digit of single precision.
fn make_steps() -> Vec<Step> {
    let colors: Vec<[f64; 3]> = (0..STEPS).map(|i| rec709_from_xyz(xyz(f64::from(middle_nm(i))))).collect();
    let sum = |f: &dyn Fn(&[f64; 3]) -> f64| colors.iter().map(f).sum::<f64>();
    let totals = [sum(&|c| c[0]), sum(&|c| c[1]), sum(&|c| c[2])];
    let shares: Vec<[f64; 3]> =
        colors.iter().map(|c| [c[0] / totals[0], c[1] / totals[1], c[2] / totals[2]]).collect();
    let weight = |c: &[f64; 3]| c[0].abs() + c[1].abs() + c[2].abs();
    let all: f64 = shares.iter().map(weight).sum();
    let mut cumulative = 0.0;
    shares
        .iter()
        .enumerate()
        .map(|(i, c)| {
            cumulative += weight(c) / all;
            Step {
                share: Rgb::new(c[0] as f32, c[1] as f32, c[2] as f32),
                probability: (weight(c) / all) as f32,
                cumulative: if i + 1 == STEPS { 1.0 } else { cumulative as f32 },
            }
        })
        .collect()
}

/// The CIE 1931 colour matching functions at a wavelength in nanometres, by the multi-lobe fit of Wyman, Sloan and
/// Shirley ("Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2(2), 2013).
fn xyz(nm: f64) -> [f64; 3] {
    // A bell with one width below its middle and another above.
    let lobe = |height: f64, middle: f64, below: f64, above: f64| {
        let t = (nm - middle) * if nm < middle { below } else { above };
        height * libm::exp(-0.5 * t * t)
    };
    [
        lobe(0.362, 442.0, 0.0624, 0.0374)
            + lobe(1.056, 599.8, 0.0264, 0.0323)
            + lobe(-0.065, 501.1, 0.0490, 0.0382),
        lobe(0.821, 568.8, 0.0213, 0.0247) + lobe(0.286, 530.9, 0.0613, 0.0322),
        lobe(1.217, 437.0, 0.0845, 0.0278) + lobe(0.681, 459.0, 0.0385, 0.0725),
    ]
}

/// Linear Rec. 709 from XYZ (ITU-R BT.709, white D65).
fn rec709_from_xyz([x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        3.240_969_9 * x - 1.537_383_2 * y - 0.498_610_8 * z,
        -0.969_243_6 * x + 1.875_967_5 * y + 0.041_555_06 * z,
        0.055_630_08 * x - 0.203_976_96 * y + 1.056_971_5 * z,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_white_and_the_probabilities_are_whole() {
        let mut sum = [0.0_f64; 4];
        for s in steps() {
            for (total, part) in sum.iter_mut().zip([s.share.r, s.share.g, s.share.b, s.probability]) {
                *total += f64::from(part);
            }
        }
        assert!(sum.iter().all(|s| (s - 1.0).abs() < 1e-6), "{sum:?}");
        assert_eq!(steps().len(), STEPS);
        assert!(steps().windows(2).all(|w| w[0].cumulative <= w[1].cumulative));
    }

    #[test]
    fn colours_stand_where_they_do_in_a_rainbow() {
        let at = |nm: f32| steps()[(nm - FIRST_NM) as usize].share;
        let (blue, green, red) = (at(450.0), at(535.0), at(620.0));
        assert!(blue.b > blue.g && blue.b > blue.r);
        assert!(green.g > green.b && green.g > green.r);
        assert!(red.r > red.g && red.r > red.b);
    }
}
