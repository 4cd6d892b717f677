//! What did not work: the reason, the file, the line with the place underlined, and what helps.

use super::Outcome;
use super::frame::{self, Buttons, Caption, Shell, Verdict};
use crate::files::{FileProblem, OpenError, TextPlace};
use crate::text::tr;
use crate::theme::{self, Theme};
use eframe::egui::text::LayoutJob;
use eframe::egui::{Context, FontId, Label, ScrollArea, Stroke, TextFormat, TextStyle, Ui};
use std::ops::Range;
use std::path::PathBuf;
use vitrine::formats::{Finding, FormatError, SceneFileError};

/// What was being done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// A scene was opened.
    Scene,
    /// A model was read.
    Model,
    /// A picture was saved.
    SavePicture,
    /// A picture was rendered.
    Render,
    /// Anything else.
    Other,
}

/// A line of a file in which something is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadLine {
    /// Counted from 1.
    pub number: usize,
    /// Its text; empty when nobody has kept it.
    pub text: String,
    /// The bytes of the text that are meant.
    pub mark: Range<usize>,
    /// What is wrong there.
    pub message: String,
    /// What helps.
    pub help: String,
}

/// Something that did not work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ErrorReport {
    /// What was being done.
    pub failure: Failure,
    /// The reason.
    pub message: String,
    /// The file, if one is to blame.
    pub path: Option<PathBuf>,
    /// The lines to blame, if it is a text.
    pub lines: Vec<BadLine>,
    /// What helps; empty when that is not known.
    pub help: String,
    has_copied: bool,
}

impl ErrorReport {
    /// A reason and what helps.
    #[must_use]
    pub fn new(failure: Failure, message: impl Into<String>, help: impl Into<String>) -> Self {
        let (message, help) = (message.into(), help.into());
        Self { failure, message, path: None, lines: Vec::new(), help, has_copied: false }
    }

    /// Why a file was not opened: everything that is wrong, with the lines.
    #[must_use]
    pub fn of_open(failure: Failure, error: &OpenError) -> Self {
        let mut problems = error.problems();
        let mut report = match &mut problems[..] {
            [only] => Self::new(failure, std::mem::take(&mut only.message), std::mem::take(&mut only.help)),
            all => Self::new(failure, tr!("dialog-error-many", count = all.len() + error.more()), ""),
        };
        report.path = Some(error.path.clone());
        let bad_line = |problem: FileProblem| {
            let TextPlace { line, text, marked, .. } = problem.place?;
            let byte = |at: usize| text.char_indices().nth(at).map_or(text.len(), |(byte, _)| byte);
            let mark = byte(marked.start)..byte(marked.end);
            Some(BadLine { number: line, text, mark, message: problem.message, help: problem.help })
        };
        report.lines = problems.into_iter().filter_map(bad_line).collect();
        report
    }

    /// What an error of a file says, with its lines.
    #[must_use]
    pub fn of_file(failure: Failure, error: &FormatError) -> Self {
        match error {
            FormatError::Scene(error) => Self::of_scene(failure, error),
            FormatError::ModelLine { path, line, reason, help } => {
                let mut report = Self::new(failure, reason, help);
                report.path = Some(path.clone());
                let text = line_of_file(path, *line);
                let mark = 0..text.len();
                let (message, help) = (String::new(), String::new());
                report.lines.push(BadLine { number: *line, text, mark, message, help });
                report
            }
            error => Self::new(failure, error.to_string(), error.help()),
        }
    }

    fn of_scene(failure: Failure, error: &SceneFileError) -> Self {
        let mut report = Self::new(failure, error.to_string(), "");
        report.path = Some(error.path.clone());
        report.lines = error.findings.iter().map(|f| bad_line(&error.text, f)).collect();
        if let [only] = &mut report.lines[..] {
            report.message = std::mem::take(&mut only.message);
            report.help = std::mem::take(&mut only.help);
        }
        report
    }

    /// All of it as a text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = self.message.clone();
        let path = self.path.iter().map(|p| p.display().to_string());
        let lines = self.lines.iter().flat_map(|line| {
            let place = format!("{}: {}", line.number, line.text.trim_end());
            [place, line.message.clone(), line.help.clone()]
        });
        for line in path.chain(lines).chain([self.help.clone()]).filter(|l| !l.is_empty()) {
            text.push('\n');
            text.push_str(&line);
        }
        text
    }

    pub(super) fn show(&mut self, ctx: &Context) -> Outcome {
        let title = tr!(match self.failure {
            Failure::Scene => "dialog-error-scene",
            Failure::Model => "dialog-error-model",
            Failure::SavePicture => "dialog-error-picture",
            Failure::Render => "dialog-error-render",
            Failure::Other => "dialog-error-title",
        });
        let width = theme::of(ctx).sizes.dialog_width * 1.35;
        let verdict = frame::show(ctx, Shell { id: "error", title: &title, width }, |ui| {
            self.body(ui);
            Buttons { other: Some(Caption::of("dialog-copy")), ..Buttons::close() }
        });
        match verdict {
            Verdict::Other => {
                ctx.copy_text(self.text());
                self.has_copied = true;
                Outcome::Stay(None)
            }
            Verdict::Open => Outcome::Stay(None),
            Verdict::Accept | Verdict::Cancel => Outcome::Close(None),
        }
    }

    fn body(&self, ui: &mut Ui) {
        frame::paragraph(ui, &sentence(&self.message));
        if let Some(path) = &self.path {
            frame::hint(ui, &path.display().to_string());
        }
        for line in &self.lines {
            bad_line_ui(ui, line);
        }
        if !self.help.is_empty() {
            frame::heading(ui, &tr!("dialog-error-help"));
            frame::paragraph(ui, &sentence(&self.help));
        }
        if matches!(self.failure, Failure::Scene | Failure::Model) {
            frame::hint(ui, &tr!("dialog-error-kept"));
        }
        if self.has_copied {
            frame::hint(ui, &tr!("dialog-copied"));
        }
    }
}

fn bad_line_ui(ui: &mut Ui, line: &BadLine) {
    let theme = theme::of(ui);
    frame::sunken(ui, |ui| {
        frame::hint(ui, &tr!("dialog-error-line", line = line.number));
        if !line.text.is_empty() {
            let font = TextStyle::Monospace.resolve(ui.style());
            let job = marked(line, &font, theme);
            ScrollArea::horizontal().id_salt(("line", line.number)).show(ui, |ui| {
                ui.add(Label::new(job).extend());
            });
        }
        if !line.message.is_empty() {
            frame::fault(ui, &sentence(&line.message));
        }
        if !line.help.is_empty() {
            frame::hint(ui, &sentence(&line.help));
        }
    });
}

/// The text with what is meant underlined.
fn marked(line: &BadLine, font: &FontId, theme: &Theme) -> LayoutJob {
    let text = line.text.as_str();
    let at = |i: usize| text.floor_char_boundary(i.min(text.len()));
    let (start, end) = (at(line.mark.start), at(line.mark.end).max(at(line.mark.start)));
    let plain = TextFormat::simple(font.clone(), theme.text);
    let underline = Stroke::new(theme.sizes.line_bold, theme.error_text);
    let mark = TextFormat { underline, ..TextFormat::simple(font.clone(), theme.error_text) };
    let mut job = LayoutJob::default();
    job.append(&text[..start], 0.0, plain.clone());
    job.append(&text[start..end], 0.0, mark);
    job.append(&text[end..], 0.0, plain);
    job
}

fn bad_line(text: &str, finding: &Finding) -> BadLine {
    let at = text.floor_char_boundary(finding.span.start.min(text.len()));
    let start = text[..at].rfind('\n').map_or(0, |i| i + 1);
    let end = text[at..].find('\n').map_or(text.len(), |i| at + i);
    let line = text[start..end].trim_end_matches('\r');
    let mark = at - start..finding.span.end.saturating_sub(start).min(line.len());
    let number = text[..at].matches('\n').count() + 1;
    let (message, help) = (finding.message.clone(), finding.help.clone());
    BadLine { number, text: line.to_owned(), mark, message, help }
}

/// The line of a text file, if it can be read and is not absurdly long.
fn line_of_file(path: &std::path::Path, number: usize) -> String {
    use std::io::{BufRead as _, BufReader, Read as _};
    const MOST: u64 = 1 << 24;
    let Ok(file) = std::fs::File::open(path) else { return String::new() };
    let mut lines = BufReader::new(file.take(MOST)).lines();
    let line = lines.nth(number.saturating_sub(1)).and_then(Result::ok).unwrap_or_default();
    line.chars().take(400).collect()
}

/// With a capital letter and a full stop, as a sentence in a window stands.
fn sentence(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().into_iter().flat_map(char::to_uppercase);
    let text: String = first.chain(chars).collect();
    if text.ends_with(['.', '?', '!']) || text.is_empty() { text } else { text + "." }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::Severity;

    fn finding(span: Range<usize>) -> Finding {
        let word = |text: &str| text.to_owned();
        Finding {
            severity: Severity::Error,
            message: word("unknown key `raduis`"),
            label: word("not known"),
            help: word("did you mean `radius`?"),
            span,
        }
    }

    #[test]
    fn the_line_is_found_with_its_number_and_mark() {
        let text = "format = 1\r\n[[object]]\r\nraduis = 2\r\n";
        let line = bad_line(text, &finding(24..30));
        assert_eq!((line.number, line.text.as_str(), line.mark), (3, "raduis = 2", 0..6));
        let last = bad_line("a\nb", &finding(3..9));
        assert_eq!((last.number, last.text.as_str(), last.mark), (2, "b", 1..1));
    }

    #[test]
    fn a_single_finding_is_the_message_itself() {
        let error = SceneFileError {
            path: "ball.vitrine.toml".into(),
            text: "raduis = 2".into(),
            findings: vec![finding(0..6)],
            more: 0,
        };
        let report = ErrorReport::of_file(Failure::Scene, &FormatError::Scene(Box::new(error)));
        assert_eq!(report.message, "unknown key `raduis`");
        let text = "unknown key `raduis`\nball.vitrine.toml\n1: raduis = 2\ndid you mean `radius`?";
        assert_eq!(report.text(), text);
    }

    #[test]
    fn messages_become_sentences() {
        assert_eq!(sentence("the name is empty"), "The name is empty.");
        assert_eq!(sentence("did you mean `a`?"), "Did you mean `a`?");
        assert_eq!(sentence(""), "");
    }
}
