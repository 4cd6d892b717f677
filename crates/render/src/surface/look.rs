//! What surfaces in lanes are made of.

use super::HitPoints;
use crate::accel::Column;
use crate::accel::packet::select3;
use crate::accel::simd::Simd;
use crate::compile::{CompiledMaterial, CompiledScene};

/// The numbers of a [`CompiledMaterial`].
#[derive(Clone, Copy)]
pub struct Look<S: Simd> {
    /// The colour, or the texture's.
    pub color: [S::F; 3],
    /// k_d
    pub diffuse: S::F,
    /// k_s
    pub specular: S::F,
    pub shininess: S::F,
    pub reflectivity: S::F,
    pub transparency: S::F,
    /// Index inside / index outside; 1 goes straight on.
    pub refraction: S::F,
}

impl<S: Simd> Look<S> {
    #[inline(always)]
    fn of_nothing(s: S) -> Self {
        let (zero, one) = (s.splat(0.0), s.splat(1.0));
        Self {
            color: [zero; 3],
            diffuse: zero,
            specular: zero,
            shininess: one,
            reflectivity: zero,
            transparency: zero,
            refraction: one,
        }
    }

    /// Puts a material into the lanes of the mask.
    #[inline(always)]
    fn put(&mut self, s: S, mask: S::M, material: &CompiledMaterial) {
        let phong = &material.phong;
        for (color, value) in self.color.iter_mut().zip(phong.color.to_array()) {
            *color = s.select(mask, s.splat(value), *color);
        }
        let numbers = [
            (&mut self.diffuse, phong.diffuse),
            (&mut self.specular, phong.specular),
            (&mut self.shininess, phong.shininess),
            (&mut self.reflectivity, material.reflectivity),
            (&mut self.transparency, material.transparency),
            (&mut self.refraction, material.refraction),
        ];
        for (number, value) in numbers {
            *number = s.select(mask, s.splat(value), *number);
        }
    }
}

impl CompiledScene {
    /// The materials at points that are hit. `materials` are their indices, as the bits of floats.
    #[inline(always)]
    pub(super) fn look<S: Simd>(&self, s: S, points: &HitPoints<S>, materials: &Column) -> Look<S> {
        let hit = points.hit;
        let mut look = Look::of_nothing(s);
        let indices = s.load(materials);
        let mut left = s.bits(hit);
        while left != 0 {
            let id = materials[left.trailing_zeros() as usize];
            let same = s.and(hit, s.eq(indices, s.splat(id)));
            left &= !s.bits(same);
            let material = &self.materials[id.to_bits() as usize];
            look.put(s, same, material);
            if let Some(texture) = material.texture {
                let uv = self.texture_points(s, same, points);
                look.color = select3(s, same, &self.textures[texture].colors(s, same, &uv), &look.color);
            }
        }
        look
    }
}
