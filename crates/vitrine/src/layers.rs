//! The layers of a picture for compositors.

use crate::film::Film;
use crate::formats::ExrLayers;
use crate::render::CompiledScene;
use crate::scene::Scene;

/// What an OpenEXR file with layers tells of a picture beside its light. `scene` is what was compiled, with the picture's settings;
/// objects are found on so many threads (0: all of the machine's).
#[must_use]
pub fn layers_of(scene: &Scene, compiled: &CompiledScene, film: &Film, threads: usize) -> ExrLayers {
    let (size, region) = (scene.settings.size, film.region());
    let map = compiled.object_map(size, threads);
    let stride = size[0] as usize;
    let (left, width) = (region.x as usize, region.width as usize);
    let rows = map.chunks(stride.max(1)).skip(region.y as usize).take(region.height as usize);
    ExrLayers {
        features: film.layers(),
        samples: film.pixel_samples(),
        objects: rows.flat_map(|row| &row[left..left + width]).copied().collect(),
        names: scene.objects.iter().map(|o| o.name.clone()).collect(),
    }
}
