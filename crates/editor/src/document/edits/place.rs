//! Moving, turning and scaling, in the world's space also inside groups.

use super::Draft;
use super::stand::{Stand, tidy_turn};
use crate::document::{EditError, Thing};
use vitrine::math::{Axis, Mat3, Transform, Vec3, rotation_from_turn, turn_from_rotation};
use vitrine::scene::{ListName, Owner, Scene, Shape, Value};

impl Draft<'_> {
    /// Moves by metres along the world's axes.
    pub(super) fn shift(&mut self, things: &[Thing], by: Vec3) -> Result<(), EditError> {
        self.each_possible(things, |draft, owner, outer| draft.shift_one(owner, outer, by))
    }

    /// Moves one thing, which is in `outer`. False when it has no place.
    pub(super) fn shift_one(&mut self, owner: Owner, outer: &Transform, by: Vec3) -> Result<bool, EditError> {
        let Some(Value::Vector(position)) = self.scene.value(owner, "position") else { return Ok(false) };
        let by_inside = outer.object_from_world.transform_vector3(by);
        self.set_one(owner, "position", Value::Vector(position + by_inside))?;
        if let (Owner::Camera, Some(target)) = (owner, self.scene.camera.look_at) {
            self.set_one(owner, "look_at", Value::Vector(target + by))?;
        }
        Ok(true)
    }

    /// Turns about an axis of the world.
    pub(super) fn turn(&mut self, things: &[Thing], axis: Axis, angle_deg: f32) -> Result<(), EditError> {
        if !angle_deg.is_finite() {
            return Err(EditError::BadNumbers);
        }
        self.each_possible(things, |draft, owner, outer| draft.turn_one(owner, outer, axis, angle_deg))
    }

    fn turn_one(
        &mut self,
        owner: Owner,
        outer: &Transform,
        axis: Axis,
        angle_deg: f32,
    ) -> Result<bool, EditError> {
        let rotation = axis.rotation_deg(angle_deg);
        if owner == Owner::Camera {
            self.scene.camera.turn(axis, angle_deg);
            self.scene.camera.turn_deg = self.scene.camera.turn_deg.map(tidy_turn);
            return Ok(true);
        }
        if let Some(Value::Vector(direction)) = self.scene.value(owner, "direction") {
            self.set_one(owner, "direction", Value::Vector(rotation * direction))?;
            return Ok(true);
        }
        let Some(mut stand) = Stand::of(&self.scene, owner) else { return Ok(false) };
        // The same turn seen from inside the group: G⁻¹·A·G, a rotation as long as the group is scaled evenly.
        let inside = if outer.world_from_object.matrix3 == vitrine::math::Affine3A::IDENTITY.matrix3 {
            rotation
        } else {
            let [to_world, from_world] =
                [outer.world_from_object, outer.object_from_world].map(|m| Mat3::from(m.matrix3));
            upright(from_world * rotation * to_world)
        };
        let pivot = self.pivot(owner, &stand);
        stand.turn_deg = tidy_turn(turn_from_rotation(inside * rotation_from_turn(stand.turn_deg)));
        self.stand_around(owner, stand, pivot).map(|()| true)
    }

    /// Makes so many times larger along its own axes.
    pub(super) fn resize(&mut self, things: &[Thing], by: Vec3) -> Result<(), EditError> {
        if !by.is_finite() || by.to_array().contains(&0.0) {
            return Err(EditError::BadNumbers);
        }
        self.each_possible(things, |draft, owner, _| draft.resize_one(owner, by))
    }

    fn resize_one(&mut self, owner: Owner, by: Vec3) -> Result<bool, EditError> {
        if let (Owner::Item(ListName::Light, _), Some(Value::Number(radius))) =
            (owner, self.scene.value(owner, "radius"))
        {
            // A disc stays round: of uneven factors their mean in area.
            let factor = (by.x * by.z).abs().sqrt();
            self.set_one(owner, "radius", Value::Number(radius * factor))?;
            return Ok(true);
        }
        let Some(mut stand) = Stand::of(&self.scene, owner) else { return Ok(false) };
        let pivot = self.pivot(owner, &stand);
        stand.scale *= by;
        self.stand_around(owner, stand, pivot).map(|()| true)
    }

    /// Does something to each of the outermost things; refused when it is possible with none.
    pub(super) fn each_possible(
        &mut self,
        things: &[Thing],
        mut change: impl FnMut(&mut Self, Owner, &Transform) -> Result<bool, EditError>,
    ) -> Result<(), EditError> {
        let mut is_possible = false;
        for (owner, outer) in self.standing(things)? {
            is_possible |= change(self, owner, &outer)?;
        }
        if is_possible { Ok(()) } else { Err(EditError::NotPossible) }
    }

    /// Where the outermost things are, and the space that each stands in.
    pub(super) fn standing(&self, things: &[Thing]) -> Result<Vec<(Owner, Transform)>, EditError> {
        let owners = self.owners(&self.outermost(things))?;
        let places = self.scene.group_places();
        let outer = |owner| match owner {
            Owner::Item(ListName::Object, i) => self.scene.objects[i].group.as_deref(),
            Owner::Item(ListName::Group, i) => self.scene.groups[i].group.as_deref(),
            _ => None,
        };
        Ok(owners.into_iter().map(|owner| (owner, places.world_from_group(outer(owner)))).collect())
    }

    /// The point of a thing that stays where it is when it is turned or scaled: in its own space, and around that.
    fn pivot(&self, owner: Owner, stand: &Stand) -> [Vec3; 2] {
        let inside = own_pivot(&self.scene, owner);
        [inside, stand.place().point(inside)]
    }

    /// Puts a thing so that its pivot is where it was.
    fn stand_around(&mut self, owner: Owner, mut stand: Stand, pivot: [Vec3; 2]) -> Result<(), EditError> {
        let [inside, outside] = pivot;
        if inside != Vec3::ZERO {
            stand.position += outside - stand.place().point(inside);
        }
        self.put(owner, &stand)
    }

    /// Puts a thing somewhere, with all checks.
    pub(super) fn put(&mut self, owner: Owner, stand: &Stand) -> Result<(), EditError> {
        self.set_one(owner, "position", Value::Vector(stand.position))?;
        self.set_one(owner, "turn_deg", Value::Vector(stand.turn_deg))?;
        self.set_one(owner, "scale", Value::Vector(stand.scale))
    }
}

/// The point about which a thing turns and grows, in its own space: its origin, or a triangle's middle, for its corners may be anywhere.
fn own_pivot(scene: &Scene, owner: Owner) -> Vec3 {
    match owner {
        Owner::Item(ListName::Object, i) => match &scene.objects[i].shape {
            Shape::Triangle(triangle) => triangle.points.iter().sum::<Vec3>() / 3.0,
            _ => Vec3::ZERO,
        },
        _ => Vec3::ZERO,
    }
}

/// The rotation nearest by: what a group that is scaled unevenly makes of a turn is none quite.
fn upright(m: Mat3) -> Mat3 {
    let x = m.x_axis.normalize_or(Vec3::X);
    let y = (m.y_axis - x * x.dot(m.y_axis)).normalize_or(x.any_orthonormal_vector());
    Mat3::from_cols(x, y, x.cross(y))
}
