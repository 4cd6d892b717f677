//! The render job: threads, order, progress and stopping. It knows nothing of physics.
//!
//! The work is cut into pieces, a tile times a block of samples, which do not depend on the threads. Threads, the caller's
//! among them, take pieces from a counter and add their sums to the film, each tile's blocks in order. So the picture is
//! the same bytes for any number of threads.

use crate::compile::CompiledScene;
use crate::error::RenderError;
use crate::integrators::{TileTask, Workshop};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use vitrine_film::{Band, Film, Region};
use vitrine_math::Rgb;
use vitrine_scene::Settings;

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

    /// Renders on so many threads, the caller's among them (0: all of the machine's), until done or cancelled. The picture does
    /// not depend on the number of threads. `progress` is called on the caller's thread, ten times a second at most and at the
    /// end.
    #[must_use]
    pub fn run(&self, threads: usize, cancel: &Cancel, progress: &mut dyn FnMut(Progress)) -> Rendered {
        let machine = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let threads = if threads == 0 { machine() } else { threads };
        let plan = Plan::new(self.region, self.settings.samples);
        let mut film = Film::new(self.region);
        let merges = film.bands().map(|band| Mutex::new(Merge::new(band, plan.across))).collect();
        let desk = Desk {
            plan: &plan,
            cancel,
            merges,
            next: AtomicUsize::new(0),
            samples: AtomicU64::new(0),
            rays: AtomicU64::new(0),
        };
        let mut report = Report::new(plan.samples_total(), progress);
        std::thread::scope(|scope| {
            for _ in 1..threads.min(plan.pieces()) {
                scope.spawn(|| self.work(&desk, &mut |_| ()));
            }
            self.work(&desk, &mut |samples| report.tell(samples));
        });
        let (samples, rays) = (desk.samples.into_inner(), desk.rays.into_inner());
        drop(desk.merges);
        report.finish(samples);
        Rendered { film, is_complete: samples == plan.samples_total(), rays }
    }

    /// Takes pieces and adds them to the film, until there are none or the job is cancelled. Tells after each how many samples are
    /// finished, those of all threads.
    fn work(&self, desk: &Desk, tell: &mut dyn FnMut(u64)) {
        let plan = desk.plan;
        let mut workshop = Workshop::default();
        while !desk.cancel.is_cancelled() {
            let number = desk.next.fetch_add(1, Ordering::Relaxed);
            if number >= plan.pieces() {
                return;
            }
            let (tile, block) = plan.piece(number);
            let samples = plan.blocks[block].clone();
            let task =
                TileTask { scene: self.scene, settings: &self.settings, tile: plan.tiles[tile], samples };
            let (sums, rays) = workshop.fill(&task);
            let merge = &desk.merges[tile / plan.across];
            // A thread that panics takes the job with it, so what it leaves behind is never seen.
            let mut merge = merge.lock().unwrap_or_else(PoisonError::into_inner);
            let (samples, rays) = merge.add(plan, [tile, block], (sums, rays));
            drop(merge);
            desk.rays.fetch_add(rays, Ordering::Relaxed);
            tell(desk.samples.fetch_add(samples, Ordering::Relaxed) + samples);
        }
    }
}

/// What the threads of a job share.
struct Desk<'a> {
    plan: &'a Plan,
    cancel: &'a Cancel,
    /// Rows of tiles.
    merges: Vec<Mutex<Merge<'a>>>,
    /// The next piece to take.
    next: AtomicUsize,
    /// Samples in the film.
    samples: AtomicU64,
    /// Rays that these took.
    rays: AtomicU64,
}

/// How the work is cut: by the picture alone.
struct Plan {
    /// Row by row.
    tiles: Vec<Region>,
    /// Tiles in a row.
    across: usize,
    blocks: Vec<Range<u32>>,
}

impl Plan {
    fn new(region: Region, samples: u32) -> Self {
        // 1, 1, 2, 4, 8, 16, 16, …: a first picture soon, then ever better ones.
        let mut blocks = Vec::new();
        let mut start = 0;
        while start < samples {
            let length = start.clamp(1, BLOCK).min(samples - start);
            blocks.push(start..start + length);
            start += length;
        }
        Self { tiles: Film::tiles(region).collect(), across: Film::tiles_across(region), blocks }
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

/// Adds each tile's blocks to a row of tiles in order; what comes too early waits.
struct Merge<'a> {
    band: Band<'a>,
    next_block: Vec<usize>,
    waiting: BTreeMap<[usize; 2], (Vec<Rgb>, u64)>,
}

impl<'a> Merge<'a> {
    fn new(band: Band<'a>, tiles: usize) -> Self {
        Self { band, next_block: vec![0; tiles], waiting: BTreeMap::new() }
    }

    /// Takes the sums and the number of rays of a piece. Gives the samples and the rays of what has been added to the film.
    fn add(&mut self, plan: &Plan, [tile, block]: [usize; 2], (sums, rays): (&[Rgb], u64)) -> (u64, u64) {
        if block > self.next_block[tile % plan.across] {
            self.waiting.insert([tile, block], (sums.to_vec(), rays));
            return (0, 0);
        }
        let (mut samples, mut rays) = (self.add_next(plan, tile, sums), rays);
        while let Some((sums, more)) = self.waiting.remove(&[tile, self.next_block[tile % plan.across]]) {
            samples += self.add_next(plan, tile, &sums);
            rays += more;
        }
        (samples, rays)
    }

    /// Adds a tile's next block; gives its samples.
    fn add_next(&mut self, plan: &Plan, tile: usize, sums: &[Rgb]) -> u64 {
        let column = tile % plan.across;
        let next = &mut self.next_block[column];
        let count = plan.blocks[*next].len() as u32;
        *next += 1;
        self.band.add_samples(column, sums, count);
        sums.len() as u64 * u64::from(count)
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
