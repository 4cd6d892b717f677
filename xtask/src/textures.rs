//! The pictures on the things of the example scenes and of the material library. Made from hashes of whole numbers
//! and `libm` alone, so they are the same bytes on every machine.

use crate::library_textures::{brick, marble, paper, wood};
use crate::root;
use std::fs;
use std::path::Path;
use vitrine::film::Image;
use vitrine::formats::{WriteOptions, encode, image_format};
use vitrine::math::{Rgb, Vec2, Vec3, hash};

/// Makes a picture.
type Maker = fn() -> Image;

const TEXTURES: &[(&str, Maker)] = &[
    ("scenes/coursework/textures/globe.png", globe),
    ("scenes/coursework/textures/leaded-window.png", leaded_window),
    ("scenes/textures/vitrine-wood.png", wood),
    ("scenes/textures/vitrine-marble.png", marble),
    ("scenes/textures/vitrine-brick.png", brick),
    ("scenes/textures/vitrine-paper.png", paper),
];

/// Writes every picture.
///
/// # Errors
/// The first that cannot be written.
pub fn write() -> Result<(), String> {
    for (path, make) in TEXTURES {
        let whole = root().join(path);
        let folder = whole.parent().unwrap_or(root());
        fs::create_dir_all(folder)
            .map_err(|e| e.to_string())
            .and_then(|()| fs::write(&whole, bytes(path, &make())?).map_err(|e| e.to_string()))
            .map_err(|e| format!("cannot write {path}: {e}"))?;
        println!("wrote {path}");
    }
    Ok(())
}

/// Compares every picture with what [`write()`] would write.
///
/// # Errors
/// The first that differs or is missing.
pub fn check() -> Result<(), String> {
    for (path, make) in TEXTURES {
        if fs::read(root().join(path)).ok() != Some(bytes(path, &make())?) {
            return Err(format!("run `cargo xtask textures`: it would write otherwise {path}"));
        }
    }
    println!("textures: every file is what `cargo xtask textures` writes");
    Ok(())
}

fn bytes(name: &str, image: &Image) -> Result<Vec<u8>, String> {
    let format = image_format(Path::new(name)).map_err(|e| e.to_string())?;
    encode(format, image, &WriteOptions::default()).map_err(|e| e.to_string())
}

/// A picture from the colour at each point.
pub fn paint(size: [u32; 2], color: impl Fn(Vec2) -> Rgb) -> Image {
    let mut image = Image::filled(size, Rgb::BLACK);
    for (i, pixel) in image.pixels.iter_mut().enumerate() {
        let (x, y) = (i as u32 % size[0], i as u32 / size[0]);
        // u to the right, v up, at the middle of the texel.
        let u = (x as f32 + 0.5) / size[0] as f32;
        *pixel = color(Vec2::new(u, 1.0 - (y as f32 + 0.5) / size[1] as f32));
    }
    image
}

/// A colour from its six hexadecimal digits.
pub fn srgb(hex: u32) -> Rgb {
    Rgb::from_srgb8([(hex >> 16) as u8, (hex >> 8) as u8, hex as u8])
}

/// From 0 at `from` to 1 at `to`, smooth at both ends.
pub fn ramp(from: f32, to: f32, v: f32) -> f32 {
    let t = ((v - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smooth random heights around 0, finer and weaker octave by octave.
fn noise(p: Vec3) -> f32 {
    let octave = |p: Vec3, seed: u32| {
        let (cell, f) = (p.floor(), p - p.floor());
        let smooth = f * f * (Vec3::splat(3.0) - f * 2.0);
        let corner = |i: u32| {
            let c = [i & 1, i >> 1 & 1, i >> 2];
            let at =
                [cell.x, cell.y, cell.z].into_iter().zip(c).map(|(v, c)| (v as i32 as u32).wrapping_add(c));
            let value = hash::unit(at.fold(hash::mix(seed), hash::join));
            let side = |c: u32, t: f32| if c == 0 { 1.0 - t } else { t };
            (value - 0.5) * side(c[0], smooth.x) * side(c[1], smooth.y) * side(c[2], smooth.z)
        };
        (0..8).map(corner).sum::<f32>()
    };
    (0..5_u32).map(|k| octave(p * (1 << k) as f32, k) / (1 << k) as f32).sum()
}

/// Seas and lands of no real planet, with lines every 30 degrees.
fn globe() -> Image {
    paint([584, 292], |at| {
        let (longitude, latitude) = (std::f32::consts::TAU * at.x, std::f32::consts::PI * (at.y - 0.5));
        let ring = libm::cosf(latitude);
        let p = Vec3::new(ring * libm::sinf(longitude), libm::sinf(latitude), ring * libm::cosf(longitude));
        let height = noise(p * 1.7 + Vec3::splat(3.4)) + 0.03;
        let sea = srgb(0x0d2f5e).lerp(srgb(0x2f86b5), ramp(-0.35, 0.0, height));
        let low = srgb(0x5f8f4a).lerp(srgb(0xc9a862), ramp(0.25, 0.75, 1.0 - p.y.abs() - noise(p * 5.0)));
        let land = low.lerp(srgb(0x7a5a40), ramp(0.12, 0.32, height));
        let shore = ramp(-0.004, 0.006, height);
        let ice = ramp(0.86, 0.9, p.y.abs() + 0.12 * noise(p * 6.0));
        let color = sea.lerp(land, shore).lerp(srgb(0xf2f6fa), ice);
        // The lines keep their width on the ball: degrees of longitude are shorter towards the poles.
        let off = |degrees: f32| (degrees - 30.0 * (degrees / 30.0).round()).abs();
        let meridian = off(360.0 * at.x) * ring.max(0.05);
        let parallel = off(180.0 * (at.y - 0.5));
        color.lerp(srgb(0xfff4d6), 0.55 * (1.0 - ramp(0.25, 0.7, meridian.min(parallel))))
    })
}

/// Pieces of coloured glass between strips of lead, framed for a triangle with its tip in the middle above.
fn leaded_window() -> Image {
    const COLORS: [u32; 7] = [0xc4262e, 0xe8a317, 0x1f5fa8, 0x2e8b57, 0x6a3d9a, 0xf2d16b, 0x2aa7b8];
    const CELLS: f32 = 7.0;
    paint([512, 512], |at| {
        let p = at * CELLS;
        // The two nearest of the cells' middles; the second a whole cell away at most.
        let (mut nearest, mut second, mut piece) = (f32::MAX, f32::MAX, 0);
        for k in 0..25_i32 {
            let cell = p.floor() + Vec2::new((k % 5 - 2) as f32, (k / 5 - 2) as f32);
            let id = hash::join(hash::mix(cell.x as i32 as u32), cell.y as i32 as u32);
            let shift = Vec2::new(hash::unit(id), hash::unit(hash::mix(id)));
            let distance = (cell + Vec2::splat(0.1) + shift * 0.8 - p).length();
            if distance < nearest {
                (second, nearest, piece) = (nearest, distance, id);
            } else {
                second = second.min(distance);
            }
        }
        // Any number gives other colours; with this one few neighbours are alike.
        let color = srgb(COLORS[(hash::mix(piece ^ 8) % COLORS.len() as u32) as usize]);
        let cloud = 1.0 + 0.7 * noise(Vec3::new(p.x, p.y, hash::unit(piece) * 9.0) * 1.5);
        let lead = 1.0 - ramp(0.05, 0.085, second - nearest);
        // The sides of the triangle (0, 0), (1, 0), (½, 1): v = 0, v = 2u, v = 2 − 2u.
        let slant = 5.0_f32.sqrt();
        let edge = at.y.min((2.0 * at.x - at.y) / slant).min((2.0 - 2.0 * at.x - at.y) / slant) * CELLS;
        let frame = 1.0 - ramp(0.08, 0.12, edge);
        (color * cloud).lerp(srgb(0x1b1c20), lead.max(frame))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checked_in_pictures_are_what_the_chore_writes() {
        assert_eq!(check(), Ok(()));
    }
}
