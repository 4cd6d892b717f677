//! Laying a picture over objects.

use super::{Paint, Thing};
use std::path::Path;
use vitrine::scene::textures::PictureFile;
use vitrine::scene::{Material, Scene, Texture, TextureSource};

/// The material of the first of the objects with a picture in place of its colour; a new one where it has none. `file` is the
/// picture's path as the scene writes it.
#[must_use]
pub fn cover(scene: &Scene, things: &[Thing], file: &str) -> Paint {
    let object = things.iter().find_map(|thing| scene.object(thing.name()?));
    let name =
        Path::new(file).file_stem().map_or_else(|| file.to_owned(), |s| s.to_string_lossy().into_owned());
    let known = object.and_then(|o| scene.material(o.material.as_deref()?)).cloned();
    let material = known.unwrap_or_else(|| Material { name: name.clone(), ..Material::default() });
    let source = TextureSource::Picture(PictureFile { file: file.to_owned(), ..PictureFile::default() });
    let texture = Texture { name: name.clone(), source, ..Texture::default() };
    Paint { material: Material { texture: Some(name), ..material }, texture: Some(texture) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::Object;

    #[test]
    fn the_object_keeps_its_material_but_for_the_picture() {
        let glass = Material { name: "glass".into(), transparency: Some(0.5), ..Material::default() };
        let ball = Object { name: "ball".into(), material: Some("glass".into()), ..Object::default() };
        let scene = Scene { materials: vec![glass], objects: vec![ball], ..Scene::default() };
        let paint = cover(&scene, &[Thing::object("ball")], "pictures/sky.png");
        assert_eq!(
            (paint.material.transparency, paint.material.texture.as_deref()),
            (Some(0.5), Some("sky"))
        );
        let file = paint.texture.and_then(|t| t.source.as_kind().file().map(Path::to_owned));
        assert_eq!(file.as_deref(), Some(Path::new("pictures/sky.png")));
    }
}
