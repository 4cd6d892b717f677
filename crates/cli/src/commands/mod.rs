//! The commands, one file each. A new one is a file here and a line in [`Command`].

mod bench;
mod check;
mod completions;
mod denoise;
#[cfg(feature = "editor")]
mod edit;
mod info;
mod man;
mod render;
mod schema;
mod sweep;
mod templates;

#[cfg(not(feature = "editor"))]
use crate::console;
use crate::failure::{Exit, Failure};
use crate::{events, report};
use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

pub use bench::{Curve, Measured};

/// Pictures of scenes behind glass, from scene files.
#[derive(Debug, Parser)]
#[command(
    name = "vitrine",
    version,
    about = "Pictures of scenes behind glass",
    long_about = "Vitrine makes pictures of scenes that stand behind transparent surfaces. Without a command it opens the \
                  window in which scenes are built. A scene is a text file, NAME.vitrine.toml; `vitrine render` makes \
                  its picture.",
    after_help = "Begin with:\n  \
                  vitrine                                              open the window\n  \
                  vitrine templates                                    see what there is\n  \
                  vitrine templates empty -o my.vitrine.toml           get a scene\n  \
                  vitrine render my.vitrine.toml                       make its picture, my.png\n\n\
                  Exit codes: 0 done, 1 failure, 2 wrong usage, 3 bad input file, 130 interrupted."
)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    #[cfg(feature = "editor")]
    Edit(edit::Edit),
    Render(Box<render::Render>),
    Check(check::Check),
    Info(info::Info),
    Denoise(denoise::Denoise),
    Sweep(Box<sweep::Sweep>),
    Bench(Box<bench::Bench>),
    Templates(templates::Templates),
    Schema(schema::Schema),
    Completions(completions::Completions),
    Man(man::Man),
}

impl Command {
    fn run(self) -> Result<Exit, Failure> {
        match self {
            #[cfg(feature = "editor")]
            Self::Edit(command) => command.run(),
            Self::Render(command) => command.run(),
            Self::Check(command) => command.run(),
            Self::Info(command) => command.run(),
            Self::Denoise(command) => command.run(),
            Self::Sweep(command) => command.run(),
            Self::Bench(command) => command.run(),
            Self::Templates(command) => command.run(),
            Self::Schema(command) => command.run(),
            Self::Completions(command) => command.run(),
            Self::Man(command) => command.run(),
        }
    }

    fn sends_events(&self) -> bool {
        matches!(self, Self::Render(command) if command.json)
    }
}

/// Runs the command line and says how it ended.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(help_or_error) => {
            // Nobody is left to tell when the terminal is gone.
            let _ = help_or_error.print();
            return if help_or_error.use_stderr() { Exit::Usage } else { Exit::Done }.into();
        }
    };
    #[cfg(feature = "editor")]
    let command = cli.command.unwrap_or(Command::Edit(edit::Edit::default()));
    #[cfg(not(feature = "editor"))]
    let Some(command) = cli.command else {
        console::tell(
            "Vitrine makes pictures of scenes behind glass. This build of it has no window.\n\n  \
             vitrine render SCENE.vitrine.toml   make a picture\n  \
             vitrine templates                   scenes to begin with\n  \
             vitrine --help                      everything else",
        );
        return Exit::Usage.into();
    };
    let sends_events = command.sends_events();
    match command.run() {
        Ok(exit) => exit.into(),
        Err(failure) => {
            if sends_events {
                events::Events::new(true).send(&events::failure(&failure));
            }
            report::show(&failure.reports);
            failure.exit.into()
        }
    }
}
