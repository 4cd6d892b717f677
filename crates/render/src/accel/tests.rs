//! All ways of tracing a ray must agree: with a plain test of every primitive in turn, and on every instruction set.

use super::*;
use crate::accel::tree::{Node, WIDTH};
use vitrine_math::{Mat3, Ray, Transform, Vec3, hash};

/// Numbers from −1 to 1.
pub(super) struct Numbers(pub u32);

impl Numbers {
    pub fn next(&mut self) -> f32 {
        self.0 += 1;
        2.0 * hash::unit(hash::mix(self.0)) - 1.0
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.next(), self.next(), self.next())
    }
}

pub(super) fn around(center: Vec3, radius: f32) -> Bounds3 {
    Bounds3 { min: center - Vec3::splat(radius), max: center + Vec3::splat(radius) }
}

/// Fewer where each costs much: under Miri.
pub(super) const fn few(count: usize) -> usize {
    if cfg!(miri) { count.div_ceil(100) } else { count }
}

/// A mesh of triangles that share no corners.
pub(super) fn mesh(corners: &[[Vec3; 3]], slots: Vec<u16>) -> MeshAccel {
    let triangles: Vec<_> = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    MeshAccel::new(corners.as_flattened(), &triangles, slots)
}

/// A bit of everything; transparencies 0, 0.25 and 0.5 so that products are exact in any order.
pub(super) fn scene(seed: u32) -> Accel {
    let mut numbers = Numbers(seed.wrapping_mul(7919));
    let mut p = Primitives::default();
    let id = |p: &mut Primitives| {
        let id = p.materials.len() as u32;
        p.materials.push(MaterialSlots { first: id % 3, by_triangle: false });
        id
    };
    for _ in 0..40 {
        let (center, radius) = (numbers.vector() * 5.0, 0.05 + numbers.next().abs());
        let ball = Sphere { center: center.into(), radius, primitive: id(&mut p) };
        p.spheres.push((ball, around(center, radius)));
    }
    for k in 0..30 {
        let turn = vitrine_math::rotation_from_turn(numbers.vector() * 180.0);
        let size = Vec3::splat(0.2) + numbers.vector().abs();
        let center = numbers.vector() * 5.0;
        let world = Affine3A::from_mat3_translation(turn * Mat3::from_diagonal(size), center);
        let unit = Unit { unit_from_world: world.inverse(), primitive: id(&mut p) };
        let bounds = around(center, size.length());
        if k % 2 == 0 { &mut p.boxes } else { &mut p.ellipsoids }.push((unit, bounds));
    }
    for _ in 0..40 {
        let a = numbers.vector() * 5.0;
        let points = [a, a + numbers.vector() * 2.0, a + numbers.vector() * 2.0];
        let id = id(&mut p);
        p.triangles.push((points, id));
    }
    for height in [-4.0, 4.5] {
        let primitive = id(&mut p);
        p.planes.push(Plane { n: [0.0, 1.0, 0.0], offset: height, primitive });
    }
    let corners: Vec<[Vec3; 3]> = (0..200)
        .map(|_| {
            let a = numbers.vector();
            [a, a + numbers.vector() * 0.4, a + numbers.vector() * 0.4]
        })
        .collect();
    let mesh = Arc::new(mesh(&corners, (0..200).map(|i| i % 3).collect()));
    for k in 0..3 {
        let center = numbers.vector() * 3.0;
        let turn = vitrine_math::rotation_from_turn(numbers.vector() * 180.0);
        let world = Affine3A::from_mat3_translation(turn * 2.0, center);
        let primitive = id(&mut p);
        p.materials[primitive as usize] = MaterialSlots { first: 0, by_triangle: k > 0 };
        let instance = Instance { mesh_from_world: world.inverse(), mesh: mesh.clone(), primitive };
        p.instances.push((instance, around(center, 2.0 * 1.4 * 3.0_f32.sqrt())));
    }
    for _ in 0..20 {
        let turn = vitrine_math::rotation_from_turn(numbers.vector() * 180.0);
        let size = Vec3::splat(0.2) + numbers.vector().abs();
        let center = numbers.vector() * 5.0;
        let world = Affine3A::from_mat3_translation(turn * Mat3::from_diagonal(size), center);
        let unit = Transform { world_from_object: world, object_from_world: world.inverse() };
        let disc = Disc::new(&unit, id(&mut p));
        p.discs.push((disc, around(center, size.length())));
    }
    Accel::new(p, vec![0.0, 0.25, 0.5])
}

/// Rays from everywhere, some along the axes, some short.
fn rays(seed: u32, count: usize) -> RayStream {
    let mut numbers = Numbers(seed.wrapping_mul(104_729));
    let mut rays = RayStream::default();
    for i in 0..count {
        let mut direction = numbers.vector();
        if i % 7 == 0 {
            direction.x = 0.0;
        }
        if i % 21 == 0 {
            direction.y = 0.0;
        }
        let t_max = if i % 3 == 0 { 4.0 } else { f32::INFINITY };
        rays.push(&Ray { origin: numbers.vector() * 6.0, direction, t_max });
    }
    rays
}

/// The same scene with one leaf for each primitive and no box that culls: every ray is tested against everything.
fn without_tree(mut accel: Accel) -> Accel {
    let everywhere = Bounds3 { min: Vec3::splat(-1e6), max: Vec3::splat(1e6) };
    open(&mut accel.tree.nodes, &everywhere);
    for instance in &mut accel.instances {
        let mut mesh = MeshAccel::clone(&instance.mesh);
        open(&mut mesh.tree.nodes, &everywhere);
        instance.mesh = Arc::new(mesh);
    }
    accel
}

fn open(nodes: &mut [Node], bounds: &Bounds3) {
    for node in nodes {
        for place in (0..WIDTH).filter(|&place| !node.bounds(place).is_empty()).collect::<Vec<_>>() {
            for axis in 0..3 {
                node.rows[2 * axis][place] = bounds.min[axis];
                node.rows[2 * axis + 1][place] = bounds.max[axis];
            }
        }
    }
}

fn closest(accel: &Accel, rays: &RayStream) -> Vec<Option<Hit>> {
    let mut hits = HitStream::default();
    accel.closest(rays, &mut hits);
    (0..rays.len()).map(|i| hits.get(i)).collect()
}

fn transmittance(accel: &Accel, rays: &RayStream) -> Vec<f32> {
    let mut passes = Vec::new();
    accel.transmittance(rays, &mut passes);
    passes.truncate(rays.len());
    passes
}

#[test]
fn the_tree_changes_no_hit_and_no_shadow() {
    for seed in (0..6).take(few(6)) {
        let (tree, all) = (scene(seed), without_tree(scene(seed)));
        let rays = rays(seed, few(3000));
        let hits = closest(&tree, &rays);
        assert_eq!(hits, closest(&all, &rays));
        assert!(hits.iter().flatten().count() > hits.len() / 3, "the test must test something");
        let a = transmittance(&tree, &rays);
        assert_eq!(a, transmittance(&all, &rays));
        assert!(a.iter().any(|t| *t > 0.0 && *t < 1.0) && a.contains(&0.0) && a.contains(&1.0));
    }
}

/// Single rays, whole packets and packets that fall apart must find the same.
#[test]
fn single_rays_find_what_packets_find() {
    for seed in (20..24).take(few(4)) {
        for set in Instructions::available() {
            let accel = scene(seed).with_instructions(set);
            let stream = rays(seed, few(3000));
            let alone: Vec<_> = (0..stream.len()).map(|i| stream.get(i)).collect();
            let mut hits = vec![None; alone.len()];
            accel.closest_each(&alone, &mut hits);
            assert_eq!(hits, closest(&accel, &stream), "{set:?}");
            let mut blocked = vec![false; alone.len()];
            accel.occluded_each(&alone, &mut blocked);
            let mut together = Vec::new();
            accel.occluded(&stream, &mut together);
            assert_eq!(blocked, together, "{set:?}");
            for (i, ((ray, hit), blocked)) in alone.iter().zip(&hits).zip(&blocked).enumerate() {
                // A surface at the ray's very end stops nothing.
                assert_eq!(hit.is_some_and(|h| h.t < ray.t_max), *blocked, "ray {i}");
            }
        }
    }
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    for seed in (10..14).take(few(4)) {
        let mut results = Vec::new();
        for set in Instructions::available() {
            let accel = scene(seed).with_instructions(set);
            let rays = rays(seed, few(2000));
            results.push((closest(&accel, &rays), transmittance(&accel, &rays)));
        }
        assert!(results.iter().all(|r| *r == results[0]));
    }
}

/// Going straight on from hit to hit meets every surface once: the product of what they let through is the transmittance.
#[test]
fn going_on_after_each_hit_meets_what_the_shadow_ray_crosses() {
    let accel = scene(3);
    let rays = rays(5, few(500));
    for (i, passes) in transmittance(&accel, &rays).iter().enumerate() {
        let mut one = RayStream::default();
        one.push(&rays.get(i));
        let mut product = 1.0;
        while let Some(hit) = closest(&accel, &one)[0] {
            let slot = accel
                .instances
                .iter()
                .find(|x| x.primitive == hit.primitive)
                .map_or(0, |x| x.mesh.slot(hit.triangle));
            product *= accel.transparency(hit.primitive, slot);
            if product == 0.0 {
                break;
            }
            one.clear();
            one.push_on(&rays.get(i), &hit);
        }
        assert_eq!(product, *passes, "ray {i}");
    }
}

#[test]
fn surfaces_in_one_place_are_both_met_in_order() {
    let mut p = Primitives::default();
    for primitive in 0..2 {
        p.planes.push(Plane { n: [0.0, 1.0, 0.0], offset: 0.0, primitive });
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
    }
    let accel = Accel::new(p, vec![0.5]);
    let mut rays = RayStream::default();
    let ray = Ray::new(Vec3::Y, Vec3::new(0.3, -1.0, 0.2));
    rays.push(&ray);
    for primitive in 0..2 {
        let hit = closest(&accel, &rays)[0].unwrap();
        assert_eq!(hit.primitive, primitive);
        rays.clear();
        rays.push_on(&ray, &hit);
    }
    assert_eq!(closest(&accel, &rays), [None]);
}

/// A ball hit from outside, inside, and missed: against the closed form in double precision.
#[test]
fn c1_sphere_distances_are_exact_at_any_scale() {
    for (radius, distance) in [(1.0_f32, 3.0_f32), (1e-3, 500.0), (1e4, 1e5), (0.5, 0.6)] {
        let mut p = Primitives::default();
        let ball = Sphere { center: [0.0, 0.0, -distance], radius, primitive: 0 };
        p.spheres.push((ball, around(Vec3::new(0.0, 0.0, -distance), radius)));
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
        let accel = Accel::new(p, vec![0.0]);
        for part in [0.0_f32, 0.5, 0.9] {
            let offset = radius * part;
            let mut rays = RayStream::default();
            rays.push(&Ray::new(Vec3::new(offset, 0.0, 0.0), Vec3::NEG_Z));
            rays.push(&Ray::new(Vec3::new(offset, 0.0, -distance), Vec3::NEG_Z));
            rays.push(&Ray::new(Vec3::new(radius * 1.01, 0.0, 0.0), Vec3::NEG_Z));
            let hits = closest(&accel, &rays);
            let depth = (f64::from(radius).powi(2) - f64::from(offset).powi(2)).sqrt();
            let near = |hit: Option<Hit>, truth: f64| {
                let t = f64::from(hit.expect("a hit").t);
                assert!((t - truth).abs() <= 2e-6 * truth.max(depth), "{t} against {truth}");
            };
            near(hits[0], f64::from(distance) - depth);
            near(hits[1], depth);
            assert_eq!(hits[2], None);
        }
    }
}

#[test]
fn a_ray_that_ends_before_it_begins_finds_nothing() {
    let accel = scene(1);
    let mut rays = RayStream::default();
    rays.push(&Ray { origin: Vec3::ZERO, direction: Vec3::X, t_max: -1.0 });
    assert_eq!(closest(&accel, &rays), [None]);
}

/// A net of triangles over whole numbers, turned so that rounding has a say, and rays at its knots and edges, where two to six
/// triangles are hit at about the same distance.
fn net() -> (Accel, Vec<Ray>) {
    let turn = vitrine_math::rotation_from_turn(Vec3::new(30.0, 40.0, 10.0));
    let knot = |i: u32, j: u32| Vec3::new(i as f32, 0.0, j as f32) - Vec3::new(10.0, 0.0, 10.0);
    let side = if cfg!(miri) { 4 } else { 20 };
    let mut triangles = Vec::new();
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        let [a, b, c, d] = [knot(i, j), knot(i + 1, j), knot(i + 1, j + 1), knot(i, j + 1)];
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    let corners: Vec<_> = triangles.iter().map(|t| t.map(|p| turn * p)).collect();
    let mut p = Primitives::default();
    for primitive in 0..2 {
        let mesh = Arc::new(mesh(&corners, Vec::new()));
        p.instances.push((
            Instance { mesh_from_world: Affine3A::IDENTITY, mesh, primitive },
            around(Vec3::ZERO, 15.0),
        ));
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
    }
    let mut numbers = Numbers(77);
    let rays = (0..few(6000) as u32).map(|k| {
        let at = turn
            * (knot(k % side, k / side % side) + Vec3::new(if k % 3 == 0 { 0.5 } else { 0.0 }, 0.0, 0.0));
        let origin = numbers.vector() * 30.0;
        Ray::new(origin, (at - origin).normalize())
    });
    (Accel::new(p, vec![0.5]), rays.collect())
}

/// A picture's bytes depend on no packet: rays alone find what they find among others, in any order.
#[test]
fn a_hit_does_not_depend_on_the_rays_beside_it() {
    let (accel, rays) = net();
    let trace = |order: &[usize]| {
        let mut stream = RayStream::default();
        order.iter().for_each(|i| stream.push(&rays[*i]));
        let mut found = vec![None; rays.len()];
        order.iter().zip(closest(&accel, &stream)).for_each(|(i, hit)| found[*i] = hit);
        found
    };
    let in_order: Vec<_> = (0..rays.len()).collect();
    let hits = trace(&in_order);
    assert!(hits.iter().flatten().count() > hits.len() * 5 / 6);
    for step in [7, 11, 1201, 3001] {
        let other: Vec<_> = (0..rays.len()).map(|i| i * step % rays.len()).collect();
        let differ = trace(&other).iter().zip(&hits).filter(|(a, b)| a != b).count();
        assert_eq!(differ, 0, "of {} rays", rays.len());
    }
}

mod beyond;
mod edge_on;
