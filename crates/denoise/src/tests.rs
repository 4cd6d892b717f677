//! Without the library: what is said. With the library, where [`VARIABLE`] names it: what becomes of noise and edges.

use super::*;
use std::fs;
use std::io::{self, Write};
use std::sync::Once;
use vitrine_film::{Features, Region, TileSums};
use vitrine_math::Vec3;

fn not_found(places: &[Place]) -> (Vec<Attempt>, String) {
    let error = Denoiser::look_in(places).unwrap_err();
    let text = error.to_string();
    assert!(error.help().contains("pyoidn") && error.help().contains(VARIABLE), "{}", error.help());
    match error {
        DenoiseError::NotFound { tried } => (tried, text),
        other => panic!("{other}"),
    }
}

#[test]
fn without_the_library_every_path_that_was_tried_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let [here, below] = [folder.path().to_path_buf(), folder.path().join("lib")];
    let (tried, text) = not_found(&[Place::Folder(here.clone()), Place::Folder(below.clone())]);
    assert_eq!(tried.len(), 2);
    for (attempt, folder) in tried.iter().zip([here, below]) {
        assert!(attempt.file.starts_with(folder) && attempt.reason == "there is no such file", "{attempt:?}");
        assert!(text.contains(&*attempt.file.to_string_lossy()), "{text}");
    }
}

#[test]
fn what_is_named_and_no_library_is_refused_with_the_systems_reason() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("libOpenImageDenoise.so.2");
    for content in [&b""[..], b"no library", &[0x7f; 5000]] {
        fs::write(&file, content).unwrap();
        let error = Denoiser::find(Some(&file)).unwrap_err();
        let DenoiseError::NotFound { tried } = &error else { panic!("{error}") };
        let [Attempt { file: tried, reason }] = &tried[..] else { panic!("{tried:?}") };
        assert_eq!(tried, &file);
        assert!(!reason.is_empty());
        let text = error.to_string();
        assert_eq!(text.matches(&*file.to_string_lossy()).count(), 1, "the path, once: {text}");
    }
}

/// The C library is on every system, and is none that removes noise.
#[test]
#[cfg(target_os = "linux")]
fn another_library_is_refused_by_what_it_lacks() {
    let maps = fs::read_to_string("/proc/self/maps").unwrap();
    let libc = maps.lines().find_map(|line| {
        let path = &line[line.find('/')?..];
        Path::new(path).file_name()?.to_str()?.starts_with("libc.").then(|| path.to_owned())
    });
    let Some(libc) = libc else {
        println!("not run: this test program has no C library as a file of its own");
        return;
    };
    let error = Denoiser::find(Some(Path::new(&libc))).unwrap_err().to_string();
    assert!(error.contains("not Open Image Denoise 2") && error.contains("oidnNewDevice"), "{error}");
}

#[test]
fn pictures_that_do_not_belong_together_are_refused() {
    let picture = |width, height| Image::filled([width, height], Rgb::WHITE);
    let (light, same, other) = (picture(4, 3), picture(4, 3), picture(3, 4));
    assert_eq!(check(&light, Some(&same), Some(&same)), Ok(()));
    let size = [3, 4];
    assert_eq!(
        check(&light, Some(&other), None),
        Err(DenoiseError::OtherSize { what: "albedo", size, light: [4, 3] })
    );
    assert_eq!(
        check(&light, Some(&same), Some(&other)),
        Err(DenoiseError::OtherSize { what: "normals", size, light: [4, 3] })
    );
    assert_eq!(check(&light, None, Some(&same)), Err(DenoiseError::NormalsAlone));
    let cut = Image { size: [4, 3], pixels: vec![Rgb::WHITE; 11] };
    assert!(matches!(check(&cut, None, None), Err(DenoiseError::NotWhole { what: "light", pixels: 11, .. })));
    let none = Image { size: [0, 3], pixels: Vec::new() };
    assert!(matches!(check(&none, None, None), Err(DenoiseError::NotWhole { .. })));
}

/// The library that the variable names, or None with a word about it.
fn library() -> Option<Denoiser> {
    if std::env::var_os(VARIABLE).is_none_or(|v| v.is_empty()) {
        static SAID: Once = Once::new();
        SAID.call_once(|| {
            // Past the test harness, which would keep it to itself.
            let _ = writeln!(
                io::stderr(),
                "NOT RUN: tests that denoise; let {VARIABLE} name the folder of Open Image Denoise 2 to run them"
            );
        });
        return None;
    }
    Some(Denoiser::find(None).expect("the variable names a library").with_threads(2))
}

const SIZE: [u32; 2] = [192, 128];

/// A picture by a function of the pixel's place, from 0 to 1 along each side.
fn paint(f: impl Fn(f32, f32) -> Rgb) -> Image {
    let [width, height] = SIZE;
    let place =
        |i: u32| (((i % width) as f32 + 0.5) / width as f32, ((i / width) as f32 + 0.5) / height as f32);
    let pixels = (0..width * height).map(|i| {
        let (x, y) = place(i);
        f(x, y)
    });
    Image { size: SIZE, pixels: pixels.collect() }
}

/// The same picture with each pixel's light multiplied by a number of its own, 1 on average and up to 2.
fn noisy(image: &Image) -> Image {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 40) as f32 / (1_u64 << 24) as f32 * 2.0
    };
    Image { size: image.size, pixels: image.pixels.iter().map(|&p| p * next()).collect() }
}

/// The root of the mean square of the difference, over luminance.
fn error_of(image: &Image, truth: &Image) -> f32 {
    let pairs = image.pixels.iter().zip(&truth.pixels);
    let sum: f32 = pairs.map(|(a, b)| (a.luminance() - b.luminance()).powi(2)).sum();
    (sum / image.pixels.len() as f32).sqrt()
}

fn mean(image: &Image) -> f32 {
    image.pixels.iter().map(|p| p.luminance()).sum::<f32>() / image.pixels.len() as f32
}

#[test]
fn noise_goes_down_on_a_ramp_and_the_light_stays() {
    let Some(denoiser) = library() else { return };
    // Ten times as bright as white at the right end: what goes in is light, not display values.
    let truth = paint(|x, y| Rgb::new(10.0 * x, 5.0 * x + y, 0.5 + y));
    let noise = noisy(&truth);
    for &(word, quality) in Quality::WORDS {
        let clean = denoiser.run(&noise, None, None, quality).unwrap();
        let (before, after) = (error_of(&noise, &truth), error_of(&clean, &truth));
        assert!(after < before / 8.0, "{word}: {before} became {after}");
        let change = mean(&clean) / mean(&truth);
        assert!((0.97..1.03).contains(&change), "{word}: the light changed by {change}");
    }
}

/// Stripes two pixels wide that only the features show clearly: the light's noise drowns them.
#[test]
fn edges_that_the_features_show_survive() {
    let Some(denoiser) = library() else { return };
    let stripe = |x: f32| ((x * SIZE[0] as f32 / 2.0) as u32).is_multiple_of(2);
    let albedo = paint(|x, _| if stripe(x) { Rgb::splat(0.7) } else { Rgb::splat(0.5) });
    let normal = paint(|_, y| if y < 0.5 { Rgb::new(0.0, 0.0, 1.0) } else { Rgb::new(0.0, 1.0, 0.0) });
    let truth = Image {
        size: SIZE,
        pixels: albedo.pixels.iter().zip(&normal.pixels).map(|(&a, n)| a * (1.0 + n.b)).collect(),
    };
    let noise = noisy(&truth);
    let with = denoiser.run(&noise, Some(&albedo), Some(&normal), Quality::High).unwrap();
    let without = denoiser.run(&noise, None, None, Quality::High).unwrap();
    // How much brighter the light stripes are than the dark ones, over the upper half, where the difference is 0.4.
    let contrast = |image: &Image| {
        let upper = 0..(SIZE[0] * SIZE[1] / 2) as usize;
        let part = |light: bool| {
            let of = upper.clone().filter(|&i| (albedo.pixels[i].r > 0.6) == light);
            let values: Vec<_> = of.map(|i| image.pixels[i].luminance()).collect();
            values.iter().sum::<f32>() / values.len() as f32
        };
        part(true) - part(false)
    };
    assert!(contrast(&with) > 0.3, "{}", contrast(&with));
    assert!(error_of(&with, &truth) < 0.5 * error_of(&without, &truth));
    assert!(error_of(&with, &truth) < error_of(&noise, &truth) / 10.0);
}

#[test]
fn a_film_brings_its_own_features() {
    let Some(denoiser) = library() else { return };
    let region = Region { x: 3, y: 5, width: 40, height: 32 };
    let fill = |film: &mut Film, with_features: bool| {
        let mut bands: Vec<_> = film.bands().collect();
        for (tile, part) in Film::tiles(region).enumerate() {
            let light: Vec<_> = (0..part.pixels()).map(|i| Rgb::splat((i * i % 7) as f32)).collect();
            let at = |i: usize| Rgb::splat(if i % part.width as usize > 3 { 0.75 } else { 0.25 });
            let feature = |i| Features { albedo: at(i), normal: Vec3::Y, depth: 1.0 };
            let features: Vec<_> = (0..part.pixels()).map(feature).collect();
            let features = if with_features { &features[..] } else { &[] };
            bands[0].add_samples(tile, TileSums { light: &light, features }, 1);
        }
    };
    let mut films = [Film::with_layers(region), Film::with_layers(region), Film::new(region)];
    for (film, with_features) in films.iter_mut().zip([true, false, false]) {
        fill(film, with_features);
    }
    let [with, empty, without] = films.map(|film| {
        let layers = film.layers().filter(|l| l.depth[0] > 0.0);
        let normal = |l: &Layers| Image {
            size: [40, 32],
            pixels: l.normal.iter().map(|n| Rgb::new(n.x, n.y, n.z)).collect(),
        };
        let normal = layers.as_ref().map(normal);
        let albedo = layers.as_ref().map(|l| &l.albedo);
        let by_hand = denoiser.run(&film.image(), albedo, normal.as_ref(), Quality::High).unwrap();
        assert_eq!(denoiser.run_film(&film, Quality::High).unwrap(), by_hand);
        by_hand
    });
    assert_eq!(empty, without, "features that nobody made are none");
    assert_ne!(with, without);
}

#[test]
fn the_same_on_one_thread_and_on_two() {
    let Some(denoiser) = library() else { return };
    let noise = noisy(&paint(|x, y| Rgb::new(x, y, 0.5)));
    let run =
        |threads| denoiser.clone().with_threads(threads).run(&noise, None, None, Quality::Fast).unwrap();
    assert_eq!(run(1), run(2));
}

#[test]
fn numbers_that_are_none_do_not_spread() {
    let Some(denoiser) = library() else { return };
    let mut noise = noisy(&paint(|_, _| Rgb::WHITE));
    for (pixel, bad) in [(5000, f32::NAN), (9000, f32::INFINITY), (12_000, -3.0)] {
        noise.pixels[pixel] = Rgb::splat(bad);
    }
    let clean = denoiser.run(&noise, None, None, Quality::High).unwrap();
    assert!(clean.pixels.iter().all(|p| p.to_array().iter().all(|c| c.is_finite() && *c >= 0.0)));
}

#[test]
fn the_version_and_the_file_are_known() {
    let Some(denoiser) = library() else { return };
    assert!(denoiser.version().starts_with("2."), "{}", denoiser.version());
    assert!(denoiser.file().to_string_lossy().contains("OpenImageDenoise"), "{:?}", denoiser.file());
}

#[test]
fn a_picture_of_one_pixel_and_a_very_flat_one() {
    let Some(denoiser) = library() else { return };
    for size in [[1, 1], [300, 1], [1, 300]] {
        let image = Image::filled(size, Rgb::new(0.2, 0.4, 0.8));
        let clean = denoiser.run(&image, Some(&image), Some(&image), Quality::High).unwrap();
        assert_eq!((clean.size, clean.pixels.len()), (size, image.pixels.len()));
    }
}
