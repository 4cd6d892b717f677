//! Who refers to whom by name.

use vitrine::scene::{ListName, Material, Scene};

/// Every place of the scene that names something of that list.
pub(super) fn references(
    scene: &mut Scene,
    list: ListName,
) -> Box<dyn Iterator<Item = &mut Option<String>> + '_> {
    match list {
        ListName::Material => Box::new(scene.objects.iter_mut().map(|o| &mut o.material)),
        ListName::Texture => Box::new(scene.materials.iter_mut().flat_map(Material::textures_mut)),
        ListName::Group => {
            let objects = scene.objects.iter_mut().map(|o| &mut o.group);
            Box::new(objects.chain(scene.groups.iter_mut().map(|g| &mut g.group)))
        }
        ListName::Object | ListName::Light => Box::new(std::iter::empty()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::{Group, Item, KindSpec, Light, Object, ParamKind, ParamSpec, Texture};

    /// How many parameters of an entry refer to each list.
    fn count<T: Item>() -> Vec<(ListName, ListName)> {
        let kinds: &[KindSpec] = T::KINDS.map_or(&[], |(_, kinds)| kinds);
        let specs = T::OWN_SPECS.iter().chain(kinds.iter().flat_map(|k| k.specs));
        let to = |spec: &ParamSpec| match spec.kind {
            ParamKind::Reference(list) => Some((T::LIST, list)),
            _ => None,
        };
        specs.filter_map(to).collect()
    }

    #[test]
    fn no_parameter_that_refers_is_forgotten() {
        let mut declared = [count::<Object>(), count::<Light>(), count::<Material>()].concat();
        declared.extend([count::<Group>(), count::<Texture>()].concat());
        let mut scene = Scene {
            objects: vec![Object::default()],
            lights: vec![Light::default()],
            materials: vec![Material::default()],
            groups: vec![Group::default()],
            textures: vec![Texture::default()],
            ..Scene::default()
        };
        for list in ListName::ALL {
            let known = references(&mut scene, list).count();
            assert_eq!(known, declared.iter().filter(|(_, to)| *to == list).count(), "{}", list.key());
        }
    }
}
