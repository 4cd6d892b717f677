//! The documentation of scene files, docs/scene-file.md: made from the descriptions that the reader uses.

use super::section::{
    ABOUT_DOC, ABOUT_KEY, FORMAT, FORMAT_DOC, FORMAT_KEY, Kinds, NAME_DOC, NAME_KEY, Section, one_line,
};
use super::text::{Style, ValueText};
use vitrine_scene::{KindSpec, ParamSpec};

const INTRODUCTION: &str = "\
<!-- Made by `cargo xtask docs` from the descriptions of the parameters in crates/scene. Do not edit. -->

# Scene files

A scene file is a text file in [TOML](https://toml.io), named `*.vitrine.toml`. It says how the picture is made
(`[settings]`), where the camera stands (`[camera]`), and lists lights, textures, materials, groups and objects, each entry
under a header of its own: `[[light]]`, `[[object]]`, …

- Everything has a default: a file says only what differs. What must be said is marked **required**.
- Right-handed axes with Y up. Lengths are in metres, angles in degrees (`_deg`). Turns go about X, then Y, then Z.
- A colour is `\"#rrggbb\"` (sRGB, as in any painting program) or `[r, g, b]` (linear, 0 or more).
- Entries refer to each other by name. Paths of files are relative to the scene file.
- A material has two sides, the classic scales and OpenPBR's parameters. What one side does not say is derived from the
  other by [these rules](../crates/scene/src/materials/derive.rs).
- Remarks begin with `#`. The program keeps them, and the order and spelling of all that it does not change.
- `vitrine check` says what is wrong with a file and where. An editor that knows JSON Schema does so while you type; begin
  the file with `#:schema` and the path of [vitrine.schema.json](vitrine.schema.json).
- `--set PATH=VALUE` changes one value of any scene: `--set object.ball.radius=0.5`, `--set settings.depth=5`. The path goes
  through references: `--set object.ball.material.transparency=0.4`. A name with a dot stands in quotes.
";

/// The text of docs/scene-file.md.
#[must_use]
pub fn reference_markdown() -> String {
    let mut text = format!("{INTRODUCTION}\n```toml\n{}```\n", include_str!("example.vitrine.toml"));
    text += "\n## At the top\n\n";
    text += &table(&[
        row(FORMAT_KEY, &FORMAT.to_string(), "", "**required**", FORMAT_DOC),
        row(ABOUT_KEY, "a text in quotes", "", "", ABOUT_DOC),
    ]);
    for section in Section::all() {
        text += &format!("\n## {}\n\n{}\n\n", section.header(), one_line(section.doc));
        let mut rows = Vec::new();
        if section.list.is_some() {
            rows.push(row(NAME_KEY, "a text in quotes", "", "**required**", NAME_DOC));
        }
        if let Some(kinds) = section.kinds {
            let meaning = format!("Its {}, with the keys below.", kinds.key);
            rows.push(row(kinds.key, &kinds.quoted(), "", "**required**", &meaning));
        }
        rows.extend(section.specs.iter().map(spec_row));
        text += &table(&rows);
        if let Some(kinds) = section.kinds {
            text.extend(kinds.all.iter().map(|kind| kind_part(kinds, kind)));
        }
    }
    text
}

fn kind_part(kinds: Kinds, kind: &KindSpec) -> String {
    let rows: Vec<_> = kind.specs.iter().map(spec_row).collect();
    let keys = if rows.is_empty() { "It has no keys of its own.\n".to_owned() } else { table(&rows) };
    format!("\n### {} = \"{}\"\n\n{}\n\n{keys}", kinds.key, kind.name, one_line(kind.doc))
}

fn spec_row(spec: &ParamSpec) -> String {
    let default = ValueText::of(&(spec.default)(), spec.kind, Style::Short);
    let default = match default {
        _ if spec.required => "**required**".to_owned(),
        Some(text) => format!("`{text}`"),
        None => String::new(),
    };
    row(spec.name, &spec.allowed(), spec.unit.sign(), &default, &one_line(spec.doc))
}

fn row(key: &str, takes: &str, unit: &str, default: &str, meaning: &str) -> String {
    format!("| `{key}` | {takes} | {unit} | {default} | {meaning} |\n")
}

fn table(rows: &[String]) -> String {
    format!("| Key | Takes | Unit | Default | Meaning |\n|---|---|---|---|---|\n{}", rows.concat())
}
