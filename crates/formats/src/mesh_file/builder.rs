//! Puts a model together from what a file says: corners that share a vertex, parts, triangles without area left out.

use super::polygon::{PolygonCutter, double_area};
use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::ops::Range;
use vitrine_math::{Vec2, Vec3};
use vitrine_scene::{MeshPart, TriangleMesh};

/// The corner of a face: the places of its parts in the file's lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Among the positions.
    pub position: u32,
    /// Among the texture coordinates.
    pub uv: Option<u32>,
    /// Among the normals.
    pub normal: Option<u32>,
}

impl Hash for Corner {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // Two words instead of the derived five: a model has millions of corners.
        let [uv, normal] = [self.uv, self.normal].map(|i| i.unwrap_or(u32::MAX));
        state.write_u64(u64::from(self.position) << 32 | u64::from(uv));
        state.write_u32(normal);
    }
}

/// The lists that a file's corners refer to.
#[derive(Debug, Default)]
pub struct Lists {
    /// Metres.
    pub positions: Vec<Vec3>,
    /// u to the right, v up.
    pub uvs: Vec<Vec2>,
    /// Unit length, or zero for none.
    pub normals: Vec<Vec3>,
}

/// Collects a model face by face.
#[derive(Default)]
pub struct MeshBuilder {
    mesh: TriangleMesh,
    vertex_of: HashMap<Corner, u32>,
    cutter: PolygonCutter,
    outline: Vec<Vec3>,
    part: (String, Option<usize>),
    part_start: usize,
    flat_faces: usize,
}

impl MeshBuilder {
    /// What follows belongs to a part of that name and material.
    pub fn begin_part(&mut self, name: &str, material: Option<usize>) {
        if self.part.0 != name || self.part.1 != material {
            self.end_part();
            self.part = (name.to_owned(), material);
        }
    }

    /// Adds a face, cut into triangles.
    pub fn add_face(&mut self, lists: &Lists, corners: &[Corner]) {
        self.outline.clear();
        self.outline.extend(corners.iter().map(|c| lists.positions[c.position as usize]));
        let before = self.mesh.triangles.len();
        let triangles = self.cutter.cut(&self.outline).iter().map(|t| t.map(|i| i as usize));
        for triangle in triangles.filter(|t| double_area(t.map(|i| self.outline[i])).length_squared() > 0.0) {
            let vertices = triangle.map(|i| {
                let next = self.vertex_of.len() as u32;
                *self.vertex_of.entry(corners[i]).or_insert_with(|| {
                    add_vertex(&mut self.mesh, lists, corners[i]);
                    next
                })
            });
            self.mesh.triangles.push(vertices);
        }
        if self.mesh.triangles.len() == before {
            self.flat_faces += 1;
        }
    }

    /// The model without its materials, and how many faces had no area and were left out.
    pub fn finish(mut self) -> (TriangleMesh, usize) {
        self.end_part();
        let mut mesh = self.mesh;
        let count = mesh.positions.len();
        if !mesh.uvs.is_empty() {
            mesh.uvs.resize(count, Vec2::ZERO);
        }
        if !mesh.normals.is_empty() {
            mesh.normals.resize(count, Vec3::ZERO);
        }
        mesh.positions.shrink_to_fit();
        mesh.normals.shrink_to_fit();
        mesh.uvs.shrink_to_fit();
        mesh.triangles.shrink_to_fit();
        (mesh, self.flat_faces)
    }

    fn end_part(&mut self) {
        let triangles = Range { start: self.part_start, end: self.mesh.triangles.len() };
        self.part_start = triangles.end;
        if !triangles.is_empty() {
            let (name, material) = std::mem::take(&mut self.part);
            self.mesh.parts.push(MeshPart { name, triangles, material });
        }
    }
}

/// Appends the vertex of a corner. Normals and texture coordinates stay empty lists until a corner has one.
fn add_vertex(mesh: &mut TriangleMesh, lists: &Lists, corner: Corner) {
    let index = mesh.positions.len();
    mesh.positions.push(lists.positions[corner.position as usize]);
    if let Some(uv) = corner.uv {
        mesh.uvs.resize(index, Vec2::ZERO);
        mesh.uvs.push(lists.uvs[uv as usize]);
    }
    if let Some(normal) = corner.normal.map(|n| lists.normals[n as usize]).filter(|n| *n != Vec3::ZERO) {
        mesh.normals.resize(index, Vec3::ZERO);
        mesh.normals.push(normal);
    }
}
