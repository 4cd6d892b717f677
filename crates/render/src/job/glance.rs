//! Looks at a job while it runs.

use super::work::Desk;
use super::{Ending, Rendered};
use std::sync::PoisonError;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};
use vitrine_film::{Film, Keep};

/// The least time between two reports of progress.
const REPORT_EVERY: Duration = Duration::from_millis(100);

/// How far a job is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Samples that are finished.
    pub samples_done: u64,
    /// All samples of the job.
    pub samples_total: u64,
    /// The picture's relative error when last it was estimated; None where the renderer does not tell it, or not yet.
    pub noise: Option<f32>,
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
            samples_total: self.desk.plan.samples_total(),
            noise: self.desk.noise,
        }
    }

    /// A copy of the picture's light so far, without what else the film keeps. Threads wait for no longer than copying
    /// their row of tiles takes.
    #[must_use]
    pub fn film(&self) -> Film {
        self.copy(Keep::Light).0
    }

    /// A copy of all that there is so far, each tile with whole blocks of samples: the job can go on from it.
    #[must_use]
    pub fn so_far(&self) -> Rendered {
        let (film, [rays, bad_samples]) = self.copy(self.desk.keep);
        let spent = self.desk.clock.now();
        Rendered { film, ending: Ending::Unfinished, rays, bad_samples, noise: self.desk.noise, spent }
    }

    /// A copy of the film, and the rays and bad samples of what is in it.
    fn copy(&self, keep: Keep) -> (Film, [u64; 2]) {
        let mut film = Film::keeping(self.desk.plan.region, keep);
        let mut counts = self.desk.before;
        for (merge, mut copy) in self.desk.merges.iter().zip(film.bands()) {
            let merge = merge.lock().unwrap_or_else(PoisonError::into_inner);
            merge.band.copy_to(&mut copy);
            counts = [0, 1].map(|i| counts[i] + merge.counts[i]);
        }
        (film, counts)
    }
}

/// Tells the caller how far the job is, not too often.
pub(super) struct Report<'a> {
    last: Instant,
    watch: &'a mut dyn FnMut(&Glance),
}

impl<'a> Report<'a> {
    pub fn new(watch: &'a mut dyn FnMut(&Glance)) -> Self {
        Self { last: Instant::now(), watch }
    }

    pub fn tell(&mut self, desk: &Desk) {
        if self.last.elapsed() >= REPORT_EVERY {
            self.finish(desk);
            // What the caller does with it does not count.
            self.last = Instant::now();
        }
    }

    pub fn finish(&mut self, desk: &Desk) {
        (self.watch)(&Glance { desk });
    }
}
