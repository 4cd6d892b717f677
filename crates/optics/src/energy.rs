//! How much rough surfaces give back in all: tables of directional albedos, by which layers share light out and by which
//! rough surfaces get back what one bounce between facets loses (Kulla and Conty, "Revisiting Physically Based Shading at
//! Imageworks", SIGGRAPH course 2017).
//!
//! A table is worked out at its first use, by a fixed set of directions, so it is the same on every machine.

use crate::fresnel::dielectric;
use crate::microfacet::Ggx;
use crate::refraction::refract;
use std::sync::OnceLock;
use vitrine_math::{Rgb, Vec3};

/// Nodes over √cos θ, over the roughness √α, and over (η − 1)/(η + 1).
const ANGLES: usize = 24;
const WIDTHS: usize = 16;
const INDICES: usize = 12;
/// The greatest (η − 1)/(η + 1): an index of 3.
const GREATEST: f32 = 0.5;
/// Facets tried for each entry.
const FACETS: u32 = 256;

/// A table over angle, roughness and index, and its means over even light.
struct Grid {
    albedo: Vec<[f32; ANGLES]>,
    average: Vec<f32>,
    indices: usize,
}

/// A table at one roughness and index.
#[derive(Clone, Copy)]
pub(crate) struct Lookup {
    grid: &'static Grid,
    /// The first of two neighbouring rows, at the index below and above.
    rows: [u16; 2],
    /// How far on to the next row and the next index, 0 to 1.
    toward: [f32; 2],
    average: f32,
}

impl std::fmt::Debug for Lookup {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lookup").field("average", &self.average).finish_non_exhaustive()
    }
}

impl Lookup {
    /// The albedo at an angle with the cosine `cos`.
    #[inline]
    pub(crate) fn at(&self, cos: f32) -> f32 {
        let x = cos.clamp(0.0, 1.0).sqrt() * (ANGLES - 1) as f32;
        let below = (x as usize).min(ANGLES - 2);
        let t = x - below as f32;
        let row = |i: usize| {
            let row = &self.grid.albedo[i];
            row[below] + t * (row[below + 1] - row[below])
        };
        self.mix(row)
    }

    /// Interpolates what `row` gives of the four rows around.
    #[inline]
    fn mix(&self, row: impl Fn(usize) -> f32) -> f32 {
        let pair = |i: u16| {
            let (a, b) = (row(usize::from(i)), row(usize::from(i) + 1));
            a + self.toward[0] * (b - a)
        };
        let (a, b) = (pair(self.rows[0]), pair(self.rows[1]));
        a + self.toward[1] * (b - a)
    }

    /// The mean over even light, 2∫E(μ)μ dμ: exactly that of what [`Self::at`] gives.
    #[inline]
    pub(crate) fn average(&self) -> f32 {
        self.average
    }
}

/// What facets of a metal that absorbs nothing give back with one bounce.
pub(crate) fn mirrors(alpha: f32) -> Lookup {
    static TABLE: OnceLock<Grid> = OnceLock::new();
    let table = TABLE.get_or_init(|| Grid::new(1, |facets, wo, _| trial(facets, wo, &|_| 1.0, None)));
    table.lookup(alpha, 0.0)
}

/// What a rough dielectric reflects from outside, with one bounce. From inside, too: of an index below 1 the inverse is
/// taken, for what lies below such a surface is not to be darkened by total reflection.
pub(crate) fn glossy(alpha: f32, eta: f32) -> Lookup {
    static TABLE: OnceLock<Grid> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        Grid::new(INDICES, |facets, wo, s| {
            let eta = (1.0 + s) / (1.0 - s);
            trial(facets, wo, &|cos| dielectric(cos, eta), None)
        })
    });
    table.lookup(alpha, strength(eta))
}

/// What a rough, clear dielectric gives back to both sides with one bounce, as energy.
pub(crate) fn glass(alpha: f32, eta: f32) -> Lookup {
    static INTO: OnceLock<Grid> = OnceLock::new();
    static OUT: OnceLock<Grid> = OnceLock::new();
    let make = |is_out: bool| {
        Grid::new(INDICES, move |facets, wo, s| {
            // An index of 1 exactly does not bend and has no facets that it could bend at.
            let s = s.max(1e-3);
            let eta = if is_out { (1.0 - s) / (1.0 + s) } else { (1.0 + s) / (1.0 - s) };
            trial(facets, wo, &|cos| dielectric(cos, eta), Some(eta))
        })
    };
    let table = if eta < 1.0 { OUT.get_or_init(|| make(true)) } else { INTO.get_or_init(|| make(false)) };
    table.lookup(alpha, strength(eta))
}

/// The mean reflectance of a smooth dielectric in even light, 2∫F(μ)μ dμ.
///
/// From inside it is 1 − (1 − F̄)/η² with the η and F̄ of outside: as much comes out as goes in.
pub(crate) fn fresnel_average(eta: f32) -> f32 {
    const NODES: usize = 65;
    static TABLE: OnceLock<[f32; NODES]> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        std::array::from_fn(|i| {
            let s = GREATEST * i as f32 / (NODES - 1) as f32;
            let eta = (1.0 + s) / (1.0 - s);
            const STEPS: u32 = 512;
            let mu = |k: u32| (k as f32 + 0.5) / STEPS as f32;
            (0..STEPS).map(|k| 2.0 * mu(k) * dielectric(mu(k), eta)).sum::<f32>() / STEPS as f32
        })
    });
    let x = (strength(eta) / GREATEST).min(1.0) * (NODES - 1) as f32;
    let below = (x as usize).min(NODES - 2);
    let outside = table[below] + (x - below as f32) * (table[below + 1] - table[below]);
    if eta < 1.0 { 1.0 - (1.0 - outside) * eta * eta } else { outside }
}

/// |η − 1|/(η + 1).
fn strength(eta: f32) -> f32 {
    ((eta - 1.0) / (eta + 1.0)).abs()
}

/// The mean over the facets that `wo` sees of what comes back: mirrored, and bent where there is an `eta`.
fn trial(facets: &Ggx, wo: Vec3, fresnel: &dyn Fn(f32) -> f32, eta: Option<f32>) -> f32 {
    let mut sum = 0.0;
    for i in 0..FACETS {
        // Hammersley's points.
        let u = [(i as f32 + 0.5) / FACETS as f32, i.reverse_bits() as f32 / 4_294_967_296.0];
        let m = facets.sample_visible(wo, u);
        let cos = wo.dot(m);
        if cos <= 0.0 {
            continue;
        }
        let f = fresnel(cos.min(1.0));
        // G₂/G₁
        let seen = |wi: Vec3| facets.g2(wo, wi) / facets.g1(wo);
        let mirrored = m * (2.0 * cos) - wo;
        if mirrored.z > 0.0 {
            sum += f * seen(mirrored);
        }
        if let Some(bent) = eta.and_then(|eta| refract(wo, m, eta))
            && bent.z < 0.0
        {
            sum += (1.0 - f) * seen(bent);
        }
    }
    sum / FACETS as f32
}

impl Grid {
    /// Fills a table with what `entry` makes of facets, direction and (η − 1)/(η + 1).
    fn new(indices: usize, entry: impl Fn(&Ggx, Vec3, f32) -> f32) -> Self {
        let (mut albedo, mut average) = (Vec::new(), Vec::new());
        for index in 0..indices {
            let s = GREATEST * index as f32 / (INDICES - 1) as f32;
            for width in 0..WIDTHS {
                let roughness = (width as f32 / (WIDTHS - 1) as f32).max(SMOOTHEST);
                let row: [f32; ANGLES] = std::array::from_fn(|angle| {
                    let x = angle as f32 / (ANGLES - 1) as f32;
                    let cos = (x * x).max(1e-4);
                    let wo = Vec3::new((1.0 - cos * cos).max(0.0).sqrt(), 0.0, cos);
                    Ggx::from_roughness(roughness).map_or(1.0, |facets| entry(&facets, wo, s)).min(1.0)
                });
                average.push(mean_of(&row));
                albedo.push(row);
            }
        }
        Self { albedo, average, indices }
    }

    fn lookup(&'static self, alpha: f32, strength: f32) -> Lookup {
        let x = alpha.sqrt() * (WIDTHS - 1) as f32;
        let width = (x as usize).min(WIDTHS - 2);
        let (index, next, s) = if self.indices == 1 {
            (0, 0, 0.0)
        } else {
            let y = (strength / GREATEST).min(1.0) * (INDICES - 1) as f32;
            let index = (y as usize).min(INDICES - 2);
            (index, index + 1, y - index as f32)
        };
        let rows = [index, next].map(|i| (i * WIDTHS + width) as u16);
        let mut lookup = Lookup { grid: self, rows, toward: [x - width as f32, s], average: 0.0 };
        lookup.average = lookup.mix(|row| self.average[row]);
        lookup
    }
}

/// Facets of no width cannot be tried; the first row stands for this roughness, which is as good as smooth.
const SMOOTHEST: f32 = 0.032;

/// 2∫E(μ)μ dμ = ∫E(x²)·4x³ dx of a row that is linear in x between its nodes.
fn mean_of(row: &[f32; ANGLES]) -> f32 {
    // Double precision: differences of fourth and fifth powers.
    let h = 1.0 / (ANGLES - 1) as f64;
    let mut sum = 0.0_f64;
    for (i, pair) in row.windows(2).enumerate() {
        let (x0, x1) = (i as f64 * h, (i + 1) as f64 * h);
        let slope = f64::from(pair[1] - pair[0]) / h;
        let fourth = x1.powi(4) - x0.powi(4);
        let fifth = 0.8 * (x1.powi(5) - x0.powi(5));
        sum += f64::from(pair[0]) * fourth + slope * (fifth - x0 * fourth);
    }
    sum as f32
}

/// The share of light that bounced between the facets of clear glass which comes out on the other side. `eta` is the
/// index there over the index here, `here` and `there` what one bounce loses on average.
///
/// As much as a smooth surface lets through, x = 1 − F̄, as far as reciprocity allows: x_here/(η²·there) = x_there/here.
pub(crate) fn sent_on(eta: f32, here: f32, there: f32) -> f32 {
    let (x_here, x_there) = (1.0 - fresnel_average(eta), 1.0 - fresnel_average(1.0 / eta));
    let both = (x_here / (eta * eta * there.max(1e-7))).min(x_there / here.max(1e-7));
    (both * eta * eta * there).min(1.0)
}

/// The colour that bounced light takes on between facets of a metal (Kulla and Conty): F̄²Ē/(1 − F̄(1 − Ē)).
pub(crate) fn bounced_color(average: Rgb, albedo: f32) -> Rgb {
    let channel = |f: f32| f * f * albedo / (1.0 - f * (1.0 - albedo)).max(1e-6);
    Rgb::new(channel(average.r), channel(average.g), channel(average.b))
}
