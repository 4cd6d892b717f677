//! How edits are carried out: on a draft of the scene, which becomes the scene when it means something. One file for each
//! family of edits.

mod add;
mod camera;
mod delete;
mod drop_to_floor;
mod duplicate;
mod group;
mod names;
mod paint;
mod place;
mod references;
mod set;
mod stand;

pub(super) use names::Names;
pub(super) use stand::Stand;

use super::thing::Places;
use super::{EditCommand, EditError, Selection, Thing};
use std::collections::{HashMap, HashSet};
use vitrine::scene::{Assets, ListName, Owner, Scene};

/// A scene that is being changed, and what will be selected.
pub(super) struct Draft<'a> {
    pub(super) scene: Scene,
    pub(super) selection: Selection,
    pub(super) assets: &'a Assets,
}

impl Draft<'_> {
    /// Carries an edit out. After an error the draft is of no use.
    pub(super) fn carry_out(&mut self, command: EditCommand) -> Result<(), EditError> {
        match command {
            EditCommand::Set { things, key, value } => self.set(&things, &key, &value),
            EditCommand::SetKind { thing, kind } => self.set_kind(&thing, &kind),
            EditCommand::Rename { thing, name } => self.rename(&thing, &name),
            EditCommand::SetAbout(about) => {
                self.scene.about = about;
                Ok(())
            }
            EditCommand::Add(addition) => self.add(addition),
            EditCommand::Delete(things) => self.delete(&things),
            EditCommand::Duplicate(things) => self.duplicate(&things),
            EditCommand::Paste(text) => self.paste(&text),
            EditCommand::Group(things) => self.group(&things),
            EditCommand::Ungroup(things) => self.ungroup(&things),
            EditCommand::Show { things, visible } => self.show(&things, visible),
            EditCommand::Move { things, by } => self.shift(&things, by),
            EditCommand::Turn { things, axis, angle_deg } => self.turn(&things, axis, angle_deg),
            EditCommand::Resize { things, by } => self.resize(&things, by),
            EditCommand::DropToFloor(things) => self.drop_to_floor(&things),
            EditCommand::Paint { things, material } => self.paint(&things, *material),
            EditCommand::Camera(change) => self.move_camera(change),
            EditCommand::Several(commands) => commands.into_iter().try_for_each(|c| self.carry_out(c)),
        }
    }

    /// Where a thing is.
    fn owner(&self, thing: &Thing) -> Result<Owner, EditError> {
        thing.owner(&self.scene).ok_or(EditError::NoThing)
    }

    /// Where things are; refused when one of them is not there.
    fn owners(&self, things: &[Thing]) -> Result<Vec<Owner>, EditError> {
        let mut places = Places::new(&self.scene);
        things.iter().map(|thing| places.owner(thing).ok_or(EditError::NoThing)).collect()
    }

    /// All that is in the groups among the things, at any depth, without the things themselves.
    fn members(&self, things: &[Thing]) -> Vec<Thing> {
        members_of(&self.scene, things)
    }

    /// The things without those that are in groups among them: what is done to a group, its members go along with.
    fn outermost(&self, things: &[Thing]) -> Vec<Thing> {
        let members: HashSet<Thing> = self.members(things).into_iter().collect();
        things.iter().filter(|thing| !members.contains(thing)).cloned().collect()
    }
}

/// All that is in the groups among the things, at any depth, groups first.
pub(super) fn members_of(scene: &Scene, things: &[Thing]) -> Vec<Thing> {
    let chosen: HashSet<&str> =
        things.iter().filter(|t| t.list() == Some(ListName::Group)).filter_map(Thing::name).collect();
    if chosen.is_empty() {
        return Vec::new();
    }
    let outer: HashMap<&str, Option<&str>> =
        scene.groups.iter().map(|g| (g.name.as_str(), g.group.as_deref())).collect();
    // Whether a group is one of the chosen or inside one, as far as it is known.
    let mut is_inside: HashMap<&str, bool> = HashMap::new();
    let mut look = |start: Option<&str>| -> bool {
        let Some(start) = start.and_then(|name| outer.get_key_value(name)).map(|(name, _)| *name) else {
            return false;
        };
        let (mut way, mut at) = (Vec::new(), Some(start));
        let answer = loop {
            let Some(name) = at else { break false };
            if chosen.contains(name) {
                break true;
            }
            if let Some(known) = is_inside.get(name) {
                break *known;
            }
            // A ring of groups is inside nothing.
            is_inside.insert(name, false);
            way.push(name);
            at = outer.get(name).copied().flatten();
        };
        for name in way {
            is_inside.insert(name, answer);
        }
        answer
    };
    let groups = scene.groups.iter().filter(|g| look(g.group.as_deref())).map(|g| Thing::group(&g.name));
    let mut members: Vec<Thing> = groups.collect();
    members.extend(scene.objects.iter().filter(|o| look(o.group.as_deref())).map(|o| Thing::object(&o.name)));
    members
}

#[cfg(test)]
mod tests;
