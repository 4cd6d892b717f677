//! Chance as a pure function: the same inputs give the same number on every machine and thread.

/// Mixes 32 bits so that every input bit reaches every output bit (PCG's RXS-M-XS step; Jarzynski and Olano, "Hash
/// Functions for GPU Rendering", JCGT 9(3), 2020).
#[inline(always)]
#[must_use]
pub const fn mix(value: u32) -> u32 {
    let state = value.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Joins a further number to a hash.
#[inline(always)]
#[must_use]
pub const fn join(hash: u32, value: u32) -> u32 {
    mix(hash ^ mix(value).wrapping_mul(0x9e37_79b9))
}

/// A hash as a number in [0, 1): its upper 24 bits, so the result is exact.
#[inline(always)]
#[must_use]
pub const fn unit(hash: u32) -> f32 {
    (hash >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_numbers_are_uniform() {
        // Chi-squared over 64 bins; the 99.99 % point for 63 degrees of freedom is 114.
        const N: u32 = 64_000;
        let mut bins = [0_u32; 64];
        for i in 0..N {
            bins[(unit(join(mix(7), i)) * 64.0) as usize] += 1;
        }
        let expected = f64::from(N) / 64.0;
        let chi2: f64 = bins.iter().map(|&n| (f64::from(n) - expected).powi(2) / expected).sum();
        assert!(chi2 < 114.0, "chi² = {chi2}");
    }

    #[test]
    fn neighbours_are_unrelated() {
        // The correlation of successive numbers is within 4σ of 0.
        const N: u32 = 100_000;
        let sum: f64 =
            (0..N).map(|i| f64::from(unit(mix(i)) - 0.5) * f64::from(unit(mix(i + 1)) - 0.5)).sum();
        let correlation = sum / f64::from(N) * 12.0;
        assert!(correlation.abs() < 4.0 / f64::from(N).sqrt(), "{correlation}");
    }
}
