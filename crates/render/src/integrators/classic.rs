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
use crate::accel::{BLOCK, Hit, HitStream, RayStream};
use crate::compile::{CompiledMaterial, CompiledScene};
use crate::samplers::in_pixel;
use crate::surface::{SurfaceBlock, SurfaceInteraction};
use vitrine_math::{Ray, Rgb};
use vitrine_optics::{reflect, refract};

/// Light with less weight than this in its pixel is not followed: it is below a tenth of the smallest step of an 8-bit picture.
const MIN_WEIGHT: f32 = 2e-5;

/// So many surfaces a ray may pass on its way; then it sees the background.
const MAX_CROSSINGS: u16 = 1000;
/// A surface that bends the ray counts as so many: such a ray may be caught inside for ever.
const BEND: u16 = 10;

/// How far the light is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Mirror images, what is behind transparent surfaces, shadows.
    Recursive,
    /// The nearest surface alone.
    CameraOnly,
}

/// What a ray of a wave carries.
#[derive(Clone, Copy, Debug)]
struct Errand {
    /// The pixel, by its place in the tile.
    pixel: u32,
    /// How much of what it sees reaches the pixel.
    weight: f32,
    /// How many times it may be mirrored yet.
    reflections: u8,
    /// How many surfaces it has passed.
    crossings: u16,
}

/// Rays that are traced together.
#[derive(Debug, Default)]
struct Wave {
    rays: RayStream,
    errands: Vec<Errand>,
}

impl Wave {
    fn clear(&mut self) {
        self.rays.clear();
        self.errands.clear();
    }

    #[inline(always)]
    fn push(&mut self, ray: &Ray, errand: Errand) {
        self.rays.push(ray);
        self.errands.push(errand);
    }

    /// The ray goes straight on after a hit.
    #[inline(always)]
    fn push_on(&mut self, ray: &Ray, hit: &Hit, errand: Errand) {
        self.rays.push_on(ray, hit);
        self.errands.push(errand);
    }
}

/// The waves of one thread.
#[derive(Debug, Default)]
pub struct Waves {
    now: Wave,
    onward: Wave,
    mirrored: Wave,
    hits: HitStream,
    surfaces: Vec<SurfaceBlock>,
    lights: LightQueue,
    sums: Vec<Rgb>,
    rays: u64,
}

impl Waves {
    /// The sums of a tile's samples, row by row, and the number of rays.
    pub fn fill(&mut self, task: &TileTask, reach: Reach) -> (Vec<Rgb>, u64) {
        self.sums = vec![Rgb::BLACK; task.tile.pixels()];
        self.rays = 0;
        for sample in task.samples.clone() {
            self.start(task, sample, reach);
            loop {
                // Onward rays first: they stay together with their neighbours.
                let next = if self.onward.rays.is_empty() { &mut self.mirrored } else { &mut self.onward };
                if next.rays.is_empty() {
                    break;
                }
                std::mem::swap(&mut self.now, next);
                next.clear();
                self.trace(task, sample, reach);
            }
        }
        (std::mem::take(&mut self.sums), self.rays)
    }

    /// Camera rays, block by block of 4 × 4 pixels so that packets are compact.
    fn start(&mut self, task: &TileTask, sample: u32, reach: Reach) {
        const BLOCK: u32 = 4;
        let (tile, size) = (task.tile, task.settings.size);
        // A single sample is the pixel's middle; in_pixel(0) is.
        let [dx, dy] = in_pixel(sample);
        let reflections = match reach {
            Reach::Recursive => u8::try_from(task.settings.depth).unwrap_or(u8::MAX),
            Reach::CameraOnly => 0,
        };
        self.now.clear();
        self.mirrored.clear();
        self.onward.clear();
        for top in (0..tile.height).step_by(BLOCK as usize) {
            for left in (0..tile.width).step_by(BLOCK as usize) {
                for y in top..(top + BLOCK).min(tile.height) {
                    for x in left..(left + BLOCK).min(tile.width) {
                        let at = [(tile.x + x) as f32 + dx, (tile.y + y) as f32 + dy];
                        let ray = task.scene.camera.generate_ray(at, size);
                        let pixel = y * tile.width + x;
                        self.onward.push(&ray, Errand { pixel, weight: 1.0, reflections, crossings: 0 });
                    }
                }
            }
        }
    }

    fn trace(&mut self, task: &TileTask, sample: u32, reach: Reach) {
        let scene = task.scene;
        self.rays += self.now.rays.len() as u64;
        scene.accel.closest(&self.now.rays, &mut self.hits);
        scene.surfaces(&self.now.rays, &self.hits, &mut self.surfaces);
        self.lights.reset(self.now.rays.len());
        for i in 0..self.now.errands.len() {
            let errand = self.now.errands[i];
            let Some(hit) = self.hits.get(i) else {
                self.sums[errand.pixel as usize] += scene.background * errand.weight;
                continue;
            };
            let material = scene.primitives[hit.primitive as usize].material_of(&hit);
            let view = View { scene, place: i, hit: &hit, material: &scene.materials[material as usize] };
            match reach {
                Reach::CameraOnly => self.show(&view, errand.pixel, errand.weight),
                Reach::Recursive => self.spread(&view, errand),
            }
        }
        let shadows = match reach {
            Reach::CameraOnly => Shadows::None,
            Reach::Recursive => Shadows::Cast,
        };
        let wave = WaveLight { task, sample, shadows, surfaces: &self.surfaces };
        self.rays += self.lights.shade(&wave, &mut self.sums);
    }

    /// The point of a hit.
    #[inline(always)]
    fn surface(&self, place: usize) -> SurfaceInteraction {
        self.surfaces[place / BLOCK].get(place % BLOCK)
    }

    /// The light of a surface itself, with that weight in its pixel.
    #[inline(always)]
    fn show(&mut self, view: &View, pixel: u32, weight: f32) {
        let (scene, mut phong) = (view.scene, view.material.phong);
        if let Some(texture) = view.material.texture {
            let at = scene.texture_point(self.surface(view.place).p, view.hit);
            phong.color = scene.textures[texture].color(at);
        }
        self.lights.put(view.place, &Lit { phong, pixel, weight }, scene.ambient);
    }

    /// Shares a ray's weight among the surface's own light, its mirror image and what is behind.
    #[inline(always)]
    fn spread(&mut self, view: &View, errand: Errand) {
        let material = view.material;
        let opaque = errand.weight * (1.0 - material.transparency);
        // At the end of the recursion a mirror shows its own colour.
        let mirror = if errand.reflections > 0 { material.reflectivity } else { 0.0 };
        let own = opaque * (1.0 - mirror);
        if own > MIN_WEIGHT {
            self.show(view, errand.pixel, own);
        }
        let reflected = opaque * mirror;
        if reflected > MIN_WEIGHT {
            let errand = Errand { weight: reflected, reflections: errand.reflections - 1, ..errand };
            self.mirrored.push(&mirrored(&self.surface(view.place)), errand);
        }
        let through = errand.weight * material.transparency;
        if through > MIN_WEIGHT {
            self.go_on(view, Errand { weight: through, ..errand });
        }
    }

    #[inline(always)]
    fn go_on(&mut self, view: &View, errand: Errand) {
        if errand.crossings >= MAX_CROSSINGS {
            self.sums[errand.pixel as usize] += view.scene.background * errand.weight;
            return;
        }
        if view.material.refraction == 1.0 {
            let errand = Errand { crossings: errand.crossings + 1, ..errand };
            self.onward.push_on(&self.now.rays.get(view.place), view.hit, errand);
        } else {
            let errand = Errand { crossings: errand.crossings + BEND, ..errand };
            self.onward.push(&bent(&self.surface(view.place), view.material.refraction), errand);
        }
    }
}

/// A hit with all that belongs to it.
struct View<'a> {
    scene: &'a CompiledScene,
    /// The ray's place in its wave.
    place: usize,
    hit: &'a Hit,
    material: &'a CompiledMaterial,
}

/// The mirror ray.
fn mirrored(s: &SurfaceInteraction) -> Ray {
    let wi = reflect(s.wo, s.ns);
    // A smooth normal may send it into the surface: then the form's own normal decides.
    let wi = if wi.dot(s.n) > 0.0 { wi } else { reflect(s.wo, s.n) };
    Ray::new(s.origin(), wi.normalize())
}

/// The refracted ray, or at total reflection the mirror ray. `refraction` is the index inside over the index outside.
fn bent(s: &SurfaceInteraction, refraction: f32) -> Ray {
    let eta = if s.is_outside { refraction } else { 1.0 / refraction };
    match refract(s.wo, s.ns, eta) {
        Some(wi) if wi.dot(s.n) < 0.0 => Ray::new(s.origin_beyond(), wi.normalize()),
        _ => mirrored(s),
    }
}
