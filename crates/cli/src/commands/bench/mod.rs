//! `vitrine bench`: measurements.

mod growth;
mod kernel;
mod threads;

use crate::failure::{Exit, Failure};
use clap::{Args, Subcommand};

pub use growth::Curve;
pub use threads::Measured;

/// Measure how fast this machine renders
#[derive(Args, Debug)]
#[command(
    after_help = "Examples:\n  vitrine bench threads --plot threads.svg\n  vitrine bench kernel --scenes seed"
)]
pub struct Bench {
    #[command(subcommand)]
    bench: Kind,
}

#[derive(Debug, Subcommand)]
enum Kind {
    Threads(threads::Threads),
    Kernel(kernel::KernelBench),
}

impl Bench {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        match self.bench {
            Kind::Threads(bench) => bench.run(),
            Kind::Kernel(bench) => bench.run(),
        }
    }
}
