//! How a command ends: the exit codes, and which error means which of them. Nothing else decides that.

use crate::report::Report;
use std::process::ExitCode;
use vitrine::Error;
use vitrine::denoise::DenoiseError;
use vitrine::formats::FormatError;
use vitrine::render::RenderError;

/// The exit codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// Done.
    Done = 0,
    /// Something failed that is not the fault of the input: no space, no permission.
    Failed = 1,
    /// The command line makes no sense.
    Usage = 2,
    /// A scene, model or texture is missing or wrong.
    BadInput = 3,
    /// Ctrl-C.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}

/// A command that did not do what it was asked.
#[derive(Debug)]
pub struct Failure {
    /// The exit code.
    pub exit: Exit,
    /// What to tell the person; may be empty when all has been told.
    pub reports: Vec<Report>,
}

impl Failure {
    /// A failure with one message.
    pub fn new(exit: Exit, report: Report) -> Self {
        Self { exit, reports: vec![report] }
    }

    /// The command line makes no sense.
    pub fn usage(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::new(Exit::Usage, Report::error(message).with_help(help))
    }

    /// The end of a command that has said everything itself.
    pub fn silent(exit: Exit) -> Self {
        Self { exit, reports: Vec::new() }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error {
            Error::Scene(error) => Self { exit: Exit::BadInput, reports: Report::of_scene(&error) },
            Error::Format(error) => error.into(),
            Error::Set { argument, error } => Self::new(Exit::Usage, Report::of_set(&argument, &error)),
            Error::Render(RenderError::Region(error)) => Self::usage(
                error.to_string(),
                "--region takes X,Y,W,H in pixels from the upper left corner of the picture",
            ),
            Error::Render(RenderError::OtherFilm) => {
                Self::new(Exit::Failed, Report::error(error.to_string()))
            }
            Error::Render(RenderError::OtherBlocks { .. }) => Self::new(
                Exit::Failed,
                Report::error(error.to_string()).with_help(
                    "render as many samples as it was begun with, or leave --resume out to begin anew",
                ),
            ),
            Error::Render(RenderError::TooLarge { .. }) => {
                Self::usage(error.to_string(), "give it fewer pixels with --size")
            }
            Error::OtherRender { .. } => Self::new(
                Exit::Failed,
                Report::error(error.to_string())
                    .with_help("render as it was begun, or leave --resume out to begin anew"),
            ),
            Error::InTheWay { .. } => Self::new(
                Exit::Failed,
                Report::error(error.to_string()).with_help("choose another name, or replace it with --force"),
            ),
            Error::Compile(error) => {
                Self::new(Exit::BadInput, Report::error(error.to_string()).with_help(error.help()))
            }
            Error::Folder { .. } => Self::new(Exit::Failed, Report::error(error.to_string())),
        }
    }
}

impl From<DenoiseError> for Failure {
    fn from(error: DenoiseError) -> Self {
        let exit = match error {
            DenoiseError::NotFound { .. } | DenoiseError::Failed { .. } => Exit::Failed,
            DenoiseError::NotWhole { .. } | DenoiseError::OtherSize { .. } | DenoiseError::NormalsAlone => {
                Exit::BadInput
            }
        };
        Self::new(exit, Report::error(error.to_string()).with_help(error.help()))
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        let exit = match error {
            FormatError::MissingFolder { .. }
            | FormatError::DiscFull { .. }
            | FormatError::Unwritable { .. }
            | FormatError::NotAState { .. }
            | FormatError::StateOfOtherVersion { .. }
            | FormatError::StateDamaged { .. }
            | FormatError::Encode { .. } => Exit::Failed,
            _ => Exit::BadInput,
        };
        Self::new(exit, Report::error(error.to_string()).with_help(error.help()))
    }
}
