//! Colours of thin layers: oil on water, soap, coated lenses, tempered steel.
//!
//! Light reflected at the two faces of a film interferes (Airy). The reflectance of a film is a Fourier series in the
//! path difference, and how a term of that series looks is the Fourier transform of the eye's response, which depends on
//! the path difference alone. So a table of that transform gives the colour without a sum over wavelengths (the idea of
//! Belcour and Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", TOG 36(4),
//! 2017, with a table in place of their Gaussians).

use crate::spectrum;
use std::sync::OnceLock;
use vitrine_math::Rgb;

/// A film of one thickness on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Film {
    /// Its thickness, in micrometres.
    pub thickness: f32,
    /// Its index over the index on the ray's side.
    pub eta: f32,
}

/// What lies below a film, relative to the index on the ray's side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Below {
    /// The index, for each channel.
    pub n: Rgb,
    /// How it absorbs, for each channel; 0 for glass.
    pub k: Rgb,
}

/// Terms of the series beyond this one are too small to see.
const TERMS: u32 = 24;

impl Film {
    /// The reflectance of the film on what lies below it, for unpolarised white light. `cos_i` is 0 to 1.
    ///
    /// With r₁₂ = a real and r₂₃ = |b|·e^{iψ} for one polarisation, and φ = 2π·OPD/λ:
    ///
    ///   R = 1 − (1 − a²)(1 − |b|²)/(1 + a²|b|² + 2a|b| cos(φ + ψ))
    ///     = 1 − (1 − a²)(1 − |b|²)/(1 − a²|b|²)·(1 + 2Σ (−a|b|)^m cos(m(φ + ψ)))
    ///
    /// (Born and Wolf, "Principles of Optics", 7th ed., section 1.6.4).
    #[must_use]
    pub fn reflectance(&self, cos_i: f32, below: &Below) -> Rgb {
        let Some(top) = Top::new(self, cos_i) else { return Rgb::WHITE };
        let table = transform();
        let channel = |c: usize, n: f32, k: f32| {
            let (s, p) = top.below(n, k);
            0.5 * (series(top.s, s, top.path, &table[c]) + series(top.p, p, top.path, &table[c]))
        };
        Rgb::new(
            channel(0, below.n.r, below.k.r),
            channel(1, below.n.g, below.k.g),
            channel(2, below.n.b, below.k.b),
        )
    }

    /// The reflectance for unpolarised light of one wavelength, in micrometres. The green channel of `below` counts.
    #[must_use]
    pub fn reflectance_at(&self, cos_i: f32, below: &Below, wavelength: f32) -> f32 {
        let Some(top) = Top::new(self, cos_i) else { return 1.0 };
        let turn = std::f32::consts::TAU * top.path / wavelength;
        let phase = Complex { re: libm::cosf(turn), im: libm::sinf(turn) };
        let airy = |a: f32, b: Complex| {
            // 1 + a²|b|² + 2a|b| cos(φ + ψ)
            let b2 = b.norm2();
            let bottom = 1.0 + a * a * b2 + 2.0 * a * (b * phase).re;
            1.0 - (1.0 - a * a) * (1.0 - b2) / bottom.max(1e-12)
        };
        let (s, p) = top.below(below.n.g, below.k.g);
        0.5 * (airy(top.s, s) + airy(top.p, p))
    }
}

/// The upper face of a film, met at one angle.
struct Top {
    /// The amplitudes reflected, across and in the plane of incidence.
    s: f32,
    p: f32,
    sin2: f32,
    eta: f32,
    cos_film: f32,
    /// The path difference of neighbouring reflections, 2·n·d·cos θ, in micrometres.
    path: f32,
}

impl Top {
    /// None at total internal reflection.
    fn new(film: &Film, cos_i: f32) -> Option<Self> {
        let sin2 = (1.0 - cos_i * cos_i).max(0.0);
        let sin2_film = sin2 / (film.eta * film.eta);
        if sin2_film >= 1.0 || cos_i <= 0.0 {
            return None;
        }
        let cos_film = (1.0 - sin2_film).sqrt();
        let s = (cos_i - film.eta * cos_film) / (cos_i + film.eta * cos_film);
        let p = (film.eta * cos_i - cos_film) / (film.eta * cos_i + cos_film);
        let path = 2.0 * film.eta * film.thickness * cos_film;
        Some(Self { s, p, sin2, eta: film.eta, cos_film, path })
    }

    /// The amplitudes that the lower face reflects, across and in the plane of incidence.
    fn below(&self, n: f32, k: f32) -> (Complex, Complex) {
        // N cos θ₃ = √(N² − sin²θ), with N = n + ik
        let n2 = Complex { re: n * n - k * k, im: 2.0 * n * k };
        let n_cos = Complex { re: n2.re - self.sin2, im: n2.im }.sqrt();
        let film_cos = self.eta * self.cos_film;
        let s = Complex { re: film_cos - n_cos.re, im: -n_cos.im }
            / Complex { re: film_cos + n_cos.re, im: n_cos.im };
        let (lower, upper) = (n2 * self.cos_film, n_cos * self.eta);
        let p = Complex { re: lower.re - upper.re, im: lower.im - upper.im }
            / Complex { re: lower.re + upper.re, im: lower.im + upper.im };
        (s, p)
    }
}

/// The series of [`Film::reflectance`] for one polarisation and channel.
fn series(a: f32, b: Complex, path: f32, table: &[Complex]) -> f32 {
    let b2 = b.norm2().min(1.0);
    let front = (1.0 - a * a) * (1.0 - b2) / (1.0 - a * a * b2).max(1e-7);
    // (−a·b)^m, with the phase ψ of b in it
    let step = b * -a;
    let mut power = Complex { re: 1.0, im: 0.0 };
    let mut sum = 1.0;
    for m in 1..=TERMS {
        power = power * step;
        let at = m as f32 * path * PER_MICROMETRE;
        if power.norm2() < 1e-7 || at >= (ENTRIES - 1) as f32 {
            break;
        }
        let below = at as usize;
        let t = at - below as f32;
        let (x, y) = (table[below], table[below + 1]);
        let seen = Complex { re: x.re + (y.re - x.re) * t, im: x.im + (y.im - x.im) * t };
        sum += 2.0 * (power * seen).re;
    }
    (1.0 - front * sum).clamp(0.0, 1.0)
}

/// Entries of the transform for each micrometre of path difference, and their number: beyond 10 µm fringes are finer
/// than the eye tells.
const PER_MICROMETRE: f32 = 128.0;
const ENTRIES: usize = 1281;

/// ∫ response(λ)·e^{2πi·OPD/λ} dλ for red, green and blue, over the path difference.
fn transform() -> &'static [Vec<Complex>; 3] {
    static TABLE: OnceLock<[Vec<Complex>; 3]> = OnceLock::new();
    TABLE.get_or_init(|| {
        let mut table =
            [vec![Complex::ZERO; ENTRIES], vec![Complex::ZERO; ENTRIES], vec![Complex::ZERO; ENTRIES]];
        for (i, step) in spectrum::steps().iter().enumerate() {
            let turn = std::f64::consts::TAU * 1000.0
                / (f64::from(spectrum::middle_nm(i)) * f64::from(PER_MICROMETRE));
            // Powers of one step's phase by multiplication, in double precision for the length of the chain.
            let (sin, cos) = (libm::sin(turn), libm::cos(turn));
            let (mut re, mut im) = (1.0_f64, 0.0_f64);
            for entry in 0..ENTRIES {
                for (channel, share) in table.iter_mut().zip(step.share.to_array()) {
                    channel[entry].re += share * re as f32;
                    channel[entry].im += share * im as f32;
                }
                (re, im) = (re * cos - im * sin, re * sin + im * cos);
            }
        }
        table
    })
}

/// As much of complex numbers as films need.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Complex {
    re: f32,
    im: f32,
}

impl Complex {
    const ZERO: Self = Self { re: 0.0, im: 0.0 };

    fn norm2(self) -> f32 {
        self.re * self.re + self.im * self.im
    }

    /// The root with a real part that is not negative and the imaginary part's sign.
    fn sqrt(self) -> Self {
        let length = self.norm2().sqrt();
        let re = (0.5 * (length + self.re)).max(0.0).sqrt();
        let im = (0.5 * (length - self.re)).max(0.0).sqrt();
        Self { re, im: if self.im < 0.0 { -im } else { im } }
    }
}

impl std::ops::Mul for Complex {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
}

impl std::ops::Mul<f32> for Complex {
    type Output = Self;
    fn mul(self, s: f32) -> Self {
        Self { re: self.re * s, im: self.im * s }
    }
}

impl std::ops::Div for Complex {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let length2 = o.norm2().max(f32::MIN_POSITIVE);
        self * Self { re: o.re / length2, im: -o.im / length2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fresnel;

    fn glass(n: f32) -> Below {
        Below { n: Rgb::splat(n), k: Rgb::BLACK }
    }

    #[test]
    fn a_quarter_wave_of_magnesium_fluoride_takes_glass_to_1_41_percent() {
        let film = Film { thickness: 0.55 / (4.0 * 1.38), eta: 1.38 };
        let r = film.reflectance_at(1.0, &glass(1.5), 0.55);
        assert!((r - 0.0141).abs() < 5e-5, "{r}");
        let half = Film { thickness: 0.55 / (2.0 * 1.38), eta: 1.38 };
        assert!((half.reflectance_at(1.0, &glass(1.5), 0.55) - 0.04).abs() < 1e-5);
    }

    #[test]
    fn a_film_of_no_thickness_is_not_there() {
        let film = Film { thickness: 0.0, eta: 1.33 };
        let metal = Below { n: Rgb::new(0.2, 0.4, 1.4), k: Rgb::new(4.0, 2.4, 1.6) };
        for i in 1..=20_u8 {
            let cos = f32::from(i) / 20.0;
            let bare = fresnel::dielectric(cos, 1.5);
            assert!((film.reflectance(cos, &glass(1.5)).g - bare).abs() < 2e-3, "{cos}");
            let (with, without) = (film.reflectance(cos, &metal), fresnel::conductor(cos, metal.n, metal.k));
            for (a, b) in with.to_array().into_iter().zip(without.to_array()) {
                assert!((a - b).abs() < 4e-3, "{cos}: {a} {b}");
            }
        }
    }

    #[test]
    fn the_series_is_the_sum_over_the_spectrum() {
        for (eta, below) in
            [(1.33, glass(1.0)), (1.38, glass(1.5)), (2.2, Below { n: Rgb::splat(0.2), k: Rgb::splat(3.0) })]
        {
            for thickness in [0.1_f32, 0.35, 0.8] {
                for cos in [1.0_f32, 0.6, 0.2] {
                    let film = Film { thickness, eta };
                    let mut truth = [0.0_f64; 3];
                    for (i, step) in spectrum::steps().iter().enumerate() {
                        let r = film.reflectance_at(cos, &below, spectrum::middle_nm(i) / 1000.0);
                        for (sum, share) in truth.iter_mut().zip(step.share.to_array()) {
                            *sum += f64::from(share * r);
                        }
                    }
                    let ours = film.reflectance(cos, &below).to_array();
                    for (t, o) in truth.into_iter().zip(ours) {
                        let t = t.clamp(0.0, 1.0);
                        assert!((t - f64::from(o)).abs() < 5e-3, "{eta} {thickness} {cos}: {t} {o}");
                    }
                }
            }
        }
    }

    #[test]
    fn soap_has_colours_and_a_thick_film_has_none() {
        let soap = Film { thickness: 0.32, eta: 1.33 }.reflectance(1.0, &glass(1.0)).to_array();
        let (least, most) =
            (soap.iter().copied().fold(1.0, f32::min), soap.iter().copied().fold(0.0, f32::max));
        assert!(most > 3.0 * least, "{soap:?}");
        let thick = Film { thickness: 30.0, eta: 1.33 }.reflectance(1.0, &glass(1.0)).to_array();
        // Two faces without interference: 2F/(1 + F).
        let f = fresnel::dielectric(1.0, 1.33);
        assert!(thick.iter().all(|c| (c - 2.0 * f / (1.0 + f)).abs() < 1e-4), "{thick:?}");
    }

    #[test]
    fn total_reflection_stays_total() {
        let film = Film { thickness: 0.3, eta: 1.38 / 1.5 };
        for i in 0..=30_u8 {
            let cos = f32::from(i) / 50.0;
            let r = film.reflectance(cos, &glass(1.0 / 1.5));
            assert!(r.to_array().iter().all(|c| *c > 0.998), "{cos}: {r:?}");
        }
    }
}
