//! The light of lamps on the surfaces of a wave, with shadows: hard ones by one ray, soft ones by rays to points of the lamp.
//!
//! Surfaces wait in blocks, a surface a lane. Their lighting, their shadow rays and the sums are worked out in lanes in one
//! go, so that no shadow ray is ever stored.

use super::TileTask;
use super::soft::SoftLight;
use crate::accel::packet::{along3, dot, load3, splat3, sub3};
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, Packet};
use crate::compile::CompiledLight;
use crate::surface::SurfaceBlock;
use vitrine_math::Rgb;
use vitrine_optics::PhongSurface;
use vitrine_scene::lights::Emission;

/// What the surfaces of a block are made of, and the light that has reached them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct LitBlock {
    pub color: [Column; 3],
    /// k_d and k_s, each times the weight of the surface's own light in its pixel; 0 in places without a surface.
    pub diffuse: Column,
    pub specular: Column,
    pub shininess: Column,
    /// The light so far, as the pixel gets it.
    pub sum: [Column; 3],
    pub pixel: [u32; BLOCK],
}

impl LitBlock {
    const DARK: Self = {
        let zero = [0.0; BLOCK];
        Self {
            color: [zero; 3],
            diffuse: zero,
            specular: zero,
            shininess: [1.0; BLOCK],
            sum: [zero; 3],
            pixel: [0; BLOCK],
        }
    };
}

/// A surface that waits for light.
#[derive(Clone, Copy, Debug)]
pub struct Lit {
    pub phong: PhongSurface,
    /// The pixel, by its place in the tile.
    pub pixel: u32,
    /// The weight of the surface's own light in the pixel.
    pub weight: f32,
}

/// The surfaces of a wave that wait for light, each in the place of its hit.
#[derive(Debug, Default)]
pub struct LightQueue {
    blocks: Vec<LitBlock>,
}

impl LightQueue {
    /// Makes so many dark places.
    pub fn reset(&mut self, len: usize) {
        self.blocks.clear();
        self.blocks.resize(len.div_ceil(BLOCK), LitBlock::DARK);
    }

    /// Puts a surface into a place, with the light that it has already.
    #[inline(always)]
    pub fn put(&mut self, i: usize, surface: &Lit, ambient: Rgb) {
        let &Lit { phong, pixel, weight } = surface;
        let (block, lane) = (&mut self.blocks[i / BLOCK], i % BLOCK);
        let (color, lit) = (phong.color.to_array(), (phong.color * ambient * weight).to_array());
        for k in 0..3 {
            block.color[k][lane] = color[k];
            block.sum[k][lane] = lit[k];
        }
        block.diffuse[lane] = phong.diffuse * weight;
        block.specular[lane] = phong.specular * weight;
        block.shininess[lane] = phong.shininess;
        block.pixel[lane] = pixel;
    }

    /// Adds the light of every lamp to the pixels; gives the number of shadow rays.
    pub fn shade(&mut self, wave: &WaveLight, sums: &mut [Rgb]) -> u64 {
        let &WaveLight { task, shadows, .. } = wave;
        let mut rays = 0;
        let accel = &task.scene.accel;
        for (index, light) in task.scene.lights.iter().enumerate() {
            let blocks = &mut self.blocks;
            rays += match (light.emission, shadows) {
                (Emission::Disc { position, radius }, Shadows::Cast) => {
                    let (disc, light) = ((position, radius), light.radiance);
                    accel.instructions.run(SoftLight { wave, index: index as u32, light, disc, blocks })
                }
                _ => accel.instructions.run(HardLight { wave, light, blocks }),
            };
        }
        for block in &self.blocks {
            for lane in 0..BLOCK {
                let [r, g, b] = &block.sum;
                sums[block.pixel[lane] as usize] += Rgb::new(r[lane], g[lane], b[lane]);
            }
        }
        rays
    }
}

/// Whether things stand in the light of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadows {
    /// They do.
    Cast,
    /// They do not (ray casting).
    None,
}

/// A wave that is to be lit.
pub struct WaveLight<'a> {
    pub task: &'a TileTask<'a>,
    /// Which sample of the pixels.
    pub sample: u32,
    pub shadows: Shadows,
    /// Where the surfaces are.
    pub surfaces: &'a [SurfaceBlock],
}

/// A lamp without size, or one taken for its middle where shadows do not count.
struct HardLight<'a> {
    wave: &'a WaveLight<'a>,
    light: &'a CompiledLight,
    blocks: &'a mut [LitBlock],
}

impl Kernel for HardLight<'_> {
    type Output = u64;

    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> u64 {
        let mut rays = 0;
        for (block, surfaces) in self.blocks.iter_mut().zip(self.wave.surfaces) {
            for start in (0..BLOCK).step_by(S::LANES) {
                let surface = SurfaceLanes::load(s, block, surfaces, start);
                let (wi, distance) = match self.light.emission {
                    Emission::Direction { travels } => (splat3(s, (-travels).into()), s.splat(f32::INFINITY)),
                    Emission::Point { position } | Emission::Disc { position, .. } => {
                        towards(s, &sub3(s, &splat3(s, position.into()), &surface.origin))
                    }
                    // Light from everywhere has no direction; `compile` keeps it apart.
                    Emission::Everywhere => return rays,
                };
                let (seen, scattered, highlight) = surface.phong(s, &wi);
                if !s.any(seen) {
                    continue;
                }
                let passes = match self.wave.shadows {
                    Shadows::None => s.splat(1.0),
                    Shadows::Cast => {
                        rays += u64::from(s.bits(seen).count_ones());
                        let t_max = s.select(seen, distance, s.splat(-1.0));
                        let packet = Packet::new(s, surface.origin, wi);
                        self.wave.task.scene.accel.packet_transmittance(s, &packet, t_max)
                    }
                };
                let dark = s.splat(0.0);
                let scattered = s.select(seen, s.mul(scattered, passes), dark);
                let highlight = s.select(seen, s.mul(highlight, passes), dark);
                add_light(s, block, start, [scattered, highlight], self.light.radiance);
            }
        }
        rays
    }
}

/// Surfaces in lanes.
#[derive(Clone, Copy)]
pub struct SurfaceLanes<S: Simd> {
    pub origin: [S::F; 3],
    pub n: [S::F; 3],
    pub ns: [S::F; 3],
    pub wo: [S::F; 3],
    pub diffuse: S::F,
    pub specular: S::F,
    pub shininess: S::F,
}

impl<S: Simd> SurfaceLanes<S> {
    #[inline(always)]
    fn load(s: S, block: &LitBlock, surfaces: &SurfaceBlock, start: usize) -> Self {
        Self {
            origin: load3(s, &surfaces.origin, start),
            n: load3(s, &surfaces.n, start),
            ns: load3(s, &surfaces.ns, start),
            wo: load3(s, &surfaces.wo, start),
            diffuse: s.load(&block.diffuse[start..]),
            specular: s.load(&block.specular[start..]),
            shininess: s.load(&block.shininess[start..]),
        }
    }

    /// One surface in all lanes.
    #[inline(always)]
    pub fn splat(s: S, block: &LitBlock, surfaces: &SurfaceBlock, lane: usize) -> Self {
        let at = |v: &[Column; 3]| [v[0][lane], v[1][lane], v[2][lane]];
        Self {
            origin: splat3(s, at(&surfaces.origin)),
            n: splat3(s, at(&surfaces.n)),
            ns: splat3(s, at(&surfaces.ns)),
            wo: splat3(s, at(&surfaces.wo)),
            diffuse: s.splat(block.diffuse[lane]),
            specular: s.splat(block.specular[lane]),
            shininess: s.splat(block.shininess[lane]),
        }
    }

    /// [`vitrine_optics::phong_light`] in lanes: where anything is lit at all, what is scattered, the highlight.
    #[inline(always)]
    pub fn phong(&self, s: S, wi: &[S::F; 3]) -> (S::M, S::F, S::F) {
        let zero = s.splat(0.0);
        let cos_l = dot(s, &self.ns, wi);
        // A lamp behind the form is hidden by the form itself, whatever the normal for shading says.
        let front = s.and(s.lt(zero, cos_l), s.lt(zero, dot(s, &self.n, wi)));
        let scattered = s.mul(self.diffuse, cos_l);
        // ⟨R, V⟩ = 2⟨N, L⟩⟨N, V⟩ − ⟨L, V⟩
        let double = s.mul(s.add(cos_l, cos_l), dot(s, &self.ns, &self.wo));
        let cos_r = s.min(s.sub(double, dot(s, wi, &self.wo)), s.splat(1.0));
        let shiny = s.and(front, s.and(s.lt(zero, cos_r), s.lt(zero, self.specular)));
        let highlight = if s.any(shiny) {
            s.select(shiny, s.mul(self.specular, s.pow_unit(cos_r, self.shininess)), zero)
        } else {
            zero
        };
        let lit = s.or(s.lt(zero, scattered), s.lt(zero, highlight));
        (s.and(front, lit), scattered, highlight)
    }
}

/// The unit directions and the distances of offsets.
#[inline(always)]
pub fn towards<S: Simd>(s: S, offset: &[S::F; 3]) -> ([S::F; 3], S::F) {
    let distance = s.sqrt(dot(s, offset, offset));
    let zero = s.splat(0.0);
    (along3(s, &[zero; 3], offset, s.div(s.splat(1.0), distance)), distance)
}

/// Adds light to surfaces: what is scattered takes their colour, highlights do not.
#[inline(always)]
fn add_light<S: Simd>(
    s: S,
    block: &mut LitBlock,
    start: usize,
    [scattered, highlight]: [S::F; 2],
    radiance: Rgb,
) {
    for (k, radiance) in radiance.to_array().into_iter().enumerate() {
        let seen = s.add(s.mul(s.load(&block.color[k][start..]), scattered), highlight);
        let sum = s.add(s.load(&block.sum[k][start..]), s.mul(seen, s.splat(radiance)));
        s.store(sum, &mut block.sum[k][start..]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::simd::Instructions;
    use vitrine_math::{Vec3, hash};
    use vitrine_optics::phong_light;

    struct Phong<'a>(&'a LitBlock, &'a SurfaceBlock, Vec3);

    impl Kernel for Phong<'_> {
        type Output = (Column, Column);

        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> (Column, Column) {
            let (mut scattered, mut highlight) = ([0.0; BLOCK], [0.0; BLOCK]);
            for start in (0..BLOCK).step_by(S::LANES) {
                let wi = splat3(s, self.2.into());
                let (seen, d, h) = SurfaceLanes::load(s, self.0, self.1, start).phong(s, &wi);
                s.store(s.select(seen, d, s.splat(0.0)), &mut scattered[start..]);
                s.store(s.select(seen, h, s.splat(0.0)), &mut highlight[start..]);
            }
            (scattered, highlight)
        }
    }

    /// C9: the lanes compute what `optics::phong_light`, the formula itself, says.
    #[test]
    fn c9_lanes_agree_with_the_formula() {
        let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
        let vector = |i: u32| Vec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2)).normalize();
        for round in 0..50 {
            let mut queue = LightQueue::default();
            queue.reset(BLOCK);
            let mut surfaces = SurfaceBlock::EMPTY;
            let mut all = Vec::new();
            for lane in 0..BLOCK {
                let i = round * 100 + lane as u32;
                let phong = PhongSurface {
                    color: Rgb::WHITE,
                    diffuse: number(i).abs(),
                    specular: if i.is_multiple_of(3) { 0.0 } else { number(i + 7).abs() },
                    shininess: 1.0 + 50.0 * number(i + 9).abs(),
                };
                let (n, wo) = (vector(2 * i), vector(2 * i + 1));
                let wo = if wo.dot(n) < 0.0 { -wo } else { wo };
                queue.put(lane, &Lit { phong, pixel: 0, weight: 1.0 }, Rgb::BLACK);
                for k in 0..3 {
                    (surfaces.n[k][lane], surfaces.ns[k][lane]) = (n[k], n[k]);
                    surfaces.wo[k][lane] = wo[k];
                }
                all.push((phong, n, wo));
            }
            let wi = vector(77_777 + round);
            for set in Instructions::available() {
                let (scattered, highlight) = set.run(Phong(&queue.blocks[0], &surfaces, wi));
                for (i, (phong, n, wo)) in all.iter().enumerate() {
                    let (d, h) = phong_light(phong, *n, wi, *wo);
                    assert!((scattered[i] - d).abs() < 1e-6, "{set:?}: {} against {d}", scattered[i]);
                    assert!((highlight[i] - h).abs() < 2e-5, "{set:?}: {} against {h}", highlight[i]);
                }
            }
        }
    }
}
