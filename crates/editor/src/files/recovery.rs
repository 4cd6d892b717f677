//! Recovery: scenes of windows that did not end as they should.

use super::open::{Opened, Seen};
use super::own_file;
use super::places::Places;
use super::problem::OpenError;
use crate::library::ThumbnailImage;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use vitrine::formats::FormatError;

/// The files of one window.
pub(super) struct WindowFiles {
    pub scene: PathBuf,
    pub picture: PathBuf,
    pub lock: PathBuf,
}

/// The files of the window of that name.
pub(super) fn paths(stem: &Path) -> WindowFiles {
    let with = |extension: &str| stem.with_extension(extension);
    WindowFiles { scene: with("toml"), picture: with("png"), lock: with("lock") }
}

/// What is written of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct Stored {
    pub title: String,
    pub path: Option<PathBuf>,
    pub folder: Option<PathBuf>,
    pub seen: Option<String>,
    /// Since 1970.
    pub seconds: u64,
    pub text: String,
}

impl Stored {
    /// Writes it, and the small picture.
    pub(super) fn write(&self, stem: &Path, thumbnail: Option<&ThumbnailImage>) -> Result<(), FormatError> {
        let files = paths(stem);
        own_file::write(&files.scene, self)?;
        match thumbnail.and_then(|image| image.to_png().ok()) {
            Some(bytes) => vitrine::formats::write_atomically(&files.picture, &bytes),
            None => Ok(()),
        }
    }
}

/// A scene that can be recovered. While this value lives, no other window offers it.
#[derive(Debug)]
pub struct Recovery {
    /// What its window called it.
    pub title: String,
    /// The scene's file; None when it had none yet.
    pub path: Option<PathBuf>,
    /// When it was written.
    pub when: SystemTime,
    /// What it showed.
    pub thumbnail: Option<ThumbnailImage>,
    stored: Stored,
    stem: PathBuf,
    /// Held meanwhile; None where the lock's file is gone.
    lock: Option<File>,
}

impl Recovery {
    /// Reads the scene with its models and pictures, as a scene that differs from its file.
    ///
    /// # Errors
    /// When its text is broken, or names a file that cannot be read.
    pub fn open(&self) -> Result<Opened, OpenError> {
        let name = self.path.clone().unwrap_or_else(|| PathBuf::from(format!("{}.vitrine.toml", self.title)));
        let opened = Opened::from_text(&name, &self.stored.text, self.stored.folder.as_deref())?;
        let seen = self.stored.seen.clone().map(Seen::from_text);
        Ok(Opened { path: self.path.clone(), seen, ..opened })
    }

    /// The folder that the scene's paths count from.
    #[must_use]
    pub fn folder(&self) -> Option<&Path> {
        self.stored.folder.as_deref()
    }

    /// Removes it for good.
    pub fn discard(self) {
        let files = paths(&self.stem);
        for file in [files.scene, files.picture, files.lock] {
            // What is gone already needs no removing.
            let _ = fs::remove_file(file);
        }
        drop(self.lock);
    }
}

/// Scenes of windows that did not end as they should, the newest first. Broken files are set aside.
#[must_use]
pub fn recoverable(places: &Places) -> Vec<Recovery> {
    let Ok(entries) = fs::read_dir(places.autosave_folder()) else { return Vec::new() };
    let files = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let (scenes, others): (Vec<_>, Vec<_>) =
        files.partition(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let mut found: Vec<_> = scenes.iter().filter_map(|path| recover(path)).collect();
    // A window that had nothing to lose leaves its lock when it is killed.
    for path in others.iter().filter(|path| path.extension().is_some_and(|e| e == "lock")) {
        if !path.with_extension("toml").is_file() && File::open(path).is_ok_and(|f| f.try_lock().is_ok()) {
            let _ = fs::remove_file(path);
        }
    }
    found.sort_by_key(|recovery| std::cmp::Reverse(recovery.when));
    found
}

/// None when the window lives, or the file is broken.
fn recover(scene: &Path) -> Option<Recovery> {
    let stem = scene.with_extension("");
    let files = paths(&stem);
    let lock = match File::options().read(true).write(true).open(&files.lock) {
        Ok(file) => {
            file.try_lock().ok()?;
            Some(file)
        }
        Err(_) => None,
    };
    let (stored, warning): (Stored, _) = own_file::read(scene);
    if warning.is_some() || stored.text.is_empty() {
        return None;
    }
    Some(Recovery {
        title: stored.title.clone(),
        path: stored.path.clone(),
        when: UNIX_EPOCH + Duration::from_secs(stored.seconds),
        thumbnail: ThumbnailImage::read_png(&files.picture),
        stored,
        stem,
        lock,
    })
}
