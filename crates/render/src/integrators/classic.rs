//! The classic renderer: recursive ray tracing with Phong's lighting (Whitted, "An Improved Illumination Model for Shaded
//! Display", CACM 23(6), 1980; course work, section 2), and ray casting as the case without secondary rays.
//!
//! At a surface of colour A, reflectivity r and α = 1 − transparency:
//!
//!   C = α·((1 − r)·A + r·mirrored) + (1 − α)·behind
//!
//! The recursion is unrolled into waves: all rays of a tile are traced together, each with the weight that its light has in
//! its pixel, and what they meet gives the next wave. So rays go in packets, and nothing depends on threads.

use super::TileTask;
use super::light::{LightQueue, Lit, Shadows, WaveLight};
use super::tile::{Sums, TileOrder};
use super::wave::{ErrandBlock, RayLanes, Wave, lanes_below};
use crate::accel::packet::{load3, select3, splat3};
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, HitBlock, HitStream, NOTHING, RayBlock};
use crate::compile::CompiledScene;
use crate::samplers::in_pixel;
use crate::surface::{HitLanes, Seen};
use vitrine_math::Rgb;

/// Light with less weight than this in its pixel is not followed: it is below a tenth of the smallest step of an 8-bit picture.
const MIN_WEIGHT: f32 = 2e-5;

/// So many surfaces a ray may pass on its way; then it sees the background.
const MAX_CROSSINGS: f32 = 1000.0;
/// A surface that bends the ray counts as so many: such a ray may be caught inside for ever.
const BEND: f32 = 10.0;

/// How far the light is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Mirror images, what is behind transparent surfaces, shadows.
    Recursive,
    /// The nearest surface alone.
    CameraOnly,
}

/// The waves of one thread.
#[derive(Debug, Default)]
pub struct Waves {
    order: TileOrder,
    now: Wave,
    onward: Wave,
    mirrored: Wave,
    hits: HitStream,
    lights: LightQueue,
    sums: Sums,
    picture: Vec<Rgb>,
}

impl Waves {
    /// The sums of a tile's samples, row by row, and the number of rays.
    pub fn fill(&mut self, task: &TileTask, reach: Reach) -> (&[Rgb], u64) {
        self.order.fit(&task.tile);
        self.sums.reset(task.tile.pixels());
        let mut rays = 0;
        for sample in task.samples.clone() {
            self.mirrored.clear();
            self.onward.clear();
            let (order, wave) = (&self.order, &mut self.onward);
            task.scene.accel.instructions.run(Start { task, sample, reach, order, wave });
            loop {
                // Onward rays first: they stay together with their neighbours.
                let next = if self.onward.rays().is_empty() { &mut self.mirrored } else { &mut self.onward };
                if next.rays().is_empty() {
                    break;
                }
                std::mem::swap(&mut self.now, next);
                next.clear();
                rays += self.trace(task, sample, reach);
            }
        }
        self.sums.show(&self.order, &mut self.picture);
        (&self.picture, rays)
    }

    /// Traces a wave; gives the number of rays.
    fn trace(&mut self, task: &TileTask, sample: u32, reach: Reach) -> u64 {
        let scene = task.scene;
        self.now.seal();
        scene.accel.closest(self.now.rays(), &mut self.hits);
        self.lights.clear();
        let Self { now, onward, mirrored, hits, lights, sums, .. } = self;
        let (now, hits) = (&*now, &*hits);
        scene.accel.instructions.run(Spread { scene, reach, now, hits, onward, mirrored, lights, sums });
        let shadows = match reach {
            Reach::CameraOnly => Shadows::None,
            Reach::Recursive => Shadows::Cast,
        };
        let wave = WaveLight { task, sample, shadows, order: &self.order };
        now.rays().len() as u64 + lights.shade(&wave, sums)
    }
}

/// The camera's rays.
struct Start<'a> {
    task: &'a TileTask<'a>,
    sample: u32,
    reach: Reach,
    order: &'a TileOrder,
    wave: &'a mut Wave,
}

impl Kernel for Start<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let TileTask { scene, settings, tile, .. } = self.task;
        // A single sample is the pixel's middle; in_pixel(0) is.
        let [dx, dy] = in_pixel(self.sample);
        let reflections = match self.reach {
            Reach::Recursive => settings.depth as f32,
            Reach::CameraOnly => 0.0,
        };
        let (zero, nothing) = (s.splat(0.0), s.splat(f32::from_bits(NOTHING)));
        let (left, top) = (s.splat(tile.x as f32), s.splat(tile.y as f32));
        let pixels = tile.pixels();
        for first in (0..pixels).step_by(S::LANES) {
            let [x, y] = self.order.lanes(s, first);
            let at = [s.add(s.add(left, x), s.splat(dx)), s.add(s.add(top, y), s.splat(dy))];
            let lanes = RayLanes {
                origin: splat3(s, scene.camera.position().into()),
                direction: scene.camera.directions(s, &at, settings.size),
                t_max: s.splat(f32::INFINITY),
                start: [zero, nothing, nothing],
                pixel: s.add(s.splat(first as f32), s.load(&super::wave::NUMBERS)),
                weight: s.splat(1.0),
                reflections: s.splat(reflections),
                crossings: zero,
            };
            self.wave.push(s, lanes_below(s, pixels - first), &lanes);
        }
    }
}

/// Shares the weight of each ray of a wave among the surface's own light, its mirror image and what is behind.
struct Spread<'a> {
    scene: &'a CompiledScene,
    reach: Reach,
    now: &'a Wave,
    hits: &'a HitStream,
    onward: &'a mut Wave,
    mirrored: &'a mut Wave,
    lights: &'a mut LightQueue,
    sums: &'a mut Sums,
}

impl Kernel for Spread<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(mut self, s: S) {
        let (now, all) = (self.now, self.hits);
        for (index, (rays, errands)) in now.rays().blocks().iter().zip(now.errands()).enumerate() {
            let hits = all.block(index);
            for start in (0..BLOCK).step_by(S::LANES) {
                self.spread(s, &Place { rays, hits, errands, start });
            }
        }
    }
}

/// Rays of a wave from a lane of their block on, with all that belongs to them.
struct Place<'a> {
    rays: &'a RayBlock,
    hits: &'a HitBlock,
    errands: &'a ErrandBlock,
    start: usize,
}

/// Parts of the weights of rays.
#[derive(Clone, Copy)]
struct Share<S: Simd> {
    /// Where it is worth following.
    mask: S::M,
    weight: S::F,
}

impl<S: Simd> Share<S> {
    #[inline(always)]
    fn new(s: S, hit: S::M, weight: S::F) -> Self {
        Self { mask: s.and(hit, s.lt(s.splat(MIN_WEIGHT), weight)), weight }
    }
}

impl Spread<'_> {
    #[inline(always)]
    fn spread<S: Simd>(&mut self, s: S, place: &Place) {
        let &Place { rays, hits, errands, start } = place;
        let zero = s.splat(0.0);
        let alive = s.lt(zero, s.load(&rays.t_max[start..]));
        let something = s.lt(s.load(&hits.primitive[start..]), s.splat(f32::from_bits(NOTHING)));
        let hit = s.and(alive, something);
        let weight = s.load(&errands.weight[start..]);
        self.escape(s, s.and_not(alive, hit), place, weight);
        if !s.any(hit) {
            return;
        }
        let seen = self.scene.seen(s, hit, &HitLanes { rays, hits, start });
        let reflections = s.load(&errands.reflections[start..]);
        let (transparency, mirror) = match self.reach {
            Reach::CameraOnly => (zero, zero),
            // At the end of the recursion a mirror shows its own colour.
            Reach::Recursive => {
                let left = s.lt(zero, reflections);
                (seen.look.transparency, s.select(left, seen.look.reflectivity, zero))
            }
        };
        let one = s.splat(1.0);
        let opaque = s.mul(weight, s.sub(one, transparency));
        let own = Share::new(s, hit, s.mul(opaque, s.sub(one, mirror)));
        let pixel = s.load(&errands.pixel[start..]);
        self.lights.push(s, own.mask, &Lit::new(s, &seen, pixel, own.weight));
        let reflected = Share::new(s, hit, s.mul(opaque, mirror));
        if s.any(reflected.mask) {
            self.mirror(s, reflected, place, &seen);
        }
        let through = Share::new(s, hit, s.mul(weight, transparency));
        if s.any(through.mask) {
            self.go_on(s, through, place, &seen);
        }
    }

    /// The light of the background.
    #[inline(always)]
    fn escape<S: Simd>(&mut self, s: S, mask: S::M, place: &Place, weight: S::F) {
        if s.any(mask) {
            let [r, g, b] = splat3(s, self.scene.background.to_array());
            let light = [s.mul(r, weight), s.mul(g, weight), s.mul(b, weight)];
            self.sums.add(s, mask, &place.errands.pixel[place.start..], &light);
        }
    }

    #[inline(always)]
    fn mirror<S: Simd>(&mut self, s: S, share: Share<S>, place: &Place, seen: &Seen<S>) {
        let &Place { errands, start, .. } = place;
        let leaving = seen.points.mirrored(s);
        let nothing = s.splat(f32::from_bits(NOTHING));
        let lanes = RayLanes {
            origin: leaving.origin,
            direction: leaving.direction,
            t_max: s.splat(f32::INFINITY),
            start: [s.splat(0.0), nothing, nothing],
            pixel: s.load(&errands.pixel[start..]),
            weight: share.weight,
            reflections: s.sub(s.load(&errands.reflections[start..]), s.splat(1.0)),
            crossings: s.load(&errands.crossings[start..]),
        };
        self.mirrored.push(s, share.mask, &lanes);
    }

    /// Behind what is transparent: straight on, or bent.
    #[inline(always)]
    fn go_on<S: Simd>(&mut self, s: S, share: Share<S>, place: &Place, seen: &Seen<S>) {
        let &Place { rays, hits, errands, start } = place;
        let crossings = s.load(&errands.crossings[start..]);
        let Share { mask, weight } = share;
        let tired = s.and(mask, s.le(s.splat(MAX_CROSSINGS), crossings));
        self.escape(s, tired, place, weight);
        let mask = s.and_not(mask, tired);
        let mut lanes = RayLanes {
            origin: load3(s, &rays.origin, start),
            direction: load3(s, &rays.direction, start),
            t_max: s.load(&rays.t_max[start..]),
            start: [
                s.load(&hits.t[start..]),
                s.load(&hits.primitive[start..]),
                s.load(&hits.triangle[start..]),
            ],
            pixel: s.load(&errands.pixel[start..]),
            weight,
            reflections: s.load(&errands.reflections[start..]),
            crossings: s.add(crossings, s.splat(1.0)),
        };
        let straight = s.eq(seen.look.refraction, s.splat(1.0));
        if s.any(s.and_not(mask, straight)) {
            let bent = seen.points.bent(s, seen.look.refraction);
            let nothing = s.splat(f32::from_bits(NOTHING));
            lanes.origin = select3(s, straight, &lanes.origin, &bent.origin);
            lanes.direction = select3(s, straight, &lanes.direction, &bent.direction);
            lanes.t_max = s.select(straight, lanes.t_max, s.splat(f32::INFINITY));
            lanes.start = select3(s, straight, &lanes.start, &[s.splat(0.0), nothing, nothing]);
            lanes.crossings = s.select(straight, lanes.crossings, s.add(crossings, s.splat(BEND)));
        }
        self.onward.push(s, mask, &lanes);
    }
}
