//! Vitrine: load a scene, render it, save the picture.
//!
//! ```
//! # let folder = tempfile::tempdir()?;
//! # let path = folder.path().join("ball.vitrine.toml");
//! std::fs::write(
//!     &path,
//!     r##"
//!     format = 1
//!     [settings]
//!     size = [80, 60]
//!     [camera]
//!     position = [0.0, 1.0, 5.0]
//!     [[light]]
//!     name = "lamp"
//!     kind = "point"
//!     position = [2.0, 4.0, 3.0]
//!     [[object]]
//!     name = "ball"
//!     shape = "sphere"
//!     position = [0.0, 1.0, 0.0]
//!     "##,
//! )?;
//!
//! let mut project = vitrine::load(&path)?;
//! project.set(&["object.ball.radius=1.5", "settings.samples=4"])?;
//! let picture = vitrine::render(&project, 2)?;
//! vitrine::save(&project, &picture, path.with_file_name("ball.png"))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`load`] reads a scene file with its models and textures, [`render`](render()) makes the picture on so many threads,
//! [`save`] writes PNG, JPEG, OpenEXR or Radiance HDR by the file's extension. Whoever needs more (progress, stopping,
//! regions) compiles the scene and runs a [`RenderJob`] from [`mod@render`]. The parts of Vitrine are re-exported as modules.

mod display;
mod error;
mod hash;
mod layers;
mod project;
mod resume;
pub mod summary;
pub mod templates;

pub use display::{display_of, without_display};
pub use error::Error;
pub use hash::SceneHash;
pub use layers::layers_of;
pub use project::{Project, load, metadata_of};
pub use resume::{STATE_EXTENSION, StateFile, StateKeeper};
pub use vitrine_denoise as denoise;
pub use vitrine_film as film;
pub use vitrine_formats as formats;
pub use vitrine_math as math;
pub use vitrine_measure as measure;
pub use vitrine_render as render;
pub use vitrine_scene as scene;

pub use film::{Image, Region};
pub use formats::WriteOptions;
pub use render::{Cancel, Ending, Progress, RenderJob, RenderOptions, Rendered};
pub use scene::Scene;

use std::path::Path;

/// Vitrine's version.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Renders the whole picture as the scene's settings say, on so many threads (0: all of the machine's). The picture does
/// not depend on their number.
///
/// # Errors
/// When the scene cannot be made ready, for instance because a model was not loaded.
pub fn render(project: &Project, threads: usize) -> Result<Rendered, Error> {
    let compiled = render::compile(&project.scene, &project.assets)?;
    let job = RenderJob::new(&compiled, project.options())?;
    Ok(job.run(threads, &Cancel::default(), &mut |_| {}))
}

/// Writes a rendered picture, as PNG, JPEG, OpenEXR or Radiance HDR by the extension, shown as the scene's settings say, with the
/// scene's mark, seed and samples in its metadata. The file is complete or as it was before.
///
/// # Errors
/// When the extension is unknown or the file cannot be written.
pub fn save(project: &Project, picture: &Rendered, path: impl AsRef<Path>) -> Result<(), Error> {
    let metadata = project.metadata(&project.scene.settings);
    let display = display_of(&project.scene.settings);
    let options = WriteOptions { metadata, display, ..WriteOptions::default() };
    Ok(formats::write_image(path.as_ref(), &picture.film.image(), &options)?)
}
