//! The radiance of a place all around, from a panorama: how bright a direction is, and how to choose bright ones.
//!
//! Texels are chosen row by row and then in their row, by their light (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th
//! edition, 12.5). Between texels the picture is smooth: each shines as a tent over its neighbours, and that is how a point near
//! a chosen one is found. So directions are chosen in proportion to their light, without steps from texel to texel.

use super::inversion::Inversion;
use std::f32::consts::{FRAC_1_PI, PI, TAU};
use std::sync::Arc;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::RadianceMap;

/// The least sine of the angle to a pole that counts: nearer, no density is larger.
const POLE: f32 = 1e-6;

/// A panorama that shines.
#[derive(Clone, Debug)]
pub struct Panorama {
    map: Arc<RadianceMap>,
    /// Its share of a whole turn.
    turn: f32,
    /// By which its texels are multiplied.
    scale: Rgb,
    /// The choice of a row.
    rows: Inversion,
    /// The choice of a texel, row after row.
    columns: Vec<Inversion>,
    /// The sines of the angles of the rows' middles from +Y, divided by the mean over all texels of luminance times sine.
    sines: Vec<f32>,
    /// Mean luminance, scaled.
    mean: f32,
}

/// Where a direction falls between four texels.
struct Between {
    columns: [usize; 2],
    rows: [usize; 2],
    /// The shares of the second column and the second row.
    shares: [f32; 2],
    /// The distance from the axis.
    sin: f32,
}

impl Panorama {
    /// A map that is turned about Y, in radians, and scaled. None where no light is in it.
    pub fn new(map: &Arc<RadianceMap>, turn: f32, scale: Rgb) -> Option<Self> {
        let [width, height] = map.size.map(|n| n as usize);
        let mut sines: Vec<f32> =
            (0..height).map(|row| libm::sinf(PI * (row as f32 + 0.5) / height as f32)).collect();
        let (mut columns, mut sums) = (Vec::with_capacity(height), Vec::with_capacity(height));
        for (row, sine) in map.pixels.chunks_exact(width).zip(&sines) {
            let weights: Vec<f32> = row.iter().map(|&texel| (texel * scale).luminance()).collect();
            // f64: millions of texels are added.
            let sum: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
            sums.push((sum / width as f64) as f32 * sine);
            columns.push(Inversion::new(&weights));
        }
        let whole = sums.iter().map(|&sum| f64::from(sum)).sum::<f64>() / height as f64;
        let mean = (whole / (sines.iter().map(|&sine| f64::from(sine)).sum::<f64>() / height as f64)) as f32;
        if !(mean > 0.0 && mean.is_finite()) {
            return None;
        }
        sines.iter_mut().for_each(|sine| *sine = (f64::from(*sine) / whole) as f32);
        let rows = Inversion::new(&sums);
        Some(Self { map: map.clone(), turn: turn / TAU, scale, rows, columns, sines, mean })
    }

    /// The irradiance that it would bring if it were as bright everywhere as in the mean, as a luminance.
    pub fn irradiance(&self) -> f32 {
        PI * self.mean
    }

    /// The radiance from a direction, smooth between texels.
    #[inline]
    pub fn le(&self, toward: Vec3) -> Rgb {
        self.le_and_pdf(toward).0
    }

    /// The density per steradian with which [`Self::choose`] finds a direction.
    #[inline]
    pub fn pdf(&self, toward: Vec3) -> f32 {
        self.le_and_pdf(toward).1
    }

    /// Both at once: most of the work is the same.
    #[inline]
    pub fn le_and_pdf(&self, toward: Vec3) -> (Rgb, f32) {
        let Between { columns, rows, shares, sin } = self.between(toward);
        let across = |row: usize| {
            let texels = &self.map.pixels[row * self.map.size[0] as usize..];
            texels[columns[0]].lerp(texels[columns[1]], shares[0]) * self.scale
        };
        let [upper, lower] = rows.map(across);
        let weights = [upper, lower].map(Rgb::luminance);
        let (a, b) = (weights[0] * self.sines[rows[0]], weights[1] * self.sines[rows[1]]);
        // p_ω = p_uv/(2π²·sinθ)
        let pdf = (a * (1.0 - shares[1]) + b * shares[1]) / (2.0 * PI * PI * sin.max(POLE));
        (upper.lerp(lower, shares[1]), pdf)
    }

    /// A direction.
    pub fn choose(&self, u: [f32; 2]) -> Vec3 {
        let [width, height] = self.map.size.map(|n| n as f32);
        let (row, down) = self.rows.choose(u[0]);
        let (column, along) = self.columns[row].choose(u[1]);
        let x = (column as f32 + tent(along)) / width;
        // Beyond the upper and the lower end the picture goes on as its last row: that is the tent folded back.
        let y = (row as f32 + tent(down)).abs();
        let y = y.min(2.0 * height - y) / height;
        let (sin, cos) = libm::sincosf(TAU * (x - 0.5 - self.turn));
        let (ground, up) = libm::sincosf(PI * y);
        Vec3::new(ground * sin, up, -ground * cos)
    }

    #[inline]
    fn between(&self, toward: Vec3) -> Between {
        let [width, height] = self.map.size;
        let around = 0.5 + libm::atan2f(toward.x, -toward.z) * (0.5 * FRAC_1_PI) + self.turn;
        let around = around - libm::floorf(around);
        // By the distance from the axis, for near the poles the arc cosine would lose digits.
        let sin = (toward.x * toward.x + toward.z * toward.z).sqrt();
        let down = libm::atan2f(sin, toward.y) * FRAC_1_PI;
        let (x, y) = (around * width as f32 - 0.5, down * height as f32 - 0.5);
        let (x0, y0) = (libm::floorf(x), libm::floorf(y));
        // At its sides the picture goes on at the other side.
        let column = |x: i32| (if x < 0 { width - 1 } else { x as u32 % width }) as usize;
        let row = |y: i32| y.clamp(0, height as i32 - 1) as usize;
        Between {
            columns: [column(x0 as i32), column(x0 as i32 + 1)],
            rows: [row(y0 as i32), row(y0 as i32 + 1)],
            shares: [x - x0, y - y0],
            sin,
        }
    }
}

/// A number in [0, 1] as a place between −½ and 1½, with a density that is a tent over ½.
#[inline]
fn tent(u: f32) -> f32 {
    if u < 0.5 { (2.0 * u).sqrt() - 0.5 } else { 1.5 - (2.0 - 2.0 * u).max(0.0).sqrt() }
}
