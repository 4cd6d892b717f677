//! Files that the program carries: models and pictures of the templates and of the material library.
//!
//! One name means one file wherever it stands, so a scene that names one can be shown before it has been saved, and saving
//! writes what the scene names beside it.

use std::path::Path;
use std::sync::Arc;
use vitrine::formats::{FormatError, image_file, mesh_file};
use vitrine::scene::{Assets, Picture, Scene, TriangleMesh};
use vitrine::templates::TEMPLATES;

macro_rules! texture {
    ($path:literal) => {
        ($path, include_bytes!(concat!("../../../../scenes/", $path)))
    };
}

/// The pictures of the material library that no template is sure to bring.
const TEXTURES: &[(&str, &[u8])] = &[
    texture!("textures/vitrine-wood.png"),
    texture!("textures/vitrine-marble.png"),
    texture!("textures/vitrine-brick.png"),
    texture!("textures/vitrine-paper.png"),
];

/// The bytes of a file that the program carries, by the path as scenes write it. None when it carries no such file.
#[must_use]
pub fn carried(path: &Path) -> Option<&'static [u8]> {
    all().find(|(name, _)| Path::new(name) == path).map(|(_, bytes)| bytes)
}

/// A picture that the program carries. None when it carries no such picture.
#[must_use]
pub fn carried_picture(path: &Path) -> Option<Arc<Picture>> {
    image_file::parse_picture(carried(path)?, path).ok().map(Arc::new)
}

/// A model that the program carries. None when it carries no such model.
#[must_use]
pub fn carried_model(path: &Path) -> Option<Arc<TriangleMesh>> {
    let beside = |name: &str| {
        let library = path.with_file_name(name);
        carried(&library).map(<[u8]>::to_vec).ok_or(FormatError::Missing { path: library })
    };
    let (mesh, _) = mesh_file::obj::parse(carried(path)?, path, &mut |name| beside(name)).ok()?;
    Some(Arc::new(mesh))
}

/// Adds the models and pictures that a scene names, the assets lack and the program carries.
pub fn add_carried(assets: &mut Assets, scene: &Scene) {
    for file in scene.textures.iter().filter_map(|t| t.source.as_kind().file()) {
        if !assets.pictures.contains_key(file)
            && let Some(picture) = carried_picture(file)
        {
            assets.pictures.insert(file.to_owned(), picture);
        }
    }
    for file in scene.objects.iter().filter_map(|o| o.shape.as_kind().file()) {
        if !assets.meshes.contains_key(file)
            && let Some(model) = carried_model(file)
        {
            assets.meshes.insert(file.to_owned(), model);
        }
    }
}

fn all() -> impl Iterator<Item = (&'static str, &'static [u8])> {
    TEXTURES.iter().copied().chain(TEMPLATES.iter().flat_map(|t| t.assets.iter().copied()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_name_means_one_file() {
        for (name, bytes) in all() {
            assert!(carried(Path::new(name)) == Some(bytes), "{name} stands for two files");
        }
        assert_eq!(carried(Path::new("models/none.obj")), None);
    }

    #[test]
    fn what_is_carried_can_be_read() {
        for (name, _) in all() {
            let path = Path::new(name);
            let is_read = match path.extension().and_then(|e| e.to_str()) {
                Some("obj") => carried_model(path).is_some(),
                _ => carried_picture(path).is_some(),
            };
            assert!(is_read, "{name}");
        }
    }

    #[test]
    fn templates_find_all_that_they_name() {
        for template in TEMPLATES {
            let file = vitrine::formats::SceneFile::parse(Path::new(template.name), template.text()).unwrap();
            let mut assets = Assets::default();
            add_carried(&mut assets, file.scene());
            assert!(vitrine::render::compile(file.scene(), &assets).is_ok(), "{}", template.name);
        }
    }
}
