//! Objects as primitives that rays can hit.

use super::limits::{is_little_stretched, is_near_enough, is_wide_enough};
use super::materials::MaterialTable;
use super::models::Models;
use super::overlapping::Placed;
use super::touching::separate;
use crate::accel::primitives::cuboid::Unit;
use crate::accel::primitives::disc::Disc;
use crate::accel::primitives::plane::Plane;
use crate::accel::primitives::sphere::Sphere;
use crate::accel::{Instance, MaterialSlots, MeshAccel, Primitives};
use crate::error::CompileError;
use std::sync::Arc;
use vitrine_math::{Bounds3, Transform, Vec3};
use vitrine_scene::{Assets, Geometry, Object, Scene, TriangleMesh};

/// What shading needs to know of a primitive beside where it was hit.
#[derive(Clone, Debug)]
pub struct Primitive {
    /// The form.
    pub form: Form,
    /// Its place.
    pub transform: Transform,
    /// The index of its object in the scene.
    pub object: u32,
    /// The index of its first material.
    pub material: u32,
    /// Whether a mesh's triangles choose among materials from the first on.
    pub by_triangle: bool,
    /// The size of the box around it in its own space, cubic metres; infinite where it has no inside.
    pub volume: f64,
}

/// The form of a primitive.
#[derive(Clone, Debug)]
pub enum Form {
    /// A ball in world space.
    Sphere {
        /// The centre.
        center: Vec3,
        /// The radius.
        radius: f32,
    },
    /// The unit ball of a space of its own.
    Ellipsoid {
        /// From that space to the world.
        unit: Transform,
    },
    /// The cube from −1 to 1 of a space of its own.
    Box {
        /// From that space to the world.
        unit: Transform,
    },
    /// The disc y = 0, x² + z² ≤ 1 of a space of its own.
    Disc {
        /// From that space to the world.
        unit: Transform,
        /// The unit normal in the world.
        n: Vec3,
    },
    /// A plane.
    Plane {
        /// One of its points.
        point: Vec3,
        /// The unit normal in the world.
        n: Vec3,
    },
    /// A triangle in world space.
    Triangle {
        /// The corners.
        points: [Vec3; 3],
        /// The unit normal.
        n: Vec3,
        /// The picture's coordinates at the corners.
        uvs: [[f32; 2]; 3],
    },
    /// A mesh in the space of its object.
    Mesh {
        /// The model.
        mesh: Arc<TriangleMesh>,
        /// Its rays' side, for the slots of its triangles.
        accel: Arc<MeshAccel>,
        /// Its box in its own space. Around its middle pictures are laid when it has no coordinates for them.
        bounds: Bounds3,
        /// Whether the normals at the corners count.
        is_smooth: bool,
    },
}

impl Primitive {
    /// The box around a form that has a space of its own, as the tree was told it; None for other forms.
    pub fn outline(&self) -> Option<Bounds3> {
        match &self.form {
            Form::Box { unit } | Form::Ellipsoid { unit } => Some(unit_bounds(unit)),
            Form::Disc { unit, .. } => Some(disc_bounds(unit)),
            Form::Mesh { bounds, .. } => Some(self.transform.bounds(bounds)),
            Form::Sphere { .. } | Form::Plane { .. } | Form::Triangle { .. } => None,
        }
    }

    /// How many materials it has in a row, from the first on.
    pub fn slots(&self) -> usize {
        match &self.form {
            Form::Mesh { mesh, .. } if self.by_triangle => mesh.materials.len() + 1,
            _ => 1,
        }
    }

    /// Whether it is a model without any corner.
    pub fn is_nothing(&self) -> bool {
        matches!(&self.form, Form::Mesh { bounds, .. } if bounds.is_empty())
    }
}

/// All primitives of a scene.
#[derive(Default)]
pub struct Collection {
    pub collected: Primitives,
    pub primitives: Vec<Primitive>,
    pub bounds: Bounds3,
    pub triangles: usize,
    pub models: Models,
}

/// Collects what is seen.
pub fn collect(
    scene: &Scene,
    assets: &Assets,
    table: &mut MaterialTable,
    models: Models,
) -> Result<Collection, CompileError> {
    let mut all = Collection { models, ..Collection::default() };
    let mut placed = all.place(scene, assets, table)?;
    separate(&mut placed, scene.settings.renderer, table, &all.models);
    for one in placed {
        let object = &scene.objects[one.object];
        let Placed { transform, by_triangle, volume, .. } = one;
        let material = one.materials.start;
        let (form, bounds) = all.form(object, one.geometry, &transform)?;
        all.bounds = all.bounds.union(bounds);
        all.collected.materials.push(MaterialSlots { first: material, by_triangle });
        let object = one.object as u32;
        all.primitives.push(Primitive { form, transform, object, material, by_triangle, volume });
    }
    Ok(all)
}

impl Collection {
    /// What is seen, with its shape, its place and its materials.
    fn place(
        &mut self,
        scene: &Scene,
        assets: &Assets,
        table: &mut MaterialTable,
    ) -> Result<Vec<Placed>, CompileError> {
        let mut placed = Vec::new();
        let places = scene.group_places();
        for (index, object) in scene.objects.iter().enumerate().filter(|(_, o)| places.is_seen(o)) {
            let missing = || CompileError::MissingModel { object: object.name.clone() };
            let geometry = object.shape.as_kind().geometry(assets).ok_or_else(missing)?;
            let (materials, by_triangle) = match (&object.material, &geometry) {
                (None, Geometry::Mesh(mesh) | Geometry::Facets(mesh)) if !mesh.materials.is_empty() => {
                    (table.add_slots(mesh, assets)?, true)
                }
                (name, _) => {
                    let material = table.find(&object.name, name.as_deref())?;
                    (material..material + 1, false)
                }
            };
            let bounds = self.box_of(&geometry, object)?;
            let transform = places.world_from_object(object);
            let mut one =
                Placed { object: index, geometry, transform, materials, by_triangle, bounds, volume: 0.0 };
            one.measure();
            placed.push(one);
        }
        Ok(placed)
    }

    /// Adds an object's form to the accelerator's; gives what shading needs and its box.
    fn form(
        &mut self,
        object: &Object,
        geometry: Geometry,
        transform: &Transform,
    ) -> Result<(Form, Bounds3), CompileError> {
        let (form, bounds) = match geometry {
            Geometry::Sphere { radius } => self.sphere(radius, transform),
            Geometry::Box { half } => self.cuboid(half, transform),
            Geometry::Plane => self.plane(transform),
            Geometry::Disc { radius } => self.disc(radius, transform),
            Geometry::Triangle { points, uvs } => self.triangle(points.map(|p| transform.point(p)), uvs),
            Geometry::Mesh(mesh) => self.mesh(object, mesh, true, transform)?,
            Geometry::Facets(mesh) => self.mesh(object, mesh, false, transform)?,
        };
        let (is_near, is_wide) = match &form {
            Form::Plane { point, n } => (is_near_enough(&Bounds3::around([*point])) && n.is_finite(), true),
            Form::Disc { unit, n } => (true, is_wide_enough(unit) && n.is_finite()),
            Form::Box { unit } | Form::Ellipsoid { unit } => (true, is_wide_enough(unit)),
            Form::Mesh { .. } => (is_little_stretched(transform), true),
            Form::Sphere { .. } | Form::Triangle { .. } => (true, true),
        };
        let object = || object.name.clone();
        if !(is_near && (bounds.is_empty() || is_near_enough(&bounds))) {
            return Err(CompileError::OutOfRange { object: object() });
        }
        if !(is_wide && is_wide_enough(transform)) {
            return Err(CompileError::TooThin { object: object() });
        }
        Ok((form, bounds))
    }

    /// The place of the primitive that is being added.
    fn next_id(&self) -> u32 {
        self.primitives.len() as u32
    }

    fn sphere(&mut self, radius: f32, transform: &Transform) -> (Form, Bounds3) {
        let id = self.next_id();
        let Some(scale) = transform.uniform_scale() else {
            let (unit, record, bounds) = unit_form(Vec3::splat(radius), transform, id);
            self.collected.ellipsoids.push((record, bounds));
            return (Form::Ellipsoid { unit }, bounds);
        };
        let (center, radius) = (transform.point(Vec3::ZERO), radius * scale);
        let bounds = Bounds3 { min: center - Vec3::splat(radius), max: center + Vec3::splat(radius) };
        self.collected.spheres.push((Sphere { center: center.into(), radius, primitive: id }, bounds));
        (Form::Sphere { center, radius }, bounds)
    }

    fn cuboid(&mut self, half: Vec3, transform: &Transform) -> (Form, Bounds3) {
        let (unit, record, bounds) = unit_form(half, transform, self.next_id());
        self.collected.boxes.push((record, bounds));
        (Form::Box { unit }, bounds)
    }

    fn plane(&mut self, transform: &Transform) -> (Form, Bounds3) {
        let n = transform.normal(Vec3::Y);
        let point = transform.point(Vec3::ZERO);
        let offset = n.dot(point);
        self.collected.planes.push(Plane { n: n.into(), offset, primitive: self.next_id() });
        (Form::Plane { point, n }, Bounds3::EMPTY)
    }

    fn disc(&mut self, radius: f32, transform: &Transform) -> (Form, Bounds3) {
        let size = Vec3::new(radius, 1.0, radius);
        let unit = transform.after(&Transform::from_place(Vec3::ZERO, Vec3::ZERO, size));
        let (disc, bounds) = (Disc::new(&unit, self.next_id()), disc_bounds(&unit));
        self.collected.discs.push((disc, bounds));
        (Form::Disc { unit, n: disc.n.into() }, bounds)
    }

    fn triangle(&mut self, points: [Vec3; 3], uvs: [[f32; 2]; 3]) -> (Form, Bounds3) {
        let bounds = Bounds3::around(points);
        self.collected.triangles.push((points, self.next_id()));
        self.triangles += 1;
        (Form::Triangle { points, n: unit_normal(points), uvs }, bounds)
    }

    /// The box around a model in its own space; empty for other forms.
    fn box_of(&mut self, geometry: &Geometry, object: &Object) -> Result<Bounds3, CompileError> {
        Ok(match geometry {
            Geometry::Mesh(mesh) | Geometry::Facets(mesh) => self.models.tree(&object.name, mesh)?.bounds(),
            _ => Bounds3::EMPTY,
        })
    }

    fn mesh(
        &mut self,
        object: &Object,
        mesh: Arc<TriangleMesh>,
        is_smooth: bool,
        transform: &Transform,
    ) -> Result<(Form, Bounds3), CompileError> {
        let accel = self.models.tree(&object.name, &mesh)?;
        let own = accel.bounds();
        let bounds = transform.bounds(&own);
        let primitive = self.next_id();
        let instance =
            Instance { mesh_from_world: transform.object_from_world, mesh: accel.clone(), primitive };
        if !bounds.is_empty() {
            self.collected.instances.push((instance, bounds));
        }
        self.triangles += mesh.triangles.len();
        Ok((Form::Mesh { mesh, accel, bounds: own, is_smooth }, bounds))
    }
}

/// A cube or ball of radius 1 stretched to that half size: its space, its record and its box.
fn unit_form(half: Vec3, transform: &Transform, primitive: u32) -> (Transform, Unit, Bounds3) {
    let unit = transform.after(&Transform::from_place(Vec3::ZERO, Vec3::ZERO, half));
    let bounds = unit_bounds(&unit);
    (unit, Unit { unit_from_world: unit.object_from_world, primitive }, bounds)
}

/// The box around the cube from −1 to 1 of a space.
fn unit_bounds(unit: &Transform) -> Bounds3 {
    unit.bounds(&Bounds3 { min: Vec3::NEG_ONE, max: Vec3::ONE })
}

/// The box around the disc y = 0, x² + z² ≤ 1 of a space.
fn disc_bounds(unit: &Transform) -> Bounds3 {
    let m = &unit.world_from_object;
    // No number where the space is stretched too much across the disc, which its box does not show else.
    let center = unit.point(Vec3::ZERO);
    let (x, z) = (m.matrix3.x_axis, m.matrix3.z_axis);
    // x·cos φ + z·sin φ is at most √(x² + z²).
    let reach = Vec3::from_array([0, 1, 2].map(|k| libm::hypotf(x[k], z[k])));
    Bounds3 { min: center - reach, max: center + reach }
}

/// The unit normal of a triangle, counter-clockwise seen from its tip; any unit vector for one without area.
fn unit_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    let (ab, ac) = (b - a, c - a);
    // Scaled first, so that tiny triangles do not underflow.
    let scale = ab.abs().max_element().max(ac.abs().max_element());
    (ab / scale).cross(ac / scale).try_normalize().unwrap_or(Vec3::Y)
}
