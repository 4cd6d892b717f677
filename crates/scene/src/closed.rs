//! Whether models are closed: one that light goes into must be, or it never comes out.

use crate::TriangleMesh;
use std::collections::HashMap;
use vitrine_math::Vec3;

impl TriangleMesh {
    /// Whether each edge belongs to as many triangles one way round as the other: then the model has an inside. It takes time
    /// in proportion to the triangles.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        // Vertices are split where normals or pictures meet: what counts is where they are.
        let mut number_of: HashMap<[u32; 3], u32> = HashMap::new();
        let numbers: Vec<u32> = self
            .positions
            .iter()
            .map(|p| {
                let next = number_of.len() as u32;
                *number_of.entry(key(*p)).or_insert(next)
            })
            .collect();
        let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|i| numbers[i as usize]);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                match from.cmp(&to) {
                    std::cmp::Ordering::Less => *edges.entry((from, to)).or_default() += 1,
                    std::cmp::Ordering::Greater => *edges.entry((to, from)).or_default() -= 1,
                    std::cmp::Ordering::Equal => {}
                }
            }
        }
        !self.triangles.is_empty() && edges.values().all(|sum| *sum == 0)
    }
}

fn key(p: Vec3) -> [u32; 3] {
    // Zero has two signs and is one place.
    p.to_array().map(|v| (v + 0.0).to_bits())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_is_closed_until_a_face_is_missing_or_turned() {
        let mut mesh = TriangleMesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::new(-0.0, 0.0, -0.0)],
            // The last vertex lies where the first does.
            triangles: vec![[0, 2, 1], [4, 1, 3], [4, 3, 2], [1, 2, 3]],
            ..TriangleMesh::default()
        };
        assert!(mesh.is_closed());
        mesh.triangles[3] = [1, 3, 2];
        assert!(!mesh.is_closed(), "a face is turned");
        mesh.triangles.pop();
        assert!(!mesh.is_closed(), "a face is missing");
        mesh.triangles.clear();
        assert!(!mesh.is_closed(), "there is nothing");
    }
}
