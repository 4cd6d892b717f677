//! The two sides of a material, each made whole.
//!
//! A parameter that is stated counts. One that is not is derived from the other side **if that side states anything that it
//! depends on**, else it has its default. The rules, with F₀ = ((n−1)/(n+1))² the reflectance at normal incidence:
//!
//! | classic | from OpenPBR |
//! |---|---|
//! | color | base_color (that of the metal, if one is named) mixed with transmission_color by transmission_weight |
//! | diffuse | base_weight |
//! | specular | specular_weight · (1 − specular_roughness) |
//! | shininess | s of α² = 2/(4s + 2), α = specular_roughness² |
//! | transparency | transmission_weight · (1 − base_metalness) · (1 − F₀) · Y(transmission_color) |
//! | reflectivity | (1 − specular_roughness) · (base_metalness + (1 − base_metalness) · transmission_weight · F₀/(1 − transparency)) |
//! | reflectivity of a named metal | the same, base_metalness times the least channel of the metal's colour |
//! | refraction | specular_ior, if transmission_weight is more than 0 and geometry_thin_walled is not true; else 1 |
//!
//! | OpenPBR | from classic |
//! |---|---|
//! | base_color, transmission_color | color |
//! | base_weight | diffuse |
//! | base_metalness | 1 if a metal is named, else reflectivity; of what light passes 0 |
//! | specular_weight | specular; of what light passes 1 |
//! | specular_roughness | 0.1 if a metal is named, 0 of what light passes, else √α · (1 − reflectivity), α² = 2/(4·shininess + 2) |
//! | specular_ior | refraction if it is more than 1, else 1.5 |
//! | transmission_weight | transparency |
//! | transmission_dispersion_scale | 1 if an Abbe number is stated, else 0 |
//!
//! What light passes (transmission_weight or transparency is more than 0) is clear glass or water, which mirrors by its index
//! alone, unless its roughness is stated.
//!
//! A metal that is named stands in the place of base_color, even of one that is stated. What light goes through is solid
//! unless geometry_thin_walled says otherwise, where the form has an inside; planes, triangles and discs are thin sheets.
//! Where refraction says that light goes straight on, the physical side is glass of index 1.5 all the same: there is no
//! glass that does not bend light. Without transmission_depth its colour is that of its surfaces, as in the classic model.
//! Coats, films, light of its own, textures other than the colour's and scattering inside have no classic side.
//!
//! So a clean pane (transmission_weight 1) has α = F₀ in the classic blend, all of it mirror image, which is what glass
//! seen head-on does. The link of roughness and exponent equates a Phong lobe, whose width is a quarter of a
//! Blinn lobe's exponent, with a Beckmann lobe (Walter et al., EGSR 2007: α_p = 2α⁻² − 2).

use super::{Material, Metal};
use vitrine_math::Rgb;

/// How rough a metal is where nothing is stated: polished by hand, not a mirror.
const METAL_ROUGHNESS: f32 = 0.1;

/// The classic side, whole: the course work's scales.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassicMaterial {
    /// Linear.
    pub color: Rgb,
    /// k_d, 0 to 1.
    pub diffuse: f32,
    /// k_s, 0 to 1.
    pub specular: f32,
    /// s, 1 or more.
    pub shininess: f32,
    /// 0 to 1.
    pub reflectivity: f32,
    /// 0 to 1.
    pub transparency: f32,
    /// Index inside / index outside; 1 goes straight on.
    pub refraction: f32,
}

/// The physical side, whole, with OpenPBR's names.
#[derive(Clone, Debug, PartialEq)]
pub struct PhysicalMaterial {
    /// A metal that is known by its index. [`Self::base_color`] is then its colour.
    pub metal: Option<Metal>,
    /// 0 to 1.
    pub base_weight: f32,
    /// Linear.
    pub base_color: Rgb,
    /// 0 to 1: σ of Oren and Nayar's model, as OpenPBR has it.
    pub base_diffuse_roughness: f32,
    /// 0 to 1.
    pub base_metalness: f32,
    /// 0 to 1.
    pub specular_weight: f32,
    /// Linear.
    pub specular_color: Rgb,
    /// 0 to 1; α is its square.
    pub specular_roughness: f32,
    /// Index inside / index outside.
    pub specular_ior: f32,
    /// 0 to 1.
    pub transmission_weight: f32,
    /// Linear.
    pub transmission_color: Rgb,
    /// Metres; 0 tints at the surface.
    pub transmission_depth: f32,
    /// Linear: what is scattered within the depth.
    pub transmission_scatter: Rgb,
    /// −0.99 to 0.99: g of Henyey and Greenstein's formula.
    pub transmission_scatter_anisotropy: f32,
    /// 0 to 1.
    pub transmission_dispersion_scale: f32,
    /// V_d, 9 to 200.
    pub transmission_dispersion_abbe_number: f32,
    /// 0 to 1.
    pub coat_weight: f32,
    /// Linear: what light keeps that crosses the coat in and out.
    pub coat_color: Rgb,
    /// 0 to 1; α is its square.
    pub coat_roughness: f32,
    /// Index of the coat / index outside.
    pub coat_ior: f32,
    /// 0 to 1.
    pub thin_film_weight: f32,
    /// Micrometres, 0 to 10.
    pub thin_film_thickness: f32,
    /// Index of the film / index outside.
    pub thin_film_ior: f32,
    /// A radiance; 1 is that of a white surface which a light of intensity 1 lights fully. Times [`Self::emission_color`].
    pub emission_luminance: f32,
    /// Linear.
    pub emission_color: Rgb,
    /// None: the form decides.
    pub geometry_thin_walled: Option<bool>,
    /// Metres: how high the bump map raises where it is white.
    pub bump_height: f32,
}

impl Default for ClassicMaterial {
    fn default() -> Self {
        Self {
            color: Rgb::splat(0.8),
            diffuse: 0.8,
            specular: 0.0,
            shininess: 32.0,
            reflectivity: 0.0,
            transparency: 0.0,
            refraction: 1.0,
        }
    }
}

impl Default for PhysicalMaterial {
    /// OpenPBR 1.1's defaults.
    fn default() -> Self {
        Self {
            metal: None,
            base_weight: 1.0,
            base_color: Rgb::splat(0.8),
            base_diffuse_roughness: 0.0,
            base_metalness: 0.0,
            specular_weight: 1.0,
            specular_color: Rgb::WHITE,
            specular_roughness: 0.3,
            specular_ior: 1.5,
            transmission_weight: 0.0,
            transmission_color: Rgb::WHITE,
            transmission_depth: 0.0,
            transmission_scatter: Rgb::BLACK,
            transmission_scatter_anisotropy: 0.0,
            transmission_dispersion_scale: 0.0,
            transmission_dispersion_abbe_number: 20.0,
            coat_weight: 0.0,
            coat_color: Rgb::WHITE,
            coat_roughness: 0.0,
            coat_ior: 1.6,
            thin_film_weight: 0.0,
            thin_film_thickness: 0.5,
            thin_film_ior: 1.4,
            emission_luminance: 0.0,
            emission_color: Rgb::WHITE,
            geometry_thin_walled: None,
            bump_height: 0.001,
        }
    }
}

impl Material {
    /// The classic side, whole.
    #[must_use]
    pub fn classic(&self) -> ClassicMaterial {
        let default = ClassicMaterial::default();
        let p = self.stated_physical();
        let f0 = vitrine_optics::normal_reflectance(p.specular_ior);
        // A mirror or pane without a word on roughness is meant polished.
        let roughness = self.specular_roughness.or(self.metal.map(|_| METAL_ROUGHNESS)).unwrap_or(0.0);
        let passes = self.transmission_weight.is_some();
        let through = p.transmission_weight * (1.0 - p.base_metalness) * (1.0 - f0);
        let transparency = self
            .transparency
            .or(passes.then(|| through * p.transmission_color.luminance().min(1.0)))
            .unwrap_or(default.transparency);
        let mirror = |opacity: f32| {
            let glass = if opacity > 0.0 { (f0 / opacity).min(1.0) } else { 0.0 };
            let dielectric = (1.0 - p.base_metalness) * p.transmission_weight * glass;
            // The classic mirror image has no tint: a metal gives as much of it as it mirrors of all colours alike.
            let metal = p.base_metalness * self.metal.map_or(1.0, |m| least(m.color()));
            (1.0 - roughness) * (metal + dielectric)
        };
        let bends = p.transmission_weight > 0.0 && self.geometry_thin_walled != Some(true);
        ClassicMaterial {
            color: self
                .color
                .or((self.base_color.is_some() || self.metal.is_some() || self.transmission_color.is_some())
                    .then(|| p.base_color.lerp(p.transmission_color, p.transmission_weight)))
                .unwrap_or(default.color),
            diffuse: self.diffuse.or(self.base_weight).unwrap_or(default.diffuse),
            specular: self
                .specular
                .or((self.specular_weight.is_some()
                    || self.specular_roughness.is_some()
                    || self.metal.is_some())
                .then_some(p.specular_weight * (1.0 - p.specular_roughness)))
                .unwrap_or(default.specular),
            shininess: self
                .shininess
                .or(self.specular_roughness.map(shininess_from_roughness))
                .unwrap_or(default.shininess),
            reflectivity: self
                .reflectivity
                .or((self.base_metalness.is_some() || self.metal.is_some() || passes)
                    .then(|| mirror(1.0 - transparency)))
                .unwrap_or(default.reflectivity),
            transparency,
            refraction: self.refraction.or(self.specular_ior.filter(|_| bends)).unwrap_or(default.refraction),
        }
    }

    /// The physical side, whole.
    #[must_use]
    pub fn physical(&self) -> PhysicalMaterial {
        let p = self.surface();
        PhysicalMaterial {
            transmission_scatter: self.transmission_scatter.unwrap_or(p.transmission_scatter),
            transmission_scatter_anisotropy: self
                .transmission_scatter_anisotropy
                .unwrap_or(p.transmission_scatter_anisotropy),
            transmission_dispersion_scale: self
                .transmission_dispersion_scale
                .or(self.transmission_dispersion_abbe_number.map(|_| 1.0))
                .unwrap_or(p.transmission_dispersion_scale),
            transmission_dispersion_abbe_number: self
                .transmission_dispersion_abbe_number
                .unwrap_or(p.transmission_dispersion_abbe_number),
            coat_weight: self.coat_weight.unwrap_or(p.coat_weight),
            coat_color: self.coat_color.unwrap_or(p.coat_color),
            coat_roughness: self.coat_roughness.unwrap_or(p.coat_roughness),
            coat_ior: self.coat_ior.unwrap_or(p.coat_ior),
            thin_film_weight: self.thin_film_weight.unwrap_or(p.thin_film_weight),
            thin_film_thickness: self.thin_film_thickness.unwrap_or(p.thin_film_thickness),
            thin_film_ior: self.thin_film_ior.unwrap_or(p.thin_film_ior),
            emission_luminance: self.emission_luminance.unwrap_or(p.emission_luminance),
            emission_color: self.emission_color.unwrap_or(p.emission_color),
            geometry_thin_walled: self.geometry_thin_walled,
            bump_height: self.bump_height.unwrap_or(p.bump_height),
            ..p
        }
    }

    /// Base, reflection and transmission, which are derived from the classic side; the rest at its defaults.
    fn surface(&self) -> PhysicalMaterial {
        let default = PhysicalMaterial::default();
        let mirror = self.reflectivity.unwrap_or(0.0);
        let is_clear = self.metal.is_none()
            && self.transmission_weight.or(self.transparency).is_some_and(|passes| passes > 0.0);
        PhysicalMaterial {
            metal: self.metal,
            base_weight: self.base_weight.or(self.diffuse).unwrap_or(default.base_weight),
            base_color: self
                .metal
                .map(Metal::color)
                .or(self.base_color)
                .or(self.color)
                .unwrap_or(default.base_color),
            base_diffuse_roughness: self.base_diffuse_roughness.unwrap_or(default.base_diffuse_roughness),
            base_metalness: self
                .base_metalness
                .or(self.metal.map(|_| 1.0))
                .or(self.reflectivity.filter(|_| !is_clear))
                .unwrap_or(default.base_metalness),
            specular_weight: self
                .specular_weight
                .or(self.specular.filter(|_| !is_clear))
                .unwrap_or(default.specular_weight),
            specular_color: self.specular_color.unwrap_or(default.specular_color),
            specular_roughness: self
                .specular_roughness
                .or(self.metal.map(|_| METAL_ROUGHNESS))
                .or(is_clear.then_some(0.0))
                .or(self.shininess.map(|s| roughness_from_shininess(s) * (1.0 - mirror)))
                .or(self.reflectivity.map(|r| default.specular_roughness * (1.0 - r)))
                .unwrap_or(default.specular_roughness),
            specular_ior: self
                .specular_ior
                .or(self.refraction.filter(|n| *n > 1.0))
                .unwrap_or(default.specular_ior),
            transmission_weight: self
                .transmission_weight
                .or(self.transparency)
                .unwrap_or(default.transmission_weight),
            transmission_color: self.transmission_color.or(self.color).unwrap_or(default.transmission_color),
            transmission_depth: self.transmission_depth.unwrap_or(default.transmission_depth),
            ..default
        }
    }

    /// The physical parameters that are stated, the rest at their defaults: nothing derived.
    fn stated_physical(&self) -> PhysicalMaterial {
        let classic_less = Self {
            color: None,
            diffuse: None,
            specular: None,
            shininess: None,
            reflectivity: None,
            transparency: None,
            refraction: None,
            ..self.clone()
        };
        classic_less.physical()
    }
}

fn least(color: Rgb) -> f32 {
    color.r.min(color.g).min(color.b)
}

fn shininess_from_roughness(roughness: f32) -> f32 {
    let alpha = roughness * roughness;
    ((2.0 / (alpha * alpha) - 2.0) / 4.0).clamp(1.0, 10_000.0)
}

fn roughness_from_shininess(shininess: f32) -> f32 {
    // α = √(2/(4s+2)), roughness = √α
    (2.0 / (4.0 * shininess + 2.0)).sqrt().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_stated_gives_both_defaults() {
        let m = Material::default();
        assert_eq!(m.classic(), ClassicMaterial::default());
        assert_eq!(m.physical(), PhysicalMaterial::default());
    }

    #[test]
    fn stated_wins_on_both_sides() {
        let m = Material {
            color: Some(Rgb::new(1.0, 0.0, 0.0)),
            base_color: Some(Rgb::new(0.0, 1.0, 0.0)),
            transparency: Some(0.3),
            transmission_weight: Some(0.9),
            ..Material::default()
        };
        assert_eq!(m.classic().color, Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(m.physical().base_color, Rgb::new(0.0, 1.0, 0.0));
        assert_eq!(m.classic().transparency, 0.3);
        assert_eq!(m.physical().transmission_weight, 0.9);
    }

    #[test]
    fn a_clean_pane_reflects_four_hundredths_in_the_classic_blend() {
        let pane = Material { transmission_weight: Some(1.0), ..Material::default() }.classic();
        let opacity = 1.0 - pane.transparency;
        assert!((opacity - 0.04).abs() < 1e-6, "F₀ of index 1.5");
        assert!((opacity * pane.reflectivity - 0.04).abs() < 1e-6, "all of it mirror image");
    }

    #[test]
    fn metal_is_a_mirror_and_dull_metal_less_so() {
        let polished = Material { base_metalness: Some(1.0), ..Material::default() };
        let dull = Material { specular_roughness: Some(0.5), ..polished.clone() };
        assert_eq!(polished.classic().reflectivity, 1.0);
        assert_eq!(dull.classic().reflectivity, 0.5);
    }

    #[test]
    fn a_named_metal_is_metal_polished_by_hand_of_its_own_colour() {
        let stated = Material {
            metal: Some(Metal::Gold),
            base_color: Some(Rgb::BLACK),
            shininess: Some(5.0),
            ..Material::default()
        };
        let gold = stated.physical();
        assert_eq!((gold.metal, gold.base_color), (Some(Metal::Gold), Metal::Gold.color()));
        assert_eq!((gold.base_metalness, gold.specular_roughness, gold.base_weight), (1.0, 0.1, 1.0));
        let classic = stated.classic();
        assert_eq!(classic.color, Metal::Gold.color());
        assert!((classic.reflectivity - 0.9 * Metal::Gold.color().b).abs() < 1e-6, "{classic:?}");
        let worn = Material { base_metalness: Some(0.5), specular_roughness: Some(0.4), ..stated };
        assert_eq!((worn.physical().base_metalness, worn.physical().specular_roughness), (0.5, 0.4));
    }

    #[test]
    fn an_abbe_number_alone_turns_dispersion_on() {
        let flint = Material { transmission_dispersion_abbe_number: Some(30.0), ..Material::default() };
        assert_eq!(flint.physical().transmission_dispersion_scale, 1.0);
        let off = Material { transmission_dispersion_scale: Some(0.0), ..flint };
        assert_eq!(off.physical().transmission_dispersion_scale, 0.0);
    }

    #[test]
    fn red_glass_of_the_course_work_is_tinted_glass() {
        let red = Rgb::from_hex("#c8281e").unwrap();
        let glass = Material { color: Some(red), transparency: Some(0.8), ..Material::default() }.physical();
        assert_eq!((glass.transmission_weight, glass.transmission_color), (0.8, red));
        assert_eq!(glass.specular_ior, 1.5);
    }

    #[test]
    fn roughness_and_shininess_are_inverse() {
        for s in [2.0_f32, 10.0, 100.0, 1000.0] {
            let back = shininess_from_roughness(roughness_from_shininess(s));
            assert!((back - s).abs() < 1e-3 * s, "{s} came back as {back}");
        }
    }

    #[test]
    fn straight_on_unless_an_index_is_stated() {
        let window = Material { transmission_weight: Some(1.0), ..Material::default() };
        assert_eq!(window.classic().refraction, 1.0);
        let solid = Material { specular_ior: Some(1.33), ..window.clone() };
        assert_eq!(solid.classic().refraction, 1.33);
        let sheet = Material { geometry_thin_walled: Some(true), ..solid };
        assert_eq!(sheet.classic().refraction, 1.0);
    }
}
