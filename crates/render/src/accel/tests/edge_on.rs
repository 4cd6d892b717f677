//! Triangles seen from their edges, where rounding decides whether and where a ray crosses them: single rays and packets must still
//! find the same, and never anything beside a triangle.

use super::*;

/// Rays about in the planes of triangles, in runs of 32 that lie close together, at the hull of each triangle and beside it.
fn grazing(corners: &[[Vec3; 3]], numbers: &mut Numbers) -> Vec<Ray> {
    let mut rays = Vec::new();
    for [a, b, c] in corners {
        let at = |u: f32, v: f32| *a + (*b - *a) * u + (*c - *a) * v;
        let origin = at(20.0 * numbers.next(), 20.0 * numbers.next());
        let [u, v] = match rays.len() / 32 % 4 {
            // On the line of an edge, beside it, inside, anywhere near.
            0 => [3.0 * numbers.next(), 0.0],
            1 => [0.0, 3.0 * numbers.next()],
            2 => [0.3, 0.3],
            _ => [2.0 * numbers.next(), 2.0 * numbers.next()],
        };
        for k in 0..32_u8 {
            let part = 1.0 + f32::from(k) * 1e-6;
            rays.push(Ray::new(origin, at(u * part, v * part) - origin));
        }
    }
    rays
}

/// Triangles of all shapes, many of them needles or nearly points.
fn triangles(numbers: &mut Numbers) -> Vec<[Vec3; 3]> {
    (0..few(3000))
        .map(|i| {
            let a = numbers.vector() * 5.0;
            let [long, short] = match i % 4 {
                0 => [1.0, 1.0],
                1 => [1.0, 1e-4],
                2 => [1e-3, 1e-6],
                _ => [1e-6, 1e-6],
            };
            // Some lie level, in boxes without thickness.
            let flat = if i % 3 == 0 { Vec3::new(1.0, 0.0, 1.0) } else { Vec3::ONE };
            [a, a + numbers.vector() * flat * long, a + numbers.vector() * flat * short]
        })
        .collect()
}

fn alone_and_together(accel: &Accel, rays: &[Ray]) -> (Vec<Option<Hit>>, Vec<Option<Hit>>) {
    let mut stream = RayStream::default();
    rays.iter().for_each(|ray| stream.push(ray));
    let mut alone = vec![None; rays.len()];
    accel.closest_each(rays, &mut alone);
    (alone, closest(accel, &stream))
}

/// Each triangle in a scene of its own, in a leaf that is much larger than it.
#[test]
fn a_triangle_seen_from_its_edge_is_hit_where_it_is_or_not_at_all() {
    let mut numbers = Numbers(31);
    let corners = triangles(&mut numbers);
    let rays = grazing(&corners, &mut numbers);
    let mut found = 0;
    for (corners, rays) in corners.iter().zip(rays.chunks(32)) {
        let mut p = Primitives::default();
        let mesh = Arc::new(mesh(&[*corners, [Vec3::splat(50.0); 3], [Vec3::splat(-50.0); 3]], Vec::new()));
        let instance = Instance { mesh_from_world: Affine3A::IDENTITY, mesh, primitive: 0 };
        p.instances.push((instance, around(Vec3::ZERO, 50.0)));
        p.materials.push(MaterialSlots { first: 0, by_triangle: false });
        let mut accel = Accel::new(p, vec![0.0]);
        let bounds = Bounds3::around(*corners);
        for set in Instructions::available() {
            accel = accel.with_instructions(set);
            let (alone, together) = alone_and_together(&accel, rays);
            assert!(alone == together, "{set:?}: {corners:?}");
            for (hit, ray) in alone.iter().zip(rays) {
                let Some(hit) = hit else { continue };
                let (p, reach) = (ray.at(hit.t), (ray.origin - corners[0]).length() * 1e-5);
                let slack = Vec3::splat(reach);
                assert!(
                    p.cmpge(bounds.min - slack).all() && p.cmple(bounds.max + slack).all(),
                    "{set:?}: {ray:?} hits {corners:?} at {p}"
                );
                assert!(hit.uv.iter().all(|c| (0.0..=1.0).contains(c)), "{set:?}: {ray:?}, {hit:?}");
                found += 1;
            }
        }
    }
    assert!(found > few(1000), "{found} hits are too few to tell");
}

/// The corners of neighbours are the same, and so is what rays at their edges find, alone or together.
#[test]
fn single_rays_find_what_packets_find_at_edges() {
    let mut numbers = Numbers(32);
    let corners = triangles(&mut numbers);
    let mut p = Primitives::default();
    let mesh = Arc::new(mesh(&corners, Vec::new()));
    let instance = Instance { mesh_from_world: Affine3A::IDENTITY, mesh, primitive: 0 };
    p.instances.push((instance, around(Vec3::ZERO, 7.0)));
    p.materials.push(MaterialSlots { first: 0, by_triangle: false });
    let mut accel = Accel::new(p, vec![0.0]);
    let rays = grazing(&corners, &mut numbers);
    let mut first = None;
    for set in Instructions::available() {
        accel = accel.with_instructions(set);
        let (alone, together) = alone_and_together(&accel, &rays);
        let differ = alone.iter().zip(&together).filter(|(a, b)| a != b).count();
        assert_eq!(differ, 0, "{set:?}");
        assert!(*first.get_or_insert_with(|| alone.clone()) == alone, "{set:?}");
    }
}
