//! Integrators: the light that a camera ray sees. Each fills a tile of the picture at a time.

mod classic;
mod light;
mod soft;
mod tile;
mod wave;

pub use wave::lanes_below;

use crate::compile::CompiledScene;
use crate::job::Cancel;
use vitrine_film::Region;
use vitrine_math::Rgb;
use vitrine_scene::{Renderer, Settings};

/// What a tile is filled with.
#[derive(Clone, Debug)]
pub struct TileTask<'a> {
    /// The scene.
    pub scene: &'a CompiledScene,
    /// Depth, samples, quality and seed.
    pub settings: &'a Settings,
    /// The tile, in the picture's pixels.
    pub tile: Region,
    /// Which samples of each pixel.
    pub samples: std::ops::Range<u32>,
}

/// The tools of one thread, kept from tile to tile so that nothing is allocated in between.
#[derive(Debug, Default)]
pub struct Workshop {
    classic: classic::Waves,
}

impl Workshop {
    /// The sums of the samples for each pixel of the tile, row by row, and how many rays that took. None when it was cancelled
    /// in between.
    pub fn fill(&mut self, task: &TileTask, cancel: &Cancel) -> Option<(&[Rgb], u64)> {
        let reach = match task.settings.renderer {
            Renderer::Classic | Renderer::Photoreal => classic::Reach::Recursive,
            Renderer::Cast => classic::Reach::CameraOnly,
        };
        self.classic.fill(task, reach, cancel)
    }
}
