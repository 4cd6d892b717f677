//! A box with right angles (the course work's parallelepiped).
//!
//! ```toml
//! [[object]]
//! name = "crate"
//! shape = "box"
//! size = [1.0, 0.5, 1.0]
//! position = [0.0, 0.25, 0.0]
//! turn_deg = [0.0, 30.0, 0.0]
//! ```

use super::{Geometry, ShapeKind};
use crate::{Assets, ParamKind, Range};
use vitrine_math::Vec3;

crate::params! {
    /// A box with right angles.
    pub struct Cuboid {
        /// The lengths of its edges along its own x, y and z.
        size: Vec3 = Vec3::ONE => ParamKind::Vector(Range::POSITIVE), Metres;
    }
}

impl ShapeKind for Cuboid {
    fn geometry(&self, _: &Assets) -> Option<Geometry> {
        Some(Geometry::Box { half: self.size * 0.5 })
    }
}
