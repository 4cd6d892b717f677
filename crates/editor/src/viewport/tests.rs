//! The picture in a window without a screen: what the pointer and the keys ask for.

use super::*;
use crate::document::CameraMove;
use eframe::egui::{self, Event, Key, Modifiers, MouseWheelUnit, PointerButton, Vec2};
use egui_kittest::{Harness, kittest::Queryable};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrine::formats::SceneFile;
use vitrine::math::{Axis, Vec3};
use vitrine::scene::{Assets, Material, Value};

/// A window of 640×520 points with the picture in it, 640×480.
struct Window {
    document: Document,
    live: Live,
    viewport: Viewport,
    actions: Actions,
    /// A material that is being dragged.
    paint: Option<Paint>,
}

type Test = Harness<'static, Window>;

/// A ball on a floor, a lamp at the upper left.
const SCENE: &str = r#"
format = 1
[settings]
size = [640, 480]
[camera]
position = [0.0, 3.0, 8.0]
look_at = [0.0, 1.0, 0.0]
[[light]]
name = "lamp"
kind = "point"
position = [-2.0, 3.0, 0.0]
[[object]]
name = "ball"
shape = "sphere"
position = [0.0, 1.0, 0.0]
[[object]]
name = "floor"
shape = "plane"
"#;

fn document(text: &str) -> Document {
    let file = SceneFile::parse(Path::new("test.vitrine.toml"), text).unwrap();
    Document::untitled(file, Assets::default(), PathBuf::new())
}

fn window() -> Test {
    let state = Window {
        document: document(SCENE),
        live: Live::synchronous(),
        viewport: Viewport::default(),
        actions: Vec::new(),
        paint: None,
    };
    let draw = |ui: &mut Ui, window: &mut Window| {
        if let Some(paint) = window.paint.take() {
            DragAndDrop::set_payload(ui.ctx(), paint);
        }
        let Window { document, live, viewport, actions, .. } = window;
        viewport_ui(ui, document, live, viewport, actions);
    };
    let mut test = Harness::builder()
        .with_size(Vec2::new(656.0, 536.0))
        .with_step_dt(1.0 / 60.0)
        .build_ui_state(draw, state);
    test.run();
    test
}

/// Where a point of the scene is in the window.
fn place(test: &Test, point: Vec3) -> Pos2 {
    let picture = test.get_by_label("Picture").rect();
    Projection::new(&test.state().document.scene().camera, picture).project(point).unwrap()
}

fn press(test: &mut Test, at: Pos2, button: PointerButton, modifiers: Modifiers, pressed: bool) {
    test.event_modifiers(Event::PointerMoved(at), modifiers);
    test.event_modifiers(Event::PointerButton { pos: at, button, pressed, modifiers }, modifiers);
    test.step();
}

fn click(test: &mut Test, at: Pos2, modifiers: Modifiers) -> Actions {
    press(test, at, PointerButton::Primary, modifiers, true);
    press(test, at, PointerButton::Primary, modifiers, false);
    // The next click is not the second of a double click.
    test.run_steps(40);
    std::mem::take(&mut test.state_mut().actions)
}

/// Drags in steps of a few points; what was asked for until the button is let go.
fn drag(test: &mut Test, ends: [Pos2; 2], button: PointerButton, modifiers: Modifiers) -> Actions {
    begin_drag(test, ends, button, modifiers);
    press(test, ends[1], button, modifiers, false);
    test.step();
    std::mem::take(&mut test.state_mut().actions)
}

fn begin_drag(test: &mut Test, [from, to]: [Pos2; 2], button: PointerButton, modifiers: Modifiers) {
    press(test, from, button, modifiers, true);
    for i in 1..=10 {
        test.event_modifiers(Event::PointerMoved(from + (to - from) * (i as f32 / 10.0)), modifiers);
        test.step();
    }
}

/// The sum of all moves, each of one gesture.
#[track_caller]
fn moved(actions: &[Action]) -> Vec3 {
    let mut gestures = Vec::new();
    let mut sum = Vec3::ZERO;
    for action in actions {
        if let Action::Drag(EditCommand::Move { by, .. }, gesture) = action {
            sum += *by;
            gestures.push(*gesture);
        }
    }
    gestures.dedup();
    assert_eq!(gestures.len(), 1, "one gesture: {actions:?}");
    sum
}

fn select(test: &mut Test, thing: Thing) {
    test.state_mut().document.select([thing]);
    test.step();
}

#[test]
fn a_click_selects_adds_and_deselects() {
    let mut test = window();
    let ball = place(&test, Vec3::Y);
    assert_eq!(click(&mut test, ball, Modifiers::NONE), [Action::Select(vec![Thing::object("ball")])]);
    let floor = place(&test, Vec3::new(2.0, 0.0, 2.0));
    assert_eq!(click(&mut test, floor, Modifiers::COMMAND), [Action::ToggleSelect(Thing::object("floor"))]);
    assert_eq!(click(&mut test, ball, Modifiers::SHIFT), [Action::ToggleSelect(Thing::object("ball"))]);
    let sky = test.get_by_label("Picture").rect().center_top() + vec2(200.0, 10.0);
    assert_eq!(click(&mut test, sky, Modifiers::NONE), [Action::Select(vec![])]);
    assert_eq!(click(&mut test, sky, Modifiers::SHIFT), []);
    let lamp = place(&test, Vec3::new(-2.0, 3.0, 0.0));
    assert_eq!(click(&mut test, lamp, Modifiers::NONE), [Action::Select(vec![Thing::light("lamp")])]);
}

#[test]
fn another_click_goes_on_to_what_is_seen_behind_glass() {
    let mut test = window();
    let glass = r#"
[[material]]
name = "glass"
transparency = 0.9
[[object]]
name = "shell"
shape = "sphere"
radius = 1.5
position = [0.0, 1.0, 0.0]
material = "glass"
"#;
    test.state_mut().document = document(&format!("{SCENE}{glass}"));
    test.run();
    let middle = place(&test, Vec3::Y);
    for name in ["shell", "ball", "shell"] {
        let wanted = vec![Thing::object(name)];
        assert_eq!(click(&mut test, middle, Modifiers::NONE), [Action::Select(wanted.clone())]);
        test.state_mut().document.select(wanted);
    }
    // What is selected is dragged, though glass is before it.
    select(&mut test, Thing::object("ball"));
    let at = middle + vec2(-20.0, 10.0);
    let actions = drag(&mut test, [at, at + vec2(40.0, 0.0)], PointerButton::Primary, Modifiers::NONE);
    let moves_ball = |a: &Action| matches!(a, Action::Drag(EditCommand::Move { things, .. }, _) if *things == [Thing::object("ball")]);
    assert!(!actions.is_empty() && actions.iter().all(moves_ball), "{actions:?}");
    let map = test.state().live.objects().unwrap();
    let index = |name: &str| map.scene.objects.iter().position(|o| o.name == name).unwrap() as u32;
    assert!(map.behind_glass.contains(&index("ball")) && !map.behind_glass.contains(&index("shell")));
}

#[test]
fn a_double_click_brings_a_thing_to_the_middle() {
    let mut test = window();
    let ball = place(&test, Vec3::Y);
    for pressed in [true, false, true, false] {
        press(&mut test, ball, PointerButton::Primary, Modifiers::NONE, pressed);
    }
    assert_eq!(test.state().actions.last(), Some(&Action::Frame(vec![Thing::object("ball")])));
}

#[test]
fn c14_a_drag_moves_a_thing_along_the_floor_and_selects_it_first() {
    let mut test = window();
    // On the side of the ball that faces the camera.
    let held = test.state().live.pick(0.5, 0.5).unwrap().point;
    let ends = [held, held + Vec3::new(1.5, 0.0, -2.0)].map(|p| place(&test, p));
    let actions = drag(&mut test, ends, PointerButton::Primary, Modifiers::NONE);
    assert_eq!(actions[0], Action::Select(vec![Thing::object("ball")]));
    assert!((moved(&actions) - Vec3::new(1.5, 0.0, -2.0)).length() < 1e-3, "{actions:?}");
}

#[test]
fn c14_with_shift_it_goes_up_and_with_ctrl_in_steps() {
    let mut test = window();
    let held = test.state().live.pick(0.5, 0.5).unwrap().point;
    let ends = [held, held + Vec3::Y * 1.1].map(|p| place(&test, p));
    let up = moved(&drag(&mut test, ends, PointerButton::Primary, Modifiers::SHIFT));
    assert!((up - Vec3::Y * 1.1).length() < 1e-3, "{up}");
    let ends = [held, held + Vec3::new(0.6, 0.0, 0.2)].map(|p| place(&test, p));
    let steps = moved(&drag(&mut test, ends, PointerButton::Primary, Modifiers::COMMAND));
    assert!((steps - Vec3::new(0.5, 0.0, 0.25)).length() < 1e-5, "{steps}");
}

#[test]
fn planes_and_the_sky_are_not_dragged() {
    let mut test = window();
    let floor = place(&test, Vec3::new(2.0, 0.0, 2.0));
    let ends = [floor, floor + vec2(50.0, 0.0)];
    assert_eq!(drag(&mut test, ends, PointerButton::Primary, Modifiers::NONE), []);
}

#[test]
fn lamps_are_dragged_by_their_icons() {
    let mut test = window();
    let lamp = Vec3::new(-2.0, 3.0, 0.0);
    let ends = [lamp, lamp + Vec3::Y].map(|p| place(&test, p));
    let actions = drag(&mut test, ends, PointerButton::Primary, Modifiers::SHIFT);
    assert_eq!(actions[0], Action::Select(vec![Thing::light("lamp")]));
    assert!((moved(&actions) - Vec3::Y).length() < 1e-3);
}

#[test]
fn c14_an_arrow_moves_along_its_axis_alone() {
    let mut test = window();
    select(&mut test, Thing::object("ball"));
    let start = place(&test, Vec3::Y) + vec2(50.0, 0.0);
    let actions = drag(&mut test, [start, start + vec2(60.0, 30.0)], PointerButton::Primary, Modifiers::NONE);
    let by = moved(&actions);
    assert!(by.x > 0.3 && by.y == 0.0 && by.z == 0.0, "{by}");
    assert!(!actions.iter().any(|a| matches!(a, Action::Select(_))));
}

#[test]
fn c14_a_ring_turns_about_its_axis_and_ctrl_makes_steps() {
    let mut test = window();
    select(&mut test, Thing::object("ball"));
    test.key_press(Key::E);
    test.run();
    assert_eq!(test.state().viewport.tool, Tool::Turn);
    // The ring about Z faces the camera but for a little; a quarter of it from the right, upwards.
    let metres = Projection::new(&test.state().document.scene().camera, test.get_by_label("Picture").rect());
    let arm = theme::of(&test.ctx).sizes.handle_arm * metres.metres_a_point(Vec3::Y);
    let on_ring = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Vec3::Y + Vec3::new(cos, sin, 0.0) * arm
    };
    let ends = [on_ring(30.0), on_ring(62.0)].map(|p| place(&test, p));
    let turned = |actions: &[Action]| {
        let turn = |action: &Action| match action {
            Action::Drag(EditCommand::Turn { axis, angle_deg, .. }, _) if *axis == Axis::Z => *angle_deg,
            other => panic!("a turn about Z: {other:?}"),
        };
        actions.iter().map(turn).sum::<f32>()
    };
    let free = turned(&drag(&mut test, ends, PointerButton::Primary, Modifiers::NONE));
    assert!((free - 32.0).abs() < 0.1, "{free}");
    let steps = turned(&drag(&mut test, ends, PointerButton::Primary, Modifiers::COMMAND));
    assert_eq!(steps, 30.0);
}

#[test]
fn c14_boxes_make_larger_along_an_axis_or_all_alike() {
    let mut test = window();
    select(&mut test, Thing::object("ball"));
    test.get_by_label("Size").click();
    test.run();
    test.state_mut().actions.clear();
    let middle = place(&test, Vec3::Y);
    let sized = |actions: Actions| {
        let by = |action: Action| match action {
            Action::Drag(EditCommand::Resize { by, .. }, _) => by,
            other => panic!("a size: {other:?}"),
        };
        actions.into_iter().map(by).fold(Vec3::ONE, |all, by| all * by)
    };
    let x = [middle + vec2(60.0, 0.0), middle + vec2(90.0, 0.0)];
    let along = sized(drag(&mut test, x, PointerButton::Primary, Modifiers::NONE));
    assert!((along.x - 1.5).abs() < 0.02 && along.y == 1.0 && along.z == 1.0, "{along}");
    let all =
        sized(drag(&mut test, [middle, middle + vec2(50.0, 0.0)], PointerButton::Primary, Modifiers::NONE));
    assert!((all - Vec3::splat(1.5)).length() < 0.01, "{all}");
}

#[test]
fn esc_takes_a_drag_back_and_the_rest_of_it_does_nothing() {
    let mut test = window();
    let ball = place(&test, Vec3::Y);
    begin_drag(&mut test, [ball, ball + vec2(60.0, 0.0)], PointerButton::Primary, Modifiers::NONE);
    test.key_press(Key::Escape);
    test.step();
    assert_eq!(test.state().actions.last(), Some(&Action::Undo));
    test.state_mut().actions.clear();
    test.event(Event::PointerMoved(ball + vec2(90.0, 0.0)));
    test.run_steps(3);
    assert_eq!(test.state().actions, []);
    assert!(test.state().viewport.drag.is_some());
}

#[test]
fn c13_the_camera_goes_around_sideways_and_nearer() {
    let mut test = window();
    let at = test.get_by_label("Picture").rect().center();
    let ends = [at, at + vec2(50.0, 20.0)];
    let camera = |action: &Action| match action {
        Action::Drag(EditCommand::Camera(step), _) => *step,
        other => panic!("a move of the camera: {other:?}"),
    };
    for (button, modifiers) in
        [(PointerButton::Secondary, Modifiers::NONE), (PointerButton::Primary, Modifiers::ALT)]
    {
        let (mut right, mut up) = (0.0, 0.0);
        for action in &drag(&mut test, ends, button, modifiers) {
            let CameraMove::Orbit { around, right_deg, up_deg } = camera(action) else {
                panic!("{action:?}")
            };
            assert_eq!(around, Vec3::Y);
            (right, up) = (right + right_deg, up + up_deg);
        }
        // The way before a press becomes a drag does not count.
        assert!(right < -10.0 && up > 4.0 && (right + 2.5 * up).abs() < 0.1, "{right} {up}");
    }
    for (button, modifiers) in
        [(PointerButton::Middle, Modifiers::NONE), (PointerButton::Secondary, Modifiers::SHIFT)]
    {
        let actions = drag(&mut test, ends, button, modifiers);
        assert!(!actions.is_empty());
        for action in &actions {
            assert!(
                matches!(camera(action), CameraMove::Pan { right, up } if right < 0.0 && up > 0.0),
                "{action:?}"
            );
        }
    }
    test.event(Event::PointerMoved(at));
    let (unit, delta, modifiers) = (MouseWheelUnit::Line, Vec2::new(0.0, 1.0), Modifiers::NONE);
    test.event(Event::MouseWheel { unit, delta, modifiers, phase: egui::TouchPhase::Move });
    test.run_steps(8);
    let actions = std::mem::take(&mut test.state_mut().actions);
    let zoom = |action: &Action| match camera(action) {
        CameraMove::Zoom { toward, factor } if toward == Vec3::Y => factor,
        other => panic!("{other:?}"),
    };
    assert!(actions.iter().map(zoom).product::<f32>() > 1.02);
    let gestures: Vec<_> =
        actions.iter().map(|a| if let Action::Drag(_, gesture) = a { *gesture } else { 0 }).collect();
    assert!(gestures.iter().all(|g| *g == gestures[0]), "one turn of the wheel is one step");
}

#[test]
fn a_material_is_dropped_on_the_thing_under_the_pointer() {
    let mut test = window();
    let ball = place(&test, Vec3::Y);
    let paint = Paint { material: Material { name: "gold".into(), ..Material::default() }, texture: None };
    test.event(Event::PointerMoved(ball));
    test.state_mut().paint = Some(paint.clone());
    test.step();
    let modifiers = Modifiers::NONE;
    test.event(Event::PointerButton { pos: ball, button: PointerButton::Primary, pressed: false, modifiers });
    test.step();
    let wanted = EditCommand::Paint { things: vec![Thing::object("ball")], material: Box::new(paint) };
    assert_eq!(test.state().actions, [Action::Edit(wanted)]);
}

#[test]
fn the_picture_follows_edits_and_the_tools_have_names_and_keys() {
    let mut test = window();
    let before = test.state().live.picture().unwrap();
    assert_eq!(before.size, [640, 480]);
    let (things, key) = (vec![Thing::Settings], "background".to_owned());
    let value = Value::Color(vitrine::math::Rgb::WHITE);
    test.state_mut().document.apply(EditCommand::Set { things, key, value }).unwrap();
    test.run();
    let after = test.state().live.picture().unwrap();
    assert!(after.generation > before.generation && after.rgba != before.rgba);
    test.run();
    assert!(Arc::ptr_eq(&after, &test.state().live.picture().unwrap()), "no picture without a reason");
    for (key, tool) in [(Key::R, Tool::Size), (Key::E, Tool::Turn), (Key::W, Tool::Move)] {
        test.key_press(key);
        test.run();
        assert_eq!(test.state().viewport.tool, tool);
    }
    test.get_by_label("Focus").click();
    test.run();
    assert_eq!(test.state().actions, [Action::Frame(vec![])], "everything");
}

#[test]
fn a_scene_that_cannot_be_rendered_is_shown_with_the_reason() {
    let mut test = window();
    let model = "\n[[object]]\nname = \"model\"\nshape = \"mesh\"\nfile = \"missing.obj\"\n";
    test.state_mut().document = document(&format!("{SCENE}{model}"));
    test.run();
    assert!(matches!(test.state().live.status().error, Some(LiveError::Compile(_))));
}
