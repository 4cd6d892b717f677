//! What a scene takes from other files, once it has been read: models and pictures.

use crate::Material;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};
use vitrine_math::{Bounds3, Rgb, Vec2, Vec3, linear_from_srgb};

/// Every model and picture that a scene names, by the path as the scene writes it.
#[derive(Clone, Debug, Default)]
pub struct Assets {
    /// Models.
    pub meshes: BTreeMap<PathBuf, Arc<TriangleMesh>>,
    /// Pictures for textures, those of models' own materials included.
    pub pictures: BTreeMap<PathBuf, Arc<Picture>>,
    /// Panoramas of lights.
    pub maps: BTreeMap<PathBuf, Arc<RadianceMap>>,
}

/// A model: triangles over shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// Vertices in object space, metres.
    pub positions: Vec<Vec3>,
    /// One for each vertex, of unit length, or zero where the file gives none; empty when it gives none at all.
    pub normals: Vec<Vec3>,
    /// One for each vertex: u to the right, v up; empty when the file gives none.
    pub uvs: Vec<Vec2>,
    /// Three indices of vertices each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Runs of triangles, in order, together all of them.
    pub parts: Vec<MeshPart>,
    /// The model's own materials.
    pub materials: Vec<MeshMaterial>,
}

/// A run of a model's triangles with one name and one material.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPart {
    /// The file's group or object name.
    pub name: String,
    /// Which triangles.
    pub triangles: Range<usize>,
    /// The index among [`TriangleMesh::materials`].
    pub material: Option<usize>,
}

/// A material that came with a model.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMaterial {
    /// The material; its `texture` stays empty.
    pub material: Material,
    /// The picture for its colour: a key of [`Assets::pictures`].
    pub picture: Option<PathBuf>,
}

impl TriangleMesh {
    /// The box around all vertices.
    #[must_use]
    pub fn bounds(&self) -> Bounds3 {
        Bounds3::around(self.positions.iter().copied())
    }

    /// Bytes of the arrays.
    #[must_use]
    pub fn memory(&self) -> usize {
        size_of_val(&*self.positions)
            + size_of_val(&*self.normals)
            + size_of_val(&*self.uvs)
            + size_of_val(&*self.triangles)
    }
}

/// A picture for a texture: 8-bit sRGB texels, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height, neither 0.
    pub size: [u32; 2],
    /// `size[0] · size[1]` texels: red, green, blue.
    pub texels: Vec<[u8; 3]>,
}

impl Picture {
    /// A texel as a linear colour. `x` counts from the left, `y` from the top.
    ///
    /// # Panics
    /// When the texel lies outside the picture.
    #[must_use]
    pub fn texel(&self, x: u32, y: u32) -> Rgb {
        static LINEAR: OnceLock<[f32; 256]> = OnceLock::new();
        let linear = LINEAR.get_or_init(|| std::array::from_fn(|v| linear_from_srgb(v as f32 / 255.0)));
        let [r, g, b] = self.texels[y as usize * self.size[0] as usize + x as usize];
        Rgb::new(linear[usize::from(r)], linear[usize::from(g)], linear[usize::from(b)])
    }
}

/// A panorama of radiance, latitude by longitude: a texel for each direction.
///
/// The top row is towards +Y, the middle column towards −Z, the column at three quarters of the width towards +X: it is
/// what a camera that is not turned would see around it, without being mirrored.
#[derive(Clone, Debug, PartialEq)]
pub struct RadianceMap {
    /// Width and height, neither 0.
    pub size: [u32; 2],
    /// `size[0] · size[1]` radiances, row by row from the top: linear, finite, not negative.
    pub pixels: Vec<Rgb>,
}

impl RadianceMap {
    /// The mean radiance over all directions.
    #[must_use]
    pub fn mean(&self) -> Rgb {
        let [width, height] = self.size;
        let (mut sum, mut whole) = ([0.0_f64; 3], 0.0);
        for (y, row) in self.pixels.chunks_exact(width as usize).enumerate() {
            // The band of a row is as long as the sine of its angle from +Y. f64: millions of texels are added.
            let band = libm::sin(std::f64::consts::PI * (y as f64 + 0.5) / f64::from(height));
            for (sum, channel) in sum.iter_mut().zip(0..3) {
                *sum += band * row.iter().map(|texel| f64::from(texel.to_array()[channel])).sum::<f64>();
            }
            whole += band * f64::from(width);
        }
        Rgb::from(sum.map(|s| (s / whole) as f32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_counts_directions_and_not_texels() {
        let even = RadianceMap { size: [8, 4], pixels: vec![Rgb::new(0.5, 2.0, 7.0); 32] };
        let off = even.mean().to_array().into_iter().zip([0.5, 2.0, 7.0]).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f32::max) < 1e-6);
        // The upper sixth of the angles is a cap of height 1 − cos 30° on a ball of height 2.
        let pixels = (0..600).map(|y| if y < 100 { Rgb::WHITE } else { Rgb::BLACK }).collect();
        let cap = RadianceMap { size: [1, 600], pixels };
        let share = (1.0 - (std::f32::consts::PI / 6.0).cos()) / 2.0;
        assert!((cap.mean().r - share).abs() < 1e-5, "{} is not {share}", cap.mean().r);
    }
}
