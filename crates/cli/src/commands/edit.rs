//! `vitrine edit`, and `vitrine` alone: the window.

use crate::failure::{Exit, Failure};
use crate::report::Report;
use clap::Args;
use std::path::PathBuf;
use vitrine_editor::LaunchError;

/// Open the window, to build a scene and watch it being ray-traced
///
/// `vitrine` without a command does the same.
#[derive(Args, Debug, Default)]
#[command(after_help = "Examples:\n  \
    vitrine edit\n  \
    vitrine edit ball.vitrine.toml")]
pub struct Edit {
    /// The scene to open; without it, a choice of scenes to begin with
    scene: Option<PathBuf>,
}

impl Edit {
    /// Runs the command until the window is closed.
    pub fn run(self) -> Result<Exit, Failure> {
        match vitrine_editor::run(self.scene) {
            Ok(()) => Ok(Exit::Done),
            Err(error @ LaunchError::NoWindow { .. }) => Err(Failure::new(
                Exit::Failed,
                Report::error(error.to_string()).with_help(
                    "the window needs a display with OpenGL; without one, `vitrine render SCENE.vitrine.toml` makes \
                     pictures and `vitrine templates` lists scenes to begin with",
                ),
            )),
        }
    }
}
