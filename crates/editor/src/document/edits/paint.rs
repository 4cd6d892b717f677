//! Making objects of a material.

use super::Draft;
use crate::document::{Addition, EditError, Paint, Thing};
use vitrine::scene::{ListName, Owner};

impl Draft<'_> {
    /// Makes objects, and those in groups, of a material.
    pub(super) fn paint(&mut self, things: &[Thing], paint: Paint) -> Result<(), EditError> {
        let things: Vec<Thing> = things.iter().cloned().chain(self.members(things)).collect();
        let owners = self.owners(&things)?;
        let objects: Vec<usize> = owners
            .into_iter()
            .filter_map(|owner| match owner {
                Owner::Item(ListName::Object, index) => Some(index),
                _ => None,
            })
            .collect();
        if objects.is_empty() {
            return Err(EditError::NotPossible);
        }
        let materials = vec![paint.material];
        let textures = paint.texture.into_iter().collect();
        let arrived = self.bring(Addition { materials, textures, ..Addition::default() })?;
        for index in objects {
            self.scene.objects[index].material = arrived.materials.first().cloned();
        }
        Ok(())
    }
}
