//! The `vitrine` program: its commands, its messages, its exit codes.

mod commands;
mod console;
mod denoise;
mod draw;
mod events;
mod failure;
mod flags;
mod interrupt;
mod keep;
mod output;
mod picture;
mod progress;
mod report;
mod stopwatch;
mod values;

use std::process::ExitCode;

fn main() -> ExitCode {
    commands::run(std::env::args_os())
}
