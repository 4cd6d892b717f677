//! Squares of two colours.
//!
//! ```toml
//! [[texture]]
//! name = "tiles"
//! kind = "checker"
//! color = "#f0f0f0"
//! other_color = "#303030"
//! ```

use super::{Pattern, TextureKind};
use crate::{Assets, ParamKind};
use vitrine_math::Rgb;

crate::params! {
    /// A chessboard of two colours; one repeat is two squares by two.
    pub struct Checker {
        /// The colour of the first square.
        color: Rgb = Rgb::new(0.8, 0.8, 0.8) => ParamKind::Color, None;
        /// The colour of its neighbours.
        other_color: Rgb = Rgb::new(0.2, 0.2, 0.2) => ParamKind::Color, None;
    }
}

impl TextureKind for Checker {
    fn pattern(&self, _: &Assets) -> Option<Pattern> {
        Some(Pattern::Checker { colors: [self.color, self.other_color] })
    }
}
