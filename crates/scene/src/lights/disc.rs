//! A lamp with size, for soft shadows.
//!
//! ```toml
//! [[light]]
//! name = "lamp"
//! kind = "disc"
//! position = [2.0, 5.0, 3.0]
//! radius = 0.5
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind, Range};
use vitrine_math::Vec3;

crate::params! {
    /// A round lamp that lies level (parallel to XOZ); the larger it is, the softer its shadows.
    pub struct Disc {
        /// Its centre.
        position: Vec3 = Vec3::new(2.0, 4.0, 3.0) => ParamKind::Vector(Range::ANY), Metres;
        /// From the centre to the rim.
        radius: f32 = 0.5 => ParamKind::Number(Range::POSITIVE), Metres;
    }
}

impl LightKind for Disc {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        Some(Emission::Disc { position: self.position, radius: self.radius })
    }
}
