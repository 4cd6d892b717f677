//! `vitrine render`: a scene file to a picture.

mod done;

use crate::denoise::{self, DenoiseFlags};
use crate::events::Events;
use crate::failure::{Exit, Failure};
use crate::flags::{PictureFlags, SettingFlags, ThreadFlag};
use crate::keep::KeepFlags;
use crate::picture;
use crate::progress::Bar;
use crate::report::Report;
use crate::stopwatch::Stopwatch;
use crate::{console, interrupt, output, report, values};
use clap::Args;
use done::Done;
use serde_json::json;
use std::path::{Path, PathBuf};
use vitrine::denoise::{DenoiseError, Denoiser};
use vitrine::film::Film;
use vitrine::render::accel::simd::Instructions;
use vitrine::render::{CompiledScene, Glance};
use vitrine::scene::{Renderer, Settings};
use vitrine::{
    Error, Image, Project, Region, RenderJob, RenderOptions, Rendered, WriteOptions, display_of, formats,
    layers_of,
};

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
    vitrine render ball.vitrine.toml --renderer photoreal --samples 4096 --noise 0.02 --time 600\n  \
    vitrine render ball.vitrine.toml --resume\n  \
    vitrine render ball.vitrine.toml --denoise\n  \
    vitrine render ball.vitrine.toml -o ball.exr --layers\n  \
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

    /// Write layers beside the light, for compositing: albedo, normal, depth, object and number of samples (.exr only)
    #[arg(long)]
    layers: bool,

    #[command(flatten)]
    keep: KeepFlags,

    /// Report to programs: lines of JSON on stdout
    ///
    /// Each line has an "event": start, warning, progress, and last done or error. The line of done has output, complete,
    /// ended (samples, noise, time or interrupted), width, height, threads, samples, resumed_samples, bad_samples, noise, rays,
    /// render_seconds, cpu_seconds (the times are those of rendering alone) and denoised: by what, or null. When the picture is
    /// saved and could not be denoised, an error follows.
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
        let write_options = self.write_options(&project, &path)?;

        let mut events = Events::new(self.json);
        let mut kept = self.keep.of(&path, &project, self.region);
        self.send_start(&events, &project, &path);
        let denoiser =
            self.wants_denoising(&project.scene.settings).then(|| self.denoising.find(self.threads.threads));
        self.show_warnings(&events, &warnings_of(&project, denoiser.as_ref()));

        let bar = Bar::new(self.quiet || self.json);
        let mut compiled = picture::compile(&project)?;
        if self.portable {
            compiled = compiled.with_instructions(Instructions::Portable);
        }
        let options = RenderOptions { region: self.region, ..project.options() };
        let job = RenderJob::new(&compiled, options).map_err(Error::from)?;
        let begun = kept.begin(&job, self.quiet || self.json)?;
        let before = begun.film.samples();
        bar.begin("Rendering");
        let watch = Stopwatch::start();
        let samples = project.scene.settings.samples;
        let look = &mut |glance: &Glance| {
            let progress = glance.progress();
            bar.show(progress);
            bar.note(progress, samples);
            events.progress(progress);
            kept.look(glance);
        };
        let rendered = job.resume(begun, self.threads.count(), &cancel, look).map_err(Error::from)?;
        let elapsed = watch.elapsed();
        let mut done = Done::new(&rendered, before, elapsed);
        // Who presses Ctrl-C waits for nothing more.
        let denoiser = denoiser.filter(|_| done.is_complete());
        if denoiser.is_some() {
            bar.say("Denoising…");
        }
        let image = self.finish(denoiser, &rendered.film, &mut done);
        drop(bar);

        if done.samples > 0 {
            let made = (&rendered, &image);
            self.save(&path, (&project, &compiled), made, &done.mark(write_options))?;
        }
        let can_go_on = kept.end(rendered);
        self.show_warnings(&events, &done.warnings());
        let path = (done.samples > 0).then_some(&*path);
        if events.is_on() {
            events.send(&done.event(path, &project, self.threads.count()));
        }
        self.say_done(path, &done, can_go_on)?;
        if let Some(Err(error)) = &done.denoised {
            return Err(kept_its_noise(error));
        }
        Ok(if done.is_complete() { Exit::Done } else { Exit::Interrupted })
    }

    /// How the picture is written.
    fn write_options(&self, project: &Project, path: &Path) -> Result<WriteOptions, Failure> {
        let settings = &project.scene.settings;
        let format = formats::image_format(path)?.name;
        if self.layers && format != "OpenEXR" {
            return Err(Failure::usage(
                format!("--layers is for OpenEXR, and this is {format}: {}", path.display()),
                "leave --layers out, or give the output the extension .exr",
            ));
        }
        let (metadata, display) = (project.metadata(settings), display_of(settings));
        Ok(WriteOptions { metadata, display, ..self.picture.options(path)? })
    }

    /// Writes the picture.
    fn save(
        &self,
        path: &Path,
        (project, compiled): (&Project, &CompiledScene),
        (rendered, image): (&Rendered, &Image),
        options: &WriteOptions,
    ) -> Result<(), Failure> {
        if self.layers {
            let layers = layers_of(&project.scene, compiled, &rendered.film, self.threads.count());
            formats::write_layers(path, image, &layers, options)?;
        } else {
            formats::write_image(path, image, options)?;
        }
        Ok(())
    }

    /// Whether the noise is to be taken out: the flag asks for that with any renderer, a scene for photoreal pictures only.
    fn wants_denoising(&self, settings: &Settings) -> bool {
        self.denoise || settings.denoise && settings.renderer == Renderer::Photoreal
    }

    /// The film's picture, without its noise where that was asked for and can be done.
    fn finish(
        &self,
        denoiser: Option<Result<Denoiser, DenoiseError>>,
        film: &Film,
        done: &mut Done,
    ) -> Image {
        let clean = |denoiser: Denoiser| {
            let image = denoiser.run_film(film, self.denoising.quality())?;
            Ok((image, denoise::metadata(&denoiser)))
        };
        match denoiser.map(|denoiser| denoiser.and_then(clean)) {
            Some(Ok((image, by))) => {
                done.denoised = Some(Ok(by));
                image
            }
            Some(Err(error)) => {
                done.denoised = Some(Err(error));
                film.image()
            }
            None => film.image(),
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

    fn say_done(&self, path: Option<&Path>, done: &Done, can_go_on: bool) -> Result<(), Failure> {
        let Some(path) = path else {
            console::tell(picture::NOTHING_YET);
            return Ok(());
        };
        if !done.is_complete() {
            let advice = if can_go_on { "; --resume goes on with it" } else { "" };
            console::tell(&format!("Interrupted: the picture so far is in {}{advice}", path.display()));
            return Ok(());
        }
        if self.quiet || self.json {
            return Ok(());
        }
        console::print(format!("{}: {}\n", path.display(), done.words()))
    }
}

/// What may be wrong before a picture is made.
fn warnings_of(project: &Project, denoiser: Option<&Result<Denoiser, DenoiseError>>) -> Vec<Report> {
    let mut warnings = Report::warnings_of(project);
    if let Some(Err(_)) = denoiser {
        warnings.push(Report::warning("Open Image Denoise 2 was not found: the picture will keep its noise"));
    }
    warnings
}

/// The end of a render whose picture is saved and was not denoised.
fn kept_its_noise(error: &DenoiseError) -> Failure {
    let report = Report::error(format!("the picture is saved with its noise: {error}"));
    Failure::new(Exit::Failed, report.with_help(error.help()))
}
