//! A model of triangles from a file.
//!
//! ```toml
//! [[object]]
//! name = "cone"
//! shape = "mesh"
//! file = "models/cone.obj"
//! ```

use super::{Geometry, ShapeKind};
use crate::{Assets, ParamKind};
use std::path::Path;

crate::params! {
    /// A model of triangles from a file (OBJ).
    pub struct Mesh {
        /// The model's file.
        file: String = String::new() => ParamKind::File, None, required;
        /// Shade by the file's normals, where it has any, so that facets look round.
        smooth: bool = true => ParamKind::Flag, None;
    }
}

impl ShapeKind for Mesh {
    fn geometry(&self, assets: &Assets) -> Option<Geometry> {
        let mesh = assets.meshes.get(Path::new(&self.file))?;
        Some(if self.smooth { Geometry::Mesh(mesh.clone()) } else { Geometry::Facets(mesh.clone()) })
    }

    fn file(&self) -> Option<&Path> {
        Some(Path::new(&self.file))
    }
}
