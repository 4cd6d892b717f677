//! Materials as the photoreal renderer sees them: numbers at hand, textures by index.

use super::geometry::{Form, Primitive};
use super::limits::dimmed;
use std::sync::Arc;
use vitrine_math::Rgb;
use vitrine_optics::absorption;
use vitrine_optics::bsdf::{Bsdf, Surface};
use vitrine_optics::dispersion::Cauchy;
use vitrine_scene::{Material, Metal, PhysicalMaterial};

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

    /// The textures of a material, by their names.
    ///
    /// # Errors
    /// Those of `find`.
    pub fn find<E>(
        material: &Material,
        find: impl Fn(&Option<String>) -> Result<Option<usize>, E>,
    ) -> Result<Self, E> {
        let find = |name: &Option<String>| Ok(find(name)?.map(|t| t as u32));
        Ok(Self {
            color: find(&material.texture)?,
            base_weight: find(&material.base_weight_texture)?,
            metalness: find(&material.metalness_texture)?,
            roughness: find(&material.roughness_texture)?,
            specular: find(&material.specular_texture)?,
            transmission: find(&material.transmission_texture)?,
            coat: find(&material.coat_texture)?,
            emission: find(&material.emission_texture)?,
            normal_map: find(&material.normal_map)?,
            bump_map: find(&material.bump_map)?,
        })
    }

    /// Whether clear glass stays the same everywhere.
    pub const fn leaves_glass_clear(&self) -> bool {
        self.color.is_none()
            && self.metalness.is_none()
            && self.roughness.is_none()
            && self.specular.is_none()
            && self.transmission.is_none()
            && self.coat.is_none()
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
    pub surface: Surface,
    /// The inside.
    pub substance: Substance,
    /// Radiance that leaves every point of it.
    pub emission: Rgb,
    /// Whether its surface is that of clear glass or water: smooth, the same everywhere, and all that is not reflected passes.
    pub is_clear: bool,
    /// Whether its surface is that of a mirror: polished bare metal, the same everywhere.
    pub is_mirror: bool,
}

/// Surfaces of less roughness are smooth.
const SMOOTH: f32 = 0.03;

impl CompiledPhysical {
    /// From a material and its textures.
    pub fn new(material: &Material, textures: TextureSet) -> Self {
        let numbers = material.physical();
        let passes_all = numbers.transmission_weight >= 1.0
            && numbers.base_metalness == 0.0
            && numbers.specular_weight >= 1.0
            && numbers.specular_color == Rgb::WHITE;
        let is_bare = numbers.coat_weight == 0.0 && numbers.thin_film_weight == 0.0;
        let is_clear =
            passes_all && is_bare && numbers.specular_roughness < SMOOTH && textures.leaves_glass_clear();
        let is_mirror = numbers.base_metalness >= 1.0
            && is_bare
            && numbers.specular_roughness < SMOOTH
            && numbers.emission_luminance == 0.0
            && textures.is_empty();
        Self {
            surface: surface_of(&numbers),
            substance: Substance::new(&numbers),
            emission: dimmed(numbers.emission_color * numbers.emission_luminance),
            is_clear,
            is_mirror,
            textures,
            numbers: Arc::new(numbers),
        }
    }

    /// Whether light passes it at all.
    pub fn is_transmissive(&self) -> bool {
        self.numbers.transmission_weight > 0.0
    }

    /// Whether a thin thing of it passes light straight on.
    pub fn is_sheet(&self) -> bool {
        self.is_transmissive() && self.numbers.specular_roughness < SMOOTH && self.textures.is_empty()
    }

    /// The share of light that passes a thin sheet of it straight on; `cos` is that between the way and the normal.
    pub fn passed_sheet(&self, cos: f32) -> Rgb {
        let thin_absorption = self.surface.transmission_tint;
        let surface =
            Surface { thin_walled: true, thin_absorption, transmission_tint: Rgb::WHITE, ..self.surface };
        Bsdf::new(&surface, cos.abs()).passed_straight()
    }
}

fn surface_of(m: &PhysicalMaterial) -> Surface {
    let tint = if m.transmission_depth > 0.0 { Rgb::WHITE } else { m.transmission_color };
    Surface {
        base_color: m.base_color * m.base_weight,
        diffuse_roughness: m.base_diffuse_roughness,
        metalness: m.base_metalness,
        metal: m.metal.map(Metal::index),
        specular_weight: m.specular_weight,
        specular_color: m.specular_color,
        roughness: m.specular_roughness,
        eta: m.specular_ior,
        transmission: m.transmission_weight,
        transmission_tint: tint,
        thin_walled: false,
        thin_absorption: Rgb::WHITE,
        coat_weight: m.coat_weight,
        coat_color: m.coat_color,
        coat_roughness: m.coat_roughness,
        coat_ior: m.coat_ior,
        thin_film_weight: m.thin_film_weight,
        thin_film_thickness: m.thin_film_thickness,
        thin_film_ior: m.thin_film_ior,
    }
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
            Cauchy::from_abbe(
                m.specular_ior,
                m.transmission_dispersion_abbe_number / m.transmission_dispersion_scale,
            )
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

    /// What is left of light after so many metres through it.
    #[inline]
    pub fn transmittance(&self, length: f32) -> Rgb {
        if self.is_empty() {
            return Rgb::WHITE;
        }
        absorption::transmittance(self.absorption + self.scattering, length)
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
        Form::Mesh { mesh, accel, .. } => !accel.is_closed(|| mesh.is_closed()),
    })
}
