//! A ball. See PRODUCT row C1.
//!
//! ```toml
//! [[object]]
//! name = "ball"
//! shape = "sphere"
//! radius = 0.5
//! position = [0.0, 0.5, 0.0]
//! ```

use super::{Geometry, ShapeKind};
use crate::{Assets, ParamKind, Range};

crate::params! {
    /// A ball, perfectly round at any size.
    pub struct Sphere {
        /// From the centre to the surface.
        radius: f32 = 1.0 => ParamKind::Number(Range::POSITIVE), Metres;
    }
}

impl ShapeKind for Sphere {
    fn geometry(&self, _: &Assets) -> Option<Geometry> {
        Some(Geometry::Sphere { radius: self.radius })
    }
}
