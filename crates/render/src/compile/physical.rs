//! Materials as the photoreal renderer sees them: numbers at hand, textures by index.

use super::geometry::{Form, Primitive};
use std::sync::Arc;
use vitrine_math::Rgb;
use vitrine_optics::absorption;
use vitrine_optics::dispersion::Cauchy;
use vitrine_scene::PhysicalMaterial;

/// The textures beside the colour's, by what they scale.
#[derive(Clone, Copy, Debug, Default)]
pub struct TextureSet {
    /// In place of the base colour and of the colour of what passes.
    pub color: Option<u32>,
    /// Of `base_weight`.
    pub base_weight: Option<u32>,
    /// Of `base_metalness`.
    pub metalness: Option<u32>,
    /// Of `specular_roughness`.
    pub roughness: Option<u32>,
    /// Of `specular_weight`.
    pub specular: Option<u32>,
    /// Of `transmission_weight`.
    pub transmission: Option<u32>,
    /// Of `coat_weight`.
    pub coat: Option<u32>,
    /// Of the emission's colour.
    pub emission: Option<u32>,
    /// A tangent-space normal map.
    pub normal_map: Option<u32>,
    /// A height map.
    pub bump_map: Option<u32>,
}

impl TextureSet {
    /// Whether there is none.
    pub const fn is_empty(&self) -> bool {
        self.color.is_none()
            && self.base_weight.is_none()
            && self.metalness.is_none()
            && self.roughness.is_none()
            && self.specular.is_none()
            && self.transmission.is_none()
            && self.coat.is_none()
            && self.emission.is_none()
            && !self.bends_normals()
    }

    /// Whether one changes the normals.
    pub const fn bends_normals(&self) -> bool {
        self.normal_map.is_some() || self.bump_map.is_some()
    }
}

/// A material with all that follows from its numbers.
#[derive(Clone, Debug)]
pub struct CompiledPhysical {
    /// The numbers.
    pub numbers: Arc<PhysicalMaterial>,
    /// The textures.
    pub textures: TextureSet,
    /// The surface where no texture changes it.
    pub surface: vitrine_optics::bsdf::Surface,
    /// The inside.
    pub substance: Substance,
    /// Radiance that leaves every point of it.
    pub emission: Rgb,
}

/// What a solid is filled with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Substance {
    /// The index of refraction by wavelength.
    pub index: Cauchy,
    /// The index in the middle of the spectrum.
    pub index_d: f32,
    /// Whether the index depends on the wavelength.
    pub is_dispersive: bool,
    /// How much is absorbed, 1/m.
    pub absorption: Rgb,
    /// How much is scattered, 1/m.
    pub scattering: Rgb,
    /// Henyey and Greenstein's asymmetry.
    pub anisotropy: f32,
}

impl Substance {
    /// From a material's numbers.
    pub fn new(m: &PhysicalMaterial) -> Self {
        let is_dispersive = m.transmission_dispersion_scale > 0.0 && m.specular_ior > 1.0;
        let index = if is_dispersive {
            Cauchy::from_abbe(m.specular_ior, m.transmission_dispersion_abbe_number / m.transmission_dispersion_scale)
        } else {
            Cauchy { a: m.specular_ior, b: 0.0 }
        };
        let (absorption, scattering) = if m.transmission_depth > 0.0 {
            // OpenPBR: the colour states extinction, of which the scatter colour is the scattered part.
            let extinction = absorption::coefficient(m.transmission_color, m.transmission_depth);
            let scattering = m.transmission_scatter / m.transmission_depth;
            let difference = (extinction - scattering).to_array();
            // Where more is scattered than the colour takes away, all channels get as much absorption as none lacks.
            let least = difference.iter().fold(0.0_f32, |a, &b| a.min(b));
            (Rgb::from(difference.map(|v| v - least)), scattering)
        } else {
            (Rgb::BLACK, Rgb::BLACK)
        };
        Self {
            index,
            index_d: m.specular_ior,
            is_dispersive,
            absorption,
            scattering,
            anisotropy: m.transmission_scatter_anisotropy,
        }
    }

    /// Its index at a wavelength in nanometres; 0: in the middle of the spectrum.
    #[inline]
    pub fn index_at(&self, wavelength: f32) -> f32 {
        if wavelength > 0.0 && self.is_dispersive { self.index.at(wavelength) } else { self.index_d }
    }

    /// Whether light fades or scatters on its way through.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.absorption == Rgb::BLACK && self.scattering == Rgb::BLACK
    }

    /// Whether it is milky.
    #[inline]
    pub fn scatters(&self) -> bool {
        self.scattering != Rgb::BLACK
    }
}

/// Whether a thing of that material is a thin sheet: what has no inside is one unless the material says otherwise.
pub fn is_thin(material: &PhysicalMaterial, primitive: &Primitive) -> bool {
    material.geometry_thin_walled.unwrap_or(match &primitive.form {
        Form::Sphere { .. } | Form::Ellipsoid { .. } | Form::Box { .. } => false,
        Form::Plane { .. } | Form::Disc { .. } | Form::Triangle { .. } => true,
        Form::Mesh { mesh, .. } => !mesh.is_closed(),
    })
}
