//! The pixels of a tile in the order of their camera rays, and their sums of light in that order.

use super::wave::NUMBERS;
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column};
use vitrine_film::Region;
use vitrine_math::Rgb;

/// The side of the squares of pixels whose rays go together, so that packets are compact.
const SQUARE: u32 = 4;

/// The order of the pixels of a tile: square by square.
#[derive(Debug, Default)]
pub struct TileOrder {
    size: [u32; 2],
    /// Each pixel's place from the tile's left and top, filled up to whole blocks.
    x: Vec<f32>,
    y: Vec<f32>,
    /// Each pixel's number, row by row.
    numbers: Vec<u32>,
}

impl TileOrder {
    /// Makes it that of a tile of this size.
    pub fn fit(&mut self, tile: &Region) {
        if self.size == [tile.width, tile.height] {
            return;
        }
        self.size = [tile.width, tile.height];
        self.x.clear();
        self.y.clear();
        self.numbers.clear();
        for top in (0..tile.height).step_by(SQUARE as usize) {
            for left in (0..tile.width).step_by(SQUARE as usize) {
                for y in top..(top + SQUARE).min(tile.height) {
                    for x in left..(left + SQUARE).min(tile.width) {
                        self.x.push(x as f32);
                        self.y.push(y as f32);
                        self.numbers.push(y * tile.width + x);
                    }
                }
            }
        }
        let whole = tile.pixels().next_multiple_of(BLOCK);
        self.x.resize(whole, 0.0);
        self.y.resize(whole, 0.0);
    }

    /// Where pixels stand in the tile, from its left and top, in lanes. Beyond the last pixel it means nothing.
    #[inline(always)]
    pub fn lanes<S: Simd>(&self, s: S, first: usize) -> [S::F; 2] {
        [s.load(&self.x[first..]), s.load(&self.y[first..])]
    }

    /// A pixel's number, row by row.
    #[inline(always)]
    pub fn number(&self, pixel: usize) -> usize {
        self.numbers[pixel] as usize
    }

    /// Where a pixel stands in the tile, from its left and top.
    #[inline(always)]
    pub fn place(&self, pixel: usize) -> [u32; 2] {
        [self.x[pixel] as u32, self.y[pixel] as u32]
    }
}

/// The light of a tile's pixels, in the tile's order.
#[derive(Debug, Default)]
pub struct Sums {
    channels: [Vec<f32>; 3],
}

impl Sums {
    /// Makes so many pixels dark.
    pub fn reset(&mut self, pixels: usize) {
        for channel in &mut self.channels {
            channel.clear();
            channel.resize(pixels.next_multiple_of(BLOCK), 0.0);
        }
    }

    /// Adds light to the pixels of the mask's lanes. `pixels` are theirs, lane by lane.
    #[inline(always)]
    pub fn add<S: Simd>(&mut self, s: S, mask: S::M, pixels: &[f32], light: &[S::F; 3]) {
        let bits = s.bits(mask);
        let first = pixels[0];
        let in_a_row = s.eq(s.load(pixels), s.add(s.splat(first), s.load(&NUMBERS)));
        let (from, to) = (first as usize, first as usize + S::LANES);
        if bits & !s.bits(in_a_row) == 0 && to <= self.channels[0].len() {
            for (channel, &light) in self.channels.iter_mut().zip(light) {
                let channel = &mut channel[from..to];
                let sum = s.load(channel);
                s.store(s.select(mask, s.add(sum, light), sum), channel);
            }
            return;
        }
        let mut lanes: [Column; 3] = [[0.0; BLOCK]; 3];
        for (column, &light) in lanes.iter_mut().zip(light) {
            s.store(light, column);
        }
        let mut left = bits;
        while left != 0 {
            let lane = left.trailing_zeros() as usize;
            left &= left - 1;
            let pixel = pixels[lane] as usize;
            for (channel, column) in self.channels.iter_mut().zip(&lanes) {
                channel[pixel] += column[lane];
            }
        }
    }

    /// Puts them into a picture of the tile, row by row.
    pub fn show(&self, order: &TileOrder, picture: &mut Vec<Rgb>) {
        picture.resize(order.numbers.len(), Rgb::BLACK);
        let [r, g, b] = &self.channels;
        for (((&number, &r), &g), &b) in order.numbers.iter().zip(r).zip(g).zip(b) {
            picture[number as usize] = Rgb::new(r, g, b);
        }
    }
}
