//! Picture files: those that a scene names, read by their content, and the finished pictures, written by extension. A
//! new format to write is a file beside these and a line in the register below.

mod exr;
mod exr_features;
mod exr_layers;
mod hdr;
mod jpeg;
mod panorama;
mod picture;
mod png;

pub use exr_features::{ExrFeatures, parse_exr_features, read_exr_features};
pub use exr_layers::{ExrLayers, encode_layers, write_layers};
pub use panorama::{parse_panorama, read_panorama};
pub use picture::{parse_picture, read_picture};

use crate::{FormatError, write_atomically};
use std::path::Path;
use vitrine_film::{Display, Image};

/// A format in which pictures are written.
#[derive(Clone, Copy, Debug)]
pub struct ImageFormat {
    /// Its name for people.
    pub name: &'static str,
    /// Its extensions in lower case, without the dot.
    pub extensions: &'static [&'static str],
    encode: fn(&Image, &WriteOptions) -> Result<Vec<u8>, String>,
}

/// The register of formats.
pub const IMAGE_FORMATS: &[ImageFormat] = &[png::FORMAT, jpeg::FORMAT, exr::FORMAT, hdr::FORMAT];

/// Bits of each channel of a PNG file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BitDepth {
    /// 8: 256 steps.
    #[default]
    Eight,
    /// 16: 65 536 steps.
    Sixteen,
}

/// How a picture is written.
#[derive(Clone, Debug, PartialEq)]
pub struct WriteOptions {
    /// PNG only.
    pub bits: BitDepth,
    /// JPEG only: 1 is small and poor, 100 large and fine.
    pub jpeg_quality: u8,
    /// For PNG and JPEG; OpenEXR and HDR keep linear light.
    pub display: Display,
    /// Keys and texts that go into the file. Known to other programs are "Software", "Description" and "Title"; own
    /// keys begin with "vitrine:". Keys are printable ASCII of at most 31 characters, without a space or `=`.
    pub metadata: Vec<(String, String)>,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self { bits: BitDepth::Eight, jpeg_quality: 92, display: Display::default(), metadata: Vec::new() }
    }
}

/// The format that the extension of a path names, in upper or lower case.
///
/// # Errors
/// [`FormatError::UnknownExtension`].
pub fn image_format(path: &Path) -> Result<&'static ImageFormat, FormatError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    let format = IMAGE_FORMATS.iter().find(|f| f.extensions.contains(&extension.as_str()));
    format.ok_or_else(|| FormatError::UnknownExtension {
        path: path.into(),
        what: "a picture",
        supported: crate::list_extensions(IMAGE_FORMATS.iter().flat_map(|f| f.extensions)),
    })
}

/// The bytes of a picture's file.
///
/// # Errors
/// [`FormatError::Encode`] when the picture or its metadata do not fit into the format.
pub fn encode(format: &ImageFormat, image: &Image, options: &WriteOptions) -> Result<Vec<u8>, FormatError> {
    let result = match refusal(image, options) {
        Some(reason) => Err(reason),
        None => (format.encode)(image, options),
    };
    result.map_err(|reason| FormatError::Encode { format: format.name, reason })
}

/// What no format can take of a picture and its metadata.
fn refusal(image: &Image, options: &WriteOptions) -> Option<String> {
    let [width, height] = image.size;
    if image.pixels.is_empty() || width as usize * height as usize != image.pixels.len() {
        return Some(format!("{width} × {height} pixels and {} colours", image.pixels.len()));
    }
    let bad_key = options.metadata.iter().map(|(key, _)| key).find(|key| !is_key(key));
    bad_key.map(|key| format!("`{key}` is no key for a text"))
}

/// Writes a picture; the extension says in which format. Either the whole file is there afterwards or what was there
/// before.
///
/// # Errors
/// As [`image_format`], [`encode`] and [`write_atomically`].
pub fn write_image(path: &Path, image: &Image, options: &WriteOptions) -> Result<(), FormatError> {
    let bytes = encode(image_format(path)?, image, options)?;
    write_atomically(path, &bytes)
}

/// Whether every format can take the key. 31 characters is what old readers of OpenEXR know.
fn is_key(key: &str) -> bool {
    (1..=31).contains(&key.len()) && key.bytes().all(|b| b.is_ascii_graphic() && b != b'=')
}

/// A text for a file's metadata: line ends and other control characters, which some formats cannot hold, become spaces.
fn one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}

#[cfg(test)]
mod tests;
