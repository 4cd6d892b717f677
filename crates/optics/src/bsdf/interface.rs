//! The base's surface as one facet sees it: what of the light along one angle is reflected and what crosses, with metal,
//! dielectric, film and thin wall mixed. No directions; those are made by the smooth and the rough lobes.

use super::conductor::Metal;
use super::thin_dielectric::Wall;
use super::{Surface, rest};
use crate::fresnel::{dielectric, weighted_eta};
use crate::thin_film::{Below, Film};
use vitrine_math::Rgb;

/// What becomes of light at one angle: shares of its energy, without the factor 1/η² of radiance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Split {
    pub(super) reflected: Rgb,
    pub(super) crossing: Rgb,
}

impl Split {
    pub(super) fn from_channels(r: (f32, f32), g: (f32, f32), b: (f32, f32)) -> Self {
        Self { reflected: Rgb::new(r.0, g.0, b.0), crossing: Rgb::new(r.1, g.1, b.1) }
    }
}

/// A film, and how much of the surface has it.
#[derive(Clone, Copy, Debug)]
struct Coverage {
    film: Film,
    weight: f32,
}

/// The base's surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interface {
    /// The index beyond over the index here: by it light bends.
    pub(super) eta: f32,
    /// The index beyond over that of what is directly above the base, as specular_weight lets it count.
    pub(super) eta_fresnel: f32,
    /// The index of what is directly above the base over the index here: the coat's, or 1.
    above: f32,
    metalness: f32,
    /// None where nothing is metal.
    metal: Option<Metal>,
    specular_weight: f32,
    specular_color: Rgb,
    /// How much of the dielectric is clear, and the colour it gives.
    transmission: f32,
    tint: Rgb,
    wall: Option<Wall>,
    film: Option<Coverage>,
}

impl Interface {
    pub(super) fn new(surface: &Surface) -> Self {
        let is_inside = surface.eta < 1.0 && !surface.thin_walled;
        // Where there is a coat, the base borders on it: above the base, or beyond it if we look from inside.
        let coat = 1.0 + surface.coat_weight * (surface.coat_ior - 1.0);
        let above = if is_inside || surface.thin_walled { 1.0 } else { coat };
        let air = if is_inside { surface.eta } else { 1.0 / above };
        let film = (surface.thin_film_weight > 0.0).then_some(Coverage {
            film: Film { thickness: surface.thin_film_thickness, eta: surface.thin_film_ior * air },
            weight: surface.thin_film_weight,
        });
        // A film that is itself the wall has air behind it.
        let is_soap =
            surface.thin_walled && film.is_some() && (surface.eta - surface.thin_film_ior).abs() < 0.05;
        let eta = if is_soap { 1.0 } else { surface.eta };
        let eta_base = if is_inside { eta * coat } else { eta / above };
        let eta_fresnel = weighted_eta(eta_base, surface.specular_weight);
        Self {
            eta,
            eta_fresnel,
            above,
            metalness: surface.metalness,
            metal: (surface.metalness > 0.0).then(|| Metal::new(surface, above)),
            specular_weight: surface.specular_weight,
            specular_color: surface.specular_color,
            transmission: surface.transmission,
            tint: surface.transmission_tint,
            wall: surface.thin_walled.then(|| Wall::new(eta, eta_fresnel, surface.thin_absorption)),
            film,
        }
    }

    /// Whether any light crosses.
    pub(super) fn is_clear(&self) -> bool {
        self.metalness < 1.0 && self.transmission > 0.0
    }

    /// Whether it is a wall with both its faces.
    pub(super) fn is_thin_walled(&self) -> bool {
        self.wall.is_some()
    }

    /// Whether it has a film, and so reflects in colours that the tables of albedos do not know.
    pub(super) fn has_film(&self) -> bool {
        self.film.is_some()
    }

    /// Whether a coat is above it.
    pub(super) fn is_coated(&self) -> bool {
        self.above != 1.0
    }

    /// What becomes of light at an angle with the cosine `cos`, 0 to 1, on the side of `wo`.
    #[inline]
    pub(super) fn split(&self, cos: f32) -> Split {
        let Some(metal) = &self.metal else {
            return self.dielectric(cos);
        };
        let metallic = self.metal_reflectance(metal, self.cos_above(cos)) * self.metalness;
        if self.metalness >= 1.0 {
            return Split { reflected: metallic, crossing: Rgb::BLACK };
        }
        let other = self.dielectric(cos);
        let share = 1.0 - self.metalness;
        Split { reflected: metallic + other.reflected * share, crossing: other.crossing * share }
    }

    /// The same of the dielectric part alone.
    #[inline]
    pub(super) fn dielectric(&self, cos: f32) -> Split {
        let face = self.face(self.cos_above(cos));
        if self.transmission <= 0.0 {
            return Split { reflected: face * self.specular_color, crossing: Rgb::BLACK };
        }
        let clear = self.clear(face, cos);
        let mixed = face * (1.0 - self.transmission) + clear.reflected * self.transmission;
        Split {
            reflected: mixed * self.specular_color,
            crossing: clear.crossing * self.tint * self.transmission,
        }
    }

    /// What the dielectric's outer face reflects, before its colour.
    #[inline]
    pub(super) fn face(&self, cos_above: f32) -> Rgb {
        let bare = Rgb::splat(self.bare_face(cos_above));
        match &self.film {
            None => bare,
            Some(on) => {
                let below = Below { n: Rgb::splat(self.eta_fresnel), k: Rgb::BLACK };
                bare.lerp(on.film.reflectance(cos_above, &below), on.weight)
            }
        }
    }

    /// The same without a film.
    #[inline]
    pub(super) fn bare_face(&self, cos_above: f32) -> f32 {
        dielectric(cos_above, self.eta_fresnel)
    }

    /// What the clear part does, given what its outer face reflects.
    #[inline]
    fn clear(&self, face: Rgb, cos: f32) -> Split {
        match &self.wall {
            Some(wall) if self.film.is_some() => wall.split_below(face, cos),
            Some(wall) => wall.split(cos),
            // Where specular_weight lets light through that cannot bend, it is reflected.
            None if 1.0 - cos * cos >= self.eta * self.eta => {
                Split { reflected: Rgb::WHITE, crossing: Rgb::BLACK }
            }
            None => Split { reflected: face, crossing: rest(face) },
        }
    }

    #[inline]
    fn metal_reflectance(&self, metal: &Metal, cos_above: f32) -> Rgb {
        let bare = metal.reflectance(cos_above);
        let seen = match &self.film {
            None => bare,
            Some(on) => bare.lerp(on.film.reflectance(cos_above, &metal.below()), on.weight),
        };
        seen * self.specular_weight
    }

    /// The mean of what the metal reflects of even light.
    pub(super) fn metal_average(&self) -> Rgb {
        self.metal.as_ref().map_or(Rgb::BLACK, Metal::average) * self.specular_weight
    }

    /// The cosine in what is above the base, by Snell's law.
    #[inline]
    pub(super) fn cos_above(&self, cos: f32) -> f32 {
        if self.above == 1.0 {
            return cos;
        }
        (1.0 - (1.0 - cos * cos).max(0.0) / (self.above * self.above)).max(0.0).sqrt()
    }
}
