//! Models and pictures on the disc, and the text that is saved.

use super::*;
use std::fs;
use vitrine::scene::shapes::Mesh;
use vitrine::scene::{Shape, Value};

const MODEL: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

pub(super) fn with_model() -> (tempfile::TempDir, Document) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("one.obj"), MODEL).unwrap();
    let path = folder.path().join("shelf.vitrine.toml");
    let file = SceneFile::parse(&path, SHELF).unwrap();
    let document = Document::opened(file, Assets::default(), Vec::new(), path);
    (folder, document)
}

pub(super) fn model(file: &str) -> EditCommand {
    let shape = Shape::Mesh(Mesh { file: file.into(), ..Mesh::default() });
    let objects = vec![Object { name: "model".into(), shape, ..Object::default() }];
    EditCommand::Add(Addition { objects, ..Addition::default() })
}

#[test]
fn a_model_is_read_from_the_scenes_folder_with_the_edit_that_names_it() {
    let (_folder, mut document) = with_model();
    edit(&mut document, model("one.obj"));
    assert_eq!(document.assets().meshes[Path::new("one.obj")].triangles.len(), 1);
    document.undo();
    assert!(document.assets().meshes.contains_key(Path::new("one.obj")), "redoing needs it");
}

#[test]
fn a_model_that_cannot_be_read_is_refused_with_the_reason() {
    let (folder, mut document) = with_model();
    fs::write(folder.path().join("broken.obj"), "f 1 2 3\n").unwrap();
    for file in ["nowhere.obj", "broken.obj", ""] {
        let EditError::File { reason, help } = refused(&mut document, model(file)) else { panic!("{file}") };
        assert!(reason.contains(file) && !help.is_empty(), "{reason}: {help}");
    }
    assert!(document.assets().meshes.is_empty());
}

#[test]
fn what_was_provided_is_not_read_again() {
    let (folder, mut document) = with_model();
    let mut assets = Assets::default();
    assets.meshes.insert("gone.obj".into(), Arc::default());
    document.provide(assets, vec!["it is empty".into()]);
    edit(&mut document, model("gone.obj"));
    assert_eq!(document.asset_warnings(), ["it is empty"]);
    drop(folder);
}

#[test]
fn a_model_that_was_missing_before_does_not_stop_other_edits() {
    let text = format!("{SHELF}\n[[object]]\nname = \"lost\"\nshape = \"mesh\"\nfile = \"lost.obj\"\n");
    let mut document = document_of(&text);
    let value = Value::Number(2.0);
    edit(&mut document, EditCommand::Set { things: objects(["ball"]), key: "radius".into(), value });
    assert!(matches!(refused(&mut document, model("other.obj")), EditError::File { .. }));
    edit(&mut document, EditCommand::Duplicate(objects(["lost"])));
}

#[test]
fn the_text_keeps_a_persons_remarks() {
    let mut document = shelf();
    assert_eq!(document.text(), SHELF);
    let value = Value::Number(0.75);
    edit(&mut document, EditCommand::Set { things: objects(["ball"]), key: "radius".into(), value });
    let name = "globe".to_owned();
    edit(&mut document, EditCommand::Rename { thing: Thing::object("ball"), name });
    edit(&mut document, EditCommand::Delete(objects(["pane"])));
    let text = document.text();
    for remark in
        ["# A shelf to test with.", "# the shelf", "# a bulb", "# black and white", "# the round one"]
    {
        assert!(text.contains(remark), "{remark} is gone:\n{text}");
    }
    assert!(text.contains("radius = 0.75") && text.contains("\"globe\"") && !text.contains("pane"));
    assert_eq!(SceneFile::parse(Path::new("s"), &text).unwrap().scene(), &**document.scene());
}
