//! Whether models are closed: a transparent one must be, or light goes in and never comes out.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::{Arc, Weak};
use vitrine::scene::TriangleMesh;

thread_local! {
    /// What is known already, by the model's address; the weak link tells whether it is still the same model.
    static KNOWN: RefCell<HashMap<*const TriangleMesh, (Weak<TriangleMesh>, bool)>> = RefCell::default();
}

/// Whether each edge of the model belongs to as many triangles one way round as the other. Remembered for each model.
pub(super) fn is_closed(mesh: &Arc<TriangleMesh>) -> bool {
    KNOWN.with_borrow_mut(|known| {
        known.retain(|_, (model, _)| model.strong_count() > 0);
        known.entry(Arc::as_ptr(mesh)).or_insert_with(|| (Arc::downgrade(mesh), mesh.is_closed())).1
    })
}
