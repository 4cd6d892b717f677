//! The statistic by which pictures are held against stored ones.
//!
//! A picture of few samples is one draw, and pictures of different seeds are independent; so the mean of R pictures over a cell (a pixel,
//! a block of pixels, the whole picture; each channel on its own) differs from that of the K stored ones by
//!
//! ```text
//! z = (m − m₀) / √(max(s², s₀²)/R + s₀²/K),
//! ```
//!
//! with the variances s² and s₀² of one picture as the two sides saw them. Light has heavy tails: a few samples are very bright, and
//! means of few pictures are far from normal. That is why the larger variance counts:
//!
//! - One that is much too bright raises s as it raises m. A single one alone gives z = 1, and sums divided by their own spread have tails
//!   no heavier than the normal ones (Efron, "Student's t-Test under Symmetry Conditions", 1969; de la Peña, Lai and Shao,
//!   "Self-Normalized Processes", 2009).
//! - Where bright ones are missing, s is too small, but s₀ knows them from many more pictures. And means of what cannot be
//!   negative are seldom too small: P(m ≤ m₀ − t) ≤ exp(−Rt²/2E[x²]) (Maurer, "A Bound on the Deviation Probability for Sums of
//!   Non-Negative Random Variables", 2003).
//!
//! That holds as long as the noise is of the same kind. A renderer that finds some light much more seldom than the one of the stored
//! pictures did fails, though its mean be right: nothing that it shows in so few pictures tells of what it misses.
//!
//! Making the stored pictures holds each R of them against the rest, so the level is seen to be kept.
//!
//! All cells are one family of tests. The limit of each is Šidák's, by which the chance that any one of a sound picture's fails
//! is at most [`LIMIT_SHARE`], however they depend on each other ("Rectangular Confidence Regions for the Means of
//! Multivariate Normal Distributions", 1967). It is what Subr and Arvo ("Statistical Hypothesis Testing for Assessing Monte
//! Carlo Estimators", 2007) and Mitsuba's tests do, with cells of more sizes: the larger ones tell smaller differences.

use super::scenes::SIZE;
use vitrine_math::Rgb;

/// The chance that the pictures of one scene fail though nothing is wrong.
pub const LIMIT_SHARE: f64 = 1e-3;
/// The edges of the blocks of pixels.
const EDGE: u32 = 4;
/// What rounding may change, as a share of the light.
const ROUNDING: f64 = 1e-5;

/// Pictures of one scene.
#[derive(Clone, Debug)]
pub struct Golden {
    /// The mean of each pixel.
    pub mean: Vec<Rgb>,
    /// The variance of each pixel in one picture.
    pub variance: Vec<Rgb>,
    /// How many pictures there were.
    pub runs: u32,
}

/// The cell that differs most.
#[derive(Debug)]
pub struct Verdict {
    /// By so many standard errors.
    pub worst: f64,
    /// Which one it is.
    pub place: String,
}

/// The mean and the variance of a picture's mean over a cell.
#[derive(Clone, Copy, Debug)]
struct Cell {
    mean: f64,
    variance: f64,
}

impl Golden {
    /// From pictures of different seeds.
    pub fn of(pictures: &[Vec<Rgb>]) -> Self {
        let n = pictures.len() as f64;
        let (mut mean, mut variance) = (Vec::new(), Vec::new());
        for pixel in 0..pictures[0].len() {
            let values = |k: usize| pictures.iter().map(move |p| f64::from(p[pixel].to_array()[k]));
            let means = [0, 1, 2].map(|k| values(k).sum::<f64>() / n);
            let square = |k: usize| values(k).map(|x| (x - means[k]) * (x - means[k])).sum::<f64>();
            mean.push(Rgb::from(means.map(|m| m as f32)));
            variance.push(Rgb::from([0, 1, 2].map(|k| (square(k) / (n - 1.0)) as f32)));
        }
        Self { mean, variance, runs: pictures.len() as u32 }
    }

    /// The same as if it had been seen in fewer pictures.
    pub fn as_seen_by(&self, runs: u32) -> Self {
        Self { runs, ..self.clone() }
    }

    /// The same with so many times the light.
    pub fn scaled(&self, scale: f32) -> Self {
        let times = |all: &[Rgb], scale: f32| all.iter().map(|c| *c * scale).collect();
        Self { mean: times(&self.mean, scale), variance: times(&self.variance, scale * scale), ..*self }
    }

    /// The least standard error of a cell's green light in so many pictures, as a share of that light.
    pub fn least_error(&self, runs: u32) -> f64 {
        let error = |(from, size)| {
            let cell = self.cell(from, size, 1);
            (cell.variance / f64::from(runs) + rounding(cell.mean).powi(2)).sqrt() / cell.mean
        };
        cells().into_iter().map(error).fold(f64::INFINITY, f64::min)
    }

    fn cell(&self, from: [u32; 2], size: [u32; 2], channel: usize) -> Cell {
        let pixels = (from[1]..from[1] + size[1])
            .flat_map(|y| (from[0]..from[0] + size[0]).map(move |x| (y * SIZE[0] + x) as usize));
        let (mut mean, mut variance) = (0.0, 0.0);
        for pixel in pixels {
            mean += f64::from(self.mean[pixel].to_array()[channel]);
            // The pixels of a picture are independent.
            variance += f64::from(self.variance[pixel].to_array()[channel]);
        }
        let n = f64::from(size[0] * size[1]);
        Cell { mean: mean / n, variance: variance / (n * n) }
    }
}

/// The cells that differ most, of `seen` and what it is held against.
pub fn compare(seen: &Golden, truth: &Golden) -> Verdict {
    let mut verdict = Verdict { worst: 0.0, place: String::new() };
    for (from, size) in cells() {
        for channel in 0..3 {
            let (now, before) = (seen.cell(from, size, channel), truth.cell(from, size, channel));
            let square = now.variance.max(before.variance) / f64::from(seen.runs)
                + before.variance / f64::from(truth.runs)
                + rounding(before.mean).powi(2);
            let z = (now.mean - before.mean) / square.sqrt();
            if z.abs() > verdict.worst.abs() {
                let place = format!(
                    "channel {channel} of {size:?} pixels at {from:?}: {} in place of {}",
                    now.mean, before.mean
                );
                verdict = Verdict { worst: z, place };
            }
        }
    }
    verdict
}

/// By how much rounding may change light.
fn rounding(light: f64) -> f64 {
    ROUNDING * (light.abs() + 1e-3)
}

/// Where each cell begins, and its size: pixels, blocks of them, the whole picture.
fn cells() -> Vec<([u32; 2], [u32; 2])> {
    let [width, height] = SIZE;
    let tiled = |edge: u32| {
        let rows = (0..height / edge).map(move |y| y * edge);
        rows.flat_map(move |y| (0..width / edge).map(move |x| ([x * edge, y], [edge, edge])))
    };
    tiled(1).chain(tiled(EDGE)).chain([([0, 0], SIZE)]).collect()
}

/// The largest difference of a cell of a sound picture, standard errors.
pub fn limit() -> f64 {
    // Šidák: (1 − p)ᵐ = 1 − α for each of m tests; and p is what is beyond ±z under the normal curve, erfc(z/√2).
    let tests = (cells().len() * 3) as f64;
    let p = -libm::expm1(libm::log1p(-LIMIT_SHARE) / tests);
    let (mut low, mut high) = (0.0, 40.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if libm::erfc(middle / std::f64::consts::SQRT_2) > p { low = middle } else { high = middle }
    }
    high
}

#[test]
fn the_limit_is_sidaks() {
    // 768 pixels, 48 blocks, the whole, three channels each: p = 4.08·10⁻⁷
    assert_eq!(cells().len() * 3, 2451);
    assert!((limit() - 5.066).abs() < 0.005, "{}", limit());
}

#[test]
fn one_bright_sample_is_not_taken_for_a_difference_and_many_are() {
    let grey = |value: f32| vec![Rgb::splat(value); (SIZE[0] * SIZE[1]) as usize];
    let noisy: Vec<_> = (0..64).map(|k| grey(1.0 + 0.1 * (k % 2) as f32)).collect();
    let truth = Golden::of(&noisy);
    let mut pictures: Vec<_> = noisy[..16].to_vec();
    assert!(compare(&Golden::of(&pictures), &truth).worst.abs() < 1e-3);
    pictures[3][77] = Rgb::splat(1e4);
    assert!(compare(&Golden::of(&pictures), &truth).worst.abs() < 1.1);
    for picture in &mut pictures {
        picture[77] *= 1.2;
    }
    pictures[3][77] = Rgb::splat(1.2);
    assert!(compare(&Golden::of(&pictures), &truth).worst > limit());
}
