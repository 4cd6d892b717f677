//! Scene files: whatever the text, a scene or mistakes at places within it; what is printed reads as the same scene.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::SceneFile;
use vitrine_formats::scene_file::print_new;

fuzz_target!(|text: &str| {
    let path = Path::new("scene.vitrine.toml");
    match SceneFile::parse(path, text) {
        Ok(file) => {
            assert_eq!(file.print(file.scene()), text, "a file without a change stays as it is");
            let printed = print_new(file.scene());
            let again = SceneFile::parse(path, &printed).expect("what is printed can be read");
            assert_eq!(again.scene(), file.scene());
        }
        Err(error) => {
            assert!(!error.findings.is_empty());
            for finding in &error.findings {
                assert!(text.get(finding.span.clone()).is_some(), "{:?} of {text:?}", finding.span);
            }
        }
    }
});
