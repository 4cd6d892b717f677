//! The shapes. A new one is a file beside these and a line in the register below.

mod cuboid;
mod disc;
mod mesh;
mod plane;
mod sphere;
mod triangle;

pub use cuboid::Cuboid;
pub use disc::Disc;
pub use mesh::Mesh;
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::{Assets, Fault, Params, TriangleMesh};
use std::path::Path;
use std::sync::Arc;
use vitrine_math::Vec3;

crate::kinds! {
    /// The form of an object, in its own space: its centre (a plane's or triangle's own points apart) is the origin.
    pub enum Shape as ShapeKind {
        Sphere(Sphere) = "sphere",
        Box(Cuboid) = "box",
        Plane(Plane) = "plane",
        Disc(Disc) = "disc",
        Triangle(Triangle) = "triangle",
        Mesh(Mesh) = "mesh",
    }
}

/// What every shape can do.
pub trait ShapeKind: Params {
    /// The form in terms that the renderer intersects, in object space. None when a file it needs is not among the assets.
    fn geometry(&self, assets: &Assets) -> Option<Geometry>;

    /// A fault that no single parameter has, such as three points on a line: the parameter to blame and what is wrong.
    fn fault(&self) -> Option<Fault> {
        None
    }

    /// The model file that it needs, relative to the scene file.
    fn file(&self) -> Option<&Path> {
        None
    }
}

/// The forms that the renderer knows. All but the mesh are exact, and all are in object space.
#[derive(Clone, Debug)]
pub enum Geometry {
    /// Centre at the origin.
    Sphere {
        /// Metres.
        radius: f32,
    },
    /// Centre at the origin, faces across the axes.
    Box {
        /// Half of each edge, metres.
        half: Vec3,
    },
    /// y = 0, normal +y, without end.
    Plane,
    /// y = 0, centre at the origin, normal +y.
    Disc {
        /// Metres.
        radius: f32,
    },
    /// One triangle.
    Triangle {
        /// The corners, metres.
        points: [Vec3; 3],
        /// The picture's coordinates at the corners.
        uvs: [[f32; 2]; 3],
    },
    /// Many triangles, shaded by the normals at their corners, if there are any.
    Mesh(Arc<TriangleMesh>),
    /// Many triangles, each shaded as the flat thing that it is.
    Facets(Arc<TriangleMesh>),
}
