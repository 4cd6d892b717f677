//! Taking the noise out of a picture before it is saved: the flags for it, and the work.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use vitrine::denoise::{DenoiseError, Denoiser, Quality};

/// With what the noise is taken out, and how well.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Denoising")]
pub struct DenoiseFlags {
    /// Where Open Image Denoise is, its file or folder; else the variable VITRINE_OIDN says it, else the system knows
    #[arg(long, value_name = "PATH")]
    oidn: Option<PathBuf>,

    /// How well the noise is taken out: `high`, `balanced` or `fast` (`high` where nothing is given)
    #[arg(long, value_name = "NAME", value_parser = quality(), hide_possible_values = true)]
    denoise_quality: Option<Quality>,
}

/// A word for a quality.
fn quality() -> impl TypedValueParser<Value = Quality> {
    let words = Quality::WORDS.iter().map(|(word, _)| *word);
    PossibleValuesParser::new(words).map(|text| {
        let found = Quality::WORDS.iter().find(|(word, _)| *word == text);
        found.map_or_else(Quality::default, |&(_, quality)| quality)
    })
}

impl DenoiseFlags {
    /// Looks for the library, to be used on so many threads.
    ///
    /// # Errors
    /// When it is not found, with what was tried.
    pub fn find(&self, threads: usize) -> Result<Denoiser, DenoiseError> {
        Ok(Denoiser::find(self.oidn.as_deref())?.with_threads(threads))
    }

    /// How well the noise is taken out.
    pub fn quality(&self) -> Quality {
        self.denoise_quality.unwrap_or_default()
    }
}

/// What a picture's file says of its denoising.
pub fn metadata(denoiser: &Denoiser) -> (String, String) {
    ("vitrine:denoised".into(), format!("Open Image Denoise {}", denoiser.version()))
}
