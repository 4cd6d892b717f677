//! The pictures of the material library: wood, marble, brick, paper. Each can be laid side by side with itself without a seam.

use crate::textures::{paint, ramp, srgb};
use vitrine::film::Image;
use vitrine::math::{Vec2, hash};

/// Width and height, texels.
const SIZE: [u32; 2] = [256, 256];

/// A number from 0 to 1 by chance for a cell of a lattice.
fn chance(x: i32, y: i32, seed: u32) -> f32 {
    hash::unit(hash::join(hash::join(hash::mix(seed), x as u32), y as u32))
}

/// Smooth random heights around 0 over so many cells across and up, the same on opposite edges of the picture.
fn cells(at: Vec2, across: [i32; 2], seed: u32) -> f32 {
    let p = at * Vec2::new(across[0] as f32, across[1] as f32);
    let (cell, f) = (p.floor(), p - p.floor());
    let smooth = f * f * (Vec2::splat(3.0) - f * 2.0);
    let corner = |dx: i32, dy: i32| {
        let x = (cell.x as i32 + dx).rem_euclid(across[0]);
        let y = (cell.y as i32 + dy).rem_euclid(across[1]);
        chance(x, y, seed) - 0.5
    };
    let row = |dy: i32| corner(0, dy) * (1.0 - smooth.x) + corner(1, dy) * smooth.x;
    row(0) * (1.0 - smooth.y) + row(1) * smooth.y
}

/// Heights of several sizes, each half as large and half as strong.
fn heights(at: Vec2, across: [i32; 2], seed: u32) -> f32 {
    (0..4_u32).map(|k| cells(at, across.map(|n| n << k), seed + k) / (1 << k) as f32).sum()
}

/// Boards of oak, the grain along u.
pub fn wood() -> Image {
    const BOARDS: f32 = 4.0;
    paint(SIZE, |at| {
        let board = (at.y * BOARDS).floor();
        let id = board as u32;
        // Each board is cut from another place of the trunk.
        let own = Vec2::new((at.x + chance(0, board as i32, 7)).fract(), at.y);
        let bend = heights(own, [2, 8], 11 + id);
        let ring = libm::sinf((own.y * BOARDS * 3.0 + 1.6 * bend) * std::f32::consts::TAU);
        let fibre = cells(own, [8, 128], 23 + id) + 0.5 * cells(own, [16, 128], 29 + id);
        let tone = 0.5 + 0.22 * ring + 0.35 * fibre + 0.3 * (chance(id as i32, 0, 3) - 0.5);
        let color = srgb(0x87562d).lerp(srgb(0xcf9a5e), tone.clamp(0.0, 1.0));
        let off = (at.y * BOARDS - (at.y * BOARDS).round()).abs() / BOARDS;
        color * (0.55 + 0.45 * ramp(0.0, 0.006, off))
    })
}

/// White marble with grey veins.
pub fn marble() -> Image {
    paint(SIZE, |at| {
        let flow = heights(at, [3, 3], 41);
        let wide = (heights(at, [2, 2], 53) + 0.35 * flow).abs();
        let thin = (heights(at, [4, 4], 67) - 0.3 * flow).abs();
        let vein = 0.75 * (1.0 - ramp(0.0, 0.09, wide)) + 0.45 * (1.0 - ramp(0.0, 0.04, thin));
        let cloud = srgb(0xf3f1ee).lerp(srgb(0xdcdcde), (0.5 + flow).clamp(0.0, 1.0));
        cloud.lerp(srgb(0x74777f), vein.min(0.85))
    })
}

/// Courses of red brick.
pub fn brick() -> Image {
    const COURSES: f32 = 6.0;
    const ACROSS: f32 = 4.0;
    paint(SIZE, |at| {
        let course = (at.y * COURSES).floor();
        // Every second course is shifted by half a brick.
        let along = at.x * ACROSS + 0.5 * (course % 2.0);
        let number = along.floor().rem_euclid(ACROSS);
        let (x, y) = (along - along.floor(), at.y * COURSES - course);
        let edge = (x.min(1.0 - x) * COURSES / ACROSS * 1.5).min(y.min(1.0 - y));
        let rough = heights(at, [16, 16], 71);
        let tone = chance(number as i32, course as i32, 73);
        let brick = srgb(0x8e3f2c).lerp(srgb(0xb9664a), tone) * (1.0 + 0.35 * rough);
        let mortar = srgb(0xc4bbae) * (1.0 + 0.25 * rough);
        mortar.lerp(brick, ramp(0.06, 0.11, edge + 0.03 * rough))
    })
}

/// Paper with faint fibres.
pub fn paper() -> Image {
    paint(SIZE, |at| {
        let fibre = cells(at, [12, 96], 83) + cells(at, [96, 12], 89) + heights(at, [8, 8], 97);
        srgb(0xf3eee2) * (1.0 + 0.05 * fibre)
    })
}

/// The way from one edge of a made picture to the opposite one, as the largest step between neighbours there.
#[cfg(test)]
fn seam(image: &Image) -> f32 {
    let [width, height] = image.size;
    let step = |a: vitrine::math::Rgb, b: vitrine::math::Rgb| (a.g - b.g).abs();
    let rows: f32 = (0..height).map(|y| step(image.pixel(0, y), image.pixel(width - 1, y))).sum();
    let columns: f32 = (0..width).map(|x| step(image.pixel(x, 0), image.pixel(x, height - 1))).sum();
    (rows / height as f32).max(columns / width as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opposite_edges_fit_together() {
        for (name, image) in [("marble", marble()), ("paper", paper())] {
            assert!(seam(&image) < 0.05, "{name}: {}", seam(&image));
        }
    }
}
