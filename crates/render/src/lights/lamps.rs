//! Lamps with a surface: balls and discs that camera and mirrors see. They are no objects of the scene, so rays are tested here.

use std::cmp::Ordering;
use vitrine_math::{Bounds3, Ray, Vec3};

/// Up to here lamps are tested one by one.
const FEW: usize = 4;

/// Where a ray meets a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LampHit {
    /// The distance, in lengths of the ray's direction.
    pub t: f32,
    /// The light.
    pub light: u32,
    /// The point on the surface, world space, metres.
    pub y: Vec3,
    /// The unit normal on the side where the ray comes from.
    pub n: Vec3,
}

/// The form of a lamp.
#[derive(Clone, Copy, Debug)]
pub enum LampForm {
    /// A ball, seen from outside only.
    Ball,
    /// A disc parallel to XOZ, seen from both sides.
    Disc,
}

/// A lamp that rays can meet.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// The form.
    pub form: LampForm,
    /// The centre, world space, metres.
    pub position: Vec3,
    /// Metres.
    pub radius: f32,
    /// The light.
    pub light: u32,
}

/// All lamps that rays can meet, in a tree if there are many.
#[derive(Clone, Debug, Default)]
pub struct Lamps {
    lamps: Vec<Lamp>,
    /// In the order of a walk from the root down; empty over few lamps.
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds3,
    /// The lamps below it.
    first: u32,
    /// One past the last of the lamps below it.
    end: u32,
    /// Where the walk goes on when its box is missed: past all that is below it.
    skip: u32,
}

impl Lamps {
    /// Over lamps.
    pub fn new(lamps: Vec<Lamp>) -> Self {
        let mut all = Self { lamps, nodes: Vec::new() };
        if all.lamps.len() > FEW {
            all.build(0, all.lamps.len());
        }
        all
    }

    fn build(&mut self, first: usize, end: usize) {
        let below = &mut self.lamps[first..end];
        let bounds = below.iter().map(Lamp::bounds).fold(Bounds3::EMPTY, Bounds3::union);
        let at = self.nodes.len();
        self.nodes.push(Node { bounds, first: first as u32, end: end as u32, skip: 0 });
        if end - first > FEW {
            let size = Bounds3::around(below.iter().map(|lamp| lamp.position)).size();
            let axis = if size.x >= size.y.max(size.z) { 0 } else { 1 + usize::from(size.z > size.y) };
            // The light decides between equal places, so the order is the same on every machine.
            let order = |a: &Lamp, b: &Lamp| -> Ordering {
                a.position[axis].total_cmp(&b.position[axis]).then(a.light.cmp(&b.light))
            };
            below.sort_by(order);
            let middle = usize::midpoint(first, end);
            self.build(first, middle);
            self.build(middle, end);
        }
        self.nodes[at].skip = self.nodes.len() as u32;
    }

    /// Whether there is none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.lamps.is_empty()
    }

    /// The nearest lamp that the ray meets before `t_max`.
    #[inline]
    pub fn intersect(&self, ray: &Ray, t_max: f32) -> Option<LampHit> {
        let mut nearest = None;
        let mut t = t_max;
        if self.nodes.is_empty() {
            self.nearest_of(0..self.lamps.len(), ray, &mut t, &mut nearest);
            return nearest;
        }
        let inverse = ray.direction.recip();
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !is_met(&node.bounds, ray.origin, inverse, t) {
                at = node.skip as usize;
                continue;
            }
            at += 1;
            if node.skip as usize == at {
                self.nearest_of(node.first as usize..node.end as usize, ray, &mut t, &mut nearest);
            }
        }
        nearest
    }

    #[inline]
    fn nearest_of(
        &self,
        range: std::ops::Range<usize>,
        ray: &Ray,
        t: &mut f32,
        nearest: &mut Option<LampHit>,
    ) {
        for lamp in &self.lamps[range] {
            if let Some(hit) = lamp.intersect(ray, *t) {
                *t = hit.t;
                *nearest = Some(hit);
            }
        }
    }
}

/// Whether a ray may meet what is in a box before `t_max`: by slabs, a little wider than rounding can make them too narrow (Ize,
/// "Robust BVH Ray Traversal", JCGT 2(2), 2013).
#[inline]
fn is_met(bounds: &Bounds3, origin: Vec3, inverse: Vec3, t_max: f32) -> bool {
    let (a, b) = ((bounds.min - origin) * inverse, (bounds.max - origin) * inverse);
    // Zero times infinity is no number; min and max then take the other.
    let (near, far) = (a.min(b), a.max(b));
    let near = near.x.max(near.y).max(near.z).max(0.0);
    let far = far.x.min(far.y).min(far.z).min(t_max);
    near <= far * (1.0 + 4.0 * f32::EPSILON)
}

impl Lamp {
    fn bounds(&self) -> Bounds3 {
        // A little larger, for rounding.
        let margin = self.position.abs().max_element() * (4.0 * f32::EPSILON);
        let reach = match self.form {
            LampForm::Ball => Vec3::splat(self.radius + margin),
            LampForm::Disc => Vec3::new(self.radius + margin, margin, self.radius + margin),
        };
        Bounds3 { min: self.position - reach, max: self.position + reach }
    }

    #[inline]
    fn intersect(&self, ray: &Ray, t_max: f32) -> Option<LampHit> {
        match self.form {
            LampForm::Ball => self.intersect_ball(ray, t_max),
            LampForm::Disc => self.intersect_disc(ray, t_max),
        }
    }

    /// The quadratic equation without cancellation (Haines, Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere
    /// Intersection", Ray Tracing Gems, 2019).
    #[inline]
    fn intersect_ball(&self, ray: &Ray, t_max: f32) -> Option<LampHit> {
        let f = ray.origin - self.position;
        let a = ray.direction.length_squared();
        let b = -f.dot(ray.direction);
        let radius2 = self.radius * self.radius;
        let c = f.length_squared() - radius2;
        // From inside, or on the way off, it is not seen.
        if b <= 0.0 || c <= 0.0 {
            return None;
        }
        let nearest = f + ray.direction * (b / a);
        let height2 = radius2 - nearest.length_squared();
        if height2 < 0.0 {
            return None;
        }
        let t = c / (b + (a * height2).sqrt());
        if !(t > 0.0 && t < t_max) {
            return None;
        }
        let n = (f + ray.direction * t).try_normalize()?;
        Some(LampHit { t, light: self.light, y: self.position + n * self.radius, n })
    }

    #[inline]
    fn intersect_disc(&self, ray: &Ray, t_max: f32) -> Option<LampHit> {
        let t = (self.position.y - ray.origin.y) / ray.direction.y;
        if !(t > 0.0 && t < t_max) {
            return None;
        }
        let p = ray.at(t);
        let (x, z) = (p.x - self.position.x, p.z - self.position.z);
        if x * x + z * z > self.radius * self.radius {
            return None;
        }
        let n = if ray.direction.y < 0.0 { Vec3::Y } else { Vec3::NEG_Y };
        Some(LampHit { t, light: self.light, y: Vec3::new(p.x, self.position.y, p.z), n })
    }
}
