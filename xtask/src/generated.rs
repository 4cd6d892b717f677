//! Files that are made from the code and checked in, so that a fresh clone has them: written anew, or compared.

use crate::root;
use std::fs;

/// A file that a chore makes.
pub struct Generated {
    /// From the folder of the workspace.
    pub path: &'static str,
    /// All of it.
    pub text: String,
}

/// Writes every file.
///
/// # Errors
/// The first file that cannot be written.
pub fn write(files: &[Generated]) -> Result<(), String> {
    for Generated { path, text } in files {
        let whole = root().join(path);
        let folder = whole.parent().unwrap_or(root());
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(&whole, text))
            .map_err(|e| format!("cannot write ({e}): {}", whole.display()))?;
        println!("wrote {path}");
    }
    Ok(())
}

/// Compares every file with what the chore of that name would write.
///
/// # Errors
/// The files that differ or are missing.
pub fn check(chore: &str, files: &[Generated]) -> Result<(), String> {
    // A checkout on Windows may have other line ends.
    let differs = |file: &&Generated| {
        fs::read_to_string(root().join(file.path)).map_or(true, |there| !there.lines().eq(file.text.lines()))
    };
    let others: Vec<&str> = files.iter().filter(differs).map(|file| file.path).collect();
    if others.is_empty() {
        println!("{chore}: every file is what `cargo xtask {chore}` writes");
        Ok(())
    } else {
        Err(format!("run `cargo xtask {chore}`: it would write otherwise {}", others.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_differs_or_is_missing_is_named() {
        let own = Generated { path: "xtask/src/generated.rs", text: include_str!("generated.rs").into() };
        let stale = Generated { path: "xtask/Cargo.toml", text: "otherwise".into() };
        let missing = Generated { path: "xtask/none", text: String::new() };
        let error = check("docs", &[own, stale, missing]).unwrap_err();
        assert_eq!(error, "run `cargo xtask docs`: it would write otherwise xtask/Cargo.toml, xtask/none");
    }
}
