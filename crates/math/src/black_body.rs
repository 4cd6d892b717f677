//! The colour of what glows, by its temperature: Planck's law seen with the CIE 1931 observer.

use crate::Rgb;

/// The first and the last wavelength that count, and the step of the sum, nanometres.
const FIRST: f64 = 360.0;
const LAST: f64 = 830.0;
const STEP: f64 = 5.0;

/// The colour of a black body as hot as `kelvin`, 1000 to 40 000 (others are drawn in), with luminance 1. A colour beyond
/// what red, green and blue can mix is drawn in: no channel is negative.
#[must_use]
pub fn black_body_color(kelvin: f32) -> Rgb {
    // f64: below 2000 K blue is the small difference of large numbers.
    let kelvin = f64::from(if kelvin.is_nan() { 6500.0 } else { kelvin }).clamp(1000.0, 40_000.0);
    let mut xyz = [0.0; 3];
    let steps = ((LAST - FIRST) / STEP) as u32;
    for i in 0..=steps {
        let nm = FIRST + f64::from(i) * STEP;
        let power = planck(nm, kelvin);
        xyz.iter_mut().zip(observer(nm)).for_each(|(sum, response)| *sum += power * response);
    }
    let [x, y, z] = xyz.map(|v| v / xyz[1]);
    // XYZ to linear Rec. 709 with white D65 (IEC 61966-2-1).
    let rgb = [
        3.240_970 * x - 1.537_383 * y - 0.498_611 * z,
        -0.969_244 * x + 1.875_968 * y + 0.041_555 * z,
        0.055_630 * x - 0.203_977 * y + 1.056_972 * z,
    ];
    let [r, g, b] = rgb.map(|channel| channel.max(0.0) as f32);
    let color = Rgb::new(r, g, b);
    color / color.luminance()
}

/// Planck's law but for a constant factor: radiance at a wavelength in nanometres.
fn planck(nm: f64, kelvin: f64) -> f64 {
    /// hc/k, nanometres times kelvin (CODATA 2018).
    const SECOND: f64 = 1.438_776_877e7;
    // λ⁻⁵ / (exp(hc/λkT) − 1); in micrometres, so that no power is extreme
    let um = nm / 1000.0;
    1.0 / (um * um * um * um * um * libm::expm1(SECOND / (nm * kelvin)))
}

/// The CIE 1931 colour matching functions x̄, ȳ, z̄ (Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE
/// XYZ Color Matching Functions", JCGT 2(2), 2013).
fn observer(nm: f64) -> [f64; 3] {
    // A lobe: its height, middle, and widths below and above.
    let lobe = |height: f64, middle: f64, below: f64, above: f64| {
        let t = (nm - middle) / if nm < middle { below } else { above };
        height * libm::exp(-0.5 * t * t)
    };
    [
        lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) - lobe(0.065, 501.1, 20.4, 26.2),
        lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
        lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chromaticity x, y of a linear Rec. 709 colour.
    fn chromaticity(c: Rgb) -> [f32; 2] {
        let x = 0.412_391 * c.r + 0.357_584 * c.g + 0.180_481 * c.b;
        let y = 0.212_639 * c.r + 0.715_169 * c.g + 0.072_192 * c.b;
        let z = 0.019_331 * c.r + 0.119_195 * c.g + 0.950_532 * c.b;
        [x / (x + y + z), y / (x + y + z)]
    }

    #[test]
    fn colours_lie_on_the_published_planckian_locus() {
        // CIE 15; Illuminant A is 2856 K.
        let table = [
            (2856.0, [0.4476, 0.4074]),
            (4000.0, [0.3805, 0.3768]),
            (5000.0, [0.3451, 0.3516]),
            (6500.0, [0.3135, 0.3237]),
            (10_000.0, [0.2807, 0.2884]),
        ];
        for (kelvin, published) in table {
            let color = black_body_color(kelvin);
            assert!((color.luminance() - 1.0).abs() < 1e-5);
            for (ours, published) in chromaticity(color).into_iter().zip(published) {
                assert!((ours - published).abs() < 0.003, "{kelvin} K: {ours} against {published}");
            }
        }
    }

    #[test]
    fn heat_turns_red_into_blue_and_no_channel_is_negative() {
        let mut before = f32::INFINITY;
        for kelvin in (1000..=40_000).step_by(500) {
            let Rgb { r, g, b } = black_body_color(kelvin as f32);
            assert!(r > 0.0 && g > 0.0 && b >= 0.0 && r / g < before, "{kelvin} K");
            before = r / g;
        }
        assert_eq!(black_body_color(1000.0).b, 0.0);
        assert!(black_body_color(f32::NAN).is_finite());
    }
}
