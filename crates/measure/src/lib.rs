//! How fast the ray kernel is: scenes that are made by the program, rays through them, and a race over the same rays.
//!
//! `vitrine bench kernel` prints what a person's own machine does; the bench `kernel` races Vitrine against another
//! library. Both race the same scenes ([`Scene`]) with the same rays ([`rays::RaySet`]), so their figures can be compared.
//! Everything is a pure function of its arguments: two machines get the same scenes.
//!
//! What the renderer's ray kernel is called stands in [`kernel`] alone.

pub mod growth;
pub mod kernel;
pub mod race;
pub mod rays;
mod scene;
mod scenes;

pub use kernel::Kernel;
pub use scene::{Ball, Model, Part, Scene, View};
pub use scenes::SceneKind;
