//! The panel of properties and its controls, driven by accessible names, in both languages.

mod support;

use eframe::egui::{Key, Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::{Light, LightSource, Material, Object, Scene, Shape, Texture, Value, lights, shapes};
use vitrine_editor::action::{Action, Actions};
use vitrine_editor::document::{Addition, Document, EditCommand, Thing};
use vitrine_editor::files::Config;
use vitrine_editor::panels::properties::{PropertiesState, properties_ui};
use vitrine_editor::text::{Language, set_language};
use vitrine_editor::theme;

/// A panel beside nothing: what it needs, and what was asked for.
struct Panel {
    document: Document,
    state: PropertiesState,
    asked: Actions,
}

fn document() -> Document {
    let mut document = Document::default();
    let glass = Material {
        name: "glass".into(),
        color: Rgb::from_hex("#c8281e").ok(),
        transparency: Some(0.8),
        specular: Some(0.5),
        ..Material::default()
    };
    let ball = |name: &str, x: f32| Object {
        name: name.into(),
        position: Vec3::new(x, 0.5, -1.25),
        material: Some("glass".into()),
        ..Object::default()
    };
    let of = |name: &str, shape: Shape| Object { name: name.into(), shape, ..Object::default() };
    let lamp =
        Light { name: "lamp".into(), source: LightSource::Disc(lights::Disc::default()), ..Light::default() };
    let addition = Addition {
        objects: vec![
            ball("Ball", 0.0),
            ball("Ball 2", 1.5),
            of("Crate", Shape::Box(shapes::Cuboid::default())),
            of("Sail", Shape::Triangle(shapes::Triangle::default())),
        ],
        lights: vec![lamp],
        materials: vec![glass],
        textures: vec![Texture { name: "tiles".into(), ..Texture::default() }],
        ..Addition::default()
    };
    document.apply(EditCommand::Add(addition)).expect("nothing of it is refused");
    document
}

fn panel(language: Language, config: &Config, things: Vec<Thing>) -> Harness<'static, Panel> {
    sized(language, config, things, 698.0)
}

fn sized(language: Language, config: &Config, things: Vec<Thing>, height: f32) -> Harness<'static, Panel> {
    let mut document = document();
    document.select(things);
    let panel = Panel { document, state: PropertiesState::default(), asked: Actions::new() };
    let config = config.clone();
    let mut is_ready = false;
    let draw = move |ui: &mut Ui, panel: &mut Panel| {
        set_language(language);
        // Fonts are there from the next frame on.
        if std::mem::replace(&mut is_ready, true) {
            draw_ui(ui, panel);
        } else {
            theme::apply(ui, &config);
            ui.request_repaint();
        }
    };
    let sizes = &theme::Theme::of_config(&Config::default()).sizes;
    let mut harness = Harness::builder()
        .with_size(vec2(sizes.properties_width, height))
        .renderer(support::CpuRenderer::default())
        .build_ui_state(draw, panel);
    harness.run();
    harness
}

fn draw_ui(ui: &mut Ui, panel: &mut Panel) {
    let mut actions = Actions::new();
    let theme = theme::of(ui);
    eframe::egui::Frame::new().fill(theme.panel).inner_margin(theme.sizes.gap_l).show(ui, |ui| {
        properties_ui(ui, &panel.document, &mut panel.state, &mut actions);
    });
    for action in &actions {
        match action {
            Action::Edit(command) => {
                let _ = panel.document.apply(command.clone());
            }
            Action::Drag(command, gesture) => {
                let _ = panel.document.drag(command.clone(), *gesture);
            }
            _ => {}
        }
    }
    panel.asked.extend(actions);
}

fn english(things: Vec<Thing>) -> Harness<'static, Panel> {
    panel(Language::English, &Config::default(), things)
}

fn type_into(harness: &mut Harness<'_, Panel>, name: &str, text: &str) {
    harness.get_by_label(name).focus();
    harness.run();
    harness.get_by_label(name).type_text(text);
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
}

fn scene<'a>(harness: &'a Harness<'_, Panel>) -> &'a Scene {
    harness.state().document.scene()
}

#[test]
fn c1_the_radius_of_a_sphere_is_typed() {
    let mut harness = english(vec![Thing::object("Ball")]);
    type_into(&mut harness, "Radius", "0,75");
    let Shape::Sphere(sphere) = &scene(&harness).object("Ball").unwrap().shape else { panic!("a sphere") };
    assert_eq!(sphere.radius, 0.75);
}

#[test]
fn nonsense_keeps_the_old_value_and_says_why_until_the_next_edit() {
    let mut harness = english(vec![Thing::object("Ball")]);
    type_into(&mut harness, "Radius", "abc");
    assert_eq!(harness.state().asked, []);
    assert!(harness.query_by_label_contains("“abc” is not a number").is_some());
    type_into(&mut harness, "Radius", "-1");
    assert_eq!(harness.state().asked, []);
    assert!(harness.query_by_label_contains("Must be more than 0").is_some());
    type_into(&mut harness, "Radius", "2*0.4");
    assert!(harness.query_by_label_contains("Must be more than").is_none());
    let Shape::Sphere(sphere) = &scene(&harness).object("Ball").unwrap().shape else { panic!("a sphere") };
    assert_eq!(sphere.radius, 0.8);
}

#[test]
fn typing_in_one_field_is_one_step_of_the_history() {
    let mut harness = english(vec![Thing::object("Ball")]);
    let before = scene(&harness).clone();
    harness.get_by_label("Place X").focus();
    harness.run();
    for letter in ["1", ".", "5"] {
        harness.get_by_label("Place X").type_text(letter);
        harness.run();
    }
    harness.key_press(Key::Enter);
    harness.run();
    assert_eq!(scene(&harness).object("Ball").unwrap().position.x, 1.5);
    assert!(harness.state_mut().document.undo());
    assert_eq!(*scene(&harness), before);
}

#[test]
fn esc_brings_the_old_value_back() {
    let mut harness = english(vec![Thing::object("Ball")]);
    harness.get_by_label("Place Y").focus();
    harness.run();
    harness.get_by_label("Place Y").type_text("9");
    harness.run();
    assert_eq!(scene(&harness).object("Ball").unwrap().position.y, 9.0);
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(scene(&harness).object("Ball").unwrap().position.y, 0.5);
}

#[test]
fn c6_scales_of_a_material_are_typed_and_taken_back() {
    let mut harness = english(vec![Thing::object("Ball")]);
    type_into(&mut harness, "Transparency", "0.25");
    assert_eq!(scene(&harness).material("glass").unwrap().transparency, Some(0.25));
    harness.get_by_label("Transparency: automatic").click_accesskit();
    harness.run();
    assert_eq!(scene(&harness).material("glass").unwrap().transparency, None);
}

#[test]
fn a_colour_is_typed_as_hexadecimal() {
    let mut harness = english(vec![Thing::object("Ball")]);
    type_into(&mut harness, "Colour", "#00ff00");
    assert_eq!(scene(&harness).material("glass").unwrap().color, Rgb::from_hex("#00ff00").ok());
    type_into(&mut harness, "Colour", "greenish");
    assert!(harness.query_by_label_contains("“greenish” is not a colour").is_some());
    assert_eq!(scene(&harness).material("glass").unwrap().color, Rgb::from_hex("#00ff00").ok());
}

#[test]
fn a_colour_is_picked_in_one_step_and_the_picker_is_named() {
    let mut harness = english(vec![Thing::light("lamp")]);
    let before = scene(&harness).clone();
    harness.get_by_label("Colour, picker").click();
    harness.run();
    assert_eq!(support::controls_without_name_or_tooltip(&harness), Vec::<String>::new());
    support::picture(&mut harness, "properties-picker");
    let square = harness.get_by_label("Shade").rect();
    harness.drag_at(square.left_top() + square.size() * 0.5);
    harness.run();
    harness.hover_at(square.right_top());
    harness.run();
    harness.drop_at(square.right_top());
    harness.run();
    let color = scene(&harness).lights[0].color.to_srgb8();
    assert_eq!(color, [255, 0, 0], "the strongest of the first hue");
    assert!(harness.state_mut().document.undo());
    assert_eq!(*scene(&harness), before);
}

#[test]
fn a_slider_is_dragged_in_one_step_and_moved_by_arrow_keys() {
    let mut harness = english(vec![Thing::light("lamp")]);
    let before = scene(&harness).clone();
    let rail = harness.get_by_label("Brightness, slider").rect();
    harness.drag_at(rail.center());
    harness.run();
    harness.hover_at(rail.right_center());
    harness.run();
    harness.drop_at(rail.right_center());
    harness.run();
    assert_eq!(scene(&harness).lights[0].intensity, 2.0);
    assert!(harness.state_mut().document.undo());
    assert_eq!(*scene(&harness), before);
    harness.get_by_label("Brightness, slider").focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    assert!(scene(&harness).lights[0].intensity > 0.7);
}

#[test]
fn c13_the_camera_is_turned_by_an_angle_about_an_axis() {
    let mut harness = english(vec![Thing::Camera]);
    type_into(&mut harness, "Angle", "30");
    harness.get_by_label("Axis X").click_accesskit();
    harness.run();
    harness.state_mut().asked.clear();
    harness.get_by_role_and_label(eframe::egui::accesskit::Role::Button, "Turn").click_accesskit();
    harness.run();
    let [Action::Edit(EditCommand::Camera(turn))] = harness.state().asked.as_slice() else {
        panic!("{:?}", harness.state().asked)
    };
    let wanted = vitrine_editor::document::CameraMove::Turn { axis: vitrine::math::Axis::X, angle_deg: 30.0 };
    assert_eq!(*turn, wanted);
}

#[test]
fn several_things_move_together_and_show_what_they_share() {
    let mut harness = english(vec![Thing::object("Ball"), Thing::object("Ball 2")]);
    type_into(&mut harness, "Radius", "2");
    let asked = harness.state().asked.clone();
    let set = asked.iter().find_map(|a| match a {
        Action::Drag(EditCommand::Set { things, value, .. }, _) => Some((things.len(), value.clone())),
        _ => None,
    });
    assert_eq!(set, Some((2, Value::Number(2.0))));
}

/// What can be selected, with a name for its picture.
fn selections() -> Vec<(&'static str, Vec<Thing>)> {
    vec![
        ("nothing", vec![]),
        ("sphere", vec![Thing::object("Ball")]),
        ("box", vec![Thing::object("Crate")]),
        ("triangle", vec![Thing::object("Sail")]),
        ("lamp", vec![Thing::light("lamp")]),
        ("camera", vec![Thing::Camera]),
        ("material", vec![Thing::material("glass")]),
        ("several", vec![Thing::object("Ball"), Thing::object("Crate"), Thing::light("lamp")]),
    ]
}

/// `VITRINE_PICTURES=strong cargo test -p vitrine-editor --test properties` draws the panel for a look by eye.
#[test]
fn nothing_is_clipped_and_everything_is_named_in_every_language_and_size() {
    for language in Language::ALL {
        for strong in [false, true] {
            let config = Config { large_text: strong, high_contrast: strong, ..Config::default() };
            for (name, things) in selections() {
                // So high that nothing is scrolled away.
                let mut harness = sized(language, &config, things, 1900.0);
                for more in ["More", "Ещё", "Pattern", "Узор"] {
                    harness.query_all_by_label(more).for_each(|node| node.click_accesskit());
                }
                harness.run();
                let place =
                    format!("properties-{name}-{}{}", language.tag(), if strong { "-strong" } else { "" });
                if support::is_pictured(&place) {
                    support::picture(&mut harness, &place);
                }
                assert_eq!(support::labels_clipped(&harness), Vec::<String>::new(), "{place}");
                assert_eq!(
                    support::controls_without_name_or_tooltip(&harness),
                    Vec::<String>::new(),
                    "{place}"
                );
            }
        }
    }
}
