//! Pictures for textures: PNG and JPEG, told apart by their content.

use super::{jpeg, png};
use crate::{FormatError, disc};
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};
use std::io::Cursor;
use std::path::Path;
use vitrine_scene::Picture;

/// The most bytes of a file.
pub(super) const MAX_FILE: u64 = 1 << 30;
/// The most pixels along a side.
pub(super) const MAX_SIDE: u32 = 65_535;
/// The most pixels: 16384 × 8192.
pub(super) const MAX_PIXELS: u64 = 1 << 27;

/// Reads a PNG or JPEG file. 16 bits become 8, grey becomes colour, transparency is left out; a photograph is turned
/// as its camera was held.
///
/// # Errors
/// When the file cannot be read, is no such picture, is cut off, damaged or too large.
pub fn read_picture(path: &Path) -> Result<Picture, FormatError> {
    parse_picture(&disc::read(path, MAX_FILE)?, path)
}

/// As [`read_picture`], from the bytes of a file. `path` names it in messages.
///
/// # Errors
/// As [`read_picture`], the disc's apart.
pub fn parse_picture(bytes: &[u8], path: &Path) -> Result<Picture, FormatError> {
    let path = || path.to_path_buf();
    let format = match image::guess_format(bytes) {
        Ok(format @ (ImageFormat::Png | ImageFormat::Jpeg)) => format,
        other => return Err(FormatError::NotAPicture { path: path(), found: what_is(bytes, other.ok()) }),
    };
    let cut_off = match format {
        ImageFormat::Png => png::is_cut_off(bytes),
        _ => jpeg::is_cut_off(bytes),
    };
    let damaged = |error: ImageError| match error {
        _ if cut_off => FormatError::PictureCutOff { path: path() },
        error => FormatError::PictureDamaged { path: path(), reason: reason(&error) },
    };
    let mut decoder =
        ImageReader::with_format(Cursor::new(bytes), format).into_decoder().map_err(&damaged)?;
    let (width, height) = decoder.dimensions();
    if width > MAX_SIDE || height > MAX_SIDE || u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(FormatError::PictureTooLarge { path: path(), width, height });
    }
    if cut_off && format == ImageFormat::Jpeg {
        return Err(FormatError::PictureCutOff { path: path() });
    }
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_SIDE);
    limits.max_image_height = Some(MAX_SIDE);
    // Decoded with 16 bits in four channels, and as much again for the decoder's own work.
    limits.max_alloc = Some(MAX_PIXELS * 16);
    decoder.set_limits(limits).map_err(&damaged)?;
    let orientation = decoder.orientation().map_err(&damaged)?;
    let mut image = DynamicImage::from_decoder(decoder).map_err(&damaged)?;
    image.apply_orientation(orientation);
    let image = image.into_rgb8();
    let size = [image.width(), image.height()];
    Ok(Picture { size, texels: image.into_raw().as_chunks().0.to_vec() })
}

/// What a file is that no reader wants.
pub(super) fn what_is(bytes: &[u8], format: Option<ImageFormat>) -> Option<&'static str> {
    Some(match format {
        Some(ImageFormat::Gif) => "a GIF picture",
        Some(ImageFormat::WebP) => "a WebP picture",
        Some(ImageFormat::Tiff) => "a TIFF picture",
        Some(ImageFormat::Bmp) => "a BMP picture",
        Some(ImageFormat::Avif) => "an AVIF picture",
        Some(ImageFormat::OpenExr) => "an OpenEXR picture",
        Some(ImageFormat::Hdr) => "a Radiance HDR picture",
        Some(ImageFormat::Dds) => "a DDS picture",
        _ if bytes.is_empty() => "an empty file",
        _ if bytes.trim_ascii_start().starts_with(b"<") => "a web page, SVG or XML file",
        _ => return None,
    })
}

/// The decoder's reason, as one short line.
pub(super) fn reason(error: &ImageError) -> String {
    let text = match error {
        ImageError::Decoding(e) => {
            std::error::Error::source(e).map_or_else(|| e.to_string(), ToString::to_string)
        }
        other => other.to_string(),
    };
    text.lines().next().unwrap_or_default().trim_end_matches('.').to_owned()
}
