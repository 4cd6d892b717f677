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

/// Nodes over √cos θ, over the fourth root of the width α, and over (η − 1)/(η + 1).
const ANGLES: usize = 32;
const WIDTHS: usize = 20;
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
    TABLE.get_or_init(|| Grid::new(Comes::Mirrored, |_| MIRROR)).lookup(alpha, 0.0)
}

/// What a rough dielectric reflects from outside, with one bounce. From inside, too: of an index below 1 the inverse is
/// taken, for what lies below such a surface is not to be darkened by total reflection.
pub(crate) fn glossy(alpha: f32, eta: f32) -> Lookup {
    static TABLE: OnceLock<Grid> = OnceLock::new();
    let table = TABLE.get_or_init(|| Grid::new(Comes::Mirrored, |s| (1.0 + s) / (1.0 - s)));
    table.lookup(alpha, strength(eta))
}

/// What a rough, clear dielectric gives back to both sides with one bounce, as energy.
pub(crate) fn glass(alpha: f32, eta: f32) -> Lookup {
    static INTO: OnceLock<Grid> = OnceLock::new();
    static OUT: OnceLock<Grid> = OnceLock::new();
    // An index of 1 exactly does not bend and has no facets that it could bend at.
    let least = |s: f32| s.max(1e-3);
    let table = if eta < 1.0 {
        OUT.get_or_init(|| Grid::new(Comes::MirroredOrBent, |s| (1.0 - least(s)) / (1.0 + least(s))))
    } else {
        INTO.get_or_init(|| Grid::new(Comes::MirroredOrBent, |s| (1.0 + least(s)) / (1.0 - least(s))))
    };
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

/// What of the light at a facet counts.
#[derive(Clone, Copy, PartialEq)]
enum Comes {
    Mirrored,
    MirroredOrBent,
}

/// An index that reflects everything: a table of it has one entry for all indices.
const MIRROR: f32 = f32::INFINITY;

/// The mean over the facets that `wo` sees of what comes back, for each index.
fn trial(facets: &Ggx, wo: Vec3, etas: &[f32], comes: Comes) -> [f32; INDICES] {
    let mut sums = [0.0; INDICES];
    let g1 = facets.g1(wo);
    for i in 0..FACETS {
        // Hammersley's points.
        let u = [(i as f32 + 0.5) / FACETS as f32, i.reverse_bits() as f32 / 4_294_967_296.0];
        let m = facets.sample_visible(wo, u);
        let cos = wo.dot(m).min(1.0);
        if cos <= 0.0 {
            continue;
        }
        // G₂/G₁
        let mirrored = m * (2.0 * cos) - wo;
        let seen = if mirrored.z > 0.0 { facets.g2(wo, mirrored) / g1 } else { 0.0 };
        for (sum, eta) in sums.iter_mut().zip(etas) {
            let f = if *eta == MIRROR { 1.0 } else { dielectric(cos, *eta) };
            *sum += f * seen;
            if comes == Comes::MirroredOrBent
                && let Some(bent) = refract(wo, m, *eta)
                && bent.z < 0.0
            {
                *sum += (1.0 - f) * facets.g2(wo, bent) / g1;
            }
        }
    }
    sums.map(|sum| (sum / FACETS as f32).min(1.0))
}

impl Grid {
    /// Fills a table. `index` makes an index of (η − 1)/(η + 1).
    fn new(comes: Comes, index: impl Fn(f32) -> f32) -> Self {
        let mut etas: Vec<f32> =
            (0..INDICES).map(|i| index(GREATEST * i as f32 / (INDICES - 1) as f32)).collect();
        etas.dedup();
        let indices = etas.len();
        let mut albedo = vec![[0.0; ANGLES]; indices * WIDTHS];
        for width in 0..WIDTHS {
            let root = SMOOTHEST + (1.0 - SMOOTHEST) * width as f32 / (WIDTHS - 1) as f32;
            let Some(facets) = Ggx::from_roughness(root * root) else { continue };
            let row: [[f32; INDICES]; ANGLES] = std::array::from_fn(|angle| {
                let x = angle as f32 / (ANGLES - 1) as f32;
                let cos = (x * x).max(1e-4);
                let wo = Vec3::new((1.0 - cos * cos).max(0.0).sqrt(), 0.0, cos);
                trial(&facets, wo, &etas, comes)
            });
            for i in 0..indices {
                albedo[i * WIDTHS + width] = row.map(|of_indices| of_indices[i]);
            }
        }
        let average = albedo.iter().map(mean_of).collect();
        Self { albedo, average, indices }
    }

    fn lookup(&'static self, alpha: f32, strength: f32) -> Lookup {
        let x = ((alpha.sqrt().sqrt() - SMOOTHEST) / (1.0 - SMOOTHEST)).max(0.0) * (WIDTHS - 1) as f32;
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

/// The fourth root of the width of the first node, which is as good as smooth.
const SMOOTHEST: f32 = 0.179;

/// 2∫E(μ)μ dμ = ∫E(x²)·4x³ dx of a row that is linear in x between its nodes.
fn mean_of(row: &[f32; ANGLES]) -> f32 {
    // Double precision: differences of fourth and fifth powers.
    let h = 1.0 / (ANGLES - 1) as f64;
    let mut sum = 0.0_f64;
    for (i, pair) in row.windows(2).enumerate() {
        let (x0, x1) = (i as f64 * h, (i + 1) as f64 * h);
        let slope = f64::from(pair[1] - pair[0]) / h;
        let (fourth0, fourth1) = (x0 * x0 * x0 * x0, x1 * x1 * x1 * x1);
        let fourth = fourth1 - fourth0;
        let fifth = 0.8 * (fourth1 * x1 - fourth0 * x0);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_light_is_reflected_as_walsh_found() {
        assert!((fresnel_average(1.5) - 0.091_778).abs() < 1e-4);
        assert!((fresnel_average(1.33) - 0.065_931).abs() < 1e-4);
        assert!((fresnel_average(1.0 / 1.5) - 0.596_346).abs() < 1e-4);
        assert_eq!(fresnel_average(1.0), 0.0);
    }

    #[test]
    fn a_nearly_smooth_surface_reflects_like_a_smooth_one() {
        let lookup = glossy(0.0011, 1.5);
        for i in 1..=20_u8 {
            let cos = f32::from(i) / 20.0;
            assert!((lookup.at(cos) - dielectric(cos, 1.5)).abs() < 6e-3, "{cos}");
        }
        assert!((lookup.average() - fresnel_average(1.5)).abs() < 2e-3);
        assert!(mirrors(0.0011).average() > 0.998);
    }

    #[test]
    fn the_rougher_the_more_is_lost() {
        let mut last = 1.1;
        for alpha in [0.01, 0.1, 0.3, 0.6, 1.0] {
            let average = mirrors(alpha).average();
            assert!(average < last);
            last = average;
        }
        assert!(last > 0.4 && last < 0.8, "{last}");
    }

    #[test]
    fn the_average_is_that_of_the_lookup() {
        for lookup in [mirrors(0.37), glossy(0.2, 1.4), glass(0.5, 1.6), glass(0.5, 0.6)] {
            const N: u16 = 4000;
            let mu = |i: u16| (f32::from(i) + 0.5) / f32::from(N);
            let sum: f64 = (0..N).map(|i| f64::from(2.0 * mu(i) * lookup.at(mu(i)))).sum();
            assert!((sum / f64::from(N) - f64::from(lookup.average())).abs() < 1e-5);
        }
    }

    #[test]
    fn both_sides_agree_on_what_is_sent_on() {
        for (here, there) in [(0.1, 0.12), (0.02, 0.05), (0.3, 0.2)] {
            let (x, y) = (sent_on(1.5, here, there), sent_on(1.0 / 1.5, there, here));
            assert!((x / (2.25 * there) - y / here).abs() < 1e-4 * y / here);
            assert!(x > 0.0 && x <= 1.0 && y > 0.0 && y <= 1.0);
        }
    }
}
