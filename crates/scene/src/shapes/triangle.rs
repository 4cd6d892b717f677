//! A triangle by three points.
//!
//! ```toml
//! [[object]]
//! name = "sail"
//! shape = "triangle"
//! points = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.5, 0.0]]
//! ```

use super::{Geometry, ShapeKind};
use crate::{Assets, Fault, ParamKind};
use vitrine_math::Vec3;

crate::params! {
    /// A flat triangle by its three corners.
    pub struct Triangle {
        /// The corners A, B and C, before the object is moved, turned or scaled.
        points: [Vec3; 3] = [Vec3::new(-0.5, 0.0, 0.0), Vec3::new(0.5, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)] => ParamKind::Points(3), Metres;
        /// Which point of the picture lies at each corner: u to the right, v up, the whole picture from 0 to 1.
        uvs: [[f32; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]] => ParamKind::Pairs(3), None;
    }
}

impl ShapeKind for Triangle {
    fn geometry(&self, _: &Assets) -> Option<Geometry> {
        Some(Geometry::Triangle { points: self.points, uvs: self.uvs })
    }

    fn fault(&self) -> Option<Fault> {
        let [a, b, c] = self.points;
        let edges = [b - a, c - a, c - b];
        let longest = edges.iter().map(|e| e.abs().max_element()).fold(0.0, f32::max);
        // Relative to its size, so that a tiny triangle is as good as a large one.
        let flat = !(longest > 0.0 && (edges[0] / longest).cross(edges[1] / longest).length() > 1e-6);
        flat.then_some(Fault {
            key: "points",
            message: "the three points lie on one line, so there is no triangle",
            help: "move one of the points off the line through the other two",
        })
    }
}
