//! `vitrine denoise`: a picture in linear light to the same without noise.

use crate::console;
use crate::denoise::{self, DenoiseFlags};
use crate::failure::{Exit, Failure};
use crate::flags::{PictureFlags, ThreadFlag};
use crate::report::{self, Report};
use crate::stopwatch::{self, Stopwatch};
use crate::{output, values};
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::path::{Path, PathBuf};
use vitrine::film::Display;
use vitrine::formats::{self, ExrFeatures};
use vitrine::scene::{Renderer, Settings, View};
use vitrine::{Error, WriteOptions, display_of};

/// Take the noise out of an OpenEXR picture
///
/// The picture has linear light in R, G and B. Edges stay sharper when it also has the colours and the normals of what each
/// pixel shows first, as albedo.R, albedo.G, albedo.B and normal.X, normal.Y, normal.Z. Open Image Denoise 2 does the work; it
/// is no part of Vitrine and must be there.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine denoise ball.exr\n  \
    vitrine denoise ball.exr -o clean.exr --denoise-quality balanced\n  \
    vitrine denoise ball.exr -o clean.png --oidn /opt/oidn/lib")]
pub struct Denoise {
    /// The picture, NAME.exr
    picture: PathBuf,

    /// Where the result goes; without it, beside the picture as NAME-denoised.png
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadFlag,

    #[command(flatten)]
    saving: PictureFlags,

    /// How light becomes the colours of a PNG or JPEG: `neutral`, `agx` or `srgb`; else as the renderer shows it that the file
    /// names
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(View::WORDS), hide_possible_values = true)]
    view: Option<String>,

    /// How much brighter a PNG or JPEG shows the light, in stops: each doubles it, less than 0 darkens it
    #[arg(long, value_name = "STOPS", value_parser = values::exposure, allow_hyphen_values = true)]
    exposure: Option<f32>,

    /// No last line; errors are still shown
    #[arg(short, long)]
    quiet: bool,

    #[command(flatten)]
    denoise: DenoiseFlags,
}

impl Denoise {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let path = self.output.clone().unwrap_or_else(|| beside(&self.picture));
        output::check_picture(&path)?;
        let options = self.saving.options(&path)?;
        let mut layers = formats::read_exr_features(&self.picture).map_err(Error::from)?;
        if layers.albedo.is_none() && layers.normal.take().is_some() && !self.quiet {
            report::show(&[Report::warning("the normals are not used, for there is no albedo")]);
        }
        let denoiser = self.denoise.find(self.threads.threads)?;
        let watch = Stopwatch::start();
        let ExrFeatures { light, albedo, normal, mut metadata } = layers;
        let light = denoiser.run(&light, albedo.as_ref(), normal.as_ref(), self.denoise.quality())?;
        let elapsed = watch.elapsed();
        let (key, by) = denoise::metadata(&denoiser);
        metadata.retain(|(k, _)| *k != key);
        metadata.push((key, by.clone()));
        let options = WriteOptions { display: self.display(&metadata), metadata, ..options };
        formats::write_image(&path, &light, &options).map_err(Error::from)?;
        if !self.quiet {
            let with = if albedo.is_some() { ", with albedo" } else { "" };
            let and = if normal.is_some() { " and normals" } else { "" };
            console::print(format!(
                "{}: denoised in {} by {by}{with}{and}\n",
                path.display(),
                stopwatch::words(elapsed.wall)
            ))?;
        }
        Ok(Exit::Done)
    }

    /// How the light is shown: as the flags say, else as the renderer would that the file's texts name.
    fn display(&self, metadata: &[(String, String)]) -> Display {
        let renderer = metadata.iter().find(|(key, _)| key == "vitrine:renderer");
        let renderer = renderer.and_then(|(_, word)| Renderer::from_word(word));
        let default = Settings::default();
        display_of(&Settings {
            renderer: renderer.unwrap_or(default.renderer),
            view: self.view.as_deref().and_then(View::from_word),
            exposure: self.exposure.unwrap_or(default.exposure),
            ..default
        })
    }
}

/// The result's file when nobody says.
fn beside(picture: &Path) -> PathBuf {
    let name = picture.file_stem().unwrap_or_default().to_string_lossy();
    picture.with_file_name(format!("{name}-denoised.png"))
}
