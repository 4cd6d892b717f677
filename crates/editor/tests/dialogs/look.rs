//! All dialogs looked over: nothing is clipped, everything is named.

use crate::support;
use crate::world::*;
use std::path::Path;
use std::sync::Arc;
use vitrine::math::Vec3;
use vitrine::scene::{
    Light, LightSource, Material, Object, Settings, Severity, Shape, TriangleMesh, lights, shapes,
};
use vitrine_editor::action::{Action, Screen};
use vitrine_editor::dialogs::*;
use vitrine_editor::document::{Addition, EditCommand, Thing};
use vitrine_editor::text::Language;

/// A tetrahedron.
fn loaded_model() -> LoadedModel {
    let positions =
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 2.0], [1.0, 2.0, 0.7]].map(Vec3::from_array);
    let triangles = vec![[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let mesh = TriangleMesh { positions: positions.to_vec(), triangles, ..TriangleMesh::default() };
    let remarks = vec!["12 faces have no normal, theirs were computed: models/roof.obj".to_owned()];
    LoadedModel { path: "models/roof.obj".into(), mesh: Arc::new(mesh), remarks }
}

fn thing(world: &World, addition: &Addition) -> Dialog {
    Dialog::Thing(Box::new(ThingDialog::add(addition, &world.document).expect("it adds a thing")))
}

fn object(shape: Shape) -> Addition {
    let material = Material { name: "Red".into(), ..Material::default() };
    let object = Object { shape, material: Some("Red".into()), name: "Ball".into(), ..Object::default() };
    Addition { objects: vec![object], materials: vec![material], ..Addition::default() }
}

fn light(source: LightSource) -> Addition {
    let light = Light { source, name: "Lamp".into(), ..Light::default() };
    Addition { lights: vec![light], ..Addition::default() }
}

fn report() -> ErrorReport {
    let help = "did you mean `radius`?";
    let mut report = ErrorReport::new(Failure::Scene, "unknown key `raduis`", help);
    report.path = Some("/home/anna/scenes/ball.vitrine.toml".into());
    let (text, mark) = ("raduis = 2.0   # from the centre to the surface".to_owned(), 0..6);
    report.lines = vec![BadLine { number: 12, text, mark, message: String::new(), help: String::new() }];
    report
}

fn problems() -> Vec<ProblemLine> {
    let line = |severity, text: &str, help: &str| ProblemLine {
        severity,
        text: text.into(),
        help: help.into(),
        thing: Some(Thing::object("Ball")),
        mend: Some(Mend { text: "…".into(), command: EditCommand::SetAbout("…".into()) }),
    };
    vec![
        line(
            Severity::Error,
            "Нет материала «стекло» / There is no material “glass”",
            "Did you mean “glass 2”?",
        ),
        line(
            Severity::Warning,
            "The camera is inside Ball",
            "Move the camera out, unless the view from inside is meant",
        ),
    ]
}

/// Every dialog, with a word for its picture.
fn all_dialogs(world: &World) -> Vec<(&'static str, Dialog)> {
    let screen = |screen| Dialog::of_screen(screen, &world.around()).expect("it is a dialog");
    let settings = Settings::default();
    let save = SaveDialog::new(Path::new("ball.png"), &settings, None);
    let current = Some(CurrentPicture { size: [960, 720], samples: 24 });
    let save_current = SaveDialog::new(Path::new("ball.png"), &settings, current);
    let unsaved = Unsaved { name: Some("display-case".into()), then: Action::Quit };
    let changed = Changed { path: "display-case.vitrine.toml".into(), is_unsaved: true };
    vec![
        ("sphere", thing(world, &object(Shape::Sphere(shapes::Sphere::default())))),
        ("box", thing(world, &object(Shape::Box(shapes::Cuboid::default())))),
        ("plane", thing(world, &object(Shape::Plane(shapes::Plane::default())))),
        ("triangle", thing(world, &object(Shape::Triangle(shapes::Triangle::default())))),
        ("ambient", thing(world, &light(LightSource::Ambient(lights::Ambient::default())))),
        ("point", thing(world, &light(LightSource::Point(lights::Point::default())))),
        ("directional", thing(world, &light(LightSource::Directional(lights::Directional::default())))),
        ("disc", thing(world, &light(LightSource::Disc(lights::Disc::default())))),
        ("model", Dialog::Model(Box::new(ModelDialog::add(loaded_model(), &world.document)))),
        ("save", Dialog::SavePicture(Box::new(save))),
        ("save-current", Dialog::SavePicture(Box::new(save_current))),
        ("settings", screen(Screen::Settings)),
        ("unsaved", Dialog::Unsaved(Box::new(unsaved))),
        ("changed", Dialog::Changed(changed)),
        ("error", Dialog::Error(Box::new(report()))),
        ("problems", Dialog::Problems),
        ("shortcuts", Dialog::Shortcuts),
        ("glossary", screen(Screen::Glossary)),
        ("about", Dialog::About),
    ]
}

/// Looks at every dialog in a language and a size of text. The pictures lie in target/tmp.
fn look_over(language: Language, large_text: bool) {
    let count = all_dialogs(&World::new(language)).len();
    for i in 0..count {
        let mut world = World::new(language);
        world.config.large_text = large_text;
        let (name, dialog) = all_dialogs(&world).swap_remove(i);
        world.problems = problems();
        world.current = (name == "save-current").then_some(CurrentPicture { size: [960, 720], samples: 24 });
        world.open = Some(dialog);
        let mut harness = harness(world);
        let size = if large_text { "-large" } else { "" };
        let name = format!("dialog-{name}-{}{size}", language.tag());
        if support::is_pictured(&name) {
            // Previews are made on threads of their own.
            std::thread::sleep(std::time::Duration::from_millis(500));
            settle(&mut harness);
            support::picture(&mut harness, &name);
        }
        assert_eq!(support::labels_clipped(&harness), [""; 0], "{name}");
        assert_eq!(support::controls_without_name_or_tooltip(&harness), [""; 0], "{name}");
    }
}

#[test]
fn nothing_is_clipped_and_everything_is_named_in_english() {
    look_over(Language::English, false);
}

#[test]
fn nothing_is_clipped_and_everything_is_named_in_russian() {
    look_over(Language::Russian, false);
}

#[test]
fn nothing_is_clipped_and_everything_is_named_with_large_text() {
    look_over(Language::Russian, true);
}
