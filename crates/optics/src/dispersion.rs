//! How the index of glass changes with the wavelength, and how a path draws the one wavelength that it then carries.

use crate::spectrum;
use vitrine_math::Rgb;

/// Fraunhofer's lines by which glass is catalogued, in nanometres: d (helium), F and C (hydrogen).
const LINE_D: f32 = 587.56;
const LINE_F: f32 = 486.13;
const LINE_C: f32 = 656.27;

/// Cauchy's law of two terms, n(λ) = a + b/λ².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cauchy {
    /// The index that it would have at infinite wavelength.
    pub a: f32,
    /// How fast it rises towards blue, in square nanometres.
    pub b: f32,
}

impl Cauchy {
    /// From the index at 587.56 nm, `n_d`, and the Abbe number, `v_d`: 20 to 90 in real glass, the less the more colour.
    /// An Abbe number of 0 or less, or an infinite one, gives a glass without dispersion.
    ///
    ///   V_d = (n_d − 1)/(n_F − n_C)  ⇒  b = (n_d − 1)/(V_d(λ_F⁻² − λ_C⁻²)), a = n_d − b/λ_d²
    #[must_use]
    pub fn from_abbe(n_d: f32, v_d: f32) -> Self {
        if v_d <= 0.0 || !v_d.is_finite() {
            return Self { a: n_d, b: 0.0 };
        }
        let inverse2 = |nm: f32| 1.0 / (nm * nm);
        let b = (n_d - 1.0) / (v_d * (inverse2(LINE_F) - inverse2(LINE_C)));
        Self { a: n_d - b * inverse2(LINE_D), b }
    }

    /// The index at a wavelength in nanometres.
    #[inline]
    #[must_use]
    pub fn at(&self, wavelength_nm: f32) -> f32 {
        self.a + self.b / (wavelength_nm * wavelength_nm)
    }
}

/// Draws a wavelength in nanometres, 380 to 780, and what it weighs as a colour: its linear Rec. 709 response over its
/// density. `u` is in [0, 1).
///
/// The mean of the colours over all `u` is (1, 1, 1), so a path that carries one wavelength is right on average. Single
/// colours have negative channels, for no display shows a pure colour of the spectrum.
#[must_use]
pub fn sample_wavelength(u: f32) -> (f32, Rgb) {
    let steps = spectrum::steps();
    let at = steps.partition_point(|s| s.cumulative <= u).min(spectrum::STEPS - 1);
    let step = steps[at];
    let below = step.cumulative - step.probability;
    let inside = ((u - below) / step.probability).clamp(0.0, 1.0);
    (spectrum::FIRST_NM + at as f32 + inside, step.share / step.probability)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bk7_has_its_catalogue_indices() {
        let bk7 = Cauchy::from_abbe(1.5168, 64.17);
        assert!((bk7.at(LINE_D) - 1.5168).abs() < 1e-6);
        assert!((bk7.at(LINE_F) - 1.522_43).abs() < 2e-5, "{}", bk7.at(LINE_F));
        assert!((bk7.at(LINE_C) - 1.514_38).abs() < 2e-5, "{}", bk7.at(LINE_C));
        let plain = Cauchy::from_abbe(1.5, 0.0);
        assert_eq!((plain.at(400.0), plain.at(700.0)), (1.5, 1.5));
    }

    #[test]
    fn the_mean_of_the_colours_is_white() {
        const N: u32 = 1 << 20;
        let mut sum = [0.0_f64; 3];
        for i in 0..N {
            let (nm, color) = sample_wavelength((i as f32 + 0.5) / N as f32);
            assert!((380.0..=780.0).contains(&nm) && color.is_finite());
            for (total, part) in sum.iter_mut().zip(color.to_array()) {
                *total += f64::from(part);
            }
        }
        for channel in sum {
            assert!((channel / f64::from(N) - 1.0).abs() < 2e-4, "{sum:?}");
        }
    }

    #[test]
    fn wavelengths_rise_with_u_and_weights_stay_small() {
        let mut last = 0.0;
        for i in 0..1000_u16 {
            let (nm, color) = sample_wavelength(f32::from(i) / 1000.0);
            assert!(nm >= last);
            last = nm;
            // Drawn by the sum of the absolute values: no channel weighs more than that sum over all wavelengths.
            assert!(color.to_array().iter().all(|c| c.abs() < 5.0), "{nm}: {color:?}");
        }
    }
}
