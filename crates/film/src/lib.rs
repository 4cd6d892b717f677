//! The picture: a film that accumulates samples, the image that comes out of it, and the view transforms that show it.

mod band;
mod film;
mod image;
mod layers;
mod noise;
mod region;
pub mod tonemap;

pub use band::Band;
pub use film::{Film, FilmParts};
pub use image::Image;
pub use layers::{Features, Keep, Layers, TileSums};
pub use noise::Noise;
pub use region::{Region, RegionError};
pub use tonemap::{Display, ViewTransform};
