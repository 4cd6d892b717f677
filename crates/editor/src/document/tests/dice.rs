//! Edits at random: all undone the first scene is back, all redone the last, and nothing invalid ever comes in.

use super::*;
use proptest::prelude::*;
use vitrine::math::{Axis, Rgb};
use vitrine::scene::{ListName, Material, Texture, Value};

/// Things that are there, that come to be there, and one that never is.
fn thing() -> impl Strategy<Value = Thing> {
    let names = ["ball", "ball 2", "box", "pane", "floor", "shelf", "group", "lamp", "sun", "tiled", "glass"];
    let name = prop::sample::select(names.to_vec());
    prop_oneof![
        1 => Just(Thing::Camera),
        1 => Just(Thing::Settings),
        1 => Just(Thing::object("never")),
        20 => (prop::sample::select(ListName::ALL.to_vec()), name).prop_map(|(l, n)| Thing::Item(l, n.into())),
        20 => prop::sample::select(vec!["ball", "box", "pane", "floor"]).prop_map(Thing::object),
        5 => Just(Thing::group("shelf")),
    ]
}

fn things() -> impl Strategy<Value = Vec<Thing>> {
    prop::collection::vec(thing(), 1..4)
}

fn vector() -> impl Strategy<Value = Vec3> {
    (-3.0_f32..3.0, -3.0_f32..3.0, -3.0_f32..3.0).prop_map(Vec3::from)
}

fn value() -> impl Strategy<Value = (String, Value)> {
    prop_oneof![
        (-1.0_f32..3.0).prop_map(|v| ("radius".into(), Value::Number(v))),
        (-0.5_f32..1.5).prop_map(|v| ("transparency".into(), Value::Number(v))),
        vector().prop_map(|v| ("position".into(), Value::Vector(v))),
        vector().prop_map(|v| ("turn_deg".into(), Value::Vector(v * 60.0))),
        vector().prop_map(|v| ("scale".into(), Value::Vector(v))),
        Just(("material".into(), Value::Text("glass".into()))),
        Just(("material".into(), Value::Nothing)),
        Just(("group".into(), Value::Text("shelf".into()))),
        Just(("texture".into(), Value::Text("nowhere".into()))),
    ]
}

fn camera_move() -> impl Strategy<Value = CameraMove> {
    prop_oneof![
        (vector(), -200.0_f32..200.0, -100.0_f32..100.0)
            .prop_map(|(around, right_deg, up_deg)| CameraMove::Orbit { around, right_deg, up_deg }),
        (-2.0_f32..2.0, -2.0_f32..2.0).prop_map(|(right, up)| CameraMove::Pan { right, up }),
        (vector(), -0.5_f32..4.0).prop_map(|(toward, factor)| CameraMove::Zoom { toward, factor }),
        (-200.0_f32..200.0).prop_map(|angle_deg| CameraMove::Turn { axis: Axis::Z, angle_deg }),
        vector().prop_map(CameraMove::LookAt),
        (vector(), -0.1_f32..4.0).prop_map(|(center, radius)| CameraMove::Frame { center, radius }),
    ]
}

fn paint() -> impl Strategy<Value = Box<Paint>> {
    (0..3_u8, any::<bool>()).prop_map(|(shade, has_texture)| {
        let texture =
            has_texture.then(|| Texture { name: "tiles".into(), repeat: [2.0, 2.0], ..Texture::default() });
        Box::new(Paint {
            material: Material {
                name: "glass".into(),
                color: Some(Rgb::splat(f32::from(shade))),
                texture: texture.as_ref().map(|t| t.name.clone()),
                ..Material::default()
            },
            texture,
        })
    })
}

fn command() -> impl Strategy<Value = EditCommand> {
    let axis = prop::sample::select(vec![Axis::X, Axis::Y, Axis::Z]);
    let kinds = vec!["sphere", "box", "plane", "triangle", "mesh", "disc", "point", "checker", "cone"];
    let words = vec!["ball", "box", "new", "new 2", "", " ", "шар"];
    prop_oneof![
        (things(), value()).prop_map(|(things, (key, value))| EditCommand::Set { things, key, value }),
        (thing(), prop::sample::select(kinds))
            .prop_map(|(thing, kind)| EditCommand::SetKind { thing, kind: kind.into() }),
        (thing(), prop::sample::select(words))
            .prop_map(|(thing, name)| EditCommand::Rename { thing, name: name.into() }),
        prop::sample::select(vec!["one", "two"]).prop_map(|t| EditCommand::SetAbout(t.into())),
        things().prop_map(EditCommand::Delete),
        things().prop_map(EditCommand::Duplicate),
        things().prop_map(|t| EditCommand::Paste(copy(shelf().scene(), &t))),
        things().prop_map(EditCommand::Group),
        things().prop_map(EditCommand::Ungroup),
        (things(), any::<bool>()).prop_map(|(things, visible)| EditCommand::Show { things, visible }),
        (things(), vector()).prop_map(|(things, by)| EditCommand::Move { things, by }),
        (things(), axis, -200.0_f32..200.0).prop_map(|(things, axis, angle_deg)| EditCommand::Turn {
            things,
            axis,
            angle_deg
        }),
        (things(), vector()).prop_map(|(things, by)| EditCommand::Resize { things, by }),
        things().prop_map(EditCommand::DropToFloor),
        (things(), paint()).prop_map(|(things, material)| EditCommand::Paint { things, material }),
        camera_move().prop_map(EditCommand::Camera),
        (vector(), things()).prop_map(|(by, things)| EditCommand::Several(vec![
            EditCommand::Move { things: things.clone(), by },
            EditCommand::Duplicate(things),
        ])),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_edits_can_be_undone_and_redone(
        steps in prop::collection::vec((command(), prop::option::of(0..3_u64)), 1..40)
    ) {
        let mut document = shelf();
        let first = (document.scene().clone(), document.selection().clone());
        for (command, gesture) in steps {
            let before = (document.scene().clone(), document.selection().clone());
            let outcome = match gesture {
                Some(gesture) => document.drag(command, gesture),
                None => document.apply(command),
            };
            if outcome.is_err() {
                prop_assert_eq!(&before, &(document.scene().clone(), document.selection().clone()));
            }
            let problems = document.scene().problems();
            prop_assert!(problems.iter().all(|p| p.severity == Severity::Warning), "{:?}", problems);
            let mut things = document.selection().things().iter();
            prop_assert!(things.all(|t| t.owner(document.scene()).is_some()));
        }
        let last = document.scene().clone();
        let steps = document.history().undoable();
        while document.undo() {}
        prop_assert_eq!(document.scene(), &first.0);
        prop_assert!(!document.is_changed());
        if steps > 0 {
            prop_assert!(document.selection().things().iter().all(|t| t.owner(document.scene()).is_some()));
        }
        while document.redo() {}
        prop_assert_eq!(document.scene(), &last);
        // What is written can be read again.
        let text = document.text();
        let file = SceneFile::parse(Path::new("dice"), &text);
        prop_assert!(file.is_ok(), "{:?}\n{}", file.err(), text);
        let read = file.unwrap().into_scene();
        prop_assert_eq!(&read, &*last);
    }
}
