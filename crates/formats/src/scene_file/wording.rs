//! The words of the findings that are about keys, sections and kinds.

use super::finding::Finding;
use super::section::{FORMAT, FORMAT_KEY, Kinds, NAME_KEY, Section};
use super::value::type_words;
use std::ops::Range;
use toml_edit::Item;
use vitrine_scene::{Cause, ListName, ParamSpec, closest};

/// An entry as messages call it: `[camera]`, `[[object]] "ball"`.
pub(super) fn title(section: Section, name: &str) -> String {
    if name.is_empty() { section.header() } else { format!("{} \"{name}\"", section.header()) }
}

pub(super) fn missing_format(span: Range<usize>) -> Finding {
    let message = "the file does not say which format it has";
    Finding::error(span, message, "no `format`", format!("write {FORMAT_KEY} = {FORMAT} as the first line"))
}

pub(super) fn other_format(span: Range<usize>, is_newer: bool) -> Finding {
    let help = if is_newer {
        format!(
            "the file was made for a newer version of Vitrine: update the program, or write {FORMAT_KEY} = {FORMAT}"
        )
    } else {
        format!("write {FORMAT_KEY} = {FORMAT}")
    };
    Finding::error(
        span,
        format!("this version of Vitrine reads format {FORMAT} only"),
        "another format",
        help,
    )
}

/// A key or section at the top of the file that no file has there.
pub(super) fn stray_top_key(span: Range<usize>, key: &str, item: &Item, words: &[&str]) -> Finding {
    if item.is_value()
        && let Some(home) = homes(key).first()
    {
        let message = format!("`{key}` stands outside of any section");
        return Finding::error(
            span,
            message,
            "wrong place",
            format!("it belongs {home}: move it below that header"),
        );
    }
    let what = if item.is_value() { "key" } else { "section" };
    let help = match closest(key, words.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("a scene file has {}", list_of(words)),
    };
    Finding::error(span, format!("a scene file has no {what} `{key}`"), format!("unknown {what}"), help)
}

/// A key that a section or entry does not have.
pub(super) struct StrayKey<'a> {
    /// The key.
    pub key: &'a str,
    /// Where it stands.
    pub section: Section,
    /// The kind of the entry, where there are kinds and it is known.
    pub kind: Option<&'a str>,
    /// The entry as messages call it.
    pub title: String,
}

impl StrayKey<'_> {
    /// Says where it belongs, or what was meant.
    pub fn finding(&self, span: Range<usize>) -> Finding {
        let Self { key, section, title, .. } = self;
        let register = section.kinds.zip(self.kind);
        let owners = section.kinds_with(key);
        if let (Some((kinds, kind)), false) = (register, owners.is_empty()) {
            return self.of_other_kind(span, kinds, kind, &owners);
        }
        let keys = section.keys(register.and_then(|(kinds, kind)| kinds.find(kind)));
        let homes = homes(key);
        let help = match (closest(key, keys.iter().copied()), homes.is_empty()) {
            (None, false) => format!("it belongs {}", homes.join(" or ")),
            (Some(near), _) => format!("did you mean `{near}`?"),
            (None, true) => format!("its keys are {}", list_of(&keys)),
        };
        let label = if homes.is_empty() { "unknown key" } else { "wrong place" };
        Finding::error(span, format!("{title} has no key `{key}`"), label, help)
    }

    fn of_other_kind(&self, span: Range<usize>, kinds: Kinds, kind: &str, owners: &[&str]) -> Finding {
        let (Self { key, title, .. }, word) = (self, kinds.key);
        let owners: Vec<_> = owners.iter().map(|k| format!("\"{k}\"")).collect();
        let own: Vec<_> = kinds.find(kind).map_or(&[][..], |k| k.specs).iter().map(|s| s.name).collect();
        let has = if own.is_empty() { "no keys of its own".to_owned() } else { list_of(&own) };
        Finding::error(
            span,
            format!("`{key}` belongs to {word} {}, and {title} is of {word} \"{kind}\"", owners.join(" or ")),
            format!("not for \"{kind}\""),
            format!("remove this line or change the {word}; \"{kind}\" has {has}"),
        )
    }
}

pub(super) fn missing_key(span: Range<usize>, spec: &ParamSpec, title: &str) -> Finding {
    let help = format!("add {} = …: {}", spec.name, spec.allowed());
    Finding::error(span, format!("{title} has no `{}`", spec.name), format!("no `{}`", spec.name), help)
}

/// `found` says what stands in place of a name, if anything does.
pub(super) fn bad_name(span: Range<usize>, section: Section, found: Option<&str>) -> Finding {
    let help = format!("write {NAME_KEY} = \"…\", a name that no other {} has", section.header());
    match found {
        None => Finding::error(span, format!("this {} has no name", section.header()), "no `name`", help),
        Some(found) => Finding::error(span, format!("a name is a text in quotes, not {found}"), found, help),
    }
}

pub(super) fn missing_kind(span: Range<usize>, kinds: Kinds, title: &str) -> Finding {
    let key = kinds.key;
    Finding::error(
        span,
        format!("{title} does not say of which {key} it is"),
        format!("no `{key}`"),
        format!("add {key} = …: {}", kinds.quoted()),
    )
}

pub(super) fn unknown_kind(span: Range<usize>, kinds: Kinds, item: &Item) -> Finding {
    let key = kinds.key;
    let Some(word) = item.as_str() else {
        let found = item.as_value().map_or("a section", type_words);
        let message = format!("`{key}` takes a text in quotes, not {found}");
        return Finding::error(span, message, found, format!("it is one of {}", kinds.quoted()));
    };
    let help = match closest(word, kinds.all.iter().map(|k| k.name)) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("it is one of {}", kinds.quoted()),
    };
    Finding::error(span, format!("there is no {key} \"{word}\""), format!("unknown {key}"), help)
}

/// A few words for the place that a problem of the whole scene underlines.
pub(super) fn problem_label(cause: &Cause) -> &'static str {
    match cause {
        Cause::DuplicateName { .. } => "the same name again",
        Cause::EmptyName => "empty",
        Cause::MissingReference { .. } => "no such name",
        Cause::GroupCycle { .. } => "leads back to this group",
        Cause::Fault(_) => "not possible",
        Cause::PictureTooLarge { .. } => "too large",
        Cause::NoLight => "no light",
        Cause::NoObject => "nothing to see",
        Cause::CameraInside { .. } => "around the camera",
        Cause::OpenSolid { .. } => "not closed",
        Cause::EqualSolids { .. } => "overlaps another",
    }
}

/// Where a key belongs: "in [settings]", "in a [[light]] of kind \"disc\"".
fn homes(key: &str) -> Vec<String> {
    let home = |section: Section| {
        let article = match section.list {
            None => "",
            Some(ListName::Object) => "an ",
            Some(_) => "a ",
        };
        let place = format!("in {article}{}", section.header());
        if section.specs.iter().any(|s| s.name == key) {
            return Some(place);
        }
        let kinds: Vec<_> = section.kinds_with(key).iter().map(|k| format!("\"{k}\"")).collect();
        let kind_key = section.kinds?.key;
        (!kinds.is_empty()).then(|| format!("{place} of {kind_key} {}", kinds.join(" or ")))
    };
    Section::all().filter_map(home).collect()
}

fn list_of(words: &[&str]) -> String {
    words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ")
}
