//! What shading needs to know of the points where rays meet surfaces, worked out once a hit, sixteen at a time.

mod coordinates;
mod field;
mod leaving;
mod look;
mod other;
mod spot;

pub use field::NormalField;
pub use look::Look;
pub use spot::{Spot, Spots};

use crate::accel::packet::{along3, load3};
use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column, HitBlock, RayBlock};
use crate::compile::CompiledScene;
use field::Fields;
use other::Arrival;

/// Points of surfaces in lanes, each seen along a ray.
#[derive(Clone, Copy)]
pub struct Points<S: Simd> {
    /// The points, put back onto the surface where rounding took them off. World space.
    pub p: [S::F; 3],
    /// The unit normals of the forms, on the viewer's side.
    pub n: [S::F; 3],
    /// The unit normals for shading, on the viewer's side of the form.
    pub ns: [S::F; 3],
    /// The unit directions to the viewer.
    pub wo: [S::F; 3],
    /// Where the viewer is on the outer side.
    pub is_outside: S::M,
    /// The largest number that took part in finding the point. Rounding is a part of it.
    pub reach: S::F,
}

/// What is hit in lanes: where, and what it is made of. Lanes without a hit mean nothing.
#[derive(Clone, Copy)]
pub struct Seen<S: Simd> {
    /// The points.
    pub points: Points<S>,
    /// The material, a texture in place of its colour.
    pub look: Look<S>,
}

impl CompiledScene {
    /// What rays of unit direction hit, in the lanes of the mask, from the lane `start` of a block on.
    #[inline(always)]
    pub(crate) fn seen<S: Simd>(&self, s: S, hit: S::M, at: &HitLanes) -> Seen<S> {
        let (points, materials) = self.met(s, hit, at);
        Seen { look: self.look(s, &HitPoints { at, hit, p: points.p }, &materials), points }
    }

    /// Where they hit it, and the indices of the materials as the bits of floats.
    #[inline(always)]
    pub(crate) fn met<S: Simd>(&self, s: S, hit: S::M, at: &HitLanes) -> (Points<S>, Column) {
        let &HitLanes { rays, hits, start } = at;
        let primitives = s.load(&hits.primitive[start..]);
        let (mut fields, mut material) = (Fields::empty(s), s.splat(0.0));
        let (mut others, mut by_triangle) = (0, 0);
        // Neighbours mostly hit the same thing: so it goes thing by thing, not lane by lane.
        let mut left = s.bits(hit);
        while left != 0 {
            let id = hits.primitive[start + left.trailing_zeros() as usize];
            let same = s.eq(primitives, s.splat(id));
            let lanes = s.bits(same);
            let field = &self.normals[id.to_bits() as usize];
            fields.put(s, same, field);
            material = s.select(same, s.splat(f32::from_bits(field.material)), material);
            others |= if field.is_other { lanes } else { 0 };
            by_triangle |= if field.by_triangle { lanes } else { 0 };
            left &= !lanes;
        }
        let mut materials = [0.0; BLOCK];
        s.store(material, &mut materials);
        for lane in lanes_of(by_triangle) {
            let primitive = hits.primitive[start + lane].to_bits() as usize;
            let triangle = hits.triangle[start + lane].to_bits();
            materials[lane] = f32::from_bits(self.primitives[primitive].material_of(triangle));
        }
        let d = load3(s, &rays.direction, start);
        let p = along3(s, &load3(s, &rays.origin, start), &d, s.load(&hits.t[start..]));
        let mut points = fields.points(s, &p, &d);
        if others != 0 {
            self.replace_others(s, others, &Arrival { at, p, d }, &mut points);
        }
        (points, materials)
    }
}

/// Hits of rays, from a lane of their block on.
#[derive(Clone, Copy)]
pub struct HitLanes<'a> {
    /// The rays.
    pub rays: &'a RayBlock,
    /// Their hits.
    pub hits: &'a HitBlock,
    /// The first lane.
    pub start: usize,
}

/// Hits in the lanes of a mask, with their points.
struct HitPoints<'a, S: Simd> {
    at: &'a HitLanes<'a>,
    hit: S::M,
    p: [S::F; 3],
}

/// The lanes of a mask's bits.
#[inline(always)]
pub fn lanes_of(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (bits != 0).then(|| bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        lane
    })
}
