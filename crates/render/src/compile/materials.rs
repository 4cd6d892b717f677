//! Materials and textures by index.

use super::limits::dimmed;
use super::physical::{CompiledPhysical, TextureSet};
use crate::accel::BLOCK;
use crate::accel::packet::{load3, select3, splat3};
use crate::accel::simd::{Portable, Simd};
use crate::accel::single::One;
use crate::error::CompileError;
use crate::surface::lanes_of;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;
use vitrine_math::{Rgb, srgb_from_linear};
use vitrine_optics::PhongSurface;
use vitrine_scene::{Assets, Material, Pattern, Picture, Scene, TriangleMesh, Wrap};

/// A material as the classic renderer sees it.
#[derive(Clone, Debug)]
pub struct CompiledMaterial {
    /// Colour and Phong's coefficients.
    pub phong: PhongSurface,
    /// The index of the texture in place of the colour.
    pub texture: Option<usize>,
    /// 0 to 1.
    pub reflectivity: f32,
    /// 0 to 1.
    pub transparency: f32,
    /// Index inside / index outside; 1 goes straight on.
    pub refraction: f32,
}

impl CompiledMaterial {
    fn new(material: &Material, texture: Option<usize>) -> Self {
        let m = material.classic();
        Self {
            phong: PhongSurface {
                color: dimmed(m.color),
                diffuse: m.diffuse,
                specular: m.specular,
                shininess: m.shininess,
            },
            texture,
            reflectivity: m.reflectivity,
            transparency: m.transparency,
            refraction: m.refraction,
        }
    }
}

/// A texture with its pattern at hand.
#[derive(Clone, Debug)]
pub struct CompiledTexture {
    pattern: Pattern,
    repeat: [f32; 2],
    shift: [f32; 2],
}

impl CompiledTexture {
    /// The colours at points of the surface in the lanes of the mask: u to the right, v up.
    #[inline(always)]
    pub fn colors<S: Simd>(&self, s: S, mask: S::M, uv: &[S::F; 2]) -> [S::F; 3] {
        let [u, v] = [self.along(s, uv[0], 0), self.along(s, uv[1], 1)];
        match &self.pattern {
            Pattern::Checker { colors } => {
                let two = s.splat(2.0);
                let u_is_odd = is_odd(s, s.floor(s.mul(two, u)));
                let v_is_odd = is_odd(s, s.floor(s.mul(two, v)));
                let other = s.or(s.and_not(u_is_odd, v_is_odd), s.and_not(v_is_odd, u_is_odd));
                let [even, odd] = colors.map(Rgb::to_array);
                select3(s, other, &splat3(s, odd), &splat3(s, even))
            }
            Pattern::Picture { picture, wrap } => {
                let (mut at, mut colors) = ([[0.0; BLOCK]; 2], [[0.0; BLOCK]; 3]);
                s.store(u, &mut at[0]);
                s.store(v, &mut at[1]);
                for lane in lanes_of(s.bits(mask)) {
                    let color = bilinear(picture, *wrap, at[0][lane], at[1][lane]);
                    [colors[0][lane], colors[1][lane], colors[2][lane]] = color.to_array();
                }
                load3(s, &colors, 0)
            }
        }
    }

    /// The colour in one point of the surface: u to the right, v up.
    #[must_use]
    pub fn color_at(&self, uv: [f32; 2]) -> Rgb {
        let s = One(Portable);
        let [u, v] = [self.along(s, uv[0], 0), self.along(s, uv[1], 1)];
        match &self.pattern {
            Pattern::Checker { .. } => Rgb::from(self.colors(s, true, &uv)),
            Pattern::Picture { picture, wrap } => bilinear(picture, *wrap, u, v),
        }
    }

    /// The numbers in one point, each from 0 to 1 as the picture's file holds them: for maps that are no colours.
    #[must_use]
    pub fn data_at(&self, uv: [f32; 2]) -> Rgb {
        Rgb::from(self.color_at(uv).to_array().map(srgb_from_linear))
    }

    /// A coordinate in repeats of the pattern: no more than fractions can tell apart. One that is no number goes to the limit,
    /// too.
    #[inline(always)]
    fn along<S: Simd>(&self, s: S, x: S::F, k: usize) -> S::F {
        const MOST: f32 = 1e9;
        let x = s.add(s.mul(x, s.splat(self.repeat[k])), s.splat(self.shift[k]));
        s.min(s.max(x, s.splat(-MOST)), s.splat(MOST))
    }
}

/// Whether whole numbers are odd.
#[inline(always)]
fn is_odd<S: Simd>(s: S, whole: S::F) -> S::M {
    let half = s.mul(whole, s.splat(0.5));
    s.lt(s.floor(half), half)
}

/// The mean of the four texels around the point, each by its nearness.
fn bilinear(picture: &Picture, wrap: Wrap, u: f32, v: f32) -> Rgb {
    let [width, height] = picture.size;
    // Texels have their middles at halves; the first row is at the top, where v is 1.
    let (x, y) = (u * width as f32 - 0.5, (1.0 - v) * height as f32 - 0.5);
    let (x0, y0) = (floor(x), floor(y));
    let (fx, fy) = (x - x0 as f32, y - y0 as f32);
    let at = |i: i64, n: u32| match wrap {
        Wrap::Repeat => i.rem_euclid(i64::from(n)) as u32,
        Wrap::Clamp => i.clamp(0, i64::from(n) - 1) as u32,
    };
    let texel =
        |dx: i64, dy: i64| picture.texel(at(x0.saturating_add(dx), width), at(y0.saturating_add(dy), height));
    let top = texel(0, 0).lerp(texel(1, 0), fx);
    let bottom = texel(0, 1).lerp(texel(1, 1), fx);
    top.lerp(bottom, fy)
}

/// The largest whole number that is not above `x`. Spelled out because `f32::floor` is a call where the processor's newer
/// instructions are not taken for granted.
fn floor(x: f32) -> i64 {
    let whole = x as i64;
    whole.saturating_sub(i64::from((whole as f32) > x))
}

/// A pattern whose colours can be computed with.
fn bounded(pattern: Pattern) -> Pattern {
    match pattern {
        Pattern::Checker { colors } => Pattern::Checker { colors: colors.map(dimmed) },
        Pattern::Picture { .. } => pattern,
    }
}

/// All materials and textures, by name while compiling.
pub struct MaterialTable {
    pub materials: Vec<CompiledMaterial>,
    pub physical: Vec<CompiledPhysical>,
    pub textures: Vec<CompiledTexture>,
    by_name: HashMap<String, u32>,
    /// The material of things that state none.
    unstated: u32,
}

impl MaterialTable {
    pub fn new(scene: &Scene, assets: &Assets) -> Result<Self, CompileError> {
        let mut textures = Vec::with_capacity(scene.textures.len());
        let mut texture_index = HashMap::new();
        for (i, texture) in scene.textures.iter().enumerate() {
            let pattern = texture.source.as_kind().pattern(assets);
            let missing = || CompileError::MissingPicture { texture: texture.name.clone() };
            let pattern = bounded(pattern.ok_or_else(missing)?);
            textures.push(CompiledTexture { pattern, repeat: texture.repeat, shift: texture.shift });
            texture_index.insert(texture.name.as_str(), i);
        }
        let (mut materials, mut physical, mut by_name) = (Vec::new(), Vec::new(), HashMap::new());
        for material in &scene.materials {
            let missing = |name: &String| CompileError::MissingName {
                owner: material.name.clone(),
                name: name.clone(),
            };
            let find = |name: &Option<String>| match name {
                Some(name) => {
                    texture_index.get(name.as_str()).copied().ok_or_else(|| missing(name)).map(Some)
                }
                None => Ok(None),
            };
            by_name.insert(material.name.clone(), materials.len() as u32);
            materials.push(CompiledMaterial::new(material, find(&material.texture)?));
            physical.push(CompiledPhysical::new(material, TextureSet::find(material, find)?));
        }
        let unstated = materials.len() as u32;
        materials.push(CompiledMaterial::new(&Material::default(), None));
        physical.push(CompiledPhysical::new(&Material::default(), TextureSet::default()));
        Ok(Self { materials, physical, textures, by_name, unstated })
    }

    /// The index of a material by name; that of a plain grey one for None.
    pub fn find(&self, owner: &str, name: Option<&str>) -> Result<u32, CompileError> {
        let Some(name) = name else { return Ok(self.unstated) };
        self.by_name
            .get(name)
            .copied()
            .ok_or_else(|| CompileError::MissingName { owner: owner.to_owned(), name: name.to_owned() })
    }

    /// Whether light passes any of these materials.
    pub fn is_any_transparent(&self, materials: Range<u32>) -> bool {
        self.materials[materials.start as usize..materials.end as usize].iter().any(|m| m.transparency > 0.0)
    }

    /// Adds a model's own materials; gives their indices. Slot 0 is that of triangles without any, slot k + 1 the model's
    /// material k.
    pub fn add_slots(&mut self, mesh: &TriangleMesh, assets: &Assets) -> Result<Range<u32>, CompileError> {
        let first = self.materials.len() as u32;
        self.materials.push(self.materials[self.unstated as usize].clone());
        self.physical.push(self.physical[self.unstated as usize].clone());
        for slot in &mesh.materials {
            let texture = match &slot.picture {
                None => None,
                Some(path) => {
                    let missing = || CompileError::MissingPicture { texture: slot.material.name.clone() };
                    let picture = Arc::clone(assets.pictures.get(path).ok_or_else(missing)?);
                    let pattern = Pattern::Picture { picture, wrap: Wrap::Repeat };
                    self.textures.push(CompiledTexture { pattern, repeat: [1.0; 2], shift: [0.0; 2] });
                    Some(self.textures.len() - 1)
                }
            };
            self.materials.push(CompiledMaterial::new(&slot.material, texture));
            let color = texture.map(|t| t as u32);
            self.physical
                .push(CompiledPhysical::new(&slot.material, TextureSet { color, ..TextureSet::default() }));
        }
        Ok(first..self.materials.len() as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::packet::store3;
    use crate::accel::simd::{Instructions, Kernel};

    /// Black, white over red, green.
    fn picture() -> Arc<Picture> {
        let texels = vec![[0, 0, 0], [255, 255, 255], [255, 0, 0], [0, 255, 0]];
        Arc::new(Picture { size: [2, 2], texels })
    }

    fn texture(wrap: Wrap) -> CompiledTexture {
        let pattern = Pattern::Picture { picture: picture(), wrap };
        CompiledTexture { pattern, repeat: [1.0; 2], shift: [0.0; 2] }
    }

    struct ColorAt<'a>(&'a CompiledTexture, [f32; 2]);

    impl Kernel for ColorAt<'_> {
        type Output = Rgb;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Rgb {
            let Self(texture, [u, v]) = self;
            let mask = s.le(s.splat(0.0), s.splat(0.0));
            let mut colors = [[0.0; BLOCK]; 3];
            store3(s, &texture.colors(s, mask, &[s.splat(u), s.splat(v)]), &mut colors, 0);
            Rgb::from(colors.map(|column| column[S::LANES - 1]))
        }
    }

    impl CompiledTexture {
        fn color(&self, uv: [f32; 2]) -> Rgb {
            Instructions::detect().run(ColorAt(self, uv))
        }
    }

    #[test]
    fn middles_of_texels_are_exact_and_v_goes_up() {
        let t = texture(Wrap::Repeat);
        assert_eq!(t.color([0.25, 0.75]), Rgb::BLACK);
        assert_eq!(t.color([0.75, 0.75]), Rgb::WHITE);
        assert_eq!(t.color([0.25, 0.25]), Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(t.color([0.75, 0.25]), Rgb::new(0.0, 1.0, 0.0));
    }

    #[test]
    fn between_texels_the_linear_colours_mix() {
        let mid = texture(Wrap::Clamp).color([0.5, 0.75]);
        assert!((mid.g - 0.5).abs() < 1e-6, "half of black and white in linear light: {mid:?}");
    }

    #[test]
    fn beyond_the_edge_it_repeats_or_keeps_the_edge() {
        assert_eq!(texture(Wrap::Repeat).color([1.25, -0.25]), Rgb::BLACK);
        assert_eq!(texture(Wrap::Clamp).color([-7.0, 0.25]), Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(texture(Wrap::Clamp).color([9.0, 9.0]), Rgb::WHITE);
    }

    #[test]
    fn checker_alternates_on_both_sides_of_zero() {
        let colors = [Rgb::WHITE, Rgb::BLACK];
        let pattern = Pattern::Checker { colors };
        let t = CompiledTexture { pattern, repeat: [1.0; 2], shift: [0.0; 2] };
        assert_eq!(t.color([0.1, 0.1]), Rgb::WHITE);
        assert_eq!(t.color([0.6, 0.1]), Rgb::BLACK);
        assert_eq!(t.color([-0.1, 0.1]), Rgb::BLACK);
        assert_eq!(t.color([-0.1, -0.1]), Rgb::WHITE);
        assert_eq!(t.color([8_388_607.5, 0.1]), Rgb::BLACK, "as far as floats have halves");
        assert_eq!(t.color([f32::INFINITY, f32::NAN]), Rgb::WHITE, "no number, but a colour");
    }
}
