//! `vitrine templates`.

use crate::support::Folder;
use vitrine::templates::TEMPLATES;

#[test]
fn the_list_names_all_with_what_they_show() {
    let outcome = Folder::new().run_well(&["templates"]);
    let lines: Vec<_> = outcome.out.lines().collect();
    assert_eq!(lines.len(), TEMPLATES.len());
    for (line, template) in lines.iter().zip(TEMPLATES) {
        assert!(line.starts_with(template.name) && line.len() > template.name.len() + 12, "{line}");
    }
}

#[test]
fn every_template_is_a_sound_scene_that_renders() {
    for template in TEMPLATES {
        let folder = Folder::new();
        folder.run_well(&["templates", template.name, "-o", "t.vitrine.toml"]);
        let outcome = folder.run_well(&["check", "t.vitrine.toml"]);
        assert_eq!(outcome.out, "t.vitrine.toml: fine\n", "{}: {}", template.name, outcome.err);
        folder.run_well(&["render", "t.vitrine.toml", "--size", "32x32", "--samples", "1"]);
        let picture = folder.picture("t.png");
        let first = picture.texels[0];
        assert!(picture.texels.iter().any(|t| *t != first), "{} shows something", template.name);
    }
}

#[test]
fn without_a_file_the_text_is_printed() {
    let outcome = Folder::new().run_well(&["templates", "empty"]);
    let empty = TEMPLATES.iter().find(|t| t.name == "empty").unwrap();
    assert_eq!(outcome.out, empty.text());
}

#[test]
fn what_is_there_is_not_replaced_unless_asked() {
    let folder = Folder::new();
    folder.write("t.vitrine.toml", "mine");
    let write = |more: &[&str]| folder.run(&[&["templates", "empty", "-o", "t.vitrine.toml"], more].concat());
    write(&[]).fails(1, &["different file", "t.vitrine.toml", "--force"]);
    assert_eq!(folder.read("t.vitrine.toml"), b"mine");
    assert_eq!(write(&["--force"]).code, Some(0));
    assert_ne!(folder.read("t.vitrine.toml"), b"mine");
    assert_eq!(write(&[]).code, Some(0), "the same once more is no clash");
}

#[test]
fn unknown_names_and_places() {
    let folder = Folder::new();
    folder.run(&["templates", "emty"]).fails(2, &["no template `emty`", "did you mean `empty`?"]);
    folder.run(&["templates", "zzzzzzzz"]).fails(2, &["no template `zzzzzzzz`", "the templates are"]);
    folder.run(&["templates", "-o", "t.vitrine.toml"]).fails(2, &["NAME"]);
    folder.run(&["templates", "empty", "-o", "missing/t.vitrine.toml"]).fails(1, &["no such folder"]);
    assert!(folder.names().is_empty());
}
