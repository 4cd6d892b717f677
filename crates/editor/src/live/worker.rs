//! The worker: makes the scene ready and renders, pass by pass, whatever was asked for last.

use super::final_render::FinalImage;
use super::passes::{Pace, Pass, View, passes};
use super::picture::{Backdrop, ObjectMap, Picture, Source, shown};
use super::shared::{FinalTask, LiveTask, Shared, Task};
use super::{Compile, LiveError, Ready, Request};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};
use vitrine::film::Film;
use vitrine::scene::{Renderer, Scene, Settings};
use vitrine::{RenderJob, RenderOptions, Rendered, display_of, without_display};

/// The least time between two pictures of one pass.
const LOOK_EVERY: Duration = Duration::from_millis(100);
/// Looking at a picture while it grows takes no more than one part in so many of the time.
const LOOK_SHARE: u32 = 20;

/// The worker.
pub struct Worker {
    /// What it shares with the window.
    pub shared: Arc<Shared>,
    /// How a scene is made ready.
    pub compile: Compile,
    /// Whether it makes a single pass at full size, and nothing finer.
    pub is_synchronous: bool,
    /// How fast pictures were lately.
    pub pace: Pace,
    /// What there is of the live picture that was drawn last.
    pub kept: Option<Kept>,
}

/// The light of a live picture, so that it can be shown otherwise without being made again.
pub struct Kept {
    request: Arc<Request>,
    /// Those of the pass that made it.
    settings: Settings,
    rendered: Rendered,
}

impl Kept {
    /// Whether another wish asks for the same light, if perhaps with another exposure, white balance or view.
    fn serves(&self, request: &Request) -> bool {
        let light = |scene: &Scene| Scene { settings: without_display(&scene.settings), ..scene.clone() };
        let (before, now) = (&self.request.scene, &request.scene);
        self.request.size == request.size
            && Arc::ptr_eq(&self.request.assets, &request.assets)
            && (Arc::ptr_eq(before, now) || light(before) == light(now))
    }
}

impl Worker {
    /// Works until the window has gone.
    pub fn run(mut self) {
        while let Some(task) = self.shared.wait_for_task() {
            self.carry_out(task);
        }
    }

    /// Does what there is to do, and comes back.
    pub fn work_off(&mut self) {
        loop {
            let task = self.shared.state().take_task();
            let Some(task) = task else { return };
            self.carry_out(task);
        }
    }

    fn carry_out(&mut self, mut task: Task) {
        let result = catch_unwind(AssertUnwindSafe(|| match &mut task {
            Task::Live(task) => self.draw(task),
            Task::Final(task) => self.finish(task),
        }));
        let result = result.unwrap_or_else(|panic| Err(LiveError::of_panic(panic.as_ref())));
        self.shared.publish(|state| {
            state.running = None;
            if let Err(error) = result {
                state.fail(&task, error);
            }
        });
    }

    /// Makes a scene ready; takes over what it can from the last one.
    fn ready(&self, request: &Request) -> Result<Arc<Ready>, LiveError> {
        let earlier = self.shared.state().ready.clone();
        if let Some(ready) = earlier.clone().filter(|ready| ready.is_of(request)) {
            return Ok(ready);
        }
        let earlier = earlier.as_ref().map(|ready| &ready.compiled);
        let compiled = (self.compile)(&request.scene, &request.assets, earlier)?;
        let (scene, assets) = (request.scene.clone(), request.assets.clone());
        let ready = Arc::new(Ready { scene, assets, compiled });
        self.shared.state().ready = Some(ready.clone());
        Ok(ready)
    }

    /// The passes for a wish, and the picture of the last quick one when it is there already, as it is after a drag.
    fn passes(&self, task: &LiveTask) -> (Vec<Pass>, Option<Arc<Picture>>) {
        let request = &*task.request;
        // A drag that changes no light, such as that of the exposure, need not make the picture any coarser.
        let is_dragging = request.is_dragging && self.kept.is_none() || self.is_synchronous;
        let size = request.size;
        let shrink =
            if self.is_synchronous { 1 } else { self.pace.shrink(size, request.scene.settings.renderer) };
        let all = passes(&View { scene: &request.scene, size, is_dragging, shrink });
        let shown = self.shared.state().picture.clone();
        let is_same =
            |p: &Arc<Picture>| p.generation == request.generation && p.size == size && p.samples > 0;
        (all, shown.filter(|p| is_same(p) && !is_dragging))
    }

    /// Draws a live picture, pass by pass.
    fn draw(&mut self, task: &LiveTask) -> Result<(), LiveError> {
        let ready = self.ready(&task.request)?;
        self.shared.state().status.error = None;
        self.kept = self.kept.take().filter(|kept| kept.serves(&task.request));
        let (all, last) = self.passes(task);
        let mut done = if last.is_some() { all.iter().filter(|pass| pass.is_quick).count() } else { 0 };
        if last.is_some() {
            self.map_objects(task, &ready);
        }
        let first_after = last.as_ref().map(|p| p.first_picture_after);
        let mut drawing = Drawing { task, passes: &all, first_after, last };
        if let Some((index, film)) = self.kept_at(&all) {
            drawing.publish(&self.shared, (index, &all[index]), film);
            self.map_objects(task, &ready);
            done = index;
        }
        for (index, pass) in all.iter().enumerate().skip(done) {
            let options = RenderOptions { settings: pass.settings.clone(), region: None };
            let job = RenderJob::new(&ready.compiled, options)?;
            let begun = match self.kept.take() {
                Some(kept) if pass.goes_on_from(&kept.settings) => kept.rendered,
                _ => job.nothing_yet(),
            };
            let rendered = self.pass(&job, begun, (index, pass), &mut drawing)?;
            let is_pointless = self.shared.is_stale(task) && drawing.last.is_some();
            let is_shown = rendered.is_complete() && !is_pointless;
            if is_shown {
                drawing.publish(&self.shared, (index, pass), &rendered.film);
            }
            let (request, settings) = (task.request.clone(), pass.settings.clone());
            self.kept = Some(Kept { request, settings, rendered });
            if is_shown && index == 0 {
                self.map_objects(task, &ready);
            }
            if !is_shown || self.shared.is_stale(task) {
                break;
            }
        }
        Ok(())
    }

    /// Which pass goes on from what is kept of an earlier picture, and that; None where it has not got a sample everywhere.
    fn kept_at(&self, passes: &[Pass]) -> Option<(usize, &Film)> {
        let kept = self.kept.as_ref().filter(|kept| fewest_samples(&kept.rendered.film) > 0)?;
        let index = passes.iter().position(|pass| pass.goes_on_from(&kept.settings))?;
        Some((index, &kept.rendered.film))
    }

    /// Renders one pass and shows it while it grows.
    fn pass(
        &mut self,
        job: &RenderJob,
        begun: Rendered,
        pass: (usize, &Pass),
        drawing: &mut Drawing,
    ) -> Result<Rendered, LiveError> {
        let task = drawing.task;
        let (before, start) = (begun.film.samples(), Instant::now());
        let mut looks = Looks::new();
        let shared = &self.shared;
        let rendered = job.resume(begun, task.request.threads, &task.cancel, &mut |glance| {
            if shared.is_stale(task) {
                task.cancel.cancel();
                return;
            }
            let progress = glance.progress();
            let is_over = progress.samples_done == progress.samples_total;
            drawing.note(shared, pass, progress);
            // Before there is anything to stand behind it, a part of a picture would only flicker.
            if !is_over && drawing.last.is_some() {
                looks.look(|| drawing.publish(shared, pass, &glance.film()));
            }
        })?;
        if pass.1.is_quick {
            let pixels = rendered.film.samples() - before;
            self.pace.learn(pass.1.settings.renderer, pixels, start.elapsed());
        }
        Ok(rendered)
    }

    /// Works out which object is seen where; coarser during a drag.
    fn map_objects(&self, task: &LiveTask, ready: &Ready) {
        let request = &*task.request;
        let size = request.size.map(|v| if request.is_dragging { v.div_ceil(2) } else { v });
        let objects = ready.compiled.object_map(size, request.threads);
        let behind_glass = ready.compiled.object_map_behind_glass(size, request.threads);
        let (generation, scene) = (request.generation, ready.scene.clone());
        let map = Arc::new(ObjectMap { generation, size, objects, behind_glass, scene });
        self.shared.publish(|state| state.objects = Some(map));
    }

    /// Renders the final picture, or what is left of it.
    fn finish(&self, task: &mut FinalTask) -> Result<(), LiveError> {
        let ready = match task.ready.take() {
            Some(ready) => ready,
            None => self.ready(&task.request)?,
        };
        let options = RenderOptions { settings: task.request.scene.settings.clone(), region: None };
        let job = RenderJob::new(&ready.compiled, options)?;
        let begun = task.so_far.take().unwrap_or_else(|| job.nothing_yet());
        let mut looks = Looks::new();
        let task = &*task;
        let rendered = job.resume(begun, task.threads, &task.cancel, &mut |glance| {
            let progress = glance.progress();
            self.for_final(task, |last| last.note(progress));
            if progress.samples_done < progress.samples_total && !task.cancel.is_cancelled() {
                looks.look(|| self.show_final(task, glance.film(), false));
            }
        })?;
        self.show_final(task, rendered.film.clone(), rendered.is_complete());
        self.for_final(task, |last| {
            last.note_ready(ready.clone());
            last.keep(rendered);
        });
        Ok(())
    }

    /// Changes the final render, unless another one has been begun meanwhile.
    fn for_final(&self, task: &FinalTask, change: impl FnOnce(&mut super::final_render::FinalRender)) {
        self.shared.publish(|state| {
            if state.last.number == task.number {
                change(&mut state.last);
            }
        });
    }

    fn show_final(&self, task: &FinalTask, film: Film, is_complete: bool) {
        let scene = task.request.scene.clone();
        let before = task.before.as_ref().map(|p| Backdrop { size: p.size, rgba: &p.rgba });
        let rgba = shown(&film, &display_of(&scene.settings), before);
        let picture = Picture {
            generation: task.request.generation,
            source: Source::Final,
            size: scene.settings.size,
            rgba,
            pass: 1,
            passes: 1,
            samples: fewest_samples(&film),
            is_final: is_complete,
            elapsed: Duration::ZERO,
            first_picture_after: Duration::ZERO,
        };
        let image = Arc::new(FinalImage { film, is_complete, scene });
        self.for_final(task, |last| {
            let elapsed = last.clock.elapsed();
            let first = last.picture.as_ref().map_or(elapsed, |p| p.first_picture_after);
            last.picture = Some(Arc::new(Picture { elapsed, first_picture_after: first, ..picture }));
            last.image = Some(image);
        });
    }
}

/// A live picture that is being drawn.
struct Drawing<'a> {
    task: &'a LiveTask,
    passes: &'a [Pass],
    first_after: Option<Duration>,
    /// What has been shown of it.
    last: Option<Arc<Picture>>,
}

impl Drawing<'_> {
    /// Shows a picture.
    fn publish(&mut self, shared: &Shared, (index, pass): (usize, &Pass), film: &Film) {
        let elapsed = self.task.start.elapsed();
        let first_picture_after = *self.first_after.get_or_insert(elapsed);
        let before = self.last.as_ref().map(|p| Backdrop { size: p.size, rgba: &p.rgba });
        let samples = fewest_samples(film);
        let picture = Arc::new(Picture {
            generation: self.task.request.generation,
            source: Source::Live,
            size: pass.settings.size,
            rgba: shown(film, &display_of(&pass.settings), before),
            pass: index as u32 + 1,
            passes: self.passes.len() as u32,
            samples,
            is_final: index + 1 == self.passes.len() && samples == pass.settings.samples,
            elapsed,
            first_picture_after,
        });
        self.last = Some(picture.clone());
        shared.publish(|state| state.picture = Some(picture));
        shared.has_shown();
    }

    /// Notes how far it is.
    fn note(&self, shared: &Shared, (index, pass): (usize, &Pass), progress: vitrine::Progress) {
        let mut state = shared.state();
        state.status.samples_done = progress.samples_done;
        state.status.samples_total = progress.samples_total;
        (state.status.pass, state.status.passes) = (index as u32 + 1, self.passes.len() as u32);
        state.status.samples = self.samples(pass, progress.samples_done);
        state.status.elapsed = self.task.start.elapsed();
    }

    /// How many samples each pixel has and will have, where they are what is waited for.
    fn samples(&self, pass: &Pass, done: u64) -> Option<[u32; 2]> {
        let last = &self.passes.last()?.settings;
        let [width, height] = last.size.map(u64::from);
        let is_told = last.renderer == Renderer::Photoreal && pass.settings.size == last.size;
        is_told.then(|| [(done / (width * height)) as u32, last.samples])
    }
}

/// When to look at a picture that grows: not too often, and less often when looking takes long.
struct Looks {
    next: Instant,
}

impl Looks {
    fn new() -> Self {
        Self { next: Instant::now() + LOOK_EVERY }
    }

    fn look(&mut self, look: impl FnOnce()) {
        let start = Instant::now();
        if start >= self.next {
            look();
            self.next = Instant::now() + LOOK_EVERY.max(start.elapsed() * LOOK_SHARE);
        }
    }
}

fn fewest_samples(film: &Film) -> u32 {
    film.tile_samples().iter().min().copied().unwrap_or(0)
}
