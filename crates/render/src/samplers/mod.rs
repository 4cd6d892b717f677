//! Sample points as pure functions of (pixel, sample, dimension, seed): the same for any number of threads.

pub mod filter;
mod path;

pub use path::PathSampler;

use vitrine_math::hash;

/// Where in its pixel a sample lies, from 0 to 1 on both axes. Sample 0 is the middle, all others fill the pixel evenly around
/// it (the R2 sequence: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
#[must_use]
pub fn in_pixel(sample: u32) -> [f32; 2] {
    // 2³²/ρ and 2³²/ρ² with ρ the plastic number; whole numbers wrap around exactly.
    const STEP: [u32; 2] = [3_242_174_889, 2_447_445_414];
    STEP.map(|step| hash::unit(0x8000_0000_u32.wrapping_add(sample.wrapping_mul(step))))
}

/// Random points of the unit square for one pixel and one purpose. Any 4ᵏ points in a row, from a multiple of 4ᵏ on,
/// are stratified 2ᵏ × 2ᵏ: a (0,2)-sequence with randomly scrambled digits (Kollig and Keller, "Efficient Multidimensional
/// Sampling", 2002).
#[derive(Clone, Copy, Debug)]
pub struct SquareSampler {
    scramble: [u32; 2],
}

impl SquareSampler {
    /// For a pixel (any number that is its own) and a dimension, such as the light's index.
    #[must_use]
    pub const fn new(pixel: u32, dimension: u32, seed: u32) -> Self {
        let h = hash::join(hash::join(hash::mix(seed), pixel), dimension);
        Self { scramble: [h, hash::mix(h ^ 0x68bc_21eb)] }
    }

    /// Sixteen points from the index `first`, a multiple of 16, on: the coordinates u, then v, each in [0, 1).
    #[inline(always)]
    #[must_use]
    pub fn round(&self, first: u32) -> [[f32; 16]; 2] {
        // Digits are joined without carry, so the sixteen differ from the first by what their own last digits give.
        const U: [u32; 16] = bits_of_first_sixteen(false);
        const V: [u32; 16] = bits_of_first_sixteen(true);
        let u = first.reverse_bits() ^ self.scramble[0];
        let v = sobol_second(first) ^ self.scramble[1];
        [U.map(|bits| hash::unit(u ^ bits)), V.map(|bits| hash::unit(v ^ bits))]
    }
}

const fn bits_of_first_sixteen(second: bool) -> [u32; 16] {
    let mut bits = [0; 16];
    let mut i = 0;
    while i < 16 {
        bits[i] = if second { sobol_second(i as u32) } else { (i as u32).reverse_bits() };
        i += 1;
    }
    bits
}

/// The second dimension of Sobol's sequence.
pub(crate) const fn sobol_second(mut index: u32) -> u32 {
    let mut direction = 1_u32 << 31;
    let mut result = 0;
    while index != 0 {
        if index & 1 != 0 {
            result ^= direction;
        }
        index >>= 1;
        direction ^= direction >> 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_sample_is_the_middle_and_the_rest_are_even() {
        assert_eq!(in_pixel(0), [0.5, 0.5]);
        for n in [16_u32, 64, 256] {
            let mut quadrants = [0_u32; 4];
            for i in 0..n {
                let [x, y] = in_pixel(i);
                quadrants[usize::from(x >= 0.5) + 2 * usize::from(y >= 0.5)] += 1;
            }
            assert!(quadrants.iter().all(|&q| q.abs_diff(n / 4) <= 2), "{n}: {quadrants:?}");
        }
    }

    fn points(sampler: &SquareSampler, from: u32, count: u32) -> Vec<[f32; 2]> {
        let round = |first| {
            let [u, v] = sampler.round(first);
            (0..16).map(move |i| [u[i], v[i]])
        };
        (from..from + count).step_by(16).flat_map(round).collect()
    }

    #[test]
    fn every_stratum_holds_one_point() {
        for (pixel, side) in [(0_u32, 4_u32), (99, 4), (7, 8), (12_345, 16)] {
            let sampler = SquareSampler::new(pixel, 3, 1);
            let count = side * side;
            for block in [0, 5] {
                let mut cells = vec![0; count as usize];
                for [u, v] in points(&sampler, block * count, count) {
                    let [u, v] = [u, v].map(|x| (x * side as f32) as u32);
                    cells[(v * side + u) as usize] += 1;
                }
                assert!(cells.iter().all(|&c| c == 1), "pixel {pixel}, {side} × {side}");
            }
        }
    }

    #[test]
    fn pixels_dimensions_and_seeds_differ() {
        let p = |pixel, dimension, seed| SquareSampler::new(pixel, dimension, seed).round(0);
        assert_ne!(p(1, 0, 0), p(2, 0, 0));
        assert_ne!(p(1, 0, 0), p(1, 1, 0));
        assert_ne!(p(1, 0, 0), p(1, 0, 1));
        assert_eq!(p(1, 2, 3), p(1, 2, 3));
    }
}
