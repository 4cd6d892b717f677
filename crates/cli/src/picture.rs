//! Making one picture: compile, render, measure.

use crate::failure::Failure;
use crate::stopwatch::{Elapsed, Stopwatch};
use vitrine::render::{self, CompiledScene, RenderError};
use vitrine::{Cancel, Error, Progress, Project, Region, RenderJob, RenderOptions, Rendered};

/// What to say when there is nothing to keep.
pub const NOTHING_YET: &str = "Interrupted before the first part of the picture; nothing was written.";

/// A rendered picture and what it took.
#[derive(Debug)]
pub struct Made {
    /// The picture.
    pub rendered: Rendered,
    /// Wall and processor time of rendering, without reading and preparing.
    pub elapsed: Elapsed,
}

/// Makes a scene ready.
///
/// # Errors
/// When a part of it is missing.
pub fn compile(project: &Project) -> Result<CompiledScene, Failure> {
    Ok(render::compile(&project.scene, &project.assets).map_err(Error::from)?)
}

/// Renders the whole picture or a region.
///
/// # Errors
/// When the region is not in the picture.
pub fn make(
    compiled: &CompiledScene,
    options: RenderOptions,
    threads: usize,
    cancel: &Cancel,
    progress: &mut dyn FnMut(Progress),
) -> Result<Made, Failure> {
    let job = RenderJob::new(compiled, options).map_err(Error::from)?;
    let watch = Stopwatch::start();
    let rendered = job.run(threads, cancel, progress);
    Ok(Made { rendered, elapsed: watch.elapsed() })
}

/// Checks that a region lies in the project's picture.
///
/// # Errors
/// When it does not.
pub fn check_region(project: &Project, region: Option<Region>) -> Result<(), Failure> {
    match region {
        Some(region) => Ok(region
            .check_inside(project.scene.settings.size)
            .map_err(|e| Error::from(RenderError::from(e)))?),
        None => Ok(()),
    }
}
