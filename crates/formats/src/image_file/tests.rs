//! Tests of reading and writing pictures.

use super::*;
use ::image::{DynamicImage, ImageDecoder, ImageReader, RgbaImage};
use proptest::prelude::*;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use vitrine_math::{Rgb, linear_from_srgb};

fn format(extension: &str) -> &'static ImageFormat {
    image_format(Path::new(&format!("a.{extension}"))).unwrap()
}

/// A picture with smooth ramps, flat parts and light beyond white.
fn ramps(size: [u32; 2]) -> Image {
    let mut image = Image::filled(size, Rgb::new(0.2, 0.4, 0.6));
    for (i, pixel) in image.pixels.iter_mut().enumerate().filter(|(i, _)| i % 13 > 5) {
        let t = i as f32 / 97.0;
        *pixel = Rgb::new(t.fract(), t * t * 1e-4, 3.0 * (t * 0.37).fract());
    }
    image
}

fn with_metadata() -> WriteOptions {
    let metadata =
        [("Software", "Vitrine 1"), ("Description", "Стеклянный шар\nline 2"), ("vitrine:seed", "7")];
    WriteOptions {
        metadata: metadata.map(|(k, v)| (k.to_owned(), v.to_owned())).to_vec(),
        ..WriteOptions::default()
    }
}

fn contains(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|w| w == text.as_bytes())
}

#[test]
fn png_comes_back_exactly_in_8_and_16_bits_with_its_texts() {
    let image = ramps([70, 30]);
    let display = Display::default();
    for bits in [BitDepth::Eight, BitDepth::Sixteen] {
        let options = WriteOptions { bits, ..with_metadata() };
        let file = encode(format("png"), &image, &options).unwrap();
        match ::image::load_from_memory(&file).unwrap() {
            DynamicImage::ImageRgb8(read) => assert_eq!(*read, display.to_u8(&image)),
            DynamicImage::ImageRgb16(read) => assert_eq!(*read, display.to_u16(&image)),
            other => panic!("{:?}", other.color()),
        }
        let mut reader = ::png::Decoder::new(Cursor::new(&file)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        reader.finish().unwrap();
        let info = reader.info();
        assert_eq!(info.srgb, Some(::png::SrgbRenderingIntent::Perceptual));
        let latin: Vec<_> =
            info.uncompressed_latin1_text.iter().map(|t| (t.keyword.as_str(), t.text.as_str())).collect();
        assert_eq!(latin, [("Software", "Vitrine 1"), ("vitrine:seed", "7")]);
        assert_eq!(info.utf8_text[0].keyword, "Description");
        assert_eq!(info.utf8_text[0].get_text().unwrap(), "Стеклянный шар line 2");
    }
}

#[test]
fn png16_is_right_to_one_step() {
    let image = ramps([64, 64]);
    let options = WriteOptions { bits: BitDepth::Sixteen, ..WriteOptions::default() };
    let file = encode(format("png"), &image, &options).unwrap();
    let read = ::image::load_from_memory(&file).unwrap().into_rgb16();
    for (pixel, read) in image.pixels.iter().zip(read.pixels()) {
        for (wanted, step) in pixel.to_array().into_iter().zip(read.0) {
            let curve = vitrine_math::srgb_from_linear(wanted.clamp(0.0, 1.0));
            assert!((curve - f32::from(step) / 65_535.0).abs() <= 1.0 / 65_535.0);
        }
    }
}

#[test]
fn exr_is_exact_and_the_same_file_each_time() {
    let mut image = ramps([33, 21]);
    image.pixels[0] = Rgb::new(-1.5, 1e-40, f32::MAX);
    let file = encode(format("exr"), &image, &with_metadata()).unwrap();
    let read = exr_image(&file);
    assert_eq!(read, image);
    for _ in 0..20 {
        assert_eq!(encode(format("exr"), &image, &with_metadata()).unwrap(), file);
    }
    let meta = ::exr::meta::MetaData::read_from_buffered(Cursor::new(&file), true).unwrap();
    let header = &meta.headers[0];
    assert!(header.shared_attributes.chromaticities.is_some());
    let text = |name: &str| match header.all_named_attributes().find(|(n, _)| *n == name.as_bytes()) {
        Some((_, ::exr::prelude::AttributeValue::Text(text))) => {
            String::from_utf8(text.bytes().to_vec()).unwrap()
        }
        other => panic!("{name}: {other:?}"),
    };
    assert_eq!(text("vitrine:seed"), "7");
    assert_eq!(text("Software"), "Vitrine 1");
    assert_eq!(text("comments"), "Стеклянный шар line 2");
}

fn exr_image(file: &[u8]) -> Image {
    use ::exr::prelude::*;
    let read = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| vitrine_film::Image::filled([size.x() as u32, size.y() as u32], Rgb::BLACK),
            |image, place, (r, g, b): (f32, f32, f32)| {
                image.pixels[place.y() * image.size[0] as usize + place.x()] = Rgb::new(r, g, b);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(file))
        .unwrap();
    read.layer_data.channel_data.pixels
}

#[test]
fn hdr_keeps_light_within_its_precision_and_has_its_texts() {
    for size in [[7, 5], [8, 3], [300, 4], [1, 1]] {
        let mut image = ramps(size);
        image.pixels[0] = Rgb::new(1000.0, 500.0, 0.001);
        let file = encode(format("hdr"), &image, &with_metadata()).unwrap();
        let read = ::image::load_from_memory(&file).unwrap().into_rgb32f();
        assert_eq!([read.width(), read.height()], size);
        for (wanted, read) in image.pixels.iter().zip(read.pixels()) {
            let largest = wanted.to_array().into_iter().fold(0.0, f32::max);
            for (wanted, read) in wanted.to_array().into_iter().zip(read.0) {
                assert!((wanted - read).abs() <= largest / 256.0, "{wanted} came back as {read}");
            }
        }
        let header = String::from_utf8_lossy(&file);
        for line in ["SOFTWARE=Vitrine 1\n", "Description=Стеклянный шар line 2\n", "vitrine:seed=7\n"]
        {
            assert!(header.contains(line), "{line}");
        }
    }
}

#[test]
fn hdr_takes_extremes() {
    let odd = [f32::NAN, -1.0, f32::INFINITY, f32::MAX, 1e-39, 1e-38, 0.999_999, 255.99 / 256.0];
    let image = Image { size: [8, 1], pixels: odd.map(Rgb::splat).to_vec() };
    let file = encode(format("hdr"), &image, &WriteOptions::default()).unwrap();
    let read = ::image::load_from_memory(&file).unwrap().into_rgb32f();
    let read: Vec<f32> = read.pixels().map(|p| p.0[0]).collect();
    assert_eq!(read[..2], [0.0, 0.0]);
    assert!(read[2] > 1.6e38 && read[3] > 1.6e38, "{read:?}");
    assert_eq!(read[4], 0.0, "below the smallest exponent");
    assert!((read[5] - 1e-38).abs() < 1e-40, "{}", read[5]);
    assert_eq!(read[6..], [1.0, 1.0], "rounded up to the next exponent");
}

#[test]
fn jpeg_is_near_and_has_its_texts() {
    let image = Image::filled([40, 24], Rgb::new(0.2, 0.5, 0.1));
    let file = encode(format("jpg"), &image, &with_metadata()).unwrap();
    let read = ::image::load_from_memory(&file).unwrap().into_rgb8();
    assert_eq!((read.width(), read.height()), (40, 24));
    let wanted = Display::default().to_u8(&image);
    assert!(read.iter().zip(&wanted).all(|(a, b)| a.abs_diff(*b) <= 3));
    assert!(contains(&file, "Software: Vitrine 1\nDescription: Стеклянный шар line 2\nvitrine:seed: 7"));
    let small =
        encode(format("jpeg"), &ramps([40, 24]), &WriteOptions { jpeg_quality: 10, ..with_metadata() });
    let large =
        encode(format("jpeg"), &ramps([40, 24]), &WriteOptions { jpeg_quality: 100, ..with_metadata() });
    assert!(small.unwrap().len() < large.unwrap().len());
}

#[test]
fn long_texts_do_not_break_a_jpeg() {
    let metadata = vec![("Description".to_owned(), "ж".repeat(70_000))];
    let options = WriteOptions { metadata, ..WriteOptions::default() };
    let file = encode(format("jpg"), &Image::filled([8, 8], Rgb::WHITE), &options).unwrap();
    assert!(::image::load_from_memory(&file).is_ok());
}

#[test]
fn what_fits_no_format_is_an_error() {
    let options = WriteOptions::default();
    let image = Image { size: [2, 2], pixels: vec![Rgb::BLACK; 3] };
    let none = Image { size: [0, 0], pixels: vec![] };
    let wide = Image::filled([65_536, 1], Rgb::BLACK);
    for (extension, image) in [("png", &image), ("png", &none), ("jpg", &wide)] {
        let error = encode(format(extension), image, &options).unwrap_err();
        assert!(matches!(error, FormatError::Encode { .. }), "{error}");
    }
    for key in ["", "two words", "a=b", "ключ", "a-key-that-is-longer-than-31-characters"] {
        let options = WriteOptions { metadata: vec![(key.into(), "x".into())], ..options.clone() };
        assert!(encode(format("hdr"), &Image::filled([1, 1], Rgb::BLACK), &options).is_err(), "{key}");
    }
}

#[test]
fn the_extension_chooses_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let image = ramps([16, 9]);
    for (name, start) in [
        ("a.png", &b"\x89PNG"[..]),
        ("a.JPG", b"\xff\xd8"),
        ("a.jpeg", b"\xff\xd8"),
        ("a.exr", b"v/1\x01"),
        ("a.hdr", b"#?"),
    ] {
        let path = folder.path().join(name);
        write_image(&path, &image, &WriteOptions::default()).unwrap();
        assert!(fs::read(&path).unwrap().starts_with(start), "{name}");
    }
    for name in ["a.gif", "a", "png"] {
        let error = write_image(&folder.path().join(name), &image, &WriteOptions::default()).unwrap_err();
        assert_eq!(error.help(), "known are .png, .jpg, .jpeg, .exr, .hdr");
    }
}

fn read_bytes(bytes: &[u8]) -> Result<vitrine_scene::Picture, FormatError> {
    parse_picture(bytes, Path::new("a.png"))
}

fn saved(image: &DynamicImage, format: ::image::ImageFormat) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    image.write_to(&mut file, format).unwrap();
    file.into_inner()
}

#[test]
fn pictures_of_every_kind_become_8_bit_colour() {
    use ::image::ImageFormat::{Jpeg, Png};
    let colors = RgbaImage::from_fn(5, 3, |x, y| [x as u8 * 51, y as u8 * 100, 77, 255 - x as u8].into());
    let image = DynamicImage::ImageRgba8(colors);
    let wanted = |x: usize, y: usize| [x as u8 * 51, y as u8 * 100, 77];
    for image in [image.clone(), image.to_rgb8().into(), image.to_rgba16().into(), image.to_rgb16().into()] {
        let picture = read_bytes(&saved(&image, Png)).unwrap();
        assert_eq!(picture.size, [5, 3]);
        for (i, texel) in picture.texels.iter().enumerate() {
            assert_eq!(*texel, wanted(i % 5, i / 5));
        }
    }
    for grey in
        [image.to_luma8().into(), image.to_luma16().into(), DynamicImage::from(image.to_luma_alpha8())]
    {
        let picture = read_bytes(&saved(&grey, Png)).unwrap();
        assert!(picture.texels.iter().all(|[r, g, b]| r == g && g == b));
    }
    let picture = read_bytes(&saved(&image.to_rgb8().into(), Jpeg)).unwrap();
    assert_eq!(picture.size, [5, 3], "whatever the extension says");
}

#[test]
fn linear_colours_of_texels() {
    let picture = vitrine_scene::Picture { size: [1, 1], texels: vec![[188, 0, 255]] };
    let color = picture.texel(0, 0);
    assert_eq!(color.to_array(), [linear_from_srgb(188.0 / 255.0), 0.0, 1.0]);
}

#[test]
fn a_photograph_is_turned_as_the_camera_was_held() {
    let image = DynamicImage::ImageRgb8(::image::RgbImage::from_fn(16, 8, |x, _| {
        [if x < 8 { 255 } else { 0 }; 3].into()
    }));
    let mut file = saved(&image, ::image::ImageFormat::Jpeg);
    // EXIF with one entry: orientation 6, "turn 90° clockwise".
    let exif = b"Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0";
    let mut segment = vec![0xff, 0xe1, 0, exif.len() as u8 + 2];
    segment.extend(exif);
    file.splice(2..2, segment);
    let picture = read_bytes(&file).unwrap();
    assert_eq!(picture.size, [8, 16]);
    assert!(picture.texels[0][0] > 250 && picture.texels[8 * 15][0] < 5, "left went up");
}

#[test]
fn a_picture_that_is_cut_off_says_so_wherever_it_is_cut() {
    let image = ramps([20, 20]);
    for (extension, magic) in [("png", 8), ("jpg", 3)] {
        let file = encode(format(extension), &image, &with_metadata()).unwrap();
        assert!(read_bytes(&file).is_ok());
        for length in magic..file.len() - 12 {
            let error = read_bytes(&file[..length]).unwrap_err();
            assert!(
                matches!(error, FormatError::PictureCutOff { .. }),
                "{extension} of {length} bytes: {error}"
            );
        }
    }
    assert_eq!(
        read_bytes(&encode(format("png"), &image, &with_metadata()).unwrap()[..99]).unwrap_err().to_string(),
        "the picture is cut off, its file ends too early: a.png"
    );
}

#[test]
fn what_is_no_picture_is_called_by_its_name() {
    let message = |bytes: &[u8]| read_bytes(bytes).unwrap_err().to_string();
    assert_eq!(message(b"GIF89a......"), "this is not a PNG or JPEG picture but a GIF picture: a.png");
    assert_eq!(message(b""), "this is not a PNG or JPEG picture but an empty file: a.png");
    assert_eq!(
        message(b" <!DOCTYPE html>"),
        "this is not a PNG or JPEG picture but a web page, SVG or XML file: a.png"
    );
    assert_eq!(message(&[7; 100]), "this is not a PNG or JPEG picture: a.png");
    let hdr = encode(format("hdr"), &ramps([4, 4]), &WriteOptions::default()).unwrap();
    assert!(message(&hdr).contains("Radiance HDR"));
}

#[test]
fn damage_inside_a_picture_is_an_error() {
    let mut file = encode(format("png"), &ramps([40, 40]), &WriteOptions::default()).unwrap();
    let middle = file.len() / 2;
    file[middle] ^= 0x55;
    let error = read_bytes(&file).unwrap_err();
    assert!(matches!(error, FormatError::PictureDamaged { .. }), "{error}");
}

#[test]
fn sizes_are_checked_before_memory_is_taken() {
    // The header of a PNG of 65 535 × 65 535 pixels, and an empty one's.
    let mut file = encode(format("png"), &ramps([4, 4]), &WriteOptions::default()).unwrap();
    let mut with_size = |size: u32| {
        file[16..20].copy_from_slice(&size.to_be_bytes());
        file[20..24].copy_from_slice(&size.to_be_bytes());
        let sum = crc32(&file[12..29]);
        file[29..33].copy_from_slice(&sum.to_be_bytes());
        read_bytes(&file).unwrap_err()
    };
    assert!(matches!(with_size(65_535), FormatError::PictureTooLarge { width: 65_535, .. }));
    assert!(matches!(with_size(0), FormatError::PictureDamaged { .. }));
    assert!(matches!(with_size(3_000_000_000), FormatError::PictureDamaged { .. }));
}

/// The checksum of PNG chunks.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, b| {
        (0..8).fold(sum ^ u32::from(*b), |s, _| if s & 1 == 1 { s >> 1 ^ 0xedb8_8320 } else { s >> 1 })
    })
}

#[test]
fn files_that_cannot_be_read() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(read_picture(&folder.path().join("no.png")), Err(FormatError::Missing { .. })));
    assert!(matches!(read_picture(folder.path()), Err(FormatError::NotAFile { .. })));
    let path: PathBuf = folder.path().join("a.jpg");
    fs::write(&path, "not a picture").unwrap();
    assert!(matches!(read_picture(&path), Err(FormatError::NotAPicture { found: None, .. })));
}

proptest! {
    #[test]
    fn every_hdr_row_comes_back(values in proptest::collection::vec(0_u8..4, 8..600)) {
        let pixels: Vec<_> = values.iter().map(|v| Rgb::splat(f32::from(*v) / 4.0)).collect();
        let image = Image { size: [values.len() as u32, 1], pixels };
        let file = encode(format("hdr"), &image, &WriteOptions::default()).unwrap();
        let reader = ImageReader::with_format(Cursor::new(&file), ::image::ImageFormat::Hdr);
        let decoder = reader.into_decoder().unwrap();
        prop_assert_eq!(decoder.dimensions(), (values.len() as u32, 1));
        let read = DynamicImage::from_decoder(decoder).unwrap().into_rgb32f();
        for (wanted, read) in image.pixels.iter().zip(read.pixels()) {
            prop_assert_eq!(wanted.to_array(), read.0);
        }
    }

    #[test]
    fn any_damage_to_a_picture_is_an_error_or_a_picture(
        jpeg: bool, places in proptest::collection::vec((0_usize..2000, 0_u8..=255), 1..8)
    ) {
        let image = ramps([24, 24]);
        let mut file = encode(format(if jpeg { "jpg" } else { "png" }), &image, &WriteOptions::default()).unwrap();
        for (place, byte) in places {
            let length = file.len();
            file[place % length] = byte;
        }
        if let Ok(picture) = read_bytes(&file) {
            prop_assert_eq!(picture.texels.len(), picture.size[0] as usize * picture.size[1] as usize);
        }
    }
}
