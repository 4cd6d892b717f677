//! `PATH=VALUE` arguments: whatever the text, a changed scene that a file can hold, or an error and no change.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use std::sync::LazyLock;
use vitrine_formats::SceneFile;
use vitrine_formats::scene_file::{print_new, set, split_values};
use vitrine_scene::Scene;

static SCENE: LazyLock<Scene> =
    LazyLock::new(|| parse(include_str!("../seeds/scene_file/every-kind.vitrine.toml")));

fn parse(text: &str) -> Scene {
    let file = SceneFile::parse(Path::new("scene.vitrine.toml"), text);
    file.unwrap_or_else(|e| panic!("{:?} in {text}", e.findings)).into_scene()
}

fuzz_target!(|argument: &str| {
    let mut scene = SCENE.clone();
    match set(&mut scene, argument) {
        Ok(()) => assert_eq!(parse(&print_new(&scene)), scene),
        Err(error) => {
            assert_eq!(scene, *SCENE);
            assert!(argument.get(error.span.clone()).is_some(), "{:?} of {argument:?}", error.span);
        }
    }
    if let Ok((path, values)) = split_values(argument) {
        assert!(argument.starts_with(&path) || argument.trim_start().starts_with(&path));
        assert!(values.iter().all(|v| argument.contains(v.as_str())));
    }
});
