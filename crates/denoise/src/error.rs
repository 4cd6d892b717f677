//! Why a picture was not denoised.

use crate::places::VARIABLE;
use std::path::PathBuf;

/// A file that was tried, and why it is not the library that is needed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// The file; a bare name stands for all places where the system looks for libraries.
    pub file: PathBuf,
    /// What the system or the library said.
    pub reason: String,
}

/// Why a picture was not denoised.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DenoiseError {
    /// No library was found that can be used.
    #[error("Open Image Denoise 2 was not found; tried were{}", list(tried))]
    NotFound {
        /// All files that were tried, in order.
        tried: Vec<Attempt>,
    },
    /// A picture has no pixels, or not as many as its size says.
    #[error("the picture with the {what} is not whole: {} × {} pixels and {pixels} colours", size[0], size[1])]
    NotWhole {
        /// "light", "albedo" or "normals".
        what: &'static str,
        /// Width and height in pixels.
        size: [u32; 2],
        /// How many colours it has.
        pixels: usize,
    },
    /// The pictures differ in size.
    #[error(
        "the picture with the {what} has {} × {} pixels and the one with the light {} × {}",
        size[0], size[1], light[0], light[1]
    )]
    OtherSize {
        /// "albedo" or "normals".
        what: &'static str,
        /// Its width and height in pixels.
        size: [u32; 2],
        /// The light's.
        light: [u32; 2],
    },
    /// There are normals and no albedo, which the library cannot use.
    #[error("there are normals but no albedo")]
    NormalsAlone,
    /// The library failed.
    #[error("Open Image Denoise {version} failed: {text}")]
    Failed {
        /// The library's version: "2.5.1".
        version: String,
        /// What it said.
        text: String,
    },
}

impl DenoiseError {
    /// How to mend it.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::NotFound { .. } => format!(
                "install it (Arch: openimagedenoise, Fedora: oidn, Homebrew: open-image-denoise), or take it from \
                 openimagedenoise.org or the Python package pyoidn, and let {VARIABLE} name the folder, lib, in which it \
                 lies; the folder must keep that name"
            ),
            Self::NotWhole { .. } => String::new(),
            Self::OtherSize { .. } => "render all of them with one size and one region".into(),
            Self::NormalsAlone => "give both of them or none".into(),
            Self::Failed { .. } => "try a smaller picture, or another version of the library".into(),
        }
    }
}

/// A line for each, indented.
fn list(tried: &[Attempt]) -> String {
    let one = |a: &Attempt| match a.reason.as_str() {
        reason if reason.contains(&*a.file.to_string_lossy()) => format!("\n  {reason}"),
        reason => format!("\n  {}: {reason}", a.file.display()),
    };
    tried.iter().map(one).collect()
}
