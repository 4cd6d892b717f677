//! Rays, hits and numbers as Embree 4 has them in memory (rtcore_common.h, rtcore_ray.h, rtcore_scene.h of Embree 4.4).

use std::ffi::c_void;
use std::ptr::null_mut;
use vitrine_math::Ray;
use vitrine_measure::race::{NOTHING, Query};

pub const VERSION: u32 = 0;
pub const TRIANGLES: u32 = 0;
pub const SPHERES: u32 = 50;
pub const INDEX_BUFFER: u32 = 0;
pub const VERTEX_BUFFER: u32 = 1;
pub const FLOAT3: u32 = 0x9003;
pub const FLOAT4: u32 = 0x9004;
pub const UINT3: u32 = 0x5003;
pub const MEDIUM_QUALITY: u32 = 1;
pub const ROBUST: u32 = 1 << 2;

/// No geometry was hit.
const INVALID: u32 = u32::MAX;
const COHERENT: u32 = 1 << 16;
const ALL_FEATURES: u32 = u32::MAX;

/// `RTCIntersectArguments` and `RTCOccludedArguments`, which are alike.
#[repr(C)]
pub struct Arguments {
    flags: u32,
    features: u32,
    context: *mut c_void,
    filter: *mut c_void,
    user_geometry: *mut c_void,
    min_width: f32,
}

impl Arguments {
    pub const fn new(are_coherent: bool) -> Self {
        Self {
            flags: if are_coherent { COHERENT } else { 0 },
            features: ALL_FEATURES,
            context: null_mut(),
            filter: null_mut(),
            user_geometry: null_mut(),
            min_width: 0.0,
        }
    }
}

/// `RTCRayHit`; its beginning is an `RTCRay`.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub struct RayHit {
    origin: [f32; 3],
    t_near: f32,
    direction: [f32; 3],
    time: f32,
    t_far: f32,
    mask: u32,
    id: u32,
    flags: u32,
    n: [f32; 3],
    uv: [f32; 2],
    primitive: u32,
    geometry: u32,
    instance: u32,
    instance_primitive: u32,
}

impl RayHit {
    pub fn new(ray: &Ray) -> Self {
        Self {
            origin: ray.origin.into(),
            t_near: 0.0,
            direction: ray.direction.into(),
            time: 0.0,
            t_far: ray.t_max,
            mask: u32::MAX,
            id: 0,
            flags: 0,
            n: [0.0; 3],
            uv: [0.0; 2],
            primitive: INVALID,
            geometry: INVALID,
            instance: INVALID,
            instance_primitive: INVALID,
        }
    }

    pub fn found(&self, query: Query) -> f32 {
        found(query, self.t_far, self.geometry)
    }
}

/// `RTCRayHit16`; its beginning is an `RTCRay16`.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct RayHit16 {
    origin: [[f32; 16]; 3],
    t_near: [f32; 16],
    direction: [[f32; 16]; 3],
    time: [f32; 16],
    t_far: [f32; 16],
    mask: [u32; 16],
    id: [u32; 16],
    flags: [u32; 16],
    n: [[f32; 16]; 3],
    uv: [[f32; 16]; 2],
    primitive: [u32; 16],
    geometry: [u32; 16],
    instance: [u32; 16],
    instance_primitive: [u32; 16],
}

impl RayHit16 {
    /// From one to sixteen rays; the last fills the lanes that are left.
    pub fn new(rays: &[Ray]) -> Self {
        let column =
            |of: &dyn Fn(&Ray) -> f32| std::array::from_fn(|lane| of(&rays[lane.min(rays.len() - 1)]));
        Self {
            origin: [0, 1, 2].map(|k| column(&|r| r.origin[k])),
            t_near: [0.0; 16],
            direction: [0, 1, 2].map(|k| column(&|r| r.direction[k])),
            time: [0.0; 16],
            t_far: column(&|r| r.t_max),
            mask: [u32::MAX; 16],
            id: [0; 16],
            flags: [0; 16],
            n: [[0.0; 16]; 3],
            uv: [[0.0; 16]; 2],
            primitive: [INVALID; 16],
            geometry: [INVALID; 16],
            instance: [INVALID; 16],
            instance_primitive: [INVALID; 16],
        }
    }

    pub fn found(&self, query: Query) -> impl Iterator<Item = f32> {
        self.t_far.iter().zip(&self.geometry).map(move |(&t, &geometry)| found(query, t, geometry))
    }
}

/// Embree sets the end of an occluded ray to −∞, and the geometry of a ray that hits.
fn found(query: Query, t_far: f32, geometry: u32) -> f32 {
    match query {
        Query::Closest if geometry == INVALID => NOTHING,
        Query::Closest => t_far,
        Query::Occlusion if t_far < 0.0 => 0.0,
        Query::Occlusion => NOTHING,
    }
}

/// Which of sixteen lanes hold a ray: −1 for yes.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct Valid([i32; 16]);

impl Valid {
    /// The first so many.
    pub fn first(count: usize) -> Self {
        Self(std::array::from_fn(|lane| if lane < count { -1 } else { 0 }))
    }
}
