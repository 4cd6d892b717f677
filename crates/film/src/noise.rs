//! How noisy a picture still is, told from two independent halves of its samples.
//!
//! Of each pixel the film knows the mean m of all n samples and the means a, b of two halves of them, n_a and n_b. If samples
//! have the variance σ², then Var(a − b) = σ²·n/(n_a·n_b) and Var(m) = σ²/n, so (a − b)²·n_a·n_b/n² has the expected value
//! Var(m). Stratified samples spread more evenly over all than over the halves; then it is too large rather than too small.
//!
//! Compare H. Dammertz, J. Hanika, A. Keller, H. Lensch, "A Hierarchical Automatic Stopping Condition for Monte Carlo Global
//! Illumination", WSCG 2010, who tell the error from two such halves as well.

use crate::{Film, Region};

/// What is darker than this share of a picture's typical light counts as that bright: nobody sees relative noise in black.
const DARKEST: f64 = 0.05;

/// How noisy a picture still is.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// The root mean square over all pixels of their relative errors: 0.02 means about 2 % of each pixel's light. What stands
    /// out alone (a pixel that one lucky path made far too bright) counts about 1, however bright it is.
    pub relative_error: f32,
    /// The same for each tile, as [`Film::tiles`] gives them.
    pub tiles: Vec<f32>,
}

impl Film {
    /// How noisy it is; None unless it keeps halves and each tile has samples in both.
    #[must_use]
    pub fn noise(&self) -> Option<Noise> {
        let parts = self.parts();
        let is_ready = |(&half, &all): (&u32, &u32)| half > 0 && half < all;
        if parts.half_counts.is_empty() || !parts.half_counts.iter().zip(&parts.counts).all(is_ready) {
            return None;
        }
        // f64: sums over millions of pixels.
        let floor = DARKEST * self.typical_light();
        let least = (3.0 * floor * floor).max(f64::from(f32::MIN_POSITIVE));
        let (mut sum, mut tiles) = (0.0, Vec::with_capacity(parts.counts.len()));
        for (index, tile) in Self::tiles(parts.region).enumerate() {
            let squares = self.squared_errors(index, tile, least);
            tiles.push((squares / tile.pixels() as f64).sqrt() as f32);
            sum += squares;
        }
        let relative_error = (sum / parts.region.pixels() as f64).sqrt() as f32;
        Some(Noise { relative_error, tiles })
    }

    /// How bright a pixel of the picture is: the square of the mean square root, so that a few lamps hardly count.
    fn typical_light(&self) -> f64 {
        let mut sum = 0.0;
        for (tile, &count) in Self::tiles(self.region()).zip(self.tile_samples()) {
            for place in self.places(tile) {
                let [r, g, b] = self.parts().light[place];
                sum += f64::from(((r + g + b) / (3.0 * count as f32)).max(0.0).sqrt());
            }
        }
        let root = sum / self.region().pixels() as f64;
        root * root
    }

    /// The sum of the squares of a tile's relative errors, each |a − b|²·n_a·n_b/n² / (|m|² + least) over the three channels.
    fn squared_errors(&self, index: usize, tile: Region, least: f64) -> f64 {
        let parts = self.parts();
        let (all, half) = (f64::from(parts.counts[index]), f64::from(parts.half_counts[index]));
        let rest = all - half;
        let share = half * rest / (all * all);
        let mut sum = 0.0;
        for place in self.places(tile) {
            let (mut difference, mut light) = (0.0, 0.0);
            for (l, h) in parts.light[place].into_iter().zip(parts.half[place]) {
                let (l, h) = (f64::from(l), f64::from(h));
                let d = h / half - (l - h) / rest;
                difference += d * d;
                light += (l / all) * (l / all);
            }
            sum += share * difference / (light + least);
        }
        sum
    }

    /// Where the pixels of a tile stand in the lists.
    fn places(&self, tile: Region) -> impl Iterator<Item = usize> {
        let region = self.region();
        let (x, y) = ((tile.x - region.x) as usize, (tile.y - region.y) as usize);
        let (stride, width) = (region.width as usize, tile.width as usize);
        (y..y + tile.height as usize).flat_map(move |y| y * stride + x..y * stride + x + width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Keep, TileSums};
    use vitrine_math::{Rgb, hash};

    /// A picture whose samples are even chances between 0 and 2·`mean`: the relative variance of one is 1/3.
    fn noisy(size: [u32; 2], samples: u32, mean: impl Fn(usize) -> f32) -> Film {
        let region = Region::whole(size);
        let mut film = Film::keeping(region, Keep::Halves);
        let tiles: Vec<_> = Film::tiles(region).collect();
        let (mut done, mut count) = (0, 1);
        while done < samples {
            let across = Film::tiles_across(region);
            for (row, mut band) in film.bands().enumerate() {
                for column in 0..across {
                    let tile = row * across + column;
                    let sum = |pixel: u32| {
                        let chance = |sample: u32| {
                            hash::unit(hash::join(hash::join(hash::mix(tile as u32), pixel), sample))
                        };
                        let light: f32 = (done..done + count).map(chance).sum();
                        Rgb::splat(2.0 * mean(tile) * light)
                    };
                    let sums: Vec<_> = (0..tiles[tile].pixels() as u32).map(sum).collect();
                    band.add_samples(column, TileSums::of_light(&sums), count);
                }
            }
            done += count;
            count = done.min(16);
        }
        film
    }

    #[test]
    fn the_estimate_is_the_error_of_the_mean() {
        for samples in [16, 32, 64, 256] {
            let noise = noisy([96, 70], samples, |_| 0.4).noise().unwrap();
            let expected = (1.0 / 3.0 / samples as f32).sqrt();
            let ratio = noise.relative_error / expected;
            // 6720 pixels: the estimate's own relative error is about 1/√(2·6720) = 0.9 %. That the mean is noisy itself raises it
            // by half of 3 times its relative variance: 3 % for 16 samples.
            assert!((0.97..1.06).contains(&ratio), "{samples} samples: {ratio}");
            assert_eq!(noise.tiles.len(), 9);
            assert!(noise.tiles.iter().all(|t| (0.7..1.4).contains(&(t / expected))), "{noise:?}");
        }
    }

    #[test]
    fn it_does_not_depend_on_how_bright_the_picture_is() {
        let [dim, bright] = [1e-6, 1e6].map(|mean| noisy([64, 32], 32, |_| mean).noise().unwrap());
        assert!((dim.relative_error / bright.relative_error - 1.0).abs() < 1e-3, "{dim:?} {bright:?}");
    }

    #[test]
    fn noise_in_what_is_nearly_black_counts_little() {
        let noise = noisy([64, 32], 32, |tile| if tile == 0 { 1.0 } else { 1e-4 }).noise().unwrap();
        assert!(noise.tiles[1] < 0.05 * noise.tiles[0], "{noise:?}");
    }

    #[test]
    fn a_firefly_counts_as_one_pixel() {
        let mut film = noisy([64, 64], 64, |_| 1.0);
        let before = film.noise().unwrap().relative_error;
        let mut parts = film.parts().clone();
        for sums in [&mut parts.light, &mut parts.half] {
            sums[1000] = [1e9; 3];
        }
        film = Film::from_parts(parts).unwrap();
        let after = film.noise().unwrap().relative_error;
        // About 1 of 4096 pixels, in quadrature.
        let added = (after * after - before * before).sqrt();
        assert!((0.5..2.0).contains(&(added * 64.0)), "{before} {after}");
    }

    #[test]
    fn as_many_samples_as_a_damaged_file_may_claim_overflow_nothing() {
        let mut parts = noisy([8, 8], 4, |_| 1.0).parts().clone();
        (parts.counts[0], parts.half_counts[0]) = (u32::MAX, u32::MAX / 2);
        let noise = Film::from_parts(parts).unwrap().noise().unwrap();
        assert!(noise.relative_error.is_finite());
    }

    #[test]
    fn black_is_not_noisy_and_without_halves_nothing_is_known() {
        let black = noisy([33, 2], 4, |_| 0.0);
        assert_eq!(black.noise().unwrap().relative_error, 0.0);
        assert_eq!(noisy([33, 2], 1, |_| 1.0).noise(), None, "one half alone");
        assert_eq!(Film::new(Region::whole([4, 4])).noise(), None);
    }
}
