//! Rays and hits by the block, component by component, so that a kernel loads as many as it has lanes.

use vitrine_math::{Ray, Vec3};

/// Rays in a block: the widest kernel's lanes.
pub const BLOCK: usize = 16;

/// One number for each ray of a block.
pub type Column = [f32; BLOCK];

/// "No primitive." As the bits of a float it is the largest, so integers below it order as floats do.
pub const NOTHING: u32 = 0x7f7f_ffff;

/// Sixteen rays.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct RayBlock {
    pub(crate) origin: [Column; 3],
    pub(crate) direction: [Column; 3],
    /// Ends; negative for places without a ray, which hit nothing.
    pub(crate) t_max: Column,
    /// Where hits begin to count: after this distance, and at it after that triangle of that primitive.
    pub(crate) start_t: Column,
    /// The bits of an integer.
    pub(crate) start_primitive: Column,
    /// The bits of an integer.
    pub(crate) start_triangle: Column,
}

impl RayBlock {
    const EMPTY: Self = Self {
        origin: [[0.0; BLOCK]; 3],
        direction: [[0.0; BLOCK]; 3],
        t_max: [-1.0; BLOCK],
        start_t: [0.0; BLOCK],
        start_primitive: [0.0; BLOCK],
        start_triangle: [0.0; BLOCK],
    };
}

impl RayBlock {
    /// One of them.
    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> Ray {
        let at = |v: &[Column; 3]| Vec3::new(v[0][lane], v[1][lane], v[2][lane]);
        Ray { origin: at(&self.origin), direction: at(&self.direction), t_max: self.t_max[lane] }
    }
}

/// Rays to be traced.
///
/// A ray starts at its origin, or after a hit: one that goes straight on through a surface is the same ray, started after
/// that surface. Nothing is rounded then and no offset is needed, so surfaces in the same place, such as a case on its
/// floor, are both met.
#[derive(Debug, Default)]
pub struct RayStream {
    /// As many as there ever were; those behind the last ray mean nothing.
    places: Vec<RayBlock>,
    len: usize,
}

impl RayStream {
    /// How many rays there are.
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
        self.len = 0;
    }

    /// Makes places for so many rays in all. The caller writes what is new, to the end of the last block.
    #[inline(always)]
    pub(crate) fn resize(&mut self, len: usize) -> &mut [RayBlock] {
        let blocks = len.div_ceil(BLOCK);
        if self.places.len() < blocks {
            self.places.resize(blocks, RayBlock::EMPTY);
        }
        self.len = len;
        &mut self.places[..blocks]
    }

    /// Adds a ray that starts at its origin.
    #[inline(always)]
    pub fn push(&mut self, ray: &Ray) {
        self.push_after(ray, 0.0, NOTHING, NOTHING);
    }

    /// Adds a ray that starts after a hit of its own.
    #[inline(always)]
    pub fn push_on(&mut self, ray: &Ray, hit: &Hit) {
        self.push_after(ray, hit.t, hit.primitive, hit.triangle);
    }

    #[inline(always)]
    fn push_after(&mut self, ray: &Ray, t: f32, primitive: u32, triangle: u32) {
        let lane = self.len % BLOCK;
        let Some(block) = self.resize(self.len + 1).last_mut() else { return };
        if lane == 0 {
            *block = RayBlock::EMPTY;
        }
        for k in 0..3 {
            block.origin[k][lane] = ray.origin[k];
            block.direction[k][lane] = ray.direction[k];
        }
        block.t_max[lane] = ray.t_max;
        block.start_t[lane] = t;
        block.start_primitive[lane] = f32::from_bits(primitive);
        block.start_triangle[lane] = f32::from_bits(triangle);
    }

    /// The rays in blocks.
    #[inline(always)]
    pub(crate) fn blocks(&self) -> &[RayBlock] {
        &self.places[..self.len.div_ceil(BLOCK)]
    }

    /// A ray.
    ///
    /// # Panics
    /// When there is no such ray.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, i: usize) -> Ray {
        self.blocks()[i / BLOCK].get(i % BLOCK)
    }
}

/// Sixteen hits.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct HitBlock {
    pub(crate) t: Column,
    /// The bits of an integer.
    pub(crate) primitive: Column,
    /// The bits of an integer.
    pub(crate) triangle: Column,
    pub(crate) u: Column,
    pub(crate) v: Column,
}

impl HitBlock {
    pub(super) const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        Self { t: zero, primitive: zero, triangle: zero, u: zero, v: zero }
    };
}

impl HitBlock {
    /// One of them; of [`NOTHING`] where nothing is hit.
    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> Hit {
        Hit {
            t: self.t[lane],
            primitive: self.primitive[lane].to_bits(),
            triangle: self.triangle[lane].to_bits(),
            uv: [self.u[lane], self.v[lane]],
        }
    }
}

/// The nearest hits of a stream of rays.
#[derive(Debug, Default)]
pub struct HitStream {
    pub(super) blocks: Vec<HitBlock>,
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
    /// Barycentric coordinates of a triangle's second and third corner; 0 for other forms.
    pub uv: [f32; 2],
}

impl HitStream {
    /// The hits of a block of rays.
    #[inline(always)]
    pub(crate) fn block(&self, i: usize) -> &HitBlock {
        &self.blocks[i]
    }

    /// The hit of a ray, or None when it hits nothing.
    ///
    /// # Panics
    /// When there is no such ray.
    #[inline(always)]
    #[must_use]
    pub fn get(&self, i: usize) -> Option<Hit> {
        let hit = self.blocks[i / BLOCK].get(i % BLOCK);
        (hit.primitive != NOTHING).then_some(hit)
    }
}
