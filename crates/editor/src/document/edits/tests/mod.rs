//! What each edit does to a scene.

mod camera;
mod groups;
mod lists;
mod places;
