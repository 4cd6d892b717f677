//! Closed models around the origin.

use std::collections::HashMap;
use std::f32::consts::{PI, TAU};
use vitrine_math::{Vec3, hash};

/// A closed model.
#[derive(Clone, Debug)]
pub struct Closed {
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    /// A ball around the origin with this radius lies inside.
    pub inner: f32,
    /// A ball around the origin with this radius holds everything.
    pub outer: f32,
}

impl Closed {
    fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>, inner: f32) -> Self {
        let outer = positions.iter().map(|p| p.length()).fold(0.0, f32::max);
        Self { positions, triangles, inner, outer }
    }

    /// The same with its corners elsewhere; the ball inside must be told anew.
    pub fn moved(mut self, inner: f32, to: impl Fn(Vec3) -> Vec3) -> Self {
        self.positions.iter_mut().for_each(|p| *p = to(*p));
        Self::new(self.positions, self.triangles, inner)
    }

    /// Every edge belongs to two triangles, which go along it in opposite directions.
    pub fn assert_closed(&self) {
        let mut edges = HashMap::new();
        for t in &self.triangles {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                assert!(a != b && edges.insert((a, b), ()).is_none(), "edge {a} {b} twice");
            }
        }
        assert!(edges.keys().all(|(a, b)| edges.contains_key(&(*b, *a))), "an edge with one side");
    }
}

/// A cube of twelve triangles.
pub fn cube() -> Closed {
    let positions = (0..8_u32).map(|i| Vec3::from([0, 1, 2].map(|k| (i >> k & 1) as f32 * 2.0 - 1.0)));
    let mut triangles = Vec::new();
    for axis in 0..3_u32 {
        let (u, w) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        for side in [0, 1 << axis] {
            let [a, b, c, d] = [side, side | u, side | u | w, side | w];
            let quad = if side == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            triangles.extend(quad);
        }
    }
    Closed::new(positions.collect(), triangles, 1.0)
}

/// A cube whose faces are tiled with so many squares each way.
pub fn tiles(count: u32) -> Closed {
    let (mut positions, mut triangles, mut index) = (Vec::new(), Vec::new(), HashMap::new());
    for axis in 0..3 {
        for side in [0, count] {
            let mut at = |i: u32, j: u32| {
                let mut key = [side; 3];
                (key[(axis + 1) % 3], key[(axis + 2) % 3]) = (i, j);
                *index.entry(key).or_insert_with(|| {
                    positions.push(Vec3::from(key.map(|k| 2.0 * k as f32 / count as f32 - 1.0)));
                    positions.len() as u32 - 1
                })
            };
            for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let quad = if side == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
                triangles.extend(quad);
            }
        }
    }
    Closed::new(positions, triangles, 1.0)
}

/// An icosahedron with each face cut into four so many times, blown up to a ball.
pub fn icosphere(levels: u32) -> Closed {
    let long = f32::midpoint(1.0, 5.0_f32.sqrt());
    let mut positions = Vec::new();
    for k in 0..3 {
        for (a, b) in [(-1.0, -long), (1.0, -long), (-1.0, long), (1.0, long)] {
            let mut p = [0.0; 3];
            (p[(k + 1) % 3], p[(k + 2) % 3]) = (a, b);
            positions.push(Vec3::from(p).normalize());
        }
    }
    // Faces are the triples of corners whose edges are the shortest, turned outwards.
    let is_edge = |a: usize, b: usize| (positions[a] - positions[b]).length() < 1.1;
    let mut triangles = Vec::new();
    for (a, b, c) in (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| (a, b, c))))
    {
        if is_edge(a, b) && is_edge(b, c) && is_edge(a, c) {
            let n = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
            let [a, b, c] = if n.dot(positions[a]) > 0.0 { [a, b, c] } else { [a, c, b] };
            triangles.push([a as u32, b as u32, c as u32]);
        }
    }
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        let cut = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(cut).collect();
    }
    // The first faces lie 0.79 from the middle.
    Closed::new(positions, triangles, 0.79)
}

/// The inside of a cave: a ball whose wall goes in and out without any order.
pub fn cave(levels: u32) -> Closed {
    let ball = icosphere(levels);
    let wall = |p: Vec3| {
        let key = p.to_array().iter().fold(7, |key, c| hash::join(key, c.to_bits()));
        p * (0.6 + 0.8 * hash::unit(key))
    };
    ball.moved(0.25, wall)
}

/// A ball of slices so thin that its triangles are slivers.
pub fn slivers(slices: u32) -> Closed {
    const RINGS: u32 = 3;
    let mut positions = vec![Vec3::Y, Vec3::NEG_Y];
    for ring in 1..=RINGS {
        let (sin, cos) = libm::sincosf(PI * ring as f32 / (RINGS + 1) as f32);
        positions.extend((0..slices).map(|slice| {
            let (s, c) = libm::sincosf(TAU * slice as f32 / slices as f32);
            Vec3::new(sin * c, cos, sin * s)
        }));
    }
    let at = |ring: u32, slice: u32| 2 + ring * slices + slice % slices;
    let mut triangles = Vec::new();
    for slice in 0..slices {
        triangles.push([0, at(0, slice + 1), at(0, slice)]);
        triangles.push([1, at(RINGS - 1, slice), at(RINGS - 1, slice + 1)]);
        for ring in 1..RINGS {
            let [a, b] = [at(ring - 1, slice), at(ring - 1, slice + 1)];
            let [c, d] = [at(ring, slice), at(ring, slice + 1)];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    Closed::new(positions, triangles, 0.5)
}
