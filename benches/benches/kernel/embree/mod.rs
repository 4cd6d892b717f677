//! Embree 4 as a contender: its C interface, declared as far as the bench needs it (rtcore_*.h of Embree 4.4), and the
//! library loaded while the program runs.
//!
//! This file has `unsafe`. The invariants:
//! - [`Api`] holds functions of a library that stays loaded as long as they are (`_library`), with the types of Embree's
//!   headers. That the file is Embree 4 is up to who sets the variable; its version is asked first and refused otherwise.
//! - A [`Peer`] releases its scene and device once, and keeps what it shares with them: the vertices and indices lie in
//!   vectors that nobody touches between building and dropping, and whose last element is followed by 16 bytes at the least.
//! - Rays and hits have Embree's layout and alignment ([`layout`]) and are not shared.
#![allow(unsafe_code)]

mod layout;

use layout::{
    Arguments, FLOAT3, FLOAT4, INDEX_BUFFER, MEDIUM_QUALITY, ROBUST, RayHit, RayHit16, SPHERES, TRIANGLES,
    UINT3, VERSION, VERTEX_BUFFER, Valid,
};
use libloading::Library;
use std::error::Error;
use std::ffi::{CStr, c_char, c_void};
use std::path::Path;
use std::ptr::null;
use std::sync::Arc;
use std::sync::atomic::{AtomicIsize, Ordering};
use std::time::Duration;
use vitrine_math::Ray;
use vitrine_measure::Scene;
use vitrine_measure::race::{Contender, Query, cpu_time_of};

/// How far the floor reaches in each direction, metres: Embree has no planes without end.
const FLOOR_REACH: f32 = 100_000.0;

type Handle = *mut c_void;
type MemoryMonitor = extern "C" fn(*mut c_void, isize, bool) -> bool;

macro_rules! api {
    ($($name:ident = $symbol:literal: fn($($argument:ty),*) $(-> $result:ty)?;)*) => {
        /// The functions of Embree that are used.
        struct Api {
            $($name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)*
        }

        impl Api {
            fn load(path: &Path) -> Result<Self, libloading::Error> {
                // SAFETY: the library's initialisers are those of Embree and of its task scheduler; the types are those
                // of its headers, see the opening of this file.
                unsafe {
                    let library = Library::new(path)?;
                    let api = Self { $($name: *library.get($symbol)?,)* };
                    // Its threads may outlive its devices: it stays until the program ends.
                    std::mem::forget(library);
                    Ok(api)
                }
            }
        }
    };
}

api! {
    new_device = b"rtcNewDevice\0": fn(*const c_char) -> Handle;
    release_device = b"rtcReleaseDevice\0": fn(Handle);
    device_property = b"rtcGetDeviceProperty\0": fn(Handle, u32) -> isize;
    device_error = b"rtcGetDeviceError\0": fn(Handle) -> u32;
    monitor_memory = b"rtcSetDeviceMemoryMonitorFunction\0": fn(Handle, MemoryMonitor, *mut c_void);
    new_scene = b"rtcNewScene\0": fn(Handle) -> Handle;
    release_scene = b"rtcReleaseScene\0": fn(Handle);
    set_scene_flags = b"rtcSetSceneFlags\0": fn(Handle, u32);
    set_scene_quality = b"rtcSetSceneBuildQuality\0": fn(Handle, u32);
    commit_scene = b"rtcCommitScene\0": fn(Handle);
    new_geometry = b"rtcNewGeometry\0": fn(Handle, u32) -> Handle;
    share_buffer = b"rtcSetSharedGeometryBuffer\0":
        fn(Handle, u32, u32, u32, *const c_void, usize, usize, usize);
    commit_geometry = b"rtcCommitGeometry\0": fn(Handle);
    attach_geometry = b"rtcAttachGeometry\0": fn(Handle, Handle) -> u32;
    release_geometry = b"rtcReleaseGeometry\0": fn(Handle);
    intersect1 = b"rtcIntersect1\0": fn(Handle, *mut RayHit, *mut Arguments);
    occluded1 = b"rtcOccluded1\0": fn(Handle, *mut RayHit, *mut Arguments);
    intersect16 = b"rtcIntersect16\0": fn(*const Valid, Handle, *mut RayHit16, *mut Arguments);
    occluded16 = b"rtcOccluded16\0": fn(*const Valid, Handle, *mut RayHit16, *mut Arguments);
}

/// The library.
#[derive(Clone)]
pub struct Embree {
    api: Arc<Api>,
    /// As 40400 for 4.4.0.
    version: isize,
}

impl Embree {
    /// Loads it from a file.
    ///
    /// # Errors
    /// When it cannot be loaded or is not Embree 4.
    pub fn load(path: &Path) -> Result<Self, String> {
        let api = Api::load(path).map_err(|error| {
            let cause = error.source().map_or_else(|| error.to_string(), ToString::to_string);
            format!("cannot load {}: {cause}", path.display())
        })?;
        // SAFETY: a device is made, asked and released; null asks for the defaults.
        let version = unsafe {
            let device = (api.new_device)(null());
            let version = (api.device_property)(device, VERSION);
            (api.release_device)(device);
            version
        };
        let embree = Self { api: Arc::new(api), version };
        if version / 10_000 != 4 {
            return Err(format!("this is Embree {}, not 4: {}", embree.version(), path.display()));
        }
        Ok(embree)
    }

    /// As "4.4.0".
    pub fn version(&self) -> String {
        let v = self.version;
        format!("{}.{}.{}", v / 10_000, v / 100 % 100, v % 100)
    }
}

/// Whether neighbouring triangles may leave a gap between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// They may, Embree's default.
    Fast,
    /// They may not: the flag "robust".
    Watertight,
}

/// A scene in Embree.
pub struct Peer {
    api: Arc<Api>,
    device: Handle,
    scene: Handle,
    memory: Arc<AtomicIsize>,
    build_time: Duration,
    /// What Embree reads while it builds and, perhaps, while it traces.
    _shared: Vec<Shared>,
}

/// Vertices of four numbers each, and triangles over them; none for balls, whose fourth number is the radius.
struct Shared {
    vertices: Vec<[f32; 4]>,
    triangles: Vec<[u32; 3]>,
    count: usize,
}

impl Shared {
    fn all(scene: &Scene) -> Vec<Self> {
        let mut all = Vec::new();
        for model in &scene.models {
            let vertices = model.positions.iter().map(|p| [p.x, p.y, p.z, 0.0]).collect();
            all.push((vertices, model.triangles.clone()));
        }
        if let Some(y) = scene.floor {
            let corner = |x: f32, z: f32| [FLOOR_REACH * x, y, FLOOR_REACH * z, 0.0];
            let corners = vec![corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
            all.push((corners, vec![[0, 1, 2], [0, 2, 3]]));
        }
        if !scene.balls.is_empty() {
            let ball = |b: &vitrine_measure::Ball| [b.center.x, b.center.y, b.center.z, b.radius];
            all.push((scene.balls.iter().map(ball).collect(), Vec::new()));
        }
        let pad = |(mut vertices, mut triangles): (Vec<[f32; 4]>, Vec<[u32; 3]>)| {
            let count = if triangles.is_empty() { vertices.len() } else { triangles.len() };
            // Embree may read 16 bytes from the last element on.
            vertices.push([0.0; 4]);
            triangles.extend([[0; 3]; 2]);
            Self { vertices, triangles, count }
        };
        all.into_iter().map(pad).collect()
    }

    fn is_balls(&self) -> bool {
        self.triangles.len() == 2
    }
}

extern "C" fn count_memory(total: *mut c_void, bytes: isize, _: bool) -> bool {
    // SAFETY: the pointer is the one that was given together with this function, to a counter that lives longer than the
    // device; counters may be shared.
    unsafe { &*total.cast::<AtomicIsize>() }.fetch_add(bytes, Ordering::Relaxed);
    true
}

impl Peer {
    /// Builds a scene, on one thread, with the quality "medium".
    ///
    /// # Errors
    /// What Embree complains about, as its number.
    pub fn build(embree: &Embree, scene: &Scene, edges: Edges) -> Result<Self, String> {
        let api = embree.api.clone();
        let shared = Shared::all(scene);
        let memory = Arc::new(AtomicIsize::new(0));
        let config: &CStr = c"threads=1,start_threads=0";
        // SAFETY: handles are those that Embree gave, each released once; the shared buffers have as many elements as
        // stated and stay where they are until the scene is gone (fields of the result, dropped after `drop` has run).
        unsafe {
            let device = (api.new_device)(config.as_ptr());
            (api.monitor_memory)(device, count_memory, Arc::as_ptr(&memory).cast_mut().cast());
            let handle = (api.new_scene)(device);
            (api.set_scene_flags)(handle, if edges == Edges::Watertight { ROBUST } else { 0 });
            (api.set_scene_quality)(handle, MEDIUM_QUALITY);
            for part in &shared {
                part.attach(&api, device, handle);
            }
            let ((), build_time) = cpu_time_of(|| (api.commit_scene)(handle));
            let error = (api.device_error)(device);
            let peer = Self { api, device, scene: handle, memory, build_time, _shared: shared };
            if error == 0 { Ok(peer) } else { Err(format!("Embree's error {error}")) }
        }
    }

    /// The processor time that building took.
    pub const fn build_time(&self) -> Duration {
        self.build_time
    }

    /// Bytes that Embree holds.
    pub fn memory(&self) -> usize {
        self.memory.load(Ordering::Relaxed).max(0) as usize
    }

    /// One ray at a time, as a contender.
    pub fn single(&self, query: Query) -> impl Contender {
        Single { peer: self, query, rays: Vec::new() }
    }

    /// Sixteen rays at a time, as a contender. Embree is told when rays in a row lie close together.
    pub fn packets(&self, query: Query, are_coherent: bool) -> impl Contender {
        Packets { peer: self, query, are_coherent, rays: Vec::new(), count: 0 }
    }
}

impl Shared {
    /// # Safety
    /// The handles are Embree's, and `self` stays unchanged until the scene is released.
    unsafe fn attach(&self, api: &Api, device: Handle, scene: Handle) {
        let (kind, format) = if self.is_balls() { (SPHERES, FLOAT4) } else { (TRIANGLES, FLOAT3) };
        let (vertices, triangles) = (self.vertices.as_ptr().cast(), self.triangles.as_ptr().cast());
        // SAFETY: as the caller promises; each vector has one element more than stated, see `pad`.
        unsafe {
            let geometry = (api.new_geometry)(device, kind);
            let count = self.vertices.len() - 1;
            (api.share_buffer)(geometry, VERTEX_BUFFER, 0, format, vertices, 0, 16, count);
            if kind == TRIANGLES {
                (api.share_buffer)(geometry, INDEX_BUFFER, 0, UINT3, triangles, 0, 12, self.count);
            }
            (api.commit_geometry)(geometry);
            (api.attach_geometry)(scene, geometry);
            (api.release_geometry)(geometry);
        }
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        // SAFETY: both are Embree's and released nowhere else.
        unsafe {
            (self.api.release_scene)(self.scene);
            (self.api.release_device)(self.device);
        }
    }
}

struct Single<'a> {
    peer: &'a Peer,
    query: Query,
    rays: Vec<RayHit>,
}

impl Contender for Single<'_> {
    fn load(&mut self, rays: &[Ray]) {
        self.rays.clear();
        self.rays.extend(rays.iter().map(RayHit::new));
    }

    fn cast(&mut self) {
        let (api, scene) = (&*self.peer.api, self.peer.scene);
        let mut arguments = Arguments::new(false);
        let call = match self.query {
            Query::Closest => api.intersect1,
            Query::Occlusion => api.occluded1,
        };
        for ray in &mut self.rays {
            // SAFETY: the scene is committed; a ray and its hit are as Embree lays them out (an occlusion ray is the
            // beginning of that).
            unsafe { call(scene, ray, &raw mut arguments) };
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        distances.extend(self.rays.iter().map(|ray| ray.found(self.query)));
    }
}

struct Packets<'a> {
    peer: &'a Peer,
    query: Query,
    are_coherent: bool,
    rays: Vec<(Valid, RayHit16)>,
    count: usize,
}

impl Contender for Packets<'_> {
    fn load(&mut self, rays: &[Ray]) {
        self.count = rays.len();
        self.rays.clear();
        self.rays.extend(rays.chunks(16).map(|rays| (Valid::first(rays.len()), RayHit16::new(rays))));
    }

    fn cast(&mut self) {
        let (api, scene) = (&*self.peer.api, self.peer.scene);
        let mut arguments = Arguments::new(self.are_coherent);
        let call = match self.query {
            Query::Closest => api.intersect16,
            Query::Occlusion => api.occluded16,
        };
        for (valid, rays) in &mut self.rays {
            // SAFETY: as for single rays; both are aligned to 64 bytes.
            unsafe { call(valid, scene, rays, &raw mut arguments) };
        }
    }

    fn read(&self, distances: &mut Vec<f32>) {
        let all = self.rays.iter().flat_map(|(_, rays)| rays.found(self.query));
        distances.extend(all.take(self.count));
    }
}
