//! What a surface is made of in the point where a path meets it.

use super::step::Arrival;
use crate::compile::{CompiledPhysical, CompiledScene};
use crate::surface::Spot;
use vitrine_math::{Frame, Rgb, Vec3};
use vitrine_optics::bsdf::Surface;

/// The least cosine between the viewer and a normal that a map has bent.
const LEAST_COS: f32 = 0.02;

/// A surface with its textures looked up.
pub struct Dressed {
    /// The frame around the normal for shading, which is on the viewer's side.
    pub frame: Frame,
    /// What it is made of; the index is that of the material over air.
    pub surface: Surface,
    /// The radiance that leaves it.
    pub emission: Rgb,
}

/// Looks everything up.
pub fn dress(scene: &CompiledScene, material: &CompiledPhysical, spot: &Spot, arrival: &Arrival) -> Dressed {
    let mut dressed =
        Dressed { frame: Frame::around(spot.ns), surface: material.surface, emission: material.emission };
    let set = &material.textures;
    if set.is_empty() {
        return dressed;
    }
    let uv = scene.uv_of(arrival.rays, arrival.hits, arrival.i, spot.p);
    let color = |texture: Option<u32>| texture.map(|t| scene.textures[t as usize].color_at(uv));
    let scale = |texture: Option<u32>| color(texture).map_or(1.0, |c| c.luminance().clamp(0.0, 1.0));
    let surface = &mut dressed.surface;
    if let Some(color) = color(set.color) {
        surface.base_color = color * material.numbers.base_weight;
        if material.numbers.transmission_depth == 0.0 {
            surface.transmission_tint = color;
        }
    }
    surface.base_color *= scale(set.base_weight);
    surface.metalness *= scale(set.metalness);
    surface.roughness *= scale(set.roughness);
    surface.specular_weight *= scale(set.specular);
    surface.transmission *= scale(set.transmission);
    surface.coat_weight *= scale(set.coat);
    if let Some(color) = color(set.emission) {
        dressed.emission = dressed.emission * color;
    }
    if set.bends_normals() {
        let n = bent_normal(scene, material, spot, uv);
        dressed.frame = Frame::around(towards(n, arrival.ray.direction * -1.0, spot.ns));
    }
    dressed
}

/// The normal after its maps, on the viewer's side.
fn bent_normal(scene: &CompiledScene, material: &CompiledPhysical, spot: &Spot, uv: [f32; 2]) -> Vec3 {
    let [along_u, along_v] = scene.tangents(spot);
    let mut n = spot.ns;
    if let Some(map) = material.textures.normal_map {
        // Colours from 0 to 1 are components from −1 to 1; the map's z is out of the surface.
        let c = scene.textures[map as usize].data_at(uv) * 2.0 - Rgb::WHITE;
        let (u, v) = (along_u.normalize_or_zero(), along_v.normalize_or_zero());
        n = (u * c.r + v * c.g + spot.ns * c.b).try_normalize().unwrap_or(spot.ns);
    }
    if let Some(map) = material.textures.bump_map {
        const STEP: f32 = 1e-3;
        let texture = &scene.textures[map as usize];
        let height = |u: f32, v: f32| texture.data_at([u, v]).luminance() * material.numbers.bump_height;
        let [u, v] = uv;
        let slope_u = (height(u + STEP, v) - height(u - STEP, v)) / (2.0 * STEP);
        let slope_v = (height(u, v + STEP) - height(u, v - STEP)) / (2.0 * STEP);
        // ∇h along the surface: slopes over the lengths of the tangents, squared for the directions.
        let gradient = along_u * (slope_u / along_u.length_squared().max(f32::MIN_POSITIVE))
            + along_v * (slope_v / along_v.length_squared().max(f32::MIN_POSITIVE));
        n = (n - gradient).try_normalize().unwrap_or(n);
    }
    n
}

/// A normal turned towards the viewer until it is seen.
fn towards(n: Vec3, wo: Vec3, otherwise: Vec3) -> Vec3 {
    let cos = n.dot(wo);
    if cos >= LEAST_COS {
        return n;
    }
    (n + wo * (LEAST_COS - cos)).try_normalize().unwrap_or(otherwise)
}
