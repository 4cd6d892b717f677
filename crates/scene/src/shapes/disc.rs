//! A disc: flat and round, such as a table top or a coin seen from afar.
//!
//! ```toml
//! [[object]]
//! name = "table top"
//! shape = "disc"
//! radius = 0.6
//! position = [0.0, 0.7, 0.0]
//! ```

use super::{Geometry, ShapeKind};
use crate::{Assets, ParamKind, Range};

crate::params! {
    /// A flat disc, perfectly round. It lies level (parallel to XOZ) until it is turned; unevenly scaled it is an ellipse. A picture lies on
    /// it as seen from above, in the square around it.
    pub struct Disc {
        /// From the centre to the rim.
        radius: f32 = 1.0 => ParamKind::Number(Range::POSITIVE), Metres;
    }
}

impl ShapeKind for Disc {
    fn geometry(&self, _: &Assets) -> Option<Geometry> {
        Some(Geometry::Disc { radius: self.radius })
    }
}
