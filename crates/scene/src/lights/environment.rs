//! The light of a place, from a panorama.
//!
//! ```toml
//! [[light]]
//! name = "street"
//! kind = "environment"
//! file = "street.hdr"
//! turn_deg = 90.0
//! intensity = 1.0
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind, Range};
use std::path::Path;

crate::params! {
    /// The light of a place all around, from a panorama; the classic renderer takes its mean for ambient light.
    pub struct Environment {
        /// The panorama, twice as wide as high: OpenEXR or Radiance HDR with true brightness, PNG or JPEG without. Its middle is towards −Z.
        file: String = String::new() => ParamKind::File, None, required;
        /// How far it is turned about the Y axis.
        turn_deg: f32 = 0.0 => ParamKind::Number(Range::ANY), Degrees;
    }
}

impl LightKind for Environment {
    fn emission(&self, assets: &Assets) -> Option<Emission> {
        let map = assets.maps.get(Path::new(&self.file))?.clone();
        // Whole turns are taken off first, so that angles stay exact.
        Some(Emission::Environment { map, turn: (self.turn_deg % 360.0).to_radians() })
    }

    fn file(&self) -> Option<&Path> {
        Some(Path::new(&self.file))
    }
}
