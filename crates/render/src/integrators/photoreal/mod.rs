//! The photoreal renderer: path tracing (Kajiya, "The Rendering Equation", 1986) with light found both by chance and on purpose (multiple
//! importance sampling: Veach and Guibas 1995), and with light that comes through glass found exactly ([`connect`]).
//!
//! All paths of a tile take a step together: their rays are traced, what they meet is worked out one by one, and the light that
//! each looks for is traced together again ([`shadow`]).

mod chain;
mod connect;
mod gather;
mod light;
mod media;
mod path;
mod polarisation;
mod shadow;
mod step;
mod surface;

use super::tile::TileOrder;
use super::{Filled, TileTask};
use crate::accel::{HitStream, RayStream};
use crate::job::Cancel;
use crate::samplers::{PathSampler, filter};
use crate::surface::Spots;
use connect::Connector;
use path::Path;
use shadow::{Shadows, is_traceable};
use vitrine_film::{Features, TileSums};
use vitrine_math::Rgb;

pub use media::Media as CompiledMedia;

/// Samples as bright as this would be no number once many are summed up, and are left out as such.
const BRIGHTEST: f32 = 1e30;

/// The tools of one thread.
#[derive(Debug, Default)]
pub struct Paths {
    order: TileOrder,
    /// Paths, and the rays on which they are.
    paths: Vec<Path>,
    rays: RayStream,
    /// The rays on which they go on.
    onward: RayStream,
    hits: HitStream,
    spots: Spots,
    connector: Connector,
    shadows: Shadows,
    /// This sample's light, by the pixel's place in the tile's order.
    light: Vec<Rgb>,
    sums: Vec<Rgb>,
    features: Vec<Features>,
}

impl Paths {
    /// The sums of a tile's samples, row by row. None when it was cancelled between two samples.
    pub fn fill(&mut self, task: &TileTask, cancel: &Cancel) -> Option<Filled<'_>> {
        self.order.fit(&task.tile);
        let pixels = task.tile.pixels();
        self.sums.clear();
        self.sums.resize(pixels, Rgb::BLACK);
        self.features.clear();
        self.features.resize(pixels, Features::default());
        let (mut rays, mut bad) = (0, 0);
        for sample in task.samples.clone() {
            if cancel.is_cancelled() {
                return None;
            }
            self.start(task, sample);
            while !self.paths.is_empty() {
                rays += self.step(task);
            }
            bad += self.take_sample();
        }
        Some(Filled { sums: TileSums { light: &self.sums, features: &self.features }, rays, bad })
    }

    /// Adds the sample's light to the sums. Gives the number of pixels whose light was no number: there it is left out.
    fn take_sample(&mut self) -> u64 {
        let mut bad = 0;
        for (pixel, light) in self.light.iter().enumerate() {
            if light.to_array().iter().all(|c| c.abs() < BRIGHTEST) {
                self.sums[self.order.number(pixel)] += *light;
            } else {
                bad += 1;
            }
        }
        bad
    }

    /// The camera's rays.
    fn start(&mut self, task: &TileTask, sample: u32) {
        let TileTask { scene, settings, tile, .. } = task;
        let pixels = tile.pixels();
        self.paths.clear();
        self.rays.clear();
        self.light.clear();
        self.light.resize(pixels, Rgb::BLACK);
        for pixel in 0..pixels {
            let [x, y] = self.order.place(pixel);
            let [x, y] = [tile.x + x, tile.y + y];
            let sampler = PathSampler::new([x, y], sample, settings.seed);
            let [dx, dy] = filter::offset(sampler.two(0));
            let at = [x as f32 + 0.5 + dx, y as f32 + 0.5 + dy];
            let ray = scene.camera.ray(at, settings.size, sampler.two(1));
            if !is_traceable(ray.origin, ray.direction) {
                continue;
            }
            self.rays.push(&ray);
            self.paths.push(Path::new(pixel as u32, sampler, scene.photoreal.camera_media));
        }
    }

    /// Takes all paths to their next vertices. Gives the number of rays.
    fn step(&mut self, task: &TileTask) -> u64 {
        let scene = task.scene;
        self.onward.clear();
        scene.accel.closest(&self.rays, &mut self.hits);
        self.spots.fill(scene, &self.rays, &self.hits);
        let mut rays = self.paths.len() as u64;
        let mut tools = step::Tools {
            task,
            connector: &mut self.connector,
            shadows: &mut self.shadows,
            onward: &mut self.onward,
            light: &mut self.light,
            order: &self.order,
            features: &mut self.features,
        };
        let mut i = 0;
        // Those that go on close ranks, as their rays do.
        self.paths.retain_mut(|path| {
            let arrival = step::Arrival {
                rays: &self.rays,
                hits: &self.hits,
                spots: &self.spots,
                i,
                ray: self.rays.get(i),
                hit: self.hits.get(i),
            };
            i += 1;
            tools.take(path, &arrival)
        });
        rays += self.shadows.settle(scene, &mut self.light);
        std::mem::swap(&mut self.rays, &mut self.onward);
        rays
    }
}
