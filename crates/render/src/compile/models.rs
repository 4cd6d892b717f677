//! Models made ready for rays: checked first, each built once, however many objects show it.

use super::limits::is_near_enough;
use crate::accel::{MeshAccel, NOTHING};
use crate::error::{CompileError, ModelFlaw};
use std::collections::HashMap;
use std::sync::Arc;
use vitrine_scene::TriangleMesh;

/// The models of a scene.
#[derive(Default)]
pub struct Models {
    /// Trees by model. The key is the model's address, which the value keeps alive.
    ready: HashMap<*const TriangleMesh, (Arc<TriangleMesh>, Arc<MeshAccel>)>,
    /// Bytes of the models and their trees.
    pub memory: usize,
}

impl Models {
    /// The tree over a model that an object shows.
    ///
    /// # Errors
    /// When the model cannot be computed with.
    pub fn tree(&mut self, object: &str, mesh: &Arc<TriangleMesh>) -> Result<Arc<MeshAccel>, CompileError> {
        if let Some((_, accel)) = self.ready.get(&Arc::as_ptr(mesh)) {
            return Ok(accel.clone());
        }
        let object = || object.to_owned();
        let triangles = mesh.triangles.len();
        // Indices travel as the bits of floats, see `accel::NOTHING`.
        if triangles >= NOTHING as usize {
            return Err(CompileError::TooManyTriangles { object: object(), triangles });
        }
        flaw_of(mesh).map_or(Ok(()), |flaw| Err(CompileError::BadModel { object: object(), flaw }))?;
        if triangles > 0 && !is_near_enough(&mesh.bounds()) {
            return Err(CompileError::OutOfRange { object: object() });
        }
        let accel = Arc::new(MeshAccel::new(&mesh.positions, &mesh.triangles, slots(mesh)));
        self.memory += accel.memory() + mesh.memory();
        self.ready.insert(Arc::as_ptr(mesh), (mesh.clone(), accel.clone()));
        Ok(accel)
    }
}

/// Why a model cannot be computed with; None when it can. Readers of files make no such models, programs may.
fn flaw_of(mesh: &TriangleMesh) -> Option<ModelFlaw> {
    let vertices = mesh.positions.len();
    let one_each = |count: usize| count == 0 || count == vertices;
    let is_there = |corner: &u32| (*corner as usize) < vertices;
    if !mesh.positions.iter().all(|p| p.is_finite()) {
        return Some(ModelFlaw::Position);
    }
    if !(one_each(mesh.normals.len()) && mesh.normals.iter().all(|n| n.is_finite())) {
        return Some(ModelFlaw::Normals);
    }
    if !(one_each(mesh.uvs.len()) && mesh.uvs.iter().all(|uv| uv.is_finite())) {
        return Some(ModelFlaw::Uvs);
    }
    if let Some(triangle) = mesh.triangles.iter().position(|t| !t.iter().all(is_there)) {
        return Some(ModelFlaw::Corner { triangle });
    }
    let is_part = |part: &vitrine_scene::MeshPart| {
        let is_run = part.triangles.start <= part.triangles.end && part.triangles.end <= mesh.triangles.len();
        is_run && part.material.is_none_or(|material| material < mesh.materials.len())
    };
    mesh.parts.iter().position(|part| !is_part(part)).map(|part| ModelFlaw::Part { part })
}

/// Each triangle's material slot; empty when the model has no materials.
fn slots(mesh: &TriangleMesh) -> Vec<u16> {
    if mesh.materials.is_empty() {
        return Vec::new();
    }
    let mut slots = vec![0; mesh.triangles.len()];
    for part in &mesh.parts {
        let slot = part.material.map_or(0, |m| u16::try_from(m + 1).unwrap_or(0));
        slots[part.triangles.clone()].fill(slot);
    }
    slots
}
