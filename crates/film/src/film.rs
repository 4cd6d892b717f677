//! The film: sums of samples, pixel by pixel.

use crate::Image;
use vitrine_math::Rgb;

/// A part of a picture, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Pixels from the left.
    pub x: u32,
    /// Pixels from the top.
    pub y: u32,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
}

/// A region that is no part of its picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the region {},{},{},{} is empty or not inside the picture of {}×{} pixels",
    region.x, region.y, region.width, region.height, size[0], size[1]
)]
pub struct RegionError {
    /// The region.
    pub region: Region,
    /// The picture's width and height.
    pub size: [u32; 2],
}

impl Region {
    /// All of a picture.
    #[must_use]
    pub const fn whole(size: [u32; 2]) -> Self {
        Self { x: 0, y: 0, width: size[0], height: size[1] }
    }

    /// How many pixels it holds.
    #[must_use]
    pub const fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Checks that it is a part of a picture of that size.
    ///
    /// # Errors
    /// When it is empty or reaches beyond the picture.
    pub fn check_inside(&self, size: [u32; 2]) -> Result<(), RegionError> {
        let fits = |from: u32, length: u32, all: u32| {
            length > 0 && from.checked_add(length).is_some_and(|end| end <= all)
        };
        if fits(self.x, self.width, size[0]) && fits(self.y, self.height, size[1]) {
            Ok(())
        } else {
            Err(RegionError { region: *self, size })
        }
    }
}

/// Sums of samples for the pixels of a region. It only accumulates, a tile at a time: all pixels of a tile have as many samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    region: Region,
    /// Row by row.
    sums: Vec<[f32; 3]>,
    /// Samples of each pixel, by the tile.
    counts: Vec<u32>,
}

impl Film {
    /// The side of a tile in pixels.
    pub const TILE: u32 = 32;

    /// A film without a sample.
    #[must_use]
    pub fn new(region: Region) -> Self {
        let tiles = Self::tiles_across(region) * region.height.div_ceil(Self::TILE) as usize;
        Self { region, sums: vec![[0.0; 3]; region.pixels()], counts: vec![0; tiles] }
    }

    /// The part of the picture that it covers.
    #[must_use]
    pub const fn region(&self) -> Region {
        self.region
    }

    /// How many tiles stand side by side in a region.
    #[must_use]
    pub const fn tiles_across(region: Region) -> usize {
        region.width.div_ceil(Self::TILE) as usize
    }

    /// The tiles of a region, row by row from the top, each row from the left. In the picture's pixels.
    pub fn tiles(region: Region) -> impl Iterator<Item = Region> {
        let part = |from: u32, length: u32| Self::TILE.min(length - from);
        let starts = |length: u32| (0..length).step_by(Self::TILE as usize);
        let at = move |x: u32, y: u32| Region {
            x: region.x + x,
            y: region.y + y,
            width: part(x, region.width),
            height: part(y, region.height),
        };
        starts(region.height).flat_map(move |y| starts(region.width).map(move |x| at(x, y)))
    }

    /// The film cut into rows of tiles, for threads to fill at once.
    pub fn bands(&mut self) -> impl Iterator<Item = Band<'_>> {
        let width = self.region.width as usize;
        let sums = self.sums.chunks_mut(width * Self::TILE as usize);
        let counts = self.counts.chunks_mut(Self::tiles_across(self.region));
        sums.zip(counts).map(move |(sums, counts)| Band { width, sums, counts })
    }

    /// How many samples have been added in all.
    #[must_use]
    pub fn samples(&self) -> u64 {
        Self::tiles(self.region)
            .zip(&self.counts)
            .map(|(t, &count)| t.pixels() as u64 * u64::from(count))
            .sum()
    }

    /// How many samples each pixel of a tile has, tile by tile as [`Film::tiles`] gives them.
    #[must_use]
    pub fn tile_samples(&self) -> &[u32] {
        &self.counts
    }

    /// The mean of each pixel's samples; black where there is none.
    #[must_use]
    pub fn image(&self) -> Image {
        self.clone().into_image()
    }

    /// The same in place of the film, without a copy.
    #[must_use]
    pub fn into_image(mut self) -> Image {
        for band in self.bands() {
            for row in band.sums.chunks_exact_mut(band.width) {
                for (pixels, &count) in row.chunks_mut(Self::TILE as usize).zip(&*band.counts) {
                    if count > 1 {
                        pixels.as_flattened_mut().iter_mut().for_each(|v| *v /= count as f32);
                    }
                }
            }
        }
        let pixels = self.sums.into_iter().map(Rgb::from).collect();
        Image { size: [self.region.width, self.region.height], pixels }
    }
}

/// A row of a film's tiles.
#[derive(Debug)]
pub struct Band<'a> {
    width: usize,
    sums: &'a mut [[f32; 3]],
    counts: &'a mut [u32],
}

impl Band<'_> {
    /// Makes a row of tiles of another film the same as this one.
    ///
    /// # Panics
    /// When it has another size.
    pub fn copy_to(&self, other: &mut Band<'_>) {
        other.sums.copy_from_slice(self.sums);
        other.counts.copy_from_slice(self.counts);
    }

    /// Adds the sums of `count` samples for each pixel of one of its tiles, row by row; `tile` counts from the left.
    ///
    /// Sums are of floats, so the order of calls for one tile matters to the last bit: the caller keeps it fixed.
    ///
    /// # Panics
    /// When there is no such tile or `sums` has another length.
    pub fn add_samples(&mut self, tile: usize, sums: &[Rgb], count: u32) {
        let is_first = self.counts[tile] == 0;
        let left = tile * Film::TILE as usize;
        let width = (self.width - left).min(Film::TILE as usize);
        assert_eq!(sums.len() * self.width, self.sums.len() * width, "one sum a pixel");
        for (row, sums) in self.sums.chunks_exact_mut(self.width).zip(sums.chunks_exact(width)) {
            for (to, sum) in row[left..left + width].iter_mut().zip(sums) {
                // New memory is written at once: to read it first costs another page fault.
                *to = if is_first { *sum } else { Rgb::from(*to) + *sum }.to_array();
            }
        }
        self.counts[tile] += count;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_land_where_they_belong_and_means_are_means() {
        let region = Region { x: 10, y: 20, width: 33, height: 35 };
        let mut film = Film::new(region);
        let tiles: Vec<_> = Film::tiles(region).collect();
        assert_eq!(tiles[3], Region { x: 42, y: 52, width: 1, height: 3 });
        let mut bands: Vec<_> = film.bands().collect();
        assert_eq!((bands.len(), tiles.len()), (2, 4));
        let sums: Vec<_> = (0..32 * 32).map(|i| Rgb::splat(i as f32)).collect();
        bands[0].add_samples(0, &sums, 1);
        bands[0].add_samples(0, &sums, 3);
        bands[1].add_samples(1, &[1.0, 2.0, 3.0].map(Rgb::splat), 1);
        let image = film.image();
        assert_eq!(image.pixel(5, 2), Rgb::splat(69.0 * 2.0 / 4.0));
        assert_eq!(image.pixel(32, 2), Rgb::BLACK, "no sample there");
        assert_eq!(image.pixel(32, 33), Rgb::splat(2.0));
        assert_eq!(film.samples(), 4 * 32 * 32 + 3);
        assert_eq!(film.into_image(), image);
    }

    #[test]
    fn regions_must_lie_inside() {
        let size = [100, 50];
        assert!(Region::whole(size).check_inside(size).is_ok());
        for bad in [[0, 0, 0, 5], [99, 0, 2, 1], [0, 50, 1, 1], [u32::MAX, 0, 2, 2]] {
            let [x, y, width, height] = bad;
            assert!(Region { x, y, width, height }.check_inside(size).is_err(), "{bad:?}");
        }
    }
}
