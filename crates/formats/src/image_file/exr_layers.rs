//! OpenEXR with layers: beside red, green and blue what compositors and denoisers ask for, in one file of many channels.
//!
//! | channels | |
//! |---|---|
//! | `R`, `G`, `B` | linear light |
//! | `albedo.R`, `.G`, `.B` | the colour of what is seen, as if evenly lit |
//! | `normal.X`, `.Y`, `.Z` | its normal, world space |
//! | `depth.Z` | its distance from the camera, metres; 0 where nothing is seen |
//! | `object.id` | which object is seen, counted from 1 in the order of `vitrine:objects`; 0 where there is none |
//! | `samples` | how many samples the pixel has |

use super::exr::{encode_channels, light, planes};
use super::{WriteOptions, exr, refusal};
use crate::{FormatError, write_atomically};
use ::exr::prelude::{AnyChannel, FlatSamples};
use std::path::Path;
use vitrine_film::{Image, Layers};

/// What stands in the file beside red, green and blue. All lists have as many entries as the picture has pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrLayers {
    /// Colours, normals and depths; None where the renderer makes none.
    pub features: Option<Layers>,
    /// Samples of each pixel.
    pub samples: Vec<u32>,
    /// The object of each pixel: its place in `names`; any other number where there is none.
    pub objects: Vec<u32>,
    /// The objects' names.
    pub names: Vec<String>,
}

/// The bytes of an OpenEXR file with layers.
///
/// # Errors
/// [`FormatError::Encode`] when the picture, its layers or its metadata do not fit together.
pub fn encode_layers(
    image: &Image,
    layers: &ExrLayers,
    options: &WriteOptions,
) -> Result<Vec<u8>, FormatError> {
    let mut options = options.clone();
    // A list of texts as JSON writes it: names may hold any character.
    let names = serde_json::Value::from(layers.names.clone()).to_string();
    options.metadata.push(("vitrine:objects".into(), names));
    let pixels = image.pixels.len();
    let fits = |f: &Layers| [f.albedo.pixels.len(), f.normal.len(), f.depth.len()] == [pixels; 3];
    let result = match refusal(image, &options) {
        Some(reason) => Err(reason),
        None if [layers.samples.len(), layers.objects.len()] != [pixels; 2]
            || !layers.features.as_ref().is_none_or(fits) =>
        {
            Err("its layers have another size".into())
        }
        None => encode_channels(image.size, channels(image, layers), &options),
    };
    result.map_err(|reason| FormatError::Encode { format: exr::FORMAT.name, reason })
}

/// Writes an OpenEXR file with layers, all of it or nothing.
///
/// # Errors
/// As [`encode_layers`] and [`write_atomically`].
pub fn write_layers(
    path: &Path,
    image: &Image,
    layers: &ExrLayers,
    options: &WriteOptions,
) -> Result<(), FormatError> {
    write_atomically(path, &encode_layers(image, layers, options)?)
}

fn channels(image: &Image, layers: &ExrLayers) -> Vec<AnyChannel<FlatSamples>> {
    let mut channels = light(image);
    let mut add = |name: &str, samples: FlatSamples| channels.push(AnyChannel::new(name, samples));
    if let Some(features) = &layers.features {
        for (name, plane) in ["albedo.R", "albedo.G", "albedo.B"].into_iter().zip(planes(&features.albedo)) {
            add(name, plane);
        }
        for (axis, name) in ["normal.X", "normal.Y", "normal.Z"].into_iter().enumerate() {
            add(name, FlatSamples::F32(features.normal.iter().map(|n| n[axis]).collect()));
        }
        add("depth.Z", FlatSamples::F32(features.depth.clone()));
    }
    let count = layers.names.len() as u32;
    let id = |&object: &u32| if object < count { object + 1 } else { 0 };
    add("object.id", FlatSamples::U32(layers.objects.iter().map(id).collect()));
    add("samples", FlatSamples::U32(layers.samples.clone()));
    channels
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::exr::prelude::{ReadChannels, ReadLayers, read};
    use std::io::Cursor;
    use vitrine_math::{Rgb, Vec3};

    const SIZE: [u32; 2] = [37, 19];
    const PIXELS: usize = 37 * 19;

    fn picture(with_features: bool) -> (Image, ExrLayers) {
        let color = |i: usize| Rgb::new(i as f32 * 0.1, -0.0, 1e6 / (i + 1) as f32);
        let image = Image { size: SIZE, pixels: (0..PIXELS).map(color).collect() };
        let features = Layers {
            albedo: Image { size: SIZE, pixels: (0..PIXELS).map(|i| color(i) * 0.5).collect() },
            normal: (0..PIXELS).map(|i| Vec3::new(0.0, 1.0, i as f32)).collect(),
            depth: (0..PIXELS).map(|i| i as f32 * 1.5).collect(),
            samples: vec![9; PIXELS],
        };
        let objects = (0..PIXELS as u32).map(|i| if i % 5 == 0 { u32::MAX } else { i % 2 }).collect();
        let names = vec!["ball".into(), "a \"quoted\" one".into()];
        let samples = vec![70_000; PIXELS];
        (image, ExrLayers { features: with_features.then_some(features), samples, objects, names })
    }

    #[test]
    fn every_layer_is_read_as_it_was_written() {
        let (image, layers) = picture(true);
        let file = encode_layers(&image, &layers, &WriteOptions::default()).unwrap();
        let read = read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(Cursor::new(&file))
            .unwrap();
        let list = &read.layer_data.channel_data.list;
        let names: Vec<_> = list.iter().map(|c| c.name.to_string()).collect();
        let wanted = [
            "B",
            "G",
            "R",
            "albedo.B",
            "albedo.G",
            "albedo.R",
            "depth.Z",
            "normal.X",
            "normal.Y",
            "normal.Z",
            "object.id",
            "samples",
        ];
        assert_eq!(names, wanted, "sorted, as the format asks");
        let numbers = |name: &str| match &list[wanted.iter().position(|n| *n == name).unwrap()].sample_data {
            FlatSamples::F32(values) => values.clone(),
            FlatSamples::U32(values) => values.iter().map(|v| *v as f32).collect(),
            FlatSamples::F16(_) => panic!("half floats"),
        };
        let features = layers.features.as_ref().unwrap();
        assert_eq!(numbers("R"), image.pixels.iter().map(|p| p.r).collect::<Vec<_>>());
        assert_eq!(numbers("albedo.B"), features.albedo.pixels.iter().map(|p| p.b).collect::<Vec<_>>());
        assert_eq!(numbers("normal.Z"), features.normal.iter().map(|n| n.z).collect::<Vec<_>>());
        assert_eq!(numbers("depth.Z"), features.depth);
        assert_eq!(numbers("object.id")[..6], [0.0, 2.0, 1.0, 2.0, 1.0, 0.0]);
        assert_eq!(numbers("samples")[0], 70_000.0);
        let text = String::from_utf8_lossy(&file);
        assert!(text.contains(r#"["ball","a \"quoted\" one"]"#), "the names stand in the header");
    }

    #[test]
    fn the_same_picture_gives_the_same_bytes() {
        let (image, layers) = picture(true);
        let options = WriteOptions {
            metadata: ["a", "b", "c", "d"].map(|key| (key.into(), "text".into())).into(),
            ..WriteOptions::default()
        };
        let first = encode_layers(&image, &layers, &options).unwrap();
        for _ in 0..10 {
            assert!(encode_layers(&image, &layers, &options).unwrap() == first);
        }
    }

    #[test]
    fn without_features_there_are_only_the_layers_that_exist() {
        let (image, layers) = picture(false);
        let file = encode_layers(&image, &layers, &WriteOptions::default()).unwrap();
        let text = String::from_utf8_lossy(&file);
        assert!(text.contains("object.id") && text.contains("samples"));
        assert!(!text.contains("albedo") && !text.contains("depth"));
        assert!(super::super::parse_panorama(&file, Path::new("a.exr")).is_ok(), "others see the light");
    }

    #[test]
    fn layers_of_another_size_are_refused() {
        let (image, mut layers) = picture(true);
        layers.samples.pop();
        let error = encode_layers(&image, &layers, &WriteOptions::default()).unwrap_err();
        assert!(matches!(error, FormatError::Encode { .. }), "{error}");
    }
}
