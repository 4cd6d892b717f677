//! New things come in: their names become unique, and materials and textures that the scene has already are shared.

use super::Draft;
use super::names::{Names, word_of};
use crate::document::clipboard;
use crate::document::{Addition, EditError, Thing};
use std::collections::HashMap;
use vitrine::scene::{Item, ListName};

/// What has come in, under the names that it has now.
#[derive(Debug, Default)]
pub(super) struct Arrived {
    /// Lights, and groups and objects that are in no group that came with them.
    pub(super) outermost: Vec<Thing>,
    /// Materials in the order in which they were given; some may have been there before.
    pub(super) materials: Vec<String>,
    /// Textures, likewise.
    pub(super) textures: Vec<String>,
}

/// Names as they were given, and what they are in the scene.
type NewNames = HashMap<String, String>;

impl Draft<'_> {
    /// Adds things and selects them.
    pub(super) fn add(&mut self, addition: Addition) -> Result<(), EditError> {
        let arrived = self.bring(addition)?;
        self.select_arrived(arrived);
        Ok(())
    }

    /// Adds what a copied text says: where it was, or beside that when it is there still.
    pub(super) fn paste(&mut self, text: &str) -> Result<(), EditError> {
        let addition = clipboard::read(text)?;
        let objects = addition.objects.iter().map(|o| Thing::object(&o.name));
        let lights = addition.lights.iter().map(|l| Thing::light(&l.name));
        let is_there_still = objects.chain(lights).any(|thing| thing.owner(&self.scene).is_some());
        let arrived = self.bring(addition)?;
        if is_there_still {
            self.put_beside(&arrived.outermost)?;
        }
        self.select_arrived(arrived);
        Ok(())
    }

    fn select_arrived(&mut self, arrived: Arrived) {
        let mut things = arrived.outermost;
        if things.is_empty() {
            things.extend(arrived.materials.into_iter().map(Thing::material));
        }
        if things.is_empty() {
            things.extend(arrived.textures.into_iter().map(Thing::texture));
        }
        self.selection = super::Selection::of(things);
    }

    /// Adds things.
    pub(super) fn bring(&mut self, addition: Addition) -> Result<Arrived, EditError> {
        let Addition { objects, groups, lights, materials, textures } = addition;
        if objects.len() + groups.len() + lights.len() + materials.len() + textures.len() == 0 {
            return Err(EditError::NothingToAdd);
        }
        let mut arrived = Arrived::default();

        let mut names = Names::of(&self.scene, ListName::Texture);
        let to = (&mut self.scene.textures, &mut arrived.textures);
        let new_textures = share(textures, to, &mut names, |_| false);

        let mut names = Names::of(&self.scene, ListName::Material);
        let materials: Vec<_> = materials
            .into_iter()
            .map(|mut material| {
                for texture in material.textures_mut() {
                    follow(texture, &new_textures);
                }
                material
            })
            .collect();
        // A new thing's own material is its own, however much it is like another's.
        let is_own =
            |name: &str| objects.iter().any(|o| o.name == name && o.material.as_deref() == Some(name));
        let to = (&mut self.scene.materials, &mut arrived.materials);
        let new_materials = share(materials, to, &mut names, is_own);

        let mut names = Names::of(&self.scene, ListName::Group);
        let new_groups: NewNames = groups.iter().map(|g| (g.name.clone(), names.take(&g.name))).collect();
        for mut group in groups {
            group.name = new_groups[&group.name].clone();
            if !follow(&mut group.group, &new_groups) {
                arrived.outermost.push(Thing::group(&group.name));
            }
            self.scene.groups.push(group);
        }

        let mut names = Names::of(&self.scene, ListName::Object);
        for mut object in objects {
            object.name = names.take(&object.name);
            follow(&mut object.material, &new_materials);
            if !follow(&mut object.group, &new_groups) {
                arrived.outermost.push(Thing::object(&object.name));
            }
            self.scene.objects.push(object);
        }

        let mut names = Names::of(&self.scene, ListName::Light);
        for mut light in lights {
            light.name = names.take(&light.name);
            arrived.outermost.push(Thing::light(&light.name));
            self.scene.lights.push(light);
        }
        Ok(arrived)
    }
}

/// Lets a reference follow what it means to its new name. False when it means nothing of what has come.
fn follow(reference: &mut Option<String>, new_names: &NewNames) -> bool {
    let new = reference.as_ref().and_then(|name| new_names.get(name));
    let is_known = new.is_some();
    if let Some(new) = new {
        *reference = Some(new.clone());
    }
    is_known
}

/// Adds entries to a list, but those that it has already, alike in all but a number after the name; what is somebody's own is
/// always added.
fn share<T: Item + Clone + PartialEq>(
    items: Vec<T>,
    (list, final_names): (&mut Vec<T>, &mut Vec<String>),
    names: &mut Names,
    is_own: impl Fn(&str) -> bool,
) -> NewNames {
    let mut by_word: HashMap<String, Vec<usize>> = HashMap::new();
    for (index, item) in list.iter().enumerate().filter(|_| !items.is_empty()) {
        by_word.entry(word_of(item.name()).to_owned()).or_default().push(index);
    }
    let mut new_names = NewNames::new();
    for mut item in items {
        let given = item.name().to_owned();
        let candidates = by_word.get(word_of(&given)).filter(|_| !is_own(&given));
        let alike = candidates.into_iter().flatten().find(|index| {
            let there = &list[**index];
            let mut renamed = item.clone();
            renamed.rename(there.name().to_owned());
            renamed == *there
        });
        let name = match alike {
            Some(index) => list[*index].name().to_owned(),
            None => {
                let name = names.take(&given);
                item.rename(name.clone());
                list.push(item);
                name
            }
        };
        final_names.push(name.clone());
        new_names.insert(given, name);
    }
    new_names
}
