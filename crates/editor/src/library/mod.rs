//! What the program brings along: materials, scenes to begin with, their files, and pictures of them all, which the
//! renderer itself makes.

mod carried;
mod materials;
mod sample;
mod thumbnails;

pub use carried::{add_carried, carried, carried_model, carried_picture};
pub use materials::{Category, LibraryMaterial, materials};
pub use thumbnails::{ThumbnailImage, Thumbnails};

/// The key of a template's title in the locales; its attribute `about` is the line below.
#[must_use]
pub fn template_key(name: &str) -> String {
    format!("template-{name}")
}
