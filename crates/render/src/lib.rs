//! From a scene to a picture: compile once, then trace rays over all threads.

mod job;

pub use job::{Cancel, CompileError, CompiledScene, Progress, RenderJob, RenderOptions, Rendered, compile};
