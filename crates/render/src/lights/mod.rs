//! STUB
use vitrine_math::{Frame, Ray, Rgb, Transform, Vec3};
use vitrine_scene::lights::Emission;

pub struct Lamp { pub emission: Emission, pub radiance: Rgb, pub full_at: f32 }
pub enum EmitterShape { Sphere { center: Vec3, radius: f32 }, Triangle { points: [Vec3; 3] }, Box { unit: Transform } }
pub struct Emitter { pub shape: EmitterShape, pub radiance: Rgb, pub primitive: u32, pub triangle: u32 }
#[derive(Clone, Copy, Debug)]
pub enum LightPoint { Point { position: Vec3 }, Surface { position: Vec3, n: Vec3, two_sided: bool }, Distant { toward: Vec3 } }
#[derive(Clone, Copy, Debug)]
pub struct LightSample { pub light: u32, pub at: LightPoint, pub le: Rgb, pub pdf: f32, pub is_delta: bool }
#[derive(Clone, Copy, Debug)]
pub struct LampHit { pub t: f32, pub light: u32, pub n: Vec3, pub le: Rgb }
#[derive(Debug, Default)]
pub struct Lights { all: Vec<(Emission, Rgb, f32)>, ambient: Rgb }
impl Lights {
    pub fn new(lamps: Vec<Lamp>, _e: Vec<Emitter>) -> Self {
        let mut s = Self::default();
        for l in lamps {
            if matches!(l.emission, Emission::Everywhere) { s.ambient += l.radiance; }
            s.all.push((l.emission, l.radiance, l.full_at));
        }
        s
    }
    fn le(&self, i: usize) -> Rgb {
        let (e, r, d) = &self.all[i];
        match e {
            Emission::Sphere { radius, .. } | Emission::Disc { radius, .. } => *r * (d * d / (radius * radius)),
            Emission::Point { .. } => *r * (std::f32::consts::PI * d * d),
            Emission::Direction { .. } => *r * std::f32::consts::PI,
            _ => *r,
        }
    }
    pub fn sample(&self, _p: Vec3, _n: Option<Vec3>, u: f32, v: [f32; 2]) -> Option<LightSample> {
        if self.all.is_empty() { return None; }
        let count = self.all.len() as f32;
        let i = ((u * count) as usize).min(self.all.len() - 1);
        let (phi, z) = (std::f32::consts::TAU * v[0], 1.0 - 2.0 * v[1]);
        let r = (1.0 - z * z).max(0.0).sqrt();
        let dir = Vec3::new(r * libm::cosf(phi), r * libm::sinf(phi), z);
        let le = self.le(i);
        let s = match &self.all[i].0 {
            Emission::Point { position } => LightSample { light: i as u32, at: LightPoint::Point { position: *position }, le, pdf: 1.0 / count, is_delta: true },
            Emission::Sphere { position, radius } => LightSample { light: i as u32, at: LightPoint::Surface { position: *position + dir * *radius, n: dir, two_sided: false }, le, pdf: 1.0 / (count * 4.0 * std::f32::consts::PI * radius * radius), is_delta: false },
            Emission::Disc { position, radius } => {
                let rr = radius * v[1].sqrt();
                LightSample { light: i as u32, at: LightPoint::Surface { position: *position + Vec3::new(rr * libm::cosf(phi), 0.0, rr * libm::sinf(phi)), n: Vec3::Y, two_sided: true }, le, pdf: 1.0 / (count * std::f32::consts::PI * radius * radius), is_delta: false }
            }
            Emission::Direction { travels } => LightSample { light: i as u32, at: LightPoint::Distant { toward: -*travels }, le, pdf: 1.0 / count, is_delta: true },
            _ => LightSample { light: i as u32, at: LightPoint::Distant { toward: dir }, le, pdf: 1.0 / (count * 4.0 * std::f32::consts::PI), is_delta: false },
        };
        let _ = Frame::around(dir);
        Some(s)
    }
    pub fn pdf_surface(&self, light: u32, _p: Vec3, _n: Option<Vec3>, _y: Vec3) -> f32 {
        let count = self.all.len() as f32;
        match &self.all[light as usize].0 {
            Emission::Sphere { radius, .. } => 1.0 / (count * 4.0 * std::f32::consts::PI * radius * radius),
            Emission::Disc { radius, .. } => 1.0 / (count * std::f32::consts::PI * radius * radius),
            _ => 0.0,
        }
    }
    pub fn pdf_distant(&self, _p: Vec3, _n: Option<Vec3>, _d: Vec3) -> f32 {
        let k = self.all.iter().filter(|a| matches!(a.0, Emission::Everywhere)).count() as f32;
        k / (self.all.len().max(1) as f32 * 4.0 * std::f32::consts::PI)
    }
    pub fn le_distant(&self, _d: Vec3) -> Rgb { self.ambient }
    pub fn emitter(&self, _p: u32, _t: u32) -> Option<u32> { None }
    pub fn intersect(&self, ray: &Ray, from: f32, end: f32) -> Option<LampHit> {
        let mut best: Option<LampHit> = None;
        for (i, (e, ..)) in self.all.iter().enumerate() {
            let hit = match e {
                Emission::Sphere { position, radius } => {
                    let f = ray.origin - *position;
                    let b = -f.dot(ray.direction);
                    let l = f + ray.direction * b;
                    let disc = radius * radius - l.length_squared();
                    if disc <= 0.0 { continue; }
                    let t = b - disc.sqrt();
                    let n = (ray.at(t) - *position) / *radius;
                    (t, n)
                }
                Emission::Disc { position, radius } => {
                    let t = (position.y - ray.origin.y) / ray.direction.y;
                    if !((ray.at(t) - *position).length() < *radius) { continue; }
                    (t, Vec3::Y)
                }
                _ => continue,
            };
            if hit.0 > from && hit.0 < end && best.is_none_or(|b| hit.0 < b.t) {
                best = Some(LampHit { t: hit.0, light: i as u32, n: hit.1, le: self.le(i) });
            }
        }
        best
    }
}
