//! What can go wrong between a scene file and a picture.

use crate::formats::scene_file::SetError;
use crate::formats::{FormatError, SceneFileError};
use crate::render::{CompileError, RenderError};
use std::io;
use std::path::PathBuf;

/// Why loading, rendering or saving failed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The scene's text has errors.
    #[error(transparent)]
    Scene(#[from] Box<SceneFileError>),
    /// A file cannot be read or written.
    #[error(transparent)]
    Format(FormatError),
    /// An assignment does not fit the scene.
    #[error("{error}")]
    Set {
        /// The assignment as given.
        argument: String,
        /// What is wrong with it.
        error: SetError,
    },
    /// The scene cannot be made ready for rendering.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The picture is too large, or the region to render is not in it.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The file of a stopped render keeps another one than is asked for.
    #[error("the stopped render cannot go on, {reason}: {}", path.display())]
    OtherRender {
        /// The file.
        path: PathBuf,
        /// What differs.
        reason: String,
    },
    /// A file with other content stands where one was to be written.
    #[error("a different file is there already: {}", path.display())]
    InTheWay {
        /// The file.
        path: PathBuf,
    },
    /// A folder cannot be made.
    #[error("cannot make the folder ({source}): {}", path.display())]
    Folder {
        /// The folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

impl From<FormatError> for Error {
    fn from(error: FormatError) -> Self {
        match error {
            FormatError::Scene(error) => Self::Scene(error),
            error => Self::Format(error),
        }
    }
}
