//! The light of lamps on the surfaces of a wave, with shadows: hard ones by one ray, soft ones by rays to points of the lamp.

use super::TileTask;
use crate::accel::RayStream;
use crate::compile::{CompiledLight, CompiledScene};
use crate::samplers::SquareSampler;
use vitrine_math::{Ray, Rgb, Vec3, offset_origin, warp};
use vitrine_optics::{PhongSurface, phong_light};
use vitrine_scene::lights::Emission;

/// A point of a surface that waits for light.
#[derive(Clone, Copy, Debug)]
pub struct Lit {
    /// The point. World space.
    pub p: Vec3,
    /// The unit normal of the form, on the viewer's side.
    pub n: Vec3,
    /// The unit normal for shading.
    pub ns: Vec3,
    /// The unit direction to the viewer.
    pub wo: Vec3,
    /// The surface.
    pub phong: PhongSurface,
    /// The pixel, by its place in the tile.
    pub pixel: u32,
    /// How much of its light reaches the pixel.
    pub weight: f32,
}

/// Points of a lamp that are tried for one surface before its quality is looked at: a full packet, and a whole stratification.
const ROUND: u32 = 16;

/// The surfaces of a wave and the shadow rays for them.
#[derive(Debug, Default)]
pub struct LightQueue {
    lit: Vec<Lit>,
    shadows: RayStream,
    /// What each shadow ray brings if nothing is in its way, and to which pixel or surface.
    brings: Vec<(u32, Rgb)>,
    passes: Vec<f32>,
    soft: Vec<Soft>,
}

/// A surface in the light of a lamp with size, while points are tried.
#[derive(Clone, Copy, Debug)]
struct Soft {
    lit: u32,
    sum: Rgb,
    /// Σ and Σ² of how much light passes, to tell the quality.
    passes: f32,
    passes2: f32,
}

impl LightQueue {
    pub fn clear(&mut self) {
        self.lit.clear();
    }

    #[inline(always)]
    pub fn push(&mut self, lit: Lit) {
        self.lit.push(lit);
    }

    /// Adds the light of every lamp to the pixels, without shadows. Shoots no ray.
    pub fn shade_unshadowed(&mut self, scene: &CompiledScene, sums: &mut [Rgb]) -> u64 {
        for light in &scene.lights {
            for lit in &self.lit {
                let (wi, _) = towards(&light.emission, lit.p);
                sums[lit.pixel as usize] += light.on(lit, wi);
            }
        }
        0
    }

    /// Adds the light of every lamp to the pixels, as far as it passes; gives the number of shadow rays.
    pub fn shade(&mut self, task: &TileTask, sample: u32, sums: &mut [Rgb]) -> u64 {
        let mut rays = 0;
        for (index, light) in task.scene.lights.iter().enumerate() {
            rays += match light.emission {
                Emission::Disc { .. } => self.shade_soft(task, sample, index as u32, sums),
                _ => self.shade_hard(task.scene, light, sums),
            };
        }
        rays
    }

    fn shade_hard(&mut self, scene: &CompiledScene, light: &CompiledLight, sums: &mut [Rgb]) -> u64 {
        self.shadows.clear();
        self.brings.clear();
        for lit in &self.lit {
            // A lamp behind the form is hidden by the form itself.
            let origin = offset_origin(lit.p, lit.n);
            let (wi, distance) = towards(&light.emission, origin);
            if wi.dot(lit.n) <= 0.0 {
                continue;
            }
            let brings = light.on(lit, wi);
            if brings != Rgb::BLACK {
                self.shadows.push(&Ray { origin, direction: wi, t_max: distance });
                self.brings.push((lit.pixel, brings));
            }
        }
        scene.accel.transmittance(&mut self.shadows, &mut self.passes);
        for ((pixel, brings), passes) in self.brings.iter().zip(&self.passes) {
            sums[*pixel as usize] += *brings * *passes;
        }
        self.brings.len() as u64
    }

    /// Tries points of a disc, a round at a time, until each surface's standard error is small enough or all points are used.
    fn shade_soft(&mut self, task: &TileTask, sample: u32, index: u32, sums: &mut [Rgb]) -> u64 {
        let points = task.settings.shadow_points;
        let start = |lit| Soft { lit, sum: Rgb::BLACK, passes: 0.0, passes2: 0.0 };
        self.soft.clear();
        self.soft.extend((0..self.lit.len() as u32).map(start));
        let (mut rays, mut tried) = (0, 0);
        while tried < points && !self.soft.is_empty() {
            let round = tried..(tried + ROUND).min(points);
            rays += self.try_points(task, sample, index, round.clone());
            tried = round.end;
            let (lit, allowed) = (&self.lit, task.settings.shadow_error);
            self.soft.retain(|soft| {
                let is_done = tried >= points || soft.standard_error(tried) <= allowed;
                if is_done {
                    let pixel = lit[soft.lit as usize].pixel;
                    sums[pixel as usize] += soft.sum / tried as f32;
                }
                !is_done
            });
        }
        rays
    }

    /// One round of points for every surface that is not done.
    fn try_points(&mut self, task: &TileTask, sample: u32, index: u32, round: std::ops::Range<u32>) -> u64 {
        let light = &task.scene.lights[index as usize];
        let Emission::Disc { position, radius } = light.emission else { return 0 };
        self.shadows.clear();
        self.brings.clear();
        for (place, soft) in self.soft.iter().enumerate() {
            let lit = &self.lit[soft.lit as usize];
            let origin = offset_origin(lit.p, lit.n);
            let tile = task.tile;
            let (x, y) = (tile.x + lit.pixel % tile.width, tile.y + lit.pixel / tile.width);
            let sampler = SquareSampler::new(y * task.settings.size[0] + x, index, task.settings.seed);
            for point in round.clone() {
                let u = sampler.point(sample.wrapping_mul(task.settings.shadow_points).wrapping_add(point));
                let on_disc = warp::concentric_disk(u) * radius;
                let (wi, distance) = along(position + Vec3::new(on_disc.x, 0.0, on_disc.y) - origin);
                let brings = if wi.dot(lit.n) > 0.0 { light.on(lit, wi) } else { Rgb::BLACK };
                if brings != Rgb::BLACK {
                    self.shadows.push(&Ray { origin, direction: wi, t_max: distance });
                    self.brings.push((place as u32, brings));
                }
            }
        }
        task.scene.accel.transmittance(&mut self.shadows, &mut self.passes);
        for ((place, brings), passes) in self.brings.iter().zip(&self.passes) {
            let soft = &mut self.soft[*place as usize];
            soft.sum += *brings * *passes;
            soft.passes += passes;
            soft.passes2 += passes * passes;
        }
        self.brings.len() as u64
    }
}

impl Soft {
    /// The standard error of the share of light that passes, after n points. Two points more are counted, one that passes
    /// and one that does not, so that a few equal points do not pass for certainty (Laplace's rule of succession).
    fn standard_error(&self, n: u32) -> f32 {
        let m = n as f32 + 2.0;
        let mean = (self.passes + 1.0) / m;
        let variance = ((self.passes2 + 1.0) / m - mean * mean).max(0.0);
        (variance / n as f32).sqrt()
    }
}

impl CompiledLight {
    /// The light that a lamp in direction `wi` brings to a surface's pixel if nothing is in its way.
    #[inline(always)]
    fn on(&self, lit: &Lit, wi: Vec3) -> Rgb {
        let (scattered, highlight) = phong_light(&lit.phong, lit.ns, wi, lit.wo);
        (lit.phong.color * scattered + Rgb::splat(highlight)) * self.radiance * lit.weight
    }
}

/// The unit direction from a point to a lamp's middle, and how far it is.
#[inline(always)]
fn towards(emission: &Emission, from: Vec3) -> (Vec3, f32) {
    match emission {
        Emission::Point { position } | Emission::Disc { position, .. } => along(*position - from),
        Emission::Direction { travels } => (-*travels, f32::INFINITY),
        // Light from everywhere has no direction; it never comes here (see `compile`).
        Emission::Everywhere => (Vec3::ZERO, 0.0),
    }
}

#[inline(always)]
fn along(offset: Vec3) -> (Vec3, f32) {
    let distance = offset.length();
    (offset / distance, distance)
}
