//! Models made in code.

use vitrine_math::{Vec2, Vec3};
use vitrine_scene::{MeshPart, TriangleMesh};

/// A model of these triangles, in one part without material.
pub fn of(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> TriangleMesh {
    let parts = vec![MeshPart { name: String::new(), triangles: 0..triangles.len(), material: None }];
    TriangleMesh { positions, triangles, parts, ..TriangleMesh::default() }
}

/// A closed convex model: an octahedron with each face cut into `n²`, blown up to a ball.
pub fn faceted_ball(radius: f32, n: u32) -> TriangleMesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut index = std::collections::BTreeMap::new();
    for octant in 0..8_i32 {
        let sign = |bit: i32| if octant >> bit & 1 == 0 { 1 } else { -1 };
        let (sx, sy, sz) = (sign(0), sign(1), sign(2));
        let mut at = |i: i32, j: i32| {
            let key = [sx * i, sy * j, sz * (n as i32 - i - j)];
            *index.entry(key).or_insert_with(|| {
                positions.push(Vec3::from(key.map(|c| c as f32)).normalize() * radius);
                positions.len() as u32 - 1
            })
        };
        let mut add =
            |[a, b, c]: [u32; 3]| triangles.push(if sx * sy * sz > 0 { [a, b, c] } else { [a, c, b] });
        for i in 0..n as i32 {
            for j in 0..n as i32 - i {
                add([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < n as i32 {
                    add([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    of(positions, triangles)
}

/// A cube from −1 to 1 of twelve triangles, counter-clockwise seen from outside.
pub fn cube() -> TriangleMesh {
    let corner = |i: u32| Vec3::from([0, 1, 2].map(|bit| if i >> bit & 1 == 0 { -1.0 } else { 1.0 }));
    let mut triangles = Vec::new();
    for axis in 0..3_u32 {
        let (u, w) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            let [a, b, c, d] = [side, side | u, side | u | w, side | w];
            let quad = if side == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            triangles.extend(quad);
        }
    }
    of((0..8).map(corner).collect(), triangles)
}

/// A level square from −1 to 1, its normal up, its picture upright seen from above with −Z up.
pub fn square() -> TriangleMesh {
    let corners = [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0_f32]];
    let mut mesh =
        of(corners.iter().map(|[x, z]| Vec3::new(*x, 0.0, *z)).collect(), vec![[0, 1, 2], [0, 2, 3]]);
    mesh.uvs = corners.iter().map(|[x, z]| Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * z)).collect();
    mesh
}
