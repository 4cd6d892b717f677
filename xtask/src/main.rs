//! The project's own chores, `cargo xtask …`: the layer check, the files that the scenes need, and everything that a
//! change must pass.

// A chore talks to the person who runs it.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod check;
mod docs;
mod generated;
mod lathe;
mod layers;
mod library_textures;
mod links;
mod models;
mod textures;

use serde_json::Value;
use std::path::Path;
use std::process::{Command, ExitCode};

const HELP: &str = "\
The project's own chores.

cargo xtask check    everything that a change must pass
cargo xtask layers   the crates' dependencies against the picture in ARCHITECTURE.md
cargo xtask docs     makes docs/scene-file.md and docs/vitrine.schema.json; with --check only compares, and
                     looks for links to files that are not there
cargo xtask models   makes the models of the example scenes; with --check only compares
cargo xtask textures makes the pictures of the example scenes and the library; with --check only compares
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words[..] {
        ["check"] => check::run(),
        ["layers"] => check_layers(),
        ["textures"] => textures::write(),
        ["textures", "--check"] => textures::check(),
        ["docs"] => generated::write(&docs::files()),
        ["docs", "--check"] => docs::check(),
        ["models"] => generated::write(&models::files()),
        ["models", "--check"] => generated::check("models", &models::files()),
        ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprint!("{HELP}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The folder of the workspace.
fn root() -> &'static Path {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.parent().unwrap_or(own)
}

/// A cargo command in the workspace's folder: the same cargo that started this program.
fn cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root());
    command
}

/// What cargo says of the crates of the workspace.
fn cargo_metadata() -> Result<Value, String> {
    let output = cargo()
        .args(["metadata", "--no-deps", "--format-version", "1"])
        .output()
        .map_err(|e| format!("cannot start cargo: {e}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata failed:\n{}", String::from_utf8_lossy(&output.stderr)));
    }
    serde_json::from_slice(&output.stdout).map_err(|e| format!("cannot read cargo metadata: {e}"))
}

fn check_layers() -> Result<(), String> {
    let found = layers::violations(&cargo_metadata()?)?;
    if found.is_empty() {
        println!("layers: every arrow is allowed");
        Ok(())
    } else {
        Err(format!("dependencies that the layers forbid (see ARCHITECTURE.md):\n  {}", found.join("\n  ")))
    }
}
