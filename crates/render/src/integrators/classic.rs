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
use super::light::{Lamps, Lit, Shadows};
use super::tile::{Sums, TileOrder};
use super::wave::{ErrandBlock, RayLanes, Wave, lanes_below};
use crate::accel::packet::{along3, load3, select3, splat3};
use crate::accel::rays::Rays;
use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, HitBlock, HitStream, NOTHING, RayBlock};
use crate::compile::CompiledScene;
use crate::job::Cancel;
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
    sums: Sums,
    picture: Vec<Rgb>,
}

impl Waves {
    /// The sums of a tile's samples, row by row, and the number of rays. None when it was cancelled between two samples.
    pub fn fill(&mut self, task: &TileTask, reach: Reach, cancel: &Cancel) -> Option<(&[Rgb], u64)> {
        self.order.fit(&task.tile);
        self.sums.reset(task.tile.pixels());
        let mut rays = 0;
        for sample in task.samples.clone() {
            if cancel.is_cancelled() {
                return None;
            }
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
        Some((&self.picture, rays))
    }

    /// Traces a wave; gives the number of rays.
    fn trace(&mut self, task: &TileTask, sample: u32, reach: Reach) -> u64 {
        self.now.seal();
        task.scene.accel.closest(self.now.rays(), &mut self.hits);
        let shadows = match reach {
            Reach::CameraOnly => Shadows::None,
            Reach::Recursive => Shadows::Cast,
        };
        let Self { order, now, onward, mirrored, hits, sums, .. } = self;
        let lamps = Lamps { task, sample, shadows, order };
        let spread = Spread { scene: task.scene, reach, now, hits, lamps, onward, mirrored, sums };
        now.rays().len() as u64 + task.scene.accel.instructions.run(spread)
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
    lamps: Lamps<'a>,
    onward: &'a mut Wave,
    mirrored: &'a mut Wave,
    sums: &'a mut Sums,
}

impl Kernel for Spread<'_> {
    /// The number of shadow rays.
    type Output = u64;

    #[inline(always)]
    fn run<S: Rays>(mut self, s: S) -> u64 {
        let mut shadow_rays = 0;
        let (now, all) = (self.now, self.hits);
        for (index, (rays, errands)) in now.rays().blocks().iter().zip(now.errands()).enumerate() {
            let hits = all.block(index);
            for start in (0..BLOCK).step_by(S::LANES) {
                self.spread(s, &Place { rays, hits, errands, start }, &mut shadow_rays);
            }
        }
        shadow_rays
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

/// What becomes of the weights of rays at surfaces.
#[derive(Clone, Copy)]
struct Shares<S: Simd> {
    /// For the surface's own light.
    own: Share<S>,
    /// For its mirror image.
    reflected: Share<S>,
    /// For what is behind.
    through: Share<S>,
}

impl Spread<'_> {
    #[inline(always)]
    fn spread<S: Rays>(&mut self, s: S, place: &Place, shadow_rays: &mut u64) {
        let &Place { rays, hits, errands, start } = place;
        let zero = s.splat(0.0);
        let alive = s.lt(zero, s.load(&rays.t_max[start..]));
        let something = s.lt(s.load(&hits.primitive[start..]), s.splat(f32::from_bits(NOTHING)));
        let hit = s.and(alive, something);
        let weight = s.load(&errands.weight[start..]);
        // The weight of the background.
        let mut beyond = s.select(something, zero, weight);
        let mut light = [zero; 3];
        if s.any(hit) {
            let seen = self.scene.seen(s, hit, &HitLanes { rays, hits, start });
            let shares = self.shares(s, hit, place, &seen);
            if s.any(shares.reflected.mask) {
                self.mirror(s, shares.reflected, place, &seen);
            }
            if s.any(shares.through.mask) {
                beyond = s.add(beyond, self.go_on(s, shares.through, place, &seen));
            }
            let Share { mask, weight } = shares.own;
            if s.any(mask) {
                let lit = Lit::new(s, mask, &seen, weight);
                let own = self.lamps.light(s, &lit, &errands.pixel[start..], shadow_rays);
                light = select3(s, mask, &own, &light);
            }
        }
        // All that a lane has for its pixel at once, so that the order of sums does not depend on the number of lanes.
        let background = splat3(s, self.scene.background.to_array());
        let light = along3(s, &light, &background, beyond);
        self.sums.add(s, alive, &errands.pixel[start..], &light);
    }

    /// Shares the weights of rays.
    #[inline(always)]
    fn shares<S: Simd>(&self, s: S, hit: S::M, place: &Place, seen: &Seen<S>) -> Shares<S> {
        let (zero, one) = (s.splat(0.0), s.splat(1.0));
        let (transparency, mirror) = match self.reach {
            Reach::CameraOnly => (zero, zero),
            // At the end of the recursion a mirror shows its own colour.
            Reach::Recursive => {
                let left = s.lt(zero, s.load(&place.errands.reflections[place.start..]));
                (seen.look.transparency, s.select(left, seen.look.reflectivity, zero))
            }
        };
        let weight = s.load(&place.errands.weight[place.start..]);
        let opaque = s.mul(weight, s.sub(one, transparency));
        Shares {
            own: Share::new(s, hit, s.mul(opaque, s.sub(one, mirror))),
            reflected: Share::new(s, hit, s.mul(opaque, mirror)),
            through: Share::new(s, hit, s.mul(weight, transparency)),
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

    /// Behind what is transparent: straight on, or bent. Gives the weights of those rays that go no farther.
    #[inline(always)]
    fn go_on<S: Simd>(&mut self, s: S, share: Share<S>, place: &Place, seen: &Seen<S>) -> S::F {
        let &Place { rays, hits, errands, start } = place;
        let crossings = s.load(&errands.crossings[start..]);
        let Share { mask, weight } = share;
        let tired = s.and(mask, s.le(s.splat(MAX_CROSSINGS), crossings));
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
        s.select(tired, weight, s.splat(0.0))
    }
}
