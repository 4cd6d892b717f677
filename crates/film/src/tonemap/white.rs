//! White balance: which light shows as white.
//!
//! The chromaticity of light of a temperature is a black body's up to 4000 K and daylight's from 5000 K, with a mixture between, as
//! CIE 224:2017 has its reference lights (here the chromaticities are mixed rather than the spectra). Colours are adapted by the
//! Bradford transform (Lam 1985; the matrix as in ICC.1:2022, annex E).

/// D65, the white of Rec. 709.
const D65: [f64; 2] = [0.3127, 0.329];
/// The temperature that is D65's: its definition in the kelvin of 1964 (c2 = 0.01438 m·K) came out as 6504 K in those of today.
const WHITE: f64 = 6500.0;
const KELVIN_NOW: f64 = 1.438_776_877 / 1.438;
/// From linear Rec. 709 to CIE XYZ, and back (IEC 61966-2-1).
const XYZ: Matrix = [
    [0.412_390_799, 0.357_584_339, 0.180_480_788],
    [0.212_639_006, 0.715_168_679, 0.072_192_315],
    [0.019_330_819, 0.119_194_780, 0.950_532_152],
];
const BRADFORD: Matrix = [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];

/// f64, for a matrix and its inverse must undo each other to all of f32's digits. Row by row.
type Matrix = [[f64; 3]; 3];

/// What linear Rec. 709 is multiplied by so that light of so many kelvin shows as white. Exactly one at 6500.
pub fn matrix(kelvin: f32) -> [[f32; 3]; 3] {
    let kelvin = f64::from(kelvin);
    if kelvin == WHITE {
        return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    }
    // M = XYZ⁻¹ · B⁻¹ · diag(B·w_D65 / B·w) · B · XYZ
    let cones = product(BRADFORD, XYZ);
    let [from, to] =
        [chromaticity(kelvin), D65].map(|[x, y]| times(BRADFORD, [x / y, 1.0, (1.0 - x - y) / y]));
    let scaled = [0, 1, 2].map(|i| cones[i].map(|v| v * to[i] / from[i]));
    product(inverse(cones), scaled).map(|row| row.map(|v| v as f32))
}

/// The chromaticity x, y of white light of a temperature; from 1000 to 25 000 K, beyond that those of the ends.
fn chromaticity(kelvin: f64) -> [f64; 2] {
    let kelvin = kelvin.clamp(1000.0, 25_000.0);
    // 0 up to 4000 K, 1 from 5000 K.
    let share = ((kelvin - 4000.0) / 1000.0).clamp(0.0, 1.0);
    let [a, b] = [black_body(kelvin.min(5000.0)), daylight(kelvin.max(4000.0) * KELVIN_NOW)];
    [0, 1].map(|i| a[i] + (b[i] - a[i]) * share)
}

/// A black body of 1000 to 15 000 K (M. Krystek, "An algorithm to calculate correlated colour temperature", Color Research and
/// Application 10, 1985): rational functions for u and v of CIE 1960, within 1e-4.
fn black_body(t: f64) -> [f64; 2] {
    let u = (0.860_117_757 + 1.541_182_54e-4 * t + 1.286_412_12e-7 * t * t)
        / (1.0 + 8.424_202_35e-4 * t + 7.081_451_63e-7 * t * t);
    let v = (0.317_398_726 + 4.228_062_45e-5 * t + 4.204_816_91e-8 * t * t)
        / (1.0 - 2.897_418_16e-5 * t + 1.614_560_53e-7 * t * t);
    // x = 3u/(2u − 8v + 4), y = 2v/(2u − 8v + 4)
    let scale = 1.0 / (2.0 * u - 8.0 * v + 4.0);
    [3.0 * u * scale, 2.0 * v * scale]
}

/// Daylight of 4000 to 25 000 K (CIE 15:2004, section 3.1).
fn daylight(t: f64) -> [f64; 2] {
    let i = 1.0 / t;
    let x = if t <= 7000.0 {
        ((-4.6070e9 * i + 2.9678e6) * i + 99.11) * i + 0.244_063
    } else {
        ((-2.0064e9 * i + 1.9018e6) * i + 247.48) * i + 0.237_040
    };
    [x, (-3.0 * x + 2.870) * x - 0.275]
}

fn times(m: Matrix, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    let column = |j: usize| times(a, [b[0][j], b[1][j], b[2][j]]);
    let [x, y, z] = [column(0), column(1), column(2)];
    [0, 1, 2].map(|i| [x[i], y[i], z[i]])
}

/// By cofactors. No matrix here is near to a singular one.
fn inverse(m: Matrix) -> Matrix {
    let minor = |r: usize, c: usize| {
        let [r0, r1] = [(r + 1) % 3, (r + 2) % 3];
        let [c0, c1] = [(c + 1) % 3, (c + 2) % 3];
        m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]
    };
    let determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / determinant))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    #[test]
    fn chromaticities_are_those_of_the_tables() {
        // CIE standard illuminant A is a black body of 2856 K; D50, D65 and D75 have their names from the old kelvin.
        for (kelvin, expected) in [
            (2855.5, [0.447_57, 0.407_45]),
            (5000.0, [0.345_67, 0.358_50]),
            (6500.0, [0.312_71, 0.329_02]),
            (7500.0, [0.299_02, 0.314_85]),
        ] {
            let found = chromaticity(kelvin);
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() < 4e-4, "{kelvin}: {found:?}");
            }
        }
    }

    #[test]
    fn at_6500_nothing_changes_and_beside_it_hardly_anything() {
        assert_eq!(matrix(6500.0), ONE);
        for kelvin in [6499.0, 6501.0] {
            for (row, one) in matrix(kelvin).iter().zip(ONE) {
                for (v, one) in row.iter().zip(one) {
                    // A third of a step in 8 bits.
                    assert!((v - one).abs() < 1.3e-3, "{kelvin}: {row:?}");
                }
            }
        }
    }

    #[test]
    fn light_of_the_temperature_shows_as_white() {
        for kelvin in [1900.0, 3000.0, 4500.0, 10_000.0] {
            let [x, y] = chromaticity(f64::from(kelvin));
            let light = times(inverse(XYZ), [x / y, 1.0, (1.0 - x - y) / y]);
            let shown = matrix(kelvin).map(|row| (0..3).map(|i| f64::from(row[i]) * light[i]).sum::<f64>());
            for v in shown {
                assert!((v - 1.0).abs() < 2e-3, "{kelvin}: {shown:?}");
            }
        }
    }

    #[test]
    fn temperatures_change_without_steps_and_lower_ones_are_redder() {
        let mut last = chromaticity(1000.0);
        for kelvin in (1010..25_000).step_by(10) {
            let [x, y] = chromaticity(f64::from(kelvin));
            assert!(x < last[0] && (y - last[1]).abs() < 2e-3, "{kelvin}");
            last = [x, y];
        }
    }
}
