//! Each message of the document and the doctor has its words in both languages, and no words are left over.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const FAMILIES: [&str; 4] = ["doctor-", "problem-", "edit-", "allowed-"];

/// The keys that the code names in quotes.
fn named(folder: &Path, keys: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            named(&path, keys);
        } else {
            let text = fs::read_to_string(&path).unwrap();
            let is_key = |word: &&str| FAMILIES.iter().any(|f| word.starts_with(f) && word.len() > f.len());
            keys.extend(text.split('"').filter(is_key).map(str::to_owned));
        }
    }
}

/// The keys of a language, each with the places for arguments.
fn told(language: &str) -> BTreeSet<(String, Vec<String>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("locales").join(language);
    let texts =
        ["doctor", "edits"].map(|name| fs::read_to_string(folder.join(format!("{name}.ftl"))).unwrap());
    let lines = texts.iter().flat_map(|text| text.lines()).filter_map(|line| line.split_once(" = "));
    let places = |text: &str| {
        let mut places: Vec<_> =
            text.split("{ $").skip(1).filter_map(|rest| Some(rest.split_once(" }")?.0.to_owned())).collect();
        places.sort();
        places
    };
    lines.map(|(key, text)| (key.to_owned(), places(text))).collect()
}

#[test]
fn every_message_has_its_words_in_both_languages() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut keys = BTreeSet::new();
    ["document", "doctor"].iter().for_each(|folder| named(&source.join(folder), &mut keys));
    assert!(keys.len() > 40, "{keys:?}");
    let english = told("en");
    assert_eq!(english.iter().map(|(key, _)| key.clone()).collect::<BTreeSet<_>>(), keys);
    assert_eq!(told("ru"), english);
}
