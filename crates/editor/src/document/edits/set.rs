//! Values, kinds, names, the line about the scene, showing and hiding.

use super::Draft;
use super::references::references;
use crate::document::{EditError, Thing};
use vitrine::scene::{Item, ListName, Owner, Scene, Value};

impl Draft<'_> {
    /// Sets a parameter of those things that have it; refused when none has.
    pub(super) fn set(&mut self, things: &[Thing], key: &str, value: &Value) -> Result<(), EditError> {
        let owners = self.owners(things)?;
        let first = *owners.first().ok_or(EditError::NotPossible)?;
        let mut having: Vec<Owner> =
            owners.into_iter().filter(|owner| self.scene.value(*owner, key).is_some()).collect();
        if having.is_empty() {
            having.push(first);
        }
        for owner in having {
            self.set_one(owner, key, value.clone())?;
        }
        Ok(())
    }

    /// Sets one parameter, with all checks.
    pub(super) fn set_one(&mut self, owner: Owner, key: &str, value: Value) -> Result<(), EditError> {
        self.scene.set(owner, key, value).map_err(|error| {
            let kind = self.scene.specs(owner).into_iter().find(|s| s.name == key).map(|s| s.kind);
            EditError::Param { error, kind }
        })
    }

    /// Shows or hides whatever can be.
    pub(super) fn show(&mut self, things: &[Thing], visible: bool) -> Result<(), EditError> {
        let key = "visible";
        let able = self.owners(things)?.into_iter().filter(|o| self.scene.value(*o, key).is_some());
        let able: Vec<_> = able.collect();
        if able.is_empty() {
            return Err(EditError::NotPossible);
        }
        able.into_iter().try_for_each(|owner| self.set_one(owner, key, Value::Flag(visible)))
    }

    /// Makes a thing another kind; values of both kinds stay.
    pub(super) fn set_kind(&mut self, thing: &Thing, word: &str) -> Result<(), EditError> {
        match self.owner(thing)? {
            Owner::Item(ListName::Object, i) => change_kind(&mut self.scene.objects[i], word),
            Owner::Item(ListName::Light, i) => change_kind(&mut self.scene.lights[i], word),
            Owner::Item(ListName::Texture, i) => change_kind(&mut self.scene.textures[i], word),
            _ => Err(EditError::NotPossible),
        }
    }

    /// Gives a thing another name; whatever refers to it follows.
    pub(super) fn rename(&mut self, thing: &Thing, name: &str) -> Result<(), EditError> {
        let owner = self.owner(thing)?;
        let (Owner::Item(list, index), Some(old)) = (owner, thing.name()) else {
            return Err(EditError::NotPossible);
        };
        let name = name.trim();
        if name == old {
            return Ok(());
        }
        if name.is_empty() {
            return Err(EditError::EmptyName);
        }
        if self.scene.names(list).any(|n| n == name) {
            return Err(EditError::NameTaken { name: name.to_owned() });
        }
        rename_entry(&mut self.scene, list, index, name);
        for reference in references(&mut self.scene, list).filter(|r| r.as_deref() == Some(old)) {
            *reference = Some(name.to_owned());
        }
        self.selection.rename(thing, &Thing::Item(list, name.to_owned()));
        Ok(())
    }
}

fn change_kind<T: Item>(item: &mut T, word: &str) -> Result<(), EditError> {
    if item.kind().is_some_and(|(_, now)| now == word) {
        return Ok(());
    }
    let values: Vec<(&str, Value)> = item.kind_params().map_or_else(Vec::new, |old| {
        old.specs().iter().filter_map(|s| Some((s.name, old.get(s.name)?))).collect()
    });
    if !item.set_kind(word) {
        return Err(EditError::NoKind { word: word.to_owned() });
    }
    let Some(new) = item.kind_params_mut() else { return Ok(()) };
    for (key, value) in values {
        // Kinds may use one word for different things: what does not fit keeps its default.
        if new.specs().iter().any(|spec| spec.name == key && spec.check(&value).is_ok()) {
            new.store(key, value);
        }
    }
    Ok(())
}

fn rename_entry(scene: &mut Scene, list: ListName, index: usize, name: &str) {
    let name = name.to_owned();
    match list {
        ListName::Object => scene.objects[index].rename(name),
        ListName::Light => scene.lights[index].rename(name),
        ListName::Material => scene.materials[index].rename(name),
        ListName::Texture => scene.textures[index].rename(name),
        ListName::Group => scene.groups[index].rename(name),
    }
}
