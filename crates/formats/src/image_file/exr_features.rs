//! Reading OpenEXR pictures for denoising: the light, and where they are there the layers of what each pixel shows first,
//! its albedo and its normal. They may be channels of one part (`albedo.R`) or parts of their own.

use super::picture::{MAX_PIXELS, MAX_SIDE};
use crate::{FormatError, disc};
use exr::meta::MetaData;
use exr::prelude::{AnyChannels, AttributeValue, FlatSamples, ReadChannels, ReadLayers, Text, read};
use std::io::Cursor;
use std::path::Path;
use vitrine_film::Image;
use vitrine_math::Rgb;

/// The most bytes of a file.
const MAX_FILE: u64 = 4 << 30;
/// The most bytes that all channels may take in memory.
const MAX_BYTES: u64 = 16 << 30;
/// No compression of the format makes anything smaller than this many times; a header that claims more claims too much.
const MAX_RATIO: u64 = 2048;

/// Names of the layer with the light, in lower case: usually none, but parts must have one.
const LIGHT: &[&str] = &["", "light", "beauty", "combined", "rgb", "rgba"];
/// Names of the layers with the albedo, in lower case; the second is Blender's.
const ALBEDO: &[&str] = &["albedo", "denoising albedo"];
/// Names of the layers with the normals, likewise.
const NORMAL: &[&str] = &["normal", "denoising normal"];
/// Texts of the file that are kept, beside those whose names begin with `vitrine:` and that are not about layers.
const TEXTS: &[&str] = &["Software", "Title"];

/// What denoising takes from an OpenEXR picture. All layers have the same size.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrFeatures {
    /// Linear light.
    pub light: Image,
    /// Colours of what is seen first, 0 to 1.
    pub albedo: Option<Image>,
    /// Normals of what is seen first, each part −1 to 1 in place of a colour's.
    pub normal: Option<Image>,
    /// The file's texts, fit to be written into another.
    pub metadata: Vec<(String, String)>,
}

/// A picture as the decoder gives it.
type Decoded = exr::prelude::Image<exr::prelude::Layers<AnyChannels<FlatSamples>>>;

/// Reads the light, albedo and normals of an OpenEXR picture. Numbers may have 16 or 32 bits.
///
/// # Errors
/// When the file cannot be read, is no such picture, has no R, G and B, is damaged or too large.
pub fn read_exr_features(path: &Path) -> Result<ExrFeatures, FormatError> {
    parse_exr_features(&disc::read(path, MAX_FILE)?, path)
}

/// As [`read_exr_features`], from the bytes of a file. `path` names it in messages.
///
/// # Errors
/// As [`read_exr_features`], the disc's apart.
pub fn parse_exr_features(bytes: &[u8], path: &Path) -> Result<ExrFeatures, FormatError> {
    if !bytes.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        return Err(unfit(path, "this is not an OpenEXR picture"));
    }
    let damaged =
        |e: exr::error::Error| FormatError::PictureDamaged { path: path.into(), reason: e.to_string() };
    check_claims(&MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(damaged)?, bytes, path)?;
    let decoded: Decoded = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(damaged)?;
    let light =
        picture(&decoded, LIGHT).ok_or_else(|| unfit(path, "the picture has no channels R, G and B"))?;
    let same_size = |image: &Image| image.size == light.size;
    Ok(ExrFeatures {
        albedo: picture(&decoded, ALBEDO).filter(same_size),
        normal: picture(&decoded, NORMAL).filter(same_size),
        metadata: texts(&decoded),
        light,
    })
}

fn unfit(path: &Path, reason: &'static str) -> FormatError {
    FormatError::Layers { path: path.into(), reason }
}

/// Checks what the headers claim before memory is taken for it.
fn check_claims(meta: &MetaData, bytes: &[u8], path: &Path) -> Result<(), FormatError> {
    let mut claimed = 0_u64;
    for header in &meta.headers {
        let (width, height) = (header.layer_size.x() as u64, header.layer_size.y() as u64);
        let pixels = width.saturating_mul(height);
        let is_too_long = width.max(height) > u64::from(MAX_SIDE);
        claimed = claimed.saturating_add(pixels.saturating_mul(4 * header.channels.list.len() as u64));
        if is_too_long || pixels > MAX_PIXELS || claimed > MAX_BYTES {
            let [width, height] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
            return Err(FormatError::PictureTooLarge { path: path.into(), width, height });
        }
    }
    if claimed > MAX_RATIO.saturating_mul(bytes.len() as u64) {
        return Err(FormatError::PictureCutOff { path: path.into() });
    }
    Ok(())
}

/// The first picture whose layer has one of the names.
fn picture(decoded: &Decoded, names: &[&str]) -> Option<Image> {
    names.iter().find_map(|name| picture_named(decoded, name))
}

fn picture_named(decoded: &Decoded, name: &str) -> Option<Image> {
    let channel = |wanted: [&str; 2]| {
        decoded.layer_data.iter().find_map(|layer| {
            let found = layer.channel_data.list.iter().find(|channel| {
                let (group, part) = group_and_part(layer.attributes.layer_name.as_ref(), &channel.name);
                group == name && wanted.contains(&part.as_str())
            })?;
            let size = [layer.size.x(), layer.size.y()];
            (found.sample_data.len() == size[0] * size[1]).then_some((size, &found.sample_data))
        })
    };
    let (size, r) = channel(["r", "x"])?;
    let [(_, g), (_, b)] = [channel(["g", "y"])?, channel(["b", "z"])?];
    if g.len() != r.len() || b.len() != r.len() {
        return None;
    }
    let value = |from: &FlatSamples, i: usize| from.value_by_flat_index(i).to_f32();
    let pixels = (0..r.len()).map(|i| Rgb::new(value(r, i), value(g, i), value(b, i))).collect();
    Some(Image { size: [u32::try_from(size[0]).ok()?, u32::try_from(size[1]).ok()?], pixels })
}

/// Of "View Layer.Denoising Albedo.R": "denoising albedo" and "r". A part's name stands before those of its channels.
fn group_and_part(layer: Option<&Text>, channel: &Text) -> (String, String) {
    let layer = layer.map(text_of).unwrap_or_default();
    let name = format!("{layer}.{}", text_of(channel)).to_lowercase();
    let mut words = name.rsplit('.');
    let part = words.next().unwrap_or_default().to_owned();
    (words.next().unwrap_or_default().to_owned(), part)
}

/// A text of the file; UTF-8 is what programs write today.
fn text_of(text: &Text) -> String {
    String::from_utf8_lossy(text.bytes()).into_owned()
}

/// The file's texts that are kept.
fn texts(decoded: &Decoded) -> Vec<(String, String)> {
    let layers = decoded.layer_data.iter().map(|layer| &layer.attributes);
    let comments = layers.clone().find_map(|a| a.comments.as_ref());
    let mut texts: Vec<_> =
        comments.map(|text| ("Description".to_owned(), text_of(text))).into_iter().collect();
    let named = decoded.attributes.other.iter().chain(layers.flat_map(|a| a.other.iter()));
    for (name, value) in named {
        let (name, AttributeValue::Text(text)) = (text_of(name), value) else { continue };
        let is_ours = name.starts_with("vitrine:") && name != "vitrine:objects" && super::is_key(&name);
        let is_kept = is_ours || TEXTS.contains(&name.as_str());
        if is_kept && texts.iter().all(|(key, _)| *key != name) {
            texts.push((name, text_of(text)));
        }
    }
    texts.sort();
    texts
}

#[cfg(test)]
mod tests {
    use super::super::{ExrLayers, encode_layers};
    use super::*;
    use crate::{WriteOptions, encode, image_format};
    use exr::prelude::{AnyChannel, Encoding, Image as ExrImage, Layer, LayerAttributes, WritableImage};
    use vitrine_film::Layers;
    use vitrine_math::Vec3;

    const PATH: &str = "a.exr";

    fn parse(bytes: &[u8]) -> Result<ExrFeatures, FormatError> {
        parse_exr_features(bytes, Path::new(PATH))
    }

    /// A layer's name and its channels, each of one value.
    type Part<'a> = (Option<&'a str>, &'a [(&'a str, f32)]);

    /// A file of parts, each a name and its channels of 3 × 2 numbers that begin with the given ones.
    fn file(parts: &[Part]) -> Vec<u8> {
        let layers = parts.iter().map(|(name, channels)| {
            let channel = |&(name, first): &(&str, f32)| {
                AnyChannel::new(name, FlatSamples::F32((0..6_u8).map(|i| first + f32::from(i)).collect()))
            };
            let channels = AnyChannels::sort(channels.iter().map(channel).collect());
            let attributes =
                LayerAttributes { layer_name: name.map(Text::from), ..LayerAttributes::default() };
            Layer::new((3, 2), attributes, Encoding::SMALL_LOSSLESS, channels)
        });
        let mut file = Cursor::new(Vec::new());
        ExrImage::from_layers(exr::prelude::ImageAttributes::with_size((3, 2)), layers.collect::<Vec<_>>())
            .write()
            .non_parallel()
            .to_buffered(&mut file)
            .unwrap();
        file.into_inner()
    }

    #[test]
    fn what_this_project_writes_comes_back_with_its_texts() {
        let mut light = Image::filled([4, 3], Rgb::new(0.25, 7.0, -1e-20));
        light.pixels[5] = Rgb::new(1.0, 2.0, 3.0);
        let mut metadata: Vec<_> =
            [("Description", "Стекло"), ("Software", "Vitrine 1"), ("vitrine:seed", "7")]
                .map(|(k, v)| (k.to_owned(), v.to_owned()))
                .to_vec();
        let options = WriteOptions { metadata: metadata.clone(), ..WriteOptions::default() };
        let bytes = encode(image_format(Path::new(PATH)).unwrap(), &light, &options).unwrap();
        metadata.sort();
        assert_eq!(parse(&bytes).unwrap(), ExrFeatures { light, albedo: None, normal: None, metadata });
    }

    #[test]
    fn layers_that_this_project_writes_are_found() {
        let light = Image::filled([4, 3], Rgb::WHITE);
        let albedo = Image::filled([4, 3], Rgb::new(0.1, 0.2, 0.3));
        let features = Layers {
            albedo: albedo.clone(),
            normal: vec![Vec3::new(0.0, 0.6, -0.8); 12],
            depth: vec![1.0; 12],
            samples: vec![4; 12],
        };
        let layers = ExrLayers {
            features: Some(features),
            samples: vec![4; 12],
            objects: vec![0; 12],
            names: vec!["ball".into()],
        };
        let read = parse(&encode_layers(&light, &layers, &WriteOptions::default()).unwrap()).unwrap();
        let normal = Some(Image::filled([4, 3], Rgb::new(0.0, 0.6, -0.8)));
        assert_eq!(read, ExrFeatures { light, albedo: Some(albedo), normal, metadata: Vec::new() });
    }

    #[test]
    fn layers_are_found_by_name_in_one_part_and_in_parts_of_their_own() {
        let one: &[(&str, f32)] = &[
            ("R", 1.0),
            ("G", 2.0),
            ("B", 3.0),
            ("A", 9.0),
            ("albedo.R", 4.0),
            ("albedo.G", 5.0),
            ("albedo.B", 6.0),
            ("normal.X", 7.0),
            ("normal.Y", 8.0),
            ("normal.Z", 9.0),
            ("normal.heat", 0.0),
        ];
        let parts: &[Part] = &[
            (Some("rgba"), &[("R", 1.0), ("G", 2.0), ("B", 3.0)]),
            (Some("albedo"), &[("R", 4.0), ("G", 5.0), ("B", 6.0)]),
            (Some("View.Denoising Normal"), &[("X", 7.0), ("Y", 8.0), ("Z", 9.0)]),
        ];
        for bytes in [file(&[(None, one)]), file(parts)] {
            let layers = parse(&bytes).unwrap();
            assert_eq!(layers.light.size, [3, 2]);
            assert_eq!(layers.light.pixel(1, 0), Rgb::new(2.0, 3.0, 4.0));
            assert_eq!(layers.albedo.unwrap().pixel(0, 1), Rgb::new(7.0, 8.0, 9.0));
            assert_eq!(layers.normal.unwrap().pixel(0, 0), Rgb::new(7.0, 8.0, 9.0));
        }
    }

    #[test]
    fn a_layer_that_is_not_whole_is_none() {
        let bytes = file(&[(None, &[("R", 1.0), ("G", 2.0), ("B", 3.0), ("albedo.R", 4.0)])]);
        let layers = parse(&bytes).unwrap();
        assert_eq!((layers.albedo, layers.normal), (None, None));
        let grey = parse(&file(&[(None, &[("Y", 1.0)])])).unwrap_err();
        assert!(grey.to_string().contains("no channels R, G and B"), "{grey}");
    }

    #[test]
    fn what_is_cut_off_or_damaged_or_claims_too_much_is_refused() {
        let whole = file(&[(None, &[("R", 1.0), ("G", 2.0), ("B", 3.0)])]);
        for end in 0..whole.len() {
            assert!(parse(&whole[..end]).is_err(), "{end}");
        }
        let not_exr = parse(b"\x89PNG").unwrap_err();
        assert!(not_exr.to_string().contains("not an OpenEXR"), "{not_exr}");
        // The corners of both windows, each after its name and type and the length 16.
        let mut huge = whole.clone();
        let mut at = 0;
        while let Some(found) = huge[at..].windows(6).position(|w| w == b"box2i\0") {
            at += found + 6 + 4;
            huge[at + 8..at + 16].copy_from_slice(&[0xff, 0x1f, 0, 0, 0xff, 0x1f, 0, 0]);
        }
        assert!(matches!(parse(&huge), Err(FormatError::PictureCutOff { .. })));
    }

    #[test]
    fn any_byte_may_be_wrong() {
        let whole =
            file(&[(Some("albedo"), &[("R", 1.0)]), (Some("light"), &[("R", 1.0), ("G", 2.0), ("B", 3.0)])]);
        for place in 0..whole.len() {
            for value in [0, 1, 0x7f, 0xff] {
                let mut bytes = whole.clone();
                bytes[place] = value;
                // It may still be a picture; it must not panic.
                let _ = parse(&bytes);
            }
        }
    }
}
