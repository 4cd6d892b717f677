//! Deleting: nothing refers to what is gone, and groups take their members along.

use super::Draft;
use super::references::references;
use crate::document::{EditError, Thing};
use std::collections::HashSet;
use vitrine::scene::{Item, ListName};

impl Draft<'_> {
    /// Deletes things. The camera and the settings stay.
    pub(super) fn delete(&mut self, things: &[Thing]) -> Result<(), EditError> {
        self.owners(things)?;
        let members = self.members(things);
        let doomed: HashSet<(ListName, &str)> =
            things.iter().chain(&members).filter_map(|t| Some((t.list()?, t.name()?))).collect();
        if doomed.is_empty() {
            return Err(EditError::NotPossible);
        }
        let scene = &mut self.scene;
        retain(&mut scene.objects, &doomed);
        retain(&mut scene.lights, &doomed);
        retain(&mut scene.materials, &doomed);
        retain(&mut scene.textures, &doomed);
        retain(&mut scene.groups, &doomed);
        for list in ListName::ALL {
            for reference in references(scene, list) {
                if reference.as_deref().is_some_and(|name| doomed.contains(&(list, name))) {
                    *reference = None;
                }
            }
        }
        Ok(())
    }
}

fn retain<T: Item>(items: &mut Vec<T>, doomed: &HashSet<(ListName, &str)>) {
    items.retain(|item| !doomed.contains(&(T::LIST, item.name())));
}
