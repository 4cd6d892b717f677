//! The file to write: where it goes when nobody says, and whether it can be written, asked before any work is done.

use crate::failure::{Exit, Failure};
use crate::report::Report;
use std::io;
use std::path::{Path, PathBuf};
use vitrine::Project;
use vitrine::formats::{self, folder_of};

/// The picture's file when nobody says: beside the scene, with its name.
pub fn beside(project: &Project, ending: &str) -> PathBuf {
    project.path().with_file_name(format!("{}{ending}", project.name()))
}

/// Checks that a picture can be written there: a known extension, a folder that exists and takes files.
///
/// # Errors
/// What is in the way.
pub fn check_picture(path: &Path) -> Result<(), Failure> {
    if let Err(error) = formats::image_format(path) {
        return Err(Failure::usage(error.to_string(), error.help()));
    }
    check_place(path)
}

/// Checks that a file can be written there: one that may be replaced, or none and around it a folder that takes files.
///
/// # Errors
/// What is in the way.
pub fn check_place(path: &Path) -> Result<(), Failure> {
    let Ok(there) = path.metadata() else { return check_folder(folder_of(path)) };
    if there.is_dir() {
        return Err(failed(format!("this is a folder, not a file: {}", path.display()), "add a file name"));
    }
    if !there.is_file() {
        // A device or a pipe is written as it is.
        return Ok(());
    }
    if there.permissions().readonly() {
        return Err(failed(
            format!("the file is write-protected: {}", path.display()),
            "choose another name, or take the protection off",
        ));
    }
    // The new file takes the old one's place where a symbolic link leads.
    let target = path.canonicalize();
    check_folder(folder_of(target.as_deref().unwrap_or(path)))
}

/// Checks that a folder exists and takes files.
///
/// # Errors
/// What is in the way.
pub fn check_folder(folder: &Path) -> Result<(), Failure> {
    match folder.metadata() {
        Ok(data) if !data.is_dir() => {
            return Err(failed(
                format!("this is a file, not a folder: {}", folder.display()),
                "choose another folder",
            ));
        }
        Ok(_) => {}
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Err(failed(
                format!("there is no such folder: {}", folder.display()),
                "create the folder first, or choose another",
            ));
        }
        Err(error) => {
            return Err(failed(
                format!("the folder cannot be used, {error}: {}", folder.display()),
                "choose another folder",
            ));
        }
    }
    // The surest way to know whether a file can be made there is to make one; it vanishes at once.
    tempfile::Builder::new().prefix(".vitrine-").tempfile_in(folder).map(drop).map_err(|error| {
        failed(
            format!("no file can be written into the folder, {}: {}", error.kind(), folder.display()),
            "choose another folder, or get the right to write there",
        )
    })
}

fn failed(message: String, help: &str) -> Failure {
    Failure::new(Exit::Failed, Report::error(message).with_help(help))
}
