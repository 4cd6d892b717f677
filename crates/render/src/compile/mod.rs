//! From the scene that a person edits to flat arrays that threads share: names become indices, places become matrices,
//! shapes become the exact forms of [`accel`](crate::accel).

mod camera;
mod geometry;
mod limits;
mod materials;
mod touching;

pub use camera::CompiledCamera;
pub use geometry::{Form, Primitive};
pub use limits::FARTHEST;
pub use materials::{CompiledMaterial, CompiledTexture};
pub use touching::reach_of;

use crate::accel::Accel;
use crate::accel::simd::Instructions;
use crate::error::CompileError;
use crate::surface::NormalField;
use vitrine_math::{Bounds3, Rgb};
use vitrine_scene::lights::Emission;
use vitrine_scene::{Assets, Scene};

/// A scene made ready for rendering: immutable, shared by threads without locks.
#[derive(Debug)]
pub struct CompiledScene {
    pub(crate) accel: Accel,
    pub(crate) camera: CompiledCamera,
    pub(crate) primitives: Vec<Primitive>,
    pub(crate) normals: Vec<NormalField>,
    pub(crate) materials: Vec<CompiledMaterial>,
    pub(crate) textures: Vec<CompiledTexture>,
    pub(crate) lights: Vec<CompiledLight>,
    /// The sum of all light that is everywhere.
    pub(crate) ambient: Rgb,
    pub(crate) background: Rgb,
    bounds: Bounds3,
    triangles: usize,
    mesh_memory: usize,
}

/// A light that casts shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompiledLight {
    /// Where the light comes from.
    pub emission: Emission,
    /// Intensity times colour.
    pub radiance: Rgb,
}

/// Makes a scene ready.
///
/// # Errors
/// [`CompileError`]: a name, a model or a picture is missing, or numbers leave the range of floats.
pub fn compile(scene: &Scene, assets: &Assets) -> Result<CompiledScene, CompileError> {
    let mut table = materials::MaterialTable::new(scene, assets)?;
    let geometry = geometry::collect(scene, assets, &mut table)?;
    let transparencies = table.materials.iter().map(|m| m.transparency).collect();
    let (mut lights, mut ambient) = (Vec::new(), Rgb::BLACK);
    for light in scene.lights.iter().filter(|l| l.visible && l.intensity > 0.0) {
        let radiance = limits::dimmed(light.color * light.intensity);
        match limits::drawn_in(light.source.as_kind().emission()) {
            Emission::Everywhere => ambient += radiance,
            emission => lights.push(CompiledLight { emission, radiance }),
        }
    }
    Ok(CompiledScene {
        accel: Accel::new(geometry.collected, transparencies),
        camera: CompiledCamera::new(&scene.camera),
        normals: geometry.primitives.iter().map(NormalField::new).collect(),
        primitives: geometry.primitives,
        materials: table.materials,
        textures: table.textures,
        lights,
        ambient: limits::dimmed(ambient),
        background: limits::dimmed(scene.settings.background),
        bounds: geometry.bounds,
        triangles: geometry.triangles,
        mesh_memory: geometry.mesh_memory,
    })
}

impl CompiledScene {
    /// The box around everything but planes; empty when there is nothing else. World space, metres.
    #[must_use]
    pub const fn bounds(&self) -> Bounds3 {
        self.bounds
    }

    /// Triangles of all objects, each object's model counted.
    #[must_use]
    pub const fn triangles(&self) -> usize {
        self.triangles
    }

    /// Bytes of geometry and trees.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.accel.memory() + self.mesh_memory + size_of_val(&*self.primitives)
    }

    /// The same scene traced with other instructions; the picture is the same bytes.
    #[must_use]
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.accel = self.accel.with_instructions(instructions);
        self
    }
}
