//! The JSON Schema and the documentation, held against the reader.

use super::dice::Dice;
use super::{EXAMPLE, parse, with};
use crate::SceneFile;
use crate::scene_file::{print_new, reference_markdown, schema};
use jsonschema::Validator;
use proptest::prelude::*;
use serde_json::{Value as Json, json};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use toml_edit::{Document, Item, Table, Value as Toml};
use vitrine_scene::{Camera, ListName, Owner, Settings};

static VALIDATOR: LazyLock<Validator> = LazyLock::new(validator);

fn validator() -> Validator {
    let schema = schema();
    jsonschema::draft202012::meta::validate(&schema).expect("a schema of the 2020-12 draft");
    jsonschema::draft202012::new(&schema).expect("a schema without loose references")
}

/// A scene file as JSON.
fn json(text: &str) -> Json {
    table(Document::parse(text).unwrap_or_else(|e| panic!("{e}\n{text}")).as_table())
}

fn table(table: &Table) -> Json {
    let entry = |(key, item): (&str, &Item)| {
        let value = match item {
            Item::None => Json::Null,
            Item::Value(v) => value(v),
            Item::Table(t) => self::table(t),
            Item::ArrayOfTables(tables) => tables.iter().map(self::table).collect(),
        };
        (key.to_owned(), value)
    };
    Json::Object(table.iter().map(entry).collect())
}

fn value(value: &Toml) -> Json {
    match value {
        Toml::String(s) => json!(s.value()),
        Toml::Integer(n) => json!(n.value()),
        Toml::Float(n) => json!(n.value()),
        Toml::Boolean(b) => json!(b.value()),
        Toml::Datetime(d) => json!(d.to_string()),
        Toml::Array(values) => values.iter().map(self::value).collect(),
        Toml::InlineTable(t) => Json::Object(t.iter().map(|(k, v)| (k.to_owned(), self::value(v))).collect()),
    }
}

#[test]
fn the_schema_takes_the_agreed_example() {
    let errors: Vec<_> = VALIDATOR.iter_errors(&json(EXAMPLE)).map(|e| e.to_string()).collect();
    assert!(errors.is_empty(), "{errors:#?}");
}

/// The files of a folder and the folders in it that are scenes.
fn scene_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = entries.flat_map(|path| if path.is_dir() { scene_files(&path) } else { vec![path] });
    files.filter(|path| path.to_string_lossy().ends_with(".vitrine.toml")).collect()
}

#[test]
fn every_example_scene_is_right_and_points_to_the_schema() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap();
    let files = scene_files(&root.join("scenes"));
    assert!(!files.is_empty());
    for path in files {
        let file = SceneFile::read(&path).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(file.warnings(), [], "{}", path.display());
        assert!(VALIDATOR.is_valid(&json(file.text())), "{}", path.display());
        let schema = file.text().lines().next().and_then(|line| line.strip_prefix("#:schema "));
        let schema =
            path.parent().unwrap().join(schema.unwrap_or_else(|| panic!("no #:schema: {}", path.display())));
        assert_eq!(
            schema.canonicalize().ok(),
            Some(root.join("docs/vitrine.schema.json")),
            "{}",
            path.display()
        );
    }
}

#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    let object = |lines: &str| format!("[[object]]\nname = \"o\"\n{lines}");
    let wrong = [
        "fog = 1".into(),
        "[settings]\nfog = 1".into(),
        "[settings]\ndepth = 3.5".into(),
        "[settings]\ndepth = 33".into(),
        "[settings]\nsize = [800]".into(),
        "[settings]\nsize = [0, 600]".into(),
        "[settings]\nrenderer = \"clasic\"".into(),
        "[settings]\nbackground = \"red\"".into(),
        "[settings]\nbackground = [0, -1, 0]".into(),
        "[camera]\nposition = [0, 1]".into(),
        "[camera]\nview_angle_deg = 171".into(),
        "[light]\nname = \"l\"".into(),
        "[[camera]]".into(),
        "[[material]]\ncolor = \"#ffffff\"".into(),
        "[[material]]\nname = \"\"".into(),
        "[[material]]\nname = \"m\"\nrefraction = 0.1".into(),
        "[[group]]\nname = \"g\"\nscale = 0".into(),
        "[[group]]\nname = \"g\"\nscale = [1, 0, 1]".into(),
        "[[group]]\nname = \"g\"\nvisible = 1".into(),
        "[[light]]\nname = \"l\"\nkind = \"directional\"\ndirection = [0, 0, 0.0]".into(),
        "[[light]]\nname = \"l\"\nkind = \"ambient\"\nposition = [0, 0, 0]".into(),
        "[[texture]]\nname = \"t\"\nkind = \"picture\"".into(),
        object(""),
        object("shape = \"ball\""),
        object("shape = \"sphere\"\nradius = 0"),
        object("shape = \"sphere\"\nsize = [1, 1, 1]"),
        object("shape = \"box\"\nsize = 1"),
        object("shape = \"mesh\""),
        object("shape = \"mesh\"\nfile = \"\""),
        object("shape = \"triangle\"\npoints = [[0, 0, 0], [1, 0, 0]]"),
    ];
    for lines in wrong {
        let text = with(&lines);
        assert!(parse(&text).is_err(), "the reader takes\n{text}");
        assert!(!VALIDATOR.is_valid(&json(&text)), "the schema takes\n{text}");
    }
    assert!(!VALIDATOR.is_valid(&json("[camera]")), "without `format`");
    assert!(!VALIDATOR.is_valid(&json("format = 2")), "another format");
}

#[test]
fn the_schema_says_meaning_unit_default_and_range() {
    let schema = schema();
    let radius = &schema["$defs"]["object.sphere"]["properties"]["radius"];
    let expected = json!({
        "type": "number", "exclusiveMinimum": 0.0, "default": 1.0, "description": "From the centre to the surface. Unit: m."
    });
    assert_eq!(*radius, expected);
    let light = &schema["$defs"]["light.disc"];
    assert_eq!(light["required"], json!(["name", "kind"]));
    assert_eq!(light["properties"]["color"]["default"], json!("#ffffff"));
    assert_eq!(light["properties"]["intensity"]["default"], json!(0.7), "not 0.699999988079071");
    assert_eq!(schema["$defs"]["texture.picture"]["required"], json!(["name", "kind", "file"]));
}

#[test]
fn the_documentation_has_every_key_of_the_file_and_its_example() {
    let text = reference_markdown();
    assert!(text.contains(EXAMPLE));
    let (settings, camera) = (Settings::SPECS, Camera::SPECS);
    let scene = Dice::new(1).scene_with_all();
    let lists = ListName::ALL.into_iter().flat_map(|list| {
        let scene = &scene;
        (0..scene.names(list).count()).flat_map(move |i| scene.specs(Owner::Item(list, i)))
    });
    for spec in settings.iter().chain(camera).chain(lists) {
        let row = text.lines().find(|line| line.starts_with(&format!("| `{}` |", spec.name)));
        assert!(row.is_some(), "`{}` is missing", spec.name);
    }
    let radius = "| `radius` | a number, more than 0 | m | `1.0` | From the centre to the surface. |";
    assert!(text.contains(radius), "{text}");
    for row in text.lines().filter(|l| l.starts_with('|')) {
        assert_eq!(row.matches('|').count(), 6, "{row}");
    }
}

proptest! {
    #[test]
    fn the_schema_takes_whatever_is_printed(seed in any::<u64>()) {
        let text = print_new(&Dice::new(seed).scene());
        let errors: Vec<_> = VALIDATOR.iter_errors(&json(&text)).map(|e| e.to_string()).collect();
        prop_assert!(errors.is_empty(), "{errors:#?}\n{text}");
    }
}
