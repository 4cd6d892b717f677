//! Where the program keeps its own files.

use directories::{ProjectDirs, UserDirs};
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
    /// Whether all is in one folder, the person's pictures and documents too.
    is_portable: bool,
}

impl Places {
    /// Those of this machine and person: the folder that `VITRINE_HOME` names, else the platform's own.
    #[must_use]
    pub fn of_this_person() -> Self {
        if let Some(home) = std::env::var_os(HOME_VARIABLE).filter(|home| !home.is_empty()) {
            return Self::inside(Path::new(&home));
        }
        match ProjectDirs::from("", "", "vitrine") {
            Some(folders) => Self {
                config: folders.config_dir().to_owned(),
                state: folders.state_dir().unwrap_or(folders.data_local_dir()).to_owned(),
                is_portable: false,
            },
            // A person without a home keeps things as long as the machine runs.
            None => Self::inside(&std::env::temp_dir().join("vitrine")),
        }
    }

    /// Everything in one folder.
    #[must_use]
    pub fn inside(folder: &Path) -> Self {
        Self { config: folder.to_owned(), state: folder.join("state"), is_portable: true }
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

    /// The folder in which a person looks for pictures: the platform's own, else the one in which the program was started.
    #[must_use]
    pub fn pictures_folder(&self) -> PathBuf {
        self.persons_folder(UserDirs::picture_dir)
    }

    /// The folder in which a person looks for documents, likewise.
    #[must_use]
    pub fn documents_folder(&self) -> PathBuf {
        self.persons_folder(UserDirs::document_dir)
    }

    fn persons_folder(&self, of: fn(&UserDirs) -> Option<&Path>) -> PathBuf {
        let dirs = (!self.is_portable).then(UserDirs::new).flatten();
        let own = dirs.as_ref().and_then(|d| of(d).filter(|f| f.is_dir()).or_else(|| Some(d.home_dir())));
        own.map_or_else(|| self.config.clone(), Path::to_owned)
    }

    /// The folder of scenes to recover.
    #[must_use]
    pub fn autosave_folder(&self) -> PathBuf {
        self.state.join("autosave")
    }
}
