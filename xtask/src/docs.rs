//! `cargo xtask docs`: the documents that are made from the descriptions of the scene's parameters.

use std::fs;
use vitrine::formats::scene_file::{reference_markdown, schema};

/// The documents: the path in the workspace and the text.
fn documents() -> [(&'static str, String); 2] {
    [("docs/scene-file.md", reference_markdown()), ("docs/vitrine.schema.json", format!("{:#}\n", schema()))]
}

/// Writes the documents anew.
///
/// # Errors
/// Which one cannot be written.
pub fn write() -> Result<(), String> {
    for (path, text) in documents() {
        let file = crate::root().join(path);
        if fs::read_to_string(&file).is_ok_and(|old| old == text) {
            println!("docs: {path} is up to date");
            continue;
        }
        file.parent()
            .map_or(Ok(()), fs::create_dir_all)
            .and_then(|()| fs::write(&file, text))
            .map_err(|e| format!("cannot write, {e}: {path}"))?;
        println!("docs: wrote {path}");
    }
    Ok(())
}

/// Whether the documents say what the code does.
///
/// # Errors
/// Which one does not.
pub fn check() -> Result<(), String> {
    for (path, text) in documents() {
        let old = fs::read_to_string(crate::root().join(path)).unwrap_or_default();
        // A checkout on Windows may have other line ends.
        if !old.lines().eq(text.lines()) {
            return Err(format!("out of date, run `cargo xtask docs`: {path}"));
        }
    }
    println!("docs: up to date");
    Ok(())
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_documents_say_what_the_code_does() {
        super::check().unwrap();
    }
}
