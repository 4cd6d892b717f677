//! A picture from a file.
//!
//! ```toml
//! [[texture]]
//! name = "globe"
//! kind = "picture"
//! file = "textures/globe.png"
//! ```

use super::{Pattern, TextureKind};
use crate::{Assets, ParamKind};
use std::path::Path;

crate::choices! {
    /// What lies beyond the edges of a picture.
    pub enum Wrap {
        /// The picture again.
        Repeat = "repeat",
        /// Its outermost texels.
        Clamp = "clamp",
    }
}

crate::params! {
    /// A picture from a PNG or JPEG file, laid over the surface.
    pub struct PictureFile {
        /// The picture's file.
        file: String = String::new() => ParamKind::File, None, required;
        /// What lies beyond the picture's edges: the picture again, or its outermost colours.
        wrap: Wrap = Wrap::Repeat => ParamKind::Choice(Wrap::WORDS), None;
    }
}

impl TextureKind for PictureFile {
    fn pattern(&self, assets: &Assets) -> Option<Pattern> {
        let picture = assets.pictures.get(Path::new(&self.file))?.clone();
        Some(Pattern::Picture { picture, wrap: self.wrap })
    }

    fn file(&self) -> Option<&Path> {
        Some(Path::new(&self.file))
    }
}
