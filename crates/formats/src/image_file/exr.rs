//! OpenEXR: linear light as 32-bit floats, compressed without loss; metadata as text attributes.

use super::{ImageFormat, WriteOptions, one_line};
use exr::meta::attribute::Chromaticities;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Encoding, Error, FlatSamples, Image as ExrImage, Layer,
    LayerAttributes, MetaData, ReadChannels, ReadLayers, Text, Vec2, WritableImage, read,
};
use std::io::Cursor;
use vitrine_film::Image;
use vitrine_math::Rgb;

/// The entry of the register.
pub const FORMAT: ImageFormat = ImageFormat { name: "OpenEXR", extensions: &["exr"], encode };

fn encode(image: &Image, options: &WriteOptions) -> Result<Vec<u8>, String> {
    encode_channels(image.size, light(image), options)
}

/// Red, green and blue.
pub fn light(image: &Image) -> Vec<AnyChannel<FlatSamples>> {
    ["R", "G", "B"].into_iter().zip(planes(image)).map(|(name, plane)| AnyChannel::new(name, plane)).collect()
}

/// The three channels of a picture, each by itself.
pub fn planes(image: &Image) -> [FlatSamples; 3] {
    let plane = |i: usize| image.pixels.iter().map(|p| p.to_array()[i]).collect();
    [0, 1, 2].map(|i| FlatSamples::F32(plane(i)))
}

/// A file with these channels, all of the picture's size.
pub fn encode_channels(
    size: [u32; 2],
    channels: Vec<AnyChannel<FlatSamples>>,
    options: &WriteOptions,
) -> Result<Vec<u8>, String> {
    let size = size.map(|s| s as usize);
    let channels = AnyChannels::sort(channels.into());
    let layer =
        Layer::new((size[0], size[1]), LayerAttributes::default(), Encoding::SMALL_LOSSLESS, channels);
    let mut picture = ExrImage::from_layer(layer);
    // Rec. 709 with the white of D65.
    picture.attributes.chromaticities = Some(Chromaticities {
        red: Vec2(0.64, 0.33),
        green: Vec2(0.3, 0.6),
        blue: Vec2(0.15, 0.06),
        white: Vec2(0.3127, 0.329),
    });
    for (key, text) in &options.metadata {
        let text = Text::from_slice_unchecked(one_line(text).as_bytes());
        if key == "Description" {
            // The format's own word.
            picture.layer_data.attributes.comments = Some(text);
        } else {
            picture.attributes.other.insert(Text::from(key.as_str()), AttributeValue::Text(text));
        }
    }
    let mut file = Cursor::new(Vec::new());
    picture.write().non_parallel().to_buffered(&mut file).map_err(|e| e.to_string())?;
    let mut file = file.into_inner();
    sort_attributes(&mut file).ok_or("the encoder failed")?;
    Ok(file)
}

/// Brings the header's attributes into the order of their names. The encoder writes them in random order, and the same
/// picture must give the same file. Nothing changes its length.
fn sort_attributes(file: &mut [u8]) -> Option<()> {
    // After the magic number and the version, each is name, 0, type, 0, length, value; a 0 ends the list.
    const START: usize = 8;
    let mut attributes = Vec::new();
    let mut rest = file.get(START..)?;
    while *rest.first()? != 0 {
        let name = rest.iter().position(|b| *b == 0)? + 1;
        let kind = rest[name..].iter().position(|b| *b == 0)? + 1;
        let (length, _) = rest[name + kind..].split_first_chunk::<4>()?;
        let (attribute, next) =
            rest.split_at_checked(name + kind + 4 + i32::from_le_bytes(*length) as usize)?;
        attributes.push(attribute);
        rest = next;
    }
    attributes.sort_unstable();
    let sorted = attributes.concat();
    file.get_mut(START..START + sorted.len())?.copy_from_slice(&sorted);
    Some(())
}

/// Reads the first layer that has red, green and blue: its size and its pixels, row by row from the top. `check` sees each
/// layer's size before memory is taken for it.
///
/// # Errors
/// What `check` says as `Ok`, what is wrong with the file as `Err`.
pub fn read_linear<E>(
    file: &[u8],
    check: impl Fn([u32; 2]) -> Result<(), E>,
) -> Result<([u32; 2], Vec<Rgb>), Result<E, Error>> {
    let meta = MetaData::read_from_buffered(Cursor::new(file), false).map_err(Err)?;
    for header in &meta.headers {
        let size = [header.layer_size.x(), header.layer_size.y()];
        check(size.map(|s| u32::try_from(s).unwrap_or(u32::MAX))).map_err(Ok)?;
    }
    let layer = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size, vec![Rgb::BLACK; size.area()]),
            |(size, pixels), place, (r, g, b): (f32, f32, f32)| {
                pixels[place.flat_index_for_size(*size)] = Rgb::new(r, g, b);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel();
    let (size, pixels) = layer.from_buffered(Cursor::new(file)).map_err(Err)?.layer_data.channel_data.pixels;
    Ok(([size.x() as u32, size.y() as u32], pixels))
}
