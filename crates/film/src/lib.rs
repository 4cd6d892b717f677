//! The picture: a film that accumulates samples, the image that comes out of it, and the view transforms that show it.

mod film;
mod image;
pub mod tonemap;

pub use film::{Band, Film, Region, RegionError};
pub use image::Image;
pub use tonemap::ViewTransform;
