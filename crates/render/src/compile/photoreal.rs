//! What the photoreal renderer needs beside what all renderers do: lights as they are, solids, what the camera is inside of.

use super::CompiledScene;
use super::geometry::{Form, Primitive};
use super::physical::{CompiledPhysical, is_thin};
use super::solids::{Candidate, Solids};
use crate::integrators::CompiledMedia;
use crate::lights::{Emitter, EmitterForm, LampSpec, Lights};
use std::ops::Deref;
use std::sync::OnceLock;
use vitrine_math::{Bounds3, Rgb, Vec3};
use vitrine_scene::Light;
use vitrine_scene::lights::Emission;

/// So many times the scene's size away stands what is infinitely far.
const FAR: f64 = 1e5;

/// Lights, solids and what follows from them.
#[derive(Debug, Default)]
pub struct Photoreal {
    /// What shines.
    pub lights: Lights,
    /// What light passes through.
    pub solids: Solids,
    /// Whether there are thin sheets, or surfaces inside other solids, that light goes straight on through.
    pub passes_sheets: bool,
    /// Whether an index depends on the wavelength.
    pub has_dispersion: bool,
    /// Whether the camera sees a panorama or a sky where there is nothing.
    pub has_panorama: bool,
    /// Where what is infinitely far is taken to be, metres.
    pub far: f64,
    /// What the camera is inside of.
    pub camera_media: CompiledMedia,
}

/// The same, made when the first photoreal picture begins: other renderers need none of it, and a sky's map or the surfaces of a model
/// that glows take a while.
#[derive(Debug)]
pub struct LazyPhotoreal {
    lamps: Vec<Lamp>,
    /// Where the camera is.
    camera: Vec3,
    made: OnceLock<Photoreal>,
}

/// A light of the scene.
#[derive(Debug)]
struct Lamp {
    emission: Emission,
    radiance: Rgb,
    /// As the scene states it.
    full_at: Option<f32>,
}

impl LazyPhotoreal {
    /// Nothing yet. `emissions` are those of the lights that are on, with their places among `lights`.
    pub fn new(emissions: Vec<(Emission, Rgb, usize)>, lights: &[Light], camera: Vec3) -> Self {
        let lamp = |(emission, radiance, index): (Emission, Rgb, usize)| {
            let full_at = lights[index].full_at;
            Lamp { emission, radiance, full_at }
        };
        let lamps = emissions.into_iter().map(lamp).collect();
        Self { lamps, camera, made: OnceLock::new() }
    }

    /// Whether it has been made.
    #[cfg(test)]
    pub fn is_made(&self) -> bool {
        self.made.get().is_some()
    }
}

impl Deref for LazyPhotoreal {
    type Target = Photoreal;

    #[inline]
    fn deref(&self) -> &Photoreal {
        self.made.get().expect("whoever works out a photoreal tile has it made first")
    }
}

impl CompiledScene {
    /// Makes what the photoreal renderer needs, unless it is there.
    #[inline]
    pub(crate) fn make_photoreal(&self) {
        self.photoreal.made.get_or_init(|| {
            let LazyPhotoreal { lamps, camera, .. } = &self.photoreal;
            let (primitives, physical) = (&self.primitives, &self.physical);
            let parts = Parts { primitives, physical, lamps, bounds: self.bounds(), camera: *camera };
            let mut made = Photoreal::new(&parts);
            made.camera_media = CompiledMedia::at(&self.accel, &made.solids, *camera);
            made
        });
    }

    /// The same to be changed.
    pub(crate) fn photoreal_mut(&mut self) -> &mut Photoreal {
        self.make_photoreal();
        self.photoreal.made.get_mut().expect("it has just been made")
    }
}

/// What it is made from.
struct Parts<'a> {
    primitives: &'a [Primitive],
    physical: &'a [CompiledPhysical],
    lamps: &'a [Lamp],
    bounds: Bounds3,
    camera: Vec3,
}

impl<'a> Parts<'a> {
    /// The materials of a primitive, slot by slot.
    fn materials_of(&self, primitive: &Primitive) -> &'a [CompiledPhysical] {
        &self.physical[primitive.material as usize..][..primitive.slots()]
    }
}

impl Photoreal {
    /// All but what the camera is inside of, for which rays are needed.
    fn new(parts: &Parts) -> Self {
        let solids = Solids::new(solids(parts), parts.primitives.len()).with_mirrors(mirrors(parts));
        let is_sheet = |p: &Primitive| {
            let materials = parts.materials_of(p);
            materials.iter().any(CompiledPhysical::is_transmissive) && is_thin(&materials[0].numbers, p)
        };
        let sees_far = |e: &Emission| matches!(e, Emission::Environment { .. } | Emission::Sky { .. });
        let middle = if parts.bounds.is_empty() { Vec3::ZERO } else { parts.bounds.center() };
        let size = if parts.bounds.is_empty() { 1.0 } else { parts.bounds.size().length() };
        let reach = size + (parts.camera - middle).length();
        let has_dispersion = solids.iter().any(|(_, s)| s.substance.is_dispersive);
        Self {
            lights: Lights::new(&lamps(parts, middle), &emitters(parts)),
            passes_sheets: parts.primitives.iter().any(is_sheet) || solids.iter().count() > 1,
            has_dispersion,
            solids,
            has_panorama: parts.lamps.iter().any(|lamp| sees_far(&lamp.emission)),
            far: f64::from(reach).max(1e-6) * FAR,
            camera_media: CompiledMedia::default(),
        }
    }
}

/// The things with an inside that light passes.
fn solids<'a>(parts: &'a Parts) -> impl Iterator<Item = Candidate<'a>> {
    (0..).zip(parts.primitives).filter_map(|(id, primitive)| {
        let materials = parts.materials_of(primitive);
        let glass = materials.iter().find(|m| m.is_transmissive())?;
        let is_solid = !is_thin(&glass.numbers, primitive);
        is_solid.then(|| Candidate {
            primitive,
            id,
            substance: glass.substance,
            is_clear: materials.iter().all(|m| m.is_clear),
        })
    })
}

/// The things of polished metal, each with its place in the scene.
fn mirrors<'a>(parts: &'a Parts) -> impl Iterator<Item = (u32, &'a Primitive)> {
    (0..)
        .zip(parts.primitives)
        .filter(|(_, primitive)| parts.materials_of(primitive).iter().all(|m| m.is_mirror))
}

/// The scene's lights.
fn lamps(parts: &Parts, middle: Vec3) -> Vec<LampSpec> {
    let lamp = |Lamp { emission, radiance, full_at }: &Lamp| {
        let position = match emission {
            Emission::Point { position }
            | Emission::Disc { position, .. }
            | Emission::Sphere { position, .. } => Some(*position),
            _ => None,
        };
        // A lamp in the very middle of things shines on what is a metre away.
        let away = position.map(|p| (p - middle).length()).filter(|d| *d > 1e-3).unwrap_or(1.0);
        LampSpec { emission: emission.clone(), radiance: *radiance, full_at: full_at.unwrap_or(away) }
    };
    parts.lamps.iter().map(lamp).collect()
}

/// The surfaces that shine.
fn emitters(parts: &Parts) -> Vec<Emitter> {
    let mut emitters = Vec::new();
    for (id, primitive) in (0..).zip(parts.primitives) {
        let materials = parts.materials_of(primitive);
        // What a picture makes brighter here and darker there is found by chance alone.
        let is_flat = |m: &CompiledPhysical| m.emission != Rgb::BLACK && m.textures.emission.is_none();
        if !materials.iter().any(is_flat) {
            continue;
        }
        let is_mirrored = primitive.transform.world_from_object.matrix3.determinant() < 0.0;
        let mut add = |form: EmitterForm, triangle: u32| {
            let material = &parts.physical[primitive.material_of(triangle) as usize];
            if is_flat(material) {
                let (radiance, primitive) = (material.emission, id);
                emitters.push(Emitter { form, radiance, is_two_sided: false, primitive, triangle });
            }
        };
        match &primitive.form {
            Form::Sphere { center, radius } => {
                add(EmitterForm::Sphere { center: *center, radius: *radius }, 0);
            }
            Form::Ellipsoid { unit } => add(EmitterForm::Ellipsoid { unit: *unit }, 0),
            Form::Box { unit } => add(EmitterForm::Box { unit: *unit }, 0),
            Form::Disc { unit, n } => add(EmitterForm::Disc { unit: *unit, n: *n }, 0),
            Form::Triangle { points, .. } => add(EmitterForm::Triangle { points: *points }, 0),
            Form::Mesh { mesh, .. } => {
                for (triangle, corners) in (0..).zip(&mesh.triangles) {
                    let mut points = corners.map(|c| primitive.transform.point(mesh.positions[c as usize]));
                    // A mirror image of a model turns its triangles over.
                    if is_mirrored {
                        points.swap(1, 2);
                    }
                    add(EmitterForm::Triangle { points }, triangle);
                }
            }
            // It shines, and is found by chance alone: no point of a plane without end can be chosen.
            Form::Plane { .. } => {}
        }
    }
    emitters
}
