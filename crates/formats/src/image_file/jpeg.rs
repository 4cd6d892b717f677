//! JPEG: display colours in 8 bits; metadata as a comment, "key: text" in each line.

use super::{ImageFormat, WriteOptions, one_line};
use image::codecs::jpeg::JpegEncoder;
use image::{ExtendedColorType, ImageEncoder};
use vitrine_film::Image;

/// The entry of the register.
pub const FORMAT: ImageFormat = ImageFormat { name: "JPEG", extensions: &["jpg", "jpeg"], encode };

/// The most bytes in a comment: its length, itself included, has 16 bits.
const MAX_COMMENT: usize = 65_533;

fn encode(image: &Image, options: &WriteOptions) -> Result<Vec<u8>, String> {
    let [width, height] = image.size;
    let mut file = Vec::new();
    JpegEncoder::new_with_quality(&mut file, options.jpeg_quality.clamp(1, 100))
        .write_image(&options.display.to_u8(image), width, height, ExtendedColorType::Rgb8)
        .map_err(|e| e.to_string())?;
    // The comment stands after the first segment, which must open the file: 2 bytes of marker, 2 of length, its content.
    let [_, _, _, _, high, low, ..] = file[..] else { return Err("the encoder failed".into()) };
    let place = (4 + usize::from(u16::from_be_bytes([high, low]))).min(file.len());
    file.splice(place..place, comment(&options.metadata));
    Ok(file)
}

fn comment(metadata: &[(String, String)]) -> Vec<u8> {
    let lines: Vec<_> = metadata.iter().map(|(key, text)| format!("{key}: {}", one_line(text))).collect();
    let mut text = lines.join("\n");
    while text.len() > MAX_COMMENT {
        text.pop();
    }
    if text.is_empty() {
        return Vec::new();
    }
    let mut segment = vec![0xff, 0xfe];
    segment.extend((text.len() as u16 + 2).to_be_bytes());
    segment.extend(text.bytes());
    segment
}

/// Whether a JPEG file ends before its picture does. Decoders fill what is missing with grey and say nothing.
pub fn is_cut_off(bytes: &[u8]) -> bool {
    // A thumbnail has an end of its own, before the picture's own start of scan; inside a scan neither mark occurs.
    let last = |mark: u8| bytes.windows(2).rposition(|w| w == [0xff, mark]);
    last(0xd9) <= last(0xda)
}
