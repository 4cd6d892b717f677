//! The scene as a person edits it: plain data, names for references, no files and no rendering.
//!
//! [`Scene`] is what a scene file says and what the editor changes. Each kind of shape, light, texture and the
//! material describes its own parameters once ([`mod@params`]); everything that reads, writes, shows or documents
//! them works from those descriptions.

mod assets;
mod camera;
mod check;
mod closed;
mod declare;
mod group;
pub mod lights;
pub mod materials;
mod object;
pub mod params;
mod path;
mod placement;
mod scene;
mod settings;
pub mod shapes;
mod solids;
mod suggest;
pub mod textures;

pub use assets::{Assets, MeshMaterial, MeshPart, Picture, RadianceMap, TriangleMesh};
pub use camera::{Camera, Fault};
pub use check::{Cause, Place, Problem, Severity};
pub use group::Group;
pub use lights::{Light, LightSource};
pub use materials::{ClassicMaterial, Material, Metal, PhysicalMaterial};
pub use object::Object;
pub use params::{
    KindSpec, ListName, ParamError, ParamKind, ParamSpec, ParamValue, Params, Range, Unit, Value,
};
pub use path::{Owner, PathError, ScenePath};
pub use placement::GroupPlaces;
pub use scene::{Item, Scene};
pub use settings::{Renderer, Settings, View};
pub use shapes::{Geometry, Shape};
pub use suggest::closest;
pub use textures::{Pattern, Texture, TextureSource, Wrap};
