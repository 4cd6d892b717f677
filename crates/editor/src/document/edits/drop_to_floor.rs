//! Setting things down on the floor or on whatever lies below them.

use super::Draft;
use crate::document::bounds::{is_apart, object_bounds, plane_level};
use crate::document::{EditError, Thing, bounds_of};
use std::collections::{HashMap, HashSet};
use std::ops::RangeInclusive;
use vitrine::math::{Bounds3, Transform, Vec3};
use vitrine::scene::{ListName, Owner};

/// How deep two things that stand on one another may be in one another by rounding, as a part of their size.
const SLACK: f32 = 1e-4;

impl Draft<'_> {
    /// Sets objects and groups down, the lowest first, so that a pile stays a pile.
    pub(super) fn drop_to_floor(&mut self, things: &[Thing]) -> Result<(), EditError> {
        let things = self.outermost(things);
        let standing = self.standing(&things)?;
        let places = self.scene.group_places();
        let bounds = |thing: &Thing, owner: Owner| match owner {
            Owner::Item(ListName::Object, i) => {
                let object = &self.scene.objects[i];
                object_bounds(object, &places.world_from_object(object), self.assets)
            }
            Owner::Item(ListName::Group, _) => {
                bounds_of(&self.scene, self.assets, std::slice::from_ref(thing))
            }
            _ => Bounds3::EMPTY,
        };
        let mut falling: Vec<(Owner, Transform, Bounds3)> = std::iter::zip(&things, standing)
            .map(|(thing, (owner, outer))| (owner, outer, bounds(thing, owner)))
            .filter(|(.., bounds)| !bounds.is_empty())
            .collect();
        if falling.is_empty() {
            return Err(EditError::NotPossible);
        }
        falling.sort_by(|a, b| a.2.min.y.total_cmp(&b.2.min.y));
        let widths = falling.iter().map(|(.., bounds)| bounds.size().x.max(bounds.size().z));
        let mut ground = self.ground(&things, widths.sum::<f32>() / falling.len() as f32);
        for (owner, outer, bounds) in falling {
            let by = Vec3::new(0.0, ground.below(&bounds) - bounds.min.y, 0.0);
            self.shift_one(owner, &outer, by)?;
            ground.add(Bounds3 { min: bounds.min + by, max: bounds.max + by });
        }
        Ok(())
    }

    /// Everything that is seen and does not fall.
    fn ground(&self, falling: &[Thing], square: f32) -> Ground {
        let falling: HashSet<Thing> = falling.iter().cloned().chain(self.members(falling)).collect();
        let places = self.scene.group_places();
        let mut ground = Ground::new(square);
        for object in &self.scene.objects {
            if !places.is_seen(object) || falling.contains(&Thing::object(&object.name)) {
                continue;
            }
            let place = places.world_from_object(object);
            ground.levels.extend(plane_level(object, &place));
            let bounds = object_bounds(object, &place, self.assets);
            if !bounds.is_empty() {
                ground.add(bounds);
            }
        }
        ground
    }
}

/// What things can stand on. The bodies stand in a grid of squares seen from above, so that each falling thing is held only
/// against those near it.
struct Ground {
    /// The heights of level planes.
    levels: Vec<f32>,
    bodies: Vec<Bounds3>,
    /// The edge of a square, metres.
    square: f32,
    /// The bodies over each square, by index.
    squares: HashMap<[i64; 2], Vec<usize>>,
    /// Those over too many squares.
    wide: Vec<usize>,
}

/// Over more squares than this a body is wide.
const MOST_SQUARES: i64 = 64;

impl Ground {
    fn new(square: f32) -> Self {
        let square = if square.is_finite() && square > 0.0 { square } else { 1.0 };
        Self { levels: Vec::new(), bodies: Vec::new(), square, squares: HashMap::new(), wide: Vec::new() }
    }

    fn add(&mut self, body: Bounds3) {
        let index = self.bodies.len();
        self.bodies.push(body);
        match self.squares_under(&body) {
            Some(squares) => squares.for_each(|at| self.squares.entry(at).or_default().push(index)),
            None => self.wide.push(index),
        }
    }

    /// The squares under a box; None when they are too many.
    fn squares_under(&self, bounds: &Bounds3) -> Option<impl Iterator<Item = [i64; 2]> + use<>> {
        let at = |v: f32| (v / self.square).floor() as i64;
        let (x, z) = (at(bounds.min.x)..=at(bounds.max.x), at(bounds.min.z)..=at(bounds.max.z));
        let count = |r: &RangeInclusive<i64>| r.end().saturating_sub(*r.start()).saturating_add(1);
        let is_few = count(&x).saturating_mul(count(&z)) <= MOST_SQUARES;
        is_few.then(|| x.flat_map(move |x| z.clone().map(move |z| [x, z])))
    }

    /// The bodies whose squares a box has a part in, some perhaps twice.
    fn near(&self, bounds: &Bounds3) -> Box<dyn Iterator<Item = &Bounds3> + '_> {
        match self.squares_under(bounds) {
            Some(squares) => {
                let close = squares.filter_map(|at| self.squares.get(&at)).flatten();
                Box::new(close.chain(&self.wide).map(|index| &self.bodies[*index]))
            }
            None => Box::new(self.bodies.iter()),
        }
    }

    /// The height of the highest thing below something. What is sunk less than half is lifted out.
    fn below(&self, bounds: &Bounds3) -> f32 {
        let slack = SLACK * bounds.size().max_element();
        let planes = self.levels.iter().copied().filter(|level| *level <= bounds.max.y + slack);
        let tops = self.near(bounds).filter(|body| {
            let inner = Bounds3 {
                min: Vec3::new(body.min.x + slack, body.min.y, body.min.z + slack),
                max: Vec3::new(body.max.x - slack, body.max.y, body.max.z - slack),
            };
            body.max.y <= bounds.center().y + slack && !is_apart(&inner, bounds, [0, 2])
        });
        planes.chain(tops.map(|body| body.max.y)).reduce(f32::max).unwrap_or(0.0)
    }
}
