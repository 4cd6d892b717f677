//! AgX: like film, holds very bright and very saturated light in one picture; bright colours fade towards white.
//!
//! Troy Sobotka's AgX, in the approximation of its base look by Benjamin Wrensch, "Minimal AgX Implementation", 2023: a matrix that
//! moves the primaries inwards, 16.5 stops on a logarithmic scale, a sigmoid (here as a polynomial), and the matrix undone.

use vitrine_math::Rgb;

/// Moves the primaries inwards, row by row.
const INWARD: [[f32; 3]; 3] = [
    [0.842_479_05, 0.078_433_6, 0.079_223_745],
    [0.042_328_24, 0.878_468_64, 0.079_166_13],
    [0.042_375_655, 0.078_433_6, 0.879_143],
];
/// Its inverse.
const OUTWARD: [[f32; 3]; 3] = [
    [1.196_879, -0.098_020_88, -0.099_029_74],
    [-0.052_896_85, 1.151_903_1, -0.098_961_18],
    [-0.052_971_635, -0.098_043_45, 1.151_073_7],
];
/// The stops of what shows black and of what shows white.
const STOPS: [f32; 2] = [-12.473_93, 4.026_069];
/// The sigmoid's coefficients, the highest power first.
const SIGMOID: [f32; 7] = [15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.002_32];
/// The curve of the display for which the sigmoid was made.
const GAMMA: f32 = 2.2;

/// Linear display light, each channel from 0 to 1.
pub fn map(color: Rgb) -> Rgb {
    let [black, white] = STOPS;
    let curve = |v: f32| {
        // Nothing darker than 2^black matters, so neither do zero, negative numbers and NaN; `max` gives the other number for it.
        let stops = libm::log2f(v.max(1e-5)).clamp(black, white);
        let x = (stops - black) / (white - black);
        SIGMOID.iter().fold(0.0, |sum, c| sum * x + c)
    };
    let seen = times(INWARD, color.to_array()).map(curve);
    let shown = times(OUTWARD, seen);
    Rgb::from(shown.map(|v| libm::powf(v.clamp(0.0, 1.0), GAMMA)))
}

fn times(matrix: [[f32; 3]; 3], [r, g, b]: [f32; 3]) -> [f32; 3] {
    matrix.map(|[x, y, z]| x * r + y * g + z * b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrices_undo_each_other_and_keep_grey() {
        for color in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.5, 0.9]] {
            let back = times(OUTWARD, times(INWARD, color));
            for (a, b) in color.iter().zip(back) {
                assert!((a - b).abs() < 2e-6, "{color:?} {back:?}");
            }
        }
        for v in times(INWARD, [1.0; 3]) {
            assert!((v - 1.0).abs() < 3e-4, "{v}");
        }
    }

    #[test]
    fn middle_grey_black_and_white() {
        let grey = |v: f32| map(Rgb::splat(v)).g;
        // AgX's pivot: middle grey shows as 0.4894 to the power of 2.2 and more or less so by the polynomial.
        assert!((grey(0.18) - libm::powf(0.4894, 2.2)).abs() < 0.01, "{}", grey(0.18));
        assert_eq!(grey(0.0), 0.0);
        assert!(grey(16.0) > 0.99 && grey(1e30) <= 1.0, "{}", grey(16.0));
    }

    #[test]
    fn brighter_light_shows_brighter() {
        let mut last = 0.0;
        for step in 0..2000 {
            let v = libm::exp2f(-12.4 + 16.4 * step as f32 / 2000.0);
            let shown = map(Rgb::splat(v)).g;
            assert!(shown >= last, "{v}: {shown} after {last}");
            last = shown;
        }
    }
}
