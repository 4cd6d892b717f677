//! The pictures of materials and of templates, rendered in one go.

use super::carried::{add_carried, carried_picture};
use super::thumbnails::ThumbnailImage;
use crate::document::Paint;
use std::path::Path;
use std::sync::{Arc, OnceLock};
use vitrine::formats::SceneFile;
use vitrine::scene::{Assets, Picture, Renderer, Scene, Settings};
use vitrine::templates::Template;
use vitrine::{Cancel, RenderJob, RenderOptions, display_of};

/// How much care is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Care {
    /// For eyes.
    Fine,
    /// For tests: there at once, and rough.
    Quick,
}

/// A ball of the material. `picture` is the one that its texture names; without it the program's own is looked for.
pub(super) fn of_material(paint: &Paint, picture: Option<Arc<Picture>>) -> Option<ThumbnailImage> {
    let mut scene = sample_scene()?.clone();
    let mut assets = Assets::default();
    if let Some(texture) = &paint.texture {
        if let Some(file) = texture.source.as_kind().file()
            && let Some(picture) = picture.or_else(|| carried_picture(file))
        {
            assets.pictures.insert(file.to_owned(), picture);
        }
        scene.textures.push(vitrine::scene::Texture { name: "sample".into(), ..texture.clone() });
    }
    let mut material = paint.material.clone();
    material.name = "sample".into();
    // The sample's scene has no other textures.
    material.textures_mut().into_iter().for_each(|texture| *texture = None);
    material.texture = paint.texture.as_ref().map(|_| "sample".into());
    scene.materials.push(material);
    scene.objects.iter_mut().filter(|o| o.name == "sample").for_each(|o| o.material = Some("sample".into()));
    render(&scene, &assets)
}

/// What a template shows, small.
pub(super) fn of_template(name: &str, care: Care) -> Option<ThumbnailImage> {
    let template = Template::find(name)?;
    let mut scene = SceneFile::parse(Path::new(name), template.text()).ok()?.into_scene();
    let mut assets = Assets::default();
    add_carried(&mut assets, &scene);
    // A small picture needs no more.
    let (size, samples) = match (care, scene.settings.renderer) {
        (Care::Fine, Renderer::Photoreal) => ([240, 180], 32),
        (Care::Fine, _) => ([240, 180], 3),
        (Care::Quick, _) => ([120, 90], 1),
    };
    scene.settings = Settings {
        size,
        samples,
        depth: scene.settings.depth.min(3),
        shadow_points: scene.settings.shadow_points.min(16),
        noise: 0.0,
        time_limit: 0.0,
        ..scene.settings
    };
    render(&scene, &assets)
}

fn sample_scene() -> Option<&'static Scene> {
    static SCENE: OnceLock<Option<Scene>> = OnceLock::new();
    let read = || SceneFile::parse(Path::new("sample"), include_str!("sample.vitrine.toml")).ok();
    SCENE.get_or_init(|| read().map(SceneFile::into_scene)).as_ref()
}

fn render(scene: &Scene, assets: &Assets) -> Option<ThumbnailImage> {
    let compiled = vitrine::render::compile(scene, assets).ok()?;
    let options = RenderOptions { settings: scene.settings.clone(), region: None };
    // One thread: what a person looks at has the others.
    let rendered = RenderJob::new(&compiled, options).ok()?.run(1, &Cancel::default(), &mut |_| {});
    let display = display_of(&scene.settings);
    Some(ThumbnailImage::of_image(&rendered.film.image(), &display, scene.settings.size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::materials;

    #[test]
    fn every_material_has_a_picture_and_no_two_are_alike() {
        let mut seen: Vec<Vec<u8>> = Vec::new();
        for m in materials() {
            let image = of_material(&m.paint(), None).unwrap_or_else(|| panic!("{}", m.title()));
            assert_eq!((image.size, image.rgba.len()), ([96, 96], 96 * 96 * 4));
            assert!(!seen.contains(&image.rgba), "{}", m.title());
            seen.push(image.rgba);
        }
    }

    #[test]
    fn a_template_has_a_picture_and_an_unknown_one_has_none() {
        assert_eq!(of_template("empty", Care::Fine).unwrap().size, [240, 180]);
        assert_eq!(of_template("none", Care::Quick), None);
    }
}
