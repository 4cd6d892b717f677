//! The models and pictures that a scene names by path.

use super::{Document, EditError};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use vitrine::formats::load_assets;
use vitrine::scene::{Assets, Item, Object, Scene, Texture, Value};

/// The key under which shapes and textures keep the path of their file.
const FILE: &str = "file";

/// Reads what the scene names, the document's scene does not name yet, and is not among its assets. None when that is
/// nothing.
pub(super) fn load_new(
    scene: &Scene,
    document: &Document,
) -> Result<Option<(Assets, Vec<String>)>, EditError> {
    let mut wanted = missing(scene, &document.assets);
    if wanted.objects.is_empty() && wanted.textures.is_empty() {
        return Ok(None);
    }
    // What was missing before the edit is no fault of the edit.
    let before = missing(&document.scene, &document.assets);
    let known: BTreeSet<&Path> = files(&before).collect();
    wanted.objects.retain(|o| o.shape.as_kind().file().is_some_and(|f| !known.contains(f)));
    wanted.textures.retain(|t| t.source.as_kind().file().is_some_and(|f| !known.contains(f)));
    let loaded = load_assets(&wanted, &document.folder);
    loaded.map(Some).map_err(|error| EditError::File { reason: error.to_string(), help: error.help() })
}

/// What names a file that is not among the assets.
pub(crate) fn missing(scene: &Scene, assets: &Assets) -> Scene {
    let lacks_model = |object: &&Object| {
        object.shape.as_kind().file().is_some_and(|file| !assets.meshes.contains_key(file))
    };
    let lacks_picture = |texture: &&Texture| {
        texture.source.as_kind().file().is_some_and(|file| !assets.pictures.contains_key(file))
    };
    Scene {
        objects: scene.objects.iter().filter(lacks_model).cloned().collect(),
        textures: scene.textures.iter().filter(lacks_picture).cloned().collect(),
        ..Scene::default()
    }
}

/// Whether two scenes name the same files.
pub(super) fn are_same(a: &Scene, b: &Scene) -> bool {
    files(a).eq(files(b))
}

fn files(scene: &Scene) -> impl Iterator<Item = &Path> {
    let models = scene.objects.iter().filter_map(|o| o.shape.as_kind().file());
    models.chain(scene.textures.iter().filter_map(|t| t.source.as_kind().file()))
}

/// Writes other paths into a scene.
pub(super) fn rename(scene: &mut Scene, to: impl Fn(&Path) -> PathBuf) {
    fn change<T: Item>(items: &mut [T], to: &impl Fn(&Path) -> PathBuf) {
        for params in items.iter_mut().filter_map(Item::kind_params_mut) {
            if let Some(Value::Text(path)) = params.get(FILE) {
                // Scene files name paths with slashes on every system.
                let path = to(Path::new(&path)).to_string_lossy().replace('\\', "/");
                params.store(FILE, Value::Text(path));
            }
        }
    }
    change(&mut scene.objects, &to);
    change(&mut scene.textures, &to);
}
