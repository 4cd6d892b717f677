//! Scene, model and picture files: the only crate that touches the disc.

mod assets;
mod atomic;
mod disc;
mod error;
pub mod image_file;
pub mod mesh_file;
pub mod scene_file;
pub mod state_file;

pub use assets::load_assets;
pub use atomic::{folder_of, write_atomically};
pub use error::FormatError;
pub use image_file::{
    BitDepth, ExrFeatures, ExrLayers, IMAGE_FORMATS, ImageFormat, WriteOptions, encode, image_format,
    read_exr_features, read_panorama, read_picture, write_image, write_layers,
};
pub use mesh_file::{MESH_FORMATS, read_mesh};
pub use scene_file::{Finding, SceneFile, SceneFileError};
pub use state_file::{RenderState, read_state, write_state};

/// Extensions for a message: ".png, .jpg, .jpeg".
fn list_extensions<'a>(extensions: impl Iterator<Item = &'a &'a str>) -> String {
    extensions.map(|e| format!(".{e}")).collect::<Vec<_>>().join(", ")
}
