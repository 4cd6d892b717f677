//! The points of hits one after another, for who works on them one by one.

use super::{HitLanes, HitPoints};
use crate::accel::packet::store3;
use crate::accel::simd::{Kernel, Portable, Simd};
use crate::accel::single::One;
use crate::accel::{BLOCK, Column, Hit, HitStream, NOTHING, RayStream};
use crate::compile::CompiledScene;
use vitrine_math::Vec3;

/// A point of a surface that a ray has hit.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// The hit.
    pub hit: Hit,
    /// The point, put back onto the surface where rounding took it off. World space.
    pub p: Vec3,
    /// The unit normal of the form, on the viewer's side.
    pub n: Vec3,
    /// The unit normal for shading, on the viewer's side of the form.
    pub ns: Vec3,
    /// Whether the viewer is on the outer side.
    pub is_outside: bool,
    /// The largest number that took part in finding the point.
    pub reach: f32,
    /// The index of the material.
    pub material: u32,
}

/// Sixteen of them, component by component.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct SpotBlock {
    p: [Column; 3],
    n: [Column; 3],
    ns: [Column; 3],
    is_outside: Column,
    reach: Column,
    material: Column,
}

impl SpotBlock {
    const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        let three = [zero; 3];
        Self { p: three, n: three, ns: three, is_outside: zero, reach: zero, material: zero }
    };
}

/// The points of a stream of hits.
#[derive(Debug, Default)]
pub struct Spots {
    blocks: Vec<SpotBlock>,
}

impl Spots {
    /// Works out the points where rays of unit direction have hit.
    pub fn fill(&mut self, scene: &CompiledScene, rays: &RayStream, hits: &HitStream) {
        let count = rays.blocks().len();
        if self.blocks.len() < count {
            self.blocks.resize(count, SpotBlock::EMPTY);
        }
        scene.accel.instructions.run(Fill { scene, rays, hits, blocks: &mut self.blocks });
    }

    /// One of them, of a hit.
    #[inline]
    pub fn get(&self, i: usize, hit: Hit) -> Spot {
        let (block, lane) = (&self.blocks[i / BLOCK], i % BLOCK);
        let at = |v: &[Column; 3]| Vec3::new(v[0][lane], v[1][lane], v[2][lane]);
        Spot {
            hit,
            p: at(&block.p),
            n: at(&block.n),
            ns: at(&block.ns),
            is_outside: block.is_outside[lane] > 0.0,
            reach: block.reach[lane],
            material: block.material[lane].to_bits(),
        }
    }
}

impl CompiledScene {
    /// Where a point that ray `i` has hit lies on the pictures of its surface: u to the right, v up.
    pub(crate) fn uv_of(&self, rays: &RayStream, hits: &HitStream, i: usize, p: Vec3) -> [f32; 2] {
        let at = HitLanes { rays: &rays.blocks()[i / BLOCK], hits: hits.block(i / BLOCK), start: i % BLOCK };
        let points = HitPoints { at: &at, hit: true, p: p.to_array() };
        self.texture_points(One(Portable), true, &points)
    }

    /// The ways over a surface in which u and v grow, in metres for each 1 of u and v. World space.
    pub(crate) fn tangents(&self, spot: &Spot) -> [Vec3; 2] {
        self.primitives[spot.hit.primitive as usize].tangents(spot)
    }
}

struct Fill<'a> {
    scene: &'a CompiledScene,
    rays: &'a RayStream,
    hits: &'a HitStream,
    blocks: &'a mut [SpotBlock],
}

impl Kernel for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let (zero, one, nothing) = (s.splat(0.0), s.splat(1.0), s.splat(f32::from_bits(NOTHING)));
        for (i, (rays, block)) in self.rays.blocks().iter().zip(self.blocks).enumerate() {
            let hits = self.hits.block(i);
            for start in (0..BLOCK).step_by(S::LANES) {
                let hit = s.lt(s.load(&hits.primitive[start..]), nothing);
                if s.bits(hit) == 0 {
                    continue;
                }
                let (points, materials) = self.scene.met(s, hit, &HitLanes { rays, hits, start });
                store3(s, &points.p, &mut block.p, start);
                store3(s, &points.n, &mut block.n, start);
                store3(s, &points.ns, &mut block.ns, start);
                s.store(s.select(points.is_outside, one, zero), &mut block.is_outside[start..]);
                s.store(points.reach, &mut block.reach[start..]);
                block.material[start..start + S::LANES].copy_from_slice(&materials[..S::LANES]);
            }
        }
    }
}
