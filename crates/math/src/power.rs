//! A power function for highlights: fast, and the same bits on every machine.

/// `x^s` for `0 ≤ x ≤ 1` and `s ≥ 1`, as `2^(s·log₂x)`.
///
/// The relative error stays below 2e-6·(1 + s·|log₂x|), that is below 1e-4 for every value that a picture can show.
/// Written without branches and without casts to integers, so that a loop over lanes vectorises.
#[inline(always)]
#[must_use]
pub fn pow_unit(x: f32, s: f32) -> f32 {
    // Below the smallest normal number the logarithm's bit trick fails; such a power is 0 for every s of use.
    let x = if x < f32::MIN_POSITIVE { f32::MIN_POSITIVE } else { x };
    exp2(s * log2(x))
}

/// log₂ of a normal positive number: exponent from the bits, mantissa m in [√½, √2) by the series of
/// 2·artanh((m−1)/(m+1))/ln 2.
#[inline(always)]
fn log2(x: f32) -> f32 {
    const SQRT_HALF: u32 = 0x3f35_04f3;
    let bits = x.to_bits().wrapping_sub(SQRT_HALF);
    let exponent = (bits as i32) >> 23;
    let mantissa = f32::from_bits((bits & 0x007f_ffff).wrapping_add(SQRT_HALF));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    // 2/(ln 2·(2k+1)) for k = 0, 1, 2, 3, 4
    let series = 2.885_39 + z2 * (0.961_796_7 + z2 * (0.577_078_03 + z2 * (0.412_198_6 + z2 * 0.320_598_9)));
    exponent as f32 + z * series
}

/// 2^y for y ≤ 0; underflows to 0.
#[inline(always)]
fn exp2(y: f32) -> f32 {
    // Adding 1.5·2²³ rounds to the nearest integer and leaves it in the low bits.
    const ROUND: f32 = 12_582_912.0;
    let y = if y > -150.0 { y } else { -150.0 };
    let rounded = y + ROUND;
    let f = y - (rounded - ROUND);
    // Taylor series of 2^f on |f| ≤ ½.
    let series = 1.0
        + f * (std::f32::consts::LN_2
            + f * (0.240_226_5
                + f * (0.055_504_11 + f * (0.009_618_129 + f * (0.001_333_355_8 + f * 0.000_154_035_3)))));
    // Two halves, so that results near the smallest normal numbers still have an exponent.
    let e = rounded.to_bits().wrapping_sub(ROUND.to_bits()) as i32;
    let scale = |e: i32| f32::from_bits(((e + 127) as u32) << 23);
    let half = e >> 1;
    series * scale(half) * scale(e - half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_library_power() {
        for i in 0..=2000_u16 {
            let x = f32::from(i) / 2000.0;
            for s in [1.0_f32, 2.0, 10.0, 33.3, 100.0, 1000.0] {
                let truth = f64::from(x).powf(f64::from(s));
                let ours = f64::from(pow_unit(x, s));
                let allowed = if truth > 1e-30 {
                    2e-6 * truth * (1.0 + f64::from(s) * f64::from(x).log2().abs())
                } else {
                    1e-19
                };
                assert!((ours - truth).abs() <= allowed, "{x}^{s}: {ours} against {truth}");
            }
        }
    }

    #[test]
    fn ends_are_exact() {
        assert_eq!(pow_unit(1.0, 50.0), 1.0);
        assert_eq!(pow_unit(0.0, 50.0), 0.0);
    }
}
