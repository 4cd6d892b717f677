//! `vitrine schema`: the scene file's JSON Schema, for editors.

use crate::console;
use crate::failure::{Exit, Failure};
use clap::Args;

/// Print the JSON Schema of scene files
///
/// Editors that know TOML complete and check a scene while one types when the file's first line points to the schema,
/// such as `#:schema vitrine.schema.json`.
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  vitrine schema > vitrine.schema.json")]
pub struct Schema {}

impl Schema {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        console::print(format!("{:#}\n", vitrine::formats::scene_file::schema()))?;
        Ok(Exit::Done)
    }
}
