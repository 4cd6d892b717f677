//! A plane without end: the ground, a wall.
//!
//! ```toml
//! [[object]]
//! name = "ground"
//! shape = "plane"
//! ```

use super::{Geometry, ShapeKind};
use crate::Assets;

crate::params! {
    /// A flat surface without end. It lies level (parallel to XOZ) until it is turned.
    pub struct Plane {
    }
}

impl ShapeKind for Plane {
    fn geometry(&self, _: &Assets) -> Option<Geometry> {
        Some(Geometry::Plane)
    }
}
