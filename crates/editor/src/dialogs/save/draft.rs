//! How a picture is to be saved, until the person accepts.

use std::path::{Path, PathBuf};
use std::time::Duration;
use vitrine::formats::BitDepth;
use vitrine::scene::{Renderer, Settings};
use vitrine::{WriteOptions, display_of};

/// The kind of file that a picture is saved as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// PNG, 256 steps for each colour.
    Png8,
    /// PNG, 65 536 steps.
    Png16,
    /// JPEG.
    Jpeg,
    /// OpenEXR, linear light.
    Exr,
    /// Radiance HDR, linear light.
    Hdr,
}

impl PictureFormat {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Png8, Self::Png16, Self::Jpeg, Self::Exr, Self::Hdr];

    /// The extension of its files, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png8 | Self::Png16 => "png",
            Self::Jpeg => "jpg",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// The key of its text.
    #[must_use]
    pub const fn text_key(self) -> &'static str {
        match self {
            Self::Png8 => "dialog-save-format-png8",
            Self::Png16 => "dialog-save-format-png16",
            Self::Jpeg => "dialog-save-format-jpeg",
            Self::Exr => "dialog-save-format-exr",
            Self::Hdr => "dialog-save-format-hdr",
        }
    }

    /// Whether a file of this name can have the format.
    #[must_use]
    pub fn fits(self, path: &Path) -> bool {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        extension == self.extension() || (self == Self::Jpeg && extension == "jpeg")
    }
}

/// Which picture is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureSource {
    /// The final render as far as it has come.
    Current,
    /// A new one.
    RenderNow,
}

/// A picture that a person wants on the disc.
#[derive(Clone, Debug, PartialEq)]
pub struct SavePictureRequest {
    /// Where; the extension is that of the format.
    pub path: PathBuf,
    /// How it is encoded.
    pub format: PictureFormat,
    /// Which picture.
    pub source: PictureSource,
    /// The settings of the scene with the size, samples and renderer asked for; what a new picture is rendered with.
    pub settings: Settings,
}

impl SavePictureRequest {
    /// How the file is written.
    #[must_use]
    pub fn write_options(&self, metadata: Vec<(String, String)>) -> WriteOptions {
        let bits = if self.format == PictureFormat::Png16 { BitDepth::Sixteen } else { BitDepth::Eight };
        WriteOptions { bits, metadata, display: display_of(&self.settings), ..WriteOptions::default() }
    }
}

/// The final render as far as it has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CurrentPicture {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Samples of each pixel.
    pub samples: u32,
}

/// Why a picture cannot be saved like this.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SaveFlaw {
    /// No file is named.
    NoPath,
    /// The folder does not exist.
    NoFolder,
    /// Too many pixels.
    TooLarge,
}

/// How a picture is to be saved.
#[derive(Clone, Debug, PartialEq)]
pub struct SaveDraft {
    /// The file as typed.
    pub path: String,
    /// Its kind.
    pub format: PictureFormat,
    /// Which picture.
    pub source: PictureSource,
    /// Size, samples, renderer and whatever else the scene says.
    pub settings: Settings,
    /// Whether width and height keep their ratio.
    pub keeps_ratio: bool,
    /// Width over height, when they keep it.
    ratio: f64,
}

impl SaveDraft {
    /// As the scene's settings say: the current picture if there is one, else a new one.
    #[must_use]
    pub fn new(path: &Path, settings: &Settings, current: Option<CurrentPicture>) -> Self {
        let fitting = PictureFormat::ALL.into_iter().find(|f| f.fits(path));
        let [width, height] = settings.size.map(f64::from);
        let mut draft = Self {
            path: path.to_string_lossy().into_owned(),
            format: fitting.unwrap_or(PictureFormat::Png8),
            source: if current.is_some() { PictureSource::Current } else { PictureSource::RenderNow },
            settings: settings.clone(),
            keeps_ratio: true,
            ratio: width / height,
        };
        draft.set_format(draft.format);
        draft
    }

    /// Chooses the kind of file; the name's extension follows.
    pub fn set_format(&mut self, format: PictureFormat) {
        self.format = format;
        let path = Path::new(self.path.trim());
        if path.file_name().is_some() && !format.fits(path) {
            // Of a name like "ball 1.5", only a known extension is one.
            let is_known = PictureFormat::ALL.iter().any(|f| f.fits(path));
            let path = if is_known { path.with_extension("") } else { path.to_owned() };
            let mut name = path.into_os_string();
            name.push(format!(".{}", format.extension()));
            self.path = name.to_string_lossy().into_owned();
        }
    }

    /// Takes a file that was chosen; its extension chooses the format.
    pub fn set_path(&mut self, path: &Path) {
        self.path = path.to_string_lossy().into_owned();
        let keeps = self.format.fits(path);
        let fitting = PictureFormat::ALL.into_iter().find(|f| f.fits(path)).filter(|_| !keeps);
        self.set_format(fitting.unwrap_or(self.format));
    }

    /// Sets the width; the height follows when they keep their ratio.
    pub fn set_width(&mut self, width: u32) {
        self.settings.size[0] = width;
        if self.keeps_ratio {
            self.settings.size[1] = pixels(f64::from(width) / self.ratio);
        }
    }

    /// Sets the height; the width follows when they keep their ratio.
    pub fn set_height(&mut self, height: u32) {
        self.settings.size[1] = height;
        if self.keeps_ratio {
            self.settings.size[0] = pixels(f64::from(height) * self.ratio);
        }
    }

    /// Sets both.
    pub fn set_size(&mut self, size: [u32; 2]) {
        self.settings.size = size;
        self.ratio = f64::from(size[0]) / f64::from(size[1]);
    }

    /// Ties width and height together as they are now, or unties them.
    pub fn set_keeps_ratio(&mut self, keeps: bool) {
        self.keeps_ratio = keeps;
        self.set_size(self.settings.size);
    }

    /// What stands in the way.
    #[must_use]
    pub fn flaw(&self) -> Option<SaveFlaw> {
        let path = Path::new(self.path.trim());
        let [width, height] = self.settings.size.map(u64::from);
        if path.file_name().is_none() {
            return Some(SaveFlaw::NoPath);
        }
        if path.parent().is_some_and(|p| !p.as_os_str().is_empty() && !p.is_dir()) {
            return Some(SaveFlaw::NoFolder);
        }
        let is_new = self.source == PictureSource::RenderNow;
        (is_new && width * height > Settings::MAX_PIXELS).then_some(SaveFlaw::TooLarge)
    }

    /// How long it will take at most, at so many samples of pixels a second of a renderer. None when that of this picture's
    /// renderer is not known.
    #[must_use]
    pub fn time(&self, samples_per_second: Option<(Renderer, f64)>) -> Option<Duration> {
        if self.source == PictureSource::Current {
            return Some(Duration::ZERO);
        }
        let [width, height] = self.settings.size.map(f64::from);
        let samples = width * height * f64::from(self.settings.samples);
        let (_, rate) = samples_per_second
            .filter(|(of, rate)| *of == self.settings.renderer && rate.is_finite() && *rate > 0.0)?;
        let limit = f64::from(self.settings.time_limit);
        let time = if limit > 0.0 { limit.min(samples / rate) } else { samples / rate };
        Duration::try_from_secs_f64(time).ok()
    }

    /// What was decided.
    #[must_use]
    pub fn request(&self) -> SavePictureRequest {
        let path = Path::new(self.path.trim());
        // A name that was typed without its extension gets it.
        let mut named = Self { path: path.to_string_lossy().into_owned(), ..self.clone() };
        named.set_format(self.format);
        SavePictureRequest {
            path: PathBuf::from(named.path),
            format: self.format,
            source: self.source,
            settings: self.settings.clone(),
        }
    }
}

/// The renderers to choose from, with the keys of their texts.
pub const RENDERERS: [(Renderer, &str); 3] = [
    (Renderer::Classic, "dialog-settings-renderer-classic"),
    (Renderer::Cast, "dialog-settings-renderer-cast"),
    (Renderer::Photoreal, "dialog-settings-renderer-photoreal"),
];

fn pixels(v: f64) -> u32 {
    // Casts of floats to integers saturate.
    (v.round() as u32).clamp(1, 32_768)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draft() -> SaveDraft {
        let settings = Settings { size: [800, 600], samples: 4, ..Settings::default() };
        SaveDraft::new(Path::new("ball.png"), &settings, None)
    }

    #[test]
    fn the_extension_follows_the_format_and_the_format_the_extension() {
        let mut draft = draft();
        draft.set_format(PictureFormat::Exr);
        assert_eq!(draft.path, "ball.exr");
        draft.set_path(Path::new("other.JPEG"));
        assert_eq!((draft.format, draft.path.as_str()), (PictureFormat::Jpeg, "other.JPEG"));
        draft.set_path(Path::new("ball 1.5"));
        assert_eq!(draft.path, "ball 1.5.jpg");
        draft.set_format(PictureFormat::Png16);
        draft.set_path(Path::new("again.png"));
        assert_eq!(draft.format, PictureFormat::Png16, "a PNG stays as fine as it was");
    }

    #[test]
    fn a_name_typed_without_extension_gets_one() {
        let draft = SaveDraft { path: " ball ".into(), ..draft() };
        assert_eq!(draft.request().path, Path::new("ball.png"));
    }

    #[test]
    fn width_and_height_keep_their_ratio_until_they_are_untied() {
        let mut draft = draft();
        draft.set_width(400);
        assert_eq!(draft.settings.size, [400, 300]);
        draft.set_height(1);
        draft.set_height(900);
        assert_eq!(draft.settings.size, [1200, 900], "the ratio survives tiny sizes");
        draft.set_keeps_ratio(false);
        draft.set_width(50);
        assert_eq!(draft.settings.size, [50, 900]);
        draft.set_keeps_ratio(true);
        draft.set_width(100);
        assert_eq!(draft.settings.size, [100, 1800]);
    }

    #[test]
    fn the_time_grows_with_pixels_and_samples() {
        let mut draft = draft();
        assert_eq!(draft.time(None), None);
        let at = |rate| Some((Renderer::Classic, rate));
        assert_eq!(draft.time(at(0.0)), None);
        assert_eq!(draft.time(at(480_000.0)), Some(Duration::from_secs(4)));
        draft.settings.samples = 8;
        assert_eq!(draft.time(at(480_000.0)), Some(Duration::from_secs(8)));
        assert_eq!(draft.time(Some((Renderer::Photoreal, 480_000.0))), None, "of another renderer");
        draft.settings.time_limit = 5.0;
        assert_eq!(draft.time(at(480_000.0)), Some(Duration::from_secs(5)));
        draft.source = PictureSource::Current;
        assert_eq!(draft.time(None), Some(Duration::ZERO));
    }

    #[test]
    fn what_cannot_be_saved_is_said() {
        let flaw = |path: &str, size| {
            let mut draft = SaveDraft { path: path.into(), ..draft() };
            draft.set_size(size);
            draft.flaw()
        };
        assert_eq!(flaw("  ", [8, 8]), Some(SaveFlaw::NoPath));
        assert_eq!(flaw("no such folder at all/a.png", [8, 8]), Some(SaveFlaw::NoFolder));
        assert_eq!(flaw("a.png", [32_768, 32_768]), Some(SaveFlaw::TooLarge));
        assert_eq!(flaw("a.png", [8, 8]), None);
    }
}
