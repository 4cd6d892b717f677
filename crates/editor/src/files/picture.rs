//! Saving the picture: size, samples, renderer and format, how long it will take, and the file.

use crate::tr;
use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Duration;
use vitrine::film::Image;
use vitrine::formats::{BitDepth, FormatError, WriteOptions, write_image};
use vitrine::scene::{Renderer, Settings};

/// A format for pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PictureFormat {
    /// PNG with 8 bits a channel.
    #[default]
    Png,
    /// PNG with 16 bits a channel.
    Png16,
    /// JPEG.
    Jpeg,
    /// OpenEXR: linear light.
    Exr,
    /// Radiance HDR: linear light.
    Hdr,
}

impl PictureFormat {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Png, Self::Png16, Self::Jpeg, Self::Exr, Self::Hdr];

    /// The extension of its files, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png | Self::Png16 => "png",
            Self::Jpeg => "jpg",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// The format that an extension means, in upper or lower case. None when it means none.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_string_lossy().to_lowercase();
        if extension == "jpeg" {
            return Some(Self::Jpeg);
        }
        Self::ALL.into_iter().find(|format| format.extension() == extension)
    }
}

impl fmt::Display for PictureFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Png => "PNG",
            Self::Png16 => "PNG 16",
            Self::Jpeg => "JPEG",
            Self::Exr => "OpenEXR",
            Self::Hdr => "Radiance HDR",
        })
    }
}

/// How a picture is to be made and saved.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureOptions {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Rays through each pixel.
    pub samples: u32,
    /// How it is made.
    pub renderer: Renderer,
    /// How it is written.
    pub format: PictureFormat,
    /// The file.
    pub path: PathBuf,
}

impl PictureOptions {
    /// As the scene says, into a new file beside it. `title` is the scene's name.
    #[must_use]
    pub fn of(settings: &Settings, folder: &Path, title: &str) -> Self {
        let format = PictureFormat::default();
        Self {
            size: settings.size,
            samples: settings.samples,
            renderer: settings.renderer,
            format,
            path: free_path(folder, title, format),
        }
    }

    /// Another format; the path follows.
    pub fn set_format(&mut self, format: PictureFormat) {
        self.format = format;
        self.path.set_extension(format.extension());
    }

    /// The scene's settings with these in their place.
    #[must_use]
    pub fn settings(&self, scene: &Settings) -> Settings {
        Settings { size: self.size, samples: self.samples, renderer: self.renderer, ..scene.clone() }
    }

    /// How many samples the picture takes.
    #[must_use]
    pub fn samples_total(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1]) * u64::from(self.samples)
    }

    /// Writes the finished picture. `metadata` says how it was made.
    ///
    /// # Errors
    /// When the picture does not fit into the format, or the file cannot be written; then what was there is as it was.
    pub fn write(&self, image: &Image, metadata: Vec<(String, String)>) -> Result<(), FormatError> {
        let bits = if self.format == PictureFormat::Png16 { BitDepth::Sixteen } else { BitDepth::Eight };
        write_image(&self.path, image, &WriteOptions { bits, metadata, ..WriteOptions::default() })
    }
}

/// A path in the folder that no file has yet: "ball.png", "ball-2.png".
fn free_path(folder: &Path, title: &str, format: PictureFormat) -> PathBuf {
    let bad = |c: char| c.is_control() || "/\\:*?\"<>|".contains(c);
    let clean = title.replace(bad, " ");
    let name = Some(clean.trim().trim_matches('.')).filter(|name| !name.is_empty());
    let name = name.map_or_else(|| tr!("files-picture-name"), str::to_owned);
    let path = |suffix: &str| folder.join(format!("{name}{suffix}.{}", format.extension()));
    let numbered = (2..10_000).map(|n| path(&format!("-{n}")));
    std::iter::once(path("")).chain(numbered).find(|p| !p.exists()).unwrap_or_else(|| path(""))
}

/// How fast pictures of the scene are made, learned from those that have been.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RenderRate {
    /// Samples a second.
    rate: Option<f64>,
}

impl RenderRate {
    /// So many samples took so long. Later ones count more than earlier ones.
    pub fn note(&mut self, samples: u64, time: Duration) {
        // What was over at once says nothing.
        if samples == 0 || time < Duration::from_millis(1) {
            return;
        }
        let new = samples as f64 / time.as_secs_f64();
        self.rate = Some(self.rate.map_or(new, |old| 0.5 * old + 0.5 * new));
    }

    /// The scene has changed: what was learned does not hold.
    pub fn forget(&mut self) {
        self.rate = None;
    }

    /// How long so many samples will take. None while nothing is known.
    #[must_use]
    pub fn estimate(&self, samples: u64) -> Option<Duration> {
        Duration::try_from_secs_f64(samples as f64 / self.rate?).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use vitrine::math::Rgb;

    #[test]
    fn a_new_picture_gets_a_name_that_no_file_has() {
        let folder = tempfile::tempdir().unwrap();
        let path = |title: &str| PictureOptions::of(&Settings::default(), folder.path(), title).path;
        assert_eq!(path("ball"), folder.path().join("ball.png"));
        fs::write(path("ball"), "").unwrap();
        fs::write(path("ball"), "").unwrap();
        assert_eq!(path("ball"), folder.path().join("ball-3.png"));
        assert_eq!(path("a/b: c"), folder.path().join("a b  c.png"));
        assert_eq!(path(" .. "), folder.path().join("picture.png"));
    }

    #[test]
    fn every_format_is_written_as_what_its_extension_says() {
        let folder = tempfile::tempdir().unwrap();
        let mut options = PictureOptions::of(&Settings::default(), folder.path(), "a");
        let image = Image::filled([4, 3], Rgb::WHITE);
        for format in PictureFormat::ALL {
            options.set_format(format);
            options.write(&image, vec![("Software".into(), "Vitrine".into())]).unwrap();
            let found = PictureFormat::of_path(&options.path).unwrap();
            assert_eq!(found.extension(), format.extension());
            let bytes = fs::read(&options.path).unwrap();
            let start: &[u8] = match format {
                PictureFormat::Png | PictureFormat::Png16 => b"\x89PNG",
                PictureFormat::Jpeg => b"\xff\xd8",
                PictureFormat::Exr => b"\x76\x2f\x31\x01",
                PictureFormat::Hdr => b"#?RADIANCE",
            };
            assert!(bytes.starts_with(start), "{format}");
            if format == PictureFormat::Png16 {
                assert_eq!(bytes[24], 16, "bits");
            }
        }
        assert_eq!(PictureFormat::of_path(Path::new("a.JPEG")), Some(PictureFormat::Jpeg));
        assert_eq!(PictureFormat::of_path(Path::new("a.gif")), None);
    }

    #[test]
    fn a_missing_folder_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let options = PictureOptions::of(&Settings::default(), &folder.path().join("none"), "a");
        let refused = options.write(&Image::filled([1, 1], Rgb::WHITE), Vec::new());
        assert!(matches!(refused, Err(FormatError::MissingFolder { .. })), "{refused:?}");
    }

    #[test]
    fn the_time_follows_from_what_was_measured() {
        let mut rate = RenderRate::default();
        assert_eq!(rate.estimate(100), None);
        rate.note(1000, Duration::from_secs(1));
        rate.note(5, Duration::ZERO);
        assert_eq!(rate.estimate(5000), Some(Duration::from_secs(5)));
        rate.note(3000, Duration::from_secs(1));
        assert_eq!(rate.estimate(4000), Some(Duration::from_secs(2)), "2000 a second in between");
        rate.forget();
        assert_eq!(rate.estimate(1), None);
    }

    #[test]
    fn options_stand_in_place_of_the_scenes_settings() {
        let scene = Settings { depth: 7, ..Settings::default() };
        let mut options = PictureOptions::of(&scene, Path::new(""), "a");
        (options.size, options.samples, options.renderer) = ([10, 20], 5, Renderer::Cast);
        let settings = options.settings(&scene);
        assert_eq!((settings.depth, settings.size, settings.renderer), (7, [10, 20], Renderer::Cast));
        assert_eq!(options.samples_total(), 1000);
    }
}
