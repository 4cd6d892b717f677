//! The course work's lighting model: Phong's, with Lambert's as the case k_s = 0.

use crate::refraction::reflect;
use vitrine_math::{Rgb, Vec3, pow_unit};

/// What the model needs to know of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhongSurface {
    /// The colour, linear. It tints what is scattered, not the highlight, which keeps the light's colour.
    pub color: Rgb,
    /// k_d, 0 to 1.
    pub diffuse: f32,
    /// k_s, 0 to 1.
    pub specular: f32,
    /// s, 1 or more.
    pub shininess: f32,
}

/// How one light of intensity 1 is seen: the factors of the surface's colour and of white.
///
/// `n`, `wi` (to the light) and `wo` (to the viewer) are of unit length and point away from the surface. A light behind
/// the surface gives neither:
///
///   scattered k_d·max(0, ⟨N, L⟩), highlight k_s·max(0, ⟨R, V⟩)^s, R = 2N⟨N, L⟩ − L
///
/// (course work, sections 2.4 and 2.5; Phong, CACM 18(6), 1975).
#[inline(always)]
#[must_use]
pub fn phong_light(surface: &PhongSurface, n: Vec3, wi: Vec3, wo: Vec3) -> (f32, f32) {
    let cos_l = n.dot(wi);
    if cos_l <= 0.0 {
        return (0.0, 0.0);
    }
    let scattered = surface.diffuse * cos_l;
    if surface.specular <= 0.0 {
        return (scattered, 0.0);
    }
    let cos_r = reflect(wi, n).dot(wo).min(1.0);
    let highlight = if cos_r > 0.0 { surface.specular * pow_unit(cos_r, surface.shininess) } else { 0.0 };
    (scattered, highlight)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHINY: PhongSurface =
        PhongSurface { color: Rgb::WHITE, diffuse: 0.8, specular: 0.5, shininess: 10.0 };

    fn at_angle_deg(angle: f32) -> Vec3 {
        let (s, c) = angle.to_radians().sin_cos();
        Vec3::new(s, c, 0.0)
    }

    /// C9: I = k_d·⟨N, L⟩ + k_s·⟨R, V⟩^s
    #[test]
    fn c9_phong_is_the_formula() {
        for (light, eye) in [(0.0_f32, 0.0_f32), (30.0, -30.0), (30.0, -10.0), (70.0, 20.0)] {
            let (d, s) = phong_light(&SHINY, Vec3::Y, at_angle_deg(light), at_angle_deg(eye));
            let cos_r = (light + eye).to_radians().cos().max(0.0);
            assert!((d - 0.8 * light.to_radians().cos()).abs() < 1e-6);
            assert!((s - 0.5 * cos_r.powi(10)).abs() < 1e-5, "{light}° {eye}°: {s}");
        }
    }

    #[test]
    fn c9_both_terms_are_clamped() {
        assert_eq!(phong_light(&SHINY, Vec3::Y, at_angle_deg(100.0), at_angle_deg(-80.0)), (0.0, 0.0));
        let (d, s) = phong_light(&SHINY, Vec3::Y, at_angle_deg(60.0), at_angle_deg(60.0));
        assert!(d > 0.0 && s == 0.0, "the mirror direction is more than 90° from the eye");
    }

    #[test]
    fn c9_lambert_is_phong_without_highlight() {
        let matte = PhongSurface { specular: 0.0, ..SHINY };
        let (d, s) = phong_light(&matte, Vec3::Y, at_angle_deg(40.0), at_angle_deg(-40.0));
        assert_eq!(s, 0.0);
        assert!((d - 0.8 * 40.0_f32.to_radians().cos()).abs() < 1e-6);
    }
}
