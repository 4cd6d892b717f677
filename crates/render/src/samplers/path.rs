//! Sample points for paths: as many dimensions as a path needs, each pair of them evenly filled by the samples of a pixel.
//!
//! Sobol's sequence in two dimensions, its digits scrambled by hashing (Owen; Laine and Karras; Burley, "Practical Hash-based Owen
//! Scrambling", JCGT 9(4), 2020). Each dimension takes the same two-dimensional points in an order of its own ("padding"), so the
//! points of two dimensions are as unrelated as random ones.

use vitrine_math::hash;

/// The random numbers of one sample of one pixel: a pure function of pixel, sample, dimension and seed.
///
/// A dimension is any number; one and the same dimension gives either one number or a pair, for the first of the pair is the
/// same number. The first 2ᵏ samples of a pixel are stratified in every dimension, for all k.
#[derive(Clone, Copy, Debug)]
pub struct PathSampler {
    /// The sample's index with its bits reversed.
    reversed: u32,
    /// Of the pixel and the seed.
    key: u64,
}

impl PathSampler {
    /// For a sample of a pixel (column, row), counted from 0. Another seed gives another, unrelated picture's noise.
    #[inline]
    #[must_use]
    pub const fn new(pixel: [u32; 2], sample: u32, seed: u32) -> Self {
        let low = hash::join(hash::join(hash::mix(seed), pixel[0]), pixel[1]);
        let high = hash::mix(low ^ 0x68bc_21eb);
        Self { reversed: sample.reverse_bits(), key: (high as u64) << 32 | low as u64 }
    }

    /// A number in [0, 1).
    #[inline]
    #[must_use]
    pub const fn one(&self, dimension: u32) -> f32 {
        let seeds = self.seeds(dimension);
        let index = scramble(self.reversed, seeds[0]).reverse_bits();
        hash::unit(scramble(index, seeds[1]).reverse_bits())
    }

    /// A point in [0, 1)².
    #[inline]
    #[must_use]
    pub const fn two(&self, dimension: u32) -> [f32; 2] {
        let seeds = self.seeds(dimension);
        let index = scramble(self.reversed, seeds[0]).reverse_bits();
        // All digits stay reversed until the end: the first dimension's are then the index itself.
        let u = scramble(index, seeds[1]).reverse_bits();
        let v = scramble(second_dimension(index), seeds[2]).reverse_bits();
        [hash::unit(u), hash::unit(v)]
    }

    /// Unrelated seeds for the order, the first and the second number of a dimension: one round of mixing 64 bits (Steele, Lea and
    /// Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
    #[inline]
    const fn seeds(&self, dimension: u32) -> [u32; 3] {
        let mut z = self.key.wrapping_add((dimension as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        [z as u32, (z >> 32) as u32, (z.wrapping_mul(0xd6e8_feb8_6659_fd93) >> 32) as u32]
    }
}

/// Owen's scrambling of digits in reversed order: each bit is flipped, or not, by a hash of the bits below it (Laine and Karras,
/// "Stratified Sampling for Stochastic Transparency", 2011; the constants are Vegdahl's, "Building a Better LK Hash", 2021).
#[inline]
const fn scramble(mut reversed: u32, seed: u32) -> u32 {
    reversed ^= reversed.wrapping_mul(0x3d20_adea);
    reversed = reversed.wrapping_add(seed);
    reversed = reversed.wrapping_mul((seed >> 16) | 1);
    reversed ^= reversed.wrapping_mul(0x0552_6c56);
    reversed ^ reversed.wrapping_mul(0x53a2_2864)
}

/// The second dimension of Sobol's sequence, its digits reversed: the index times Pascal's triangle modulo 2, which falls into five
/// steps (Ahmed, "An Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR 2024).
#[inline]
const fn second_dimension(index: u32) -> u32 {
    let mut v = index;
    v ^= v >> 16;
    v ^= (v & 0xff00_ff00) >> 8;
    v ^= (v & 0xf0f0_f0f0) >> 4;
    v ^= (v & 0xcccc_cccc) >> 2;
    v ^ (v & 0xaaaa_aaaa) >> 1
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIXELS: [[u32; 2]; 4] = [[0, 0], [1, 0], [1919, 3], [511, 1079]];

    fn points(pixel: [u32; 2], dimension: u32, count: u32) -> Vec<[f32; 2]> {
        (0..count).map(|sample| PathSampler::new(pixel, sample, 5).two(dimension)).collect()
    }

    #[test]
    fn the_second_dimension_is_sobols() {
        for index in (0..2000).chain([u32::MAX, 0x8000_0000, 0x1234_5678]) {
            assert_eq!(
                second_dimension(index).reverse_bits(),
                crate::samplers::sobol_second(index),
                "{index:#x}"
            );
        }
    }

    #[test]
    fn every_elementary_interval_of_every_power_of_two_holds_one_point() {
        for (pixel, dimension) in PIXELS.into_iter().flat_map(|pixel| (0..20).map(move |d| (pixel, d))) {
            for k in 0..=9_u32 {
                let points = points(pixel, dimension, 1 << k);
                for across in 0..=k {
                    let [columns, rows] = [1_u32 << across, 1 << (k - across)];
                    let mut held = vec![0; 1 << k];
                    for [u, v] in &points {
                        let [u, v] = [(u * columns as f32) as u32, (v * rows as f32) as u32];
                        held[(v * columns + u) as usize] += 1;
                    }
                    assert!(held.iter().all(|&n| n == 1), "{pixel:?}, {dimension}: {columns} × {rows}");
                }
            }
        }
    }

    #[test]
    fn one_number_is_the_first_of_a_pair() {
        for sample in 0..100 {
            let sampler = PathSampler::new([3, 4], sample, 9);
            assert_eq!(sampler.one(7), sampler.two(7)[0]);
        }
    }

    /// The correlation of pairs of numbers in [0, 1).
    fn correlation(pairs: impl Iterator<Item = [f32; 2]>) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for [a, b] in pairs {
            sum += (f64::from(a) - 0.5) * (f64::from(b) - 0.5) * 12.0;
            count += 1.0;
        }
        sum / count
    }

    #[test]
    fn dimensions_pixels_and_seeds_are_unrelated() {
        // Over 400 sets of 64 samples the mean correlation of two dimensions is within 4σ of 0, and its spread in one set
        // is what fully random nested permutations give, measured as √1.58/8; for random numbers it would be 1/8.
        let unrelated = |name: &str, pair: &dyn Fn(u32, u32) -> [f32; 2]| {
            let each = (0..400).map(|i| correlation((0..64).map(|sample| pair(i, sample))));
            let (sum, squares) = each.fold((0.0, 0.0), |(s, q), c| (s + c, q + c * c));
            assert!((sum / 400.0).abs() < 4.0 * 1.26 / 8.0 / 20.0, "{name}: mean {}", sum / 400.0);
            let spread = squares / 400.0 * 64.0;
            assert!((1.2..2.0).contains(&spread), "{name}: spread {spread}");
        };
        let at = |x, sample, seed, dimension| PathSampler::new([x, 8], sample, seed).two(dimension);
        unrelated("neighbouring dimensions", &|i, s| [at(i, s, 0, 3)[0], at(i, s, 0, 4)[0]]);
        unrelated("dimensions' second numbers", &|i, s| [at(i, s, 0, 0)[1], at(i, s, 0, 1)[1]]);
        unrelated("first and second across dimensions", &|i, s| [at(i, s, 0, 6)[0], at(i, s, 0, 9)[1]]);
        unrelated("neighbouring pixels", &|i, s| [at(i, s, 0, 3)[0], at(i + 1, s, 0, 3)[0]]);
        unrelated("pixels one below the other", &|i, s| {
            [at(i, s, 0, 3)[1], PathSampler::new([i, 9], s, 0).two(3)[1]]
        });
        unrelated("seeds", &|i, s| [at(i, s, 1, 3)[0], at(i, s, 2, 3)[0]]);
    }

    #[test]
    fn single_samples_are_uniform_over_pixels() {
        // Chi-squared over 8 × 8 cells, 63 degrees of freedom: the 99.99 % point is 114.
        for sample in [0, 1, 2, 3, 17, 1000] {
            let mut cells = [0_u32; 64];
            for i in 0..64_000 {
                let [u, v] = PathSampler::new([i % 400, i / 400], sample, 0).two(2);
                cells[(v * 8.0) as usize * 8 + (u * 8.0) as usize] += 1;
            }
            let chi2: f64 = cells.iter().map(|&n| (f64::from(n) - 1000.0).powi(2) / 1000.0).sum();
            assert!(chi2 < 114.0, "sample {sample}: chi² = {chi2}");
        }
    }

    #[test]
    fn means_are_right_and_a_smooth_integrand_converges_faster_than_by_chance() {
        // ∫∫ e^(u+v) = (e−1)²; the standard deviation of the integrand is 0.80.
        let exact = (std::f64::consts::E - 1.0).powi(2);
        let root_mean_square = |count: u32| {
            let squares = (0..64).map(|pixel| {
                let sum: f64 =
                    points([pixel, 7], 11, count).iter().map(|[u, v]| f64::from(u + v).exp()).sum();
                (sum / f64::from(count) - exact).powi(2)
            });
            (squares.sum::<f64>() / 64.0).sqrt()
        };
        // By chance it is 0.80/√N: 0.1 and 0.0125. Owen's scrambling of a smooth integrand: nearly N^(−3/2).
        assert!(root_mean_square(64) < 0.1 / 8.0, "{}", root_mean_square(64));
        assert!(root_mean_square(4096) < 0.0125 / 60.0, "{}", root_mean_square(4096));
    }

    #[test]
    fn three_dimensions_together_converge_as_well_as_by_chance() {
        // Products of numbers of different dimensions: a mean of 1/8 with a standard deviation of √(1/27 − 1/64) = 0.146.
        let squares = (0..256).map(|pixel| {
            let product = |s| {
                let sampler = PathSampler::new([pixel, 1], s, 3);
                f64::from(sampler.one(0) * sampler.two(1)[1] * sampler.two(2)[0])
            };
            ((0..64).map(product).sum::<f64>() / 64.0 - 0.125).powi(2)
        });
        let error = (squares.sum::<f64>() / 256.0).sqrt();
        assert!(error < 0.146 / 8.0, "{error}");
    }
}
