//! Sample points as pure functions of (pixel, sample, dimension, seed): the same for any number of threads.

use vitrine_math::{Vec2, hash};

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

    /// A point, each coordinate in [0, 1).
    #[must_use]
    pub fn point(&self, index: u32) -> Vec2 {
        Vec2::new(
            hash::unit(index.reverse_bits() ^ self.scramble[0]),
            hash::unit(sobol_second(index) ^ self.scramble[1]),
        )
    }
}

/// The second dimension of Sobol's sequence.
const fn sobol_second(mut index: u32) -> u32 {
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

    #[test]
    fn every_stratum_holds_one_point() {
        for (pixel, side) in [(0_u32, 4_u32), (99, 4), (7, 8), (12_345, 16)] {
            let sampler = SquareSampler::new(pixel, 3, 1);
            for block in [0, 5] {
                let mut cells = vec![0; (side * side) as usize];
                for i in 0..side * side {
                    let p = sampler.point(block * side * side + i) * side as f32;
                    cells[(p.y as u32 * side + p.x as u32) as usize] += 1;
                }
                assert!(cells.iter().all(|&c| c == 1), "pixel {pixel}, {side} × {side}");
            }
        }
    }

    #[test]
    fn pixels_dimensions_and_seeds_differ() {
        let p = |pixel, dimension, seed| SquareSampler::new(pixel, dimension, seed).point(0);
        assert_ne!(p(1, 0, 0), p(2, 0, 0));
        assert_ne!(p(1, 0, 0), p(1, 1, 0));
        assert_ne!(p(1, 0, 0), p(1, 0, 1));
        assert_eq!(p(1, 2, 3), p(1, 2, 3));
    }
}
