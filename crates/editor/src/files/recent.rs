//! The scenes that were open lately.

use super::own_file;
use super::places::Places;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use vitrine::formats::FormatError;

/// A scene that was open lately.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RecentFile {
    /// The scene's file.
    pub path: PathBuf,
    /// When it was opened or saved, in seconds since 1970.
    #[serde(default)]
    seconds: u64,
}

impl RecentFile {
    /// When it was opened or saved.
    #[must_use]
    pub fn when(&self) -> SystemTime {
        UNIX_EPOCH + Duration::from_secs(self.seconds)
    }
}

/// The scenes that were open lately, the last one first.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Recent {
    file: Vec<RecentFile>,
}

impl Recent {
    /// The most that are kept.
    pub const MOST: usize = 12;

    /// Reads the list and leaves out what is no longer there. A broken list is an empty one.
    #[must_use]
    pub fn load(places: &Places) -> Self {
        let (mut recent, _): (Self, _) = own_file::read(&places.recent_file());
        recent.file.retain(|f| f.path.is_file());
        recent.file.truncate(Self::MOST);
        recent
    }

    /// Writes the list.
    ///
    /// # Errors
    /// When the file or its folder cannot be written.
    pub fn save(&self, places: &Places) -> Result<(), FormatError> {
        own_file::write(&places.recent_file(), self)
    }

    /// Puts a scene on top that has been opened or saved.
    pub fn add(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.remove(&path);
        let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
        self.file.insert(0, RecentFile { path, seconds });
        self.file.truncate(Self::MOST);
    }

    /// Forgets a scene.
    pub fn remove(&mut self, path: &Path) {
        self.file.retain(|f| f.path != path);
    }

    /// The scenes, the last one first.
    #[must_use]
    pub fn files(&self) -> &[RecentFile] {
        &self.file
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn the_last_one_comes_first_and_twelve_are_kept() {
        let home = tempfile::tempdir().unwrap();
        let mut recent = Recent::default();
        let paths: Vec<_> = (0..14).map(|i| home.path().join(format!("{i}.vitrine.toml"))).collect();
        for path in &paths {
            fs::write(path, "format = 1\n").unwrap();
            recent.add(path);
        }
        recent.add(&paths[5]);
        let listed: Vec<_> = recent.files().iter().map(|f| f.path.clone()).collect();
        assert_eq!(listed.len(), 12);
        assert_eq!((&listed[0], &listed[1]), (&paths[5], &paths[13]));
        assert_eq!(listed.iter().filter(|p| **p == paths[5]).count(), 1);

        let places = Places::inside(home.path());
        recent.save(&places).unwrap();
        assert_eq!(Recent::load(&places), recent);
        fs::remove_file(&paths[5]).unwrap();
        assert_eq!(Recent::load(&places).files()[0].path, paths[13], "what is gone is left out");
    }

    #[test]
    fn a_broken_list_is_empty() {
        let home = tempfile::tempdir().unwrap();
        let places = Places::inside(home.path());
        fs::create_dir_all(places.recent_file().parent().unwrap()).unwrap();
        fs::write(places.recent_file(), "file = 7").unwrap();
        assert_eq!(Recent::load(&places), Recent::default());
    }
}
