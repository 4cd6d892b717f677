//! Writing files so that a failure leaves what was there.

use crate::FormatError;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// Writes a file: all of it or nothing. The bytes go to a temporary file in the same folder, which then takes the place of
/// what was there. The file has the permissions of the one that it replaces, else those of any new file. A
/// symbolic link stays one; a device or pipe is written as it is.
///
/// # Errors
/// [`FormatError::MissingFolder`], [`FormatError::NotAFile`], [`FormatError::DiscFull`], [`FormatError::Unwritable`]. Then
/// what was there is unchanged and nothing is left behind.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), FormatError> {
    let failed = |cause: io::Error| failed(path, cause);
    let there = match fs::metadata(path) {
        Ok(meta) => Some(meta),
        Err(cause) if cause.kind() == io::ErrorKind::NotFound => None,
        Err(cause) => return Err(failed(cause)),
    };
    let Some(meta) = there else {
        return check_folder(path).and_then(|()| replace(path, bytes, None).map_err(failed));
    };
    if meta.is_dir() {
        return Err(FormatError::NotAFile { path: path.into(), what: "a folder" });
    }
    if !meta.is_file() {
        let write = |mut file: File| file.write_all(bytes);
        return OpenOptions::new().write(true).open(path).and_then(write).map_err(failed);
    }
    if meta.permissions().readonly() {
        return Err(failed(io::Error::new(io::ErrorKind::PermissionDenied, "it is write-protected")));
    }
    // The file itself where the path is a symbolic link to it.
    let target = fs::canonicalize(path).map_err(failed)?;
    replace(&target, bytes, Some(meta.permissions())).map_err(failed)
}

/// The same by way of a temporary file with a name of its own, for a file that is written again and again by a program that may be
/// killed: what such a one leaves is replaced by the next.
///
/// # Errors
/// As [`write_atomically`].
pub fn write_through(part: &Path, path: &Path, bytes: &[u8]) -> Result<(), FormatError> {
    check_folder(path)?;
    let write = || {
        let mut file = File::create(part)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(part, path)
    };
    write().map_err(|cause| {
        // The cause counts, not whether the part could be removed.
        let _ = fs::remove_file(part);
        failed(path, cause)
    })
}

/// Why the file could not be written.
fn failed(path: &Path, cause: io::Error) -> FormatError {
    match cause.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            FormatError::DiscFull { path: path.into() }
        }
        _ => FormatError::Unwritable { path: path.into(), cause },
    }
}

/// That the folder for a new file exists.
fn check_folder(path: &Path) -> Result<(), FormatError> {
    let folder = folder_of(path);
    if folder.is_dir() { Ok(()) } else { Err(FormatError::MissingFolder { folder: folder.into() }) }
}

/// The folder that a file stands in; `.` where the path does not tell.
#[must_use]
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn replace(path: &Path, bytes: &[u8], permissions: Option<fs::Permissions>) -> io::Result<()> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrine-").suffix(".part");
    // By itself the temporary file would be for its owner's eyes only; the system takes the umask off this.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The error itself would name the temporary file.
    let mut file = builder.tempfile_in(folder_of(path)).map_err(|e| io::Error::from(e.kind()))?;
    file.write_all(bytes)?;
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    // Before the name leads to it, its content must be on the disc.
    file.as_file().sync_all()?;
    file.persist(path)?;
    // The new name too. Where folders cannot be synced, the file is written all the same.
    #[cfg(unix)]
    if let Ok(folder) = File::open(folder_of(path)) {
        let _ = folder.sync_all();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn writes_and_replaces_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        for bytes in [&b"first"[..], b"second, longer", b""] {
            write_atomically(&path, bytes).unwrap();
            assert_eq!(fs::read(&path).unwrap(), bytes);
        }
        assert_eq!(names_in(folder.path()), ["a.png"]);
    }

    #[test]
    fn what_a_killed_program_left_is_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let [path, part] = ["a", "a.part"].map(|name| folder.path().join(name));
        fs::write(&part, "half of a longer text").unwrap();
        for bytes in [&b"first"[..], b"second"] {
            write_through(&part, &path, bytes).unwrap();
            assert_eq!(fs::read(&path).unwrap(), bytes);
        }
        assert_eq!(names_in(folder.path()), ["a"]);
        fs::create_dir(folder.path().join("folder")).unwrap();
        let error = write_through(&part, &folder.path().join("folder"), b"x").unwrap_err();
        assert!(matches!(error, FormatError::Unwritable { .. }), "{error}");
        assert_eq!(names_in(folder.path()), ["a", "folder"]);
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("no").join("a.png");
        let error = write_atomically(&path, b"x").unwrap_err();
        let expected = format!("there is no such folder: {}", folder.path().join("no").display());
        assert_eq!(error.to_string(), expected);
        assert!(error.help().contains("create the folder"));
        assert_eq!(names_in(folder.path()), [""; 0]);
    }

    #[test]
    fn a_folder_in_the_way_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::create_dir(&path).unwrap();
        let error = write_atomically(&path, b"x").unwrap_err();
        assert!(matches!(error, FormatError::NotAFile { what: "a folder", .. }));
        assert!(path.is_dir());
        // A file where a folder should be.
        fs::write(folder.path().join("file"), "x").unwrap();
        let error = write_atomically(&folder.path().join("file").join("a.png"), b"x").unwrap_err();
        assert!(
            matches!(error, FormatError::Unwritable { .. } | FormatError::MissingFolder { .. }),
            "{error}"
        );
        assert_eq!(names_in(folder.path()), ["a.png", "file"]);
    }

    #[test]
    fn a_write_protected_file_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, "old").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        let error = write_atomically(&path, b"new").unwrap_err();
        assert!(error.to_string().contains("write-protected"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names_in(folder.path()), ["a.png"]);
    }

    #[test]
    #[cfg(unix)]
    fn permissions_are_those_of_any_new_file_or_of_the_old_one() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let [path, plain] = ["a.png", "plain"].map(|name| folder.path().join(name));
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        write_atomically(&path, b"x").unwrap();
        fs::write(&plain, "x").unwrap();
        assert_eq!(mode(&path), mode(&plain));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        write_atomically(&path, b"y").unwrap();
        assert_eq!(mode(&path), 0o640);
    }

    #[test]
    #[cfg(unix)]
    fn a_symbolic_link_stays_one() {
        let folder = tempfile::tempdir().unwrap();
        let [path, link] = ["a.png", "link.png"].map(|name| folder.path().join(name));
        fs::write(&path, "old").unwrap();
        std::os::unix::fs::symlink("a.png", &link).unwrap();
        write_atomically(&link, b"new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_disc_and_a_folder_that_takes_no_files() {
        // The system's own stand-ins: a device that is always full, and a folder in which not even root creates files.
        let full = write_atomically(Path::new("/dev/full"), b"x").unwrap_err();
        assert!(matches!(full, FormatError::DiscFull { .. }), "{full}");
        assert!(full.help().contains("make space"));
        let error = write_atomically(Path::new("/sys/a.png"), b"x").unwrap_err();
        assert!(matches!(error, FormatError::Unwritable { .. }), "{error}");
        assert!(error.to_string().ends_with(": /sys/a.png"), "{error}");
        write_atomically(Path::new("/dev/null"), b"x").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file(), "a device stays one");
    }
}
