//! The renderer's ray kernel under the names that the measurements use. What it is called in `vitrine_render` stands here
//! alone.

use crate::race::{Contender, NOTHING, Query, cpu_time_of};
use crate::{Part, Scene};
use std::sync::Arc;
use std::time::Duration;
use vitrine_math::{Affine3A, Bounds3, Ray, Vec3};
use vitrine_render::accel::primitives::plane::Plane;
use vitrine_render::accel::primitives::sphere::Sphere;
use vitrine_render::accel::primitives::triangle::Triangle;
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
            let (built, time) = cpu_time_of(|| build_mesh(mesh));
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
        let packets = Packets::new(&self.accel, query);
        Single { packets, rays: Vec::new(), count: 0, distances: Vec::new() }
    }

    /// The kernel for many rays at a time, as a contender.
    #[must_use]
    pub fn packets(&self, query: Query) -> impl Contender {
        Packets::new(&self.accel, query)
    }
}

fn build_mesh(mesh: &crate::Model) -> MeshAccel {
    let triangles: Vec<_> =
        (0..mesh.triangles.len()).map(|i| Triangle::new(mesh.corners(i), i as u32)).collect();
    MeshAccel::new(&triangles, |t| Bounds3::around(mesh.corners(t.id as usize)), Vec::new())
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
    passes: Vec<f32>,
}

impl<'a> Packets<'a> {
    fn new(accel: &'a Accel, query: Query) -> Self {
        let (rays, hits, passes) = (RayStream::default(), HitStream::default(), Vec::new());
        Self { accel, query, rays, hits, passes }
    }
}

/// Packets with one ray each.
struct Single<'a> {
    packets: Packets<'a>,
    rays: Vec<RayStream>,
    count: usize,
    distances: Vec<f32>,
}

impl Contender for Single<'_> {
    fn load(&mut self, rays: &[Ray]) {
        self.count = rays.len();
        self.rays.resize_with(self.rays.len().max(rays.len()), RayStream::default);
        for (stream, ray) in self.rays.iter_mut().zip(rays) {
            stream.clear();
            stream.push(ray);
        }
    }

    fn cast(&mut self) {
        self.distances.clear();
        for rays in &mut self.rays[..self.count] {
            std::mem::swap(&mut self.packets.rays, rays);
            self.packets.cast();
            self.packets.read(&mut self.distances);
            std::mem::swap(&mut self.packets.rays, rays);
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        distances.extend_from_slice(&self.distances);
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
            Query::Occlusion => self.accel.transmittance(&self.rays, &mut self.passes),
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        distances.extend((0..self.rays.len()).map(|i| match self.query {
            Query::Closest => self.hits.get(i).map_or(NOTHING, |hit| hit.t),
            Query::Occlusion if self.passes[i] > 0.0 => NOTHING,
            Query::Occlusion => 0.0,
        }));
    }
}
