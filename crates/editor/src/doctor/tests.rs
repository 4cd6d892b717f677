//! Each illness is found, and its mend cures it.

use super::*;
use crate::document::Document;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::SceneFile;
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::shapes::Mesh;
use vitrine::scene::{Assets, Material, Object, Scene, Shape, TriangleMesh};

const HEALTHY: &str = r#"format = 1
[camera]
position = [0.0, 1.0, 6.0]
look_at = [0.0, 0.5, 0.0]
[[light]]
name = "lamp"
kind = "point"
position = [2.0, 4.0, 3.0]
[[object]]
name = "ground"
shape = "plane"
[[object]]
name = "ball"
shape = "sphere"
radius = 0.5
position = [0.0, 0.5, 0.0]
"#;

fn ill(changes: &[(&str, &str)]) -> Document {
    let text = changes.iter().fold(HEALTHY.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    let file = SceneFile::parse(Path::new("test"), &text).unwrap();
    Document::untitled(file, Assets::default(), PathBuf::new())
}

/// The illness is found first, and after its mend nothing is.
#[track_caller]
fn is_cured(document: &mut Document, picture: Option<Brightness>, key: &str) {
    let found = diagnose(document, picture);
    assert_eq!(found.first().map(|d| d.message.key), Some(key), "{found:?}");
    assert!(found[0].things.iter().all(|t| t.owner(document.scene()).is_some()));
    document.apply(found[0].mend.clone()).unwrap();
    assert_eq!(diagnose(document, Some(Brightness::default())), []);
    assert_eq!(diagnose(document, None), []);
    document.undo();
    assert!(!document.is_changed(), "one step");
}

#[test]
fn a_healthy_scene_has_none() {
    assert_eq!(diagnose(&ill(&[]), None), []);
    assert_eq!(problems(&ill(&[])), []);
}

#[test]
fn darkness() {
    let no_lamp = HEALTHY.find("[[light]]").unwrap()..HEALTHY.find("[[object]]").unwrap();
    is_cured(&mut ill(&[(&HEALTHY[no_lamp], "")]), None, "doctor-no-light");
    let kind = "kind = \"point\"";
    is_cured(&mut ill(&[(kind, "kind = \"point\"\nvisible = false")]), None, "doctor-lights-off");
    is_cured(&mut ill(&[(kind, "kind = \"point\"\nintensity = 0.0")]), None, "doctor-lights-zero");
    is_cured(&mut ill(&[(kind, "kind = \"point\"\ncolor = \"#000000\"")]), None, "doctor-lights-zero");
    is_cured(&mut ill(&[(kind, "kind = \"point\"\nintensity = 0.001")]), None, "doctor-too-dark");
}

#[test]
fn glare() {
    let bright =
        |intensity: &str| ill(&[("kind = \"point\"", &format!("kind = \"point\"\nintensity = {intensity}"))]);
    is_cured(&mut bright("40.0"), None, "doctor-too-bright");
    let white = Brightness { white: 0.8, ..Brightness::default() };
    is_cured(&mut bright("2.0"), Some(white), "doctor-too-bright");
    assert_eq!(diagnose(&bright("2.0"), Some(Brightness { white: 0.1, ..white })), []);
}

#[test]
fn emptiness() {
    let objects = &HEALTHY[HEALTHY.find("[[object]]").unwrap()..];
    is_cured(&mut ill(&[(objects, "")]), None, "doctor-no-object");
    let hidden = [
        ("shape = \"plane\"", "shape = \"plane\"\nvisible = false"),
        ("radius = 0.5", "radius = 0.5\nvisible = false"),
    ];
    is_cured(&mut ill(&hidden), None, "doctor-all-hidden");
}

#[test]
fn a_camera_in_the_wrong_place() {
    let at = |position: &str, target: &str| {
        ill(&[("[0.0, 1.0, 6.0]", position), ("look_at = [0.0, 0.5, 0.0]", target)])
    };
    is_cured(&mut at("[0.1, 0.6, 0.1]", "look_at = [5.0, 0.7, 3.0]"), None, "doctor-camera-inside");
    is_cured(&mut at("[0.0, -1.0, 6.0]", "look_at = [0.0, 0.5, 0.0]"), None, "doctor-camera-under");
    is_cured(&mut at("[0.0, 1.0, 6.0]", "look_at = [0.0, 1.0, 20.0]"), None, "doctor-all-behind");
    is_cured(&mut at("[0.0, 1.0, 6.0]", "look_at = [30.0, 1.0, 5.0]"), None, "doctor-nothing-in-view");
    is_cured(&mut at("[0.0, 0.5, 0.502]", "look_at = [0.0, 0.5, 0.0]"), None, "doctor-camera-too-near");
    let ground = &HEALTHY[HEALTHY.find("[[object]]").unwrap()..HEALTHY.rfind("[[object]]").unwrap()];
    let far = &mut ill(&[("[0.0, 1.0, 6.0]", "[0.0, 1.0, 6000.0]"), (ground, "")]);
    is_cured(far, None, "doctor-camera-too-far");
}

#[test]
fn planes_alone_out_of_view() {
    let ball = &HEALTHY[HEALTHY.rfind("[[object]]").unwrap()..];
    let mut document = ill(&[(ball, ""), ("look_at = [0.0, 0.5, 0.0]", "look_at = [0.0, 5.0, 0.0]")]);
    assert_eq!(diagnose(&document, None), []);
    let empty = Brightness { background: 1.0, ..Brightness::default() };
    is_cured(&mut document, Some(empty), "doctor-nothing-in-view");
}

#[test]
fn inside_glass_may_be_meant_and_is_a_line_of_the_list() {
    let glass = "[[material]]\nname = \"glass\"\ntransparency = 0.9\n[[object]]";
    let document = ill(&[
        ("[[object]]", glass),
        ("radius = 0.5", "radius = 0.5\nmaterial = \"glass\""),
        ("[0.0, 1.0, 6.0]", "[0.1, 0.6, 0.1]"),
        ("look_at = [0.0, 0.5, 0.0]", "look_at = [5.0, 0.7, 3.0]"),
    ]);
    assert_eq!(diagnose(&document, None), []);
    let lines = problems(&document);
    assert_eq!(lines.iter().map(|l| l.message.key).collect::<Vec<_>>(), ["problem-camera-inside"]);
    assert_eq!(lines[0].things, [Thing::object("ball")]);
}

/// A tetrahedron with the corner that is given, or without its last face.
fn tetrahedron(faces: usize) -> TriangleMesh {
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::ZERO, -Vec3::ZERO];
    // Corners 4 and 5 are where corner 0 is.
    let triangles = [[0, 2, 1], [4, 1, 3], [5, 3, 2], [1, 2, 3]][..faces].to_vec();
    TriangleMesh { positions, triangles, ..TriangleMesh::default() }
}

fn with_model(mesh: TriangleMesh, transparency: f32) -> Document {
    let mut scene = Scene::clone(ill(&[]).scene());
    let shape = Shape::Mesh(Mesh { file: "m.obj".into(), ..Mesh::default() });
    let material = Some("m".to_owned());
    scene.objects.push(Object { name: "model".into(), shape, material, ..Object::default() });
    let transparency = Some(transparency);
    scene.materials.push(Material { name: "m".into(), transparency, ..Material::default() });
    let text = vitrine::formats::scene_file::print_new(&scene);
    let file = SceneFile::parse(Path::new("test"), &text).unwrap();
    let mut assets = Assets::default();
    assets.meshes.insert("m.obj".into(), Arc::new(mesh));
    Document::untitled(file, assets, PathBuf::new())
}

#[test]
fn an_open_model_of_glass_is_a_problem_and_a_closed_one_is_none() {
    let keys = |d: &Document| problems(d).iter().map(|l| l.message.key).collect::<Vec<_>>();
    assert_eq!(keys(&with_model(tetrahedron(3), 0.5)), ["problem-open-model"]);
    assert_eq!(keys(&with_model(tetrahedron(4), 0.5)), [""; 0]);
    assert_eq!(keys(&with_model(tetrahedron(3), 0.0)), [""; 0]);
}

#[test]
fn a_camera_in_a_model_is_inside_only_where_the_model_is() {
    for (position, is_inside) in [([0.1, 0.1, 0.1], true), ([0.6, 0.6, 0.6], false), ([0.2, 0.3, 0.3], true)]
    {
        let mut document = with_model(tetrahedron(4), 0.0);
        let value = vitrine::scene::Value::Vector(Vec3::from(position));
        let key = "position".into();
        document.apply(EditCommand::Set { things: vec![Thing::Camera], key, value }).unwrap();
        let found = diagnose(&document, None);
        let inside = found.iter().any(|d| d.things.contains(&Thing::object("model")));
        assert_eq!(inside, is_inside, "{position:?}: {found:?}");
    }
}

#[test]
fn missing_files_and_warnings_of_models_are_lines() {
    let mut document = with_model(tetrahedron(4), 0.0);
    document.provide(Assets::default(), vec!["model m.obj: no normals".into()]);
    let keys: Vec<_> = problems(&document).iter().map(|l| l.message.key).collect();
    assert_eq!(keys, ["problem-asset"]);
    let text = document.text();
    let file = SceneFile::parse(Path::new("test"), &text).unwrap();
    let without = Document::untitled(file, Assets::default(), PathBuf::new());
    let lines = problems(&without);
    assert_eq!(lines[0].message, Message::new("problem-missing-model").with("path", "m.obj"));
    assert_eq!(lines[0].things, [Thing::object("model")]);
}

#[test]
fn shares_of_black_white_and_background_are_counted_as_shown() {
    let settings = Settings { background: Rgb::splat(0.5), ..Settings::default() };
    // Mid grey is 188 on a screen; one step of rounding is forgiven.
    let shown = [
        [0, 0, 0],
        [4, 4, 4],
        [5, 0, 0],
        [255, 255, 255],
        [252, 252, 252],
        [188, 188, 187],
        [188, 188, 180],
        [128; 3],
    ];
    let rgba: Vec<u8> = shown.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]).collect();
    let wanted = Brightness { black: 2.0 / 8.0, white: 2.0 / 8.0, background: 1.0 / 8.0 };
    assert_eq!(Brightness::of(&rgba, &settings), wanted);
    assert_eq!(Brightness::of(&[], &settings), Brightness::default());
}
