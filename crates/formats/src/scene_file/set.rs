//! `PATH=VALUE`: one value of a scene changed by a line of text, with the same checks as in a file.

use super::section::{NAME_KEY, Section};
use super::value::{BadValue, read_value};
use super::wording::problem_label;
use std::ops::Range;
use toml_edit::{Document, Value as Toml};
use vitrine_scene::{ParamKind, PathError, Problem, Scene, ScenePath, Severity};

/// Why `PATH=VALUE` was refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct SetError {
    /// What is wrong, in one line.
    pub message: String,
    /// A few words to stand at the underlined place.
    pub label: String,
    /// What is allowed or how to mend it.
    pub help: String,
    /// The bytes of the argument that are meant; empty where something is missing.
    pub span: Range<usize>,
}

impl SetError {
    fn new(span: Range<usize>, message: impl Into<String>, label: &str, help: impl Into<String>) -> Self {
        Self { message: message.into(), label: label.into(), help: help.into(), span }
    }
}

const FORM: &str = "write PATH=VALUE, such as object.ball.radius=0.5 or camera.position=[0,1,5]";

/// Sets one value: `object.ball.material.transparency=0.4`.
///
/// The words of the path are parted by dots; a word with a dot or = in it stands in quotes. References are followed. The
/// value is TOML; what is no TOML counts as a text, so `settings.renderer=cast` and `light.Lamp.color=#ff8800` work.
///
/// # Errors
/// Whatever a file would be refused for. Then nothing has changed.
pub fn set(scene: &mut Scene, argument: &str) -> Result<(), SetError> {
    let assignment = Assignment::split(argument)?;
    let words: Vec<&str> = assignment.words.iter().map(|(word, _)| word.as_str()).collect();
    let path = ScenePath::find(scene, &words).map_err(|e| assignment.path_error(&e))?;
    let span = assignment.value.clone();
    if span.is_empty() {
        let help = format!("`{}` takes {}", path.spec.name, path.spec.allowed());
        return Err(SetError::new(span, "the value is missing", "no value", help));
    }
    let value = read_text(&path, &argument[span.clone()]).map_err(|bad| {
        let part = bad.span.map_or(span.clone(), |part| span.start + part.start..span.start + part.end);
        SetError { message: bad.message, label: bad.label, help: bad.help, span: part }
    })?;
    let mut changed = scene.clone();
    changed.set(path.owner, path.spec.name, value).map_err(|e| {
        SetError::new(
            span.clone(),
            e.to_string(),
            "not allowed",
            format!("`{}` takes {}", path.spec.name, path.spec.allowed()),
        )
    })?;
    let known = errors(scene);
    if let Some(problem) = errors(&changed).into_iter().find(|p| !known.contains(p)) {
        let label = problem_label(&problem.cause);
        return Err(SetError::new(span, problem.cause.to_string(), label, problem.cause.help()));
    }
    *scene = changed;
    Ok(())
}

/// Parts `PATH=V1,V2,…` into the path and the values. Commas in brackets and quotes part nothing.
///
/// # Errors
/// When there is no path, or a value is missing.
pub fn split_values(argument: &str) -> Result<(String, Vec<String>), SetError> {
    let assignment = Assignment::split(argument)?;
    let mut values = Vec::new();
    let mut start = assignment.value.start;
    for end in commas(argument, assignment.value.clone()).into_iter().chain([assignment.value.end]) {
        let value = argument[start..end].trim();
        if value.is_empty() {
            return Err(SetError::new(start..end, "a value is missing", "no value", "write PATH=V1,V2,…"));
        }
        values.push(value.to_owned());
        start = end + 1;
    }
    Ok((argument[..assignment.equals].trim().to_owned(), values))
}

/// The commas that part values.
fn commas(text: &str, within: Range<usize>) -> Vec<usize> {
    let mut commas = Vec::new();
    let mut depth = 0_usize;
    let mut quote = None;
    // A quote within a word, as in Bob's, opens nothing.
    let mut is_start = true;
    let mut is_escaped = false;
    for (at, c) in text[within.clone()].char_indices() {
        match (quote, c) {
            (Some('"'), '\\') if !is_escaped => {
                is_escaped = true;
                continue;
            }
            (Some(open), c) if c == open && !is_escaped => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') if is_start => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            (None, ',') if depth == 0 => commas.push(within.start + at),
            (None, _) => {}
        }
        is_escaped = false;
        is_start = matches!(c, ',' | '[' | '{') || (is_start && c.is_whitespace());
    }
    commas
}

/// `PATH=VALUE`, parted.
struct Assignment {
    /// The words of the path without quotes, and where they stand.
    words: Vec<(String, Range<usize>)>,
    /// Where the = is.
    equals: usize,
    /// The value without blanks around it.
    value: Range<usize>,
}

impl Assignment {
    fn split(text: &str) -> Result<Self, SetError> {
        let mut words = Vec::new();
        let mut at = 0;
        loop {
            let (word, span) = path_word(text, at)?;
            let rest = &text[span.end..];
            let next = span.end + (rest.len() - rest.trim_start().len());
            words.push((word, span));
            at = next + 1;
            match text[next..].chars().next() {
                Some('.') => {}
                Some('=') => break,
                Some(_) => {
                    return Err(SetError::new(
                        next..text.len(),
                        "a dot is missing after the quotes",
                        "here",
                        FORM,
                    ));
                }
                None => return Err(SetError::new(next..next, "there is no =, so no value", "no =", FORM)),
            }
        }
        let value = &text[at..];
        let start = at + (value.len() - value.trim_start().len());
        Ok(Self { words, equals: at - 1, value: start..(at + value.trim_end().len()).max(start) })
    }

    /// Finds the words that the error is about.
    fn path_error(&self, error: &PathError) -> SetError {
        let texts: Vec<&str> = self.words.iter().map(|(word, _)| word.as_str()).collect();
        let span = |index: usize| self.words.get(index).map_or(0..self.equals, |(_, span)| span.clone());
        let behind = |owner: &str| (0..texts.len()).find(|n| texts[..*n].join(".") == *owner);
        let (span, label) = match error {
            PathError::Malformed { .. } => (0..self.equals, "not a path"),
            PathError::NoPart { .. } => (span(0), "no part of a scene"),
            PathError::NoName { name, .. } => {
                let index = texts.iter().position(|t| t == name).unwrap_or(1);
                (span(index), "no such name")
            }
            PathError::NoKey { owner, .. } => (behind(owner).map_or(0..self.equals, span), "no such key"),
            PathError::NoReference { owner, .. } => {
                (behind(owner).map_or(0..self.equals, span), "not stated")
            }
        };
        match error {
            PathError::NoKey { key, .. } if is_of_frame(key) => {
                let help =
                    "names and kinds are changed in the scene file; here only what an entry has of its own";
                SetError::new(span, format!("`{key}` cannot be set"), label, help)
            }
            _ => SetError::new(span, error.to_string(), label, error.help()),
        }
    }
}

/// Whether a key is the frame's and no parameter: the name or the kind.
fn is_of_frame(key: &str) -> bool {
    key == NAME_KEY || Section::all().filter_map(|s| s.kinds).any(|kinds| kinds.key == key)
}

/// One word of a path from there, and where it stands.
fn path_word(text: &str, from: usize) -> Result<(String, Range<usize>), SetError> {
    let rest = &text[from..];
    let start = from + (rest.len() - rest.trim_start().len());
    let rest = &text[start..];
    let Some(quote) = rest.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
        let word = rest.find(['.', '=']).map_or(rest, |end| &rest[..end]).trim_end();
        if word.is_empty() {
            return Err(SetError::new(start..start, "a word of the path is missing", "no word", FORM));
        }
        return Ok((word.to_owned(), start..start + word.len()));
    };
    let mut word = String::new();
    let mut is_escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        match c {
            '\\' if quote == '"' && !is_escaped => is_escaped = true,
            c if c == quote && !is_escaped => return Ok((word, start..start + at + 1)),
            c => {
                word.push(c);
                is_escaped = false;
            }
        }
    }
    Err(SetError::new(
        start..text.len(),
        "the quotes are not closed",
        "here",
        format!("write {quote} at the end of the word"),
    ))
}

/// Reads the text of a value as TOML, or as a text where that is what the parameter takes or what it can only be.
fn read_text(path: &ScenePath, text: &str) -> Result<vitrine_scene::Value, BadValue> {
    let takes_text = matches!(
        path.spec.kind,
        ParamKind::Text | ParamKind::Choice(_) | ParamKind::Reference(_) | ParamKind::File
    );
    const KEY: &str = "v=";
    let line = format!("{KEY}{text}");
    let parsed = Document::parse(line.as_str());
    // Not more than the value: no remark behind it and no further line.
    let whole = |v: &&Toml| v.span() == Some(KEY.len()..line.len());
    let value = parsed.as_ref().ok().and_then(|d| d.get("v")).and_then(|i| i.as_value()).filter(whole);
    let read = match value {
        Some(value) if value.is_str() || !takes_text => read_value(path.spec, value, &line),
        _ if text.starts_with('[') && !takes_text => Err(BadValue {
            span: None,
            message: format!("this value of `{}` is no list in TOML", path.spec.name),
            label: "brackets or commas are wrong".into(),
            help: format!("`{}` takes {}", path.spec.name, path.spec.allowed()),
        }),
        _ => read_value(path.spec, &Toml::from(text), &line),
    };
    let in_text = |span: Range<usize>| span.start - KEY.len()..span.end - KEY.len();
    read.map_err(|bad| BadValue { span: bad.span.map(in_text), ..bad })
}

fn errors(scene: &Scene) -> Vec<Problem> {
    scene.problems().into_iter().filter(|p| p.severity == Severity::Error).collect()
}
