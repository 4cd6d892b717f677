//! What is copied is the text of a small scene, so it can be pasted into a scene file by hand and the other way round.

use super::edits::{Stand, members_of};
use super::thing::Places;
use super::{Addition, EditError, Thing};
use std::collections::HashSet;
use std::path::Path;
use vitrine::formats::SceneFile;
use vitrine::formats::scene_file::print_new;
use vitrine::scene::{ListName, Owner, Scene};

/// Things as the text of a scene, with the materials, textures and groups that they need. A thing that is in a group that
/// is not copied stands where it stood in the world. Empty when none of the things can be copied.
#[must_use]
pub fn copy(scene: &Scene, things: &[Thing]) -> String {
    let copied = Copied::of(scene, things).scene();
    if copied == Scene::default() { String::new() } else { print_new(&copied) }
}

/// What a copied text says.
///
/// # Errors
/// [`EditError::NotAScene`] with the line, and [`EditError::NothingToAdd`] when it says nothing.
pub(super) fn read(text: &str) -> Result<Addition, EditError> {
    // A piece of a scene file is welcome without the line that opens a whole one.
    let is_whole = text.lines().any(|line| line.trim_start().starts_with("format"));
    let opening = if is_whole { "" } else { "format = 1\n" };
    let whole = format!("{opening}{text}");
    let file = SceneFile::parse(Path::new("clipboard"), &whole).map_err(|error| {
        let finding = error.findings.into_iter().next();
        let (at, reason, help) = finding.map_or_else(Default::default, |f| (f.span.start, f.message, f.help));
        let before = &whole.as_bytes()[..at.min(whole.len())];
        let line = before.iter().filter(|b| **b == b'\n').count() + 1;
        EditError::NotAScene { line: line.saturating_sub(opening.lines().count()).max(1), reason, help }
    })?;
    let Scene { objects, groups, lights, materials, textures, .. } = file.into_scene();
    let addition = Addition { objects, groups, lights, materials, textures };
    if addition == Addition::default() { Err(EditError::NothingToAdd) } else { Ok(addition) }
}

/// The indices of what is copied.
struct Copied<'a> {
    from: &'a Scene,
    chosen: HashSet<(ListName, usize)>,
}

impl<'a> Copied<'a> {
    /// The things with all that they need.
    fn of(scene: &'a Scene, things: &[Thing]) -> Self {
        let mut places = Places::new(scene);
        let mut chosen = HashSet::new();
        for thing in things.iter().chain(&members_of(scene, things)) {
            if let Some(Owner::Item(list, index)) = places.owner(thing) {
                chosen.insert((list, index));
            }
        }
        let mut copied = Self { from: scene, chosen };
        copied.keep_askew_groups(&mut places);
        let materials =
            scene.objects.iter().enumerate().filter_map(|(i, o)| {
                copied.has(ListName::Object, i).then_some(o.material.as_deref()).flatten()
            });
        let materials: Vec<_> = materials.filter_map(|m| places.index(ListName::Material, m)).collect();
        copied.chosen.extend(materials.into_iter().map(|i| (ListName::Material, i)));
        let materials = scene.materials.iter().enumerate();
        let materials = materials.filter(|(i, _)| copied.has(ListName::Material, *i));
        let textures = materials.flat_map(|(_, m)| m.textures()).filter_map(Option::as_deref);
        let textures: Vec<_> = textures.filter_map(|t| places.index(ListName::Texture, t)).collect();
        copied.chosen.extend(textures.into_iter().map(|i| (ListName::Texture, i)));
        copied
    }

    fn has(&self, list: ListName, index: usize) -> bool {
        self.chosen.contains(&(list, index))
    }

    /// Copies the groups around things that would be askew without them.
    fn keep_askew_groups(&mut self, places: &mut Places) {
        let groups = self.from.group_places();
        let chosen: Vec<_> = self.chosen.iter().copied().collect();
        for (list, index) in chosen {
            let mut at = self.group_of(list, index);
            let around = groups.world_from_group(at).world_from_object;
            let stand = Stand::of(self.from, Owner::Item(list, index));
            if at.is_none() || stand.is_none_or(|stand| stand.out_of(&around).is_some()) {
                continue;
            }
            while let Some(group) = at.and_then(|name| places.index(ListName::Group, name)) {
                if !self.chosen.insert((ListName::Group, group)) {
                    break;
                }
                at = self.group_of(ListName::Group, group);
            }
        }
    }

    fn group_of(&self, list: ListName, index: usize) -> Option<&'a str> {
        match list {
            ListName::Object => self.from.objects[index].group.as_deref(),
            ListName::Group => self.from.groups[index].group.as_deref(),
            _ => None,
        }
    }

    /// A scene of these alone.
    fn scene(&self) -> Scene {
        let kept_groups: HashSet<&str> =
            self.pick(ListName::Group, &self.from.groups).map(|g| g.name.as_str()).collect();
        let places = self.from.group_places();
        let leave = |group: &mut Option<String>, stand: Stand| -> Stand {
            if group.as_deref().is_none_or(|name| kept_groups.contains(name)) {
                return stand;
            }
            let around = places.world_from_group(group.take().as_deref()).world_from_object;
            stand.out_of(&around).unwrap_or(stand)
        };
        let mut scene = Scene {
            lights: self.pick(ListName::Light, &self.from.lights).cloned().collect(),
            textures: self.pick(ListName::Texture, &self.from.textures).cloned().collect(),
            materials: self.pick(ListName::Material, &self.from.materials).cloned().collect(),
            ..Scene::default()
        };
        for mut group in self.pick(ListName::Group, &self.from.groups).cloned() {
            let stand = Stand { position: group.position, turn_deg: group.turn_deg, scale: group.scale };
            let stand = leave(&mut group.group, stand);
            (group.position, group.turn_deg, group.scale) = (stand.position, stand.turn_deg, stand.scale);
            scene.groups.push(group);
        }
        for mut object in self.pick(ListName::Object, &self.from.objects).cloned() {
            let stand = Stand { position: object.position, turn_deg: object.turn_deg, scale: object.scale };
            let stand = leave(&mut object.group, stand);
            (object.position, object.turn_deg, object.scale) = (stand.position, stand.turn_deg, stand.scale);
            scene.objects.push(object);
        }
        scene
    }

    fn pick<'s, T>(&'s self, list: ListName, items: &'a [T]) -> impl Iterator<Item = &'a T> + use<'s, 'a, T> {
        let chosen = items.iter().enumerate().filter(move |(index, _)| self.has(list, *index));
        chosen.map(|(_, item)| item)
    }
}
