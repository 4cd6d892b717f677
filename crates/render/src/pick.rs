//! What lies under a pixel: the object, the point and its normal, by the same kernels that make the picture.

use crate::accel::simd::{Kernel, Simd};
use crate::accel::{BLOCK, Column, HitStream, NOTHING, RayBlock, RayStream};
use crate::compile::{CompiledCamera, CompiledScene};
use crate::surface::HitLanes;
use std::sync::{Mutex, PoisonError};
use vitrine_math::{Ray, Vec3};

/// "No object", in a map of objects.
pub const NO_OBJECT: u32 = u32::MAX;

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

    /// The nearest surface on a ray; None when there is none or the ray has no direction.
    #[must_use]
    pub fn ray_hit(&self, ray: &Ray) -> Option<Picked> {
        let length = ray.direction.length();
        let direction = ray.direction.try_normalize()?;
        let mut rays = RayStream::default();
        rays.push(&Ray { direction, t_max: ray.t_max * length, ..*ray });
        let mut hits = HitStream::default();
        self.accel.closest(&rays, &mut hits);
        let hit = hits.get(0)?;
        let at = HitLanes { rays: &rays.blocks()[0], hits: hits.block(0), start: 0 };
        let [point, n] = self.accel.instructions.run(Meet { scene: self, at });
        let object = self.primitives[hit.primitive as usize].object as usize;
        Some(Picked { object, point, distance: hit.t, n })
    }

    /// The object that is seen first in the middle of each pixel, row by row: its index in the scene's list, or [`NO_OBJECT`].
    /// On so many threads (0: all of the machine's).
    #[must_use]
    pub fn object_map(&self, size: [u32; 2], threads: usize) -> Vec<u32> {
        let [width, height] = size.map(|v| v as usize);
        let mut map = vec![NO_OBJECT; width * height];
        if map.is_empty() {
            return map;
        }
        let machine = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let threads = if threads == 0 { machine() } else { threads };
        let rows = Mutex::new(map.chunks_mut(width).enumerate());
        let next = || rows.lock().unwrap_or_else(PoisonError::into_inner).next();
        let work = || {
            let (mut rays, mut hits) = (RayStream::default(), HitStream::default());
            while let Some((y, row)) = next() {
                let blocks = rays.resize(width);
                self.accel.instructions.run(Row { camera: &self.camera, y, size, blocks });
                self.accel.closest(&rays, &mut hits);
                for (x, object) in row.iter_mut().enumerate() {
                    let hit = hits.get(x);
                    *object = hit.map_or(NO_OBJECT, |h| self.primitives[h.primitive as usize].object);
                }
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
