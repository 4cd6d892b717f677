//! A round bulb.
//!
//! ```toml
//! [[light]]
//! name = "bulb"
//! kind = "sphere"
//! position = [0.0, 2.5, 0.0]
//! radius = 0.05
//! temperature = 2900
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind, Range};
use vitrine_math::Vec3;

crate::params! {
    /// A round bulb; the larger it is, the softer its shadows. The classic renderer takes it for a level disc.
    pub struct Sphere {
        /// Its centre.
        position: Vec3 = Vec3::new(2.0, 4.0, 3.0) => ParamKind::Vector(Range::ANY), Metres;
        /// From the centre to the surface.
        radius: f32 = 0.05 => ParamKind::Number(Range::POSITIVE), Metres;
    }
}

impl LightKind for Sphere {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        Some(Emission::Sphere { position: self.position, radius: self.radius })
    }
}
