//! `cargo xtask docs`: the documents that are made from the code.

use crate::generated::Generated;
use vitrine::formats::scene_file;

/// Every such document.
pub fn files() -> Vec<Generated> {
    vec![
        Generated { path: "docs/scene-file.md", text: scene_file::reference_markdown() },
        Generated { path: "docs/vitrine.schema.json", text: format!("{:#}\n", scene_file::schema()) },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{generated, root};
    use std::fs;
    use std::path::Path;

    #[test]
    fn the_checked_in_documents_are_what_the_code_says() {
        assert_eq!(generated::check("docs", &files()), Ok(()));
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
