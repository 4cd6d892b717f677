//! The renderer's ray kernel under the names that the measurements use. What it is called in `vitrine_render` stands here
//! alone.

use crate::race::{Contender, NOTHING, Query, cpu_time_of};
use crate::{Part, Scene};
use std::sync::Arc;
use std::time::Duration;
use vitrine_math::{Affine3A, Bounds3, Ray, Vec3};
use vitrine_render::accel::primitives::plane::Plane;
use vitrine_render::accel::primitives::sphere::Sphere;
use vitrine_render::accel::simd::Instructions;
use vitrine_render::accel::{
    Accel, Hit, HitStream, Instance, MaterialSlots, MeshAccel, Primitives, RayStream,
};

/// A scene made ready for rays.
#[derive(Debug)]
pub struct Kernel {
    accel: Accel,
    /// What each primitive is; of a model, its first triangle.
    parts: Vec<Part>,
    build_time: Duration,
    memory: usize,
}

impl Kernel {
    /// Makes a scene ready, on as many threads as the renderer would.
    #[must_use]
    pub fn build(scene: &Scene) -> Self {
        let mut primitives = Primitives::default();
        let mut parts = Vec::new();
        let mut memory = 0;
        let mut add = |part| {
            parts.push(part);
            parts.len() as u32 - 1
        };
        for (i, ball) in scene.balls.iter().enumerate() {
            let primitive = add(Part::Ball(i));
            let r = Vec3::splat(ball.radius);
            let bounds = Bounds3 { min: ball.center - r, max: ball.center + r };
            let sphere = Sphere { center: ball.center.into(), radius: ball.radius, primitive };
            primitives.spheres.push((sphere, bounds));
        }
        if let Some(offset) = scene.floor {
            let primitive = add(Part::Floor);
            primitives.planes.push(Plane { n: Vec3::Y.into(), offset, primitive });
        }
        let mut build_time = Duration::ZERO;
        for (model, mesh) in scene.models.iter().enumerate() {
            let primitive = add(Part::Triangle { model, triangle: 0 });
            let (built, time) = cpu_time_of(|| MeshAccel::new(&mesh.positions, &mesh.triangles, Vec::new()));
            build_time += time;
            memory += built.memory();
            let instance = Instance { mesh_from_world: Affine3A::IDENTITY, mesh: Arc::new(built), primitive };
            primitives.instances.push((instance, mesh.bounds()));
        }
        primitives.materials = vec![MaterialSlots { first: 0, by_triangle: false }; parts.len()];
        let (accel, time) = cpu_time_of(|| Accel::new(primitives, vec![0.0]));
        let memory = memory + accel.memory();
        Self { accel, parts, build_time: build_time + time, memory }
    }

    /// The processor time that building took, all threads together, from triangles to the finished tree.
    #[must_use]
    pub const fn build_time(&self) -> Duration {
        self.build_time
    }

    /// Bytes of trees and triangles; the models' vertices are not needed any more.
    #[must_use]
    pub const fn memory(&self) -> usize {
        self.memory
    }

    /// The nearest hit of each ray, and what it is.
    #[must_use]
    pub fn closest(&self, rays: &[Ray]) -> Vec<Option<(f32, Part)>> {
        let (mut stream, mut hits) = (RayStream::default(), HitStream::default());
        rays.iter().for_each(|ray| stream.push(ray));
        self.accel.closest(&stream, &mut hits);
        (0..rays.len()).map(|i| hits.get(i).map(|hit| (hit.t, self.part(&hit)))).collect()
    }

    fn part(&self, hit: &Hit) -> Part {
        match self.parts[hit.primitive as usize] {
            Part::Triangle { model, .. } => Part::Triangle { model, triangle: hit.triangle as usize },
            other => other,
        }
    }

    /// The kernel for one ray at a time, as a contender.
    #[must_use]
    pub fn single(&self, query: Query) -> impl Contender {
        let (rays, hits, answers) = (Vec::new(), Vec::new(), Vec::new());
        Single { accel: &self.accel, query, rays, hits, answers }
    }

    /// The kernel for many rays at a time, as a contender.
    #[must_use]
    pub fn packets(&self, query: Query) -> impl Contender {
        Packets::new(&self.accel, query)
    }
}

/// The vector instructions that rays are traced with on this machine.
#[must_use]
pub fn instructions() -> &'static str {
    match Instructions::detect() {
        Instructions::Portable => "portable",
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2(_) => "AVX2",
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512(_) => "AVX-512",
    }
}

struct Packets<'a> {
    accel: &'a Accel,
    query: Query,
    rays: RayStream,
    hits: HitStream,
    answers: Vec<bool>,
}

impl<'a> Packets<'a> {
    fn new(accel: &'a Accel, query: Query) -> Self {
        let (rays, hits, answers) = (RayStream::default(), HitStream::default(), Vec::new());
        Self { accel, query, rays, hits, answers }
    }
}

struct Single<'a> {
    accel: &'a Accel,
    query: Query,
    rays: Vec<Ray>,
    hits: Vec<Option<Hit>>,
    answers: Vec<bool>,
}

impl Contender for Single<'_> {
    fn load(&mut self, rays: &[Ray]) {
        self.rays.clear();
        self.rays.extend_from_slice(rays);
        self.hits.resize(rays.len(), None);
        self.answers.resize(rays.len(), false);
    }

    fn cast(&mut self) {
        match self.query {
            Query::Closest => self.accel.closest_each(&self.rays, &mut self.hits),
            Query::Occlusion => self.accel.occluded_each(&self.rays, &mut self.answers),
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        distances.extend((0..self.rays.len()).map(|i| match self.query {
            Query::Closest => self.hits[i].map_or(NOTHING, |hit| hit.t),
            Query::Occlusion if self.answers[i] => 0.0,
            Query::Occlusion => NOTHING,
        }));
    }
}

impl Contender for Packets<'_> {
    fn load(&mut self, rays: &[Ray]) {
        self.rays.clear();
        rays.iter().for_each(|ray| self.rays.push(ray));
    }

    fn cast(&mut self) {
        match self.query {
            Query::Closest => self.accel.closest(&self.rays, &mut self.hits),
            Query::Occlusion => self.accel.occluded(&self.rays, &mut self.answers),
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        distances.extend((0..self.rays.len()).map(|i| match self.query {
            Query::Closest => self.hits.get(i).map_or(NOTHING, |hit| hit.t),
            Query::Occlusion if self.answers[i] => 0.0,
            Query::Occlusion => NOTHING,
        }));
    }
}
