//! Reads every model and picture that a scene names.

use crate::{FormatError, read_mesh, read_picture};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine_scene::{Assets, MeshMaterial, Picture, Scene};

/// Reads every model and picture that a scene names, each once. `folder` is the scene file's. The warnings are one
/// sentence each, with the path.
///
/// The pictures of models' own materials are keyed by their path relative to the same folder; one that cannot be read is a
/// warning, and the material keeps its colour.
///
/// # Errors
/// [`FormatError::Asset`] for the first file that cannot be read, with the object or texture that names it.
pub fn load_assets(scene: &Scene, folder: &Path) -> Result<(Assets, Vec<String>), FormatError> {
    let mut assets = Assets::default();
    let mut warnings = Vec::new();
    for texture in &scene.textures {
        let Some(file) = texture.source.as_kind().file() else { continue };
        if !assets.pictures.contains_key(file) {
            let picture =
                named(file, folder, read_picture).map_err(|e| wanted_by("texture", &texture.name, e))?;
            assets.pictures.insert(file.into(), Arc::new(picture));
        }
    }
    for object in &scene.objects {
        let Some(file) = object.shape.as_kind().file() else { continue };
        if !assets.meshes.contains_key(file) {
            let (mut mesh, notes) =
                named(file, folder, read_mesh).map_err(|e| wanted_by("object", &object.name, e))?;
            warnings.extend(notes);
            for material in &mut mesh.materials {
                load_picture(material, file, folder, &mut assets.pictures, &mut warnings);
            }
            assets.meshes.insert(file.into(), Arc::new(mesh));
        }
    }
    Ok((assets, warnings))
}

/// Reads a file that the scene names.
fn named<T>(
    file: &Path,
    folder: &Path,
    read: impl Fn(&Path) -> Result<T, FormatError>,
) -> Result<T, FormatError> {
    if file.as_os_str().is_empty() { Err(FormatError::EmptyPath) } else { read(&folder.join(file)) }
}

fn wanted_by(list: &str, name: &str, cause: FormatError) -> FormatError {
    FormatError::Asset { owner: format!("{list} `{name}`"), cause: Box::new(cause) }
}

/// Reads the picture of a model's material unless it is there, and makes the material name it by its key.
fn load_picture(
    material: &mut MeshMaterial,
    model: &Path,
    folder: &Path,
    pictures: &mut BTreeMap<PathBuf, Arc<Picture>>,
    warnings: &mut Vec<String>,
) {
    let Some(picture) = material.picture.take() else { return };
    let key = model.with_file_name("").join(&picture);
    // Exporters like to write the path on their own disc, and people send the files in one folder.
    let beside = picture.file_name().map(|name| model.with_file_name(name));
    let found = std::iter::once(&key).chain(&beside).find(|k| folder.join(k).is_file()).unwrap_or(&key);
    if !pictures.contains_key(found) {
        match read_picture(&folder.join(found)) {
            Ok(read) => drop(pictures.insert(found.clone(), Arc::new(read))),
            Err(fault) => {
                let name = &material.material.name;
                warnings.push(format!("material `{name}` of a model keeps its plain colour, {fault}"));
                return;
            }
        }
    }
    material.picture = Some(found.clone());
}
