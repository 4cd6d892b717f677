//! `vitrine bench`: measurements.

mod threads;

use crate::failure::{Exit, Failure};
use clap::{Args, Subcommand};

pub use threads::Measured;

/// Measure how fast this machine renders
#[derive(Args, Debug)]
#[command(after_help = "Example:\n  vitrine bench threads --plot threads.svg")]
pub struct Bench {
    #[command(subcommand)]
    bench: Kind,
}

#[derive(Debug, Subcommand)]
enum Kind {
    Threads(threads::Threads),
}

impl Bench {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        match self.bench {
            Kind::Threads(bench) => bench.run(),
        }
    }
}
