//! A bulb without size.
//!
//! ```toml
//! [[light]]
//! name = "bulb"
//! kind = "point"
//! position = [2.0, 4.0, 3.0]
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind, Range};
use vitrine_math::Vec3;

crate::params! {
    /// A bulb without size; its shadows are sharp.
    pub struct Point {
        /// Where it hangs.
        position: Vec3 = Vec3::new(2.0, 4.0, 3.0) => ParamKind::Vector(Range::ANY), Metres;
    }
}

impl LightKind for Point {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        Some(Emission::Point { position: self.position })
    }
}
