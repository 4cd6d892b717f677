//! PNG: display colours in 8 or 16 bits, marked as sRGB; metadata as text chunks.

use super::{BitDepth, ImageFormat, WriteOptions, one_line};
use png::{ColorType, Compression, Encoder, SrgbRenderingIntent};
use vitrine_film::Image;

/// The entry of the register.
pub const FORMAT: ImageFormat = ImageFormat { name: "PNG", extensions: &["png"], encode };

fn encode(image: &Image, options: &WriteOptions) -> Result<Vec<u8>, String> {
    let (depth, bytes) = match options.bits {
        BitDepth::Eight => (png::BitDepth::Eight, options.display.to_u8(image)),
        BitDepth::Sixteen => {
            let values = options.display.to_u16(image);
            (png::BitDepth::Sixteen, values.into_iter().flat_map(u16::to_be_bytes).collect())
        }
    };
    let mut file = Vec::with_capacity(bytes.len() / 2);
    write(&mut file, image.size, (depth, &bytes), &options.metadata).map_err(|e| e.to_string())?;
    Ok(file)
}

fn write(
    file: &mut Vec<u8>,
    [width, height]: [u32; 2],
    (depth, bytes): (png::BitDepth, &[u8]),
    metadata: &[(String, String)],
) -> Result<(), png::EncodingError> {
    let mut encoder = Encoder::new(file, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(depth);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    // A picture that renders in a tenth of a second must not take longer to save.
    encoder.set_compression(Compression::Fast);
    for (key, text) in metadata {
        // Plain text chunks are Latin-1; every program reads them. Others are UTF-8.
        let text = one_line(text);
        if text.is_ascii() {
            encoder.add_text_chunk(key.clone(), text)?;
        } else {
            encoder.add_itxt_chunk(key.clone(), text)?;
        }
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()
}

/// Whether a PNG file ends before its last chunk does.
pub fn is_cut_off(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(8..).unwrap_or_default();
    loop {
        let Some((length, kind)) = rest.split_first_chunk::<4>() else { return true };
        if kind.starts_with(b"IEND") {
            return false;
        }
        // A chunk is its length, a name of 4 bytes, the data and a checksum of 4 bytes.
        match rest.get(u32::from_be_bytes(*length) as usize + 12..) {
            Some(next) => rest = next,
            None => return true,
        }
    }
}
