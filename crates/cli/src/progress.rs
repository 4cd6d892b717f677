//! The progress bar: on stderr, only when that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use vitrine::Progress;

/// A bar for work that counts samples; it vanishes when it is dropped.
#[derive(Debug)]
pub struct Bar(ProgressBar);

impl Bar {
    /// A bar with a word before it; hidden when `quiet` or when stderr is no terminal.
    pub fn new(label: impl Into<String>, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        let style = ProgressStyle::with_template("{msg} {bar:30} {percent:>3} %, {elapsed} gone, {eta} left")
            .expect("the template is right");
        bar.set_style(style.progress_chars("█▓░"));
        bar.set_message(label.into());
        Self(bar)
    }

    /// Changes the word before the bar.
    pub fn name(&self, label: impl Into<String>) {
        self.0.set_message(label.into());
    }

    /// Shows how far the work is.
    pub fn show(&self, progress: Progress) {
        self.0.set_length(progress.samples_total);
        self.0.set_position(progress.samples_done);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
