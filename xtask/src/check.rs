//! `cargo xtask check`: everything that a change must pass, the quick steps first. CI runs the same.

use crate::{docs, generated, models};
use std::time::Instant;

/// A step: its arguments to cargo, and a variable of its environment.
type Step = (&'static [&'static str], Option<(&'static str, &'static str)>);

const QUICK: &[Step] = &[
    (&["fmt", "--all", "--check"], None),
    (&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], None),
];

const SLOW: &[Step] = &[
    (&["test", "--workspace"], None),
    (&["doc", "--no-deps", "--workspace"], Some(("RUSTDOCFLAGS", "-D warnings"))),
];

/// Runs every step until one fails.
///
/// # Errors
/// Which step failed.
pub fn run() -> Result<(), String> {
    let start = Instant::now();
    QUICK.iter().try_for_each(run_step)?;
    crate::check_layers()?;
    docs::check()?;
    generated::check("models", &models::files())?;
    SLOW.iter().try_for_each(run_step)?;
    println!("check: all passed in {} s", start.elapsed().as_secs());
    Ok(())
}

fn run_step((arguments, variable): &Step) -> Result<(), String> {
    let shown = format!("cargo {}", arguments.join(" "));
    println!("── {shown}");
    let mut command = crate::cargo();
    command.args(*arguments).envs(*variable);
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("`{shown}` failed")),
        Err(e) => Err(format!("cannot start `{shown}`: {e}")),
    }
}
