//! Polarisation as far as it matters: inside a stack of parallel panes, or a ball, light keeps its plane of incidence, and there its two
//! parts go their own ways. Two shares tell all; averaging them at each surface instead makes a stack too dark.

use vitrine_math::Vec3;
use vitrine_optics::fresnel;

/// Planes of incidence whose normals' cosine is above this are the same.
const SAME: f32 = 0.999_99;

/// How much of the light is polarised across its plane of incidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polarisation {
    /// The unit normal of the plane of incidence; zero where there was none yet.
    axis: Vec3,
    /// The share across the plane (s); the rest lies in it (p).
    s: f32,
}

impl Default for Polarisation {
    fn default() -> Self {
        Self { axis: Vec3::ZERO, s: 0.5 }
    }
}

/// How light parts at a smooth surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parting {
    /// The part that is reflected.
    pub reflectance: f32,
    /// The state of what is reflected.
    pub reflected: Polarisation,
    /// The state of what passes.
    pub passed: Polarisation,
}

impl Polarisation {
    /// How light of this state parts at a smooth surface with the unit normal `n` on its side. `wo` points back along the light,
    /// `eta` is the index beyond over the index here.
    #[inline]
    pub fn part(&self, wo: Vec3, n: Vec3, eta: f32) -> Parting {
        let cos = wo.dot(n).clamp(0.0, 1.0);
        let (rs, rp) = fresnel::dielectric_sp(cos, eta);
        let across = wo.cross(n);
        let length = across.length();
        // Straight on there is no plane, and both parts do the same.
        let (axis, s) = if length < 1e-4 {
            (self.axis, self.s)
        } else {
            let axis = across / length;
            (axis, if axis.dot(self.axis).abs() > SAME { self.s } else { 0.5 })
        };
        let p = 1.0 - s;
        let reflectance = s * rs + p * rp;
        let passes = 1.0 - reflectance;
        let share = |part: f32, all: f32| if all > 0.0 { part / all } else { 0.5 };
        Parting {
            reflectance,
            reflected: Self { axis, s: share(s * rs, reflectance) },
            passed: Self { axis, s: share(s * (1.0 - rs), passes) },
        }
    }

    /// The same where polarisations are averaged at each surface.
    #[inline]
    pub fn part_unpolarised(wo: Vec3, n: Vec3, eta: f32) -> Parting {
        Parting { reflected: Self::default(), passed: Self::default(), ..Self::default().part(wo, n, eta) }
    }
}
