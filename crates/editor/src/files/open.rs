//! Opening: scenes, templates, models, pictures, each with all that belongs to it. Everything here may take a while and is
//! meant for a [`Task`](super::Task).

use super::problem::OpenError;
use super::relative::path_in_scene;
use crate::library::{add_carried, carried};
use std::fs;
use std::path::{Path, PathBuf};
use vitrine::SceneHash;
use vitrine::formats::{FormatError, SceneFile, load_assets};
use vitrine::scene::lights::Environment;
use vitrine::scene::shapes::Mesh;
use vitrine::scene::textures::PictureFile;
use vitrine::scene::{Assets, Light, LightSource, Object, Scene, Shape, Texture, TextureSource};
use vitrine::templates::Template;

/// What a file said when it was read or written last, so that a change by another program is noticed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Seen(String);

impl Seen {
    /// A text that was read or written.
    #[must_use]
    pub fn of(text: &str) -> Self {
        Self(SceneHash::of(text).to_string())
    }

    /// Whether the file says something else now. A file that is gone does not.
    #[must_use]
    pub fn differs_from(&self, path: &Path) -> bool {
        fs::read(path).is_ok_and(|bytes| {
            String::from_utf8(bytes).map_or(true, |text| SceneHash::of(&text).to_string() != self.0)
        })
    }

    pub(super) fn as_text(&self) -> &str {
        &self.0
    }

    pub(super) const fn from_text(text: String) -> Self {
        Self(text)
    }
}

/// A scene that has been opened.
#[derive(Debug)]
pub struct Opened {
    /// Its text and what it says.
    pub file: SceneFile,
    /// The models and pictures that it names.
    pub assets: Assets,
    /// What should be known of the models and pictures: one sentence each.
    pub notes: Vec<String>,
    /// The scene's file; None when it has none yet.
    pub path: Option<PathBuf>,
    /// What that file said.
    pub seen: Option<Seen>,
}

impl Opened {
    /// A text that was not read from where it belongs, such as a template. `folder` is the one that its paths count from.
    ///
    /// # Errors
    /// When the text says something wrong, or names a file that cannot be read.
    pub(super) fn from_text(name: &Path, text: &str, folder: Option<&Path>) -> Result<Self, OpenError> {
        let parsed = SceneFile::parse(name, text);
        let file = parsed.map_err(|e| OpenError::of(name, FormatError::Scene(Box::new(e))))?;
        let mut assets = Assets::default();
        let notes = complete_assets(&mut assets, file.scene(), folder)
            .map_err(|cause| OpenError::of_asset(name, cause, file.text()))?;
        Ok(Self { file, assets, notes, path: None, seen: None })
    }
}

/// Reads a scene with its models and pictures.
///
/// # Errors
/// When it cannot be read, says something wrong, or names a file that cannot be read.
pub fn read_scene(path: &Path) -> Result<Opened, OpenError> {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let file = SceneFile::read(&path).map_err(|cause| OpenError::of(&path, cause))?;
    let opened = Opened::from_text(&path, file.text(), path.parent())?;
    let seen = Some(Seen::of(file.text()));
    Ok(Opened { path: Some(path), seen, ..opened })
}

/// A template as a new scene.
///
/// # Errors
/// When there is no template of that name.
pub fn read_template(name: &str) -> Result<Opened, OpenError> {
    let path = PathBuf::from(format!("{name}.vitrine.toml"));
    let Some(template) = Template::find(name) else {
        return Err(OpenError::of(&path, FormatError::Missing { path: path.clone() }));
    };
    Opened::from_text(&path, template.text(), None)
}

/// Adds to the assets what the scene names and they lack: files of its folder, else files that the program carries. To be
/// called whenever an edit may have named a file. Gives what should be known of them, one sentence each.
///
/// # Errors
/// The first file that cannot be read; the others may have been added.
pub fn complete_assets(
    assets: &mut Assets,
    scene: &Scene,
    folder: Option<&Path>,
) -> Result<Vec<String>, FormatError> {
    let folder = folder.unwrap_or(Path::new(""));
    let is_own = |file: &Path| carried(file).is_some() && !folder.join(file).is_file();
    let missing = |file: Option<&Path>, there: bool| file.is_some_and(|f| !there && !is_own(f));
    let mut wanted = Scene::default();
    for texture in &scene.textures {
        let file = texture.source.as_kind().file();
        if missing(file, file.is_some_and(|f| assets.pictures.contains_key(f))) {
            wanted.textures.push(texture.clone());
        }
    }
    for object in &scene.objects {
        let file = object.shape.as_kind().file();
        if missing(file, file.is_some_and(|f| assets.meshes.contains_key(f))) {
            wanted.objects.push(object.clone());
        }
    }
    for light in &scene.lights {
        let file = light.source.as_kind().file();
        if missing(file, file.is_some_and(|f| assets.maps.contains_key(f))) {
            wanted.lights.push(light.clone());
        }
    }
    let (read, notes) = load_assets(&wanted, folder)?;
    assets.meshes.extend(read.meshes);
    assets.pictures.extend(read.pictures);
    assets.maps.extend(read.maps);
    add_carried(assets, scene);
    Ok(notes)
}

/// A model, picture or panorama that is to come into a scene.
#[derive(Debug)]
pub struct NewAsset {
    /// Its path as the scene is to write it.
    pub file: String,
    /// The model, picture or panorama under that path, and a model's own pictures.
    pub assets: Assets,
    /// What should be known of it: one sentence each.
    pub notes: Vec<String>,
}

/// Reads a model for a scene whose paths count from `folder`; None: a scene without a file.
///
/// # Errors
/// When it cannot be read or is no model.
pub fn read_model(path: &Path, folder: Option<&Path>) -> Result<NewAsset, OpenError> {
    let file = path_in_scene(path, folder);
    let shape = Shape::Mesh(Mesh { file: file.clone(), ..Mesh::default() });
    let scene = Scene { objects: vec![Object { shape, ..Object::default() }], ..Scene::default() };
    read_asset(path, file, &scene, folder)
}

/// Reads a picture for a scene whose paths count from `folder`; None: a scene without a file.
///
/// # Errors
/// When it cannot be read or is no picture.
pub fn read_picture(path: &Path, folder: Option<&Path>) -> Result<NewAsset, OpenError> {
    let file = path_in_scene(path, folder);
    let source = TextureSource::Picture(PictureFile { file: file.clone(), ..PictureFile::default() });
    let scene = Scene { textures: vec![Texture { source, ..Texture::default() }], ..Scene::default() };
    read_asset(path, file, &scene, folder)
}

/// Reads a panorama for a scene whose paths count from `folder`; None: a scene without a file.
///
/// # Errors
/// When it cannot be read or is no picture.
pub fn read_panorama(path: &Path, folder: Option<&Path>) -> Result<NewAsset, OpenError> {
    let file = path_in_scene(path, folder);
    let source = LightSource::Environment(Environment { file: file.clone(), ..Environment::default() });
    let scene = Scene { lights: vec![Light { source, ..Light::default() }], ..Scene::default() };
    read_asset(path, file, &scene, folder)
}

fn read_asset(
    path: &Path,
    file: String,
    scene: &Scene,
    folder: Option<&Path>,
) -> Result<NewAsset, OpenError> {
    match load_assets(scene, folder.unwrap_or(Path::new(""))) {
        Ok((assets, notes)) => Ok(NewAsset { file, assets, notes }),
        // Whoever adds a file knows which; the scene's word for it says nothing new.
        Err(FormatError::Asset { cause, .. }) => Err(OpenError::of(path, *cause)),
        Err(cause) => Err(OpenError::of(path, cause)),
    }
}

#[cfg(test)]
#[path = "open_tests.rs"]
mod tests;
