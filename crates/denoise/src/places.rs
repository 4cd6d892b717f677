//! Where the library may lie, in the order in which it is looked for.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// The environment variable that names the library's file or folder.
pub const VARIABLE: &str = "VITRINE_OIDN";

/// Names under which the library lies on this system, the surest first.
#[cfg(target_os = "windows")]
const NAMES: &[&str] = &["OpenImageDenoise.dll"];
/// Names under which the library lies on this system, the surest first.
#[cfg(target_os = "macos")]
const NAMES: &[&str] = &["libOpenImageDenoise.2.dylib", "libOpenImageDenoise.dylib"];
/// Names under which the library lies on this system, the surest first.
#[cfg(not(any(target_os = "windows", target_os = "macos")))]
const NAMES: &[&str] = &["libOpenImageDenoise.so.2", "libOpenImageDenoise.so"];

/// How the names with a whole version begin: `libOpenImageDenoise.so.2.5.1`, `libOpenImageDenoise.2.5.1.dylib`.
const VERSIONED: &str =
    if cfg!(target_os = "macos") { "libOpenImageDenoise.2." } else { "libOpenImageDenoise.so.2." };

/// A place to look at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A file or a folder that somebody named.
    Named(PathBuf),
    /// Wherever the system looks for libraries.
    System,
    /// A folder that may hold the library.
    Folder(PathBuf),
}

/// The places to look at. What somebody names is the only place: nothing else is taken in its stead.
pub fn places(setting: Option<&Path>, variable: Option<&OsStr>, program: Option<&Path>) -> Vec<Place> {
    let named = setting.or(variable.map(Path::new)).filter(|path| !path.as_os_str().is_empty());
    if let Some(path) = named {
        return vec![Place::Named(path.into())];
    }
    let mut places = vec![Place::System];
    if let Some(folder) = program.and_then(Path::parent) {
        places.extend([folder.to_path_buf(), folder.join("lib")].map(Place::Folder));
        // As installed programs and their libraries lie: bin/ beside lib/.
        places.extend(folder.parent().map(|above| Place::Folder(above.join("lib"))));
    }
    places
}

impl Place {
    /// The files to try there, the surest first. There is at least one, so that it can be said what was tried.
    pub fn files(&self) -> Vec<PathBuf> {
        match self {
            Self::System => NAMES.iter().map(PathBuf::from).collect(),
            Self::Named(path) if !path.is_dir() => vec![path.clone()],
            // Where the library's archive was unpacked, it lies in a folder below.
            Self::Named(path) => {
                let all: Vec<_> = [path.clone(), path.join("lib"), path.join("bin")]
                    .iter()
                    .flat_map(|f| files_in(f))
                    .collect();
                if all.is_empty() { vec![path.join(NAMES[0])] } else { all }
            }
            Self::Folder(folder) => {
                let all = files_in(folder);
                if all.is_empty() { vec![folder.join(NAMES[0])] } else { all }
            }
        }
    }
}

/// The files of a folder that have the library's name. One with a whole version counts where the others are missing.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let usual: Vec<_> = NAMES.iter().map(|name| folder.join(name)).filter(|path| path.exists()).collect();
    if !usual.is_empty() {
        return usual;
    }
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let names = entries.flatten().filter(|e| e.file_name().to_string_lossy().starts_with(VERSIONED));
    let mut versioned: Vec<_> = names.map(|e| e.path()).collect();
    versioned.sort();
    versioned
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_is_the_only_place() {
        let program = Path::new("/opt/vitrine/bin/vitrine");
        let named = |path: &str| vec![Place::Named(path.into())];
        assert_eq!(places(Some(Path::new("/a")), Some(OsStr::new("/b")), Some(program)), named("/a"));
        assert_eq!(places(None, Some(OsStr::new("/b")), Some(program)), named("/b"));
    }

    #[test]
    fn without_a_name_the_system_comes_first_and_then_the_programs_folders() {
        let program = Path::new("/opt/vitrine/bin/vitrine");
        let folder = |path: &str| Place::Folder(path.into());
        // An empty variable is none.
        assert_eq!(
            places(None, Some(OsStr::new("")), Some(program)),
            [
                Place::System,
                folder("/opt/vitrine/bin"),
                folder("/opt/vitrine/bin/lib"),
                folder("/opt/vitrine/lib")
            ]
        );
        assert_eq!(places(None, None, None), [Place::System]);
    }

    #[test]
    fn a_folder_without_the_library_still_says_which_file_was_wanted() {
        let folder = tempfile::tempdir().unwrap();
        for place in [Place::Named(folder.path().into()), Place::Folder(folder.path().into())] {
            assert_eq!(place.files(), [folder.path().join(NAMES[0])]);
        }
    }

    #[test]
    fn an_unpacked_archive_is_searched_through() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("lib").join(NAMES[0]);
        fs::create_dir(folder.path().join("lib")).unwrap();
        fs::write(&file, "").unwrap();
        assert_eq!(Place::Named(folder.path().into()).files(), [file]);
    }

    #[test]
    #[cfg(not(target_os = "windows"))]
    fn a_name_with_a_whole_version_counts_where_the_usual_ones_are_missing() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let versioned = path(&format!("{VERSIONED}5.1"));
        fs::write(&versioned, "").unwrap();
        fs::write(path("libOpenImageDenoise_core.so.2.5.1"), "").unwrap();
        let place = Place::Folder(folder.path().into());
        assert_eq!(place.files(), [versioned]);
        fs::write(path(NAMES[0]), "").unwrap();
        assert_eq!(place.files(), [path(NAMES[0])]);
    }
}
