//! Models of any number of triangles: balls, rings, cones, boxes.

use crate::Model;
use std::collections::HashMap;
use std::f32::consts::TAU;
use vitrine_math::{Bounds3, Vec3};

/// The corners of an icosahedron are these and their rotations: ±1 and ±the golden ratio.
const GOLDEN: f32 = 1.618_034;

/// The faces of an icosahedron, counter-clockwise seen from outside.
const FACES: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

fn icosahedron() -> [Vec3; 12] {
    std::array::from_fn(|i| {
        let (one, golden) = (if i & 1 == 0 { -1.0 } else { 1.0 }, if i & 2 == 0 { GOLDEN } else { -GOLDEN });
        match i / 4 {
            0 => Vec3::new(one, golden, 0.0),
            1 => Vec3::new(0.0, one, golden),
            _ => Vec3::new(golden, 0.0, one),
        }
    })
}

/// How finely to cut the faces of a ball of about so many triangles.
pub fn ball_frequency(triangles: u32) -> u32 {
    ((f64::from(triangles) / 20.0).sqrt().round() as u32).max(1)
}

/// A ball of radius 1: an icosahedron whose edges are cut into so many pieces, 20·frequency² triangles. It is closed:
/// triangles share their vertices.
pub fn ball(frequency: u32) -> Model {
    let corners = icosahedron();
    let mut model = Model::default();
    let mut shared: HashMap<[(u32, u32); 2], u32> = HashMap::new();
    for face in FACES {
        // The vertices of the face in rows, by how far they are from its first corner.
        let mut rows: Vec<Vec<u32>> = Vec::new();
        for i in 0..=frequency {
            let row = (0..=i).map(|j| {
                let weights = [frequency - i, i - j, j];
                let place: Vec3 =
                    face.iter().zip(weights).map(|(&corner, w)| corners[corner as usize] * w as f32).sum();
                let mut add = || {
                    model.positions.push(place.normalize());
                    model.positions.len() as u32 - 1
                };
                match edge(face, weights) {
                    Some(key) => *shared.entry(key).or_insert_with(add),
                    None => add(),
                }
            });
            rows.push(row.collect());
        }
        for pair in rows.windows(2) {
            let (upper, lower) = (&pair[0], &pair[1]);
            model.triangles.extend((0..upper.len()).map(|j| [upper[j], lower[j], lower[j + 1]]));
            model.triangles.extend((1..upper.len()).map(|j| [upper[j - 1], lower[j], upper[j]]));
        }
    }
    model
}

/// What names a vertex on the edge of a face for both its neighbours: the corners that it lies between, each with its
/// weight, the lower corner first; a corner itself comes twice. None within the face.
fn edge(face: [u32; 3], weights: [u32; 3]) -> Option<[(u32, u32); 2]> {
    let mut ends: Vec<_> = face.into_iter().zip(weights).filter(|(_, w)| *w > 0).collect();
    ends.sort_unstable();
    match ends[..] {
        [corner] => Some([corner, corner]),
        [a, b] => Some([a, b]),
        _ => None,
    }
}

/// A ring around the y axis of 2·around·across triangles: its middle line has radius 1, it is so thick.
pub fn ring(around: u32, across: u32, thickness: f32) -> Model {
    let mut model = Model::default();
    for i in 0..around {
        let (sin, cos) = libm::sincosf(TAU * i as f32 / around as f32);
        for j in 0..across {
            let (up, out) = libm::sincosf(TAU * j as f32 / across as f32);
            let radius = 1.0 + thickness * out;
            model.positions.push(Vec3::new(radius * cos, thickness * up, radius * sin));
        }
    }
    for i in 0..around {
        for j in 0..across {
            let at = |i: u32, j: u32| i % around * across + j % across;
            let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
            model.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    model
}

/// A cone of 2·sides triangles, 1 m wide and high, its base around the origin.
pub fn cone(sides: u32) -> Model {
    let rim = |i| {
        let (sin, cos) = libm::sincosf(TAU * i as f32 / sides as f32);
        Vec3::new(0.5 * cos, 0.0, 0.5 * sin)
    };
    let (tip, middle) = (sides, sides + 1);
    let triangle = |i| [[tip, (i + 1) % sides, i], [middle, i, (i + 1) % sides]];
    Model {
        positions: (0..sides).map(rim).chain([Vec3::Y, Vec3::ZERO]).collect(),
        triangles: (0..sides).flat_map(triangle).collect(),
    }
}

/// A box of 12 triangles.
pub fn cuboid(bounds: &Bounds3) -> Model {
    // The four corners of each side, in a ring.
    const SIDES: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Model {
        positions: bounds.corners().to_vec(),
        triangles: SIDES.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Each edge of a closed surface has two triangles, which go along it in opposite ways.
    fn is_closed(model: &Model) -> bool {
        let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
        for t in &model.triangles {
            for k in 0..3 {
                let (a, b) = (t[k], t[(k + 1) % 3]);
                *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
            }
        }
        edges.values().all(|&sum| sum == 0)
    }

    /// By the divergence theorem; positive when the triangles face outwards.
    fn volume(model: &Model) -> f32 {
        let signed = |t| {
            let [a, b, c] = model.corners(t);
            a.cross(b).dot(c) / 6.0
        };
        (0..model.triangles.len()).map(signed).sum()
    }

    #[test]
    fn models_are_closed_face_outwards_and_have_their_volume() {
        let unit = Bounds3 { min: Vec3::ZERO, max: Vec3::ONE };
        let pi = std::f32::consts::PI;
        for (name, model, triangles, expected) in [
            ("ball", ball(12), 20 * 144, 4.0 / 3.0 * pi),
            ("ring", ring(60, 30, 0.2), 3600, 2.0 * pi * pi * 0.04),
            ("cone", cone(80), 160, pi / 12.0),
            ("box", cuboid(&unit), 12, 1.0),
        ] {
            assert_eq!(model.triangles.len(), triangles, "{name}");
            assert!(is_closed(&model), "{name}");
            assert!((volume(&model) / expected - 1.0).abs() < 0.02, "{name}: {}", volume(&model));
        }
    }

    #[test]
    fn a_closed_ball_shares_every_vertex() {
        // Euler: vertices − edges + faces = 2, with three edges to two faces.
        let model = ball(9);
        assert_eq!(model.positions.len(), model.triangles.len() / 2 + 2);
    }
}
