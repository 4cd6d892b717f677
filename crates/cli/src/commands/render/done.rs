//! What there is to say of a picture beside the picture.

use crate::console;
use crate::progress::percent;
use crate::report::Report;
use crate::stopwatch::{self, Elapsed};
use serde_json::{Value, json};
use std::path::Path;
use vitrine::denoise::DenoiseError;
use vitrine::summary::plural;
use vitrine::{Ending, Project, Region, Rendered, WriteOptions};

/// How a render ended.
pub struct Done {
    ending: Ending,
    region: Region,
    /// Samples in the film.
    pub samples: u64,
    /// How many of them were there before.
    before: u64,
    bad_samples: u64,
    /// The fewest samples that a pixel has.
    fewest: u32,
    noise: Option<f32>,
    rays: u64,
    elapsed: Elapsed,
    /// What the file says of its denoising, or why there was none. None: nobody asked for it.
    pub denoised: Option<Result<(String, String), DenoiseError>>,
}

impl Done {
    /// Of a picture that began with so many samples, and took so long since.
    pub fn new(rendered: &Rendered, before: u64, elapsed: Elapsed) -> Self {
        let film = &rendered.film;
        Self {
            ending: rendered.ending,
            region: film.region(),
            samples: film.samples(),
            before,
            bad_samples: rendered.bad_samples,
            fewest: film.tile_samples().iter().min().copied().unwrap_or(0),
            noise: rendered.noise,
            rays: rendered.rays,
            elapsed,
            denoised: None,
        }
    }

    /// Key and text for the picture's file.
    fn denoised(&self) -> Option<&(String, String)> {
        self.denoised.as_ref()?.as_ref().ok()
    }

    /// Whether the picture is what was asked for.
    pub fn is_complete(&self) -> bool {
        self.ending != Ending::Unfinished
    }

    /// Says in the picture's file how it ended, unless that is as always.
    pub fn mark(&self, mut options: WriteOptions) -> WriteOptions {
        let mut say = |key: &str, text: String| options.metadata.push((key.to_owned(), text));
        match self.ending {
            Ending::Samples => {}
            Ending::Unfinished => say("vitrine:complete", "false".into()),
            Ending::Noise | Ending::Time => {
                say("vitrine:ended", self.word().into());
                say("vitrine:samples-done", self.fewest.to_string());
            }
        }
        options.metadata.extend(self.denoised().cloned());
        options
    }

    /// What may be wrong with the picture.
    pub fn warnings(&self) -> Vec<Report> {
        if self.bad_samples == 0 {
            return Vec::new();
        }
        let samples = plural(self.bad_samples, "sample");
        let message = format!("{samples} of light that is no finite number were left out of the picture");
        let help =
            "the picture is a little wrong where they were; a scene that does this shows a fault of Vitrine";
        vec![Report::warning(message).with_help(help)]
    }

    /// The last line for programs.
    pub fn event(&self, path: Option<&Path>, project: &Project, threads: usize) -> Value {
        json!({
            "event": "done",
            "output": path,
            "complete": self.is_complete(),
            "ended": self.word(),
            "width": self.region.width,
            "height": self.region.height,
            "threads": threads,
            "samples_per_pixel": project.scene.settings.samples,
            "samples": self.samples,
            "resumed_samples": self.before,
            "bad_samples": self.bad_samples,
            "noise": self.noise,
            "rays": self.rays,
            "render_seconds": self.elapsed.wall.as_secs_f64(),
            "cpu_seconds": self.elapsed.cpu.as_secs_f64(),
            "scene_hash": project.hash().to_string(),
            "denoised": self.denoised().map(|(_, by)| by),
        })
    }

    /// The last line for people, without the file's name.
    pub fn words(&self) -> String {
        let Region { width, height, .. } = self.region;
        let noise = self.noise.map(|n| format!(", noise {}", percent(n))).unwrap_or_default();
        let end = match self.ending {
            Ending::Noise => format!(", clean enough after {} samples{noise}", self.fewest),
            Ending::Time => format!(", its time was over after {} samples{noise}", self.fewest),
            Ending::Samples | Ending::Unfinished => noise,
        };
        let denoised = if self.denoised().is_some() { ", denoised" } else { "" };
        let (time, rays) = (stopwatch::words(self.elapsed.wall), console::thousands(self.rays));
        format!("{width} × {height} pixels in {time} ({rays} rays){end}{denoised}")
    }

    fn word(&self) -> &'static str {
        match self.ending {
            Ending::Unfinished => "interrupted",
            Ending::Samples => "samples",
            Ending::Noise => "noise",
            Ending::Time => "time",
        }
    }
}
