//! What a material is at one point, once its textures have been looked up.

use crate::microfacet::Ggx;
use vitrine_math::Rgb;

/// A surface at a point, in OpenPBR's terms. Colours and weights are 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The base's colour, its weight already in: of the diffuse ground, and of metal facing us.
    pub base_color: Rgb,
    /// How dusty the diffuse ground looks: 0 is Lambert's.
    pub diffuse_roughness: f32,
    /// How much of the base is metal.
    pub metalness: f32,
    /// The index of refraction n and absorption k of a measured metal, in place of the base's colour.
    pub metal: Option<(Rgb, Rgb)>,
    /// How much the base's surface reflects: for dielectrics the factor of the reflectance facing us.
    pub specular_weight: f32,
    /// The colour of what dielectrics reflect, and of what metals reflect near 82°.
    pub specular_color: Rgb,
    /// How rough the surface is; its square is the width α of the distribution of facets. Below about 0.03 it is smooth.
    pub roughness: f32,
    /// The index beyond the surface over the index here, on the side of `wo`. Of a thin wall: the index of its inside.
    pub eta: f32,
    /// How much of the dielectric is clear.
    pub transmission: f32,
    /// The colour that crossing light takes on at the surface; white where the inside absorbs.
    pub transmission_tint: Rgb,
    /// Whether it is a thin wall, with both its faces, in air.
    pub thin_walled: bool,
    /// What the inside of a thin wall leaves of light that crosses it straight.
    pub thin_absorption: Rgb,
    /// How much of the surface is coated.
    pub coat_weight: f32,
    /// What the coat leaves of white light that goes straight in and out again.
    pub coat_color: Rgb,
    /// How rough the coat is, as `roughness`.
    pub coat_roughness: f32,
    /// The coat's index, against air.
    pub coat_ior: f32,
    /// How much of the surface has a thin film.
    pub thin_film_weight: f32,
    /// The film's thickness, in micrometres.
    pub thin_film_thickness: f32,
    /// The film's index, against air. A film of the same index as the thin wall that it is on is the wall: soap.
    pub thin_film_ior: f32,
}

impl Default for Surface {
    /// OpenPBR's defaults.
    fn default() -> Self {
        Self {
            base_color: Rgb::splat(0.8),
            diffuse_roughness: 0.0,
            metalness: 0.0,
            metal: None,
            specular_weight: 1.0,
            specular_color: Rgb::WHITE,
            roughness: 0.3,
            eta: 1.5,
            transmission: 0.0,
            transmission_tint: Rgb::WHITE,
            thin_walled: false,
            thin_absorption: Rgb::WHITE,
            coat_weight: 0.0,
            coat_color: Rgb::WHITE,
            coat_roughness: 0.0,
            coat_ior: 1.6,
            thin_film_weight: 0.0,
            thin_film_thickness: 0.5,
            thin_film_ior: 1.4,
        }
    }
}

impl Surface {
    /// Nothing but a Lambertian ground.
    #[inline]
    pub(super) fn is_plainly_matte(&self) -> bool {
        self.metalness <= 0.0
            && self.transmission <= 0.0
            && self.specular_weight <= 0.0
            && self.coat_weight <= 0.0
            && self.thin_film_weight <= 0.0
            && self.diffuse_roughness <= 0.0
    }

    /// Nothing but smooth, solid glass without a colour at its surface.
    #[inline]
    pub(super) fn is_plain_glass(&self) -> bool {
        self.transmission >= 1.0
            && self.metalness <= 0.0
            && self.roughness * self.roughness < Ggx::SMOOTH
            && !self.thin_walled
            && self.coat_weight <= 0.0
            && self.thin_film_weight <= 0.0
            && self.specular_weight == 1.0
            && self.specular_color == Rgb::WHITE
            && self.transmission_tint == Rgb::WHITE
    }

    /// Every part is delta.
    pub(super) fn is_smooth(&self) -> bool {
        self.diffuse_share() <= 0.0
            && self.facets().is_none()
            && (self.coat_weight <= 0.0 || Ggx::from_roughness(self.coat_roughness).is_none())
    }

    /// How much of the base is diffuse ground.
    pub(super) fn diffuse_share(&self) -> f32 {
        (1.0 - self.metalness) * (1.0 - self.transmission)
    }

    /// How much of the base is clear.
    pub(super) fn clear_share(&self) -> f32 {
        (1.0 - self.metalness) * self.transmission
    }

    /// The base's facets; None where it is smooth, or where its roughness cannot show because nothing bends.
    pub(super) fn facets(&self) -> Option<Ggx> {
        let is_matched = !self.thin_walled && self.clear_share() > 0.0 && (self.eta - 1.0).abs() < 1e-3;
        // A surface that reflects nothing over an opaque ground is not there.
        let is_bare = self.specular_weight <= 0.0
            && self.metalness <= 0.0
            && self.transmission <= 0.0
            && self.thin_film_weight <= 0.0;
        if is_matched || is_bare { None } else { Ggx::from_roughness(self.roughness) }
    }
}
