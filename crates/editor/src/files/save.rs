//! Saving a scene: the text with the person's remarks, what it names beside it, the version before it as `.bak`.

use super::open::Seen;
use super::relative::path_in_scene;
use super::wording;
use crate::library::carried;
use crate::tr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::scene_file::print_new;
use vitrine::formats::{FormatError, SceneFile, SceneFileError, write_atomically};
use vitrine::scene::{Assets, ListName, Owner, ParamKind, Scene, Value};

/// What is to be saved, and where.
#[derive(Clone, Debug)]
pub struct SaveRequest {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The models and pictures that it names.
    pub assets: Arc<Assets>,
    /// The file that it was read from, for its remarks; None for one that was begun from nothing.
    pub base: Option<SceneFile>,
    /// The folder that its paths count from; None while it has no file.
    pub folder: Option<PathBuf>,
    /// The file to write.
    pub to: PathBuf,
    /// What that file said last. With it, a change by another program is an error; None overwrites.
    pub seen: Option<Seen>,
}

/// A scene that has been saved. Its paths may read otherwise than before.
#[derive(Debug)]
pub struct Saved {
    /// The file as it is now, with the scene that it says.
    pub file: SceneFile,
    /// The models and pictures, by their new paths and by their old ones, which steps of the history still name.
    pub assets: Assets,
    /// What the file says now.
    pub seen: Seen,
    /// Paths that have changed: before and after.
    pub moved: Vec<(String, String)>,
}

/// Why a scene was not saved. What was there is as it was.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// Another program has changed the file since it was read or written.
    #[error("another program has changed the file: {}", path.display())]
    ChangedOnDisc {
        /// The file.
        path: PathBuf,
    },
    /// The scene says something that could not be read again.
    #[error("the scene cannot be saved as it is: {0}")]
    Unsound(Box<SceneFileError>),
    /// A file cannot be written.
    #[error(transparent)]
    Format(#[from] FormatError),
}

impl SaveError {
    /// The message and how to mend it, in the current language.
    #[must_use]
    pub fn words(&self) -> (String, String) {
        match self {
            Self::ChangedOnDisc { path } => (
                tr!("files-changed-on-disc", path = path.display().to_string()),
                tr!("files-changed-on-disc.help"),
            ),
            Self::Unsound(error) => {
                let first = error.findings.first();
                let [reason, help] = first.map(|f| [f.message.clone(), f.help.clone()]).unwrap_or_default();
                (tr!("files-unsound", reason = reason), help)
            }
            Self::Format(error) => wording::describe(error),
        }
    }
}

/// Saves a scene. May take a while.
///
/// # Errors
/// [`SaveError`]; then the scene's file is as it was.
pub fn save(request: &SaveRequest) -> Result<Saved, SaveError> {
    let to = std::path::absolute(&request.to).unwrap_or_else(|_| request.to.clone());
    let folder = to.parent().unwrap_or(Path::new(""));
    let mut scene = Scene::clone(&request.scene);
    let (moved, beside) = settle_paths(&mut scene, request.folder.as_deref(), folder);
    let text = request.base.as_ref().map_or_else(|| print_new(&scene), |base| base.print(&scene));
    let file = SceneFile::parse(&to, &text).map_err(|e| SaveError::Unsound(Box::new(e)))?;
    if request.seen.as_ref().is_some_and(|seen| seen.differs_from(&to)) {
        return Err(SaveError::ChangedOnDisc { path: to });
    }
    for (path, bytes) in beside {
        if let Some(parent) = path.parent() {
            let unwritable = |cause: io::Error| FormatError::Unwritable { path: parent.to_owned(), cause };
            fs::create_dir_all(parent).map_err(unwritable)?;
        }
        write_atomically(&path, bytes)?;
    }
    keep_backup(&to, &text)?;
    write_atomically(&to, text.as_bytes())?;
    let mut assets = Assets::clone(&request.assets);
    for (before, after) in &moved {
        let [before, after] = [before, after].map(Path::new);
        if let Some(model) = assets.meshes.get(before).cloned() {
            assets.meshes.insert(after.to_owned(), model);
        }
        if let Some(picture) = assets.pictures.get(before).cloned() {
            assets.pictures.insert(after.to_owned(), picture);
        }
        if let Some(map) = assets.maps.get(before).cloned() {
            assets.maps.insert(after.to_owned(), map);
        }
    }
    Ok(Saved { seen: Seen::of(&text), file, assets, moved })
}

/// Paths before and after, and files to write with their bytes.
type Settled = (Vec<(String, String)>, Vec<(PathBuf, &'static [u8])>);

/// Makes the scene's paths count from its new folder.
fn settle_paths(scene: &mut Scene, from: Option<&Path>, to: &Path) -> Settled {
    let (mut moved, mut beside) = (Vec::new(), Vec::new());
    for (owner, key, file) in named_files(scene) {
        let source = from.unwrap_or(Path::new("")).join(&file);
        let after = if source.is_absolute() && source.is_file() {
            path_in_scene(&source, Some(to))
        } else if let Some(bytes) = carried(Path::new(&file)) {
            let name = free_name(&file, bytes, to);
            if !to.join(&name).is_file() {
                beside.push((to.join(&name), bytes));
            }
            name
        } else {
            continue;
        };
        let is_path = |text: &str| Path::new(text) == Path::new(&file);
        if !is_path(&after) && scene.set(owner, key, Value::Text(after.clone())).is_ok() {
            moved.push((file, after));
        }
    }
    moved.dedup();
    (moved, beside)
}

/// Every file that the scene names: whose, under which key, and the path.
fn named_files(scene: &Scene) -> Vec<(Owner, &'static str, String)> {
    let of_list = |list: ListName| (0..scene.names(list).count()).map(move |i| Owner::Item(list, i));
    let owners = ListName::ALL.into_iter().flat_map(of_list);
    let mut files = Vec::new();
    for owner in owners {
        for spec in scene.specs(owner).into_iter().filter(|s| s.kind == ParamKind::File) {
            if let Some(Value::Text(file)) = scene.value(owner, spec.name) {
                files.push((owner, spec.name, file));
            }
        }
    }
    files
}

/// The name under which a file of the program lies or can lie in a folder: its own unless a different file has it.
fn free_name(file: &str, bytes: &[u8], folder: &Path) -> String {
    let fits = |name: &str| fs::read(folder.join(name)).map_or(true, |there| there == bytes);
    let (stem, extension) = file.rsplit_once('.').unwrap_or((file, ""));
    let numbered = (2..100).map(|n| format!("{stem}-{n}.{extension}"));
    std::iter::once(file.to_owned())
        .chain(numbered)
        .find(|name| fits(name))
        .unwrap_or_else(|| file.to_owned())
}

/// Keeps what the file says so far as `*.bak`, unless it says the same.
fn keep_backup(path: &Path, text: &str) -> Result<(), FormatError> {
    let Ok(before) = fs::read(path) else { return Ok(()) };
    if before == text.as_bytes() {
        return Ok(());
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".bak");
    write_atomically(&path.with_file_name(name), &before)
}

#[cfg(test)]
#[path = "save_tests.rs"]
mod tests;
