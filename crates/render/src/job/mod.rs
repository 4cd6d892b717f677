//! The render job: threads, order, progress and stopping. It knows nothing of physics.
//!
//! The work is cut into pieces, a tile times a block of samples, which do not depend on the threads. Threads, the caller's
//! among them, take pieces from a counter and add their sums to the film, each tile's blocks in order. So the picture is
//! the same bytes for any number of threads, and a film says itself where a job that was stopped has to go on.
//!
//! A job ends when all samples are there, when its time is over, or when the picture is clean enough. The last is asked only
//! at certain numbers of samples, when all tiles have as many and before any gets more: so it ends with the same picture
//! whatever the threads do. Where a time limit falls, nobody can foretell.

mod glance;
mod merge;
mod plan;
mod work;

pub use glance::{Glance, Progress};

use crate::compile::CompiledScene;
use crate::error::RenderError;
use crate::integrators::keeps;
use glance::Report;
use plan::Plan;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use vitrine_film::{Film, Region};
use vitrine_scene::Settings;
use work::{Crew, Desk, Reached, Stage};

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

/// Why a job gave back what it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// It was cancelled, or has not begun.
    Unfinished,
    /// All samples are there.
    Samples,
    /// The picture is as clean as the settings ask for.
    Noise,
    /// The settings' time is over.
    Time,
}

/// What a job gives back, finished or not.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture so far.
    pub film: Film,
    /// Why there is no more.
    pub ending: Ending,
    /// Rays traced: camera, mirror, straight-on, refracted and shadow rays.
    pub rays: u64,
    /// Samples whose light was no finite number, and which were left out.
    pub bad_samples: u64,
    /// The relative error of the picture ([`vitrine_film::Noise::relative_error`]) when last it was estimated; None: it never
    /// was.
    pub noise: Option<f32>,
    /// How long it has been rendered, all times together if it was stopped in between.
    pub spent: Duration,
}

impl Rendered {
    /// Whether it is what the settings ask for: it ended, and not because someone cancelled it.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        !matches!(self.ending, Ending::Unfinished)
    }

    /// A picture that was stopped with this film.
    #[must_use]
    pub const fn of_film(film: Film) -> Self {
        let (ending, spent) = (Ending::Unfinished, Duration::ZERO);
        Self { film, ending, rays: 0, bad_samples: 0, noise: None, spent }
    }
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
        Rendered::of_film(Film::keeping(self.region, keeps(&self.settings)))
    }

    /// Renders on so many threads, the caller's among them (0: all of the machine's), until done or cancelled. The picture does
    /// not depend on the number of threads, unless it is a time limit that ends it. `progress` is called on the caller's thread,
    /// ten times a second at most and at the end.
    #[must_use]
    pub fn run(&self, threads: usize, cancel: &Cancel, progress: &mut dyn FnMut(Progress)) -> Rendered {
        let plan = Plan::new(self.region, self.settings.samples);
        let blocks = vec![0; plan.tiles.len()];
        let crew = Crew::new(threads, cancel);
        self.go_on((plan, blocks), self.nothing_yet(), crew, &mut |glance| progress(glance.progress()))
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
        if so_far.film.keep() != keeps(&self.settings) {
            return Err(RenderError::OtherFilm);
        }
        let blocks = plan.begun(&so_far.film)?;
        Ok(self.go_on((plan, blocks), so_far, Crew::new(threads, cancel), watch))
    }

    /// Renders what is left of a plan, from one question about the noise to the next.
    fn go_on(
        &self,
        (plan, mut blocks): (Plan, Vec<usize>),
        mut so_far: Rendered,
        mut crew: Crew,
        watch: &mut dyn FnMut(&Glance),
    ) -> Rendered {
        let clock = Clock::new(so_far.spent, self.settings.time_limit);
        let mut report = Report::new(watch);
        so_far.ending = Ending::Unfinished;
        for end in plan.stages(so_far.film.keep()) {
            let stage = Stage { job: self, plan: &plan, blocks: &blocks, end, clock };
            let reached = stage.run(&mut so_far, &mut crew, &mut report);
            if reached != Reached::Whole {
                so_far.ending = if reached == Reached::Time { Ending::Time } else { Ending::Unfinished };
                break;
            }
            blocks.iter_mut().for_each(|b| *b = (*b).max(end));
            so_far.noise = so_far.film.noise().map(|n| n.relative_error).or(so_far.noise);
            if end == plan.blocks.len() {
                so_far.ending = Ending::Samples;
            } else if self.is_clean_enough(so_far.noise) && blocks.iter().all(|b| *b == end) {
                so_far.ending = Ending::Noise;
                break;
            }
        }
        so_far.spent = clock.now();
        report.finish(&Desk::new(&plan, &blocks, clock, &mut so_far));
        so_far
    }

    /// Whether a picture with this relative error needs no more samples.
    fn is_clean_enough(&self, noise: Option<f32>) -> bool {
        self.settings.noise > 0.0 && noise.is_some_and(|n| n <= self.settings.noise)
    }
}

/// How long a picture has been rendered, and how long it may be.
#[derive(Clone, Copy, Debug)]
struct Clock {
    start: Instant,
    /// What it took before this start.
    before: Duration,
    /// When its time is over; None: never.
    deadline: Option<Instant>,
}

impl Clock {
    /// Starts it; a limit of 0 seconds is none.
    fn new(before: Duration, limit: f32) -> Self {
        let start = Instant::now();
        // A time too long to be told is none, too.
        let limit = Duration::try_from_secs_f32(limit).ok().filter(|limit| !limit.is_zero());
        let deadline = limit.and_then(|limit| start.checked_add(limit.saturating_sub(before)));
        Self { start, before, deadline }
    }

    fn now(self) -> Duration {
        self.before + self.start.elapsed()
    }

    fn is_over(self) -> bool {
        self.deadline.is_some_and(|end| Instant::now() >= end)
    }
}
