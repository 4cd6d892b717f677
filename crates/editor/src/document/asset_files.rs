//! The models, pictures and panoramas that a scene names by path.

use super::{Document, EditError};
use crate::files::complete_assets;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use vitrine::scene::{Assets, Item, Light, Object, Scene, Texture, Value};

/// The key under which shapes, textures and lights keep the path of their file.
const FILE: &str = "file";

impl Document {
    /// Reads what the scene names, the document's scene does not name yet, and is not among its assets.
    pub(super) fn load_what_is_new(&mut self, scene: &Scene) -> Result<(), EditError> {
        let mut wanted = missing(scene, &self.assets);
        if wanted.objects.is_empty() && wanted.textures.is_empty() && wanted.lights.is_empty() {
            return Ok(());
        }
        // What was missing before the edit is no fault of the edit.
        let before = missing(&self.scene, &self.assets);
        let known: BTreeSet<&Path> = files(&before).collect();
        wanted.objects.retain(|o| o.shape.as_kind().file().is_some_and(|f| !known.contains(f)));
        wanted.textures.retain(|t| t.source.as_kind().file().is_some_and(|f| !known.contains(f)));
        wanted.lights.retain(|l| l.source.as_kind().file().is_some_and(|f| !known.contains(f)));
        let mut assets = Assets::default();
        let notes = complete_assets(&mut assets, &wanted, Some(&self.folder))
            .map_err(|error| EditError::File { reason: error.to_string(), help: error.help() })?;
        self.provide(assets, notes);
        Ok(())
    }
}

/// What names a file that is not among the assets.
pub(crate) fn missing(scene: &Scene, assets: &Assets) -> Scene {
    let lacks_model = |object: &&Object| {
        object.shape.as_kind().file().is_some_and(|file| !assets.meshes.contains_key(file))
    };
    let lacks_picture = |texture: &&Texture| {
        texture.source.as_kind().file().is_some_and(|file| !assets.pictures.contains_key(file))
    };
    let lacks_panorama =
        |light: &&Light| light.source.as_kind().file().is_some_and(|file| !assets.maps.contains_key(file));
    Scene {
        lights: scene.lights.iter().filter(lacks_panorama).cloned().collect(),
        objects: scene.objects.iter().filter(lacks_model).cloned().collect(),
        textures: scene.textures.iter().filter(lacks_picture).cloned().collect(),
        ..Scene::default()
    }
}

fn files(scene: &Scene) -> impl Iterator<Item = &Path> {
    let models = scene.objects.iter().filter_map(|o| o.shape.as_kind().file());
    let pictures = scene.textures.iter().filter_map(|t| t.source.as_kind().file());
    models.chain(pictures).chain(scene.lights.iter().filter_map(|l| l.source.as_kind().file()))
}

/// Writes other paths into a scene.
pub(super) fn rename(scene: &mut Scene, to: impl Fn(&Path) -> PathBuf + Copy) {
    rename_in(&mut scene.objects, to);
    rename_in(&mut scene.textures, to);
    rename_in(&mut scene.lights, to);
}

/// Writes other paths into the entries of a list.
pub(super) fn rename_in<T: Item>(items: &mut [T], to: impl Fn(&Path) -> PathBuf) {
    for params in items.iter_mut().filter_map(Item::kind_params_mut) {
        if let Some(Value::Text(path)) = params.get(FILE) {
            // Scene files name paths with slashes on every system.
            let path = to(Path::new(&path)).to_string_lossy().replace('\\', "/");
            params.store(FILE, Value::Text(path));
        }
    }
}
