//! `vitrine check`: everything that is wrong with scene files, without rendering them.

use crate::failure::{Exit, Failure};
use crate::report::Report;
use crate::{console, report};
use clap::Args;
use std::path::PathBuf;
use vitrine::summary::plural;

/// Find everything that is wrong with scenes
///
/// Reads each scene with its models and textures, and shows all errors and warnings with their lines. Ends with exit
/// code 3 when there is an error; warnings alone are no failure.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine check ball.vitrine.toml\n  \
    vitrine check scenes/*.vitrine.toml")]
pub struct Check {
    /// The scene files
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
}

impl Check {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let (mut errors, mut warnings) = (0, 0);
        for path in &self.scenes {
            let reports = match vitrine::load(path) {
                Ok(project) => Report::warnings_of(&project),
                Err(error) => Failure::from(error).reports,
            };
            let count =
                |errors: bool| reports.iter().filter(|r| r.is_error() == errors).map(Report::count).sum();
            let (wrong, odd): (usize, usize) = (count(true), count(false));
            console::print(format!("{}: {}\n", path.display(), verdict(wrong, odd)))?;
            report::show(&reports);
            errors += wrong;
            warnings += odd;
        }
        if self.scenes.len() > 1 {
            let scenes = plural(self.scenes.len() as u64, "scene");
            console::print(format!("{scenes}: {}\n", verdict(errors, warnings)))?;
        }
        Ok(if errors > 0 { Exit::BadInput } else { Exit::Done })
    }
}

fn verdict(errors: usize, warnings: usize) -> String {
    let parts = [(errors, "error"), (warnings, "warning")];
    let found: Vec<_> = parts.iter().filter(|p| p.0 > 0).map(|(n, noun)| plural(*n as u64, noun)).collect();
    if found.is_empty() { "fine".into() } else { found.join(", ") }
}
