//! The render job: threads, order, progress and stopping. It knows nothing of physics.
//!
//! The work is cut into pieces, a tile times a block of samples, which do not depend on the threads. Threads, the caller's
//! among them, take pieces from a counter and add their sums to the film, each tile's blocks in order. So the picture is
//! the same bytes for any number of threads, and a film says itself where a job that was stopped has to go on.

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

    /// What there is before the first sample: the place where a job begins.
    #[must_use]
    pub fn nothing_yet(&self) -> Rendered {
        Rendered { film: Film::new(self.region), is_complete: false, rays: 0 }
    }

    /// Renders on so many threads, the caller's among them (0: all of the machine's), until done or cancelled. The picture does
    /// not depend on the number of threads. `progress` is called on the caller's thread, ten times a second at most and at the
    /// end.
    #[must_use]
    pub fn run(&self, threads: usize, cancel: &Cancel, progress: &mut dyn FnMut(Progress)) -> Rendered {
        let plan = Plan::new(self.region, self.settings.samples);
        let begun = vec![0; plan.tiles.len()];
        self.go_on(&Begun { plan, blocks: begun }, self.nothing_yet(), (threads, cancel), &mut |glance| {
            progress(glance.progress());
        })
    }

    /// Goes on where this job, or one of the same scene and settings, was stopped. What comes out at last is the same bytes as
    /// if it had never been, however often it was stopped and whatever the number of threads.
    ///
    /// `watch` is called as `progress` is by [`RenderJob::run`] and may have a look at the film.
    ///
    /// # Errors
    /// When the film is none that this job can have left.
    pub fn resume(
        &self,
        so_far: Rendered,
        threads: usize,
        cancel: &Cancel,
        watch: &mut dyn FnMut(&Glance),
    ) -> Result<Rendered, RenderError> {
        let plan = Plan::new(self.region, self.settings.samples);
        let blocks = plan.begun(&so_far.film).ok_or(RenderError::OtherFilm)?;
        Ok(self.go_on(&Begun { plan, blocks }, so_far, (threads, cancel), watch))
    }

    fn go_on(
        &self,
        begun: &Begun,
        so_far: Rendered,
        (threads, cancel): (usize, &Cancel),
        watch: &mut dyn FnMut(&Glance),
    ) -> Rendered {
        let machine = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let threads = if threads == 0 { machine() } else { threads };
        let plan = &begun.plan;
        let Rendered { mut film, rays, .. } = so_far;
        let done = film.samples();
        let rows = begun.blocks.chunks(plan.across);
        let merges = film.bands().zip(rows).map(|(band, row)| Mutex::new(Merge::new(band, row))).collect();
        let desk = Desk {
            begun,
            cancel,
            merges,
            next: AtomicUsize::new(begun.first_piece()),
            samples: AtomicU64::new(done),
            rays: AtomicU64::new(rays),
        };
        let mut report = Report { last: Instant::now(), watch };
        std::thread::scope(|scope| {
            for _ in 1..threads.min(plan.pieces()) {
                scope.spawn(|| self.work(&desk, &mut || ()));
            }
            self.work(&desk, &mut || report.tell(&desk));
        });
        report.finish(&desk);
        let (samples, rays) = (desk.samples.into_inner(), desk.rays.into_inner());
        drop(desk.merges);
        Rendered { film, is_complete: samples == plan.samples_total(), rays }
    }

    /// Takes pieces and adds them to the film, until there are none or the job is cancelled. Tells after each that it is done.
    fn work(&self, desk: &Desk, tell: &mut dyn FnMut()) {
        let plan = &desk.begun.plan;
        let mut workshop = Workshop::default();
        while !desk.cancel.is_cancelled() {
            let number = desk.next.fetch_add(1, Ordering::Relaxed);
            if number >= plan.pieces() {
                return;
            }
            let (tile, block) = plan.piece(number);
            if block < desk.begun.blocks[tile] {
                continue;
            }
            let samples = plan.blocks[block].clone();
            let task =
                TileTask { scene: self.scene, settings: &self.settings, tile: plan.tiles[tile], samples };
            let Some((sums, rays)) = workshop.fill(&task, desk.cancel) else { return };
            let merge = &desk.merges[tile / plan.across];
            // A thread that panics takes the job with it, so what it leaves behind is never seen.
            let mut merge = merge.lock().unwrap_or_else(PoisonError::into_inner);
            let (samples, rays) = merge.add(plan, [tile, block], (sums, rays));
            drop(merge);
            desk.rays.fetch_add(rays, Ordering::Relaxed);
            desk.samples.fetch_add(samples, Ordering::Relaxed);
            tell();
        }
    }
}

/// A look at a job while it runs.
pub struct Glance<'a, 'f> {
    desk: &'a Desk<'f>,
}

impl Glance<'_, '_> {
    /// How far the job is.
    #[must_use]
    pub fn progress(&self) -> Progress {
        Progress {
            samples_done: self.desk.samples.load(Ordering::Relaxed),
            samples_total: self.desk.begun.plan.samples_total(),
        }
    }

    /// A copy of the film so far, each tile with whole blocks of samples: the job could go on from it. Threads wait for
    /// no longer than copying their row of tiles takes.
    #[must_use]
    pub fn film(&self) -> Film {
        let mut film = Film::new(self.desk.begun.plan.region);
        for (merge, mut copy) in self.desk.merges.iter().zip(film.bands()) {
            merge.lock().unwrap_or_else(PoisonError::into_inner).band.copy_to(&mut copy);
        }
        film
    }
}

/// What the threads of a job share.
struct Desk<'a> {
    begun: &'a Begun,
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

/// The work, and how much of it was done before.
struct Begun {
    plan: Plan,
    /// How many blocks of each tile are in the film already.
    blocks: Vec<usize>,
}

impl Begun {
    /// No piece before it is left to do.
    fn first_piece(&self) -> usize {
        self.blocks.iter().min().copied().unwrap_or(0) * self.plan.tiles.len()
    }
}

/// How the work is cut: by the picture alone.
struct Plan {
    region: Region,
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
        Self { region, tiles: Film::tiles(region).collect(), across: Film::tiles_across(region), blocks }
    }

    fn pieces(&self) -> usize {
        self.tiles.len() * self.blocks.len()
    }

    /// All tiles of a block before the next block.
    fn piece(&self, number: usize) -> (usize, usize) {
        (number % self.tiles.len(), number / self.tiles.len())
    }

    /// How many whole blocks each tile of a film has; None when the film is another picture's.
    fn begun(&self, film: &Film) -> Option<Vec<usize>> {
        let whole = |samples: &u32| match samples {
            0 => Some(0),
            end => self.blocks.iter().position(|b| b.end == *end).map(|last| last + 1),
        };
        let is_same = film.region() == self.region;
        is_same.then(|| film.tile_samples().iter().map(whole).collect()).flatten()
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
    fn new(band: Band<'a>, blocks: &[usize]) -> Self {
        Self { band, next_block: blocks.to_vec(), waiting: BTreeMap::new() }
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
    last: Instant,
    watch: &'a mut dyn FnMut(&Glance),
}

impl Report<'_> {
    fn tell(&mut self, desk: &Desk) {
        if self.last.elapsed() >= REPORT_EVERY {
            self.finish(desk);
            // What the caller does with it does not count.
            self.last = Instant::now();
        }
    }

    fn finish(&mut self, desk: &Desk) {
        (self.watch)(&Glance { desk });
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
