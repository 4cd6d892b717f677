//! Flags that several commands share.

use crate::failure::{Exit, Failure};
use crate::values;
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::path::Path;
use vitrine::formats::{self, BitDepth};
use vitrine::render::threads;
use vitrine::scene::{Renderer, View};
use vitrine::{Error, Project, WriteOptions};

/// What stands for values of the scene.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "In place of what the scene says")]
pub struct SettingFlags {
    /// How the picture is made: `classic` with mirrors, transparency and shadows, `cast` without any of them, `photoreal`
    /// with light as it is
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(Renderer::WORDS), hide_possible_values = true)]
    pub renderer: Option<String>,

    /// Width and height of the picture in pixels, such as 1920x1080
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true)]
    pub size: Option<[u32; 2]>,

    /// Rays through each pixel; 1 goes through the middle, 4 or more smooth the edges
    #[arg(long, value_name = "N", value_parser = values::samples, allow_hyphen_values = true)]
    pub samples: Option<u32>,

    /// How many times a mirror image may be mirrored again
    #[arg(long, value_name = "N", value_parser = values::depth, allow_hyphen_values = true)]
    pub depth: Option<u32>,

    /// Another number gives other random points of the same quality
    #[arg(long, value_name = "N", value_parser = values::seed, allow_hyphen_values = true)]
    pub seed: Option<u32>,

    /// The picture is done once its noise is this share of its light, such as 0.02, even with fewer samples
    #[arg(long, value_name = "SHARE", value_parser = values::noise, allow_hyphen_values = true)]
    pub noise: Option<f32>,

    /// The picture is done after so many seconds, even with fewer samples and more noise
    #[arg(long, value_name = "SECONDS", value_parser = values::time, allow_hyphen_values = true)]
    pub time: Option<f32>,

    /// How light becomes the colours of the display: `neutral`, `agx` or `srgb`
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(View::WORDS), hide_possible_values = true)]
    pub view: Option<String>,

    /// Show the picture brighter by so many stops, or darker below 0; each stop doubles the light
    #[arg(long, value_name = "STOPS", value_parser = values::exposure, allow_hyphen_values = true)]
    pub exposure: Option<f32>,

    /// The temperature of the light that is shown as white: 6500 is daylight, 2900 the light of a bulb
    #[arg(long, value_name = "KELVIN", value_parser = values::white_balance, allow_hyphen_values = true)]
    pub white_balance: Option<f32>,

    /// Change one value, such as object.ball.material.transparency=0.4; may be given several times
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
}

impl SettingFlags {
    /// Changes the scene as the flags say.
    ///
    /// # Errors
    /// When a value does not fit; the fault is the command line's, as the file itself is sound.
    pub fn apply(&self, project: &mut Project) -> Result<(), Failure> {
        project.set(&self.assignments()).map_err(|error| match error {
            Error::Scene(_) => Failure { exit: Exit::Usage, ..error.into() },
            _ => error.into(),
        })
    }

    /// The flags as assignments, after those of `--set`.
    pub fn assignments(&self) -> Vec<String> {
        let flags = [
            self.renderer.as_ref().map(|v| format!("settings.renderer=\"{v}\"")),
            self.size.map(|[width, height]| format!("settings.size=[{width}, {height}]")),
            self.samples.map(|v| format!("settings.samples={v}")),
            self.depth.map(|v| format!("settings.depth={v}")),
            self.seed.map(|v| format!("settings.seed={v}")),
            self.noise.map(|v| format!("settings.noise={v:?}")),
            self.time.map(|v| format!("settings.time_limit={v:?}")),
            self.view.as_ref().map(|v| format!("settings.view=\"{v}\"")),
            self.exposure.map(|v| format!("settings.exposure={v:?}")),
            self.white_balance.map(|v| format!("settings.white_balance={v:?}")),
        ];
        self.set.iter().cloned().chain(flags.into_iter().flatten()).collect()
    }
}

/// On how many threads.
#[derive(Args, Clone, Copy, Debug)]
pub struct ThreadFlag {
    /// Number of threads; 0 takes all cores. The picture is the same for any number
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = values::threads, allow_hyphen_values = true)]
    pub threads: usize,
}

impl ThreadFlag {
    /// The number of threads that will run.
    pub fn count(self) -> usize {
        threads::meant_by(self.threads)
    }
}

/// How a picture is stored.
#[derive(Args, Clone, Copy, Debug)]
pub struct PictureFlags {
    /// Bits for each colour in PNG, 8 or 16 (8 where nothing is given)
    #[arg(long, value_name = "8|16", value_parser = values::bits, allow_hyphen_values = true)]
    pub bits: Option<BitDepth>,

    /// Quality of a JPEG, 1 to 100 (92 where nothing is given)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=100))]
    pub quality: Option<u8>,
}

impl PictureFlags {
    /// How to write a file of that name.
    ///
    /// # Errors
    /// When a flag means nothing for its format.
    pub fn options(self, path: &Path) -> Result<WriteOptions, Failure> {
        let format = formats::image_format(path)?.name;
        if self.bits.is_some() && format != "PNG" {
            return Err(Failure::usage(
                format!("--bits is for PNG, and this is {format}: {}", path.display()),
                "leave --bits out, or give the output the extension .png",
            ));
        }
        if self.quality.is_some() && format != "JPEG" {
            return Err(Failure::usage(
                format!("--quality is for JPEG, and this is {format}: {}", path.display()),
                "leave --quality out, or give the output the extension .jpg",
            ));
        }
        let default = WriteOptions::default();
        Ok(WriteOptions {
            bits: self.bits.unwrap_or(default.bits),
            jpeg_quality: self.quality.unwrap_or(default.jpeg_quality),
            ..default
        })
    }
}
