//! The scenes of glass: each says what it shows, is photoreal, and gives a picture of numbers alone.

use crate::support::{all_scenes, at, load, picture};
use vitrine::math::Vec3;
use vitrine::scene::Renderer;

fn glass_scenes() -> Vec<String> {
    all_scenes().into_iter().filter(|file| file.starts_with("glass/")).collect()
}

#[test]
fn every_glass_scene_opens_with_its_schema_and_a_remark() {
    for file in glass_scenes() {
        let text = load(&file).checked_text().to_owned();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("#:schema ../../docs/vitrine.schema.json"), "{file}");
        assert!(lines.next().is_some_and(|line| line.starts_with("# ")), "{file}");
    }
}

#[test]
fn every_glass_scene_gives_a_photoreal_picture_without_a_bad_sample() {
    let files = glass_scenes();
    assert!(files.len() >= 12, "{files:?}");
    for file in files {
        let mut project = load(&file);
        assert!(project.warnings().is_empty(), "{file}: {:?}", project.warnings());
        assert_eq!(project.scene.settings.renderer, Renderer::Photoreal, "{file}");
        project.set(&["settings.size=[16,12]", "settings.samples=2"]).unwrap();
        let rendered = vitrine::render(&project, 1).unwrap();
        assert!(rendered.is_complete(), "{file}");
        assert_eq!(rendered.bad_samples, 0, "{file}");
        let image = rendered.film.image();
        assert!(image.pixels.iter().any(|c| c.r + c.g + c.b > 0.05), "{file} is black");
    }
}

/// What is infinitely far once had such large coordinates that a pane near the lit point was taken for the point's own surface.
#[test]
fn the_sun_shines_through_a_window_pane() {
    let project = load("glass/window-pane.vitrine.toml");
    let floor = Vec3::new(-0.6, 0.0, -0.3);
    let [with, without] = ["true", "false"].map(|visible| {
        let pane = format!("object.pane.visible={visible}");
        let changes = ["settings.size=[80,60]", "settings.samples=16", "settings.bounces=3", &pane];
        at(&project, &picture(&project, &changes), floor).luminance()
    });
    // Two surfaces of glass, met at 40° from their normal, let nine tenths pass.
    let share = with / without;
    assert!((0.75..1.0).contains(&share), "{with} of {without}");
}
