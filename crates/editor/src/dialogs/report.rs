//! What did not work: the reason, the file, the line with the place underlined, and what helps.

use super::Outcome;
use super::frame::{self, Buttons, Caption, Shell, Verdict};
use crate::files::{FileProblem, OpenError, TextPlace, describe};
use crate::text::tr;
use crate::theme::{self, Theme};
use eframe::egui::text::LayoutJob;
use eframe::egui::{Context, FontId, Label, ScrollArea, Stroke, TextFormat, TextStyle, Ui};
use std::ops::Range;
use std::path::PathBuf;
use vitrine::formats::FormatError;

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

    /// What an error of a file says.
    #[must_use]
    pub fn of_file(failure: Failure, error: &FormatError) -> Self {
        let (message, help) = describe(error);
        Self::new(failure, message, help)
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
    use crate::files::{read_model, read_scene};
    use std::path::Path;

    /// What is reported of a scene with this text.
    fn report_of(folder: &Path, text: &str) -> ErrorReport {
        let path = folder.join("ball.vitrine.toml");
        std::fs::write(&path, text).unwrap();
        let report = ErrorReport::of_open(Failure::Scene, &read_scene(&path).unwrap_err());
        assert_eq!(report.path, Some(path));
        report
    }

    #[test]
    fn a_single_fault_is_the_message_itself_with_its_place_in_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let text = "format = 1\r\n[[object]]\r\nshape = \"sphere\"\r\nname = \"мяч\"\r\nraduis = 2\r\n";
        let report = report_of(folder.path(), text);
        assert!(report.message.contains("raduis") && report.help.contains("radius"), "{report:?}");
        let [line] = &report.lines[..] else { panic!("{report:?}") };
        assert_eq!(
            (line.number, line.text.as_str(), &line.text[line.mark.clone()]),
            (5, "raduis = 2", "raduis")
        );
        assert!(line.message.is_empty() && line.help.is_empty(), "it stands above");
        let path = report.path.as_ref().unwrap().display();
        let all = format!("{}\n{path}\n5: raduis = 2\n{}", report.message, report.help);
        assert_eq!(report.text(), all);
    }

    #[test]
    fn each_of_several_faults_stands_at_its_line() {
        let folder = tempfile::tempdir().unwrap();
        let text = "format = 1\n[[object]]\nname = \"мяч\" ; \nshape = 1\n";
        let syntax = report_of(folder.path(), text);
        assert!(syntax.lines.iter().all(|line| line.text.is_char_boundary(line.mark.end)), "{syntax:?}");
        let report = report_of(folder.path(), "format = 1\nabuot = \"\"\n[kamera]\n");
        let numbers: Vec<_> = report.lines.iter().map(|line| line.number).collect();
        assert_eq!(numbers, [2, 3]);
        assert!(
            report.lines.iter().all(|line| !line.message.is_empty()) && report.help.is_empty(),
            "{report:?}"
        );
        assert!(report.message.contains('2'), "it says how many: {}", report.message);
    }

    #[test]
    fn a_faulty_line_of_a_model_is_shown_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("broken.obj");
        std::fs::write(&path, "v 0 0 0\nf 1 2 3\n").unwrap();
        let error = read_model(&path, Some(folder.path())).unwrap_err();
        let report = ErrorReport::of_open(Failure::Model, &error);
        let [line] = &report.lines[..] else { panic!("{report:?}") };
        assert_eq!((line.number, line.text.as_str(), line.mark.clone()), (2, "f 1 2 3", 0..7));
    }

    #[test]
    fn a_file_that_is_not_there_has_no_lines() {
        let error = read_scene(Path::new("nowhere/none.vitrine.toml")).unwrap_err();
        let report = ErrorReport::of_open(Failure::Scene, &error);
        assert!(report.lines.is_empty() && !report.message.is_empty() && !report.help.is_empty());
    }

    #[test]
    fn messages_become_sentences() {
        assert_eq!(sentence("the name is empty"), "The name is empty.");
        assert_eq!(sentence("did you mean `a`?"), "Did you mean `a`?");
        assert_eq!(sentence(""), "");
    }
}
