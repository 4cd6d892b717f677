//! Soft shadows: random points of a disc are tried, a round of sixteen at a time, until the shadow is good enough
//! (course work, section 2.6.1).

use super::TileTask;
use super::light::{Lamps, Lit, SurfaceLanes, towards};
use crate::accel::packet::{splat3, store3, sub3};
use crate::accel::rays::Rays;
use crate::accel::{BLOCK, Column, Packet};
use crate::samplers::SquareSampler;
use crate::surface::lanes_of;
use vitrine_math::{Vec3, warp};

/// Points of a lamp that are tried for one surface before its quality is looked at: whole packets, and stratified 4 × 4.
const ROUND: u32 = BLOCK as u32;

/// A disc lamp.
pub struct SoftLight<'a> {
    pub lamps: &'a Lamps<'a>,
    /// Which of the scene's lights.
    pub index: u32,
    /// The disc's middle and radius.
    pub disc: (Vec3, f32),
}

impl SoftLight<'_> {
    /// The light on surfaces of pixels, lane by lane: what is scattered and the highlight. Counts shadow rays.
    #[inline(always)]
    pub fn shine<S: Rays>(&self, s: S, lit: &Lit<S>, pixels: &[f32], rays: &mut u64) -> [S::F; 2] {
        let zero = s.splat(0.0);
        let SurfaceLanes { origin, n, ns, wo, diffuse, specular, shininess } = &lit.surface;
        let shines = s.or(s.lt(zero, *diffuse), s.lt(zero, *specular));
        let mut columns = [[[0.0; BLOCK]; 3]; 5];
        let [shading, others @ ..] = &mut columns;
        store3(s, &[*diffuse, *specular, *shininess], shading, 0);
        for (column, v) in others.iter_mut().zip([origin, n, ns, wo]) {
            store3(s, v, column, 0);
        }
        let (mut scattered, mut highlight) = ([0.0; BLOCK], [0.0; BLOCK]);
        for lane in lanes_of(s.bits(s.and(lit.mask, shines))) {
            let at = columns.map(|c| [c[0][lane], c[1][lane], c[2][lane]]);
            let [[diffuse, specular, shininess], origin, n, ns, wo] = at;
            let mut surface = SoftShadow::new(SurfaceLanes {
                origin: splat3(s, origin),
                n: splat3(s, n),
                ns: splat3(s, ns),
                wo: splat3(s, wo),
                diffuse: s.splat(diffuse),
                specular: s.splat(specular),
                shininess: s.splat(shininess),
            });
            surface.try_points(s, self, pixels[lane] as usize);
            *rays += u64::from(surface.rays);
            scattered[lane] = total(&surface.scattered) / surface.tried as f32;
            highlight[lane] = total(&surface.highlight) / surface.tried as f32;
        }
        [s.load(&scattered), s.load(&highlight)]
    }
}

/// A surface while points of a lamp are tried for it.
struct SoftShadow<S: Rays> {
    surface: SurfaceLanes<S>,
    /// What has come through, point by point of a round.
    scattered: Column,
    highlight: Column,
    /// Σ and Σ² of the share of light that passes, to tell the quality.
    passes: f32,
    passes2: f32,
    tried: u32,
    rays: u32,
}

impl<S: Rays> SoftShadow<S> {
    #[inline(always)]
    fn new(surface: SurfaceLanes<S>) -> Self {
        let zero = [0.0; BLOCK];
        Self { surface, scattered: zero, highlight: zero, passes: 0.0, passes2: 0.0, tried: 0, rays: 0 }
    }

    /// Tries points until the standard error is small enough or all are used.
    #[inline(always)]
    fn try_points(&mut self, s: S, light: &SoftLight, pixel: usize) {
        let TileTask { settings, tile, .. } = light.lamps.task;
        let [x, y] = light.lamps.order.place(pixel);
        let (x, y) = (tile.x + x, tile.y + y);
        let sampler = SquareSampler::new(y * settings.size[0] + x, light.index, settings.seed);
        // Whole rounds for each sample, so that every round is stratified.
        let first = light.lamps.sample.wrapping_mul(settings.shadow_points.next_multiple_of(ROUND));
        while self.tried < settings.shadow_points {
            let points = sampler.round(first.wrapping_add(self.tried));
            let count = ROUND.min(settings.shadow_points - self.tried);
            self.try_round(s, light, &points, count);
            self.tried += count;
            if self.standard_error() <= settings.shadow_error {
                return;
            }
        }
    }

    #[inline(always)]
    fn try_round(&mut self, s: S, light: &SoftLight, [u, v]: &[Column; 2], count: u32) {
        let (middle, radius) = light.disc;
        let (mut x, mut z, mut used) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        for i in 0..BLOCK {
            let p = warp::concentric_disk(vitrine_math::Vec2::new(u[i], v[i]));
            x[i] = middle.x + radius * p.x;
            z[i] = middle.z + radius * p.y;
            used[i] = if (i as u32) < count { 1.0 } else { 0.0 };
        }
        let mut share = [0.0; BLOCK];
        for start in (0..BLOCK).step_by(S::LANES) {
            let zero = s.splat(0.0);
            let on_disc = [s.load(&x[start..]), s.splat(middle.y), s.load(&z[start..])];
            let (wi, distance) = towards(s, &sub3(s, &on_disc, &self.surface.origin));
            let (seen, scattered, highlight) = self.surface.phong(s, &wi);
            let seen = s.and(seen, s.lt(zero, s.load(&used[start..])));
            if !s.any(seen) {
                continue;
            }
            self.rays += s.bits(seen).count_ones();
            let packet = Packet::new(s, self.surface.origin, wi);
            let t_max = s.select(seen, distance, s.splat(-1.0));
            let passes = light.lamps.task.scene.accel.packet_transmittance(s, &packet, t_max);
            let passes = s.select(seen, passes, zero);
            s.store(passes, &mut share[start..]);
            accumulate(s, &mut self.scattered[start..], s.select(seen, scattered, zero), passes);
            accumulate(s, &mut self.highlight[start..], s.select(seen, highlight, zero), passes);
        }
        self.passes += total(&share);
        self.passes2 += total(&share.map(|p| p * p));
    }

    /// The standard error of the share of light that passes. Two points more are counted, one that passes and one that does
    /// not, so that a few equal points do not pass for certainty (Laplace's rule of succession).
    #[inline(always)]
    fn standard_error(&self) -> f32 {
        let m = self.tried as f32 + 2.0;
        let mean = (self.passes + 1.0) / m;
        let variance = (self.passes2 + 1.0) / m - mean * mean;
        (variance.max(0.0) / self.tried as f32).sqrt()
    }
}

/// sum + a·b
#[inline(always)]
fn accumulate<S: Rays>(s: S, sum: &mut [f32], a: S::F, b: S::F) {
    s.store(s.add(s.load(sum), s.mul(a, b)), sum);
}

/// The sum of a column, always in the same order of pairs, so that it does not depend on the number of lanes.
#[inline(always)]
fn total(column: &Column) -> f32 {
    let (mut sums, mut width) = (*column, BLOCK / 2);
    while width > 0 {
        for i in 0..width {
            sums[i] += sums[i + width];
        }
        width /= 2;
    }
    sums[0]
}
