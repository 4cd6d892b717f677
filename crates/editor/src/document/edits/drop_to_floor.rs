//! Setting things down on the floor or on whatever lies below them.

use super::Draft;
use crate::document::bounds::{is_apart, object_bounds, plane_level};
use crate::document::{EditError, Thing, bounds_of};
use std::collections::HashSet;
use vitrine::math::{Bounds3, Transform, Vec3};
use vitrine::scene::{ListName, Owner};

/// How deep two things that stand on one another may be in one another by rounding, as a part of their size.
const SLACK: f32 = 1e-4;

impl Draft<'_> {
    /// Sets objects and groups down, the lowest first, so that a pile stays a pile.
    pub(super) fn drop_to_floor(&mut self, things: &[Thing]) -> Result<(), EditError> {
        let things = self.outermost(things);
        let standing = self.standing(&things)?;
        let mut falling: Vec<(Owner, Transform, Bounds3)> = std::iter::zip(&things, standing)
            .filter(|(_, (owner, _))| matches!(owner, Owner::Item(ListName::Object | ListName::Group, _)))
            .map(|(thing, (owner, outer))| {
                (owner, outer, bounds_of(&self.scene, self.assets, std::slice::from_ref(thing)))
            })
            .filter(|(.., bounds)| !bounds.is_empty())
            .collect();
        if falling.is_empty() {
            return Err(EditError::NotPossible);
        }
        falling.sort_by(|a, b| a.2.min.y.total_cmp(&b.2.min.y));
        let mut ground = self.ground(&things);
        for (owner, outer, bounds) in falling {
            let by = Vec3::new(0.0, ground.below(&bounds) - bounds.min.y, 0.0);
            self.shift_one(owner, &outer, by)?;
            ground.bodies.push(Bounds3 { min: bounds.min + by, max: bounds.max + by });
        }
        Ok(())
    }

    /// Everything that is seen and does not fall.
    fn ground(&self, falling: &[Thing]) -> Ground {
        let falling: HashSet<Thing> = falling.iter().cloned().chain(self.members(falling)).collect();
        let places = self.scene.group_places();
        let mut ground = Ground { levels: Vec::new(), bodies: Vec::new() };
        for object in &self.scene.objects {
            if !places.is_seen(object) || falling.contains(&Thing::object(&object.name)) {
                continue;
            }
            let place = places.world_from_object(object);
            ground.levels.extend(plane_level(object, &place));
            let bounds = object_bounds(object, &place, self.assets);
            if !bounds.is_empty() {
                ground.bodies.push(bounds);
            }
        }
        ground
    }
}

/// What things can stand on.
struct Ground {
    /// The heights of level planes.
    levels: Vec<f32>,
    bodies: Vec<Bounds3>,
}

impl Ground {
    /// The height of the highest thing below something. What is sunk less than half is lifted out.
    fn below(&self, bounds: &Bounds3) -> f32 {
        let slack = SLACK * bounds.size().max_element();
        let planes = self.levels.iter().copied().filter(|level| *level <= bounds.max.y + slack);
        let tops = self.bodies.iter().filter(|body| {
            let inner = Bounds3 {
                min: Vec3::new(body.min.x + slack, body.min.y, body.min.z + slack),
                max: Vec3::new(body.max.x - slack, body.max.y, body.max.z - slack),
            };
            body.max.y <= bounds.center().y + slack && !is_apart(&inner, bounds, [0, 2])
        });
        planes.chain(tops.map(|body| body.max.y)).reduce(f32::max).unwrap_or(0.0)
    }
}
