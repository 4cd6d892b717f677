//! Light that is everywhere alike.
//!
//! ```toml
//! [[light]]
//! name = "air"
//! kind = "ambient"
//! intensity = 0.15
//! ```

use super::{Emission, LightKind};
use crate::Assets;

crate::params! {
    /// Light that reaches every point alike and casts no shadow.
    pub struct Ambient {
    }
}

impl LightKind for Ambient {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        Some(Emission::Everywhere)
    }
}
