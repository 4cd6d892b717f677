//! Where the scenes are.

use std::path::{Path, PathBuf};
use vitrine::Project;

/// The folder of the example scenes.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

/// Every scene file, by its path in the folder, with `/`.
pub fn all_scenes() -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(inner) = folders.pop() {
        for entry in std::fs::read_dir(folder().join(&inner)).unwrap() {
            let entry = entry.unwrap();
            let path = format!("{inner}{}", entry.file_name().to_string_lossy());
            if entry.file_type().unwrap().is_dir() {
                folders.push(path + "/");
            } else if path.ends_with(".vitrine.toml") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// A scene by its path in the folder.
pub fn load(file: &str) -> Project {
    vitrine::load(folder().join(file)).unwrap_or_else(|e| panic!("{file}: {e}"))
}

/// A scene of the course work by its name.
pub fn coursework(name: &str) -> Project {
    load(&format!("coursework/{name}.vitrine.toml"))
}
