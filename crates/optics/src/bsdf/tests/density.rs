//! Sampling held against the densities that it claims: chi-squared over cells of the sphere.

use super::*;

const N: u32 = 60_000;
/// Cells over z and over the angle around it; the integral of the density in each begins with this many points squared.
const RINGS: usize = 24;
const SECTORS: usize = 16;
const POINTS: usize = 16;

/// What was drawn and what was to be expected, cell by cell, and what is not in cells.
struct Counts {
    drawn: Vec<f64>,
    expected: Vec<f64>,
    delta_drawn: f64,
    delta_expected: f64,
    lost: f64,
}

/// The cell of a direction. Rings are finer towards the horizon: z = t·|t|.
fn cell(w: Vec3) -> usize {
    let t = w.z.signum() * w.z.abs().sqrt();
    let ring = ((t + 1.0) * 0.5 * RINGS as f32) as usize;
    let turn = (w.y.atan2(w.x) / std::f32::consts::TAU).rem_euclid(1.0);
    let sector = (turn * SECTORS as f32) as usize;
    ring.min(RINGS - 1) * SECTORS + sector.min(SECTORS - 1)
}

fn expected(bsdf: &Bsdf, wo: Vec3) -> Vec<f64> {
    let mut all = vec![0.0; RINGS * SECTORS];
    let (rings, sectors) = (RINGS * POINTS, SECTORS * POINTS);
    let size = [2.0 / rings as f32, 1.0 / sectors as f32];
    for i in 0..rings {
        for j in 0..sectors {
            let middle = [(i as f32 + 0.5) * size[0] - 1.0, (j as f32 + 0.5) * size[1]];
            let whole = expected_at(bsdf, wo, middle, size);
            all[i / POINTS * SECTORS + j / POINTS] += refined(bsdf, wo, middle, size, whole);
        }
    }
    all
}

/// How many samples a patch expects by the density in its middle. Patches are of t and of turns, z = t·|t|.
fn expected_at(bsdf: &Bsdf, wo: Vec3, [t, turn]: [f32; 2], size: [f32; 2]) -> f64 {
    let wi = direction(t * t.abs(), std::f32::consts::TAU * turn).normalize();
    // dω = dz dφ = 2|t| dt dφ
    let area = 2.0 * t.abs() * size[0] * std::f32::consts::TAU * size[1];
    f64::from(bsdf.pdf(wo, wi) * area) * f64::from(N)
}

/// The same over the patch's quarters, and theirs, until that changes little.
fn refined(bsdf: &Bsdf, wo: Vec3, middle: [f32; 2], size: [f32; 2], whole: f64) -> f64 {
    let half = size.map(|s| s * 0.5);
    let quarters = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)].map(|(a, b)| {
        let at = [middle[0] + a * half[0] * 0.5, middle[1] + b * half[1] * 0.5];
        (at, expected_at(bsdf, wo, at, half))
    });
    let sum: f64 = quarters.iter().map(|q| q.1).sum();
    if (sum - whole).abs() < 0.02 || half[0] < 1e-5 {
        return sum;
    }
    quarters.iter().map(|(at, part)| refined(bsdf, wo, *at, half, *part)).sum()
}

fn count(surface: &Surface, wo: Vec3) -> Counts {
    let bsdf = Bsdf::new(surface, wo.z);
    let mut counts = Counts {
        drawn: vec![0.0; RINGS * SECTORS],
        expected: expected(&bsdf, wo),
        delta_drawn: 0.0,
        delta_expected: 0.0,
        lost: 0.0,
    };
    let mut deltas: Vec<(Vec3, f64)> = Vec::new();
    for i in 0..N {
        let h = hash::join(hash::mix(11), i);
        let unit = |k: u32| hash::unit(hash::mix(h ^ k));
        match bsdf.sample(wo, unit(1), [unit(2), unit(3)]) {
            None => counts.lost += 1.0,
            Some(s) if s.event.is_delta => {
                counts.delta_drawn += 1.0;
                if !deltas.iter().any(|(wi, _)| wi.distance(s.wi) < 1e-4) {
                    deltas.push((s.wi, f64::from(s.pdf)));
                }
            }
            Some(s) => counts.drawn[cell(s.wi)] += 1.0,
        }
    }
    counts.delta_expected = deltas.iter().map(|(_, p)| p * f64::from(N)).sum();
    counts
}

/// The point that chi-squared passes once in a million (Wilson and Hilferty).
fn limit(freedom: f64) -> f64 {
    const Z: f64 = 4.75;
    let a = 2.0 / (9.0 * freedom);
    freedom * (1.0 - a + Z * a.sqrt()).powi(3)
}

fn assert_density(name: &str, surface: &Surface) {
    for cos in [0.9, 0.5, 0.1] {
        let counts = count(surface, direction(cos, 0.4));
        // Cells that expect little are taken together.
        let (mut chi2, mut cells) = (0.0, 0.0);
        let (mut few_drawn, mut few_expected) = (0.0, 0.0);
        for (drawn, expected) in counts.drawn.iter().zip(&counts.expected) {
            if *expected < 8.0 {
                few_drawn += drawn;
                few_expected += expected;
            } else {
                chi2 += (drawn - expected) * (drawn - expected) / expected;
                cells += 1.0;
            }
        }
        if few_expected > 8.0 {
            chi2 += (few_drawn - few_expected) * (few_drawn - few_expected) / few_expected;
            cells += 1.0;
        } else {
            assert!(few_drawn < 30.0, "{name} at {cos}: {few_drawn} where {few_expected} are expected");
        }
        if cells > 0.0 {
            assert!(chi2 < limit(cells), "{name} at {cos}: chi² = {chi2} over {cells} cells");
        }
        let n = f64::from(N);
        let sigma = (n * 0.25).sqrt();
        let (drawn, expected) = (counts.delta_drawn, counts.delta_expected);
        assert!((drawn - expected).abs() < 4.5 * sigma, "{name} at {cos}: {drawn} deltas, not {expected}");
        let all = counts.expected.iter().sum::<f64>() + expected + counts.lost;
        assert!((all / n - 1.0).abs() < 0.01, "{name} at {cos}: densities sum up to {}", all / n);
    }
}

#[test]
fn matte_samples_follow_their_density() {
    let lambert = Surface { specular_weight: 0.0, ..white() };
    assert_density("lambert", &lambert);
    assert_density("rough", &Surface { diffuse_roughness: 0.7, ..lambert });
}

#[test]
fn metal_samples_follow_their_density() {
    for roughness in [0.15, 0.3, 0.6, 1.0] {
        assert_density(&format!("metal {roughness}"), &metal(roughness));
    }
}

#[test]
fn glass_samples_follow_their_density() {
    for roughness in [0.2, 0.4, 0.8] {
        assert_density(&format!("glass {roughness}"), &glass(roughness));
        assert_density(&format!("glass {roughness} from inside"), &from_inside(glass(roughness)));
        assert_density(&format!("pane {roughness}"), &pane(roughness));
    }
}

#[test]
fn layered_samples_follow_their_density() {
    let coated = |surface: Surface| Surface { coat_weight: 1.0, ..surface };
    for (name, surface) in [
        ("plastic", white()),
        ("smooth plastic", Surface { roughness: 0.0, ..white() }),
        ("coated plastic", coated(white())),
        ("rough coated plastic", Surface { coat_roughness: 0.5, ..coated(white()) }),
        ("all", Surface { metalness: 0.3, transmission: 0.5, coat_weight: 0.5, ..white() }),
        ("smooth mix", Surface { transmission: 0.5, roughness: 0.0, ..white() }),
    ] {
        assert_density(name, &surface);
    }
}

#[test]
fn smooth_samples_come_as_often_as_they_claim() {
    for (name, surface) in [("glass", glass(0.0)), ("pane", pane(0.0)), ("mirror", metal(0.0))] {
        let counts = count(&surface, direction(0.3, 0.0));
        let n = f64::from(N);
        assert_eq!((counts.delta_drawn, counts.lost), (n, 0.0), "{name}");
        assert!((counts.delta_expected - n).abs() < 1e-2 * n, "{name}");
    }
}
