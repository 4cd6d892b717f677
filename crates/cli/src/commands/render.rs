//! `vitrine render`: a scene file to a picture.

use crate::denoise::{self, DenoiseFlags};
use crate::events::Events;
use crate::failure::{Exit, Failure};
use crate::flags::{PictureFlags, SettingFlags, ThreadFlag};
use crate::picture::{self, Made};
use crate::progress::Bar;
use crate::report::Report;
use crate::stopwatch::Elapsed;
use crate::{console, interrupt, output, report, stopwatch, values};
use clap::Args;
use serde_json::json;
use std::path::{Path, PathBuf};
use vitrine::denoise::{DenoiseError, Denoiser};
use vitrine::film::Film;
use vitrine::render::accel::simd::Instructions;
use vitrine::scene::{Renderer, Settings};
use vitrine::{Image, Project, Region, RenderOptions, Rendered, WriteOptions, formats};

/// Make the picture of a scene
///
/// The picture's extension says how it is stored: .png, .jpg, .exr (OpenEXR, linear light) or .hdr (Radiance, linear
/// light). Ctrl-C stops and keeps the picture so far; a second Ctrl-C quits at once.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine render ball.vitrine.toml\n  \
    vitrine render ball.vitrine.toml -o ball.jpg --size 1920x1080 --samples 16\n  \
    vitrine render ball.vitrine.toml --set object.ball.material.transparency=0.4\n  \
    vitrine render ball.vitrine.toml -o part.png --region 100,50,400,300 --threads 1\n  \
    vitrine render ball.vitrine.toml --denoise\n  \
    vitrine render ball.vitrine.toml --json | tail -1")]
pub struct Render {
    /// The scene file, NAME.vitrine.toml
    scene: PathBuf,

    /// Where the picture goes; without it, beside the scene as NAME.png
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Only this part of the picture, in pixels from its upper left corner
    #[arg(long, value_name = "X,Y,W,H", value_parser = values::region, allow_hyphen_values = true)]
    region: Option<Region>,

    #[command(flatten)]
    threads: ThreadFlag,

    /// Trace without the processor's vector instructions
    ///
    /// The picture is the same to the byte on every machine, with these instructions and without; only the time differs. If it
    /// is not, the machine computes wrongly: this flag is there to find that out.
    #[arg(long)]
    portable: bool,

    #[command(flatten)]
    picture: PictureFlags,

    /// Report to programs: lines of JSON on stdout
    ///
    /// Each line has an "event": start, warning, progress, and last done or error. The line of done has output, complete,
    /// width, height, threads, samples, rays, render_seconds, cpu_seconds (the times are those of rendering alone) and denoised: by
    /// what, or null. When the picture is saved and could not be denoised, an error follows.
    #[arg(long)]
    pub json: bool,

    /// No progress bar, no warnings, no last line; errors are still shown
    #[arg(short, long)]
    quiet: bool,

    /// Take out the noise that is left when the picture is done, as settings.denoise asks for it in a scene
    ///
    /// Open Image Denoise 2 does it, which is no part of Vitrine and must be there. Where it is not, the picture is saved with
    /// its noise, and the exit code is 1. The same bytes on every machine are promised only without this.
    #[arg(long)]
    denoise: bool,

    #[command(flatten)]
    denoising: DenoiseFlags,

    #[command(flatten)]
    settings: SettingFlags,
}

impl Render {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let cancel = interrupt::cancel_on_interrupt()?;
        if let Some(path) = &self.output {
            output::check_picture(path)?;
        }
        let mut project = vitrine::load(&self.scene)?;
        self.settings.apply(&mut project)?;
        picture::check_region(&project, self.region)?;
        let path = match &self.output {
            Some(path) => path.clone(),
            None => output::beside(&project, ".png"),
        };
        output::check_picture(&path)?;
        let settings = project.scene.settings.clone();
        let write_options =
            WriteOptions { metadata: project.metadata(&settings), ..self.picture.options(&path)? };

        let mut events = Events::new(self.json);
        self.send_start(&events, &project, &path);
        let denoiser = self.wants_denoising(&settings).then(|| self.denoising.find(self.threads.threads));
        let mut warnings = Report::warnings_of(&project);
        if let Some(Err(_)) = &denoiser {
            warnings
                .push(Report::warning("Open Image Denoise 2 was not found: the picture will keep its noise"));
        }
        self.show_warnings(&events, &warnings);

        let bar = Bar::new(self.quiet || self.json);
        let mut compiled = picture::compile(&project)?;
        if self.portable {
            compiled = compiled.with_instructions(Instructions::Portable);
        }
        let options = RenderOptions { settings, region: self.region };
        bar.begin("Rendering");
        let made = picture::make(&compiled, options, self.threads.count(), &cancel, &mut |progress| {
            bar.show(progress);
            events.progress(progress);
        })?;
        let (mut done, film) = Done::of(made);
        // Who presses Ctrl-C waits for nothing more.
        let denoiser = denoiser.filter(|_| done.is_complete);
        if denoiser.is_some() {
            bar.say("Denoising…");
        }
        let image = self.finish(denoiser, film, &mut done);
        drop(bar);
        let is_saved = done.samples > 0;
        if is_saved {
            save(&path, &image, &done, write_options)?;
        }
        self.send_done(&events, &project, is_saved.then_some(&path), &done);
        self.say_done(is_saved.then_some(&path), &done)?;
        match done.denoised {
            Some(Err(error)) => Err(kept_its_noise(&error)),
            _ if done.is_complete => Ok(Exit::Done),
            _ => Ok(Exit::Interrupted),
        }
    }

    /// Whether the noise is to be taken out: the flag asks for that with any renderer, a scene for photoreal pictures only.
    fn wants_denoising(&self, settings: &Settings) -> bool {
        self.denoise || settings.denoise && settings.renderer == Renderer::Photoreal
    }

    /// The film's picture, without its noise where that was asked for and can be done.
    fn finish(&self, denoiser: Option<Result<Denoiser, DenoiseError>>, film: Film, done: &mut Done) -> Image {
        let clean = |denoiser: Denoiser| {
            let image = denoiser.run_film(&film, self.denoising.quality())?;
            Ok((image, denoise::metadata(&denoiser)))
        };
        match denoiser.map(|denoiser| denoiser.and_then(clean)) {
            Some(Ok((image, by))) => {
                done.denoised = Some(Ok(by));
                image
            }
            Some(Err(error)) => {
                done.denoised = Some(Err(error));
                film.into_image()
            }
            None => film.into_image(),
        }
    }

    fn show_warnings(&self, events: &Events, warnings: &[Report]) {
        for warning in warnings {
            let mut event = warning.to_json();
            event["event"] = "warning".into();
            events.send(&event);
        }
        if !self.quiet {
            report::show(warnings);
        }
    }

    fn send_start(&self, events: &Events, project: &Project, path: &Path) {
        if !events.is_on() {
            return;
        }
        let settings = &project.scene.settings;
        let region = self.region.unwrap_or(Region::whole(settings.size));
        events.send(&json!({
            "event": "start",
            "version": vitrine::VERSION,
            "scene": project.path(),
            "scene_hash": project.hash().to_string(),
            "output": path,
            "renderer": settings.renderer.word(),
            "width": settings.size[0],
            "height": settings.size[1],
            "region": [region.x, region.y, region.width, region.height],
            "samples_per_pixel": settings.samples,
            "depth": settings.depth,
            "seed": settings.seed,
            "threads": self.threads.count(),
            "portable": self.portable,
        }));
    }

    fn send_done(&self, events: &Events, project: &Project, path: Option<&PathBuf>, done: &Done) {
        if !events.is_on() {
            return;
        }
        events.send(&json!({
            "event": "done",
            "output": path,
            "complete": done.is_complete,
            "width": done.region.width,
            "height": done.region.height,
            "threads": self.threads.count(),
            "samples_per_pixel": project.scene.settings.samples,
            "samples": done.samples,
            "rays": done.rays,
            "render_seconds": done.elapsed.wall.as_secs_f64(),
            "cpu_seconds": done.elapsed.cpu.as_secs_f64(),
            "scene_hash": project.hash().to_string(),
            "denoised": done.denoised().map(|(_, by)| by),
        }));
    }

    fn say_done(&self, path: Option<&PathBuf>, done: &Done) -> Result<(), Failure> {
        let Some(path) = path else {
            console::tell(picture::NOTHING_YET);
            return Ok(());
        };
        if !done.is_complete {
            console::tell(&format!("Interrupted: the picture so far is in {}", path.display()));
            return Ok(());
        }
        if self.quiet || self.json {
            return Ok(());
        }
        let denoised = if done.denoised().is_some() { ", denoised" } else { "" };
        console::print(format!(
            "{}: {} × {} pixels in {} ({} rays){denoised}\n",
            path.display(),
            done.region.width,
            done.region.height,
            stopwatch::words(done.elapsed.wall),
            console::thousands(done.rays),
        ))
    }
}

/// What there is to say of a picture beside the picture.
struct Done {
    region: Region,
    samples: u64,
    rays: u64,
    is_complete: bool,
    elapsed: Elapsed,
    /// What the file says of its denoising, or why there was none. None: nobody asked for it.
    denoised: Option<Result<(String, String), DenoiseError>>,
}

impl Done {
    /// Takes the film out of what was made.
    fn of(made: Made) -> (Self, Film) {
        let Made { rendered, elapsed } = made;
        let is_complete = rendered.is_complete();
        let Rendered { film, rays, .. } = rendered;
        let (region, samples) = (film.region(), film.samples());
        (Self { region, samples, rays, is_complete, elapsed, denoised: None }, film)
    }

    /// Key and text for the picture's file.
    fn denoised(&self) -> Option<&(String, String)> {
        self.denoised.as_ref()?.as_ref().ok()
    }
}

/// The end of a render whose picture is saved and was not denoised.
fn kept_its_noise(error: &DenoiseError) -> Failure {
    let report = Report::error(format!("the picture is saved with its noise: {error}"));
    Failure::new(Exit::Failed, report.with_help(error.help()))
}

fn save(path: &Path, image: &Image, done: &Done, mut options: WriteOptions) -> Result<(), Failure> {
    if !done.is_complete {
        options.metadata.push(("vitrine:complete".into(), "false".into()));
    }
    options.metadata.extend(done.denoised().cloned());
    formats::write_image(path, image, &options)?;
    Ok(())
}
