//! What things are made of. One material has two sides, the course work's scales and physical parameters with OpenPBR's
//! names; what one side does not say is derived from the other ([`mod@derive`]).

pub mod derive;

pub use derive::{ClassicMaterial, PhysicalMaterial};

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
        /// How much of the base there is. OpenPBR.
        base_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// The base's colour. OpenPBR.
        base_color: Option<Rgb> = None => ParamKind::Color, None;
        /// 0 is plastic, glass or wood, 1 is metal. OpenPBR.
        base_metalness: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
        /// How much the surface reflects. OpenPBR.
        specular_weight: Option<f32> = None => ParamKind::Number(Range::UNIT), None;
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
        /// Whether it is a thin sheet; where nothing is stated the form decides. OpenPBR.
        geometry_thin_walled: Option<bool> = None => ParamKind::Flag, None;
    }
}
