//! Things that stand exactly on others. A glass block on its floor has a face in the floor's plane, and rounding would show now
//! one, now the other before the other: speckles. So transparent boxes and models draw back by a little more than
//! rounding can move, far less than can be seen; the floor is then always met after the glass.

use super::materials::MaterialTable;
use super::models::Models;
use super::overlapping::{Placed, overlap};
use vitrine_math::{Bounds3, OFFSET_SHARE, Transform, Vec3};
use vitrine_scene::{Geometry, Renderer};

/// How many times farther than a ray's start a face draws back, times 1 to [`RANKS`]: a bent ray that leaves the glass starts
/// beyond its face and must still be before the floor.
pub const STEPS: f32 = 2.0;
/// Neighbours in the scene's list draw back differently, so that two glass blocks that touch stay apart as well.
const RANKS: u32 = 4;
/// The largest part of a thin pane's thickness that it may lose on each side.
const MOST: f32 = 1e-3;

/// Keeps apart what touches: transparent things draw back, or where the renderer bends light at them, grow into each other.
pub fn separate(placed: &mut [Placed], renderer: Renderer, table: &MaterialTable, models: &Models) {
    let is_solid = |p: &Placed| {
        let materials = &table.physical[p.materials.start as usize..p.materials.end as usize];
        let glass = materials.iter().find(|m| m.is_transmissive());
        glass.is_some_and(|m| match &p.geometry {
            Geometry::Mesh(mesh) | Geometry::Facets(mesh) => {
                !m.numbers.geometry_thin_walled.unwrap_or_else(|| !models.is_closed(mesh))
            }
            _ => !m.numbers.geometry_thin_walled.unwrap_or(false),
        })
    };
    let mut solids = Vec::new();
    for (id, one) in placed.iter_mut().enumerate() {
        if renderer == Renderer::Photoreal && is_solid(one) {
            solids.push(id);
        } else if table.is_any_transparent(one.materials.clone()) {
            let geometry = one.geometry.clone();
            (one.geometry, one.transform) = drawn_back(geometry, one.transform, &one.bounds, id as u32);
        }
    }
    overlap(placed, &solids);
}

/// The largest number on the way to the world and back, of a form in a space of its own whose coordinates reach so far.
pub fn reach_of(transform: &Transform, size: Vec3) -> f32 {
    let m = &transform.world_from_object;
    let [x, y, z] = [0, 1, 2].map(|k| (m.matrix3.col(k) * size[k]).abs());
    (x + y + z + m.translation.abs()).max_element()
}

/// A form of a transparent thing and its place, both a little smaller. `id` is its place among the scene's primitives, `bounds`
/// a model's box.
fn drawn_back(geometry: Geometry, transform: Transform, bounds: &Bounds3, id: u32) -> (Geometry, Transform) {
    let (half, reach) = match &geometry {
        Geometry::Box { half } => (*half, reach_of(&transform, *half)),
        Geometry::Mesh(_) | Geometry::Facets(_) if !bounds.is_empty() => {
            (bounds.size() * 0.5, reach_of(&transform, bounds.min.abs().max(bounds.max.abs())))
        }
        // Balls touch in points; planes and single triangles have no inside to draw back to.
        _ => return (geometry, transform),
    };
    let scale = share_left(half, reach, &transform, id);
    scaled(geometry, transform, bounds, scale)
}

/// A form and its place, so many times as large along each of its own axes. `bounds` is a model's box, whose middle stays.
pub fn scaled(
    geometry: Geometry,
    transform: Transform,
    bounds: &Bounds3,
    scale: Vec3,
) -> (Geometry, Transform) {
    match geometry {
        Geometry::Box { half } => (Geometry::Box { half: half * scale }, transform),
        Geometry::Sphere { radius } => (Geometry::Sphere { radius: radius * scale.max_element() }, transform),
        Geometry::Mesh(_) | Geometry::Facets(_) => {
            let about_middle =
                Transform::from_place(bounds.center() * (Vec3::ONE - scale), Vec3::ZERO, scale);
            (geometry, transform.after(&about_middle))
        }
        _ => (geometry, transform),
    }
}

/// The part of each half edge that is left.
fn share_left(half: Vec3, reach: f32, transform: &Transform, id: u32) -> Vec3 {
    let step = STEPS * OFFSET_SHARE * reach * (1 + id % RANKS) as f32;
    Vec3::from_array([0, 1, 2].map(|k| {
        let half_edge = transform.world_from_object.matrix3.col(k).length() * half[k];
        // What is flat, or too large or small to tell, stays as it is.
        if half_edge > 0.0 && step.is_finite() { 1.0 - (step / half_edge).min(MOST) } else { 1.0 }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_of(geometry: &Geometry) -> Vec3 {
        let Geometry::Box { half } = geometry else { panic!("a box stays a box") };
        *half
    }

    #[test]
    fn boxes_lose_millionths_and_neighbours_differ() {
        let half = Vec3::new(0.5, 1.0, 0.01);
        let losses: Vec<_> = (0..4)
            .map(|id| {
                half - half_of(
                    &drawn_back(Geometry::Box { half }, Transform::default(), &Bounds3::EMPTY, id).0,
                )
            })
            .collect();
        for (k, loss) in losses.iter().enumerate() {
            assert!(loss.cmpgt(Vec3::ZERO).all() && loss.max_element() < 2e-5, "{loss}");
            assert!(loss.z <= 1.01e-5, "a thin pane keeps its thickness");
            assert!(losses[..k].iter().all(|other| (other.y - loss.y).abs() > 3e-6));
        }
    }

    #[test]
    fn huge_and_tiny_boxes_stay_boxes() {
        for size in [1e-38_f32, 1e-20, 1e18, 3e38] {
            let half = Vec3::splat(size);
            let back =
                half_of(&drawn_back(Geometry::Box { half }, Transform::default(), &Bounds3::EMPTY, 1).0);
            assert!(back.cmpgt(half * 0.99).all() && back.cmple(half).all(), "{back}");
        }
    }
}
