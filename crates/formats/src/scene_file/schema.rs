//! The JSON Schema of scene files, for editors: made from the descriptions that the reader uses.

use super::section::{
    ABOUT_DOC, ABOUT_KEY, FORMAT, FORMAT_DOC, FORMAT_KEY, Kinds, NAME_DOC, NAME_KEY, Section, one_line,
};
use super::text::{Style, ValueText};
use serde_json::{Map, Value as Json, json};
use vitrine_scene::{KindSpec, ParamKind, ParamSpec, Range, Unit};

/// The schema of scene files (JSON Schema 2020-12). What only several values together can be wrong about, such as
/// references and names, is the reader's business.
#[must_use]
pub fn schema() -> Json {
    let mut properties = Map::new();
    properties.insert(FORMAT_KEY.into(), json!({ "description": FORMAT_DOC, "const": FORMAT }));
    properties.insert(ABOUT_KEY.into(), json!({ "description": ABOUT_DOC, "type": "string" }));
    let mut definitions = Map::new();
    for section in Section::all() {
        let reference = json!({ "$ref": format!("#/$defs/{}", section.word) });
        let property = match section.list {
            Some(_) => json!({ "type": "array", "items": reference }),
            None => reference,
        };
        properties.insert(section.word.into(), property);
        define(section, &mut definitions);
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Vitrine scene",
        "description": "A scene file of Vitrine, *.vitrine.toml.",
        "type": "object",
        "required": [FORMAT_KEY],
        "additionalProperties": false,
        "properties": properties,
        "$defs": definitions,
    })
}

/// The definition of a section, and of each of its kinds.
fn define(section: Section, definitions: &mut Map<String, Json>) {
    let Some(kinds) = section.kinds else {
        definitions.insert(section.word.into(), table(section, None));
        return;
    };
    let name = |kind: &KindSpec| format!("{}.{}", section.word, kind.name);
    let references: Vec<_> =
        kinds.all.iter().map(|k| json!({ "$ref": format!("#/$defs/{}", name(k)) })).collect();
    let words: Vec<_> = kinds.all.iter().map(|k| k.name).collect();
    let kind_doc = format!("Its {}.", kinds.key);
    definitions.insert(
        section.word.into(),
        json!({
            "description": one_line(section.doc),
            "type": "object",
            "required": [NAME_KEY, kinds.key],
            "properties": { (kinds.key): { "description": kind_doc, "enum": words } },
            "oneOf": references,
        }),
    );
    for kind in kinds.all {
        definitions.insert(name(kind), table(section, Some((kinds, kind))));
    }
}

/// A section, or the entries of a list that are of one kind.
fn table(section: Section, kind: Option<(Kinds, &KindSpec)>) -> Json {
    let mut properties = Map::new();
    let mut required = Vec::new();
    if section.list.is_some() {
        properties
            .insert(NAME_KEY.into(), json!({ "description": NAME_DOC, "type": "string", "pattern": "\\S" }));
        required.push(NAME_KEY);
    }
    if let Some((kinds, kind)) = kind {
        properties.insert(kinds.key.into(), json!({ "description": one_line(kind.doc), "const": kind.name }));
        required.push(kinds.key);
    }
    let of_kind = kind.map_or(&[][..], |(_, kind)| kind.specs);
    for spec in of_kind.iter().chain(section.specs) {
        properties.insert(spec.name.into(), property(spec));
        required.extend(spec.required.then_some(spec.name));
    }
    let doc = kind.map_or(section.doc, |(_, kind)| kind.doc);
    json!({
        "description": one_line(doc),
        "type": "object",
        "required": required,
        "additionalProperties": false,
        "properties": properties,
    })
}

/// What a file may say for a parameter.
fn property(spec: &ParamSpec) -> Json {
    let mut property = takes(spec.kind);
    let mut description = one_line(spec.doc);
    if spec.unit != Unit::None {
        description += &format!(" Unit: {}.", spec.unit.sign());
    }
    if let ParamKind::Reference(list) = spec.kind {
        description += &format!(" The name of a [[{}]].", list.key());
    }
    property["description"] = description.into();
    let default = ValueText::of(&(spec.default)(), spec.kind, Style::Short).filter(|_| !spec.required);
    if let Some(default) = default {
        property["default"] = json_of(&default);
    }
    property
}

fn takes(kind: ParamKind) -> Json {
    match kind {
        ParamKind::Flag => json!({ "type": "boolean" }),
        ParamKind::Integer { min, max } => json!({ "type": "integer", "minimum": min, "maximum": max }),
        ParamKind::Number(range) => number(range),
        ParamKind::Size { min, max } => {
            list(2, &json!({ "type": "integer", "minimum": min, "maximum": max }))
        }
        ParamKind::Pair(range) => list(2, &number(range)),
        ParamKind::Vector(range) => list(3, &number(range)),
        ParamKind::Direction => {
            let mut direction = list(3, &number(Range::ANY));
            direction["not"] = json!({ "items": { "const": 0 } });
            direction
        }
        ParamKind::Scale => {
            let factor = json!({ "type": "number", "not": { "const": 0 } });
            json!({ "anyOf": [factor, list(3, &factor)] })
        }
        ParamKind::Color => json!({ "anyOf": [
            { "type": "string", "pattern": "^#[0-9a-fA-F]{6}$" },
            list(3, &number(Range::NOT_NEGATIVE)),
        ] }),
        ParamKind::Points(count) => list(count, &list(3, &number(Range::ANY))),
        ParamKind::Pairs(count) => list(count, &list(2, &number(Range::ANY))),
        ParamKind::Choice(words) => json!({ "enum": words }),
        ParamKind::Text => json!({ "type": "string" }),
        ParamKind::Reference(_) | ParamKind::File => json!({ "type": "string", "pattern": "\\S" }),
    }
}

fn list(count: usize, items: &Json) -> Json {
    json!({ "type": "array", "items": items, "minItems": count, "maxItems": count })
}

fn number(range: Range) -> Json {
    let mut number = json!({ "type": "number" });
    if range.min > f32::MIN {
        let key = if range.above_min { "exclusiveMinimum" } else { "minimum" };
        number[key] = short(range.min);
    }
    if range.max < f32::MAX {
        number["maximum"] = short(range.max);
    }
    number
}

/// The number with no more digits than it needs.
fn short(number: f32) -> Json {
    json_of(&ValueText::One(super::text::number_text(number)))
}

/// A value's text as JSON. Numbers, texts, true and false are written alike in TOML and JSON as this program writes them.
fn json_of(text: &ValueText) -> Json {
    match text {
        ValueText::One(text) => text.parse().unwrap_or_else(|_| Json::from(text.as_str())),
        ValueText::List(parts) => parts.iter().map(json_of).collect(),
    }
}
