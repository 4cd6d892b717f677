//! How the work is cut: by the picture alone.

use crate::error::RenderError;
use std::ops::Range;
use vitrine_film::{Film, Keep, Region};

/// The most samples in a block.
const BLOCK: u32 = 16;
/// Before each pixel has so many samples nobody asks how noisy the picture is: what is rare has not shown itself yet.
const LEAST: u32 = 32;
/// So many times the samples must there be before it is asked again, as a fraction: an eighth more samples take 6 % off the
/// noise. All threads wait for the answer, so it should not be asked too often.
const GROWTH: [u32; 2] = [9, 8];

/// The pieces of a picture.
pub struct Plan {
    pub region: Region,
    /// Row by row.
    pub tiles: Vec<Region>,
    /// Tiles in a row.
    pub across: usize,
    pub blocks: Vec<Range<u32>>,
}

impl Plan {
    pub fn new(region: Region, samples: u32) -> Self {
        // 1, 1, 2, 4, 8, 16, 16, …: a first picture soon, then ever better ones.
        let mut blocks = Vec::new();
        let mut start = 0;
        while start < samples {
            let length = start.clamp(1, BLOCK).min(samples - start);
            blocks.push(start..start + length);
            start += length;
        }
        Self { region, tiles: Film::tiles(region).collect(), across: Film::tiles_across(region), blocks }
    }

    /// All tiles of a block before the next block.
    pub fn piece(&self, number: usize) -> (usize, usize) {
        (number % self.tiles.len(), number / self.tiles.len())
    }

    /// After how many blocks all threads come together, the last time when all is done. In between, where the film can tell, it
    /// is asked how noisy the picture is. More samples do not change when that is.
    pub fn stages(&self, keep: Keep) -> Vec<usize> {
        let (mut ends, mut last) = (Vec::new(), 0);
        for (index, block) in self.blocks.iter().enumerate().filter(|_| keep >= Keep::Halves) {
            if block.end >= LEAST && block.end * GROWTH[1] >= last * GROWTH[0] {
                ends.push(index + 1);
                last = block.end;
            }
        }
        if ends.last() != Some(&self.blocks.len()) {
            ends.push(self.blocks.len());
        }
        ends
    }

    /// How many whole blocks each tile of a film has.
    ///
    /// # Errors
    /// When the film is another picture's, or cut into other blocks.
    pub fn begun(&self, film: &Film) -> Result<Vec<usize>, RenderError> {
        if film.region() != self.region {
            return Err(RenderError::OtherFilm);
        }
        let wanted = self.blocks.last().map_or(0, |b| b.end);
        let whole = |&samples: &u32| match samples {
            0 => Ok(0),
            end => {
                let last = self.blocks.iter().position(|b| b.end == end);
                last.map(|last| last + 1).ok_or(RenderError::OtherBlocks { samples, wanted })
            }
        };
        film.tile_samples().iter().map(whole).collect()
    }

    pub fn samples_total(&self) -> u64 {
        self.region.pixels() as u64 * u64::from(self.blocks.last().map_or(0, |b| b.end))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plans_cover_every_pixel_and_sample_once() {
        for (width, height, samples) in [(1, 1, 1), (32, 32, 16), (33, 70, 100), (809, 817, 5)] {
            let region = Region { x: 7, y: 3, width, height };
            let plan = Plan::new(region, samples);
            let pixels: usize = plan.tiles.iter().map(Region::pixels).sum();
            assert_eq!(pixels, region.pixels());
            let all: Vec<u32> = plan.blocks.iter().cloned().flatten().collect();
            assert_eq!(all, (0..samples).collect::<Vec<_>>());
            assert_eq!(plan.samples_total(), u64::from(samples) * region.pixels() as u64);
        }
    }

    #[test]
    fn the_noise_is_asked_for_ever_more_rarely_and_at_the_same_places_for_more_samples() {
        let ends = |samples, keep| {
            let plan = Plan::new(Region::whole([40, 40]), samples);
            plan.stages(keep).iter().map(|end| plan.blocks[end - 1].end).collect::<Vec<_>>()
        };
        assert_eq!(ends(1000, Keep::Light), [1000]);
        assert_eq!(ends(20, Keep::Halves), [20]);
        assert_eq!(ends(200, Keep::Layers), [32, 48, 64, 80, 96, 112, 128, 144, 176, 200]);
        let (few, many) = (ends(400, Keep::Layers), ends(4000, Keep::Layers));
        assert_eq!(few[..few.len() - 1], many[..few.len() - 1]);
        assert!(many.len() < 60, "{many:?}");
    }
}
