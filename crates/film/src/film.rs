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

/// Sums of samples for the pixels of a region. It only accumulates.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    region: Region,
    sums: Vec<Rgb>,
    counts: Vec<u32>,
}

impl Film {
    /// A film without a sample.
    #[must_use]
    pub fn new(region: Region) -> Self {
        Self { region, sums: vec![Rgb::BLACK; region.pixels()], counts: vec![0; region.pixels()] }
    }

    /// The part of the picture that it covers.
    #[must_use]
    pub const fn region(&self) -> Region {
        self.region
    }

    /// Adds the sums of `count` samples for each pixel of a part of the region, row by row. `part` is in the picture's
    /// pixels.
    ///
    /// Sums are of floats, so the order of calls for one pixel matters to the last bit: the caller keeps it fixed.
    ///
    /// # Panics
    /// When `part` is not inside the region or `sums` has another length.
    pub fn add_samples(&mut self, part: Region, sums: &[Rgb], count: u32) {
        assert_eq!(sums.len(), part.pixels(), "one sum a pixel");
        let (left, top) = (part.x - self.region.x, part.y - self.region.y);
        assert!(left + part.width <= self.region.width && top + part.height <= self.region.height);
        for (row, sums) in sums.chunks_exact(part.width as usize).enumerate() {
            let start = (top as usize + row) * self.region.width as usize + left as usize;
            for (i, sum) in sums.iter().enumerate() {
                self.sums[start + i] += *sum;
                self.counts[start + i] += count;
            }
        }
    }

    /// How many samples have been added in all.
    #[must_use]
    pub fn samples(&self) -> u64 {
        self.counts.iter().map(|&c| u64::from(c)).sum()
    }

    /// The mean of each pixel's samples; black where there is none.
    #[must_use]
    pub fn image(&self) -> Image {
        let mean = |(sum, count): (&Rgb, &u32)| {
            if *count == 0 { Rgb::BLACK } else { *sum / *count as f32 }
        };
        let pixels = self.sums.iter().zip(&self.counts).map(mean).collect();
        Image { size: [self.region.width, self.region.height], pixels }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_land_where_they_belong_and_means_are_means() {
        let region = Region { x: 10, y: 20, width: 4, height: 3 };
        let mut film = Film::new(region);
        let part = Region { x: 12, y: 21, width: 2, height: 1 };
        film.add_samples(part, &[Rgb::splat(1.0), Rgb::splat(4.0)], 1);
        film.add_samples(part, &[Rgb::splat(3.0), Rgb::splat(4.0)], 1);
        let image = film.image();
        assert_eq!(image.pixel(2, 1), Rgb::splat(2.0));
        assert_eq!(image.pixel(3, 1), Rgb::splat(4.0));
        assert_eq!(image.pixel(0, 0), Rgb::BLACK);
        assert_eq!(film.samples(), 4);
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
