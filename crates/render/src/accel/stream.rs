//! Rays and hits by the thousand, component by component, so that a kernel loads as many as it has lanes.

use vitrine_math::{Ray, Vec3};

/// The widest kernel's lanes: streams are padded to a multiple of it.
pub const MAX_LANES: usize = 16;

/// Rays to be traced, in arrays by component.
#[derive(Debug, Default)]
pub struct RayStream {
    /// Origins, x, y and z.
    pub origin: [Vec<f32>; 3],
    /// Directions, x, y and z.
    pub direction: [Vec<f32>; 3],
    /// Ends; negative for padding, which hits nothing.
    pub t_max: Vec<f32>,
    len: usize,
}

impl RayStream {
    /// How many rays there are, without padding.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Takes all rays out.
    pub fn clear(&mut self) {
        for v in self.components() {
            v.clear();
        }
        self.len = 0;
    }

    /// Adds a ray.
    #[inline(always)]
    pub fn push(&mut self, ray: &Ray) {
        for (to, v) in self.origin.iter_mut().zip(ray.origin.to_array()) {
            to.push(v);
        }
        for (to, v) in self.direction.iter_mut().zip(ray.direction.to_array()) {
            to.push(v);
        }
        self.t_max.push(ray.t_max);
        self.len += 1;
    }

    /// A ray.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, i: usize) -> Ray {
        let at = |v: &[Vec<f32>; 3]| Vec3::new(v[0][i], v[1][i], v[2][i]);
        Ray { origin: at(&self.origin), direction: at(&self.direction), t_max: self.t_max[i] }
    }

    /// Fills up to whole packets with rays that hit nothing.
    pub(super) fn pad(&mut self) {
        let padded = self.len.next_multiple_of(MAX_LANES);
        for v in self.components() {
            v.truncate(padded);
            v.resize(padded, -1.0);
        }
    }

    fn components(&mut self) -> impl Iterator<Item = &mut Vec<f32>> {
        self.origin.iter_mut().chain(&mut self.direction).chain(std::iter::once(&mut self.t_max))
    }
}

/// Where on its way each ray of a stream starts to count hits: after a distance, and at that distance after a primitive.
///
/// A ray that goes straight on through a surface is the same ray, started after that surface: nothing is rounded and no
/// offset is needed, so surfaces in the same place, such as a case on its floor, are both met.
#[derive(Debug, Default)]
pub struct Starts {
    pub(super) t: Vec<f32>,
    /// The bits of an integer.
    pub(super) primitive: Vec<f32>,
    /// The bits of an integer.
    pub(super) triangle: Vec<f32>,
}

impl Starts {
    /// Takes all out.
    pub fn clear(&mut self) {
        for v in self.components() {
            v.clear();
        }
    }

    /// The next ray starts at its origin.
    #[inline(always)]
    pub fn push_origin(&mut self) {
        self.push_after(0.0, NOTHING, NOTHING);
    }

    /// The next ray starts after that hit.
    #[inline(always)]
    pub fn push_hit(&mut self, hit: &Hit) {
        self.push_after(hit.t, hit.primitive, hit.triangle);
    }

    #[inline(always)]
    fn push_after(&mut self, t: f32, primitive: u32, triangle: u32) {
        self.t.push(t);
        self.primitive.push(f32::from_bits(primitive));
        self.triangle.push(f32::from_bits(triangle));
    }

    pub(super) fn pad(&mut self, padded: usize) {
        for v in self.components() {
            v.resize(padded, 0.0);
        }
    }

    fn components(&mut self) -> [&mut Vec<f32>; 3] {
        [&mut self.t, &mut self.primitive, &mut self.triangle]
    }
}

/// "No primitive."
pub const NOTHING: u32 = 0x7f7f_ffff;

/// The nearest hits of a stream of rays, in arrays by component.
#[derive(Debug, Default)]
pub struct HitStream {
    /// Distances in lengths of the direction; the ray's end where nothing is hit.
    pub t: Vec<f32>,
    /// Which primitive of the scene, or [`NOTHING`]. The bits of an integer.
    pub(super) primitive: Vec<f32>,
    /// Which triangle of a mesh; 0 for other primitives. The bits of an integer.
    pub(super) triangle: Vec<f32>,
    /// Barycentric coordinates of the second corner of a triangle.
    pub u: Vec<f32>,
    /// Barycentric coordinates of the third corner of a triangle.
    pub v: Vec<f32>,
}

/// One hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The distance in lengths of the direction.
    pub t: f32,
    /// The index of the scene's primitive.
    pub primitive: u32,
    /// The index of a mesh's triangle; 0 for other primitives.
    pub triangle: u32,
    /// Barycentric coordinates of a triangle's second and third corner.
    pub uv: [f32; 2],
}

impl HitStream {
    pub(super) fn reset(&mut self, padded: usize) {
        for v in [&mut self.t, &mut self.primitive, &mut self.triangle, &mut self.u, &mut self.v] {
            v.clear();
            v.resize(padded, 0.0);
        }
    }

    /// The hit of a ray, or None when it hits nothing.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, i: usize) -> Option<Hit> {
        let primitive = self.primitive[i].to_bits();
        (primitive != NOTHING).then(|| Hit {
            t: self.t[i],
            primitive,
            triangle: self.triangle[i].to_bits(),
            uv: [self.u[i], self.v[i]],
        })
    }
}
