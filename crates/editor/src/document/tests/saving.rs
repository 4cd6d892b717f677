//! What the document takes over from the file that was written, and what counts as nothing to save.

use super::files::{model, with_model};
use super::*;
use crate::files::{SaveRequest, Saved, save};
use std::fs;
use vitrine::scene::Value;

fn radius(value: f32) -> EditCommand {
    EditCommand::Set { things: objects(["ball"]), key: "radius".into(), value: Value::Number(value) }
}

/// Writes the scene as it is now, as the window's thread does, without telling the document.
fn written(document: &Document, to: &Path) -> Saved {
    let request = SaveRequest {
        scene: document.scene().clone(),
        assets: document.assets().clone(),
        base: Some(document.file().clone()),
        folder: Some(document.folder().to_owned()),
        to: to.to_owned(),
        seen: None,
    };
    save(&request).unwrap()
}

#[test]
fn there_is_nothing_to_save_when_everything_is_as_it_was_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vitrine.toml");
    let mut document = shelf();
    document.apply(radius(2.0)).unwrap();
    assert!(document.is_changed());
    document.undo();
    assert!(!document.is_changed());
    document.redo();
    let (saved, scene) = (written(&document, &path), document.scene().clone());
    document.take_saved(path.clone(), saved, &scene);
    assert!(!document.is_changed());
    assert_eq!(document.title().as_deref(), Some("s.vitrine.toml"));
    assert_eq!((document.path(), document.folder()), (Some(path.as_path()), folder.path()));
    document.undo();
    assert!(document.is_changed());
    // By hand instead of by redoing.
    document.apply(radius(2.0)).unwrap();
    assert!(!document.is_changed());
    document.mark_unsaved();
    assert!(document.is_changed());
}

#[test]
fn what_was_edited_while_it_was_saved_is_still_to_save() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vitrine.toml");
    let mut document = shelf();
    document.apply(radius(2.0)).unwrap();
    let (saved, scene) = (written(&document, &path), document.scene().clone());
    document.apply(radius(3.0)).unwrap();
    document.take_saved(path, saved, &scene);
    assert!(document.is_changed());
    document.undo();
    assert!(!document.is_changed());
}

#[test]
fn in_another_folder_the_scene_and_its_history_name_files_anew() {
    let (old, mut document) = with_model();
    let new = tempfile::tempdir().unwrap();
    edit(&mut document, model("one.obj"));
    edit(&mut document, EditCommand::Delete(objects(["model"])));
    document.undo();
    let path = new.path().join("s.vitrine.toml");
    let (saved, scene, revision) = (written(&document, &path), document.scene().clone(), document.revision());
    document.take_saved(path, saved, &scene);
    assert_eq!(document.folder(), new.path());
    assert!(!document.is_changed() && document.revision() > revision);
    let file_of = |document: &Document| {
        let file = object(document, "model").shape.as_kind().file().unwrap();
        (file.to_owned(), document.assets().meshes.contains_key(file))
    };
    let (file, is_there) = file_of(&document);
    assert!(is_there && file != Path::new("one.obj"), "{}", file.display());
    let from_new = new.path().join(&file);
    assert_eq!(fs::canonicalize(from_new).unwrap(), fs::canonicalize(old.path().join("one.obj")).unwrap());
    // The steps before and after were noted under the old path.
    assert!(document.redo() && document.scene().object("model").is_none());
    assert!(document.undo());
    assert_eq!(file_of(&document), (file.clone(), true));
    assert!(document.undo() && document.redo());
    assert_eq!(file_of(&document), (file, true));
}

#[test]
fn what_is_given_up_is_not_to_save_until_the_next_edit() {
    let mut document = shelf();
    document.apply(radius(2.0)).unwrap();
    document.forget_changes();
    assert!(!document.is_changed());
    assert_eq!(document.history().undoable(), 1, "undoing still works");
    document.apply(radius(3.0)).unwrap();
    assert!(document.is_changed());
    document.mark_unsaved();
    document.forget_changes();
    assert!(!document.is_changed());
}
