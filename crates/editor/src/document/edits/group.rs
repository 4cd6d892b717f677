//! Groups: things stay where they are in the world when they come into a group or leave it.

use super::names::Names;
use super::{Draft, Stand};
use crate::document::{EditError, Selection, Thing, bounds_of};
use vitrine::math::{Affine3A, Transform, Vec3};
use vitrine::scene::{Group, ListName, Object, Owner, Scene, Shape};

impl Draft<'_> {
    /// Puts objects and groups into a new group, which is selected.
    pub(super) fn group(&mut self, things: &[Thing]) -> Result<(), EditError> {
        let is_member = |t: &Thing| matches!(t.list(), Some(ListName::Object | ListName::Group));
        let things: Vec<Thing> = self.outermost(things).into_iter().filter(is_member).collect();
        let standing = self.standing(&things)?;
        let Some((first, outer)) = standing.first().copied() else { return Err(EditError::NotPossible) };

        // Things of one group get the new group inside it, others one in the world.
        let parent = group_of(&self.scene, first).map(str::to_owned);
        let is_shared = standing.iter().all(|(owner, _)| group_of(&self.scene, *owner) == parent.as_deref());
        let (parent, outer) = if is_shared { (parent, outer) } else { (None, Transform::default()) };
        let center = outer.object_from_world.transform_point3(self.middle(&things, &standing));

        let name = Names::of(&self.scene, ListName::Group).take("group");
        for (owner, its_outer) in standing {
            if !is_shared {
                self.lift(owner, &its_outer.world_from_object)?;
            }
            if let Some(stand) = Stand::of(&self.scene, owner) {
                self.put(owner, &Stand { position: stand.position - center, ..stand })?;
            }
            set_group(&mut self.scene, owner, Some(name.clone()));
        }
        let group = Group { name: name.clone(), position: center, group: parent, ..Group::default() };
        self.scene.groups.push(group);
        self.selection = Selection::of([Thing::group(name)]);
        Ok(())
    }

    /// The middle of things in the world, in numbers that read well.
    fn middle(&self, things: &[Thing], standing: &[(Owner, Transform)]) -> Vec3 {
        let bounds = bounds_of(&self.scene, self.assets, things);
        if !bounds.is_empty() {
            let is_large = bounds.size().max_element() > 0.1;
            let round = |v: f32| if is_large && v.abs() < 1e4 { (v * 1000.0).round() / 1000.0 } else { v };
            return bounds.center().map(round);
        }
        // Nothing but planes.
        let stands = standing.iter().filter_map(|(owner, outer)| {
            Stand::of(&self.scene, *owner).map(|stand| outer.point(stand.position))
        });
        stands.sum::<Vec3>() / standing.len().max(1) as f32
    }

    /// Takes groups apart and selects what was in them.
    pub(super) fn ungroup(&mut self, things: &[Thing]) -> Result<(), EditError> {
        self.owners(things)?;
        let groups = things.iter().filter(|t| t.list() == Some(ListName::Group)).filter_map(Thing::name);
        let names: Vec<&str> = groups.collect();
        if names.is_empty() {
            return Err(EditError::NotPossible);
        }
        let mut released = Vec::new();
        for name in &names {
            let Some(index) = self.scene.groups.iter().position(|g| g.name == *name) else { continue };
            let group = self.scene.groups.remove(index);
            for owner in members_at(&self.scene, name) {
                self.lift(owner, &group.place().world_from_object)?;
                set_group(&mut self.scene, owner, group.group.clone());
                if !group.visible {
                    hide(&mut self.scene, owner);
                }
                released.extend(Thing::at(&self.scene, owner));
            }
        }
        self.selection = Selection::of(released);
        self.selection.keep_what_is_in(&self.scene);
        Ok(())
    }

    /// Tells the stand of a thing in the space around its group. Its corners take up what a triangle's stand cannot say.
    fn lift(&mut self, owner: Owner, outer: &Affine3A) -> Result<(), EditError> {
        let Some(stand) = Stand::of(&self.scene, owner) else { return Ok(()) };
        if let Some(lifted) = stand.out_of(outer) {
            return self.put(owner, &lifted);
        }
        if let Owner::Item(ListName::Object, index) = owner {
            let object = &mut self.scene.objects[index];
            if let Shape::Triangle(triangle) = &mut object.shape {
                let place = *outer * stand.place().world_from_object;
                triangle.points = triangle.points.map(|p| place.transform_point3(p));
                let Object { position, turn_deg, scale, .. } = Object::default();
                return self.put(owner, &Stand { position, turn_deg, scale });
            }
        }
        let name = Thing::at(&self.scene, owner).and_then(|t| t.name().map(str::to_owned));
        Err(EditError::Askew { name: name.unwrap_or_default() })
    }
}

/// What is in a group itself.
fn members_at(scene: &Scene, name: &str) -> Vec<Owner> {
    let is_in = |group: &Option<String>| group.as_deref() == Some(name);
    let groups = scene.groups.iter().enumerate().filter(|(_, g)| is_in(&g.group));
    let groups = groups.map(|(i, _)| Owner::Item(ListName::Group, i));
    let objects = scene.objects.iter().enumerate().filter(|(_, o)| is_in(&o.group));
    groups.chain(objects.map(|(i, _)| Owner::Item(ListName::Object, i))).collect()
}

/// The group that an object or group is in.
fn group_of(scene: &Scene, owner: Owner) -> Option<&str> {
    match owner {
        Owner::Item(ListName::Group, i) => scene.groups[i].group.as_deref(),
        Owner::Item(ListName::Object, i) => scene.objects[i].group.as_deref(),
        _ => None,
    }
}

/// Puts an object or group into a group, or into none.
fn set_group(scene: &mut Scene, owner: Owner, group: Option<String>) {
    match owner {
        Owner::Item(ListName::Group, i) => scene.groups[i].group = group,
        Owner::Item(ListName::Object, i) => scene.objects[i].group = group,
        _ => {}
    }
}

fn hide(scene: &mut Scene, owner: Owner) {
    match owner {
        Owner::Item(ListName::Group, i) => scene.groups[i].visible = false,
        Owner::Item(ListName::Object, i) => scene.objects[i].visible = false,
        _ => {}
    }
}
