//! What lies under a pixel: the object, the point and its normal, by the same kernels that make the picture.

use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, Hit, HitStream, NOTHING, RayBlock, RayStream};
use crate::compile::{CompiledCamera, CompiledScene};
use crate::surface::HitLanes;
use crate::threads;
use std::sync::{Mutex, PoisonError};
use vitrine_math::{Ray, Vec3};

/// "No object", in a map of objects.
pub const NO_OBJECT: u32 = u32::MAX;

/// So many transparent surfaces one looks through.
const MOST_SURFACES: usize = 32;

/// The nearest surface on a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// The object's index in the scene's list.
    pub object: usize,
    /// Where the ray meets it. World space, metres.
    pub point: Vec3,
    /// From the ray's start, metres.
    pub distance: f32,
    /// The unit normal, on the side from which the ray comes.
    pub n: Vec3,
}

impl CompiledScene {
    /// The camera's ray through a point of a picture of that size, counted in pixels from its upper left corner. Its direction is
    /// of unit length.
    #[must_use]
    pub fn camera_ray(&self, point: [f32; 2], size: [u32; 2]) -> Ray {
        let direction = self.accel.instructions.run(Through { camera: &self.camera, point, size });
        Ray::new(self.camera.position(), direction)
    }

    /// What the camera sees first in a point of a picture of that size; what is transparent counts like all else. None
    /// where there is nothing.
    #[must_use]
    pub fn pick(&self, point: [f32; 2], size: [u32; 2]) -> Option<Picked> {
        self.ray_hit(&self.camera_ray(point, size))
    }

    /// All objects that the camera sees in a point of a picture of that size, the nearest first: those behind others as far as
    /// these are transparent. Each where it is met first; straight on, as if nothing bent the ray.
    #[must_use]
    pub fn pick_through(&self, point: [f32; 2], size: [u32; 2]) -> Vec<Picked> {
        let ray = self.camera_ray(point, size);
        let mut seen: Vec<Picked> = Vec::new();
        let mut last = None;
        for _ in 0..MOST_SURFACES {
            let Some((hit, picked)) = self.next_hit(&ray, last.as_ref()) else { break };
            if seen.iter().all(|p| p.object != picked.object) {
                seen.push(picked);
            }
            if !self.is_transparent(&hit) {
                break;
            }
            last = Some(hit);
        }
        seen
    }

    /// The nearest surface on a ray; None when there is none or the ray has no direction.
    #[must_use]
    pub fn ray_hit(&self, ray: &Ray) -> Option<Picked> {
        let length = ray.direction.length();
        let direction = ray.direction.try_normalize()?;
        let ray = Ray { direction, t_max: ray.t_max * length, ..*ray };
        self.next_hit(&ray, None).map(|(_, picked)| picked)
    }

    /// The nearest surface on a ray of unit direction after an earlier hit of it.
    fn next_hit(&self, ray: &Ray, after: Option<&Hit>) -> Option<(Hit, Picked)> {
        let mut rays = RayStream::default();
        match after {
            None => rays.push(ray),
            Some(hit) => rays.push_on(ray, hit),
        }
        let mut hits = HitStream::default();
        self.accel.closest(&rays, &mut hits);
        let hit = hits.get(0)?;
        let at = HitLanes { rays: &rays.blocks()[0], hits: hits.block(0), start: 0 };
        let [point, n] = self.accel.instructions.run(Meet { scene: self, at });
        let object = self.primitives[hit.primitive as usize].object as usize;
        Some((hit, Picked { object, point, distance: hit.t, n }))
    }

    fn is_transparent(&self, hit: &Hit) -> bool {
        let material = self.primitives[hit.primitive as usize].material_of(hit.triangle);
        self.materials[material as usize].transparency > 0.0
    }

    /// The object that is seen first in the middle of each pixel, row by row: its index in the scene's list, or [`NO_OBJECT`].
    /// On so many threads (0: all of the machine's).
    #[must_use]
    pub fn object_map(&self, size: [u32; 2], threads: usize) -> Vec<u32> {
        self.map(size, threads, &|hit| Some(self.primitives[hit.primitive as usize].object))
    }

    /// The same with what is seen behind all that is transparent.
    #[must_use]
    pub fn object_map_behind_glass(&self, size: [u32; 2], threads: usize) -> Vec<u32> {
        let opaque =
            |hit: &Hit| (!self.is_transparent(hit)).then(|| self.primitives[hit.primitive as usize].object);
        self.map(size, threads, &opaque)
    }

    /// Says something of each pixel by what its ray hits first of which there is something to say.
    fn map(&self, size: [u32; 2], threads: usize, say: &(dyn Fn(&Hit) -> Option<u32> + Sync)) -> Vec<u32> {
        let [width, height] = size.map(|v| v as usize);
        let mut map = vec![NO_OBJECT; width * height];
        if map.is_empty() {
            return map;
        }
        let threads = threads::meant_by(threads);
        let rows = Mutex::new(map.chunks_mut(width).enumerate());
        let next = || rows.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = || {
            let mut tools = RowTools::default();
            while let Some((y, row)) = next() {
                let blocks = tools.rays.resize(width);
                self.accel.instructions.run(Row { camera: &self.camera, y, size, blocks });
                self.map_row(&mut tools, row, say);
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..threads.min(height) {
                scope.spawn(work);
            }
            work();
        });
        map
    }

    /// Traces the rays of a row until there is something to say of each.
    fn map_row(&self, tools: &mut RowTools, row: &mut [u32], say: &dyn Fn(&Hit) -> Option<u32>) {
        let RowTools { rays, onward, hits, places, later } = tools;
        places.clear();
        places.extend(0..row.len());
        for _ in 0..MOST_SURFACES {
            self.accel.closest(rays, hits);
            onward.clear();
            later.clear();
            for (i, &place) in places.iter().enumerate() {
                let Some(hit) = hits.get(i) else { continue };
                match say(&hit) {
                    Some(said) => row[place] = said,
                    None => {
                        onward.push_on(&rays.get(i), &hit);
                        later.push(place);
                    }
                }
            }
            if later.is_empty() {
                return;
            }
            std::mem::swap(rays, onward);
            std::mem::swap(places, later);
        }
    }
}

/// What a thread needs to trace rows of pixels.
#[derive(Default)]
struct RowTools {
    rays: RayStream,
    onward: RayStream,
    hits: HitStream,
    /// The pixels of the rays.
    places: Vec<usize>,
    later: Vec<usize>,
}

/// The direction through one point.
struct Through<'a> {
    camera: &'a CompiledCamera,
    point: [f32; 2],
    size: [u32; 2],
}

impl Kernel for Through<'_> {
    type Output = Vec3;

    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> Vec3 {
        let at = self.point.map(|v| s.splat(v));
        first_lane(s, &self.camera.directions(s, &at, self.size))
    }
}

/// The camera rays of a row of pixels.
struct Row<'a> {
    camera: &'a CompiledCamera,
    y: usize,
    size: [u32; 2],
    blocks: &'a mut [RayBlock],
}

impl Kernel for Row<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let y = s.splat(self.y as f32 + 0.5);
        let nothing = f32::from_bits(NOTHING);
        for (first, block) in (0..).step_by(BLOCK).zip(self.blocks) {
            let middles: Column = std::array::from_fn(|lane| (first + lane) as f32 + 0.5);
            for start in (0..BLOCK).step_by(S::LANES) {
                let d = self.camera.directions(s, &[s.load(&middles[start..]), y], self.size);
                for (column, d) in block.direction.iter_mut().zip(d) {
                    s.store(d, &mut column[start..]);
                }
            }
            block.origin = self.camera.position().to_array().map(|v| [v; BLOCK]);
            // Beyond the end of the row there is no ray.
            block.t_max = middles.map(|x| if x < self.size[0] as f32 { f32::INFINITY } else { -1.0 });
            block.start_t = [0.0; BLOCK];
            block.start_primitive = [nothing; BLOCK];
            block.start_triangle = [nothing; BLOCK];
        }
    }
}

/// Where the ray of the first lane meets its surface, and the normal there.
struct Meet<'a> {
    scene: &'a CompiledScene,
    at: HitLanes<'a>,
}

impl Kernel for Meet<'_> {
    type Output = [Vec3; 2];

    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> [Vec3; 2] {
        let first = crate::integrators::lanes_below(s, 1);
        let points = self.scene.seen(s, first, &self.at).points;
        [first_lane(s, &points.p), first_lane(s, &points.n)]
    }
}

#[inline(always)]
fn first_lane<S: Simd>(s: S, v: &[S::F; 3]) -> Vec3 {
    Vec3::from_array([0, 1, 2].map(|k| {
        let mut column = [0.0; BLOCK];
        s.store(v[k], &mut column);
        column[0]
    }))
}
