//! Takes the noise out of a picture in linear light, between the film and the file: by Intel's Open Image Denoise 2, a
//! neural network that has learned from ray-traced pictures. Of a scene it knows nothing.
//!
//! The library is no part of the program. It is looked for when it is asked for ([`Denoiser::find`]), and where it is not
//! found that is said, with all places that were tried; nothing else depends on it. A denoised picture depends on the
//! library and the processor, so the promise of the same bytes on every machine ends here.
//!
//! The network keeps edges better when it also sees the colours and the normals of what the camera sees first. Those have
//! noise of their own where things are out of focus or behind rough glass, so they are denoised before, each alone, as the
//! library's documentation advises ("prefiltering").

mod error;
mod library;
mod places;

pub use error::{Attempt, DenoiseError};
pub use places::VARIABLE;

use library::{Device, Job, Library};
use places::Place;
use std::ffi::{CStr, c_int};
use std::path::{Path, PathBuf, absolute};
use vitrine_film::{Film, Image, Layers};
use vitrine_math::Rgb;

/// How much time goes into a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// As good as it can be: for finished pictures.
    #[default]
    High,
    /// About half of the time, hardly worse.
    Balanced,
    /// About a quarter of the time: for looking at while a picture grows.
    Fast,
}

impl Quality {
    /// All of them with their words, the best first.
    pub const WORDS: &[(&'static str, Self)] =
        &[("high", Self::High), ("balanced", Self::Balanced), ("fast", Self::Fast)];

    /// The library's number for it.
    const fn number(self) -> c_int {
        match self {
            Self::High => 6,
            Self::Balanced => 5,
            Self::Fast => 4,
        }
    }
}

/// The library, found and ready.
#[derive(Clone, Debug)]
pub struct Denoiser {
    library: Library,
    file: PathBuf,
    threads: usize,
}

impl Denoiser {
    /// Looks for the library: where `setting` points, a file or a folder; else where the environment variable
    /// [`VARIABLE`] points; else where the system looks for libraries, beside the program, in a folder `lib` there and in
    /// one above it. What the setting or the variable names is used or refused, never replaced by another.
    ///
    /// # Errors
    /// [`DenoiseError::NotFound`] with all that was tried.
    pub fn find(setting: Option<&Path>) -> Result<Self, DenoiseError> {
        let variable = std::env::var_os(VARIABLE);
        let program = std::env::current_exe().ok();
        Self::look_in(&places::places(setting, variable.as_deref(), program.as_deref()))
    }

    fn look_in(places: &[Place]) -> Result<Self, DenoiseError> {
        let mut tried = Vec::new();
        for place in places {
            for file in place.files() {
                let loaded = match place {
                    Place::System => Library::load(&file),
                    Place::Named(_) | Place::Folder(_) if !file.exists() => {
                        Err("there is no such file".into())
                    }
                    // A bare name would send the system to its own places.
                    _ => absolute(&file).map_err(|e| e.to_string()).and_then(|file| Library::load(&file)),
                };
                match loaded {
                    Ok(library) => return Ok(Self { library, file, threads: 0 }),
                    Err(reason) => tried.push(Attempt { file, reason }),
                }
            }
        }
        Err(DenoiseError::NotFound { tried })
    }

    /// The same, working on so many threads; 0: as many as the library finds best.
    #[must_use]
    pub fn with_threads(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// The library's version, as "2.5.1".
    #[must_use]
    pub fn version(&self) -> String {
        self.library.version()
    }

    /// The library's file; a bare name when the system found it.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// Takes the noise out of a picture in linear light of any brightness.
    ///
    /// `albedo` is the colour of what each pixel shows first, from 0 to 1, and `normal` its normal, each part from −1 to 1;
    /// both may have noise, and both are black where nothing is. What is negative or no number in the light becomes 0.
    ///
    /// # Errors
    /// When the pictures are not whole or differ in size, when there are normals and no albedo, and when the library fails,
    /// for instance for want of memory.
    pub fn run(
        &self,
        light: &Image,
        albedo: Option<&Image>,
        normal: Option<&Image>,
        quality: Quality,
    ) -> Result<Image, DenoiseError> {
        check(light, albedo, normal)?;
        let failed = |text| DenoiseError::Failed { version: self.version(), text };
        let device = self.library.device(self.threads).map_err(failed)?;
        let task = Task { device, size: light.size, quality };
        let albedo = albedo.map(|image| task.prefilter(c"albedo", image)).transpose().map_err(failed)?;
        let normal = normal.map(|image| task.prefilter(c"normal", image)).transpose().map_err(failed)?;
        let color = floats(light);
        let mut inputs = vec![(c"color", color.as_slice())];
        inputs.extend(albedo.as_deref().map(|pixels| (c"albedo", pixels)));
        inputs.extend(normal.as_deref().map(|pixels| (c"normal", pixels)));
        // "cleanAux": the features have no noise any more.
        let claims: &[&CStr] = if albedo.is_some() { &[c"hdr", c"cleanAux"] } else { &[c"hdr"] };
        let clean = task.run(&inputs, claims).map_err(failed)?;
        let pixels = clean.as_chunks().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
        Ok(Image { size: light.size, pixels })
    }

    /// The picture of a film, without its noise; with the help of albedo and normals where the film has them.
    ///
    /// # Errors
    /// As [`Denoiser::run`].
    pub fn run_film(&self, film: &Film, quality: Quality) -> Result<Image, DenoiseError> {
        let light = film.image();
        // A renderer that makes no features leaves them black.
        let layers = film.layers().filter(|layers| layers.albedo.pixels.iter().any(|p| *p != Rgb::BLACK));
        let Some(Layers { albedo, normal, .. }) = layers else {
            return self.run(&light, None, None, quality);
        };
        let normal =
            Image { size: light.size, pixels: normal.iter().map(|n| Rgb::from(n.to_array())).collect() };
        self.run(&light, Some(&albedo), Some(&normal), quality)
    }
}

/// Filters for one picture.
struct Task<'a> {
    device: Device<'a>,
    size: [u32; 2],
    quality: Quality,
}

impl Task<'_> {
    /// Denoises a feature alone.
    fn prefilter(&self, name: &'static CStr, image: &Image) -> Result<Vec<f32>, String> {
        self.run(&[(name, &floats(image))], &[])
    }

    fn run(&self, inputs: &[(&'static CStr, &[f32])], claims: &[&'static CStr]) -> Result<Vec<f32>, String> {
        let size = self.size.map(|s| s as usize);
        self.device.filter(&Job { size, inputs, claims, quality: self.quality.number() })
    }
}

fn floats(image: &Image) -> Vec<f32> {
    image.pixels.iter().flat_map(|p| p.to_array()).collect()
}

/// Checks that the pictures belong together.
fn check(light: &Image, albedo: Option<&Image>, normal: Option<&Image>) -> Result<(), DenoiseError> {
    let pictures = [("light", Some(light)), ("albedo", albedo), ("normals", normal)];
    for (what, image) in pictures.into_iter().filter_map(|(what, image)| Some((what, image?))) {
        let (size, pixels) = (image.size, image.pixels.len());
        if pixels == 0 || size[0] as usize * size[1] as usize != pixels {
            return Err(DenoiseError::NotWhole { what, size, pixels });
        }
        if size != light.size {
            return Err(DenoiseError::OtherSize { what, size, light: light.size });
        }
    }
    if albedo.is_none() && normal.is_some() {
        return Err(DenoiseError::NormalsAlone);
    }
    Ok(())
}

#[cfg(test)]
mod tests;
