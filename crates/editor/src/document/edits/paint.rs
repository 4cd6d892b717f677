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
            let object = &mut self.scene.objects[index];
            let former = std::mem::replace(&mut object.material, arrived.materials.first().cloned());
            // What came with the object and was named after it goes with its last use.
            if let Some(former) = former.filter(|name| *name == object.name) {
                self.drop_unused_material(&former);
            }
        }
        Ok(())
    }

    fn drop_unused_material(&mut self, name: &str) {
        if !self.scene.objects.iter().any(|o| o.material.as_deref() == Some(name)) {
            self.scene.materials.retain(|m| m.name != name);
        }
    }
}
