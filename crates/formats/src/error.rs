//! Everything that can go wrong with a file, by cause.
//!
//! A message says what is wrong and ends with the path; [`FormatError::help`] says how to mend it.

use crate::SceneFileError;
use std::io;
use std::path::PathBuf;

/// Why a file was not read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FormatError {
    /// There is nothing at the path.
    #[error("there is no such file: {}", path.display())]
    Missing {
        /// The file.
        path: PathBuf,
    },
    /// The path leads to a folder, a device or the like.
    #[error("this is {what}, not a file: {}", path.display())]
    NotAFile {
        /// The path.
        path: PathBuf,
        /// What it is: "a folder".
        what: &'static str,
    },
    /// The file exists and cannot be read.
    #[error("the file cannot be read, {cause}: {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        cause: io::Error,
    },
    /// The file is larger than its reader takes.
    #[error("the file is too large, more than {} MB: {}", limit >> 20, path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The most bytes.
        limit: u64,
    },
    /// The file should be text and is not.
    #[error("the file is not UTF-8 text, see byte {} ({byte:#04x}): {}", position + 1, path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// How many good bytes come before the bad one.
        position: usize,
        /// The first bad byte.
        byte: u8,
    },
    /// A scene file says something wrong.
    #[error(transparent)]
    Scene(#[from] Box<SceneFileError>),
    /// No reader or writer knows the extension.
    #[error("the extension of the file is not that of {what}: {}", path.display())]
    UnknownExtension {
        /// The file.
        path: PathBuf,
        /// What was wanted: "a model".
        what: &'static str,
        /// The extensions that are known: ".obj".
        supported: String,
    },
    /// A model's file is wrong as a whole.
    #[error("{reason}: {}", path.display())]
    Model {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
        /// How to mend it.
        help: String,
    },
    /// A line of a model's file is wrong.
    #[error("line {line}: {reason}: {}", path.display())]
    ModelLine {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// What is wrong.
        reason: String,
        /// How to mend it.
        help: String,
    },
    /// The file's content is no picture that can be read.
    #[error("this is not a PNG or JPEG picture{}: {}", found.map(|f| format!(" but {f}")).unwrap_or_default(), path.display())]
    NotAPicture {
        /// The file.
        path: PathBuf,
        /// What it is: "a GIF picture". None: nobody knows.
        found: Option<&'static str>,
    },
    /// The file's content is no panorama that can be read.
    #[error("this is not an OpenEXR, HDR, PNG or JPEG picture{}: {}", found.map(|f| format!(" but {f}")).unwrap_or_default(), path.display())]
    NotAPanorama {
        /// The file.
        path: PathBuf,
        /// What it is: "a GIF picture". None: nobody knows.
        found: Option<&'static str>,
    },
    /// The file is not one with the layers of a picture, or lacks what is needed.
    #[error("{reason}: {}", path.display())]
    Layers {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: &'static str,
    },
    /// The picture's file ends before the picture does.
    #[error("the picture is cut off, its file ends too early: {}", path.display())]
    PictureCutOff {
        /// The file.
        path: PathBuf,
    },
    /// The picture has more pixels than fit into memory.
    #[error("the picture is too large, {width} × {height} pixels: {}", path.display())]
    PictureTooLarge {
        /// The file.
        path: PathBuf,
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
    },
    /// The picture's file is damaged.
    #[error("the picture is damaged, {reason}: {}", path.display())]
    PictureDamaged {
        /// The file.
        path: PathBuf,
        /// The decoder's reason.
        reason: String,
    },
    /// The file keeps no render.
    #[error("this is not a file that keeps a stopped render: {}", path.display())]
    NotAState {
        /// The file.
        path: PathBuf,
    },
    /// The file keeps a render of another version of Vitrine.
    #[error("the stopped render was begun by another version of Vitrine: {}", path.display())]
    StateOfOtherVersion {
        /// The file.
        path: PathBuf,
    },
    /// The file keeps a render and is damaged.
    #[error("the file of the stopped render is damaged or cut off: {}", path.display())]
    StateDamaged {
        /// The file.
        path: PathBuf,
    },
    /// A picture does not fit into its format.
    #[error("the picture does not fit into a {format} file: {reason}")]
    Encode {
        /// The format's name: "JPEG".
        format: &'static str,
        /// What does not fit.
        reason: String,
    },
    /// The folder to write to does not exist.
    #[error("there is no such folder: {}", folder.display())]
    MissingFolder {
        /// The folder.
        folder: PathBuf,
    },
    /// The disc is full.
    #[error("there is no space left on the disc to write the file: {}", path.display())]
    DiscFull {
        /// The file.
        path: PathBuf,
    },
    /// The file cannot be written.
    #[error("the file cannot be written, {cause}: {}", path.display())]
    Unwritable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        cause: io::Error,
    },
    /// A file that the scene names is wrong.
    #[error("{owner}: {cause}")]
    Asset {
        /// What names the file: "object `cone`".
        owner: String,
        /// What is wrong with the file.
        cause: Box<FormatError>,
    },
    /// Something in the scene names no file where it must.
    #[error("`file` is empty")]
    EmptyPath,
}

impl FormatError {
    /// How to mend it.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::Missing { .. } => "check the spelling and the folder".into(),
            Self::NotAFile { .. } => "give the path of a file".into(),
            Self::Unreadable { .. } => "check that you may read the file".into(),
            Self::TooLarge { .. } => "use a smaller or simplified file".into(),
            Self::NotText { position: 0, byte: 0xfe | 0xff, .. } => {
                "it looks like UTF-16: save it as UTF-8 in your editor".into()
            }
            Self::NotText { .. } => {
                "open it in a text editor and save it as UTF-8, if it is a text at all".into()
            }
            Self::Scene(error) => error.findings.first().map_or_else(String::new, |f| f.help.clone()),
            Self::UnknownExtension { supported, .. } => format!("known are {supported}"),
            Self::Model { help, .. } | Self::ModelLine { help, .. } => help.clone(),
            Self::NotAPicture { .. } => "save the picture as PNG or JPEG".into(),
            Self::NotAPanorama { .. } => "save the panorama as OpenEXR, HDR, PNG or JPEG".into(),
            Self::Layers { .. } => "save the picture as OpenEXR, in colour".into(),
            Self::PictureCutOff { .. } => "copy or download the picture again".into(),
            Self::PictureTooLarge { .. } => "make the picture smaller".into(),
            Self::PictureDamaged { .. } => "open the picture in another program and save it again".into(),
            Self::NotAState { .. } => "give the .vitrine-state file that the render left".into(),
            Self::StateOfOtherVersion { .. } => {
                "go on with the version that began it, or remove the file and render anew".into()
            }
            Self::StateDamaged { .. } => "remove the file and render anew".into(),
            Self::Encode { .. } => "choose another format or a smaller picture".into(),
            Self::MissingFolder { .. } => "create the folder first, or choose another".into(),
            Self::DiscFull { .. } => "make space or choose another disc".into(),
            Self::Unwritable { .. } => "check that you may write there, or choose another folder".into(),
            Self::Asset { cause, .. } => cause.help(),
            Self::EmptyPath => "give the path of a file, relative to the scene file".into(),
        }
    }
}
