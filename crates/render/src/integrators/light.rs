//! The light of lamps on the surfaces of a wave, with shadows: hard ones by one ray, soft ones by rays to points of the lamp.
//!
//! Surfaces wait in blocks, a surface a lane. Their lighting, their shadow rays and the sums are worked out in lanes in one
//! go, so that no shadow ray is ever stored.

use super::TileTask;
use super::soft::SoftLight;
use super::tile::{Sums, TileOrder};
use super::wave::{Columns, Joining, lanes_below};
use crate::accel::packet::{dot, load3, scale3, splat3, sub3};
use crate::accel::rays::Rays;
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, Packet};
use crate::compile::CompiledLight;
use crate::surface::Seen;
use vitrine_scene::lights::Emission;

/// Sixteen surfaces that wait for light.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct LitBlock {
    /// Where shadow rays start.
    pub origin: [Column; 3],
    /// The unit normals of the forms, on the viewer's side.
    pub n: [Column; 3],
    /// The unit normals for shading.
    pub ns: [Column; 3],
    /// The unit directions to the viewer.
    pub wo: [Column; 3],
    pub color: [Column; 3],
    /// k_d and k_s, each times the weight of the surface's own light in its pixel; 0 in places without a surface.
    pub diffuse: Column,
    pub specular: Column,
    pub shininess: Column,
    /// The weight of the surface's own light in its pixel.
    pub weight: Column,
    /// The pixel, by its place in the tile's order.
    pub pixel: Column,
}

impl LitBlock {
    const DARK: Self = {
        let zero = [0.0; BLOCK];
        let zero3 = [zero; 3];
        Self {
            origin: zero3,
            n: zero3,
            ns: zero3,
            wo: zero3,
            color: zero3,
            diffuse: zero,
            specular: zero,
            shininess: zero,
            weight: zero,
            pixel: zero,
        }
    };
}

impl Columns<20> for LitBlock {
    #[inline(always)]
    fn columns(&mut self) -> [&mut Column; 20] {
        let ([ox, oy, oz], [nx, ny, nz]) = (&mut self.origin, &mut self.n);
        let ([sx, sy, sz], [wx, wy, wz]) = (&mut self.ns, &mut self.wo);
        let ([r, g, b], d, s) = (&mut self.color, &mut self.diffuse, &mut self.specular);
        let (shininess, weight, pixel) = (&mut self.shininess, &mut self.weight, &mut self.pixel);
        [ox, oy, oz, nx, ny, nz, sx, sy, sz, wx, wy, wz, r, g, b, d, s, shininess, weight, pixel]
    }
}

/// Surfaces that wait for light, in lanes: the columns of a [`LitBlock`].
#[derive(Clone, Copy)]
pub struct Lit<S: Simd>([S::F; 20]);

impl<S: Simd> Lit<S> {
    /// What is seen in pixels, its own light with those weights.
    #[inline(always)]
    pub fn new(s: S, seen: &Seen<S>, pixel: S::F, weight: S::F) -> Self {
        let Seen { points, look } = seen;
        let ([ox, oy, oz], [nx, ny, nz]) = (points.origin(s), points.n);
        let ([sx, sy, sz], [wx, wy, wz], [r, g, b]) = (points.ns, points.wo, look.color);
        let (d, k) = (s.mul(look.diffuse, weight), s.mul(look.specular, weight));
        Self([ox, oy, oz, nx, ny, nz, sx, sy, sz, wx, wy, wz, r, g, b, d, k, look.shininess, weight, pixel])
    }
}

/// The surfaces of a wave that wait for light.
#[derive(Debug, Default)]
pub struct LightQueue {
    blocks: Vec<LitBlock>,
    len: usize,
}

impl LightQueue {
    /// Takes all surfaces out.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds the chosen lanes.
    #[inline(always)]
    pub fn push<S: Simd>(&mut self, s: S, chosen: S::M, lit: &Lit<S>) {
        let joining = Joining::new(s, chosen, self.len);
        if joining.end() == self.len {
            return;
        }
        self.len = joining.end();
        let blocks = self.len.div_ceil(BLOCK);
        if self.blocks.len() < blocks {
            self.blocks.resize(blocks, LitBlock::DARK);
        }
        joining.write(s, &lit.0, &mut self.blocks);
    }

    /// Adds the light of every lamp to the pixels; gives the number of shadow rays.
    pub fn shade(&mut self, wave: &WaveLight, sums: &mut Sums) -> u64 {
        if self.len == 0 {
            return 0;
        }
        let blocks = &mut self.blocks[..self.len.div_ceil(BLOCK)];
        if let Some(last) = blocks.last_mut() {
            let used = (self.len - 1) % BLOCK + 1;
            last.diffuse[used..].fill(0.0);
            last.specular[used..].fill(0.0);
        }
        wave.task.scene.accel.instructions.run(Lighting { wave, blocks, len: self.len, sums })
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
    /// Where the pixels are.
    pub order: &'a TileOrder,
}

/// Surfaces on the way into the light.
struct Lighting<'a> {
    wave: &'a WaveLight<'a>,
    blocks: &'a [LitBlock],
    len: usize,
    sums: &'a mut Sums,
}

impl Kernel for Lighting<'_> {
    type Output = u64;

    #[inline(always)]
    fn run<S: Rays>(self, s: S) -> u64 {
        let scene = self.wave.task.scene;
        let ambient = splat3(s, scene.ambient.to_array());
        let mut rays = 0;
        for first in (0..self.len).step_by(S::LANES) {
            let (block, start) = (&self.blocks[first / BLOCK], first % BLOCK);
            let surface = SurfaceLanes::load(s, block, start);
            let color = load3(s, &block.color, start);
            let weight = s.load(&block.weight[start..]);
            let mut sum = scale3(s, &mul3(s, &color, &ambient), weight);
            for (index, light) in scene.lights.iter().enumerate() {
                let (radiance, wave) = (light.radiance, self.wave);
                let factors = match (light.emission, wave.shadows) {
                    (Emission::Disc { position, radius }, Shadows::Cast) => {
                        let light = SoftLight { wave, index: index as u32, disc: (position, radius) };
                        light.shine(s, block, start, &mut rays)
                    }
                    _ => wave.shine(s, light, &surface, &mut rays),
                };
                if let Some([scattered, highlight]) = factors {
                    // What is scattered takes the surface's colour, highlights do not.
                    for (k, radiance) in radiance.to_array().into_iter().enumerate() {
                        let seen = s.add(s.mul(color[k], scattered), highlight);
                        sum[k] = s.add(sum[k], s.mul(seen, s.splat(radiance)));
                    }
                }
            }
            self.sums.add(s, lanes_below(s, self.len - first), &block.pixel[start..], &sum);
        }
        rays
    }
}

impl WaveLight<'_> {
    /// The light of a lamp without size, or of one taken for its middle where shadows do not count: what is scattered and the
    /// highlight, or None when it shines on nothing.
    #[inline(always)]
    fn shine<S: Rays>(
        &self,
        s: S,
        light: &CompiledLight,
        surface: &SurfaceLanes<S>,
        rays: &mut u64,
    ) -> Option<[S::F; 2]> {
        let (wi, distance) = match light.emission {
            Emission::Direction { travels } => (splat3(s, (-travels).into()), s.splat(f32::INFINITY)),
            Emission::Point { position } | Emission::Disc { position, .. } => {
                towards(s, &sub3(s, &splat3(s, position.into()), &surface.origin))
            }
            // Light from everywhere has no direction; `compile` keeps it apart.
            Emission::Everywhere => return None,
        };
        let (seen, scattered, highlight) = surface.phong(s, &wi);
        if !s.any(seen) {
            return None;
        }
        let passes = match self.shadows {
            Shadows::None => s.splat(1.0),
            Shadows::Cast => {
                *rays += u64::from(s.bits(seen).count_ones());
                let t_max = s.select(seen, distance, s.splat(-1.0));
                let packet = Packet::new(s, surface.origin, wi);
                self.task.scene.accel.packet_transmittance(s, &packet, t_max)
            }
        };
        let dark = s.splat(0.0);
        let scattered = s.select(seen, s.mul(scattered, passes), dark);
        Some([scattered, s.select(seen, s.mul(highlight, passes), dark)])
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
    fn load(s: S, block: &LitBlock, start: usize) -> Self {
        Self {
            origin: load3(s, &block.origin, start),
            n: load3(s, &block.n, start),
            ns: load3(s, &block.ns, start),
            wo: load3(s, &block.wo, start),
            diffuse: s.load(&block.diffuse[start..]),
            specular: s.load(&block.specular[start..]),
            shininess: s.load(&block.shininess[start..]),
        }
    }

    /// One surface in all lanes.
    #[inline(always)]
    pub fn splat(s: S, block: &LitBlock, lane: usize) -> Self {
        let at = |v: &[Column; 3]| [v[0][lane], v[1][lane], v[2][lane]];
        Self {
            origin: splat3(s, at(&block.origin)),
            n: splat3(s, at(&block.n)),
            ns: splat3(s, at(&block.ns)),
            wo: splat3(s, at(&block.wo)),
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
    (scale3(s, offset, s.div(s.splat(1.0), distance)), distance)
}

/// The products of components.
#[inline(always)]
fn mul3<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> [S::F; 3] {
    [s.mul(a[0], b[0]), s.mul(a[1], b[1]), s.mul(a[2], b[2])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::simd::Instructions;
    use vitrine_math::{Rgb, Vec3, hash};
    use vitrine_optics::{PhongSurface, phong_light};

    struct Phong<'a>(&'a LitBlock, Vec3);

    impl Kernel for Phong<'_> {
        type Output = (Column, Column);

        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> (Column, Column) {
            let (mut scattered, mut highlight) = ([0.0; BLOCK], [0.0; BLOCK]);
            for start in (0..BLOCK).step_by(S::LANES) {
                let wi = splat3(s, self.1.into());
                let (seen, d, h) = SurfaceLanes::load(s, self.0, start).phong(s, &wi);
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
            let mut block = LitBlock::DARK;
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
                for k in 0..3 {
                    (block.n[k][lane], block.ns[k][lane], block.wo[k][lane]) = (n[k], n[k], wo[k]);
                }
                (block.diffuse[lane], block.specular[lane]) = (phong.diffuse, phong.specular);
                block.shininess[lane] = phong.shininess;
                all.push((phong, n, wo));
            }
            let wi = vector(77_777 + round);
            for set in Instructions::available() {
                let (scattered, highlight) = set.run(Phong(&block, wi));
                for (i, (phong, n, wo)) in all.iter().enumerate() {
                    let (d, h) = phong_light(phong, *n, wi, *wo);
                    assert!((scattered[i] - d).abs() < 1e-6, "{set:?}: {} against {d}", scattered[i]);
                    assert!((highlight[i] - h).abs() < 2e-5, "{set:?}: {} against {h}", highlight[i]);
                }
            }
        }
    }
}
