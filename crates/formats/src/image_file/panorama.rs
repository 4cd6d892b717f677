//! Panoramas for lights: OpenEXR and Radiance HDR with true brightness, PNG and JPEG without, told apart by their content.

use super::exr::read_linear;
use super::picture::{MAX_FILE, MAX_PIXELS, MAX_SIDE, parse_picture, reason, what_is};
use crate::{FormatError, disc};
use image::codecs::hdr::HdrDecoder;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, Limits};
use std::io::{Cursor, ErrorKind};
use std::path::Path;
use vitrine_math::Rgb;
use vitrine_scene::RadianceMap;

/// The brightest radiance that is taken; the sun's is a hundred thousand times that of the sky.
const BRIGHTEST: f32 = 1e15;

/// Reads a panorama. The warnings, one sentence each with the path, say what has been mended.
///
/// # Errors
/// When the file cannot be read, is no such picture, is cut off, damaged or too large.
pub fn read_panorama(path: &Path) -> Result<(RadianceMap, Vec<String>), FormatError> {
    parse_panorama(&disc::read(path, MAX_FILE)?, path)
}

/// As [`read_panorama`], from the bytes of a file. `path` names it in messages.
///
/// # Errors
/// As [`read_panorama`], the disc's apart.
pub fn parse_panorama(bytes: &[u8], path: &Path) -> Result<(RadianceMap, Vec<String>), FormatError> {
    let mut map = match image::guess_format(bytes) {
        Ok(ImageFormat::OpenExr) => read_exr(bytes, path)?,
        _ if bytes.starts_with(b"#?") => read_hdr(bytes, path)?,
        Ok(ImageFormat::Png | ImageFormat::Jpeg) => {
            let picture = parse_picture(bytes, path)?;
            let [width, height] = picture.size;
            let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            RadianceMap { size: picture.size, pixels: places.map(|(x, y)| picture.texel(x, y)).collect() }
        }
        other => {
            let found = what_is(bytes, other.ok());
            return Err(FormatError::NotAPanorama { path: path.into(), found });
        }
    };
    let mut warnings = Vec::new();
    let mended = mend(&mut map.pixels);
    if mended > 0 {
        let texels = if mended == 1 { "1 texel is".into() } else { format!("{mended} texels are") };
        let why =
            "not a number, infinite or negative; they have been made black or as bright as the brightest";
        warnings.push(format!("in a panorama {texels} {why}: {}", path.display()));
    }
    let [width, height] = map.size.map(u64::from);
    if width != 2 * height && height > 1 {
        let why = "is not twice as wide as high and will look stretched";
        warnings.push(format!("a panorama of {width} × {height} pixels {why}: {}", path.display()));
    }
    Ok((map, warnings))
}

fn read_exr(bytes: &[u8], path: &Path) -> Result<RadianceMap, FormatError> {
    let fault = |error| match error {
        exr::error::Error::NotSupported(reason) | exr::error::Error::Invalid(reason) => {
            FormatError::PictureDamaged { path: path.into(), reason: reason.into_owned() }
        }
        exr::error::Error::Io(error) if error.kind() == ErrorKind::UnexpectedEof => {
            FormatError::PictureCutOff { path: path.into() }
        }
        other => FormatError::PictureDamaged { path: path.into(), reason: other.to_string() },
    };
    let (size, pixels) = read_linear(bytes, |size| check_size(size, path)).map_err(|e| match e {
        Ok(refused) => refused,
        Err(error) => fault(error),
    })?;
    Ok(RadianceMap { size, pixels })
}

fn read_hdr(bytes: &[u8], path: &Path) -> Result<RadianceMap, FormatError> {
    let damaged = |error: ImageError| match error {
        ImageError::IoError(e) if e.kind() == ErrorKind::UnexpectedEof => {
            FormatError::PictureCutOff { path: path.into() }
        }
        error => FormatError::PictureDamaged { path: path.into(), reason: reason(&error) },
    };
    // Not strict: some programs write another first line.
    let mut decoder = HdrDecoder::new_nonstrict(Cursor::new(bytes)).map_err(damaged)?;
    let (width, height) = decoder.dimensions();
    check_size([width, height], path)?;
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_PIXELS * 16);
    decoder.set_limits(limits).map_err(damaged)?;
    let image = DynamicImage::from_decoder(decoder).map_err(damaged)?.into_rgb32f();
    let pixels = image.pixels().map(|p| Rgb::from(p.0)).collect();
    Ok(RadianceMap { size: [width, height], pixels })
}

fn check_size([width, height]: [u32; 2], path: &Path) -> Result<(), FormatError> {
    if width == 0 || height == 0 {
        return Err(FormatError::PictureDamaged { path: path.into(), reason: "it has no pixels".into() });
    }
    if width > MAX_SIDE || height > MAX_SIDE || u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(FormatError::PictureTooLarge { path: path.into(), width, height });
    }
    Ok(())
}

/// Makes what is no radiance one, and counts such texels: no numbers and what is negative become black, what is brighter than
/// any light as bright as the brightest channel that is one.
fn mend(pixels: &mut [Rgb]) -> usize {
    let is_sound = |c: &f32| (0.0..=BRIGHTEST).contains(c);
    let channels = pixels.iter().flat_map(|p| p.to_array());
    let brightest = channels.filter(is_sound).fold(0.0, f32::max);
    let mut mended = 0;
    for pixel in pixels {
        let channels = pixel.to_array();
        if !channels.iter().all(is_sound) {
            let mend = |c: f32| {
                if c > BRIGHTEST {
                    brightest
                } else if is_sound(&c) {
                    c
                } else {
                    0.0
                }
            };
            *pixel = Rgb::from(channels.map(mend));
            mended += 1;
        }
    }
    mended
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{WriteOptions, encode, image_format};
    use proptest::prelude::*;
    use vitrine_film::Image;

    fn file(extension: &str, image: &Image) -> Vec<u8> {
        let format = image_format(Path::new(&format!("a.{extension}"))).unwrap();
        encode(format, image, &WriteOptions::default()).unwrap()
    }

    fn read(bytes: &[u8]) -> Result<(RadianceMap, Vec<String>), FormatError> {
        parse_panorama(bytes, Path::new("street.hdr"))
    }

    fn bright() -> Image {
        let pixels = (0..32).map(|i| Rgb::new(i as f32 * 8.0, 0.25, 1024.0)).collect();
        Image { size: [8, 4], pixels }
    }

    #[test]
    fn light_comes_back_from_openexr_exactly_and_from_hdr_within_its_steps() {
        let image = bright();
        for (extension, most) in [("exr", 0.0), ("hdr", 0.005)] {
            let (map, warnings) = read(&file(extension, &image)).unwrap();
            assert_eq!((map.size, warnings.len()), ([8, 4], 0), "{extension}");
            for (read, wanted) in map.pixels.iter().zip(&image.pixels) {
                let off = (read.r - wanted.r).abs() / 1024.0;
                assert!(off <= most, "{extension}: {read:?} for {wanted:?}");
            }
        }
    }

    #[test]
    fn pictures_of_a_display_become_linear_light() {
        let image = Image::filled([4, 2], Rgb::from_srgb8([188, 0, 255]));
        let (map, _) = read(&file("png", &image)).unwrap();
        assert_eq!(map.pixels, vec![Rgb::from_srgb8([188, 0, 255]); 8]);
    }

    #[test]
    fn what_is_no_light_is_mended_counted_and_named() {
        let mut image = bright();
        image.pixels[3] = Rgb::new(f32::NAN, 1.0, -2.0);
        image.pixels[9] = Rgb::splat(f32::INFINITY);
        let (map, warnings) = read(&file("exr", &image)).unwrap();
        assert_eq!(map.pixels[3], Rgb::new(0.0, 1.0, 0.0));
        assert_eq!(map.pixels[9], Rgb::splat(1024.0), "the brightest that is a number");
        assert_eq!(warnings.len(), 1);
        assert!(warnings[0].contains("2 texels") && warnings[0].ends_with(": street.hdr"), "{warnings:?}");
    }

    #[test]
    fn a_panorama_of_another_shape_is_a_warning() {
        let (_, warnings) = read(&file("hdr", &Image::filled([9, 9], Rgb::WHITE))).unwrap();
        assert_eq!(
            warnings,
            ["a panorama of 9 × 9 pixels is not twice as wide as high and will look stretched: street.hdr"]
        );
    }

    #[test]
    fn a_cut_file_is_an_error_wherever_it_is_cut() {
        for extension in ["exr", "hdr"] {
            let whole = file(extension, &bright());
            for length in 0..whole.len() - 1 {
                assert!(read(&whole[..length]).is_err(), "{extension} of {length} bytes");
            }
        }
    }

    #[test]
    fn sizes_are_checked_before_memory_is_taken() {
        let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n";
        assert!(matches!(read(hdr), Err(FormatError::PictureTooLarge { width: 60_000, .. })));
        let mut exr = file("exr", &bright());
        // The data window: four numbers, of which the third is the last column.
        let window = exr.windows(10).position(|w| w == b"dataWindow").unwrap() + 10 + 1 + 6 + 4;
        exr[window + 8..window + 16].copy_from_slice(&[0xff, 0xff, 0xff, 0x3f].repeat(2));
        assert!(matches!(
            read(&exr),
            Err(FormatError::PictureTooLarge { .. } | FormatError::PictureDamaged { .. })
        ));
    }

    #[test]
    fn what_is_no_panorama_is_called_by_its_name() {
        let error = read(b"GIF89a......").unwrap_err();
        assert_eq!(
            error.to_string(),
            "this is not an OpenEXR, HDR, PNG or JPEG picture but a GIF picture: street.hdr"
        );
    }

    proptest! {
        #[test]
        fn any_damage_is_an_error_or_a_map_of_radiances(
            exr: bool, places in proptest::collection::vec((0_usize..2000, 0_u8..=255), 1..8)
        ) {
            let mut bytes = file(if exr { "exr" } else { "hdr" }, &bright());
            for (place, byte) in places {
                let length = bytes.len();
                bytes[place % length] = byte;
            }
            if let Ok((map, _)) = read(&bytes) {
                prop_assert_eq!(map.pixels.len(), map.size[0] as usize * map.size[1] as usize);
                prop_assert!(map.pixels.iter().all(|p| p.to_array().iter().all(|c| *c >= 0.0 && *c <= BRIGHTEST)));
            }
        }
    }
}
