//! No ray gets between two triangles: ten million rays are shot at closed models from inside, at random and exactly along edges
//! and at corners, singly and in packets, with every instruction set, and each must hit. From outside, a ray towards a point
//! inside must hit, too.

// A test may unwrap, and so may what helps it.
#![allow(clippy::unwrap_used)]

mod meshes;

use meshes::{Closed, cave, cube, icosphere, slivers, tiles};
use std::sync::Arc;
use vitrine_math::{Bounds3, Ray, Transform, Vec3, hash};
use vitrine_render::accel::simd::Instructions;
use vitrine_render::accel::{Accel, HitStream, Instance, MaterialSlots, MeshAccel, Primitives, RayStream};

/// Rays in all tests together, counted for each way of tracing them.
const RAYS: usize = 10_000_000;
/// Pairs of a model and a place in all tests together.
const CASES: usize = MODELS * PLACES;
const MODELS: usize = 9;
const PLACES: usize = 6;

/// Chance.
struct Numbers(u32);

impl Numbers {
    /// From 0 to 1.
    fn unit(&mut self) -> f32 {
        self.0 += 1;
        hash::unit(hash::mix(self.0))
    }

    /// In the cube from −1 to 1.
    fn vector(&mut self) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| 2.0 * self.unit() - 1.0))
    }

    /// In the ball of radius 1.
    fn in_ball(&mut self) -> Vec3 {
        loop {
            let p = self.vector();
            if p.length() <= 1.0 {
                return p;
            }
        }
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f32) as usize).min(count - 1)
    }
}

/// Where models are put: at home, turned, stretched, tiny, huge, far away.
fn places() -> [Transform; PLACES] {
    let turn = Vec3::new(33.0, -71.0, 12.0);
    let at = |position, turn, scale| Transform::from_place(position, turn, scale);
    [
        Transform::default(),
        at(Vec3::ZERO, turn, Vec3::ONE),
        at(Vec3::new(3.0, -5.0, 0.7), -turn, Vec3::new(0.3, 7.0, -1.9)),
        at(Vec3::splat(1e-4), turn, Vec3::splat(1e-4)),
        at(Vec3::new(-2e4, 1e4, 5e3), turn, Vec3::splat(3e4)),
        at(Vec3::new(1e4, 3e3, -2e4), turn, Vec3::new(1.0, 2.0, 1.5)),
    ]
}

/// A model at a place, alone in a scene.
fn scene(model: &Closed, place: &Transform) -> Accel {
    let mesh = Arc::new(MeshAccel::new(&model.positions, &model.triangles, Vec::new()));
    let bounds = place.bounds(&Bounds3::around(model.positions.iter().copied()));
    let instance = Instance { mesh_from_world: place.object_from_world, mesh, primitive: 0 };
    let primitives = Primitives {
        instances: vec![(instance, bounds)],
        materials: vec![MaterialSlots { first: 0, by_triangle: false }],
        ..Primitives::default()
    };
    Accel::new(primitives, vec![0.0])
}

/// A point of the model's surface that two or more triangles share, or any point of it.
fn target(model: &Closed, numbers: &mut Numbers) -> Vec3 {
    let triangle = model.triangles[numbers.below(model.triangles.len())];
    let [a, b, c] = triangle.map(|corner| model.positions[corner as usize]);
    match numbers.below(8) {
        0 | 1 => a,
        2 => a.midpoint(b),
        3..6 => a.lerp(b, numbers.unit()),
        _ => a.lerp(b, numbers.unit()).lerp(c, numbers.unit()),
    }
}

/// Rays from inside, in the world.
fn from_inside(model: &Closed, place: &Transform, numbers: &mut Numbers) -> Ray {
    let aim = target(model, numbers);
    let start = match numbers.below(4) {
        0 => Vec3::ZERO,
        // Level with a corner, so that some components of the direction are zero.
        1 => {
            let mut start = numbers.in_ball() * (0.7 * model.inner);
            let axis = numbers.below(3);
            start[axis] = aim[axis].clamp(-0.6 * model.inner, 0.6 * model.inner);
            start.clamp_length_max(0.9 * model.inner)
        }
        _ => numbers.in_ball() * (0.9 * model.inner),
    };
    let direction = if numbers.below(5) == 0 { numbers.in_ball() } else { aim - start };
    let origin = place.point(start);
    // Half of the directions are turned with the model, the others go from point to point in the world.
    let direction = if numbers.below(2) == 0 { place.vector(direction) } else { place.point(aim) - origin };
    Ray::new(origin, direction)
}

/// Rays from outside that reach a point inside at t = 1, in the world.
fn from_outside(model: &Closed, place: &Transform, numbers: &mut Numbers) -> Ray {
    let end = numbers.in_ball() * (0.8 * model.inner);
    let through = target(model, numbers) - end;
    let beyond = model.outer * (2.0 + 10.0 * numbers.unit());
    let start = match numbers.below(3) {
        0 => numbers.vector().normalize_or(Vec3::X) * beyond,
        // Through the surface at what triangles share.
        _ => end + through.normalize() * beyond,
    };
    let (start, end) = (place.point(start), place.point(end));
    Ray { t_max: 1.0, ..Ray::new(start, end - start) }
}

/// Traces rays in each way, with all instruction sets; none may miss.
fn assert_all_hit(accel: Accel, rays: &[Ray], what: &str) {
    let mut stream = RayStream::default();
    rays.iter().for_each(|ray| stream.push(ray));
    let mut accel = accel;
    for set in Instructions::available() {
        accel = accel.with_instructions(set);
        let missed = |i: usize, way: &str| panic!("{way} with {set:?} miss {what}: {:?}", rays[i]);
        let (mut together, mut alone) = (HitStream::default(), vec![None; rays.len()]);
        accel.closest(&stream, &mut together);
        accel.closest_each(rays, &mut alone);
        for (i, alone) in alone.iter().enumerate() {
            let Some(hit) = together.get(i) else { missed(i, "packets") };
            let Some(same) = alone else { missed(i, "single rays") };
            assert!(hit == *same && hit.t > 0.0, "{hit:?} and {same:?}");
        }
        // Shadows, with a part of them.
        let some = &rays[..rays.len() / 8];
        let (mut together, mut alone) = (Vec::new(), vec![false; some.len()]);
        accel.occluded(&stream, &mut together);
        accel.occluded_each(some, &mut alone);
        together.iter().position(|hit| !hit).inspect(|i| missed(*i, "packets of shadow rays"));
        alone.iter().position(|hit| !hit).inspect(|i| missed(*i, "single shadow rays"));
    }
}

/// A share of all rays at a model at each place.
fn assert_watertight(model: &Closed, name: &str) {
    model.assert_closed();
    let ways = 2 * Instructions::available().len();
    let count = RAYS.div_ceil(CASES * ways);
    for (k, place) in places().iter().enumerate() {
        let mut numbers = Numbers(hash::join(k as u32, model.triangles.len() as u32));
        let make = |from: fn(&Closed, &Transform, &mut Numbers) -> Ray, numbers: &mut Numbers, count| {
            (0..count).map(|_| from(model, place, numbers)).collect::<Vec<_>>()
        };
        let inside = make(from_inside, &mut numbers, count * 3 / 4);
        assert_all_hit(scene(model, place), &inside, &format!("{name} at place {k} from inside"));
        let outside = make(from_outside, &mut numbers, count - count * 3 / 4);
        assert_all_hit(scene(model, place), &outside, &format!("{name} at place {k} from outside"));
    }
}

/// A point far from where floats are dense.
const FAR: Vec3 = Vec3::new(1500.0, -700.0, 300.0);

#[test]
fn no_ray_gets_out_of_a_cube() {
    assert_watertight(&cube(), "the cube");
}

/// Walls whose triangles lie in flat boxes that touch.
#[test]
fn no_ray_gets_out_of_a_room_of_tiles() {
    assert_watertight(&tiles(25), "the room of tiles");
}

#[test]
fn no_ray_gets_out_of_a_turned_cube() {
    let turn = Transform::from_place(Vec3::ZERO, Vec3::new(20.0, 40.0, 60.0), Vec3::ONE);
    assert_watertight(&cube().moved(0.9, |p| turn.point(p)), "the turned cube");
}

#[test]
fn no_ray_gets_out_of_an_icosahedron() {
    assert_watertight(&icosphere(0), "the icosahedron");
}

#[test]
fn no_ray_gets_out_of_an_icosphere() {
    assert_watertight(&icosphere(4), "the icosphere");
}

#[test]
fn no_ray_gets_out_of_a_cave() {
    assert_watertight(&cave(5), "the cave");
}

#[test]
fn no_ray_gets_out_of_a_cave_whose_corners_stand_on_a_coarse_net() {
    // Flat spots and corners that coincide on an axis.
    let coarse = |p: Vec3| (p * 64.0).round() / 64.0;
    assert_watertight(&cave(3).moved(0.25, coarse), "the coarse cave");
}

#[test]
fn no_ray_gets_out_of_slivers() {
    assert_watertight(&slivers(3000), "the slivers");
}

#[test]
fn no_ray_gets_out_of_a_needle() {
    let long = |p: Vec3| p * Vec3::new(1.0, 1000.0, 1.0);
    assert_watertight(&icosphere(3).moved(0.7, long), "the needle");
}

/// Corners far from the origin of the model's own space, where floats are coarse.
#[test]
fn no_ray_gets_out_of_a_model_far_from_its_origin() {
    let (model, mut numbers) = (cave(3), Numbers(3));
    let place = Transform::from_place(FAR, Vec3::new(10.0, 20.0, 30.0), Vec3::ONE);
    let rays: Vec<_> = (0..20_000).map(|_| from_inside(&model, &place, &mut numbers)).collect();
    let far = model.moved(0.25, |p| place.point(p));
    assert_all_hit(scene(&far, &Transform::default()), &rays, "the cave that is far away");
}

/// The test can fail: without one of its triangles the cube is open, and rays find the hole.
#[test]
fn a_hole_is_found() {
    let mut open = cube();
    open.triangles.pop();
    let mut numbers = Numbers(1);
    let place = Transform::default();
    let rays: Vec<_> = (0..1000).map(|_| from_inside(&open, &place, &mut numbers)).collect();
    let mut hits = vec![None; rays.len()];
    scene(&open, &place).closest_each(&rays, &mut hits);
    let missed = hits.iter().filter(|hit| hit.is_none()).count();
    assert!(missed > 3 && missed < 200, "{missed} of a thousand");
}
