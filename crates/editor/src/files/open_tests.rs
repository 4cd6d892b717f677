//! Scenes good and bad, opened.

use super::*;
use crate::files::TextPlace;
use vitrine::templates::TEMPLATES;

const SCENE: &str = r#"format = 1
[[light]]
name = "lamp"
kind = "point"
[[texture]]
name = "cover"
kind = "picture"
file = "pictures/cover.png"
[[material]]
name = "covered"
texture = "cover"
[[object]]
name = "ball"
shape = "sphere"
material = "covered"
"#;

fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_scene_comes_with_what_it_names() {
    let folder = tempfile::tempdir().unwrap();
    let path = write(folder.path(), "a.vitrine.toml", SCENE);
    write(folder.path(), "pictures/cover.png", carried(Path::new("textures/globe.png")).unwrap());
    let opened = read_scene(&path).unwrap();
    assert_eq!(opened.assets.pictures[Path::new("pictures/cover.png")].size, [584, 292]);
    assert!(opened.file.warnings().is_empty(), "{:?}", opened.file.warnings());
    let seen = opened.seen.unwrap();
    assert!(!seen.differs_from(&path));
    fs::write(&path, "format = 1\n").unwrap();
    assert!(seen.differs_from(&path));
    fs::remove_file(&path).unwrap();
    assert!(!seen.differs_from(&path), "what is gone can be written anew");
}

#[test]
fn a_missing_picture_is_told_with_the_line_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = write(folder.path(), "a.vitrine.toml", SCENE);
    let problems = read_scene(&path).unwrap_err().problems();
    let [problem] = &problems[..] else { panic!("{problems:?}") };
    assert!(
        problem.message.contains("texture `cover`") && problem.message.contains("cover.png"),
        "{problem:?}"
    );
    assert!(!problem.help.is_empty());
    let place = problem.place.as_ref().unwrap();
    assert_eq!((place.line, place.text.as_str()), (8, "file = \"pictures/cover.png\""));
}

#[test]
fn a_broken_scene_is_told_with_lines_and_help() {
    let folder = tempfile::tempdir().unwrap();
    let broken = SCENE.replace("shape = \"sphere\"", "shape = \"spere\"");
    let path = write(folder.path(), "a.vitrine.toml", broken);
    let problems = read_scene(&path).unwrap_err().problems();
    let place: &TextPlace = problems[0].place.as_ref().unwrap();
    assert_eq!((place.line, place.text.as_str()), (14, "shape = \"spere\""));
    assert!(problems[0].help.contains("sphere"), "{problems:?}");
    for (name, bytes) in [("b.toml", &b"\xff\xfe"[..]), ("c.toml", b""), ("d.toml", b"[[[[")] {
        let error = read_scene(&write(folder.path(), name, bytes)).unwrap_err();
        assert!(!error.problems()[0].message.is_empty(), "{name}");
    }
    assert!(read_scene(folder.path()).is_err() && read_scene(&folder.path().join("none")).is_err());
}

#[test]
fn every_template_opens_without_a_file() {
    for template in TEMPLATES {
        let opened = read_template(template.name).unwrap();
        assert_eq!((opened.path, opened.seen), (None, None));
        assert_eq!(opened.notes, [""; 0], "{}", template.name);
    }
    assert!(read_template("none").is_err());
}

#[test]
fn own_files_go_before_those_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let file = read_template("textured-sphere").unwrap().file;
    let own = carried(Path::new("textures/vitrine-wood.png")).unwrap();
    write(folder.path(), "textures/globe.png", own);
    let mut assets = Assets::default();
    complete_assets(&mut assets, file.scene(), Some(folder.path())).unwrap();
    assert_eq!(assets.pictures[Path::new("textures/globe.png")].size, [256, 256]);
}

#[test]
fn a_model_is_read_before_it_is_added() {
    let folder = tempfile::tempdir().unwrap();
    let path = write(folder.path(), "models/cone.obj", carried(Path::new("models/cone.obj")).unwrap());
    let model = read_model(&path, Some(folder.path())).unwrap();
    assert_eq!(model.file, "models/cone.obj");
    let mesh = &model.assets.meshes[Path::new("models/cone.obj")];
    assert_eq!((mesh.triangles.len(), mesh.bounds().max.y), (160, 1.0));
    assert!(Path::new(&read_model(&path, None).unwrap().file).is_absolute());

    let broken = write(folder.path(), "broken.obj", "v 0 0 0\nv 1 zero 0\n");
    let problems = read_model(&broken, None).unwrap_err().problems();
    let place = problems[0].place.as_ref().unwrap();
    assert_eq!((place.line, place.text.as_str()), (2, "v 1 zero 0"));
    let missing = read_model(&folder.path().join("none.obj"), None).unwrap_err();
    assert!(missing.problems()[0].message.contains("none.obj"));
    assert!(read_picture(&path, None).is_err(), "a model is no picture");
}
