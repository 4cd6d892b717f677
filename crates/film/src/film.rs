//! The film: sums of samples, pixel by pixel.

use crate::{Band, Features, Image, Keep, Region};
use vitrine_math::Rgb;

/// Sums of samples for the pixels of a region. It only accumulates, a tile at a time: all pixels of a tile have as many samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Film(FilmParts);

/// A film taken apart, as files keep it. All lists of pixels go row by row, those of tiles as [`Film::tiles`] gives them.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmParts {
    /// The part of the picture.
    pub region: Region,
    /// The sum of each pixel's samples.
    pub light: Vec<[f32; 3]>,
    /// Samples of each pixel, by the tile.
    pub counts: Vec<u32>,
    /// The same sums of every other block of samples; empty where the film does not keep them.
    pub half: Vec<[f32; 3]>,
    /// How many samples are in `half`, by the tile; as empty as that.
    pub half_counts: Vec<u32>,
    /// Sums of colours and normals, and the depth of the first block's mean; empty where the film does not keep them.
    pub features: Vec<Features>,
}

impl FilmParts {
    /// Whether the lists have the lengths that the region asks for.
    fn fit(&self) -> bool {
        let (pixels, tiles) = (self.region.pixels(), Film::tile_count(self.region));
        let keeps_half = !self.half.is_empty();
        let half = [self.half.len(), self.half_counts.len()];
        pixels > 0
            && [self.light.len(), self.counts.len()] == [pixels, tiles]
            && half == if keeps_half { [pixels, tiles] } else { [0, 0] }
            && (self.features.is_empty() || keeps_half && self.features.len() == pixels)
            && self.half_counts.iter().zip(&self.counts).all(|(half, all)| half <= all)
    }
}

impl Film {
    /// The side of a tile in pixels.
    pub const TILE: u32 = 32;

    /// A film without a sample, for light alone.
    #[must_use]
    pub fn new(region: Region) -> Self {
        Self::keeping(region, Keep::Light)
    }

    /// A film without a sample that keeps features and what the estimate of noise needs, too.
    #[must_use]
    pub fn with_layers(region: Region) -> Self {
        Self::keeping(region, Keep::Layers)
    }

    /// A film without a sample.
    #[must_use]
    pub fn keeping(region: Region, keep: Keep) -> Self {
        let (pixels, tiles) = (region.pixels(), Self::tile_count(region));
        let only_if = |wanted: bool, length: usize| if wanted { length } else { 0 };
        let halves = keep >= Keep::Halves;
        Self(FilmParts {
            region,
            light: vec![[0.0; 3]; pixels],
            counts: vec![0; tiles],
            half: vec![[0.0; 3]; only_if(halves, pixels)],
            half_counts: vec![0; only_if(halves, tiles)],
            features: vec![Features::default(); only_if(keep == Keep::Layers, pixels)],
        })
    }

    /// Puts a film together; None when the parts do not fit to one another.
    #[must_use]
    pub fn from_parts(parts: FilmParts) -> Option<Self> {
        parts.fit().then_some(Self(parts))
    }

    /// What it consists of.
    #[must_use]
    pub const fn parts(&self) -> &FilmParts {
        &self.0
    }

    /// The part of the picture that it covers.
    #[must_use]
    pub const fn region(&self) -> Region {
        self.0.region
    }

    /// What it keeps beside the light.
    #[must_use]
    pub fn keep(&self) -> Keep {
        match (self.0.half.is_empty(), self.0.features.is_empty()) {
            (true, _) => Keep::Light,
            (false, true) => Keep::Halves,
            (false, false) => Keep::Layers,
        }
    }

    /// How many tiles stand side by side in a region.
    #[must_use]
    pub const fn tiles_across(region: Region) -> usize {
        region.width.div_ceil(Self::TILE) as usize
    }

    /// How many tiles a region has.
    #[must_use]
    pub const fn tile_count(region: Region) -> usize {
        Self::tiles_across(region) * region.height.div_ceil(Self::TILE) as usize
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
        let region = self.0.region;
        let width = region.width as usize;
        let (pixels, across) = (width * Self::TILE as usize, Self::tiles_across(region));
        let parts = &mut self.0;
        let light = parts.light.chunks_mut(pixels);
        let counts = parts.counts.chunks_mut(across);
        // What the film does not keep is an empty piece for each row.
        let mut half = parts.half.chunks_mut(pixels);
        let mut half_counts = parts.half_counts.chunks_mut(across);
        let mut features = parts.features.chunks_mut(pixels);
        light.zip(counts).map(move |(light, counts)| Band {
            width,
            light,
            counts,
            half: half.next().unwrap_or_default(),
            half_counts: half_counts.next().unwrap_or_default(),
            features: features.next().unwrap_or_default(),
        })
    }

    /// How many samples have been added in all.
    #[must_use]
    pub fn samples(&self) -> u64 {
        Self::tiles(self.0.region)
            .zip(&self.0.counts)
            .map(|(t, &count)| t.pixels() as u64 * u64::from(count))
            .sum()
    }

    /// How many samples each pixel of a tile has, tile by tile as [`Film::tiles`] gives them.
    #[must_use]
    pub fn tile_samples(&self) -> &[u32] {
        &self.0.counts
    }

    /// How many samples each pixel has, row by row.
    #[must_use]
    pub fn pixel_samples(&self) -> Vec<u32> {
        let width = self.0.region.width as usize;
        let tile = Self::TILE as usize;
        let row = |counts: &[u32]| (0..width).map(|x| counts[x / tile]).collect::<Vec<_>>();
        let rows = self.0.counts.chunks(Self::tiles_across(self.0.region)).map(row);
        let heights = (0..self.0.region.height as usize).step_by(tile);
        heights
            .zip(rows)
            .flat_map(|(y, row)| row.repeat(tile.min(self.0.region.height as usize - y)))
            .collect()
    }

    /// The mean of each pixel's samples; black where there is none.
    #[must_use]
    pub fn image(&self) -> Image {
        Self(FilmParts {
            half: Vec::new(),
            half_counts: Vec::new(),
            features: Vec::new(),
            light: self.0.light.clone(),
            counts: self.0.counts.clone(),
            region: self.0.region,
        })
        .into_image()
    }

    /// The same in place of the film, without a copy.
    #[must_use]
    pub fn into_image(mut self) -> Image {
        for band in self.bands() {
            for row in band.light.chunks_exact_mut(band.width) {
                for (pixels, &count) in row.chunks_mut(Self::TILE as usize).zip(&*band.counts) {
                    if count > 1 {
                        pixels.as_flattened_mut().iter_mut().for_each(|v| *v /= count as f32);
                    }
                }
            }
        }
        let FilmParts { region, light, .. } = self.0;
        let pixels = light.into_iter().map(Rgb::from).collect();
        Image { size: [region.width, region.height], pixels }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TileSums;

    #[test]
    fn tiles_land_where_they_belong_and_means_are_means() {
        let region = Region { x: 10, y: 20, width: 33, height: 35 };
        let mut film = Film::new(region);
        let tiles: Vec<_> = Film::tiles(region).collect();
        assert_eq!(tiles[3], Region { x: 42, y: 52, width: 1, height: 3 });
        let mut bands: Vec<_> = film.bands().collect();
        assert_eq!((bands.len(), tiles.len()), (2, 4));
        let sums: Vec<_> = (0..32 * 32).map(|i| Rgb::splat(i as f32)).collect();
        bands[0].add_samples(0, TileSums::of_light(&sums), 1);
        bands[0].add_samples(0, TileSums::of_light(&sums), 3);
        bands[1].add_samples(1, TileSums::of_light(&[1.0, 2.0, 3.0].map(Rgb::splat)), 1);
        let image = film.image();
        assert_eq!(image.pixel(5, 2), Rgb::splat(69.0 * 2.0 / 4.0));
        assert_eq!(image.pixel(32, 2), Rgb::BLACK, "no sample there");
        assert_eq!(image.pixel(32, 33), Rgb::splat(2.0));
        assert_eq!(film.samples(), 4 * 32 * 32 + 3);
        let samples = film.pixel_samples();
        assert_eq!(samples.len(), 33 * 35);
        assert_eq!([samples[31], samples[32], samples[33 * 34], samples[33 * 35 - 1]], [4, 0, 0, 1]);
        assert_eq!(film.into_image(), image);
    }

    #[test]
    fn both_halves_get_as_many_samples_in_the_long_run() {
        let mut film = Film::keeping(Region::whole([1, 1]), Keep::Halves);
        let mut halves = Vec::new();
        for count in [1, 1, 2, 4, 8, 16, 16, 16, 16, 16] {
            let sum = [Rgb::splat(count as f32)];
            film.bands().next().unwrap().add_samples(0, TileSums::of_light(&sum), count);
            halves.push((film.parts().half_counts[0], film.parts().counts[0]));
        }
        assert_eq!(halves[..4], [(1, 1), (1, 2), (3, 4), (3, 8)]);
        assert_eq!(halves[5..], [(11, 32), (27, 48), (27, 64), (43, 80), (43, 96)]);
        assert_eq!(film.parts().half, [[43.0; 3]]);
    }

    #[test]
    fn layers_change_nothing_of_the_light() {
        let region = Region::whole([40, 3]);
        let mut films = [Keep::Light, Keep::Halves, Keep::Layers].map(|keep| Film::keeping(region, keep));
        for film in &mut films {
            let mut band = film.bands().next().unwrap();
            for count in [1, 1, 2] {
                let sums: Vec<_> = (0..8 * 3).map(|i| Rgb::new(0.1, 0.3, i as f32) * count as f32).collect();
                band.add_samples(1, TileSums::of_light(&sums), count);
            }
        }
        assert_eq!(films[0].image(), films[1].image());
        assert_eq!(films[0].image(), films[2].image());
        assert_eq!(films.map(|f| f.keep()), [Keep::Light, Keep::Halves, Keep::Layers]);
    }

    #[test]
    fn only_parts_that_fit_make_a_film() {
        let film = Film::with_layers(Region::whole([40, 3]));
        assert_eq!(Film::from_parts(film.parts().clone()), Some(film.clone()));
        let refused = |spoil: fn(&mut FilmParts)| {
            let mut parts = film.parts().clone();
            spoil(&mut parts);
            Film::from_parts(parts).is_none()
        };
        assert!(refused(|p| p.region.width = 41));
        assert!(refused(|p| p.counts.push(0)));
        assert!(refused(|p| p.half.clear()), "features without a half");
        assert!(refused(|p| p.half_counts[0] = 1), "more in the half than in all");
        assert!(refused(|p| p.features.truncate(1)));
        assert!(!refused(|p| p.features.clear()));
    }
}
