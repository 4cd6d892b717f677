//! The live picture: a worker renders whatever the window asked for last, coarse at once and then ever finer, and the final
//! render. Nothing here knows of a window.
//!
//! [`Live::show`] says what is to be seen; [`Live::picture`] gives the newest picture of it at any time. The scene is
//! compiled on the worker, which takes over the trees of models from the scene before.

mod final_render;
mod passes;
mod picture;
mod shared;
mod worker;

pub use final_render::{FinalImage, FinalState};
pub use picture::{ObjectMap, Picked, Picture, Source};

use passes::Pace;
use shared::{Shared, Wake};
use std::any::Any;
use std::sync::Arc;
use std::time::Duration;
use vitrine::render::{CompileError, CompiledScene, RenderError, compile};
use vitrine::scene::{Assets, Scene};
use worker::Worker;

/// How a scene is made ready; a later state takes over what it can from an earlier one.
type Compile = fn(&Scene, &Assets, Option<&CompiledScene>) -> Result<CompiledScene, CompileError>;

/// What is to be seen.
#[derive(Clone, Debug)]
pub struct Request {
    /// The scene.
    pub scene: Arc<Scene>,
    /// Its models and pictures.
    pub assets: Arc<Assets>,
    /// Width and height of the view, in pixels. The final render takes the scene's own.
    pub size: [u32; 2],
    /// Threads; 0: all of the machine's.
    pub threads: usize,
    /// Whether something is being dragged: then the picture gets no finer than quick.
    pub is_dragging: bool,
    /// The caller's name for this state of the scene; the pictures of it carry it.
    pub generation: u64,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LiveError {
    /// The scene cannot be made ready.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The picture cannot be made.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The renderer has a fault.
    #[error("the renderer has failed: {message}")]
    Panic {
        /// What it said.
        message: String,
    },
}

impl LiveError {
    fn of_panic(panic: &(dyn Any + Send)) -> Self {
        let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
        let message = text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default();
        Self::Panic { message }
    }
}

/// How far the picture is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Status {
    /// Why there is no newer picture; None when all is well.
    pub error: Option<LiveError>,
    /// Samples of this pass, or of the final render, that are finished.
    pub samples_done: u64,
    /// All of them.
    pub samples_total: u64,
    /// The pass, counted from 1; 0 before the first.
    pub pass: u32,
    /// How many passes there will be.
    pub passes: u32,
    /// How many samples each pixel of a photoreal live picture has, on average, and how many it will have; None while it is
    /// coarse and for what else is shown.
    pub samples: Option<[u32; 2]>,
    /// Whether something is being computed or waits to be.
    pub is_busy: bool,
    /// Since the request; of the final render all the time that it ran.
    pub elapsed: Duration,
    /// How long the final render will still take; None when nobody knows.
    pub time_left: Option<Duration>,
}

/// A scene that has been made ready.
#[derive(Debug)]
struct Ready {
    scene: Arc<Scene>,
    assets: Arc<Assets>,
    compiled: CompiledScene,
}

impl Ready {
    fn is_of(&self, request: &Request) -> bool {
        Arc::ptr_eq(&self.scene, &request.scene) && Arc::ptr_eq(&self.assets, &request.assets)
    }

    /// A point of the picture in pixels of the scene's own size.
    fn pixel(&self, x: f32, y: f32) -> ([f32; 2], [u32; 2]) {
        let size = self.scene.settings.size;
        ([x * size[0] as f32, y * size[1] as f32], size)
    }

    fn named(&self, picked: vitrine::render::Picked) -> Option<Picked> {
        let name = self.scene.objects.get(picked.object)?.name.clone();
        Some(Picked { name, point: picked.point, distance: picked.distance, n: picked.n })
    }
}

/// The live picture and the final render of one window.
pub struct Live {
    shared: Arc<Shared>,
    /// Does everything on the caller's thread; None when a thread of its own does.
    here: Option<Worker>,
}

impl Live {
    /// Starts the worker. `wake` is called, on any thread, when there is something new to show.
    ///
    /// # Panics
    /// When the system has no thread left.
    #[must_use]
    pub fn new(wake: Wake) -> Self {
        Self::with_compile(wake, compile_after)
    }

    fn with_compile(wake: Wake, compile: Compile) -> Self {
        let worker = worker(wake, compile);
        let shared = worker.shared.clone();
        let thread = std::thread::Builder::new().name("live".into());
        thread.spawn(move || worker.run()).expect("the system has a thread left");
        Self { shared, here: None }
    }

    /// Without a thread of its own: [`Live::show`] comes back with a picture of full size and one sample, and a final render
    /// is complete when its start comes back. For tests of windows.
    #[must_use]
    pub fn synchronous() -> Self {
        let worker = Worker { is_synchronous: true, ..worker(Arc::new(|| ()), compile_after) };
        Self { shared: worker.shared.clone(), here: Some(worker) }
    }

    fn work_here(&mut self) {
        if let Some(worker) = &mut self.here {
            worker.work_off();
        }
    }

    /// Asks for a picture. What is running stops at once; only the newest wish counts. Another scene than that of the final
    /// render brings the live picture back.
    pub fn show(&mut self, request: Request) {
        self.shared.change(|state| state.show(request));
        self.work_here();
    }

    /// The newest picture.
    #[must_use]
    pub fn picture(&self) -> Option<Arc<Picture>> {
        self.shared.state().newest_picture()
    }

    /// Which object is seen where in the live picture.
    #[must_use]
    pub fn objects(&self) -> Option<Arc<ObjectMap>> {
        self.shared.state().objects.clone()
    }

    /// How far the picture is.
    #[must_use]
    pub fn status(&self) -> Status {
        self.shared.state().newest_status()
    }

    /// What lies under a point of the picture, as shares of its width from the left and of its height from the top. Works on
    /// the last scene that was made ready and waits for nothing.
    #[must_use]
    pub fn pick(&self, x: f32, y: f32) -> Option<Picked> {
        let ready = self.shared.state().ready.clone()?;
        let (at, size) = ready.pixel(x, y);
        ready.named(ready.compiled.pick(at, size)?)
    }

    /// The same with what is seen behind it, as far as things are transparent; the nearest first.
    #[must_use]
    pub fn pick_through(&self, x: f32, y: f32) -> Vec<Picked> {
        let Some(ready) = self.shared.state().ready.clone() else { return Vec::new() };
        let (at, size) = ready.pixel(x, y);
        ready.compiled.pick_through(at, size).into_iter().filter_map(|picked| ready.named(picked)).collect()
    }

    /// Begins the final render, at the scene's own size and quality. An earlier one is forgotten. The live picture rests.
    pub fn start_final(&mut self, request: Request) {
        self.shared.change(|state| state.start_final(request));
        self.work_here();
    }

    /// Stops the final render; what there is of it stays.
    pub fn stop_final(&mut self) {
        self.shared.change(shared::State::stop_final);
    }

    /// Goes on where the final render was stopped; the picture will be the same bytes as if it had never been.
    pub fn continue_final(&mut self) {
        self.shared.change(shared::State::continue_final);
        self.work_here();
    }

    /// How far the final render is.
    #[must_use]
    pub fn final_state(&self) -> FinalState {
        self.shared.state().last.state
    }

    /// The final picture so far, to be saved.
    #[must_use]
    pub fn final_image(&self) -> Option<Arc<FinalImage>> {
        self.shared.state().final_image()
    }
}

impl Drop for Live {
    /// The worker stops soon and ends by itself.
    fn drop(&mut self) {
        self.shared.change(|state| {
            state.is_over = true;
            state.stop_running();
        });
    }
}

fn worker(wake: Wake, compile: Compile) -> Worker {
    let shared = Arc::new(Shared::new(wake));
    Worker { shared, compile, is_synchronous: false, pace: Pace::default(), kept: None }
}

fn compile_after(
    scene: &Scene,
    assets: &Assets,
    earlier: Option<&CompiledScene>,
) -> Result<CompiledScene, CompileError> {
    earlier.map_or_else(|| compile(scene, assets), |earlier| earlier.recompile(scene, assets))
}

#[cfg(test)]
mod tests;
