//! Adds each tile's blocks to a row of tiles in order; what comes too early waits.

use super::plan::Plan;
use crate::integrators::Filled;
use std::collections::BTreeMap;
use vitrine_film::{Band, Features, TileSums};
use vitrine_math::Rgb;

/// A row of tiles and what waits for its turn.
pub struct Merge<'a> {
    pub band: Band<'a>,
    /// The rays and the bad samples of what has been added.
    pub counts: [u64; 2],
    next_block: Vec<usize>,
    waiting: BTreeMap<[usize; 2], Waiting>,
}

/// The sums of a block that came too early.
struct Waiting {
    light: Vec<Rgb>,
    features: Vec<Features>,
    counts: [u64; 2],
}

impl Waiting {
    fn new(filled: &Filled) -> Self {
        let TileSums { light, features } = filled.sums;
        Self { light: light.to_vec(), features: features.to_vec(), counts: [filled.rays, filled.bad] }
    }

    fn filled(&self) -> Filled<'_> {
        let sums = TileSums { light: &self.light, features: &self.features };
        Filled { sums, rays: self.counts[0], bad: self.counts[1] }
    }
}

impl<'a> Merge<'a> {
    /// A row of tiles that has so many blocks of each.
    pub fn new(band: Band<'a>, blocks: &[usize]) -> Self {
        Self { band, counts: [0; 2], next_block: blocks.to_vec(), waiting: BTreeMap::new() }
    }

    /// Whether each of its tiles has all blocks before this one.
    pub fn has_all_before(&self, end: usize) -> bool {
        self.next_block.iter().all(|next| *next >= end)
    }

    /// Takes a piece. Gives the number of samples that have been added to the film.
    pub fn add(&mut self, plan: &Plan, [tile, block]: [usize; 2], filled: &Filled) -> u64 {
        if block > self.next_block[tile % plan.across] {
            self.waiting.insert([tile, block], Waiting::new(filled));
            return 0;
        }
        let mut samples = self.add_next(plan, tile, filled);
        while let Some(next) = self.waiting.remove(&[tile, self.next_block[tile % plan.across]]) {
            samples += self.add_next(plan, tile, &next.filled());
        }
        samples
    }

    /// Adds a tile's next block; gives its samples.
    fn add_next(&mut self, plan: &Plan, tile: usize, filled: &Filled) -> u64 {
        let column = tile % plan.across;
        let next = &mut self.next_block[column];
        let count = plan.blocks[*next].len() as u32;
        *next += 1;
        self.band.add_samples(column, filled.sums, count);
        let [rays, bad] = self.counts;
        self.counts = [rays + filled.rays, bad + filled.bad];
        filled.sums.light.len() as u64 * u64::from(count)
    }
}
