//! `cargo xtask docs`: the documents that are made from the code.

use crate::generated::{self, Generated};
use crate::links;
use vitrine::formats::scene_file;

/// Every such document.
pub fn files() -> Vec<Generated> {
    vec![
        Generated { path: "docs/scene-file.md", text: scene_file::reference_markdown() },
        Generated { path: "docs/vitrine.schema.json", text: format!("{:#}\n", scene_file::schema()) },
    ]
}

/// Compares the documents with what the code says, and follows the links of all documents.
///
/// # Errors
/// The documents that differ, or the links that lead to no file.
pub fn check() -> Result<(), String> {
    generated::check("docs", &files())?;
    let broken = links::broken()?;
    if broken.is_empty() { Ok(()) } else { Err(format!("links:\n  {}", broken.join("\n  "))) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::root;
    use std::fs;
    use std::path::Path;

    #[test]
    fn the_checked_in_documents_are_what_the_code_says_and_links_lead_somewhere() {
        assert_eq!(check(), Ok(()));
    }

    /// The text of each block in a fence of that language.
    fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
        let fence = format!("```{language}\n");
        text.split(fence.as_str()).skip(1).filter_map(|after| after.split("```").next()).collect()
    }

    #[test]
    fn the_scene_in_the_readme_is_a_sound_scene() {
        let readme = fs::read_to_string(root().join("README.md")).unwrap();
        let scenes = blocks(&readme, "toml");
        assert!(!scenes.is_empty());
        for scene in scenes {
            let file = scene_file::SceneFile::parse(Path::new("README.md"), scene).unwrap();
            assert!(file.warnings().is_empty());
        }
    }
}
