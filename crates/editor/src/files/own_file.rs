//! The program's own small files: TOML, written whole or not at all; a broken one is set aside and never a reason to stop.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use vitrine::formats::{FormatError, write_atomically};

/// One of the program's own files could not be read as it should.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{reason}: {}", path.display())]
pub struct OwnFileWarning {
    /// The file.
    pub path: PathBuf,
    /// What is wrong, in one line.
    pub reason: String,
    /// Where the broken file lies now.
    pub set_aside: Option<PathBuf>,
}

/// Reads a file, or gives the default when there is none. A broken one is renamed to `*.broken` and the default given.
pub(super) fn read<T: DeserializeOwned + Default>(path: &Path) -> (T, Option<OwnFileWarning>) {
    let warn = |reason: String, set_aside| {
        let path = path.to_owned();
        (T::default(), Some(OwnFileWarning { path, reason, set_aside }))
    };
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return (T::default(), None),
        Err(error) if error.kind() == io::ErrorKind::InvalidData => {
            return warn("the file is no text".into(), set_aside(path));
        }
        Err(error) => return warn(error.to_string(), None),
    };
    match toml_edit::de::from_str(&text) {
        Ok(value) => (value, None),
        Err(error) => warn(error.message().lines().next().unwrap_or_default().to_owned(), set_aside(path)),
    }
}

fn set_aside(path: &Path) -> Option<PathBuf> {
    let mut name = path.file_name()?.to_owned();
    name.push(".broken");
    let aside = path.with_file_name(name);
    fs::rename(path, &aside).ok().map(|()| aside)
}

/// Writes a file, and the folder that it lies in.
pub(super) fn write(path: &Path, value: &impl Serialize) -> Result<(), FormatError> {
    let unwritable = |cause: io::Error| FormatError::Unwritable { path: path.to_owned(), cause };
    let text = toml_edit::ser::to_string_pretty(value).map_err(|e| unwritable(io::Error::other(e)))?;
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(unwritable)?;
    }
    write_atomically(path, text.as_bytes())
}
