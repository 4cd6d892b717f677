//! What is wrong with a file, in the words of the window: the message, the line it is about, how to mend it.

use super::wording;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::{Finding, FormatError};
use vitrine::scene::Severity;

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextPlace {
    /// Counted from 1.
    pub line: usize,
    /// Counted from 1, in characters.
    pub column: usize,
    /// The whole line.
    pub text: String,
    /// The characters of the line that are meant; empty where something is missing.
    pub marked: Range<usize>,
}

impl TextPlace {
    /// The place of these bytes of a text; of several lines, the first.
    #[must_use]
    pub fn of(text: &str, span: &Range<usize>) -> Self {
        let inside = |at: usize| (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i));
        let (from, to) = (inside(span.start).unwrap_or(0), inside(span.end).unwrap_or(0));
        let start = text[..from].rfind('\n').map_or(0, |i| i + 1);
        let end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let column = text[start..from].chars().count();
        let length = text[from.min(end)..to.clamp(from.min(end), end)].chars().count();
        Self {
            line: text[..start].matches('\n').count() + 1,
            column: column + 1,
            text: text[start..end].trim_end_matches('\r').to_owned(),
            marked: column..column + length,
        }
    }
}

/// One thing wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileProblem {
    /// How bad.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// How to mend it; may be empty.
    pub help: String,
    /// Where, when it is at some place of a text.
    pub place: Option<TextPlace>,
}

impl FileProblem {
    /// What was found in the text of a scene.
    #[must_use]
    pub fn of_finding(finding: &Finding, text: &str) -> Self {
        Self {
            severity: finding.severity,
            message: finding.message.clone(),
            help: finding.help.clone(),
            place: Some(TextPlace::of(text, &finding.span)),
        }
    }
}

/// Why a file was not opened.
#[derive(Debug, thiserror::Error)]
#[error("{cause}")]
pub struct OpenError {
    /// The file that a person wanted.
    pub path: PathBuf,
    /// What is wrong.
    #[source]
    pub cause: FormatError,
    /// The text of the scene, where the fault is in a file that it names.
    text: Option<Arc<str>>,
}

impl OpenError {
    /// A fault of the file itself.
    pub(super) fn of(path: &Path, cause: FormatError) -> Self {
        Self { path: path.to_owned(), cause, text: None }
    }

    /// A fault of a file that the scene names.
    pub(super) fn of_asset(path: &Path, cause: FormatError, text: &str) -> Self {
        Self { path: path.to_owned(), cause, text: Some(text.into()) }
    }

    /// All that is wrong, in the order of the text and in the current language.
    #[must_use]
    pub fn problems(&self) -> Vec<FileProblem> {
        if let FormatError::Scene(error) = &self.cause {
            return error.findings.iter().map(|f| FileProblem::of_finding(f, &error.text)).collect();
        }
        let (message, help) = wording::describe(&self.cause);
        vec![FileProblem { severity: Severity::Error, message, help, place: self.place() }]
    }

    /// How many further problems are not listed.
    #[must_use]
    pub fn more(&self) -> usize {
        if let FormatError::Scene(error) = &self.cause { error.more } else { 0 }
    }

    fn place(&self) -> Option<TextPlace> {
        if let FormatError::ModelLine { path, line, .. } = &self.cause {
            return line_of_file(path, *line);
        }
        let (FormatError::Asset { cause, .. }, Some(text)) = (&self.cause, &self.text) else { return None };
        // The scene writes the file's path as the end of the whole one, in quotes.
        let whole = path_of(cause)?.to_string_lossy().replace('\\', "/");
        let starts = text.match_indices('"').map(|(i, _)| i + 1);
        let named = starts.filter_map(|start| {
            let end = start + text[start..].find(['"', '\n'])?;
            let name = text[start..end].replace('\\', "/");
            (name.contains('.') && whole.ends_with(name.trim_start_matches("./"))).then_some(start..end)
        });
        named.max_by_key(Range::len).map(|span| TextPlace::of(text, &span))
    }
}

/// A line of a model's file. Models can be large, so it is read only up to there.
fn line_of_file(path: &Path, line: usize) -> Option<TextPlace> {
    use std::io::{BufRead, BufReader};
    let file = BufReader::new(std::fs::File::open(path).ok()?);
    let text = file.lines().nth(line.checked_sub(1)?)?.ok()?;
    let length = text.chars().count();
    Some(TextPlace { line, column: 1, text, marked: 0..length })
}

/// The file that an error is about.
fn path_of(error: &FormatError) -> Option<&Path> {
    match error {
        FormatError::Missing { path }
        | FormatError::NotAFile { path, .. }
        | FormatError::Unreadable { path, .. }
        | FormatError::TooLarge { path, .. }
        | FormatError::NotText { path, .. }
        | FormatError::UnknownExtension { path, .. }
        | FormatError::Model { path, .. }
        | FormatError::ModelLine { path, .. }
        | FormatError::NotAPicture { path, .. }
        | FormatError::PictureCutOff { path }
        | FormatError::PictureTooLarge { path, .. }
        | FormatError::PictureDamaged { path, .. } => Some(path),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_lines_and_characters_from_one() {
        let text = "format = 1\nимя = \"мяч\"\r\nend";
        let start = text.find("\"мяч\"").unwrap();
        let place = TextPlace::of(text, &(start..start + "\"мяч\"".len()));
        assert_eq!((place.line, place.column, place.text.as_str()), (2, 7, "имя = \"мяч\""));
        assert_eq!(place.marked, 6..11);
    }

    #[test]
    fn spans_beyond_the_end_or_inside_a_letter_do_no_harm() {
        let text = "ж\n";
        for span in [0..0, 1..1, 0..1, 2..9, 9..12] {
            let place = TextPlace::of(text, &span);
            assert!(place.line <= 2 && place.marked.end <= 1, "{span:?}: {place:?}");
        }
        assert_eq!(TextPlace::of("", &(0..0)).line, 1);
    }
}
