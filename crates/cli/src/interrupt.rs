//! Ctrl-C: the first asks to stop and keep the picture so far, the second ends the program at once.

use crate::console;
use crate::failure::{Exit, Failure};
use crate::report::Report;
use vitrine::Cancel;

/// From now on Ctrl-C (and a polite end from outside) cancels what the returned value is given to.
///
/// # Errors
/// When the system does not let the program listen.
pub fn cancel_on_interrupt() -> Result<Cancel, Failure> {
    let cancel = Cancel::default();
    let asked = cancel.clone();
    ctrlc::set_handler(move || {
        if asked.is_cancelled() {
            std::process::exit(Exit::Interrupted as i32);
        }
        asked.cancel();
        console::tell("Stopping, and keeping the picture so far. Press Ctrl-C again to quit at once.");
    })
    .map_err(|error| {
        Failure::new(Exit::Failed, Report::error(format!("cannot listen for Ctrl-C: {error}")))
    })?;
    Ok(cancel)
}
