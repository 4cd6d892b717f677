//! The document as whoever uses it sees it. What each edit does stands beside the edits.

mod clipboard;
mod defaults;
mod dice;
mod files;
mod history;
mod saving;

use super::*;
use vitrine::math::Vec3;
use vitrine::scene::Object;

/// A shelf with a textured ball and a box in it, a pane, a floor, a lamp and sunlight.
pub(in crate::document) const SHELF: &str = r##"# A shelf to test with.
format = 1
about = "a shelf"

[camera]
position = [0.0, 1.5, 8.0]
look_at = [0.0, 0.5, 0.0] # the shelf

[[light]]
name = "lamp" # a bulb
kind = "disc"
position = [2.0, 5.0, 3.0]
radius = 0.5

[[light]]
name = "sun"
kind = "directional"
direction = [0.0, -1.0, 0.0]

[[light]]
name = "air"
kind = "ambient"
intensity = 0.2

[[texture]]
name = "tiles"
kind = "checker"

[[material]]
name = "tiled"
texture = "tiles" # black and white
diffuse = 0.9

[[material]]
name = "glass"
transparency = 0.8

[[group]]
name = "shelf"
position = [1.0, 0.0, -1.0]
turn_deg = [0.0, 90.0, 0.0]
scale = 2.0

[[object]]
name = "floor"
shape = "plane"
material = "tiled"

[[object]]
name = "ball" # the round one
shape = "sphere"
radius = 0.5
position = [0.0, 1.0, 0.0]
material = "tiled"
group = "shelf"

[[object]]
name = "box"
shape = "box"
position = [1.0, 0.5, 0.0]
turn_deg = [0.0, 30.0, 0.0]
group = "shelf"

[[object]]
name = "pane"
shape = "triangle"
position = [-2.0, 0.0, 1.0]
material = "glass"
"##;

pub(in crate::document) fn document_of(text: &str) -> Document {
    let file = SceneFile::parse(Path::new("test"), text).unwrap();
    Document::untitled(file, Assets::default(), PathBuf::from("nowhere"))
}

/// The shelf with its ball selected.
pub(in crate::document) fn shelf() -> Document {
    let mut document = document_of(SHELF);
    document.select([Thing::object("ball")]);
    document
}

pub(in crate::document) fn object<'a>(document: &'a Document, name: &str) -> &'a Object {
    document.scene().object(name).unwrap_or_else(|| panic!("no object {name}"))
}

/// Where a point of an object is in the world.
pub(in crate::document) fn point(document: &Document, name: &str, p: Vec3) -> Vec3 {
    document.scene().world_from_object(object(document, name)).point(p)
}

pub(in crate::document) fn objects<const N: usize>(names: [&str; N]) -> Vec<Thing> {
    names.map(Thing::object).to_vec()
}

#[track_caller]
pub(in crate::document) fn assert_near(a: Vec3, b: Vec3) {
    assert!((a - b).length() < 1e-5, "{a} instead of {b}");
}

/// Makes an edit and holds undoing and redoing it against the scene and the selection before and after.
#[track_caller]
pub(in crate::document) fn edit(document: &mut Document, command: EditCommand) {
    let before = (Scene::clone(document.scene()), document.selection().clone());
    document.apply(command).unwrap();
    let after = (Scene::clone(document.scene()), document.selection().clone());
    assert_ne!(before.0, after.0, "the edit changes the scene");
    assert!(document.undo());
    assert_eq!((Scene::clone(document.scene()), document.selection().clone()), before);
    assert!(document.redo());
    assert_eq!((Scene::clone(document.scene()), document.selection().clone()), after);
    let errors = document.scene().problems().into_iter().filter(|p| p.severity == Severity::Error);
    assert_eq!(errors.count(), 0);
}

/// Gives why an edit was refused, after a look that nothing has changed.
#[track_caller]
pub(in crate::document) fn refused(document: &mut Document, command: EditCommand) -> EditError {
    let state = |d: &Document| {
        (d.scene().clone(), d.selection().clone(), d.revision(), d.is_changed(), d.history().undoable())
    };
    let before = state(document);
    let error = document.apply(command).unwrap_err();
    assert_eq!(state(document), before);
    error
}
