//! Reads every model, picture and panorama that a scene names.

use crate::{FormatError, read_mesh, read_panorama, read_picture};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine_scene::{Assets, MeshMaterial, Picture, Scene};

/// Reads every model, picture and panorama that a scene names, each once. `folder` is the scene file's. The warnings are one
/// sentence each, with the path.
///
/// The pictures of models' own materials are keyed by their path relative to the same folder; one that cannot be read is a
/// warning, and the material keeps its colour.
///
/// # Errors
/// [`FormatError::Asset`] for the first file that cannot be read, with the object, texture or light that names it.
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
    for light in &scene.lights {
        let Some(file) = light.source.as_kind().file() else { continue };
        if !assets.maps.contains_key(file) {
            let (map, notes) =
                named(file, folder, read_panorama).map_err(|e| wanted_by("light", &light.name, e))?;
            warnings.extend(notes);
            assets.maps.insert(file.into(), Arc::new(map));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{WriteOptions, write_image};
    use std::fs;
    use tempfile::TempDir;
    use vitrine_film::Image;
    use vitrine_math::Rgb;
    use vitrine_scene::lights::Environment;
    use vitrine_scene::shapes::Mesh;
    use vitrine_scene::textures::PictureFile;
    use vitrine_scene::{Light, LightSource, Object, Shape, Texture, TextureSource};

    const MODEL: &str = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";

    /// A folder with `models/m.obj`, its library with that line, and `models/tex/a.png`.
    fn folder(library_line: &str) -> TempDir {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir_all(folder.path().join("models/tex")).unwrap();
        fs::write(folder.path().join("models/m.obj"), MODEL).unwrap();
        fs::write(folder.path().join("models/m.mtl"), format!("newmtl m\n{library_line}\n")).unwrap();
        let image = Image::filled([2, 1], Rgb::WHITE);
        write_image(&folder.path().join("models/tex/a.png"), &image, &WriteOptions::default()).unwrap();
        folder
    }

    fn scene(models: &[&str], pictures: &[&str]) -> Scene {
        let object = |file: &&str| Object {
            name: format!("thing {file}"),
            shape: Shape::Mesh(Mesh { file: (*file).into(), ..Mesh::default() }),
            ..Object::default()
        };
        let texture = |file: &&str| Texture {
            name: format!("cover {file}"),
            source: TextureSource::Picture(PictureFile { file: (*file).into(), ..PictureFile::default() }),
            ..Texture::default()
        };
        Scene {
            objects: models.iter().map(object).chain([Object::default()]).collect(),
            textures: pictures.iter().map(texture).chain([Texture::default()]).collect(),
            ..Scene::default()
        }
    }

    #[test]
    fn everything_is_keyed_as_the_scene_writes_it_and_models_pictures_by_their_path() {
        let folder = folder("map_Kd tex/a.png");
        let scene = scene(&["models/m.obj", "models/m.obj"], &["models/tex/a.png"]);
        let (assets, warnings) = load_assets(&scene, folder.path()).unwrap();
        assert_eq!(warnings, [""; 0]);
        let mesh = &assets.meshes[Path::new("models/m.obj")];
        assert_eq!(mesh.materials[0].picture.as_deref(), Some(Path::new("models/tex/a.png")));
        assert_eq!(assets.pictures.len(), 1, "the texture's and the model's are one");
        assert_eq!(assets.pictures[Path::new("models/tex/a.png")].size, [2, 1]);
        for object in &scene.objects {
            assert!(object.shape.as_kind().geometry(&assets).is_some());
        }
        for texture in &scene.textures {
            assert!(texture.source.as_kind().pattern(&assets).is_some());
        }
    }

    #[test]
    fn a_lights_panorama_is_read_and_what_is_wrong_with_it_names_the_light() {
        let folder = folder("");
        let light = |file: &str| Light {
            name: "street".into(),
            source: LightSource::Environment(Environment { file: file.into(), ..Environment::default() }),
            ..Light::default()
        };
        let scene = |file: &str| Scene { lights: vec![light(file), Light::default()], ..Scene::default() };
        let (assets, warnings) = load_assets(&scene("models/tex/a.png"), folder.path()).unwrap();
        assert_eq!(warnings, [""; 0]);
        assert_eq!(assets.maps[Path::new("models/tex/a.png")].size, [2, 1]);
        for light in &scene("models/tex/a.png").lights {
            assert!(light.source.as_kind().emission(&assets).is_some());
            let is_panorama = light.source.as_kind().file().is_some();
            assert_eq!(light.source.as_kind().emission(&Assets::default()).is_none(), is_panorama);
        }
        let error = load_assets(&scene("models/m.obj"), folder.path()).unwrap_err().to_string();
        assert!(error.starts_with("light `street`: this is not an OpenEXR, HDR, PNG or JPEG"), "{error}");
    }

    #[test]
    fn a_models_picture_is_found_beside_it_too() {
        let folder = folder("map_Kd C:\\Users\\me\\a.png");
        fs::rename(folder.path().join("models/tex/a.png"), folder.path().join("models/a.png")).unwrap();
        let (assets, warnings) = load_assets(&scene(&["models/m.obj"], &[]), folder.path()).unwrap();
        assert_eq!(warnings, [""; 0]);
        let mesh = &assets.meshes[Path::new("models/m.obj")];
        assert_eq!(mesh.materials[0].picture.as_deref(), Some(Path::new("models/a.png")));
    }

    #[test]
    fn a_models_missing_picture_is_a_warning() {
        let folder = folder("map_Kd none.png");
        let (assets, warnings) = load_assets(&scene(&["models/m.obj"], &[]), folder.path()).unwrap();
        assert_eq!(assets.meshes[Path::new("models/m.obj")].materials[0].picture, None);
        let path = folder.path().join("models/none.png");
        let expected = format!(
            "material `m` of a model keeps its plain colour, there is no such file: {}",
            path.display()
        );
        assert_eq!(warnings, [expected]);
    }

    #[test]
    fn errors_say_who_wanted_the_file_and_its_whole_path() {
        let folder = folder("");
        let message = |scene: &Scene| load_assets(scene, folder.path()).unwrap_err().to_string();
        let full = |file: &str| folder.path().join(file).display().to_string();
        assert_eq!(
            message(&scene(&["none.obj"], &[])),
            format!("object `thing none.obj`: there is no such file: {}", full("none.obj"))
        );
        assert_eq!(
            message(&scene(&[], &["models/m.obj"])),
            format!(
                "texture `cover models/m.obj`: this is not a PNG or JPEG picture: {}",
                full("models/m.obj")
            )
        );
        assert_eq!(message(&scene(&[""], &[])), "object `thing `: `file` is empty");
        let model_as_picture = message(&scene(&["models/tex/a.png"], &[]));
        assert!(model_as_picture.contains("not that of a model"), "{model_as_picture}");
    }
}
