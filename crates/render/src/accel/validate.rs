//! Checks of everything that rays walk through: the scene's tree, the trees of its meshes, and what their leaves hold.
//!
//! Compiling needs none of it, for trees are right by construction. Tests and people who look for a fault call it.

use super::primitives::cuboid::Unit;
use super::primitives::disc::Disc;
use super::primitives::sphere::{BLOCK_SPHERES, SphereBlock};
use super::primitives::triangle::{BLOCK_TRIANGLES, TriangleBlock};
use super::tree::{LeafFound, TreeFlaw};
use super::{Accel, MeshAccel, leaf};
use std::collections::BTreeSet;
use std::sync::Arc;
use vitrine_math::{Bounds3, Vec3};

/// What can be wrong with a scene that is ready for rays.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AccelFlaw {
    /// The scene's tree or one of its leaves.
    #[error("the scene's tree: {flaw}")]
    Scene {
        /// What is wrong.
        flaw: TreeFlaw,
    },
    /// The tree of a mesh.
    #[error("the tree of the mesh of primitive {primitive}: {flaw}")]
    Mesh {
        /// The first primitive that shows the mesh.
        primitive: u32,
        /// What is wrong.
        flaw: TreeFlaw,
    },
    /// A primitive that no ray can find, though there is something to be found.
    #[error("no leaf holds primitive {primitive}")]
    Lost {
        /// The primitive.
        primitive: u32,
    },
    /// A plane that is held twice or is no plane.
    #[error("primitive {primitive} is no proper plane, or is held twice")]
    BadPlane {
        /// The primitive.
        primitive: u32,
    },
}

impl From<TreeFlaw> for AccelFlaw {
    fn from(flaw: TreeFlaw) -> Self {
        Self::Scene { flaw }
    }
}

impl Accel {
    /// Checks the scene's tree and those of its meshes: every node is reached once, boxes hold what is below them, each primitive
    /// and each triangle is in one leaf, and all numbers are finite.
    ///
    /// # Errors
    /// The first [`AccelFlaw`] that is found.
    pub fn validate(&self) -> Result<(), AccelFlaw> {
        self.validate_with(&|_| None).map(drop)
    }

    /// The same, and that the box of each form with a space of its own holds the box that `outline` tells of its primitive.
    /// (From the way into that space alone it could not be told exactly.) Gives which primitives are held.
    pub(crate) fn validate_with(
        &self,
        outline: &dyn Fn(u32) -> Option<Bounds3>,
    ) -> Result<Vec<bool>, AccelFlaw> {
        let mut met = Met {
            accel: self,
            outline,
            primitives: vec![false; self.materials.len()],
            places: [
                vec![false; self.spheres.len()],
                vec![false; self.boxes.len()],
                vec![false; self.ellipsoids.len()],
                vec![false; self.triangles.len()],
                vec![false; self.instances.len()],
                vec![false; self.discs.len()],
            ],
        };
        self.tree.validate(&mut |found| met.leaf(found))?;
        let count = met.places.iter().flatten().filter(|met| !**met).count();
        if count > 0 {
            return Err(TreeFlaw::Unreachable { count }.into());
        }
        for plane in &self.planes {
            let primitive = plane.primitive;
            let is_plane = Vec3::from(plane.n).is_normalized() && plane.offset.is_finite();
            if !is_plane || met.primitive(primitive).is_none() {
                return Err(AccelFlaw::BadPlane { primitive });
            }
        }
        let mut meshes = BTreeSet::new();
        for instance in &self.instances {
            if meshes.insert(Arc::as_ptr(&instance.mesh)) {
                let primitive = instance.primitive;
                instance.mesh.validate().map_err(|flaw| AccelFlaw::Mesh { primitive, flaw })?;
            }
        }
        Ok(met.primitives)
    }
}

/// What the leaves of the scene's tree have held so far.
struct Met<'a> {
    accel: &'a Accel,
    outline: &'a dyn Fn(u32) -> Option<Bounds3>,
    primitives: Vec<bool>,
    /// Blocks and forms by kind.
    places: [Vec<bool>; 6],
}

impl Met<'_> {
    /// The box around what a leaf holds, or None when something is wrong with it.
    fn leaf(&mut self, found: LeafFound) -> Option<Bounds3> {
        let LeafFound { kind, first, count } = found;
        let (first, count, accel) = (first as usize, count as usize, self.accel);
        match kind {
            leaf::SPHERE => {
                self.place(kind, first)?;
                let bounds = spheres(&accel.spheres[first], count)?;
                self.all(&accel.spheres[first].primitives[..count])?;
                Some(bounds)
            }
            leaf::TRIANGLE => {
                self.place(kind, first)?;
                let bounds = triangles(&accel.triangles[first], count)?;
                self.all(&accel.triangles[first].ids[..count])?;
                Some(bounds)
            }
            leaf::BOX => self.forms(found, &accel.boxes, unit),
            leaf::ELLIPSOID => self.forms(found, &accel.ellipsoids, unit),
            leaf::MESH => {
                self.forms(found, &accel.instances, |i| (i.primitive, i.mesh_from_world.is_finite()))
            }
            leaf::DISC => self.forms(found, &accel.discs, disc),
            _ => None,
        }
    }

    /// Forms with spaces of their own, each with its primitive and whether its numbers are finite.
    fn forms<T>(
        &mut self,
        LeafFound { kind, first, count }: LeafFound,
        forms: &[T],
        parts: impl Fn(&T) -> (u32, bool),
    ) -> Option<Bounds3> {
        let (first, count, mut all) = (first as usize, count as usize, Bounds3::EMPTY);
        for (place, form) in forms.get(first..first.checked_add(count)?)?.iter().enumerate() {
            let (primitive, is_finite) = parts(form);
            self.place(kind, first + place)?;
            self.primitive(primitive)?;
            if !is_finite {
                return None;
            }
            all = all.union((self.outline)(primitive).unwrap_or(Bounds3::EMPTY));
        }
        Some(all)
    }

    fn place(&mut self, kind: u8, place: usize) -> Option<()> {
        once(&mut self.places[usize::from(kind)], place)
    }

    fn primitive(&mut self, primitive: u32) -> Option<()> {
        once(&mut self.primitives, primitive as usize)
    }

    fn all(&mut self, primitives: &[u32]) -> Option<()> {
        primitives.iter().try_for_each(|id| self.primitive(*id))
    }
}

fn unit(form: &Unit) -> (u32, bool) {
    (form.primitive, form.unit_from_world.is_finite())
}

fn disc(form: &Disc) -> (u32, bool) {
    let [u, v] = form.across.map(Vec3::from);
    let is_finite = Vec3::from(form.center).is_finite() && u.is_finite() && v.is_finite();
    (form.primitive, is_finite && Vec3::from(form.n).is_normalized())
}

/// Notes that something has been met; None when it is not there or was met before.
fn once(seen: &mut [bool], place: usize) -> Option<()> {
    let seen = seen.get_mut(place)?;
    (!std::mem::replace(seen, true)).then_some(())
}

/// The box around the triangles of a block, or None when it does not hold just so many.
fn triangles(block: &TriangleBlock, count: usize) -> Option<Bounds3> {
    let is_full = |place| block.corners_of(place).iter().all(|corner| corner.is_finite());
    let is_empty = |place: usize| {
        block.ids[place] == u32::MAX && block.corners_of(place).iter().all(|c| c.is_nan_mask().all())
    };
    let is_sound = (1..=BLOCK_TRIANGLES).contains(&count)
        && (0..count).all(is_full)
        && (count..BLOCK_TRIANGLES).all(is_empty);
    is_sound.then(|| Bounds3::around((0..count).flat_map(|place| block.corners_of(place))))
}

/// The box around the balls of a block, or None when it does not hold just so many.
fn spheres(block: &SphereBlock, count: usize) -> Option<Bounds3> {
    let center = |place: usize| Vec3::from_array(block.centers.map(|axis| axis[place]));
    let is_full = |place: usize| {
        center(place).is_finite() && block.radii[place].is_finite() && block.radii[place] >= 0.0
    };
    let is_empty = |place: usize| block.primitives[place] == u32::MAX && block.radii[place].is_nan();
    let is_sound = (1..=BLOCK_SPHERES).contains(&count)
        && (0..count).all(is_full)
        && (count..BLOCK_SPHERES).all(is_empty);
    let ends = |place: usize| {
        let radius = Vec3::splat(block.radii[place]);
        [center(place) - radius, center(place) + radius]
    };
    is_sound.then(|| Bounds3::around((0..count).flat_map(ends)))
}

impl MeshAccel {
    /// Checks the tree: every node is reached once, boxes hold what is below them, each of the model's triangles is in one leaf,
    /// and all numbers are finite.
    ///
    /// # Errors
    /// The first [`TreeFlaw`] that is found.
    pub fn validate(&self) -> Result<(), TreeFlaw> {
        let mut blocks = vec![false; self.blocks.len()];
        let mut ids = vec![false; self.triangles];
        self.tree.validate(&mut |found| {
            let (first, count) = (found.first as usize, found.count as usize);
            if found.kind != leaf::TRIANGLE {
                return None;
            }
            once(&mut blocks, first)?;
            let bounds = triangles(&self.blocks[first], count)?;
            self.blocks[first].ids[..count].iter().try_for_each(|id| once(&mut ids, *id as usize))?;
            Some(bounds)
        })?;
        match blocks.iter().chain(&ids).filter(|met| !**met).count() {
            0 => Ok(()),
            count => Err(TreeFlaw::Unreachable { count }),
        }
    }
}

#[cfg(test)]
mod tests;
