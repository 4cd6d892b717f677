//! Integrators: the light that a camera ray sees. Each fills a tile of the picture at a time.

mod classic;
mod light;
mod photoreal;
mod soft;
mod tile;
mod wave;

pub use photoreal::CompiledMedia;
pub use wave::lanes_below;

use crate::compile::CompiledScene;
use crate::job::Cancel;
use vitrine_film::{Keep, Region, TileSums};
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

/// What has been worked out of a tile.
#[derive(Clone, Copy, Debug)]
pub struct Filled<'a> {
    /// The sums of its samples.
    pub sums: TileSums<'a>,
    /// How many rays that took.
    pub rays: u64,
    /// How many samples were left out because their light was no finite number.
    pub bad: u64,
}

/// What a film has to keep for these settings.
pub const fn keeps(settings: &Settings) -> Keep {
    match settings.renderer {
        Renderer::Photoreal => Keep::Layers,
        Renderer::Classic | Renderer::Cast if settings.noise > 0.0 => Keep::Halves,
        Renderer::Classic | Renderer::Cast => Keep::Light,
    }
}

/// The tools of one thread, kept from tile to tile so that nothing is allocated in between.
#[derive(Debug, Default)]
pub struct Workshop {
    classic: classic::Waves,
    photoreal: photoreal::Paths,
}

impl Workshop {
    /// Works out the samples of a tile. None when it was cancelled in between.
    pub fn fill(&mut self, task: &TileTask, cancel: &Cancel) -> Option<Filled<'_>> {
        let reach = match task.settings.renderer {
            Renderer::Photoreal => {
                task.scene.make_photoreal();
                return self.photoreal.fill(task, cancel);
            }
            Renderer::Classic => classic::Reach::Recursive,
            Renderer::Cast => classic::Reach::CameraOnly,
        };
        let (light, rays) = self.classic.fill(task, reach, cancel)?;
        Some(Filled { sums: TileSums::of_light(light), rays, bad: 0 })
    }
}
