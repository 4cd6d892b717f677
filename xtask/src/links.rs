//! Links in the project's documents to files that are not there.

use crate::root;
use std::fs;
use std::path::PathBuf;

/// Where documents stand, from the folder of the workspace.
const FOLDERS: &[&str] = &["", "assets/fonts", "benches/runs", "docs", "fuzz"];

/// Every link in a document of the project that leads to no file, as a line that names both.
///
/// # Errors
/// When a document cannot be read.
pub fn broken() -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    for document in documents()? {
        let text = fs::read_to_string(&document)
            .map_err(|e| format!("cannot read ({e}): {}", document.display()))?;
        let folder = document.parent().unwrap_or(root());
        let broken = relative_links(&text).filter(|link| !folder.join(link).exists());
        found
            .extend(broken.map(|link| format!("{} links to {link}, which is not there", document.display())));
    }
    Ok(found)
}

/// The documents of the project.
fn documents() -> Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    for folder in FOLDERS.iter().map(|folder| root().join(folder)).filter(|folder| folder.is_dir()) {
        let entries =
            fs::read_dir(&folder).map_err(|e| format!("cannot read ({e}): {}", folder.display()))?;
        let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
        found.extend(paths.filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    found.sort();
    Ok(found)
}

/// The links of a Markdown text to files beside it, without what follows a `#`.
fn relative_links(text: &str) -> impl Iterator<Item = &str> {
    text.split("](")
        .skip(1)
        .filter_map(|after| after.split([')', '#']).next())
        .filter(|link| !link.is_empty() && !link.contains("://"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_found_and_those_to_the_web_left_alone() {
        let text = "See [a](docs/a.md#part), [the web](https://example.org), [below](#more) and ![b](b.jpg).";
        assert_eq!(relative_links(text).collect::<Vec<_>>(), ["docs/a.md", "b.jpg"]);
    }
}
