//! Messages to the person: what is wrong, where (with the line underlined), how to mend it.

use miette::{
    Diagnostic, GraphicalTheme, LabeledSpan, MietteHandlerOpts, NamedSource, ReportHandler, SourceCode,
};
use serde_json::{Value, json};
use std::fmt;
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::sync::Arc;
use vitrine::Project;
use vitrine::formats::scene_file::SetError;
use vitrine::formats::{Finding, SceneFileError};
use vitrine::scene::Severity;

/// One message.
#[derive(Debug)]
pub struct Report {
    severity: Severity,
    message: String,
    help: Option<String>,
    place: Option<Place>,
    /// How many findings it stands for.
    count: usize,
}

/// Where in a text something is wrong.
#[derive(Debug)]
struct Place {
    source: NamedSource<Arc<str>>,
    label: String,
    span: Range<usize>,
}

impl Report {
    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into(), help: None, place: None, count: 1 }
    }

    /// A warning.
    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// The same with advice; an empty advice is none.
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = stated(&help.into());
        self
    }

    /// One finding in the text of a file.
    pub fn of_finding(name: &str, text: &Arc<str>, finding: &Finding) -> Self {
        Self {
            severity: finding.severity,
            message: finding.message.clone(),
            help: stated(&finding.help),
            place: Some(Place {
                source: NamedSource::new(name, text.clone()),
                label: finding.label.clone(),
                span: finding.span.clone(),
            }),
            count: 1,
        }
    }

    /// Everything that is wrong with a scene file.
    pub fn of_scene(error: &SceneFileError) -> Vec<Self> {
        let name = error.path.display().to_string();
        let findings = error.findings.iter().map(|f| Self::of_finding(&name, &error.text, f));
        let more =
            Self { count: error.more, ..Self::error(format!("{} more after these: {name}", error.more)) };
        findings.chain((error.more > 0).then_some(more)).collect()
    }

    /// What may not be as it was meant in a scene, its models and textures.
    pub fn warnings_of(project: &Project) -> Vec<Self> {
        let name = project.path().display().to_string();
        let text: Arc<str> = project.checked_text().into();
        let findings = project.warnings().iter().map(|f| Self::of_finding(&name, &text, f));
        findings.chain(project.asset_warnings().iter().map(Self::warning)).collect()
    }

    /// What is wrong with the argument of `--set`.
    pub fn of_set(argument: &str, error: &SetError) -> Self {
        Self {
            severity: Severity::Error,
            message: error.message.clone(),
            help: stated(&error.help),
            place: Some(Place {
                source: NamedSource::new("--set", argument.into()),
                label: error.label.clone(),
                span: error.span.clone(),
            }),
            count: 1,
        }
    }

    /// How many findings it stands for.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether it is an error rather than a warning.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }

    /// The message for programs.
    pub fn to_json(&self) -> Value {
        let mut json = json!({
            "severity": if self.is_error() { "error" } else { "warning" },
            "message": self.message,
            "help": self.help,
        });
        if let Some(place) = &self.place {
            let (line, column) = line_and_column(place.source.inner(), place.span.start);
            json["file"] = place.source.name().into();
            json["line"] = line.into();
            json["column"] = column.into();
        }
        json
    }
}

/// An advice, unless it is empty.
fn stated(help: &str) -> Option<String> {
    (!help.is_empty()).then(|| help.to_owned())
}

/// Line and column, both from 1, of a byte; columns count characters.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |n| n + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// Shows messages on stderr: with colours and fine lines on a terminal, plain elsewhere.
pub fn show(reports: &[Report]) {
    let options = MietteHandlerOpts::new().force_graphical(true).terminal_links(false).context_lines(1);
    let handler = if std::io::stderr().is_terminal() {
        options.build()
    } else {
        // For logs and programs: no colours, only ASCII, and words in place of signs.
        let mut theme = GraphicalTheme::none();
        theme.characters.error = "error:".into();
        theme.characters.warning = "warning:".into();
        options.graphical_theme(theme).color(false).width(100).build()
    };
    let mut text = String::new();
    for report in reports {
        let drawn = format!("{:?}\n", Shown { report, handler: &handler });
        // The handler indents the first line by two; a log reads better without.
        text.push_str(drawn.trim_start_matches(' '));
    }
    // Nobody is left to tell when stderr itself fails.
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// A message with the way to draw it.
struct Shown<'a> {
    report: &'a Report,
    handler: &'a miette::MietteHandler,
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.handler.debug(self.report, f)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Report {}

impl Diagnostic for Report {
    fn severity(&self) -> Option<miette::Severity> {
        Some(if self.is_error() { miette::Severity::Error } else { miette::Severity::Warning })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|h| Box::new(h) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.place.as_ref().map(|p| &p.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.place.as_ref()?;
        let label = LabeledSpan::new(Some(place.label.clone()), place.span.start, place.span.len());
        Some(Box::new(std::iter::once(label)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_one_and_by_characters() {
        let text = "шар = 1\nрадиус = 2\n";
        assert_eq!(line_and_column(text, 0), (1, 1));
        let two = text.find('2').unwrap();
        assert_eq!(line_and_column(text, two), (2, 10));
        assert_eq!(line_and_column(text, text.len()), (3, 1));
    }
}
