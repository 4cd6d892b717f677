//! Rays whose numbers leave the range of floats, in the world or in the space of a mesh: every walk ends, whatever its arithmetic gives,
//! and what is found depends on no other ray and no instruction set.

use super::*;

/// A scene with a mesh so small that places far from it are infinitely far in its own space.
fn with_a_speck(seed: u32) -> Accel {
    const SIZE: f32 = 1e-18;
    let mut numbers = Numbers(seed);
    let corners: Vec<[Vec3; 3]> = (0..400).map(|_| std::array::from_fn(|_| numbers.vector())).collect();
    let mesh = Arc::new(mesh(&corners, Vec::new()));
    let mut p = Primitives::default();
    for (primitive, size) in [SIZE, 1.0].into_iter().enumerate() {
        let world = Affine3A::from_scale(Vec3::splat(size));
        let instance =
            Instance { mesh_from_world: world.inverse(), mesh: mesh.clone(), primitive: primitive as u32 };
        p.instances.push((instance, around(Vec3::ZERO, size)));
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
    }
    for (k, y) in [(0.0, -3.0), (0.5, 3.0)] {
        let ball = Sphere { center: [k, y, 0.0], radius: 0.7, primitive: p.materials.len() as u32 };
        p.spheres.push((ball, around(ball.center.into(), 0.7)));
        p.materials.push(MaterialSlots { first: 1, by_triangle: false });
    }
    Accel::new(p, vec![0.5, 0.25])
}

/// Rays at the middle of all from ever farther, along each axis and aslant, and rays of any numbers that there are.
fn strays() -> Vec<Ray> {
    const ODD: [f32; 12] = [
        0.0,
        1.0,
        -0.5,
        1e-30,
        -1e20,
        1e20,
        1e30,
        -1e38,
        f32::MAX,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    let mut rays = Vec::new();
    for k in 0..32 {
        let direction = match k % 4 {
            3 => Vec3::new(0.1, 1.0, -0.2),
            axis => Vec3::AXES[axis],
        } * if k % 8 < 4 { 1.0 } else { -1.0 };
        for far in [1e12, 1e19, 1e25, 1e36, f32::MAX / 2.0] {
            rays.push(Ray::new(-direction * far, direction));
        }
    }
    let mut numbers = Numbers(5);
    let odd = |numbers: &mut Numbers| {
        let at = (0.5 * numbers.next() + 0.5) * ODD.len() as f32;
        ODD[at as usize % ODD.len()]
    };
    for _ in 0..few(4000) {
        let [origin, direction]: [Vec3; 2] =
            std::array::from_fn(|_| Vec3::from_array(std::array::from_fn(|_| odd(&mut numbers))));
        rays.push(Ray::new(origin, direction));
        // Among them rays that hit something.
        rays.push(Ray::new(numbers.vector() * 4.0, numbers.vector()));
    }
    rays
}

#[test]
fn a_walk_ends_for_rays_of_any_numbers_and_depends_on_no_other_ray() {
    let rays = strays();
    let mut stream = RayStream::default();
    rays.iter().for_each(|ray| stream.push(ray));
    for seed in 0..3 {
        let mut first = None;
        for set in Instructions::available() {
            let accel = with_a_speck(seed).with_instructions(set);
            let mut alone = vec![None; rays.len()];
            accel.closest_each(&rays, &mut alone);
            let together = closest(&accel, &stream);
            let mut blocked = vec![false; rays.len()];
            accel.occluded_each(&rays, &mut blocked);
            let mut blocked_together = Vec::new();
            accel.occluded(&stream, &mut blocked_together);
            let passes = transmittance(&accel, &stream);
            for (i, ray) in rays.iter().enumerate() {
                assert_eq!(alone[i], together[i], "{set:?}: {ray:?}");
                assert_eq!(blocked[i], blocked_together[i], "{set:?}: {ray:?}");
            }
            let hits = alone.iter().flatten().count();
            assert!(hits > few(50), "{hits} hits are too few to tell");
            let found = (alone, blocked, passes);
            assert!(*first.get_or_insert_with(|| found.clone()) == found, "{set:?}");
        }
    }
}
