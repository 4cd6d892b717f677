//! Sunlight: parallel rays.
//!
//! ```toml
//! [[light]]
//! name = "sun"
//! kind = "directional"
//! direction = [-0.4, -1.0, -0.3]
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind};
use vitrine_math::Vec3;

crate::params! {
    /// Sunlight: parallel rays from very far away; its shadows are sharp.
    pub struct Directional {
        /// The way the light travels: [0, -1, 0] shines straight down. Its length does not matter.
        direction: Vec3 = Vec3::new(-0.4, -1.0, -0.3) => ParamKind::Direction, None;
    }
}

impl LightKind for Directional {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        // Scaled first: the square of a very long or short vector would leave the range of numbers.
        let scaled = self.direction / self.direction.abs().max_element();
        Some(Emission::Direction { travels: scaled.normalize() })
    }
}
