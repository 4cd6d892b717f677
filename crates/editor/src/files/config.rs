//! The settings of the program, which are the person's and not the scene's.

use super::own_file::{self, OwnFileWarning};
use super::places::Places;
use crate::text::Language;
use serde::{Deserialize, Serialize};
use vitrine::formats::FormatError;

/// The settings of the program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Config {
    /// The language of the window.
    pub language: Language,
    /// How many threads compute the picture; 0: all of the machine's.
    pub threads: usize,
    /// Larger letters.
    pub large_text: bool,
    /// Stronger contrast.
    pub high_contrast: bool,
    /// Whether the guided tour has been seen or dismissed.
    pub tour_seen: bool,
}

impl Config {
    /// Reads the settings. A broken file is set aside with a warning, and the defaults hold.
    #[must_use]
    pub fn load(places: &Places) -> (Self, Option<OwnFileWarning>) {
        own_file::read(&places.config_file())
    }

    /// Writes the settings.
    ///
    /// # Errors
    /// When the file or its folder cannot be written.
    pub fn save(&self, places: &Places) -> Result<(), FormatError> {
        own_file::write(&places.config_file(), self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn settings_survive_and_a_first_start_has_the_defaults() {
        let home = tempfile::tempdir().unwrap();
        let places = Places::inside(&home.path().join("new"));
        assert_eq!(Config::load(&places), (Config::default(), None));
        let config =
            Config { language: Language::Russian, threads: 3, large_text: true, ..Config::default() };
        config.save(&places).unwrap();
        assert_eq!(Config::load(&places), (config, None));
    }

    #[test]
    fn a_broken_file_is_set_aside_with_a_warning() {
        let home = tempfile::tempdir().unwrap();
        let places = Places::inside(home.path());
        for bad in [&b"language = \"klingon\""[..], b"threads = -1", b"[[[", b"\xff\xfe\x00"] {
            fs::write(places.config_file(), bad).unwrap();
            let (config, warning) = Config::load(&places);
            assert_eq!(config, Config::default());
            let warning = warning.unwrap();
            assert!(!warning.reason.is_empty() && !warning.reason.contains('\n'), "{warning}");
            assert_eq!(fs::read(warning.set_aside.unwrap()).unwrap(), bad);
            assert!(!places.config_file().exists());
        }
    }

    #[test]
    fn settings_of_a_later_version_are_read_as_far_as_they_are_known() {
        let home = tempfile::tempdir().unwrap();
        let places = Places::inside(home.path());
        fs::write(places.config_file(), "threads = 2\nholograms = true\n").unwrap();
        assert_eq!(Config::load(&places).0, Config { threads: 2, ..Config::default() });
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_an_error() {
        let home = tempfile::tempdir().unwrap();
        let file = home.path().join("file");
        fs::write(&file, "").unwrap();
        assert!(Config::default().save(&Places::inside(&file)).is_err());
    }
}
