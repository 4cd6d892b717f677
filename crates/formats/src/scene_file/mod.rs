//! Scene files, `*.vitrine.toml`: read with every mistake underlined, written with the person's remarks kept.
//!
//! The frame of the file (sections, lists, `name`, `kind`) is known here; the keys in it come from the descriptions in
//! `vitrine-scene`. TOML itself is `toml_edit`'s business.

mod edit;
mod finding;
mod outline;
mod pairing;
mod print;
mod read;
mod reference;
mod schema;
mod section;
mod set;
mod syntax;
mod text;
mod value;
mod view;
mod wording;
mod write;

pub use finding::{Finding, SceneFileError};
pub use reference::reference_markdown;
pub use schema::schema;
pub use set::{SetError, set, split_values};
pub use write::print_new;

use crate::{FormatError, disc};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml_edit::Document;
use vitrine_scene::{Scene, Severity};

/// The most bytes of a scene file: some 160 000 objects. The parser needs 60 to 130 times as much memory.
pub const MAX_BYTES: u64 = 16 << 20;

/// A scene file: its text and the scene that it says.
#[derive(Clone, Debug)]
pub struct SceneFile {
    path: PathBuf,
    text: Arc<str>,
    scene: Scene,
    warnings: Vec<Finding>,
}

impl SceneFile {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read or is no text, and [`FormatError::Scene`] when it says something wrong.
    pub fn read(path: &Path) -> Result<Self, FormatError> {
        let bytes = disc::read(path, MAX_BYTES)?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let position = error.utf8_error().valid_up_to();
            FormatError::NotText { path: path.to_owned(), position, byte: error.as_bytes()[position] }
        })?;
        Ok(Self::parse(path, &text).map_err(Box::new)?)
    }

    /// Reads the text of a file. The path is for messages alone.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn parse(path: &Path, text: &str) -> Result<Self, SceneFileError> {
        let path = path.to_owned();
        let text: Arc<str> = text.into();
        let (scene, findings) = match Document::parse(&*text) {
            Ok(document) => read::read_scene(document.as_table(), &text),
            Err(error) => {
                let findings = vec![syntax::syntax_finding(&error, &text)];
                return Err(SceneFileError { path, text, findings, more: 0 });
            }
        };
        let (findings, more) = findings.into_parts();
        if findings.iter().any(|f| f.severity == Severity::Error) {
            return Err(SceneFileError { path, text, findings, more });
        }
        Ok(Self { path, text, scene, warnings: findings })
    }

    /// The scene that the file says.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene that the file says, without the file.
    #[must_use]
    pub fn into_scene(self) -> Scene {
        self.scene
    }

    /// Where the file is; paths in it are relative to its folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file's text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The file's text, changed so that it says this scene. Remarks, order and formatting of all that has not changed stay
    /// to the byte. Entries that were renamed, moved, added or removed are found out.
    #[must_use]
    pub fn print(&self, scene: &Scene) -> String {
        print::print(&self.text, &self.scene, scene)
    }

    /// What may not be as it was meant, such as a scene without light.
    #[must_use]
    pub fn warnings(&self) -> &[Finding] {
        &self.warnings
    }
}

#[cfg(test)]
mod tests;
