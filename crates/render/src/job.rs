//! The render job (interface only in this slice).

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use vitrine_film::{Film, Region, RegionError};
use vitrine_math::Rgb;
use vitrine_scene::{Assets, Renderer, Scene, Settings};

/// A scene made ready for rendering: immutable, shared by threads without locks.
#[derive(Debug)]
pub struct CompiledScene {
    background: Rgb,
}

/// Why a scene cannot be rendered.
#[derive(Debug, thiserror::Error)]
pub enum CompileError {
    /// A file was not loaded.
    #[error("the model of `{object}` has not been loaded")]
    MissingAsset {
        /// The object.
        object: String,
    },
}

/// Makes a scene ready.
///
/// # Errors
/// [`CompileError`]
pub fn compile(scene: &Scene, _assets: &Assets) -> Result<CompiledScene, CompileError> {
    Ok(CompiledScene { background: scene.settings.background })
}

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
    region: Region,
}

impl<'a> RenderJob<'a> {
    /// Prepares a job.
    ///
    /// # Errors
    /// When the region is not inside the picture.
    pub fn new(scene: &'a CompiledScene, options: RenderOptions) -> Result<Self, RegionError> {
        let _ = Renderer::Classic;
        let region = options.region.unwrap_or(Region::whole(options.settings.size));
        region.check_inside(options.settings.size)?;
        Ok(Self { scene, region })
    }

    /// Renders on so many threads (0: all of the machine's) until done or cancelled. The picture does not depend on
    /// the number of threads. `progress` is called from the calling thread, a few times a second at most.
    #[must_use]
    pub fn run(&self, _threads: usize, _cancel: &Cancel, _progress: &mut dyn FnMut(Progress)) -> Rendered {
        let mut film = Film::new(self.region);
        film.add_samples(self.region, &vec![self.scene.background; self.region.pixels()], 1);
        Rendered { film, is_complete: true, rays: 0 }
    }
}
