//! Where the program keeps its own files.

use directories::ProjectDirs;
use std::path::{Path, PathBuf};

/// The variable of the environment that names one folder for all of it: portable installations, tests.
pub const HOME_VARIABLE: &str = "VITRINE_HOME";

/// The folders in which the program keeps its own files. They need not exist yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Places {
    /// Settings.
    config: PathBuf,
    /// What can be lost: recent files, scenes to recover.
    state: PathBuf,
}

impl Places {
    /// Those of this machine and person: the folder that `VITRINE_HOME` names, else the platform's own.
    #[must_use]
    pub fn of_machine() -> Self {
        if let Some(home) = std::env::var_os(HOME_VARIABLE).filter(|home| !home.is_empty()) {
            return Self::inside(Path::new(&home));
        }
        match ProjectDirs::from("", "", "vitrine") {
            Some(folders) => Self {
                config: folders.config_dir().to_owned(),
                state: folders.state_dir().unwrap_or(folders.data_local_dir()).to_owned(),
            },
            // A person without a home keeps things as long as the machine runs.
            None => Self::inside(&std::env::temp_dir().join("vitrine")),
        }
    }

    /// Everything in one folder.
    #[must_use]
    pub fn inside(folder: &Path) -> Self {
        Self { config: folder.to_owned(), state: folder.join("state") }
    }

    /// The file of the settings.
    #[must_use]
    pub fn config_file(&self) -> PathBuf {
        self.config.join("config.toml")
    }

    /// The file of the list of recent files.
    #[must_use]
    pub fn recent_file(&self) -> PathBuf {
        self.state.join("recent.toml")
    }

    /// The folder of scenes to recover.
    #[must_use]
    pub fn autosave_folder(&self) -> PathBuf {
        self.state.join("autosave")
    }
}
