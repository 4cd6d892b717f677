//! Whether models are closed: a transparent one must be, or light goes in and never comes out.

use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, Weak};
use vitrine::math::Vec3;
use vitrine::scene::TriangleMesh;

thread_local! {
    /// What is known already, by the model's address; the weak link tells whether it is still the same model.
    static KNOWN: RefCell<HashMap<*const TriangleMesh, (Weak<TriangleMesh>, bool)>> = RefCell::default();
}

/// Whether each edge of the model belongs to as many triangles one way round as the other. Remembered for each model.
pub(super) fn is_closed(mesh: &Arc<TriangleMesh>) -> bool {
    KNOWN.with_borrow_mut(|known| {
        known.retain(|_, (model, _)| model.strong_count() > 0);
        known.entry(Arc::as_ptr(mesh)).or_insert_with(|| (Arc::downgrade(mesh), find_out(mesh))).1
    })
}

fn find_out(mesh: &TriangleMesh) -> bool {
    // Vertices are split where normals or pictures meet: what counts is where they are.
    let mut number_of: HashMap<u64, u32> = HashMap::new();
    let numbers: Vec<u32> = mesh
        .positions
        .iter()
        .map(|p| {
            let next = number_of.len() as u32;
            *number_of.entry(key(*p)).or_insert(next)
        })
        .collect();
    let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| numbers[i as usize]);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            match from.cmp(&to) {
                std::cmp::Ordering::Less => *edges.entry((from, to)).or_default() += 1,
                std::cmp::Ordering::Greater => *edges.entry((to, from)).or_default() -= 1,
                std::cmp::Ordering::Equal => {}
            }
        }
    }
    !mesh.triangles.is_empty() && edges.values().all(|sum| *sum == 0)
}

fn key(p: Vec3) -> u64 {
    let mut hasher = DefaultHasher::new();
    // Zero has two signs and is one place.
    p.to_array().map(|v| (v + 0.0).to_bits()).hash(&mut hasher);
    hasher.finish()
}
