//! The final render: at the scene's own size and quality, with stopping and going on.

use super::picture::Picture;
use super::shared::FinalTask;
use super::{LiveError, Ready, Request, Status};
use std::sync::Arc;
use std::time::{Duration, Instant};
use vitrine::film::Film;
use vitrine::scene::{Scene, Settings};
use vitrine::{Cancel, Image, Progress, Rendered};

/// How far the final render is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FinalState {
    /// There is none.
    #[default]
    Idle,
    /// It runs.
    Running,
    /// It was stopped and can go on.
    Stopped,
    /// It is complete.
    Done,
}

/// The final picture so far, to be saved.
#[derive(Clone, Debug)]
pub struct FinalImage {
    /// Sums of samples; [`FinalImage::image`] is their mean.
    pub film: Film,
    /// Whether all samples are in it.
    pub is_complete: bool,
    /// The scene as it was when the render was begun.
    pub scene: Arc<Scene>,
}

impl FinalImage {
    /// The picture in linear light.
    #[must_use]
    pub fn image(&self) -> Image {
        self.film.image()
    }

    /// The settings with which it is made.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.scene.settings
    }
}

/// Time during which something ran.
#[derive(Clone, Copy, Debug, Default)]
pub struct Clock {
    before: Duration,
    since: Option<Instant>,
}

impl Clock {
    /// Goes on.
    pub fn start(&mut self) {
        self.since.get_or_insert_with(Instant::now);
    }

    /// Stops.
    pub fn stop(&mut self) {
        self.before = self.elapsed();
        self.since = None;
    }

    /// All the time that it ran.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        self.before + self.since.map_or(Duration::ZERO, |since| since.elapsed())
    }
}

/// The final render, as the window and the worker share it.
#[derive(Default)]
pub struct FinalRender {
    /// How far it is.
    pub state: FinalState,
    /// Counts the final renders, so that the worker does not take one for another.
    pub number: u64,
    /// How long it has run.
    pub clock: Clock,
    /// What there is to be saved.
    pub image: Option<Arc<FinalImage>>,
    /// The same to be shown.
    pub picture: Option<Arc<Picture>>,
    request: Option<Arc<Request>>,
    ready: Option<Arc<Ready>>,
    so_far: Option<Rendered>,
    threads: usize,
    progress: Option<Progress>,
    error: Option<LiveError>,
}

impl FinalRender {
    /// Begins anew.
    pub fn start(&mut self, request: Request) {
        let (number, threads) = (self.number + 1, request.threads);
        *self = Self { number, threads, state: FinalState::Running, ..Self::default() };
        self.request = Some(Arc::new(request));
        self.clock.start();
    }

    /// Its scene.
    pub fn scene(&self) -> Option<Arc<Scene>> {
        self.request.as_ref().map(|request| request.scene.clone())
    }

    /// What the worker has to do.
    pub fn task(&mut self, cancel: Cancel) -> Option<FinalTask> {
        let request = self.request.clone()?;
        let (number, threads) = (self.number, self.threads);
        let (ready, so_far) = (self.ready.clone(), self.so_far.take());
        Some(FinalTask { number, request, ready, so_far, threads, cancel, before: None })
    }

    /// Takes another number of threads; whether that has to interrupt it.
    pub fn use_threads(&mut self, threads: usize) -> bool {
        let is_other = threads != self.threads;
        self.threads = threads;
        is_other && self.state == FinalState::Running
    }

    /// Notes what its scene has become.
    pub fn note_ready(&mut self, ready: Arc<Ready>) {
        self.ready = Some(ready);
    }

    /// Notes how far it is.
    pub fn note(&mut self, progress: Progress) {
        self.progress = Some(progress);
    }

    /// Keeps what the worker leaves.
    pub fn keep(&mut self, rendered: Rendered) {
        if rendered.is_complete() {
            self.state = FinalState::Done;
            self.clock.stop();
            (self.ready, self.so_far) = (None, None);
        } else {
            self.so_far = Some(rendered);
        }
    }

    /// Notes why it cannot be made.
    pub fn fail(&mut self, error: LiveError) {
        self.state = FinalState::Idle;
        self.clock.stop();
        self.error = Some(error);
    }

    /// How much is left of the time that the scene gives it; None where it sets no limit.
    fn limit(&self) -> Option<Duration> {
        let limit = self.request.as_ref()?.scene.settings.time_limit;
        let limit = Duration::try_from_secs_f32(limit).ok().filter(|limit| !limit.is_zero())?;
        Some(limit.saturating_sub(self.clock.elapsed()))
    }

    /// How far it is.
    pub fn status(&self) -> Status {
        let elapsed = self.clock.elapsed();
        let mut status =
            Status { error: self.error.clone(), elapsed, pass: 1, passes: 1, ..Status::default() };
        if let Some(Progress { samples_done, samples_total, .. }) = self.progress {
            (status.samples_done, status.samples_total) = (samples_done, samples_total);
            if samples_done > 0 {
                let left = samples_total.saturating_sub(samples_done) as f64 / samples_done as f64;
                let left = Duration::try_from_secs_f64(elapsed.as_secs_f64() * left).ok();
                status.time_left = left.map(|left| self.limit().map_or(left, |limit| left.min(limit)));
            }
        }
        status
    }
}
