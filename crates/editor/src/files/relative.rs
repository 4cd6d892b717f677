//! Paths as a scene writes them: relative to its folder where they can be, with `/` on every system.

use std::path::{Component, Path, PathBuf};

/// The path of a file as a scene in that folder writes it. A scene without a folder writes whole paths.
#[must_use]
pub fn path_in_scene(file: &Path, folder: Option<&Path>) -> String {
    let whole = plain(file);
    let relative = folder.and_then(|folder| relative(&whole, &plain(folder)));
    let path = relative.unwrap_or(whole);
    let text = path.to_string_lossy().into_owned();
    if cfg!(windows) { text.replace('\\', "/") } else { text }
}

/// The name of a file without its folder, as it is shown; empty when there is none.
#[must_use]
pub fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The way from a folder to a file. None when they have nothing but the root in common.
fn relative(file: &Path, folder: &Path) -> Option<PathBuf> {
    let (to, from): (Vec<_>, Vec<_>) = (file.components().collect(), folder.components().collect());
    let common = to.iter().zip(&from).take_while(|(a, b)| a == b).count();
    let shares_a_folder = to[..common].iter().any(|c| matches!(c, Component::Normal(_)));
    let is_below = common == from.len();
    (shares_a_folder || is_below).then(|| {
        let up = from[common..].iter().map(|_| Component::ParentDir);
        up.chain(to[common..].iter().copied()).collect()
    })
}

/// The whole path without links, `.` and `..`, as far as it exists.
fn plain(path: &Path) -> PathBuf {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    if let Ok(found) = whole.canonicalize() {
        return found;
    }
    match (whole.parent(), whole.file_name()) {
        (Some(parent), Some(name)) => plain(parent).join(name),
        _ => whole,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn below_beside_and_elsewhere() {
        let root = tempfile::tempdir().unwrap();
        let at = |path: &str| root.path().join(path);
        for folder in ["scenes/models", "other"] {
            fs::create_dir_all(at(folder)).unwrap();
        }
        let written = |file: &str| path_in_scene(&at(file), Some(&at("scenes")));
        assert_eq!(written("scenes/models/a.obj"), "models/a.obj");
        assert_eq!(written("scenes/./models/../b.obj"), "b.obj");
        assert_eq!(written("other/c.obj"), "../other/c.obj");
        let whole = path_in_scene(&at("other/c.obj"), None);
        assert!(Path::new(&whole).is_absolute() && whole.ends_with("other/c.obj"), "{whole}");
    }

    #[cfg(unix)]
    #[test]
    fn with_the_root_alone_in_common_the_path_is_whole() {
        assert_eq!(
            path_in_scene(Path::new("/nowhere/a.obj"), Some(Path::new("/elsewhere/b"))),
            "/nowhere/a.obj"
        );
    }

    #[cfg(unix)]
    #[test]
    fn links_do_not_lead_astray() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir_all(root.path().join("real/deep")).unwrap();
        std::os::unix::fs::symlink(root.path().join("real/deep"), root.path().join("link")).unwrap();
        fs::write(root.path().join("real/a.obj"), "").unwrap();
        let written = path_in_scene(&root.path().join("real/a.obj"), Some(&root.path().join("link")));
        assert_eq!(written, "../a.obj", "as the system follows it");
    }
}
