//! Reading files from the disc with a limit.

use crate::FormatError;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// Opens a file for reading after checking that it is one and not larger than `limit` bytes. No more than that can be
/// read from it, even if it grows meanwhile.
///
/// # Errors
/// [`FormatError::Missing`], [`FormatError::NotAFile`], [`FormatError::TooLarge`], [`FormatError::Unreadable`].
pub fn open(path: &Path, limit: u64) -> Result<io::Take<File>, FormatError> {
    // Before opening: to open a named pipe waits for a writer.
    let meta = fs::metadata(path).map_err(|cause| unreadable(path, cause))?;
    if !meta.is_file() {
        let what = if meta.is_dir() { "a folder" } else { "a device or a pipe" };
        return Err(FormatError::NotAFile { path: path.into(), what });
    }
    if meta.len() > limit {
        return Err(FormatError::TooLarge { path: path.into(), limit });
    }
    let file = File::open(path).map_err(|cause| unreadable(path, cause))?;
    Ok(file.take(limit))
}

/// All bytes of a file of at most `limit` bytes.
///
/// # Errors
/// As [`open`].
pub fn read(path: &Path, limit: u64) -> Result<Vec<u8>, FormatError> {
    let mut bytes = Vec::new();
    open(path, limit)?.read_to_end(&mut bytes).map_err(|cause| unreadable(path, cause))?;
    Ok(bytes)
}

/// The error for a file that cannot be read.
pub fn unreadable(path: &Path, cause: io::Error) -> FormatError {
    match cause.kind() {
        io::ErrorKind::NotFound => FormatError::Missing { path: path.into() },
        _ => FormatError::Unreadable { path: path.into(), cause },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_file_is_refused_before_it_is_opened() {
        let folder = tempfile::tempdir().unwrap();
        let of = |path: &Path| read(path, 10).unwrap_err();
        assert!(matches!(of(folder.path()), FormatError::NotAFile { what: "a folder", .. }));
        assert!(matches!(of(&folder.path().join("no")), FormatError::Missing { .. }));
        #[cfg(unix)]
        assert!(matches!(of(Path::new("/dev/zero")), FormatError::NotAFile { .. }));
    }

    #[test]
    fn a_file_over_the_limit_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        fs::write(&path, [7; 11]).unwrap();
        assert!(matches!(read(&path, 10), Err(FormatError::TooLarge { limit: 10, .. })));
        assert_eq!(read(&path, 11).unwrap(), [7; 11]);
    }
}
