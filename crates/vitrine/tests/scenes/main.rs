//! The example scenes: each is sound, has the counts that its experiment asks for, and shows what the course work reports.

// A test may unwrap, and so may what helps it.
#![allow(clippy::unwrap_used)]

mod benchmark;
mod mirrors;
mod shadows;
mod support;
mod textures;
mod transparency;

use support::{all_scenes, load};
use vitrine::scene::LightSource;

#[test]
fn every_scene_is_read_without_a_word_and_can_be_rendered() {
    let files = all_scenes();
    assert!(files.len() >= 7, "{files:?}");
    for file in files {
        let project = load(&file);
        assert!(project.warnings().is_empty(), "{file}: {:?}", project.warnings());
        assert!(project.asset_warnings().is_empty(), "{file}: {:?}", project.asset_warnings());
        let compiled = vitrine::render::compile(&project.scene, &project.assets).unwrap();
        compiled.validate().unwrap_or_else(|flaw| panic!("{file}: {flaw}"));
    }
}

#[test]
fn every_scene_says_what_it_shows_and_has_a_ground() {
    for file in all_scenes() {
        let project = load(&file);
        let about = &project.scene.about;
        assert!(!about.is_empty() && !about.contains('\n'), "{file}");
        let ground = project.scene.object("ground").unwrap_or_else(|| panic!("{file} has no ground"));
        let place = project.scene.world_from_object(ground);
        assert_eq!((ground.shape.kind(), place.point(vitrine::math::Vec3::ZERO).y), ("plane", 0.0), "{file}");
        let lit = project.scene.lights.iter().any(|l| !matches!(l.source, LightSource::Ambient(_)));
        assert!(lit, "{file} has no lamp");
    }
}

#[test]
fn every_experiment_opens_with_its_schema_and_a_remark() {
    for file in all_scenes().iter().filter(|f| f.starts_with("coursework/")) {
        let text = load(file).checked_text().to_owned();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("#:schema ../../docs/vitrine.schema.json"), "{file}");
        assert!(lines.next().is_some_and(|line| line.starts_with("# ")), "{file}");
    }
}
