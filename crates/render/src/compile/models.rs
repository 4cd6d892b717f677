//! Models made ready for rays: checked first, each built once, however many objects show it.

use super::geometry::{Form, Primitive};
use super::limits::is_near_enough;
use crate::accel::{MeshAccel, NOTHING};
use crate::error::{CompileError, ModelFlaw};
use std::collections::HashMap;
use std::sync::Arc;
use vitrine_scene::{MeshPart, TriangleMesh};

/// The models of a scene.
#[derive(Default)]
pub struct Models {
    /// Trees by model. The key is the model's address, which the value keeps alive.
    ready: HashMap<*const TriangleMesh, Ready>,
    /// Bytes of the models that are shown and of their trees.
    pub memory: usize,
    /// Bytes of the trees alone.
    trees: u64,
    /// The most bytes that the trees may take.
    limit: u64,
}

struct Ready {
    mesh: Arc<TriangleMesh>,
    accel: Arc<MeshAccel>,
    /// Whether it belongs to this scene, not only to the one before.
    is_shown: bool,
}

impl Models {
    /// No models yet. The trees of those among the earlier primitives will be taken over.
    pub fn new(limit: u64, earlier: &[Primitive]) -> Self {
        let models = earlier.iter().filter_map(|primitive| match &primitive.form {
            Form::Mesh { mesh, accel, .. } => Some((mesh, accel)),
            _ => None,
        });
        let ready = |(mesh, accel): (&Arc<TriangleMesh>, &Arc<MeshAccel>)| {
            (Arc::as_ptr(mesh), Ready { mesh: mesh.clone(), accel: accel.clone(), is_shown: false })
        };
        Self { ready: models.map(ready).collect(), limit, ..Self::default() }
    }

    /// The tree over a model that an object shows. Building it takes time; asking again takes none.
    ///
    /// # Errors
    /// When the model cannot be computed with or is too large.
    pub fn tree(&mut self, object: &str, mesh: &Arc<TriangleMesh>) -> Result<Arc<MeshAccel>, CompileError> {
        let key = Arc::as_ptr(mesh);
        if !self.ready.contains_key(&key) {
            let accel = Arc::new(self.build(object, mesh)?);
            self.ready.insert(key, Ready { mesh: mesh.clone(), accel, is_shown: false });
        }
        let ready = self.ready.get_mut(&key).expect("it has just been looked for and put there");
        if !std::mem::replace(&mut ready.is_shown, true) {
            self.memory += ready.accel.memory() + ready.mesh.memory();
            self.trees += ready.accel.memory() as u64;
        }
        Ok(ready.accel.clone())
    }

    /// Whether a model whose tree is there has an inside and an outside.
    pub fn is_closed(&self, mesh: &Arc<TriangleMesh>) -> bool {
        let ready = self.ready.get(&Arc::as_ptr(mesh));
        ready.is_some_and(|ready| ready.accel.is_closed(|| mesh.is_closed()))
    }

    fn build(&self, object: &str, mesh: &TriangleMesh) -> Result<MeshAccel, CompileError> {
        let object = || object.to_owned();
        let triangles = mesh.triangles.len();
        // Indices travel as the bits of floats, see `accel::NOTHING`.
        if triangles >= NOTHING as usize {
            return Err(CompileError::TooManyTriangles { object: object(), triangles });
        }
        let needed = self.trees + MeshAccel::bytes_to_build(triangles);
        if needed > self.limit {
            let allowed = self.limit;
            return Err(CompileError::TooMuchMemory { object: object(), triangles, needed, allowed });
        }
        if let Some(flaw) = flaw_of(mesh) {
            return Err(CompileError::BadModel { object: object(), flaw });
        }
        if triangles > 0 && !is_near_enough(&mesh.bounds()) {
            return Err(CompileError::OutOfRange { object: object() });
        }
        Ok(MeshAccel::new(&mesh.positions, &mesh.triangles, slots(mesh)))
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
    let is_part = |part: &MeshPart| {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::{CompiledScene, compile};
    use vitrine_math::Vec3;
    use vitrine_scene::shapes::Mesh;
    use vitrine_scene::{Assets, Object, Scene, Shape};

    /// The trees of a scene's objects, in order.
    fn trees(compiled: &CompiledScene) -> Vec<&Arc<MeshAccel>> {
        compiled
            .primitives
            .iter()
            .map(|primitive| match &primitive.form {
                Form::Mesh { accel, .. } => accel,
                _ => panic!("a model"),
            })
            .collect()
    }

    fn triangle() -> TriangleMesh {
        TriangleMesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            triangles: vec![[0, 1, 2]],
            ..TriangleMesh::default()
        }
    }

    fn object(name: &str, file: &str, smooth: bool) -> Object {
        let shape = Shape::Mesh(Mesh { file: file.into(), smooth });
        Object { name: name.into(), shape, ..Object::default() }
    }

    #[test]
    fn a_tree_is_shared_by_all_objects_and_by_later_states_of_the_scene() {
        let meshes = ["a", "b"].map(|file| (file.into(), Arc::new(triangle()))).into();
        let mut assets = Assets { meshes, ..Assets::default() };
        let objects = vec![object("1", "a", true), object("2", "a", false), object("3", "b", true)];
        let mut scene = Scene { objects, ..Scene::default() };
        let first = compile(&scene, &assets).unwrap();
        let old = trees(&first);
        assert!(Arc::ptr_eq(old[0], old[1]) && !Arc::ptr_eq(old[0], old[2]));

        scene.objects[0].position = Vec3::ONE;
        let second = first.recompile(&scene, &assets).unwrap();
        assert!(old.iter().zip(trees(&second)).all(|(old, new)| Arc::ptr_eq(old, new)));

        // An equal model is another model; the one that is still there stays.
        assets.meshes.insert("a".into(), Arc::new(triangle()));
        let third = second.recompile(&scene, &assets).unwrap();
        let new = trees(&third);
        assert!(!Arc::ptr_eq(old[0], new[0]) && Arc::ptr_eq(new[0], new[1]) && Arc::ptr_eq(old[2], new[2]));
    }

    #[test]
    fn building_takes_no_more_memory_than_was_estimated() {
        let net = |count: u32, height: fn(u32, u32) -> f32| {
            let at = |i: u32, j: u32| Vec3::new(i as f32, height(i, j), j as f32);
            let places = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
            let corners: Vec<_> = places.flat_map(|(i, j)| [at(i, j), at(i + 1, j), at(i, j + 1)]).collect();
            let triangles: Vec<_> = (0..count * count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
            let memory = MeshAccel::new(&corners, &triangles, Vec::new()).memory() as u64;
            let estimated = MeshAccel::bytes_to_build(triangles.len());
            assert!(memory <= estimated && estimated < 3 * memory + 8192, "{memory} of {estimated}");
        };
        for count in [0, 1, 3, 10, 100] {
            net(count, |_, _| 0.0);
            net(count, |i, j| (i * j % 17) as f32);
            net(count, |i, _| libm::exp2f((i % 60) as f32));
        }
    }
}
