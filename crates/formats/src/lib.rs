//! Scene, model and picture files: the only crate that touches the disc.

mod error;

pub use error::FormatError;
