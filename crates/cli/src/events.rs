//! Lines of JSON for programs that run this one (`--json`).

use crate::failure::Failure;
use crate::report::Report;
use serde_json::{Value, json};
use std::io::Write;
use std::time::{Duration, Instant};
use vitrine::Progress;

/// Between two lines of progress.
const PAUSE: Duration = Duration::from_millis(250);

/// Where events go.
#[derive(Debug)]
pub struct Events {
    is_on: bool,
    started: Instant,
    last_progress: Option<Instant>,
}

impl Events {
    /// Events on stdout, or nowhere.
    pub fn new(is_on: bool) -> Self {
        Self { is_on, started: Instant::now(), last_progress: None }
    }

    /// Whether anyone listens.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// Writes one event.
    pub fn send(&self, event: &Value) {
        if self.is_on {
            // A listener that went away does not stop the picture.
            let mut out = std::io::stdout().lock();
            let _ = writeln!(out, "{event}").and_then(|()| out.flush());
        }
    }

    /// Writes how far the work is, now and then.
    pub fn progress(&mut self, progress: Progress) {
        if !self.is_on || self.last_progress.is_some_and(|last| last.elapsed() < PAUSE) {
            return;
        }
        self.last_progress = Some(Instant::now());
        self.send(&json!({
            "event": "progress",
            "samples_done": progress.samples_done,
            "samples_total": progress.samples_total,
            "noise": progress.noise,
            "elapsed_seconds": self.started.elapsed().as_secs_f64(),
        }));
    }
}

/// The event for a failure: one line with everything that was found.
pub fn failure(failure: &Failure) -> Value {
    let findings: Vec<_> = failure.reports.iter().map(Report::to_json).collect();
    let message = failure.reports.first().map(ToString::to_string);
    json!({
        "event": "error",
        "exit_code": failure.exit as u8,
        "message": message,
        "findings": findings,
    })
}
