//! From the scene that a person edits to flat arrays that threads share: names become indices, places become matrices,
//! shapes become the exact forms of [`accel`](crate::accel).

mod camera;
mod geometry;
mod lamps;
mod limits;
mod materials;
mod models;
mod nests;
mod overlapping;
mod photoreal;
mod physical;
mod solids;
mod touching;

pub use camera::CompiledCamera;
pub use geometry::{Form, Primitive};
pub use limits::{FARTHEST, memory_limit};
pub use materials::{CompiledMaterial, CompiledTexture};
pub use nests::{MOST_SHELLS, Nest};
pub use photoreal::LazyPhotoreal;
pub use physical::CompiledPhysical;
pub use solids::{AIR, Mirror, Piece, Solids, probe};
pub use touching::reach_of;

use crate::accel::simd::Instructions;
use crate::accel::{Accel, AccelFlaw};
use crate::error::CompileError;
use crate::surface::NormalField;
use models::Models;
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
    /// What shines, as the classic renderer takes it: without `Everywhere`, `Environment`, `Sky` and `Sphere`.
    pub(crate) lights: Vec<CompiledLight>,
    /// The materials as the photoreal renderer sees them, by the same indices.
    pub(crate) physical: Vec<CompiledPhysical>,
    /// What else the photoreal renderer needs, once it has begun.
    pub(crate) photoreal: LazyPhotoreal,
    /// The sum of all light that is everywhere.
    pub(crate) ambient: Rgb,
    pub(crate) background: Rgb,
    bounds: Bounds3,
    triangles: usize,
    mesh_memory: usize,
}

/// A light that casts shadows.
#[derive(Clone, Debug, PartialEq)]
pub struct CompiledLight {
    /// Where the light comes from.
    pub emission: Emission,
    /// Intensity times colour.
    pub radiance: Rgb,
}

/// How a scene is made ready.
#[derive(Clone, Copy, Debug)]
pub struct CompileOptions<'a> {
    /// The most bytes that the trees over the scene's models may take. They are estimated before they are built.
    pub memory: u64,
    /// An earlier state of the scene, or another scene: trees over models that both of them show (the same [`Arc`], not only the
    /// same triangles) are taken over and not built anew.
    ///
    /// [`Arc`]: std::sync::Arc
    pub earlier: Option<&'a CompiledScene>,
}

impl Default for CompileOptions<'_> {
    /// As much memory as [`memory_limit`] says, and nothing to take over.
    fn default() -> Self {
        Self { memory: memory_limit(), earlier: None }
    }
}

/// Makes a scene ready.
///
/// # Errors
/// [`CompileError`]: a name, a model or a picture is missing, numbers leave the range of floats, or the trees would not fit
/// into memory.
pub fn compile(scene: &Scene, assets: &Assets) -> Result<CompiledScene, CompileError> {
    compile_with(scene, assets, CompileOptions::default())
}

/// Makes a scene ready, with options.
///
/// # Errors
/// As [`compile`].
pub fn compile_with(
    scene: &Scene,
    assets: &Assets,
    options: CompileOptions,
) -> Result<CompiledScene, CompileError> {
    let mut table = materials::MaterialTable::new(scene, assets)?;
    let models = Models::new(options.memory, options.earlier.map_or(&[], |earlier| &earlier.primitives));
    let geometry = geometry::collect(scene, assets, &mut table, models)?;
    let transparencies = table.materials.iter().map(|m| m.transparency).collect();
    let emissions = lamps::emissions(scene, assets)?;
    let (lights, ambient) = lamps::classic(&emissions);
    Ok(CompiledScene {
        accel: Accel::new(geometry.collected, transparencies),
        camera: CompiledCamera::new(&scene.camera),
        normals: geometry.primitives.iter().map(NormalField::new).collect(),
        primitives: geometry.primitives,
        materials: table.materials,
        textures: table.textures,
        lights,
        physical: table.physical,
        photoreal: LazyPhotoreal::new(emissions, &scene.lights, scene.camera.position),
        ambient: limits::dimmed(ambient),
        background: limits::dimmed(scene.settings.background),
        bounds: geometry.bounds,
        triangles: geometry.triangles,
        mesh_memory: geometry.models.memory,
    })
}

impl CompiledScene {
    /// Makes a later state of the scene ready, with the same instructions. Trees over models that are still shown are taken over:
    /// moving, hiding or painting objects takes no longer for large models than for small ones.
    ///
    /// # Errors
    /// As [`compile`].
    pub fn recompile(&self, scene: &Scene, assets: &Assets) -> Result<Self, CompileError> {
        let options = CompileOptions { earlier: Some(self), ..CompileOptions::default() };
        Ok(compile_with(scene, assets, options)?.with_instructions(self.accel.instructions))
    }

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

    /// Checks everything that rays walk through, which compiling leaves right: trees, boxes, and that each primitive and each
    /// triangle of a model can be found. It takes about as long as building the trees.
    ///
    /// # Errors
    /// The first [`AccelFlaw`] that is found.
    pub fn validate(&self) -> Result<(), AccelFlaw> {
        let held = self.accel.validate_with(&|id| self.primitives.get(id as usize)?.outline())?;
        let is_held = |place: usize| held.get(place).is_some_and(|held| *held);
        let is_lost = |place: &usize| !is_held(*place) && !self.primitives[*place].is_nothing();
        match (0..self.primitives.len()).find(is_lost) {
            Some(place) => Err(AccelFlaw::Lost { primitive: place as u32 }),
            None => Ok(()),
        }
    }

    /// The same scene traced with other instructions; the picture is the same bytes.
    #[must_use]
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.accel = self.accel.with_instructions(instructions);
        self
    }

    /// The same scene without connections through clear glass: the photoreal renderer then finds what shines behind it by chance
    /// alone. The picture has the same expected values and more noise, which proves the connections right.
    #[doc(hidden)]
    #[must_use]
    pub fn without_connections(mut self) -> Self {
        self.photoreal_mut().solids.forget_clear();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Primitives;
    use crate::accel::tree::TreeFlaw;
    use crate::{Cancel, RenderJob, RenderOptions};
    use vitrine_math::Transform;
    use vitrine_scene::lights::Sky;
    use vitrine_scene::shapes::Cuboid;
    use vitrine_scene::{Light, LightSource, Object, Renderer, Settings, Shape};

    fn one_box() -> CompiledScene {
        let shape = Shape::Box(Cuboid::default());
        let object = Object { name: "box".into(), shape, ..Object::default() };
        let scene = Scene { objects: vec![object], ..Scene::default() };
        let compiled = compile(&scene, &Assets::default()).unwrap();
        assert_eq!(compiled.validate(), Ok(()));
        compiled
    }

    #[test]
    fn a_form_that_reaches_out_of_its_box_in_the_tree_is_found() {
        let mut compiled = one_box();
        let Form::Box { unit } = &mut compiled.primitives[0].form else { panic!("a box stays one") };
        *unit = unit.after(&Transform::from_place(
            vitrine_math::Vec3::ZERO,
            vitrine_math::Vec3::ZERO,
            vitrine_math::Vec3::splat(1.000_01),
        ));
        let flaw = TreeFlaw::OutsideBox { node: 0, place: 0 };
        assert_eq!(compiled.validate(), Err(AccelFlaw::Scene { flaw }));
    }

    #[test]
    fn a_primitive_that_no_leaf_holds_is_found() {
        let mut compiled = one_box();
        compiled.accel = Accel::new(Primitives::default(), Vec::new());
        assert_eq!(compiled.validate(), Err(AccelFlaw::Lost { primitive: 0 }));
    }
    #[test]
    fn what_the_photoreal_renderer_needs_is_made_when_it_begins_and_anew_after_a_change() {
        let sky = LightSource::Sky(Sky::default());
        let scene = Scene { lights: vec![Light { source: sky, ..Light::default() }], ..Scene::default() };
        let compiled = compile(&scene, &Assets::default()).unwrap();
        let render = |compiled: &CompiledScene, renderer| {
            let settings = Settings { size: [2, 2], samples: 1, renderer, ..Settings::default() };
            let job = RenderJob::new(compiled, RenderOptions { settings, region: None }).unwrap();
            let _ = job.run(1, &Cancel::default(), &mut |_| {});
        };
        render(&compiled, Renderer::Classic);
        assert!(!compiled.photoreal.is_made());
        render(&compiled, Renderer::Photoreal);
        assert!(compiled.photoreal.is_made() && compiled.photoreal.has_panorama);
        assert!(!compiled.recompile(&scene, &Assets::default()).unwrap().photoreal.is_made());
    }
}
