//! The progress bar: on stderr, only when that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use vitrine::Progress;

/// A bar for work that counts samples; it vanishes when it is dropped.
#[derive(Debug)]
pub struct Bar(ProgressBar);

impl Bar {
    /// The word "Preparing", and no bar yet; hidden when `quiet` or when stderr is no terminal.
    pub fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        bar.set_style(style("{msg}"));
        bar.set_message("Preparing…");
        Self(bar)
    }

    /// From now on a bar with this word before it; its clock starts.
    pub fn begin(&self, label: impl Into<String>) {
        self.0.reset_elapsed();
        self.0.set_style(style("{msg} {bar:30} {percent:>3} %, {elapsed} gone, {eta} left{prefix}"));
        self.0.set_message(label.into());
    }

    /// From now on this word, and no bar.
    pub fn say(&self, label: &str) {
        self.0.set_style(style("{msg}"));
        self.0.set_message(label.to_owned());
    }

    /// Shows how far the work is.
    pub fn show(&self, progress: Progress) {
        self.0.set_length(progress.samples_total);
        self.0.set_position(progress.samples_done);
    }

    /// Shows at the end how many samples each pixel has of those that it gets, and how noisy the picture is.
    pub fn note(&self, progress: Progress, samples: u32) {
        let share = u128::from(progress.samples_done) * u128::from(samples);
        let done = share / u128::from(progress.samples_total.max(1));
        let noise = progress.noise.map(|n| format!(", noise {}", percent(n))).unwrap_or_default();
        self.0.set_prefix(format!(", {done} of {samples} samples{noise}"));
    }
}

/// A share: "2.3 %".
pub fn percent(share: f32) -> String {
    format!("{:.1} %", share * 100.0)
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).expect("the template is right").progress_chars("█▓░")
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
