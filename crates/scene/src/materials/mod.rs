//! What things are made of. One material has two sides, the course work's scales and physical parameters with OpenPBR's
//! names; what one side does not say is derived from the other ([`mod@derive`]).

pub mod derive;
mod metal;

pub use derive::{ClassicMaterial, PhysicalMaterial};
pub use metal::Metal;

use crate::{ListName, ParamKind, Range};
use vitrine_math::Rgb;

crate::params! {
    /// What a thing is made of. State as much as you like of either side; what is missing is derived or has its default.
    pub struct Material {
        @plain {
            /// Its name, unique among the materials.
            name: String = "material".to_owned();
        }
        /// Its colour. Classic scale.
        color: Option<Rgb> = None => ParamKind::Color, None;
        /// A texture in place of the colour.
        texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// How strongly it scatters light evenly (k_d). Classic scale, 0.8 where nothing is stated.
        diffuse: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How strong its highlights are (k_s). Classic scale, 0 where nothing is stated.
        specular: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How small its highlights are (the exponent s). Classic scale, 32 where nothing is stated.
        shininess: Option<f32> = None => ParamKind::Number(Range::from_to(1.0, 10_000.0)), None;
        /// How much of what it shows is a mirror image. Classic scale, 0 where nothing is stated.
        reflectivity: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How much of what lies behind shows through each surface. Classic scale, 0 where nothing is stated.
        transparency: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The index by which it bends light; 1 lets light go straight on. Classic scale, 1 where nothing is stated.
        refraction: Option<f32> = None => ParamKind::Number(Range::from_to(0.25, 4.0)), None;
        /// A metal by its measured index of refraction, in place of the base's colour; the base is then metal where base_metalness says nothing else.
        metal: Option<Metal> = None => ParamKind::Choice(Metal::WORDS), None;
        /// How much of the base there is. OpenPBR.
        base_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The base's colour. OpenPBR.
        base_color: Option<Rgb> = None => ParamKind::Color, None;
        /// How rough an even surface is in the small: 0 is smooth, 1 is clay or the moon. OpenPBR, 0 where nothing is stated.
        base_diffuse_roughness: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// 0 is plastic, glass or wood, 1 is metal. OpenPBR.
        base_metalness: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How much the surface reflects. OpenPBR.
        specular_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The colour of what the surface reflects; of metal, of its edges. OpenPBR, white where nothing is stated.
        specular_color: Option<Rgb> = None => ParamKind::Color, None;
        /// 0 is polished, 1 is dull. OpenPBR.
        specular_roughness: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The index of refraction. OpenPBR.
        specular_ior: Option<f32> = None => ParamKind::Number(Range::from_to(1.0, 4.0)), None;
        /// How much light passes: 1 is glass or water. OpenPBR.
        transmission_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The colour of what has passed, after transmission_depth if that is stated. OpenPBR.
        transmission_color: Option<Rgb> = None => ParamKind::Color, None;
        /// The way through the inside after which light has the transmission colour; 0 tints at the surface. OpenPBR.
        transmission_depth: Option<f32> = None => ParamKind::Number(Range::NOT_NEGATIVE), Metres;
        /// The colour of the light that the inside scatters, as milk does; black is clear. It is scattered within transmission_depth. OpenPBR.
        transmission_scatter: Option<Rgb> = None => ParamKind::Color, None;
        /// Where the inside scatters to: more than 0 is forwards, less is back, 0 is evenly all around. OpenPBR.
        transmission_scatter_anisotropy: Option<f32> = None => ParamKind::Number(Range::from_to(-0.99, 0.99)), None;
        /// How much of the splitting of light into its colours there is. OpenPBR, 1 where an Abbe number is stated, else 0.
        transmission_dispersion_scale: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How little glass splits light into its colours, its Abbe number: window glass 60, flint glass 30, diamond 55. OpenPBR, 20 where nothing is stated.
        transmission_dispersion_abbe_number: Option<f32> = None => ParamKind::Number(Range::from_to(9.0, 200.0)), None;
        /// How much of a clear coat of lacquer there is. OpenPBR, 0 where nothing is stated.
        coat_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The colour that the coat gives to what lies under it. OpenPBR, white where nothing is stated.
        coat_color: Option<Rgb> = None => ParamKind::Color, None;
        /// 0 is a polished coat, 1 a dull one. OpenPBR, 0 where nothing is stated.
        coat_roughness: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The coat's index of refraction. OpenPBR, 1.6 where nothing is stated.
        coat_ior: Option<f32> = None => ParamKind::Number(Range::from_to(1.0, 3.0)), None;
        /// How much of the surface a thin film covers, which shines in the colours of a soap bubble. OpenPBR, 0 where nothing is stated.
        thin_film_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How thick the film is. OpenPBR, 0.5 where nothing is stated.
        thin_film_thickness: Option<f32> = None => ParamKind::Number(Range::from_to(0.0, 10.0)), Micrometres;
        /// The film's index of refraction. OpenPBR, 1.4 where nothing is stated.
        thin_film_ior: Option<f32> = None => ParamKind::Number(Range::from_to(1.0, 3.0)), None;
        /// How bright it shines by itself; 1 is as bright as a white surface that is fully lit. OpenPBR, 0 where nothing is stated.
        emission_luminance: Option<f32> = None => ParamKind::Number(Range::NOT_NEGATIVE), None;
        /// The colour of its own light. OpenPBR, white where nothing is stated.
        emission_color: Option<Rgb> = None => ParamKind::Color, None;
        /// Whether it is a thin sheet; where nothing is stated the form decides. OpenPBR.
        geometry_thin_walled: Option<bool> = None => ParamKind::Flag, None;
        /// A texture whose brightness scales base_weight.
        base_weight_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness scales specular_roughness.
        roughness_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness scales base_metalness.
        metalness_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness scales specular_weight.
        specular_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness scales transmission_weight.
        transmission_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness scales coat_weight.
        coat_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose colour scales the light that it sends out itself.
        emission_texture: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture that tilts the surface in the small: red is to the right, green up, blue away from the surface.
        normal_map: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// A texture whose brightness raises the surface in the small, by bump_height where it is white.
        bump_map: Option<String> = None => ParamKind::Reference(ListName::Texture), None;
        /// How high bump_map raises the surface where it is white. 0.001 where nothing is stated.
        bump_height: Option<f32> = None => ParamKind::Number(Range::ANY), Metres;
    }
}

impl Material {
    /// The names of all textures, where there are any: that of the colour first.
    #[must_use]
    pub const fn textures(&self) -> [&Option<String>; 10] {
        [
            &self.texture,
            &self.base_weight_texture,
            &self.roughness_texture,
            &self.metalness_texture,
            &self.specular_texture,
            &self.transmission_texture,
            &self.coat_texture,
            &self.emission_texture,
            &self.normal_map,
            &self.bump_map,
        ]
    }

    /// The same, to change.
    pub const fn textures_mut(&mut self) -> [&mut Option<String>; 10] {
        [
            &mut self.texture,
            &mut self.base_weight_texture,
            &mut self.roughness_texture,
            &mut self.metalness_texture,
            &mut self.specular_texture,
            &mut self.transmission_texture,
            &mut self.coat_texture,
            &mut self.emission_texture,
            &mut self.normal_map,
            &mut self.bump_map,
        ]
    }
}
