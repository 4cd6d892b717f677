//! Renders that were stopped or killed, and go on to the same picture.

mod keeper;
mod mark;

pub use keeper::StateKeeper;

use crate::formats::FormatError;
use crate::formats::state_file::{RenderState, part_of, read_state, write_state};
use crate::render::{Ending, Rendered};
use crate::{Error, Project, Region, VERSION};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The ending of names of state files, without the dot.
pub const STATE_EXTENSION: &str = "vitrine-state";

/// A file in which a render keeps how far it is.
#[derive(Clone, Debug, PartialEq)]
pub struct StateFile {
    path: PathBuf,
    /// What the render is of.
    scene: String,
    settings: String,
    region: Region,
}

impl StateFile {
    /// The file for a render of the whole picture or of a region.
    #[must_use]
    pub fn new(path: PathBuf, project: &Project, region: Option<Region>) -> Self {
        let settings = &project.scene.settings;
        Self {
            path,
            scene: mark::scene_mark(&project.scene, &project.assets),
            settings: mark::settings_text(settings),
            region: region.unwrap_or(Region::whole(settings.size)),
        }
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What the file keeps of this render, or None when there is no file.
    ///
    /// # Errors
    /// When the file cannot be read, is damaged, or keeps a render of another scene, of other settings or of another version. The
    /// settings of how long to render and how to show the picture may differ.
    pub fn load(&self) -> Result<Option<Rendered>, Error> {
        let state = match read_state(&self.path) {
            Err(FormatError::Missing { .. }) => return Ok(None),
            other => other?,
        };
        if state.program != program() {
            return Err(FormatError::StateOfOtherVersion { path: self.path.clone() }.into());
        }
        let reason = if state.scene != self.scene {
            Some("the scene, its models or its pictures have changed".to_owned())
        } else if state.film.region() != self.region {
            Some("it is of another part of the picture".to_owned())
        } else {
            mark::difference(&state.settings, &self.settings)
        };
        if let Some(reason) = reason {
            return Err(Error::OtherRender { path: self.path.clone(), reason });
        }
        Ok(Some(Rendered {
            film: state.film,
            ending: Ending::Unfinished,
            rays: state.rays,
            bad_samples: state.bad_samples,
            noise: None,
            spent: Duration::from_millis(state.spent_ms),
        }))
    }

    /// Keeps how far the render is. The file is complete or as it was before.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn save(&self, rendered: Rendered) -> Result<(), Error> {
        let state = RenderState {
            program: program(),
            scene: self.scene.clone(),
            settings: self.settings.clone(),
            rays: rendered.rays,
            bad_samples: rendered.bad_samples,
            spent_ms: rendered.spent.as_millis() as u64,
            film: rendered.film,
        };
        Ok(write_state(&self.path, &state)?)
    }

    /// Removes it, once the picture is finished; nothing happens where there is none.
    pub fn remove(&self) {
        // What cannot be removed does no harm: the next render of the picture refuses it or replaces it.
        let _ = std::fs::remove_file(&self.path);
        // A render that was killed while it wrote has left its part.
        let _ = std::fs::remove_file(part_of(&self.path));
    }
}

fn program() -> String {
    format!("Vitrine {VERSION}")
}

#[cfg(test)]
mod tests;
