//! How much a smooth surface reflects: dielectrics, measured metals, and metals known only by their colour.
//!
//! Cosines are those of the angle between the ray and the normal, 0 to 1. An `eta` here is the index beyond the surface
//! over the index on the ray's own side.

use vitrine_math::Rgb;

/// The reflectance at normal incidence, F₀ = ((n−1)/(n+1))². `eta` is the index inside over the index outside.
#[must_use]
pub fn normal_reflectance(eta: f32) -> f32 {
    let r = (eta - 1.0) / (eta + 1.0);
    r * r
}

/// The reflectance of a dielectric for unpolarised light; 1 at total internal reflection.
#[inline]
#[must_use]
pub fn dielectric(cos_i: f32, eta: f32) -> f32 {
    let (s, p) = dielectric_sp(cos_i, eta);
    0.5 * (s + p)
}

/// The reflectances of a dielectric for light polarised across (s) and in (p) the plane of incidence; both 1 at total
/// internal reflection.
#[inline]
#[must_use]
pub fn dielectric_sp(cos_i: f32, eta: f32) -> (f32, f32) {
    // Snell: sin²θt = sin²θi / η²
    let sin2_t = (1.0 - cos_i * cos_i).max(0.0) / (eta * eta);
    if sin2_t >= 1.0 {
        return (1.0, 1.0);
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    // Fresnel: r_s = (cos θi − η cos θt)/(cos θi + η cos θt), r_p = (η cos θi − cos θt)/(η cos θi + cos θt)
    let s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    let p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    (s * s, p * p)
}

/// The index that turns `eta` into one whose reflectance at normal incidence is `weight` times as large.
///
///   ε = √weight·(η − 1)/(η + 1), η' = (1 + ε)/(1 − ε)   (OpenPBR 1.1, "Dielectric base", specular_weight)
#[inline]
#[must_use]
pub fn weighted_eta(eta: f32, weight: f32) -> f32 {
    if weight == 1.0 {
        return eta;
    }
    let e = (weight.max(0.0).sqrt() * (eta - 1.0) / (eta + 1.0)).clamp(-0.999, 0.999);
    (1.0 + e) / (1.0 - e)
}

/// The reflectance of a metal of index n + ik, for unpolarised light. `n` and `k` are relative to the index on the ray's
/// side.
#[inline]
#[must_use]
pub fn conductor(cos_i: f32, n: Rgb, k: Rgb) -> Rgb {
    Rgb::new(
        conductor_channel(cos_i, n.r, k.r),
        conductor_channel(cos_i, n.g, k.g),
        conductor_channel(cos_i, n.b, k.b),
    )
}

/// One channel of [`conductor`]: Fresnel's equations with a complex index (Born and Wolf, "Principles of Optics", 7th
/// ed., section 14.2).
#[inline]
fn conductor_channel(cos_i: f32, n: f32, k: f32) -> f32 {
    let cos2 = cos_i * cos_i;
    let sin2 = (1.0 - cos2).max(0.0);
    // a² + b² = |η² − sin²θ| and a² − b² = Re(η² − sin²θ)
    let difference = n * n - k * k - sin2;
    let sum = (difference * difference + 4.0 * n * n * k * k).sqrt();
    let a = (0.5 * (sum + difference)).max(0.0).sqrt();
    // R_s = (a² + b² + cos²θ − 2a cos θ)/(a² + b² + cos²θ + 2a cos θ)
    let even = sum + cos2;
    let odd = 2.0 * a * cos_i;
    let s = (even - odd) / (even + odd);
    // R_p = R_s·(cos²θ(a² + b²) + sin⁴θ − 2a cos θ sin²θ)/(… + …)
    let even = cos2 * sum + sin2 * sin2;
    let odd = odd * sin2;
    let sum = even + odd;
    let p = if sum > 0.0 { s * (even - odd) / sum } else { s };
    0.5 * (s + p)
}

/// A metal known by its colours: `f0` facing it, and `tint` times Schlick's value at 82°.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColoredMetal {
    f0: Rgb,
    /// How deep the dip near 82° is, for each channel.
    dip: Rgb,
}

impl ColoredMetal {
    /// `f0` and `tint` are 0 to 1.
    #[must_use]
    pub fn new(f0: Rgb, tint: Rgb) -> Self {
        if tint == Rgb::WHITE {
            return Self { f0, dip: Rgb::BLACK };
        }
        // (1 − tint)·F_Schlick(μ̄)/(μ̄(1 − μ̄)⁶), μ̄ = 1/7
        const COS_82: f32 = 1.0 / 7.0;
        let rest2 = (1.0 - COS_82) * (1.0 - COS_82);
        let bottom = COS_82 * rest2 * rest2 * rest2;
        let dip = |f0: f32, tint: f32| (1.0 - tint) * (f0 + (1.0 - f0) * fifth(1.0 - COS_82)) / bottom;
        Self { f0, dip: Rgb::new(dip(f0.r, tint.r), dip(f0.g, tint.g), dip(f0.b, tint.b)) }
    }

    /// What it reflects.
    ///
    ///   F(μ) = F₀ + (1 − F₀)(1 − μ)⁵ − dip·μ(1 − μ)⁶   (the "F82-tint" of Kutz, Hašan and Edmondson, "Novel aspects of
    ///   the Adobe Standard Material", 2021)
    #[inline]
    #[must_use]
    pub fn reflectance(&self, cos_i: f32) -> Rgb {
        let rest = (1.0 - cos_i).max(0.0);
        let p5 = fifth(rest);
        let p6 = cos_i * p5 * rest;
        let channel = |f0: f32, dip: f32| (f0 + (1.0 - f0) * p5 - dip * p6).max(0.0);
        Rgb::new(
            channel(self.f0.r, self.dip.r),
            channel(self.f0.g, self.dip.g),
            channel(self.f0.b, self.dip.b),
        )
    }

    /// The mean over a hemisphere of even light, 2∫F(μ)μ dμ = F₀ + (1 − F₀)/21 − dip/126.
    #[must_use]
    pub fn average(&self) -> Rgb {
        let channel = |f0: f32, dip: f32| (f0 + (1.0 - f0) / 21.0 - dip / 126.0).max(0.0);
        Rgb::new(
            channel(self.f0.r, self.dip.r),
            channel(self.f0.g, self.dip.g),
            channel(self.f0.b, self.dip.b),
        )
    }
}

#[inline]
fn fifth(x: f32) -> f32 {
    let x2 = x * x;
    x2 * x2 * x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2∫ c·f(c) dc by the midpoint rule.
    fn diffuse(f: impl Fn(f32) -> f32) -> f64 {
        const N: u16 = 20_000;
        (0..N)
            .map(|i| (f64::from(i) + 0.5) / f64::from(N))
            .map(|c| 2.0 * c * f64::from(f(c as f32)))
            .sum::<f64>()
            / f64::from(N)
    }

    #[test]
    fn glass_and_water_have_their_textbook_values() {
        assert!((normal_reflectance(1.5) - 0.04).abs() < 1e-7);
        assert!((normal_reflectance(1.33) - 0.02006).abs() < 1e-5);
        assert!((dielectric(1.0, 1.5) - 0.04).abs() < 1e-7);
        assert!((dielectric(1.0, 1.33) - 0.02006).abs() < 1e-5);
    }

    #[test]
    fn even_light_is_reflected_as_walsh_found() {
        assert!((diffuse(|c| dielectric(c, 1.5)) - 0.091_778).abs() < 2e-6);
        assert!((diffuse(|c| dielectric(c, 1.33)) - 0.065_931).abs() < 2e-6);
        assert!((diffuse(|c| dielectric(c, 1.0 / 1.5)) - 0.596_346).abs() < 2e-5);
    }

    #[test]
    fn brewsters_angle_reflects_no_p_light() {
        let cos = (1.5_f32).atan().cos();
        let (s, p) = dielectric_sp(cos, 1.5);
        assert!(p < 1e-10, "{p}");
        assert!((s - 0.147_93).abs() < 1e-5, "{s}");
    }

    #[test]
    fn reflection_is_total_beyond_the_critical_angle() {
        let cos = |deg: f32| deg.to_radians().cos();
        assert!(dielectric(cos(41.80), 1.0 / 1.5) < 1.0);
        assert_eq!(dielectric(cos(41.82), 1.0 / 1.5), 1.0);
        assert_eq!(dielectric(0.0, 1.5), 1.0);
    }

    #[test]
    fn both_sides_reflect_the_same_along_one_path() {
        for i in 1..=20_u8 {
            let cos = f32::from(i) / 20.0;
            let cos_t = (1.0 - (1.0 - cos * cos) / 2.25).sqrt();
            assert!((dielectric(cos, 1.5) - dielectric(cos_t, 1.0 / 1.5)).abs() < 1e-5);
        }
    }

    #[test]
    fn a_metal_that_absorbs_nothing_is_a_dielectric() {
        for i in 0..=20_u8 {
            let cos = f32::from(i) / 20.0;
            let metal = conductor(cos, Rgb::splat(1.5), Rgb::BLACK).g;
            assert!((metal - dielectric(cos, 1.5)).abs() < 1e-5, "{cos}: {metal}");
        }
    }

    #[test]
    fn a_metal_faces_us_with_its_formula() {
        // ((n−1)² + k²)/((n+1)² + k²)
        let f = conductor(1.0, Rgb::splat(0.2), Rgb::splat(3.0)).r;
        assert!((f - (0.64 + 9.0) / (1.44 + 9.0)).abs() < 1e-6);
    }

    #[test]
    fn a_colored_metal_has_its_colours_at_0_and_82_degrees() {
        let f0 = Rgb::new(0.9, 0.6, 0.3);
        let plain = ColoredMetal::new(f0, Rgb::WHITE);
        let tinted = ColoredMetal::new(f0, Rgb::new(1.0, 0.8, 0.5));
        assert_eq!(tinted.reflectance(1.0), f0);
        assert_eq!(tinted.reflectance(0.0), Rgb::WHITE);
        let (a, b) = (plain.reflectance(1.0 / 7.0), tinted.reflectance(1.0 / 7.0));
        assert!((b.g / a.g - 0.8).abs() < 1e-5 && (b.b / a.b - 0.5).abs() < 1e-5 && b.r == a.r);
        assert!((diffuse(|c| tinted.reflectance(c).b) - f64::from(tinted.average().b)).abs() < 1e-5);
    }

    #[test]
    fn the_weight_scales_what_is_reflected_facing_the_surface() {
        for eta in [1.5_f32, 1.0 / 1.5, 2.4] {
            let f = normal_reflectance(weighted_eta(eta, 0.25));
            assert!((f - 0.25 * normal_reflectance(eta)).abs() < 1e-6);
        }
        assert_eq!(weighted_eta(1.5, 0.0), 1.0);
    }
}
