//! What is wrong with a scene file, and where in its text.

use std::fmt;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;
use vitrine_scene::Severity;

/// One thing wrong with a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How bad.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// A few words to stand at the underlined place.
    pub label: String,
    /// What is allowed or how to mend it.
    pub help: String,
    /// The bytes of the text that are meant; empty where something is missing.
    pub span: Range<usize>,
}

impl Finding {
    pub(super) fn error(
        span: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        let (message, label, help) = (message.into(), label.into(), help.into());
        Self { severity: Severity::Error, message, label, help, span }
    }
}

/// A scene file that says something wrong.
#[derive(Debug, thiserror::Error)]
pub struct SceneFileError {
    /// The file.
    pub path: PathBuf,
    /// Its whole text.
    pub text: Arc<str>,
    /// What is wrong, in the order of the text; never empty.
    pub findings: Vec<Finding>,
    /// How many further ones are not listed.
    pub more: usize,
}

impl fmt::Display for SceneFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let first = self.findings.first().map_or("", |f| f.message.as_str());
        match self.findings.len() + self.more {
            0 | 1 => write!(f, "{first}: {}", self.path.display()),
            n => write!(f, "{first}, and {} more: {}", n - 1, self.path.display()),
        }
    }
}

/// Collects findings in the order of the text, and of very many only the first.
#[derive(Debug, Default)]
pub(super) struct Findings {
    kept: Vec<Finding>,
    more: usize,
}

impl Findings {
    /// As many as a person reads at once.
    pub(super) const MOST: usize = 20;

    /// Adds one. `make` runs only if it will be kept.
    pub(super) fn add(&mut self, span: Range<usize>, make: impl FnOnce(Range<usize>) -> Finding) {
        let at = self.kept.partition_point(|f| f.span.start <= span.start);
        if at < Self::MOST {
            self.kept.insert(at, make(span));
            if self.kept.len() <= Self::MOST {
                return;
            }
            self.kept.pop();
        }
        self.more += 1;
    }

    pub(super) fn is_empty(&self) -> bool {
        self.kept.is_empty()
    }

    /// The findings, and how many more there were.
    pub(super) fn into_parts(self) -> (Vec<Finding>, usize) {
        (self.kept, self.more)
    }
}
