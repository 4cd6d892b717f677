//! A row of a film's tiles: what threads add their samples to.

use crate::{Features, Film, TileSums};
use vitrine_math::Rgb;

/// A row of a film's tiles.
#[derive(Debug)]
pub struct Band<'a> {
    pub(crate) width: usize,
    pub(crate) light: &'a mut [[f32; 3]],
    pub(crate) counts: &'a mut [u32],
    pub(crate) half: &'a mut [[f32; 3]],
    pub(crate) half_counts: &'a mut [u32],
    pub(crate) features: &'a mut [Features],
}

impl Band<'_> {
    /// Makes a row of tiles of another film the same as this one, as far as that film keeps it.
    ///
    /// # Panics
    /// When it has another size, or keeps what this one does not.
    pub fn copy_to(&self, other: &mut Band<'_>) {
        other.light.copy_from_slice(self.light);
        other.counts.copy_from_slice(self.counts);
        if !other.half.is_empty() {
            other.half.copy_from_slice(self.half);
            other.half_counts.copy_from_slice(self.half_counts);
        }
        if !other.features.is_empty() {
            other.features.copy_from_slice(self.features);
        }
    }

    /// Adds the sums of `count` samples for each pixel of one of its tiles, row by row; `tile` counts from the left.
    ///
    /// Sums are of floats, so the order of calls for one tile matters to the last bit: the caller keeps it fixed. Which block
    /// goes into the half follows from that order, too: one that finds it no fuller than the rest.
    ///
    /// # Panics
    /// When there is no such tile or the sums have another length.
    pub fn add_samples(&mut self, tile: usize, sums: TileSums<'_>, count: u32) {
        let is_first = self.counts[tile] == 0;
        let left = tile * Film::TILE as usize;
        let width = (self.width - left).min(Film::TILE as usize);
        let place = Place { width: self.width, left, tile_width: width };
        place.add(self.light, sums.light, is_first);
        if let Some(half_count) = self.half_counts.get_mut(tile)
            && *half_count <= self.counts[tile] - *half_count
        {
            place.add(self.half, sums.light, *half_count == 0);
            *half_count += count;
        }
        if !self.features.is_empty() && !sums.features.is_empty() {
            place.add_features(self.features, sums.features, is_first.then_some(count));
        }
        self.counts[tile] += count;
    }
}

/// Where a tile lies in a row of tiles.
struct Place {
    /// Pixels in the row.
    width: usize,
    /// Pixels to the left of the tile.
    left: usize,
    /// Pixels in a row of the tile.
    tile_width: usize,
}

impl Place {
    /// The rows of the tile in the band, each with its piece of the sums.
    fn rows<'b, T, S>(&self, to: &'b mut [T], sums: &'b [S]) -> impl Iterator<Item = (&'b mut [T], &'b [S])> {
        assert_eq!(sums.len() * self.width, to.len() * self.tile_width, "one sum a pixel");
        let columns = self.left..self.left + self.tile_width;
        let rows = to.chunks_exact_mut(self.width).zip(sums.chunks_exact(self.tile_width));
        rows.map(move |(row, sums)| (&mut row[columns.clone()], sums))
    }

    fn add(&self, to: &mut [[f32; 3]], sums: &[Rgb], is_first: bool) {
        for (row, sums) in self.rows(to, sums) {
            for (to, sum) in row.iter_mut().zip(sums) {
                // New memory is written at once: to read it first costs another page fault.
                *to = if is_first { *sum } else { Rgb::from(*to) + *sum }.to_array();
            }
        }
    }

    /// `first` is the number of samples when they are the tile's first.
    fn add_features(&self, to: &mut [Features], sums: &[Features], first: Option<u32>) {
        for (row, sums) in self.rows(to, sums) {
            for (to, sum) in row.iter_mut().zip(sums) {
                match first {
                    Some(count) => *to = Features { depth: sum.depth / count as f32, ..*sum },
                    None => to.add_blended(sum),
                }
            }
        }
    }
}
