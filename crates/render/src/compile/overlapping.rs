//! Solids that touch, in the photoreal renderer. Water that stands exactly on its floor or in its glass must have no gap there, for a film
//! of air, however thin, reflects light and at a slant all of it. So each solid grows by a little more than rounding can
//! move, far less than can be seen: the floor is then met while still in the water, and where two solids overlap the smaller one is
//! there, so that water and glass have one surface between them ([`solids`](super::solids)).
//!
//! Of solids within each other (glass, the hollow in it, the water that fills the hollow) some faces may be the same. The one that is
//! there grows more than the one that it replaces, and covers it.

use super::touching::{STEPS, reach_of, scaled};
use std::ops::Range;
use vitrine_math::{Bounds3, OFFSET_SHARE, Transform, Vec3};
use vitrine_scene::Geometry;

/// So many steps a solid grows at most, however many it lies within.
const MOST_STEPS: f32 = 16.0;
/// The largest part of its thickness by which a thin pane grows on each side.
const MOST: f32 = 0.02;

/// An object on its way to become a primitive.
pub struct Placed {
    /// The index of its object in the scene.
    pub object: usize,
    /// Its shape.
    pub geometry: Geometry,
    /// Its place.
    pub transform: Transform,
    /// Its materials.
    pub materials: Range<u32>,
    /// Whether a mesh's triangles choose among them.
    pub by_triangle: bool,
    /// A model's box in its own space; empty for other forms.
    pub bounds: Bounds3,
    /// The size of the space that it takes, cubic metres; infinite where it has no inside.
    pub volume: f64,
}

impl Placed {
    /// The box around it in its own space; None: it has no end, or no inside.
    fn own(&self) -> Option<Bounds3> {
        let around = |half: Vec3| Bounds3 { min: -half, max: half };
        match &self.geometry {
            Geometry::Sphere { radius } => Some(around(Vec3::splat(*radius))),
            Geometry::Box { half } => Some(around(*half)),
            Geometry::Mesh(_) | Geometry::Facets(_) if !self.bounds.is_empty() => Some(self.bounds),
            _ => None,
        }
    }

    /// Sets its volume: that of its box in its own space.
    pub fn measure(&mut self) {
        self.volume = self.own().map_or(f64::INFINITY, |own| {
            let size = own.size().as_dvec3();
            let scale = f64::from(self.transform.world_from_object.matrix3.determinant()).abs();
            size.x * size.y * size.z * scale
        });
    }
}

/// A solid that grows.
struct Grower {
    /// Its place in the list.
    place: usize,
    is_ball: bool,
    own: Bounds3,
    /// In the world.
    bounds: Bounds3,
    /// One step of growth, metres.
    step: f32,
    /// How much it grows, metres.
    growth: f32,
}

/// Lets solids grow, those of the places that are given.
pub fn overlap(placed: &mut [Placed], solids: &[usize]) {
    let mut growers: Vec<Grower> = solids.iter().filter_map(|&place| grower(&placed[place], place)).collect();
    // The largest first; of equal ones the later in the list is there, so it grows more.
    growers.sort_by(|a, b| {
        placed[b.place].volume.total_cmp(&placed[a.place].volume).then(a.place.cmp(&b.place))
    });
    let lower = overlapped(&growers);
    for (k, lower) in lower.iter().enumerate() {
        let Grower { is_ball, step, .. } = growers[k];
        let below = lower.iter().map(|&l| &growers[l]);
        // A ball touches others in points, but for one that is the same.
        let below = below.filter(|other| !is_ball || is_same(&growers[k], other));
        let covered = below.fold(None, |most: Option<(f32, f32)>, other| {
            let (growth, widest) = most.unwrap_or((0.0, step));
            Some((growth.max(other.growth), widest.max(other.step)))
        });
        growers[k].growth = match covered {
            Some((growth, widest)) => (growth + widest).min(MOST_STEPS * widest),
            None if is_ball => 0.0,
            None => step,
        };
    }
    for grower in &growers {
        grow(&mut placed[grower.place], grower);
    }
}

fn grower(placed: &Placed, place: usize) -> Option<Grower> {
    let own = placed.own()?;
    let bounds = placed.transform.bounds(&own);
    let step = STEPS * OFFSET_SHARE * reach_of(&placed.transform, own.min.abs().max(own.max.abs()));
    let is_ball = matches!(placed.geometry, Geometry::Sphere { .. });
    step.is_finite().then_some(Grower { place, is_ball, own, bounds, step, growth: 0.0 })
}

/// For each solid those before it in the order whose boxes meet its box.
fn overlapped(growers: &[Grower]) -> Vec<Vec<usize>> {
    let mut lower = vec![Vec::new(); growers.len()];
    // Along the x axis only neighbours need be compared.
    let from = |k: usize| growers[k].bounds.min.x - MOST_STEPS * growers[k].step;
    let to = |k: usize| growers[k].bounds.max.x + MOST_STEPS * growers[k].step;
    let mut along: Vec<usize> = (0..growers.len()).collect();
    along.sort_by(|&a, &b| from(a).total_cmp(&from(b)));
    for (i, &a) in along.iter().enumerate() {
        for &b in along[i + 1..].iter().take_while(|&&b| from(b) <= to(a)) {
            let margin = Vec3::splat(MOST_STEPS * growers[a].step.max(growers[b].step));
            let (one, other) = (&growers[a].bounds, &growers[b].bounds);
            if one.min.cmple(other.max + margin).all() && other.min.cmple(one.max + margin).all() {
                lower[a.max(b)].push(a.min(b));
            }
        }
    }
    lower
}

/// Whether two are the same ball, but for rounding.
fn is_same(a: &Grower, b: &Grower) -> bool {
    let near = MOST_STEPS * a.step.max(b.step);
    let off = |p: Vec3, q: Vec3| (p - q).abs().max_element();
    b.is_ball && off(a.bounds.min, b.bounds.min) < near && off(a.bounds.max, b.bounds.max) < near
}

fn grow(placed: &mut Placed, grower: &Grower) {
    let half = grower.own.size() * 0.5;
    let scale = Vec3::from_array([0, 1, 2].map(|k| {
        let half_edge = placed.transform.world_from_object.matrix3.col(k).length() * half[k];
        // What is flat, or too large or small to tell, stays as it is.
        let share = grower.growth / half_edge;
        if half_edge > 0.0 && share.is_finite() { 1.0 + share.min(MOST) } else { 1.0 }
    }));
    let geometry = placed.geometry.clone();
    (placed.geometry, placed.transform) = scaled(geometry, placed.transform, &placed.bounds, scale);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(geometry: Geometry, position: Vec3) -> Placed {
        let transform = Transform::from_place(position, Vec3::ZERO, Vec3::ONE);
        let bounds = Bounds3::EMPTY;
        let mut placed = Placed {
            object: 0,
            geometry,
            transform,
            materials: 0..1,
            by_triangle: false,
            bounds,
            volume: 0.0,
        };
        placed.measure();
        placed
    }

    fn cuboid(half: f32, x: f32) -> Placed {
        placed(Geometry::Box { half: Vec3::splat(half) }, Vec3::X * x)
    }

    fn grown(mut all: Vec<Placed>) -> Vec<f32> {
        let solids: Vec<_> = (0..all.len()).collect();
        overlap(&mut all, &solids);
        let size = |p: &Placed| match p.geometry {
            Geometry::Box { half } => half.x,
            Geometry::Sphere { radius } => radius,
            _ => panic!("forms stay what they are"),
        };
        all.iter().map(size).collect()
    }

    #[test]
    fn what_is_there_grows_more_than_what_it_replaces() {
        // Water in the hollow of a glass, the same size as the hollow; and in another order.
        let nested = grown(vec![cuboid(1.0, 0.0), cuboid(0.5, 0.0), cuboid(0.5, 0.0)]);
        let gained = [nested[0] - 1.0, nested[1] - 0.5, nested[2] - 0.5];
        assert!(gained[0] > 1e-6 && gained[1] > gained[0] + 1e-6 && gained[2] > gained[1] + 1e-6);
        assert!(gained[2] < 3e-5, "{gained:?}");
        let other = grown(vec![cuboid(0.5, 0.0), cuboid(0.5, 0.0), cuboid(1.0, 0.0)]);
        assert_eq!(other, [nested[1], nested[2], nested[0]]);
    }

    #[test]
    fn those_far_from_each_other_grow_one_step_and_none_grows_much() {
        let apart = grown(vec![cuboid(0.5, 0.0), cuboid(0.5, 7.0)]);
        let step = |reach: f32| STEPS * OFFSET_SHARE * reach;
        assert!((apart[0] - 0.5 - step(0.5)).abs() < 1e-7 && (apart[1] - 0.5 - step(7.5)).abs() < 1e-7);
        let pile = grown((0..100).map(|_| cuboid(0.5, 0.0)).collect());
        assert!(pile.iter().all(|half| half - 0.5 < 17.0 * step(0.5)));
    }

    #[test]
    fn balls_stay_exact_but_for_those_that_are_the_same() {
        let ball = |radius: f32, x: f32| placed(Geometry::Sphere { radius }, Vec3::X * x);
        assert_eq!(grown(vec![ball(0.5, 0.0), ball(0.3, 0.8), cuboid(0.5, 0.0)])[..2], [0.5, 0.3]);
        let same = grown(vec![ball(0.5, 0.0), ball(0.5, 0.0)]);
        assert!(same[0] == 0.5 && same[1] > 0.5 + 1e-6, "{same:?}");
    }

    #[test]
    fn huge_and_tiny_ones_stay_numbers() {
        for size in [1e-38_f32, 1e-20, 1e18, 3e38] {
            let half = grown(vec![cuboid(size, 0.0), cuboid(size, 0.0)]);
            assert!(half.iter().all(|h| *h >= size && *h <= size * 1.021), "{half:?}");
        }
    }
}
