//! Copies, put a little beside.

use super::Draft;
use super::names::Names;
use crate::document::{Addition, EditError, Selection, Thing, bounds_of};
use std::collections::HashSet;
use vitrine::math::{Transform, Vec3};
use vitrine::scene::{Item, ListName, Owner, Value};

impl Draft<'_> {
    /// Copies things beside themselves and selects the copies.
    pub(super) fn duplicate(&mut self, things: &[Thing]) -> Result<(), EditError> {
        let outermost = self.outermost(things);
        let all: Vec<Thing> = outermost.iter().cloned().chain(self.members(&outermost)).collect();
        let mut copies = Addition::default();
        let mut selected = Vec::new();
        for owner in self.owners(&all)? {
            let scene = &mut self.scene;
            match owner {
                Owner::Item(ListName::Object, i) => copies.objects.push(scene.objects[i].clone()),
                Owner::Item(ListName::Group, i) => copies.groups.push(scene.groups[i].clone()),
                Owner::Item(ListName::Light, i) => copies.lights.push(scene.lights[i].clone()),
                Owner::Item(ListName::Material, i) => {
                    let name = Names::of(scene, ListName::Material).take(&scene.materials[i].name);
                    selected.push(Thing::material(&name));
                    copy_entry(&mut scene.materials, i, name);
                }
                Owner::Item(ListName::Texture, i) => {
                    let name = Names::of(scene, ListName::Texture).take(&scene.textures[i].name);
                    selected.push(Thing::texture(&name));
                    copy_entry(&mut scene.textures, i, name);
                }
                Owner::Camera | Owner::Settings => {}
            }
        }
        if copies != Addition::default() {
            let arrived = self.bring(copies)?;
            self.put_beside(&arrived.outermost)?;
            selected.extend(arrived.outermost);
        }
        if selected.is_empty() {
            return Err(EditError::NotPossible);
        }
        self.selection = Selection::of(selected);
        Ok(())
    }

    /// Moves things to the right until they are beside themselves and not where a copy is already.
    pub(super) fn put_beside(&mut self, things: &[Thing]) -> Result<(), EditError> {
        let bounds = bounds_of(&self.scene, self.assets, things);
        let size = bounds.size();
        let step = if bounds.is_empty() || size.x <= 0.0 { 0.5 } else { size.x + 0.1 * size.max_element() };
        let standing = self.standing(things)?;
        let Some(first) = standing.iter().find_map(|(owner, outer)| self.origin(*owner, outer)) else {
            return Ok(());
        };
        let taken = self.origins();
        let steps = (1..=1000).find(|n| !taken.contains(&millimetres(first + Vec3::X * (step * *n as f32))));
        let by = Vec3::X * (step * steps.unwrap_or(1) as f32);
        for (owner, outer) in standing {
            self.shift_one(owner, &outer, by)?;
        }
        Ok(())
    }

    /// Where something is in the world; None when it is nowhere.
    fn origin(&self, owner: Owner, outer: &Transform) -> Option<Vec3> {
        match self.scene.value(owner, "position")? {
            Value::Vector(position) => Some(outer.point(position)),
            _ => None,
        }
    }

    /// Where all objects, groups and lights are.
    fn origins(&self) -> HashSet<[i64; 3]> {
        let places = self.scene.group_places();
        let objects = self.scene.objects.iter().map(|o| (o.group.as_deref(), o.position));
        let groups = self.scene.groups.iter().map(|g| (g.group.as_deref(), g.position));
        let inside = objects.chain(groups).map(|(g, p)| places.world_from_group(g).point(p));
        let lights = (0..self.scene.lights.len())
            .filter_map(|i| self.origin(Owner::Item(ListName::Light, i), &Transform::default()));
        inside.chain(lights).map(millimetres).collect()
    }
}

fn millimetres(p: Vec3) -> [i64; 3] {
    p.to_array().map(|v| (v * 1000.0).round() as i64)
}

fn copy_entry<T: Item + Clone>(list: &mut Vec<T>, index: usize, name: String) {
    let mut copy = list[index].clone();
    copy.rename(name);
    list.push(copy);
}
