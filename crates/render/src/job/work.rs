//! The threads at work on a stage of a job.

use super::glance::Report;
use super::merge::Merge;
use super::plan::Plan;
use super::{Cancel, Clock, RenderJob, Rendered};
use crate::integrators::{TileTask, Workshop};
use crate::threads;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use vitrine_film::Keep;

/// The threads' tools, and who may send them home.
pub struct Crew<'c> {
    /// One for each thread, at least one.
    workshops: Vec<Workshop>,
    cancel: &'c Cancel,
}

impl<'c> Crew<'c> {
    /// So many threads; 0: as many as the machine has.
    pub fn new(threads: usize, cancel: &'c Cancel) -> Self {
        let threads = threads::meant_by(threads);
        Self { workshops: (0..threads).map(|_| Workshop::default()).collect(), cancel }
    }
}

/// How far a stage came.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reached {
    /// To its end.
    Whole,
    /// It was cancelled.
    Cancelled,
    /// Its time was over.
    Time,
}

/// A part of the plan after which all threads come together.
pub struct Stage<'s> {
    pub job: &'s RenderJob<'s>,
    pub plan: &'s Plan,
    /// How many blocks of each tile are in the film already.
    pub blocks: &'s [usize],
    /// How many each tile has in the end.
    pub end: usize,
    pub clock: Clock,
}

impl Stage<'_> {
    /// Renders what is missing.
    pub fn run(&self, so_far: &mut Rendered, crew: &mut Crew, report: &mut Report) -> Reached {
        let Crew { workshops, cancel } = crew;
        let desk = Desk::new(self.plan, self.blocks, self.clock, so_far);
        let pieces = (self.end * self.plan.tiles.len()).saturating_sub(desk.next.load(Ordering::Relaxed));
        let helpers = pieces.saturating_sub(1);
        std::thread::scope(|scope| {
            let (desk, cancel) = (&desk, &**cancel);
            if let Some((mine, others)) = workshops.split_first_mut() {
                for workshop in others.iter_mut().take(helpers) {
                    scope.spawn(move || self.work(desk, (workshop, cancel), &mut || ()));
                }
                self.work(desk, (mine, cancel), &mut || report.tell(desk));
            }
        });
        let reached = match desk.has_all_before(self.end) {
            true => Reached::Whole,
            false if cancel.is_cancelled() => Reached::Cancelled,
            false => Reached::Time,
        };
        let counts = desk.counts();
        [so_far.rays, so_far.bad_samples] = counts;
        reached
    }

    /// Takes pieces and adds them to the film, until there are none or the job is to stop. Tells after each that it is done.
    fn work(&self, desk: &Desk, (workshop, cancel): (&mut Workshop, &Cancel), tell: &mut dyn FnMut()) {
        let Plan { tiles, across, .. } = self.plan;
        while !cancel.is_cancelled() && !desk.is_time_over.load(Ordering::Relaxed) {
            let number = desk.next.fetch_add(1, Ordering::Relaxed);
            if number >= self.end * tiles.len() {
                return;
            }
            // Every pixel gets its first sample, however short the time.
            if number >= tiles.len() && self.clock.is_over() {
                desk.is_time_over.store(true, Ordering::Relaxed);
                return;
            }
            let (tile, block) = self.plan.piece(number);
            if block < self.blocks[tile] {
                continue;
            }
            let samples = self.plan.blocks[block].clone();
            let RenderJob { scene, settings, .. } = self.job;
            let task = TileTask { scene, settings, tile: tiles[tile], samples };
            let Some(filled) = workshop.fill(&task, cancel) else { return };
            // A thread that panics takes the job with it, so what it leaves behind is never seen.
            let mut merge = desk.merges[tile / across].lock().unwrap_or_else(PoisonError::into_inner);
            let samples = merge.add(self.plan, [tile, block], &filled);
            drop(merge);
            desk.samples.fetch_add(samples, Ordering::Relaxed);
            tell();
        }
    }
}

/// What the threads of a job share.
pub struct Desk<'a> {
    pub plan: &'a Plan,
    pub clock: Clock,
    /// What the film keeps.
    pub keep: Keep,
    /// The last estimate of the relative error.
    pub noise: Option<f32>,
    /// The rays and the bad samples of what was in the film before.
    pub before: [u64; 2],
    /// Rows of tiles.
    pub merges: Vec<Mutex<Merge<'a>>>,
    /// Samples in the film.
    pub samples: AtomicU64,
    /// The next piece to take.
    next: AtomicUsize,
    is_time_over: AtomicBool,
}

impl<'a> Desk<'a> {
    /// `blocks` says how many blocks of each tile are in the film.
    pub fn new(plan: &'a Plan, blocks: &[usize], clock: Clock, so_far: &'a mut Rendered) -> Self {
        let samples = AtomicU64::new(so_far.film.samples());
        let (keep, before) = (so_far.film.keep(), [so_far.rays, so_far.bad_samples]);
        // No piece before it is left to do.
        let first = blocks.iter().min().copied().unwrap_or(0) * plan.tiles.len();
        let rows = blocks.chunks(plan.across);
        let merges = so_far.film.bands().zip(rows).map(|(band, row)| Mutex::new(Merge::new(band, row)));
        Self {
            plan,
            clock,
            keep,
            noise: so_far.noise,
            before,
            merges: merges.collect(),
            samples,
            next: AtomicUsize::new(first),
            is_time_over: AtomicBool::new(false),
        }
    }

    fn has_all_before(&self, end: usize) -> bool {
        let has_all =
            |merge: &Mutex<Merge>| merge.lock().unwrap_or_else(PoisonError::into_inner).has_all_before(end);
        self.merges.iter().all(has_all)
    }

    /// The rays and the bad samples of all that is in the film.
    fn counts(self) -> [u64; 2] {
        let mut counts = self.before;
        for merge in self.merges {
            let merge = merge.into_inner().unwrap_or_else(PoisonError::into_inner);
            counts = [0, 1].map(|i| counts[i] + merge.counts[i]);
        }
        counts
    }
}
