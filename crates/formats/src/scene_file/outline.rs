//! Where the sections and entries of a parsed file stand.

use super::finding::{Finding, Findings};
use super::section::{CAMERA, SETTINGS, Section};
use std::ops::Range;
use toml_edit::{Item, Table, TableLike, Value};
use vitrine_scene::{ListName, Owner};

/// One section, or one entry of a list.
#[derive(Clone)]
pub(super) struct Entry<'d> {
    /// Its keys and values.
    pub table: &'d dyn TableLike,
    /// Its header; the whole of it where it stands in braces.
    pub span: Range<usize>,
    /// Whether it stands under a header; not with dots or in braces.
    pub has_header: bool,
}

impl Entry<'_> {
    /// Where a key stands.
    pub fn key_span(&self, key: &str) -> Range<usize> {
        let key = self.table.get_key_value(key).and_then(|(k, _)| k.span());
        key.unwrap_or_else(|| self.span.clone())
    }

    /// Where a key's value stands; the header when the key is missing.
    pub fn value_span(&self, key: &str) -> Range<usize> {
        match self.table.get(key) {
            Some(item) => item.span().unwrap_or_else(|| self.key_span(key)),
            None => self.span.clone(),
        }
    }
}

/// The sections and lists of a file.
#[derive(Default)]
pub(super) struct Outline<'d> {
    pub settings: Option<Entry<'d>>,
    pub camera: Option<Entry<'d>>,
    lists: [Vec<Entry<'d>>; ListName::ALL.len()],
}

impl<'d> Outline<'d> {
    /// Finds them. What stands in brackets of the wrong sort is reported and left out.
    pub fn read(root: &'d Table, findings: &mut Findings) -> Self {
        let mut outline = Self::default();
        for section in Section::all() {
            let Some((key, item)) = root.get_key_value(section.word) else { continue };
            let span = key.span().unwrap_or_default();
            let entries = match section.list {
                Some(_) => list_entries(item, &span),
                None => single_entry(item, &span).map(|e| vec![e]),
            };
            let mut entries = entries.unwrap_or_else(|wrong| {
                let header = section.header();
                findings.add(wrong, |span| wrong_brackets(span, item, section, &header));
                Vec::new()
            });
            match (section.list, section.word) {
                (Some(list), _) => outline.lists[list as usize] = entries,
                (None, SETTINGS) => outline.settings = entries.pop(),
                (None, CAMERA) => outline.camera = entries.pop(),
                (None, _) => {}
            }
        }
        outline
    }

    /// The entries of a list.
    pub fn list(&self, list: ListName) -> &[Entry<'d>] {
        &self.lists[list as usize]
    }

    /// Where an owner of parameters stands.
    pub fn entry(&self, owner: Owner) -> Option<&Entry<'d>> {
        match owner {
            Owner::Settings => self.settings.as_ref(),
            Owner::Camera => self.camera.as_ref(),
            Owner::Item(list, index) => self.list(list).get(index),
        }
    }
}

/// The entry of a section that stands once, or where it goes wrong.
fn single_entry<'d>(item: &'d Item, key: &Range<usize>) -> Result<Entry<'d>, Range<usize>> {
    let span = item.span().unwrap_or_else(|| key.clone());
    match item {
        Item::Table(table) => Ok(Entry { table, span, has_header: !table.is_dotted() }),
        Item::Value(Value::InlineTable(table)) => Ok(Entry { table, span, has_header: false }),
        Item::ArrayOfTables(tables) => Err(tables.get(0).and_then(Table::span).unwrap_or(span)),
        _ => Err(span),
    }
}

/// The entries of a list, or where it goes wrong.
fn list_entries<'d>(item: &'d Item, key: &Range<usize>) -> Result<Vec<Entry<'d>>, Range<usize>> {
    let span = |span: Option<Range<usize>>| span.unwrap_or_else(|| key.clone());
    match item {
        Item::ArrayOfTables(tables) => Ok(tables
            .iter()
            .map(|table| Entry { table, span: span(table.span()), has_header: true })
            .collect()),
        Item::Value(Value::Array(values)) => {
            let entry = |value: &'d Value| match value {
                Value::InlineTable(table) => Ok(Entry { table, span: span(table.span()), has_header: false }),
                other => Err(span(other.span())),
            };
            values.iter().map(entry).collect()
        }
        other => Err(span(other.span())),
    }
}

fn wrong_brackets(span: Range<usize>, item: &Item, section: Section, header: &str) -> Finding {
    let word = section.word;
    let (message, label) = match (item, section.list) {
        (Item::Table(_), Some(_)) => {
            (format!("`{word}` is a list, so each entry starts with {header}"), "single brackets")
        }
        (Item::ArrayOfTables(_), None) => {
            (format!("there is only one {word}, so it starts with {header}"), "double brackets")
        }
        (_, Some(_)) => {
            (format!("each entry of `{word}` is a section that starts with {header}"), "not an entry")
        }
        (_, None) => (format!("`{word}` is a section that starts with {header}"), "not a section"),
    };
    Finding::error(span, message, label, format!("write {header} on a line of its own, and its keys below"))
}
