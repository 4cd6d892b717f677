//! The textures. A new one is a file beside these and a line in the register below.

mod checker;
mod picture;

pub use checker::Checker;
pub use picture::{PictureFile, Wrap};

use crate::{ParamKind, Params, Picture, Range};
use std::path::Path;
use std::sync::Arc;
use vitrine_math::Rgb;

use crate::Assets;

crate::kinds! {
    /// The kind of a texture with that kind's own parameters.
    pub enum TextureSource as TextureKind {
        Picture(PictureFile) = "picture",
        Checker(Checker) = "checker",
    }
}

crate::params! {
    /// A colour that changes over a surface.
    pub struct Texture {
        @plain {
            /// Its name, unique among the textures.
            name: String = "texture".to_owned();
            /// Its kind.
            source: TextureSource = TextureSource::Checker(Checker::default());
        }
        /// How many times it repeats across the surface's u and v. A plane's u and v count metres, other shapes' go once over the surface.
        repeat: [f32; 2] = [1.0, 1.0] => ParamKind::Pair(Range::POSITIVE), None;
        /// How far it is shifted along u and v, in repeats.
        shift: [f32; 2] = [0.0, 0.0] => ParamKind::Pair(Range::ANY), None;
    }
}

/// What every texture can do.
pub trait TextureKind: Params {
    /// The pattern in terms that the renderer looks up. None when a file it needs is not among the assets.
    fn pattern(&self, assets: &Assets) -> Option<Pattern>;

    /// The picture file that it needs, relative to the scene file.
    fn file(&self) -> Option<&Path> {
        None
    }
}

/// The patterns that the renderer knows.
#[derive(Clone, Debug)]
pub enum Pattern {
    /// A picture, its first row at v = 1.
    Picture {
        /// The texels.
        picture: Arc<Picture>,
        /// What lies beyond its edges.
        wrap: Wrap,
    },
    /// Squares: two to a repeat along each direction.
    Checker {
        /// The colours of the squares.
        colors: [Rgb; 2],
    },
}
