//! `vitrine completions`: what shells need to complete the command line.

use super::Cli;
use crate::console;
use crate::failure::{Exit, Failure};
use clap::{Args, CommandFactory};

/// Print the completions for a shell
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine completions bash > ~/.local/share/bash-completion/completions/vitrine\n  \
    vitrine completions fish > ~/.config/fish/completions/vitrine.fish")]
pub struct Completions {
    /// The shell
    shell: clap_complete::Shell,
}

impl Completions {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "vitrine", &mut text);
        console::print(text)?;
        Ok(Exit::Done)
    }
}
