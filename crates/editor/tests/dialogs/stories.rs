//! Each dialog as a story, in both languages.

use crate::world::*;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::path::Path;
use vitrine::math::Vec3;
use vitrine::scene::{Light, LightSource, Object, Severity, Shape, Value, lights, shapes};
use vitrine_editor::action::{Action, Screen};
use vitrine_editor::dialogs::*;
use vitrine_editor::document::{Addition, EditCommand, Thing};
use vitrine_editor::files::Config;
use vitrine_editor::text::{Language, tr};

fn sphere() -> Object {
    Object { name: "Ball".into(), ..Object::default() }
}

fn add_object(language: Language, object: Object) -> Harness<'static, World> {
    let mut world = World::new(language);
    let addition = Addition { objects: vec![object], ..Addition::default() };
    let dialog = ThingDialog::add(&addition, &world.document).expect("it adds a thing");
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
        world.open = Dialog::of_screen(Screen::Settings, &world.around());
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
        world.open = Dialog::of_screen(Screen::Settings, &world.around());
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
            Action::Edit(command) => world.document.apply(command).expect("the edit is allowed"),
            Action::Drag(command, gesture) => {
                world.document.drag(command, gesture).expect("the edit is allowed");
            }
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
