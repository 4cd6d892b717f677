//! Tests of the whole of scene files.

mod bad_input;
mod dice;
mod documenting;
mod printing;
mod reading;
mod setting;
mod size;

use super::{SceneFile, SceneFileError};
use std::path::Path;

/// The example file that the format was agreed on; its keys are a contract.
const EXAMPLE: &str = include_str!("../example.vitrine.toml");

fn parse(text: &str) -> Result<SceneFile, SceneFileError> {
    SceneFile::parse(Path::new("test.vitrine.toml"), text)
}

/// A file that is right, with these lines after what every file needs.
fn with(lines: &str) -> String {
    format!("format = 1\n{lines}\n")
}
