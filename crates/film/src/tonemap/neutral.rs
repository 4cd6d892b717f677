//! Khronos PBR Neutral: shows the colours of surfaces as they are, and takes only the brightest light back towards white.
//!
//! Khronos Group, "PBR Neutral Tone Mapping Specification", 2024 (github.com/KhronosGroup/ToneMapping). Beyond Rec. 709, where the
//! specification says nothing, channels below 0 count as 0.

use vitrine_math::Rgb;

/// What a surface of index 1.5 mirrors at least, which the eye takes for haze: the specification's F90.
const HAZE: f32 = 0.04;
/// Where compression starts: K_s = 0.8 − F90.
const START: f32 = 0.8 - HAZE;
/// How fast compressed colours lose saturation: K_d.
const FADING: f32 = 0.15;
/// As bright as white gets; keeps infinities out of the formulas.
const MOST: f32 = 1e9;

/// Linear display light, each channel from 0 to 1.
pub fn map(color: Rgb) -> Rgb {
    // NaN is not greater than 0 either.
    let [r, g, b] = color.to_array().map(|v| if v > 0.0 { v.min(MOST) } else { 0.0 });
    // f = x − x²/(4·F90) where the least channel x ≤ 2·F90, else F90.
    let x = r.min(g).min(b);
    let f = if x <= 2.0 * HAZE { x - x * x / (4.0 * HAZE) } else { HAZE };
    let clear = Rgb::new(r - f, g - f, b - f);
    let p = (r - f).max(g - f).max(b - f);
    if p <= START {
        return clear;
    }
    // p_n = 1 − (1 − K_s)²/(p + 1 − 2·K_s);  g = 1/(K_d·(p − p_n) + 1);  c = (c − f)·(p_n/p)·g + p_n·(1 − g)
    let compressed = 1.0 - (1.0 - START) * (1.0 - START) / (p + 1.0 - 2.0 * START);
    let kept = 1.0 / (FADING * (p - compressed) + 1.0);
    clear * (compressed / p * kept) + Rgb::splat(compressed * (1.0 - kept))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn below_the_start_of_compression_colours_only_lose_the_haze() {
        let shown = map(Rgb::new(0.6, 0.3, 0.1));
        for (v, expected) in shown.to_array().into_iter().zip([0.56, 0.26, 0.06]) {
            assert!((v - expected).abs() < 1e-6, "{shown:?}");
        }
        // Dark greys: x − (x − 6.25·x²) = 6.25·x².
        let dark = map(Rgb::splat(0.04));
        assert!((dark.r - 6.25 * 0.04 * 0.04).abs() < 1e-7, "{dark:?}");
    }

    #[test]
    fn compressed_values_are_those_of_the_formula() {
        // A grey of 1: p = 0.96, p_n = 1 − 0.24²/(0.96 + 1 − 1.52) = 0.869 091; grey stays grey.
        let grey = map(Rgb::WHITE);
        assert!((grey.g - 0.869_091).abs() < 1e-6 && grey.r == grey.g && grey.g == grey.b, "{grey:?}");
        // Red of 4: p = 4, p_n = 1 − 0.0576/3.48 = 0.983 448, g = 1/(0.15·3.016 552 + 1) = 0.688 476.
        let red = map(Rgb::new(4.0, 0.0, 0.0));
        let expected = [0.983_448, 0.306_368, 0.306_368];
        for (v, expected) in red.to_array().into_iter().zip(expected) {
            assert!((v - expected).abs() < 1e-5, "{red:?}");
        }
    }

    #[test]
    fn it_has_no_step_where_its_pieces_meet() {
        for seam in [0.08, START + HAZE] {
            let [below, above] = [-1e-5, 1e-5].map(|d| map(Rgb::splat(seam + d)).r);
            assert!((0.0..5e-5).contains(&(above - below)), "{below} {above}");
        }
    }
}
