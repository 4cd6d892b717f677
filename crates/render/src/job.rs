//! The render job: threads, order, progress and stopping. It knows nothing of physics.
//!
//! The work is cut into pieces, a tile times a block of samples, which do not depend on the threads. Threads take them from a
//! counter; the caller's thread adds their sums to the film, each tile's blocks in order. So the picture is the same bytes
//! for any number of threads.

use crate::compile::CompiledScene;
use crate::error::RenderError;
use crate::integrators::{TileTask, Workshop};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::time::{Duration, Instant};
use vitrine_film::{Film, Region};
use vitrine_math::Rgb;
use vitrine_scene::Settings;

/// The side of a tile in pixels.
const TILE: u32 = 32;
/// The most samples in a block.
const BLOCK: u32 = 16;
/// The least time between two reports of progress.
const REPORT_EVERY: Duration = Duration::from_millis(100);

/// What to render: the settings of a scene, with whatever the caller wants otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderOptions {
    /// The scene's settings.
    pub settings: Settings,
    /// The part of the picture to render; None for all of it.
    pub region: Option<Region>,
}

/// A wish to stop that any thread may utter.
#[derive(Clone, Debug, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Asks the job to stop soon.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it has been asked to.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// How far a job is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Samples that are finished.
    pub samples_done: u64,
    /// All samples of the job.
    pub samples_total: u64,
}

/// What a job gives back, finished or not.
#[derive(Debug)]
pub struct Rendered {
    /// The picture so far.
    pub film: Film,
    /// Whether all samples are in it.
    pub is_complete: bool,
    /// Rays traced: camera, mirror, straight-on, refracted and shadow rays.
    pub rays: u64,
}

/// One picture to be rendered.
#[derive(Debug)]
pub struct RenderJob<'a> {
    scene: &'a CompiledScene,
    settings: Settings,
    region: Region,
}

/// A finished piece of work.
struct Piece {
    tile: usize,
    block: usize,
    sums: Vec<Rgb>,
    rays: u64,
}

impl<'a> RenderJob<'a> {
    /// Prepares a job.
    ///
    /// # Errors
    /// When the picture is too large or the region is not inside it.
    pub fn new(scene: &'a CompiledScene, options: RenderOptions) -> Result<Self, RenderError> {
        let RenderOptions { settings, region } = options;
        let [width, height] = settings.size;
        if u64::from(width) * u64::from(height) > Settings::MAX_PIXELS {
            return Err(RenderError::TooLarge { width, height, limit: Settings::MAX_PIXELS });
        }
        let region = region.unwrap_or(Region::whole(settings.size));
        region.check_inside(settings.size)?;
        Ok(Self { scene, settings, region })
    }

    /// Renders on so many threads (0: all of the machine's) until done or cancelled. The picture does not depend on
    /// the number of threads. `progress` is called on the caller's thread, ten times a second at most and at the end.
    #[must_use]
    pub fn run(&self, threads: usize, cancel: &Cancel, progress: &mut dyn FnMut(Progress)) -> Rendered {
        let machine = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let threads = if threads == 0 { machine() } else { threads };
        let plan = Plan::new(self.region, self.settings.samples);
        let next = AtomicUsize::new(0);
        let mut merge = Merge::new(&plan, self.region);
        let mut report = Report::new(plan.samples_total(), progress);
        std::thread::scope(|scope| {
            let (send, receive) = sync_channel(4 * threads);
            for _ in 0..threads.min(plan.pieces()) {
                let (send, plan, next) = (send.clone(), &plan, &next);
                scope.spawn(move || self.work(plan, next, cancel, &send));
            }
            drop(send);
            for piece in receive {
                merge.add(&plan, piece);
                report.tell(merge.samples);
            }
        });
        report.finish(merge.samples);
        Rendered { is_complete: merge.samples == plan.samples_total(), film: merge.film, rays: merge.rays }
    }

    /// Takes pieces and sends them back finished, until there are none or the job is cancelled.
    fn work(&self, plan: &Plan, next: &AtomicUsize, cancel: &Cancel, send: &SyncSender<Piece>) {
        let mut workshop = Workshop::default();
        while !cancel.is_cancelled() {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= plan.pieces() {
                return;
            }
            let (tile, block) = plan.piece(number);
            let (sums, rays) = workshop.fill(&TileTask {
                scene: self.scene,
                settings: &self.settings,
                tile: plan.tiles[tile],
                samples: plan.blocks[block].clone(),
            });
            if send.send(Piece { tile, block, sums: sums.to_vec(), rays }).is_err() {
                return;
            }
        }
    }
}

/// How the work is cut: by the picture alone.
struct Plan {
    tiles: Vec<Region>,
    blocks: Vec<Range<u32>>,
}

impl Plan {
    fn new(region: Region, samples: u32) -> Self {
        let mut tiles = Vec::new();
        for y in (0..region.height).step_by(TILE as usize) {
            for x in (0..region.width).step_by(TILE as usize) {
                let (width, height) = (TILE.min(region.width - x), TILE.min(region.height - y));
                tiles.push(Region { x: region.x + x, y: region.y + y, width, height });
            }
        }
        // 1, 1, 2, 4, 8, 16, 16, …: a first picture soon, then ever better ones.
        let mut blocks = Vec::new();
        let mut start = 0;
        while start < samples {
            let length = start.clamp(1, BLOCK).min(samples - start);
            blocks.push(start..start + length);
            start += length;
        }
        Self { tiles, blocks }
    }

    fn pieces(&self) -> usize {
        self.tiles.len() * self.blocks.len()
    }

    /// All tiles of a block before the next block.
    fn piece(&self, number: usize) -> (usize, usize) {
        (number % self.tiles.len(), number / self.tiles.len())
    }

    fn samples_total(&self) -> u64 {
        let pixels: u64 = self.tiles.iter().map(|t| t.pixels() as u64).sum();
        pixels * u64::from(self.blocks.last().map_or(0, |b| b.end))
    }
}

/// Adds each tile's blocks in order; what comes too early waits.
struct Merge {
    film: Film,
    samples: u64,
    rays: u64,
    next_block: Vec<usize>,
    waiting: BTreeMap<(usize, usize), Piece>,
}

impl Merge {
    fn new(plan: &Plan, region: Region) -> Self {
        Self {
            film: Film::new(region),
            samples: 0,
            rays: 0,
            next_block: vec![0; plan.tiles.len()],
            waiting: BTreeMap::new(),
        }
    }

    fn add(&mut self, plan: &Plan, piece: Piece) {
        let tile = piece.tile;
        self.waiting.insert((tile, piece.block), piece);
        while let Some(piece) = self.waiting.remove(&(tile, self.next_block[tile])) {
            let count = plan.blocks[piece.block].len() as u32;
            self.film.add_samples(plan.tiles[tile], &piece.sums, count);
            self.samples += piece.sums.len() as u64 * u64::from(count);
            self.rays += piece.rays;
            self.next_block[tile] += 1;
        }
    }
}

/// Tells the caller how far the job is, not too often.
struct Report<'a> {
    total: u64,
    last: Instant,
    progress: &'a mut dyn FnMut(Progress),
}

impl<'a> Report<'a> {
    fn new(total: u64, progress: &'a mut dyn FnMut(Progress)) -> Self {
        Self { total, last: Instant::now(), progress }
    }

    fn tell(&mut self, samples: u64) {
        if self.last.elapsed() >= REPORT_EVERY {
            self.last = Instant::now();
            self.finish(samples);
        }
    }

    fn finish(&mut self, samples: u64) {
        (self.progress)(Progress { samples_done: samples, samples_total: self.total });
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
}
