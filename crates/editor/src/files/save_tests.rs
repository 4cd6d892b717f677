//! Scenes saved, saved elsewhere, and refused.

use super::*;
use crate::files::{Opened, read_scene, read_template};

fn request(opened: Opened, to: &Path) -> SaveRequest {
    let folder = opened.path.as_deref().and_then(Path::parent).map(Path::to_owned);
    SaveRequest {
        scene: Arc::new(opened.file.scene().clone()),
        assets: Arc::new(opened.assets),
        base: Some(opened.file),
        folder,
        to: to.to_owned(),
        seen: opened.seen,
    }
}

fn names_in(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

#[test]
fn a_template_is_saved_with_its_files_and_opens_again() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("mine.vitrine.toml");
    let saved = save(&request(read_template("display-case").unwrap(), &to)).unwrap();
    assert_eq!(saved.moved, []);
    assert_eq!(names_in(folder.path()), ["mine.vitrine.toml", "models", "textures"]);
    let opened = read_scene(&to).unwrap();
    assert_eq!(opened.file.scene(), saved.file.scene());
    assert!(opened.file.text().contains("# A museum's display case."), "remarks are kept");
    assert!(!saved.seen.differs_from(&to));
}

#[test]
fn the_version_before_is_kept_once() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("a.vitrine.toml");
    let first = save(&request(read_template("empty").unwrap(), &to)).unwrap();
    let before = fs::read_to_string(&to).unwrap();
    save(&request(read_scene(&to).unwrap(), &to)).unwrap();
    assert_eq!(names_in(folder.path()), ["a.vitrine.toml"], "nothing has changed");
    let mut changed = request(read_scene(&to).unwrap(), &to);
    Arc::make_mut(&mut changed.scene).about = "Otherwise".into();
    save(&changed).unwrap();
    assert_eq!(names_in(folder.path()), ["a.vitrine.toml", "a.vitrine.toml.bak"]);
    assert_eq!(fs::read_to_string(folder.path().join("a.vitrine.toml.bak")).unwrap(), before);
    assert!(first.seen.differs_from(&to));
}

#[test]
fn saving_elsewhere_leads_to_the_same_files() {
    let root = tempfile::tempdir().unwrap();
    let [here, there] = ["here", "deep/there"].map(|name| root.path().join(name));
    for folder in [&here, &there] {
        fs::create_dir_all(folder).unwrap();
    }
    let first = here.join("a.vitrine.toml");
    save(&request(read_template("soft-shadows").unwrap(), &first)).unwrap();
    let second = there.join("b.vitrine.toml");
    let mut elsewhere = request(read_scene(&first).unwrap(), &second);
    elsewhere.seen = None;
    let saved = save(&elsewhere).unwrap();
    let (old, new) = ("models/cone-160.obj", "../../here/models/cone-160.obj");
    assert_eq!(saved.moved, [(old.to_owned(), new.to_owned())]);
    assert!(
        saved.assets.meshes.contains_key(Path::new(new)) && saved.assets.meshes.contains_key(Path::new(old))
    );
    assert_eq!(names_in(&there), ["b.vitrine.toml"], "nothing is copied");
    let opened = read_scene(&second).unwrap();
    assert!(vitrine::render::compile(opened.file.scene(), &opened.assets).is_ok());
}

#[test]
fn a_file_of_the_person_is_not_overwritten_by_one_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("textures")).unwrap();
    fs::write(folder.path().join("textures/globe.png"), "the person's own").unwrap();
    let to = folder.path().join("a.vitrine.toml");
    let saved = save(&request(read_template("textured-sphere").unwrap(), &to)).unwrap();
    assert_eq!(saved.moved, [("textures/globe.png".to_owned(), "textures/globe-2.png".to_owned())]);
    assert_eq!(fs::read(folder.path().join("textures/globe.png")).unwrap(), b"the person's own");
    assert!(read_scene(&to).is_ok());
}

#[test]
fn a_change_by_another_program_is_noticed_and_can_be_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("a.vitrine.toml");
    save(&request(read_template("empty").unwrap(), &to)).unwrap();
    let mut mine = request(read_scene(&to).unwrap(), &to);
    fs::write(&to, "format = 1\nabout = \"theirs\"\n").unwrap();
    let refused = save(&mine).unwrap_err();
    assert!(matches!(&refused, SaveError::ChangedOnDisc { .. }), "{refused}");
    assert!(!refused.words().1.is_empty());
    assert!(fs::read_to_string(&to).unwrap().contains("theirs"));
    mine.seen = None;
    save(&mine).unwrap();
    assert!(!fs::read_to_string(&to).unwrap().contains("theirs"));
    assert!(fs::read_to_string(folder.path().join("a.vitrine.toml.bak")).unwrap().contains("theirs"));
}

#[test]
fn what_could_not_be_read_again_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("a.vitrine.toml");
    let mut request = request(read_template("empty").unwrap(), &to);
    Arc::make_mut(&mut request.scene).objects[0].material = Some("none".into());
    let refused = save(&request).unwrap_err();
    assert!(matches!(&refused, SaveError::Unsound(_)), "{refused}");
    assert!(!to.exists());
}

#[test]
fn a_folder_that_is_missing_or_a_file_in_its_place_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "").unwrap();
    for place in ["none/a.vitrine.toml", "file/a.vitrine.toml"] {
        let refused = save(&request(read_template("empty").unwrap(), &folder.path().join(place)));
        assert!(matches!(refused, Err(SaveError::Format(_))), "{place}");
    }
}

#[test]
fn a_scene_begun_from_nothing_is_saved_too() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("a.vitrine.toml");
    let mut from_nothing = request(read_template("glass-ball").unwrap(), &to);
    from_nothing.base = None;
    save(&from_nothing).unwrap();
    assert_eq!(read_scene(&to).unwrap().file.scene(), &*from_nothing.scene);
}
