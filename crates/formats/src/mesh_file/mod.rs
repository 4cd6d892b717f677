//! Model files. A new format is a file beside these and a line in the register below.

mod builder;
mod crossing;
mod lines;
pub mod mtl;
pub mod obj;
mod polygon;

use crate::FormatError;
use std::path::Path;
use vitrine_scene::TriangleMesh;

/// A model, and what a person should know about how it was read: one sentence each, with the path.
pub type Reading = (TriangleMesh, Vec<String>);

/// A format of model files.
#[derive(Clone, Copy, Debug)]
pub struct MeshFormat {
    /// Its name for people.
    pub name: &'static str,
    /// Its extensions in lower case, without the dot.
    pub extensions: &'static [&'static str],
    /// The reader.
    pub read: fn(&Path) -> Result<Reading, FormatError>,
}

/// The register of formats.
pub const MESH_FORMATS: &[MeshFormat] = &[obj::FORMAT];

/// Reads a model; the extension says in which format. The pictures of its materials are named relative to its folder
/// and not read.
///
/// # Errors
/// When the extension is unknown, the file cannot be read, or what it says is no model.
pub fn read_mesh(path: &Path) -> Result<Reading, FormatError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    let format = MESH_FORMATS.iter().find(|f| f.extensions.contains(&extension.as_str()));
    let format = format.ok_or_else(|| FormatError::UnknownExtension {
        path: path.into(),
        what: "a model",
        supported: crate::list_extensions(MESH_FORMATS.iter().flat_map(|f| f.extensions)),
    })?;
    (format.read)(path)
}
