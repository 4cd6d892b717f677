//! Changes to the text of one section or entry: only the values that differ are touched.

use super::outline::Entry;
use super::text::{Style, ValueText, number_text};
use super::value::{read_number, read_value};
use super::view::{Statement, View};
use std::ops::Range;
use toml_edit::{Item, Value as Toml};
use vitrine_scene::Value;

/// A piece of text in place of another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Edit {
    /// The bytes that go; empty when something comes in between.
    pub range: Range<usize>,
    /// What comes.
    pub text: String,
}

/// The changes to one section or entry.
#[derive(Debug, Default)]
pub(super) struct EntryEdits {
    /// The changes.
    pub edits: Vec<Edit>,
    /// Whether keys come or go, which needs lines of their own. Without a header they are not among the changes.
    pub has_lines: bool,
}

/// The file's text by its lines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lines<'a> {
    /// The text.
    pub text: &'a str,
    /// How its lines end.
    pub newline: &'static str,
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a str) -> Self {
        let is_windows = text.find('\n').is_some_and(|at| text[..at].ends_with('\r'));
        Self { text, newline: if is_windows { "\r\n" } else { "\n" } }
    }

    /// Where the line begins.
    pub fn start(&self, at: usize) -> usize {
        self.text[..at].rfind('\n').map_or(0, |end| end + 1)
    }

    /// Where the line ends, before the sign of its end.
    pub fn end(&self, at: usize) -> usize {
        let line = self.text[at..].find('\n').map_or(&self.text[at..], |end| &self.text[at..at + end]);
        at + line.strip_suffix('\r').unwrap_or(line).len()
    }

    /// Where the next line begins.
    pub fn next(&self, at: usize) -> usize {
        self.text[at..].find('\n').map_or(self.text.len(), |end| at + end + 1)
    }

    /// A line of its own behind the one with that byte, as far in.
    fn insertion(&self, after: usize, key: &str, value: &ValueText) -> Edit {
        let after = self.end(after);
        let line = &self.text[self.start(after)..after];
        let indent = &line[..line.len() - line.trim_start_matches([' ', '\t']).len()];
        Edit { range: after..after, text: format!("{}{indent}{key} = {value}", self.newline) }
    }

    /// Takes the lines of a key and its value out.
    pub fn removal(&self, key: &Range<usize>, value: &Range<usize>) -> Edit {
        Edit { range: self.start(key.start)..self.next(value.end), text: String::new() }
    }
}

/// What must change in an entry's text so that it says what the view does.
pub(super) fn entry_edits(entry: &Entry, view: &View, lines: Lines) -> EntryEdits {
    let mut editor = EntryEditor::new(entry, lines, entry.span.end);
    for statement in &view.statements {
        editor.say(statement);
    }
    for (key, _) in entry.table.iter() {
        if !view.statements.iter().any(|s| s.key == key) {
            editor.remove(key);
        }
    }
    editor.result
}

/// What must change in an entry for one key; a new line goes behind that of the key `after`.
pub(super) fn statement_edits(entry: &Entry, statement: &Statement, after: &str, lines: Lines) -> EntryEdits {
    let mut editor = EntryEditor::new(entry, lines, entry.value_span(after).end);
    editor.say(statement);
    editor.result
}

struct EntryEditor<'a> {
    entry: &'a Entry<'a>,
    lines: Lines<'a>,
    /// The line behind which a new one goes, by any byte in it.
    after: usize,
    result: EntryEdits,
}

impl<'a> EntryEditor<'a> {
    fn new(entry: &'a Entry<'a>, lines: Lines<'a>, after: usize) -> Self {
        Self { entry, lines, after, result: EntryEdits::default() }
    }

    fn say(&mut self, statement: &Statement) {
        let key = statement.key;
        let Some(old) = self.entry.table.get(key).and_then(Item::as_value) else {
            let text = statement.value_text(Style::Short).filter(|_| statement.is_needed());
            return text.into_iter().for_each(|text| self.add(key, &text));
        };
        let style = if old.is_array() { Style::List } else { Style::Short };
        let Some(new) = statement.value_text(style) else { return self.remove(key) };
        if !says(old, statement, self.lines.text) {
            value_edits(old, &new, self.lines.text, &mut self.result.edits);
        }
        self.after = self.entry.value_span(key).end;
    }

    fn add(&mut self, key: &str, value: &ValueText) {
        self.result.has_lines = true;
        if self.entry.has_header {
            self.result.edits.push(self.lines.insertion(self.after, key, value));
        }
    }

    fn remove(&mut self, key: &str) {
        self.result.has_lines = true;
        if self.entry.has_header {
            let (key, value) = (self.entry.key_span(key), self.entry.value_span(key));
            self.result.edits.push(self.lines.removal(&key, &value));
        }
    }
}

/// Whether the text says this already, in whatever way.
fn says(old: &Toml, statement: &Statement, text: &str) -> bool {
    match (statement.spec, &statement.value) {
        (Some(spec), value) => read_value(spec, old, text).is_ok_and(|v| v == *value),
        (None, Value::Text(word)) => old.as_str() == Some(word),
        (None, _) => false,
    }
}

/// Puts a new value in place of the old one; of a list of the same length, only what differs.
fn value_edits(old: &Toml, new: &ValueText, text: &str, edits: &mut Vec<Edit>) {
    match (old, new) {
        (Toml::Array(old), ValueText::List(new)) if old.len() == new.len() => {
            for (old, new) in old.iter().zip(new) {
                value_edits(old, new, text, edits);
            }
        }
        (_, ValueText::One(new)) if is_number(old, new, text) => {}
        _ => edits.extend(old.span().map(|range| Edit { range, text: new.to_string() })),
    }
}

/// Whether a number is the one that the new text says.
fn is_number(old: &Toml, new: &str, text: &str) -> bool {
    let is_same = |n: f32| number_text(n) == new;
    old.as_integer().is_some_and(|n| n.to_string() == new) || read_number(old, text).is_some_and(is_same)
}
