//! Writing files so that a failure leaves what was there.

use crate::FormatError;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a file: all of it or nothing. The bytes go to a temporary file in the same folder, which then takes the place of
/// what was there. The file has the permissions of the one that it replaces, else those of any new file. A
/// symbolic link stays one; a device or pipe is written as it is.
///
/// # Errors
/// [`FormatError::MissingFolder`], [`FormatError::NotAFile`], [`FormatError::DiscFull`], [`FormatError::Unwritable`]. Then
/// what was there is unchanged and nothing is left behind.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), FormatError> {
    let failed = |cause: io::Error| match cause.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            FormatError::DiscFull { path: path.into() }
        }
        _ => FormatError::Unwritable { path: path.into(), cause },
    };
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

/// That the folder for a new file exists.
fn check_folder(path: &Path) -> Result<(), FormatError> {
    let folder = folder_of(path);
    if folder.is_dir() { Ok(()) } else { Err(FormatError::MissingFolder { folder }) }
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.into(),
        _ => ".".into(),
    }
}

fn replace(path: &Path, bytes: &[u8], permissions: Option<fs::Permissions>) -> io::Result<()> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".vitrine-").suffix(".part");
    // By itself the temporary file would be for its owner's eyes only; the system takes the umask off this.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder_of(path))?;
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
