//! Each dialog as a story, by the names that a screen reader says, in both languages; and all of them looked over: nothing
//! is clipped, everything is named.

mod support;

use eframe::egui::accesskit::Role;
use eframe::egui::{ColorImage, Key, Modifiers, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::Path;
use std::sync::Arc;
use vitrine::math::Vec3;
use vitrine::scene::{
    Light, LightSource, Material, Object, ParamSpec, Settings, Severity, Shape, TriangleMesh, Value, lights,
    shapes,
};
use vitrine_editor::action::{Action, Actions, Screen};
use vitrine_editor::dialogs::*;
use vitrine_editor::document::{Addition, Document, EditCommand, Paint, Thing};
use vitrine_editor::files::Config;
use vitrine_editor::text::{Language, param_label, set_language, tr};
use vitrine_editor::theme;

/// A window with a dialog in it.
struct World {
    language: Language,
    document: Document,
    config: Config,
    problems: Vec<ProblemLine>,
    current: Option<CurrentPicture>,
    open: Option<Dialog>,
    actions: Actions,
    replies: Vec<Reply>,
    is_dressed: bool,
}

impl World {
    fn new(language: Language) -> Self {
        set_language(language);
        Self {
            language,
            document: Document::default(),
            config: Config { language, ..Config::default() },
            problems: Vec::new(),
            current: None,
            open: None,
            actions: Vec::new(),
            replies: Vec::new(),
            is_dressed: false,
        }
    }

    fn draw(&mut self, ui: &mut Ui) {
        set_language(self.language);
        if !std::mem::replace(&mut self.is_dressed, true) {
            theme::apply(ui, &self.config);
            return;
        }
        let around = Around {
            document: &self.document,
            config: &self.config,
            problems: &self.problems,
            samples_per_second: Some(1.0e6),
            current: self.current,
        };
        let reply = dialogs_ui(ui, &mut self.open, &around, &mut self.actions);
        self.replies.extend(reply);
    }
}

fn harness(world: World) -> Harness<'static, World> {
    let builder = Harness::builder()
        .with_size(vec2(1280.0, 800.0))
        .with_max_steps(30)
        .renderer(support::CpuRenderer::default());
    let mut harness = builder.build_ui_state(|ui, world: &mut World| world.draw(ui), world);
    settle(&mut harness);
    harness
}

/// Lets the window come to rest. A preview that arrives meanwhile asks for another frame.
fn settle(harness: &mut Harness<'_, World>) {
    assert!(harness.run_ok().is_some(), "the window does not come to rest");
}

/// Types into the field of that name in place of what it held.
fn type_into(harness: &mut Harness<'_, World>, name: &str, text: &str) {
    let is_field = |role| matches!(role, Role::TextInput | Role::SpinButton | Role::NumberInput);
    let field = |harness: &Harness<'_, World>| {
        let nodes: Vec<_> = harness.query_all_by_label(name).map(|n| n.accesskit_node().role()).collect();
        let place = nodes.iter().position(|role| is_field(*role));
        place.unwrap_or_else(|| panic!("no field {name}: {nodes:?}"))
    };
    let at = field(harness);
    harness.query_all_by_label(name).nth(at).unwrap().focus();
    settle(harness);
    harness.key_combination_modifiers(Modifiers::COMMAND, &[Key::A]);
    settle(harness);
    let at = field(harness);
    harness.query_all_by_label(name).nth(at).unwrap().type_text(text);
    settle(harness);
}

fn press(harness: &mut Harness<'_, World>, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click();
    settle(harness);
}

fn both(test: impl Fn(Language)) {
    Language::ALL.into_iter().for_each(test);
}

fn label(kind: &str, specs: &'static [ParamSpec], key: &str) -> String {
    param_label(kind, specs.iter().find(|s| s.name == key).unwrap())
}

fn sphere() -> Object {
    Object { name: "Ball".into(), ..Object::default() }
}

fn add_object(language: Language, object: Object) -> Harness<'static, World> {
    let mut world = World::new(language);
    let addition = Addition { objects: vec![object], ..Addition::default() };
    let dialog = ThingDialog::add(&addition, &world.document).unwrap();
    world.open = Some(Dialog::Thing(Box::new(dialog)));
    harness(world)
}

#[test]
fn c1_a_sphere_with_the_typed_radius_is_added_and_nothing_else() {
    both(|language| {
        let mut harness = add_object(language, sphere());
        type_into(&mut harness, &label("sphere", shapes::Sphere::SPECS, "radius"), "0.5");
        press(&mut harness, &tr!("dialog-add-ok"));
        let world = harness.state();
        let shape = Shape::Sphere(shapes::Sphere { radius: 0.5 });
        let objects = vec![Object { shape, ..sphere() }];
        let addition = Addition { objects, ..Addition::default() };
        assert_eq!(world.actions, [Action::Edit(EditCommand::Add(addition))]);
        assert!(world.open.is_none());
    });
}

#[test]
fn c8_a_disc_lamp_with_typed_values_is_added_by_enter() {
    both(|language| {
        let mut world = World::new(language);
        let light = Light {
            name: "Lamp".into(),
            source: LightSource::Disc(lights::Disc::default()),
            ..Light::default()
        };
        let addition = Addition { lights: vec![light.clone()], ..Addition::default() };
        let dialog = ThingDialog::add(&addition, &world.document).unwrap();
        world.open = Some(Dialog::Thing(Box::new(dialog)));
        let mut harness = harness(world);
        type_into(&mut harness, &label("disc", lights::Disc::SPECS, "radius"), "1,5");
        harness.key_press(Key::Enter);
        settle(&mut harness);
        let disc = lights::Disc { radius: 1.5, ..lights::Disc::default() };
        let lights = vec![Light { source: LightSource::Disc(disc), ..light }];
        let addition = Addition { lights, ..Addition::default() };
        assert_eq!(harness.state().actions, [Action::Edit(EditCommand::Add(addition))]);
    });
}

#[test]
fn nonsense_keeps_the_old_value() {
    both(|language| {
        let mut harness = add_object(language, sphere());
        type_into(&mut harness, &label("sphere", shapes::Sphere::SPECS, "radius"), "a lot");
        press(&mut harness, &tr!("dialog-add-ok"));
        let addition = Addition { objects: vec![sphere()], ..Addition::default() };
        assert_eq!(harness.state().actions, [Action::Edit(EditCommand::Add(addition))]);
    });
}

#[test]
fn esc_and_cancel_change_nothing() {
    both(|language| {
        for by_key in [true, false] {
            let mut harness = add_object(language, sphere());
            type_into(&mut harness, &label("sphere", shapes::Sphere::SPECS, "radius"), "3");
            if by_key {
                harness.key_press(Key::Escape);
                settle(&mut harness);
            } else {
                press(&mut harness, &tr!("dialog-cancel"));
            }
            assert!(harness.state().open.is_none(), "by key: {by_key}");
            assert_eq!(harness.state().actions, []);
        }
    });
}

#[test]
fn the_focus_begins_in_the_first_field() {
    both(|language| {
        let harness = add_object(language, sphere());
        let name = tr!("dialog-add-name");
        let mut fields = harness.query_all_by_role_and_label(Role::TextInput, &name);
        assert!(fields.next().unwrap().is_focused());
    });
}

#[test]
fn c4_a_triangle_with_its_points_on_a_line_is_not_accepted() {
    both(|language| {
        let shape = Shape::Triangle(shapes::Triangle {
            points: [Vec3::ZERO, Vec3::X, Vec3::X * 2.0],
            ..Default::default()
        });
        let mut harness = add_object(language, Object { shape, ..sphere() });
        harness.get_by_label(&tr!("dialog-add-fault-line"));
        harness.key_press(Key::Enter);
        settle(&mut harness);
        assert!(harness.state().open.is_some());
        assert_eq!(harness.state().actions, []);
    });
}

#[test]
fn c10_c16_depth_and_threads_are_set_and_the_language_changes_at_once() {
    both(|language| {
        let mut world = World::new(language);
        let around = Around {
            document: &world.document,
            config: &world.config,
            problems: &[],
            samples_per_second: None,
            current: None,
        };
        let dialog = Dialog::of_screen(Screen::Settings, &around);
        world.open = dialog;
        let mut harness = harness(world);
        harness.get_by_role_and_label(Role::ComboBox, &tr!("dialog-settings-threads")).click();
        settle(&mut harness);
        harness.get_by_role_and_label(Role::Button, "1").click();
        settle(&mut harness);
        type_into(&mut harness, &tr!("dialog-settings-depth"), "7");
        press(&mut harness, &tr!("dialog-ok"));
        let config = Config { threads: 1, language, ..Config::default() };
        let things = vec![Thing::Settings];
        let depth = EditCommand::Set { things, key: "depth".into(), value: Value::Integer(7) };
        let wanted = [Action::Configure(Box::new(config)), Action::Edit(depth)];
        assert_eq!(harness.state().actions, wanted);
    });
}

#[test]
fn settings_are_taken_back_by_cancel() {
    both(|language| {
        let mut world = World::new(language);
        let around = Around {
            document: &world.document,
            config: &world.config,
            problems: &[],
            samples_per_second: None,
            current: None,
        };
        let dialog = Dialog::of_screen(Screen::Settings, &around);
        world.open = dialog;
        let mut harness = harness(world);
        harness.get_by_label(&tr!("dialog-settings-large-text")).click();
        settle(&mut harness);
        harness.key_press(Key::Escape);
        settle(&mut harness);
        let before = Config { language, ..Config::default() };
        let changed = Config { large_text: true, ..before.clone() };
        let wanted = [changed, before].map(|c| Action::Configure(Box::new(c)));
        assert_eq!(harness.state().actions, wanted);
    });
}

#[test]
fn a_picture_is_saved_as_it_was_asked_for() {
    both(|language| {
        let mut world = World::new(language);
        let settings = world.document.scene().settings.clone();
        let dialog = SaveDialog::new(Path::new("ball.png"), &settings, None);
        world.open = Some(Dialog::SavePicture(Box::new(dialog)));
        let mut harness = harness(world);
        type_into(&mut harness, &tr!("dialog-save-width"), "480");
        type_into(&mut harness, &tr!("dialog-save-samples"), "16");
        press(&mut harness, &tr!("dialog-save-render-ok"));
        let [Reply::SavePicture(request)] = &harness.state().replies[..] else {
            panic!("{:?}", harness.state().replies)
        };
        assert_eq!(request.path, Path::new("ball.png"));
        assert_eq!(request.settings.size, [480, 360], "the ratio is kept");
        assert_eq!(request.settings.samples, 16);
        assert_eq!(request.source, PictureSource::RenderNow);
    });
}

#[test]
fn unsaved_changes_have_three_ways_out() {
    both(|language| {
        let answer = |name: Option<&str>| {
            let mut world = World::new(language);
            let unsaved = Unsaved { name: Some("case".into()), then: Action::Quit };
            world.open = Some(Dialog::Unsaved(Box::new(unsaved)));
            let mut harness = harness(world);
            match name {
                Some(name) => press(&mut harness, &tr!(name)),
                None => {
                    harness.key_press(Key::Enter);
                    settle(&mut harness);
                }
            }
            assert!(harness.state().open.is_none());
            harness.state().replies.clone()
        };
        let quit = || Box::new(Action::Quit);
        assert_eq!(answer(None), [Reply::SaveThen(quit())], "Enter saves");
        assert_eq!(answer(Some("dialog-unsaved-save")), [Reply::SaveThen(quit())]);
        assert_eq!(answer(Some("dialog-unsaved-drop")), [Reply::DropThen(quit())]);
        assert_eq!(answer(Some("dialog-cancel")), []);
    });
}

#[test]
fn a_problem_is_mended_by_its_button_and_a_click_selects_its_thing() {
    both(|language| {
        let mut world = World::new(language);
        let command = EditCommand::SetAbout("mended".into());
        world.problems = vec![ProblemLine {
            severity: Severity::Warning,
            text: "The camera is inside Ball".into(),
            help: String::new(),
            thing: Some(Thing::object("Ball")),
            mend: Some(Mend { text: "Move it out".into(), command: command.clone() }),
        }];
        world.open = Some(Dialog::Problems);
        let mut harness = harness(world);
        press(&mut harness, &tr!("dialog-problems-fix"));
        press(&mut harness, "The camera is inside Ball");
        let select = Action::Select(vec![Thing::object("Ball")]);
        assert_eq!(harness.state().actions, [Action::Edit(command), select]);
        assert!(harness.state().open.is_some(), "the list stays");
    });
}

#[test]
fn terms_are_found_in_the_glossary() {
    both(|language| {
        let mut world = World::new(language);
        world.open = Some(Dialog::Glossary(GlossaryDialog::default()));
        let mut harness = harness(world);
        type_into(&mut harness, &tr!("help-glossary-search"), "фонг");
        harness.get_by_label("Phong model");
        harness.get_by_label("Модель Фонга");
        assert!(harness.query_by_label("Ray casting").is_none());
    });
}

#[test]
fn an_error_shows_line_and_help_and_copies_itself() {
    both(|language| {
        let mut world = World::new(language);
        let mut report = ErrorReport::new(Failure::Scene, "unknown key `raduis`", "did you mean `radius`?");
        let (text, mark) = ("raduis = 2".to_owned(), 0..6);
        let (message, help) = (String::new(), String::new());
        report.lines = vec![BadLine { number: 12, text, mark, message, help }];
        world.open = Some(Dialog::Error(Box::new(report)));
        let mut harness = harness(world);
        harness.get_by_label("Unknown key `raduis`.");
        harness.get_by_label("Did you mean `radius`?");
        harness.get_by_label(&tr!("dialog-error-line", line = 12));
        harness.get_by_role_and_label(Role::Button, &tr!("dialog-copy")).click();
        settle(&mut harness);
        harness.get_by_label(&tr!("dialog-copied"));
    });
}

/// Does to the document what was asked for.
fn carry_out(world: &mut World) {
    for action in std::mem::take(&mut world.actions) {
        match action {
            Action::Edit(command) => world.document.apply(command).unwrap(),
            Action::Drag(command, gesture) => world.document.drag(command, gesture).unwrap(),
            Action::Select(things) => world.document.select(things),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn c14_edit_changes_a_thing_and_its_name_in_one_step_that_can_be_undone() {
    both(|language| {
        let mut world = World::new(language);
        let addition = Addition { objects: vec![sphere()], ..Addition::default() };
        world.document.apply(EditCommand::Add(addition)).unwrap();
        let before = world.document.scene().clone();
        let dialog = ThingDialog::edit(&Thing::object("Ball"), &world.document).unwrap();
        world.open = Some(Dialog::Thing(Box::new(dialog)));
        let mut harness = harness(world);
        type_into(&mut harness, &label("sphere", shapes::Sphere::SPECS, "radius"), "2");
        type_into(&mut harness, &tr!("dialog-add-name"), "Globe");
        press(&mut harness, &tr!("dialog-edit-ok"));
        let world = harness.state_mut();
        carry_out(world);
        let globe = world.document.scene().object("Globe").unwrap();
        assert_eq!(globe.shape, Shape::Sphere(shapes::Sphere { radius: 2.0 }));
        assert!(world.document.undo());
        assert_eq!(*world.document.scene(), before, "one step");
    });
}

#[test]
fn the_tour_goes_on_when_a_step_has_really_been_done() {
    use vitrine_editor::dialogs::tour::{Tour, TourFacts};
    let mut document = Document::default();
    let mut tour = Tour::begin(&document);
    let look = |tour: &mut Tour, document: &Document, is_rendered, is_saved| {
        tour.look(&TourFacts { document, is_rendered, is_saved });
        tour.step().map(|s| s.word)
    };
    assert_eq!(look(&mut tour, &document, true, true), Some("add"), "later steps wait for the first");
    document.apply(EditCommand::Add(Addition { objects: vec![sphere()], ..Addition::default() })).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("paint"));
    let red = Material {
        name: "Red glass".into(),
        color: Some(vitrine::math::Rgb::new(0.8, 0.05, 0.05)),
        transparency: Some(0.8),
        ..Material::default()
    };
    let blue = Material { color: Some(vitrine::math::Rgb::new(0.05, 0.05, 0.8)), ..red.clone() };
    let paint = |material| EditCommand::Paint {
        things: vec![Thing::object("Ball")],
        material: Box::new(Paint { material, texture: None }),
    };
    document.apply(paint(blue)).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("paint"), "blue glass is not red");
    document.apply(paint(red)).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("move"));
    document.apply(EditCommand::Move { things: vec![Thing::object("Ball")], by: Vec3::X }).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("render"));
    assert_eq!(look(&mut tour, &document, true, false), Some("save"));
    assert_eq!(look(&mut tour, &document, true, true), None);
}

#[test]
fn the_card_of_the_tour_is_whole_in_both_languages_and_can_be_closed() {
    use vitrine_editor::dialogs::tour::{self, Tour, TourFacts};
    both(|language| {
        let world = World::new(language);
        let tour = Some(Tour::begin(&world.document));
        let builder =
            Harness::builder().with_size(vec2(1280.0, 800.0)).renderer(support::CpuRenderer::default());
        let mut is_dressed = false;
        let draw = move |ui: &mut Ui, (world, tour): &mut (World, Option<Tour>)| {
            if !std::mem::replace(&mut is_dressed, true) {
                theme::apply(ui, &world.config);
                return;
            }
            let response = ui.button("Sphere");
            tour::mark(ui, "add-sphere", response.rect);
            let facts = TourFacts { document: &world.document, is_rendered: false, is_saved: false };
            tour_ui(ui, tour, &facts, &world.config, &mut world.actions);
        };
        let mut harness = builder.build_ui_state(draw, (world, tour));
        harness.run();
        harness.get_by_label(&tr!("tour-add"));
        if std::env::var_os("VITRINE_PICTURES").is_some() {
            support::picture(&mut harness, &format!("tour-{}", language.tag()));
        }
        assert_eq!(support::labels_clipped(&harness), [""; 0]);
        for _ in tour::STEPS {
            harness.get_by_role_and_label(Role::Button, &tr!("tour-skip")).click();
            harness.run();
            assert_eq!(support::labels_clipped(&harness), [""; 0]);
        }
        harness.get_by_role_and_label(Role::Button, &tr!("tour-finish")).click();
        harness.run();
        let config = Config { language, tour_seen: true, ..Config::default() };
        assert_eq!(harness.state().0.actions, [Action::Configure(Box::new(config))]);
        assert!(harness.state().1.is_none());
    });
}

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
    Dialog::Thing(Box::new(ThingDialog::add(addition, &world.document).unwrap()))
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
    let around = Around {
        document: &world.document,
        config: &world.config,
        problems: &[],
        samples_per_second: None,
        current: None,
    };
    let screen = |screen| Dialog::of_screen(screen, &around).unwrap();
    let settings = Settings::default();
    let save = SaveDialog::new(Path::new("ball.png"), &settings, None);
    let current = Some(CurrentPicture { size: [960, 720], samples: 24 });
    let save_current = SaveDialog::new(Path::new("ball.png"), &settings, current);
    let unsaved = Unsaved { name: Some("display-case".into()), then: Action::Quit };
    let picture = ColorImage::filled([160, 120], theme::Theme::of_config(&world.config).accent);
    let recovery = Recovery::new("x".into(), "display-case".into(), "3 min".into(), Some(picture));
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
        ("recover", Dialog::Recover(Box::new(recovery))),
        ("changed", Dialog::Changed(changed)),
        ("error", Dialog::Error(Box::new(report()))),
        ("problems", Dialog::Problems),
        ("shortcuts", Dialog::Shortcuts),
        ("glossary", screen(Screen::Glossary)),
        ("about", Dialog::About),
    ]
}

/// Whether a picture is wanted, for a look by eye: VITRINE_PICTURES is a part of its name.
fn is_pictured(name: &str) -> bool {
    std::env::var("VITRINE_PICTURES").is_ok_and(|part| name.contains(&part))
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
        if is_pictured(&name) {
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
