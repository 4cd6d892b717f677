//! Scene, model and picture files: the only crate that touches the disc.

mod disc;
mod error;
pub mod mesh_file;

pub use error::FormatError;
pub use mesh_file::read_mesh;

/// Extensions for a message: ".png, .jpg, .jpeg".
fn list_extensions<'a>(extensions: impl Iterator<Item = &'a &'a str>) -> String {
    extensions.map(|e| format!(".{e}")).collect::<Vec<_>>().join(", ")
}
