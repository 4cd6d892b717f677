//! The radiance of a place all around, from a panorama: how bright a direction is, and how to choose bright ones.
//!
//! Texels are chosen row by row and then in their row, by their light (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th
//! edition, 12.5). A texel counts with the mean of what the smooth picture between texels shows in it, so nothing bright is
//! missed; within a texel all directions are alike, by solid angle.

use super::inversion::Inversion;
use std::f32::consts::{FRAC_1_PI, PI, TAU};
use std::sync::Arc;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::RadianceMap;

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
    /// Where rows lie.
    bands: Vec<Band>,
    /// Mean luminance, scaled.
    mean: f32,
}

impl Panorama {
    /// A map that is turned about Y, in radians, and scaled. None where no light is in it.
    pub fn new(map: &Arc<RadianceMap>, turn: f32, scale: Rgb) -> Option<Self> {
        let [width, height] = map.size.map(|n| n as usize);
        let bands: Vec<Band> = (0..height).map(|row| Band::new(row, height)).collect();
        let luminance = |row: usize| -> Vec<f32> {
            map.pixels[row * width..][..width].iter().map(|&texel| (texel * scale).luminance()).collect()
        };
        let (mut columns, mut sums) = (Vec::with_capacity(height), Vec::with_capacity(height));
        let mut near = [luminance(0), luminance(0), luminance(1.min(height - 1))];
        for row in 0..height {
            let weights = cell_means(&near);
            let sum: f64 = weights.iter().map(|&w| f64::from(w)).sum();
            sums.push((sum * f64::from(bands[row].height())) as f32);
            columns.push(Inversion::new(&weights));
            near.rotate_left(1);
            near[2] = luminance((row + 2).min(height - 1));
        }
        let whole: f64 = sums.iter().map(|&sum| f64::from(sum)).sum();
        let mean = (whole / (2.0 * width as f64)) as f32;
        let turn = turn / TAU;
        let panorama =
            Self { map: map.clone(), turn, scale, rows: Inversion::new(&sums), columns, bands, mean };
        (mean > 0.0 && mean.is_finite()).then_some(panorama)
    }

    /// The irradiance that it would bring if it were as bright everywhere as in the mean, as a luminance.
    pub fn irradiance(&self) -> f32 {
        PI * self.mean
    }

    /// The radiance from a direction, smooth between texels.
    pub fn le(&self, toward: Vec3) -> Rgb {
        let [u, v] = self.place(toward);
        let [width, height] = self.map.size;
        let (x, y) = (u * width as f32 - 0.5, v * height as f32 - 0.5);
        let (x0, y0) = (libm::floorf(x), libm::floorf(y));
        let (tx, ty) = (x - x0, y - y0);
        // Around the turn the picture goes on at its other side.
        let wrap = |x: i32| if x < 0 { width - 1 } else { x as u32 % width };
        let columns = [wrap(x0 as i32), wrap(x0 as i32 + 1)];
        let row = |y: i32| y.clamp(0, height as i32 - 1) as u32 * width;
        let across = |y: i32| {
            let [a, b] = columns.map(|x| self.map.pixels[(row(y) + x) as usize]);
            a.lerp(b, tx)
        };
        across(y0 as i32).lerp(across(y0 as i32 + 1), ty) * self.scale
    }

    /// A direction and its density per steradian.
    pub fn choose(&self, u: [f32; 2]) -> (Vec3, f32) {
        let (row, down, of_row) = self.rows.choose(u[0]);
        let (column, along, of_column) = self.columns[row].choose(u[1]);
        let around = (column as f32 + along) / self.map.size[0] as f32 - 0.5 - self.turn;
        let (sin, cos) = libm::sincosf(TAU * around);
        let [y, ground] = self.bands[row].at(down);
        (Vec3::new(ground * sin, y, -ground * cos), of_row * of_column / self.solid_angle(row))
    }

    /// The density per steradian with which [`Self::choose`] finds a direction.
    pub fn pdf(&self, toward: Vec3) -> f32 {
        let [u, v] = self.place(toward);
        let cell = |share: f32, n: u32| ((share * n as f32) as usize).min(n as usize - 1);
        let (row, column) = (cell(v, self.map.size[1]), cell(u, self.map.size[0]));
        self.rows.share(row) * self.columns[row].share(column) / self.solid_angle(row)
    }

    /// Of a texel: (cosθ₀ − cosθ₁)·2π/width
    fn solid_angle(&self, row: usize) -> f32 {
        self.bands[row].height() * TAU / self.map.size[0] as f32
    }

    /// Where in the map a direction is, from 0 to 1 from its left and its top.
    fn place(&self, toward: Vec3) -> [f32; 2] {
        let around = 0.5 + libm::atan2f(toward.x, -toward.z) * (0.5 * FRAC_1_PI) + self.turn;
        let around = around - libm::floorf(around);
        // Near the poles the arc cosine would lose digits.
        let ground = (toward.x * toward.x + toward.z * toward.z).sqrt();
        [around, libm::atan2f(ground, toward.y) * FRAC_1_PI]
    }
}

/// Where a row of texels lies: one less the cosine of the angle to the nearer pole, which keeps digits that the cosine would lose.
#[derive(Clone, Copy, Debug)]
struct Band {
    /// At the row's upper edge.
    from: f32,
    /// At the row's lower edge.
    to: f32,
    /// The pole's height: 1 of +Y, −1 of −Y.
    pole: f32,
}

impl Band {
    fn new(row: usize, height: usize) -> Self {
        let is_upper = 2 * row < height;
        let rest = |edge: usize| {
            let from_pole = if is_upper { edge } else { height - edge };
            // 1 − cosθ = 2·sin²(θ/2)
            let half = libm::sin(std::f64::consts::FRAC_PI_2 * from_pole as f64 / height as f64);
            (2.0 * half * half) as f32
        };
        Self { from: rest(row), to: rest(row + 1), pole: if is_upper { 1.0 } else { -1.0 } }
    }

    /// The difference of the cosines of its edges.
    fn height(&self) -> f32 {
        (self.to - self.from).abs()
    }

    /// Y and the distance from the axis of a unit vector in it: `down` is 0 at the upper edge and 1 at the lower, even by area.
    fn at(&self, down: f32) -> [f32; 2] {
        let rest = self.from + (self.to - self.from) * down;
        [self.pole * (1.0 - rest), (rest * (2.0 - rest)).max(0.0).sqrt()]
    }
}

/// The mean of the smooth picture in each texel of the middle one of three rows: the weights ⅛, ¾, ⅛ both ways, which are the
/// integrals of the tent over a texel and its neighbours.
fn cell_means(rows: &[Vec<f32>; 3]) -> Vec<f32> {
    let mean = |a: f32, b: f32, c: f32| 0.125 * (a + c) + 0.75 * b;
    let down: Vec<f32> = (0..rows[1].len()).map(|x| mean(rows[0][x], rows[1][x], rows[2][x])).collect();
    let n = down.len();
    (0..n).map(|x| mean(down[(x + n - 1) % n], down[x], down[(x + 1) % n])).collect()
}
