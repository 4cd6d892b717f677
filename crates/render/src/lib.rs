//! From a scene to a picture: compile once, then trace rays over all threads.
//!
//! [`compile`] turns the scene that a person edits into flat arrays; [`accel`] finds what rays hit; the integrators say
//! what light a ray sees; [`RenderJob`] owns threads, order, progress and stopping.

pub mod accel;
mod compile;
mod error;
mod integrators;
mod job;
pub mod lights;
mod pick;
mod samplers;
mod surface;
pub mod threads;

pub use compile::{CompileOptions, CompiledScene, compile, compile_with, memory_limit};
pub use error::{CompileError, ModelFlaw, RenderError};
pub use job::{Cancel, Ending, Glance, Progress, RenderJob, RenderOptions, Rendered};
pub use pick::{NO_OBJECT, Picked};
