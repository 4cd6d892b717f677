//! Files that are right.

use super::{EXAMPLE, parse, with};
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::shapes::{Mesh, Sphere};
use vitrine_scene::{LightSource, Severity, Shape};

#[test]
fn the_agreed_example_says_what_it_should() {
    let file = parse(EXAMPLE).unwrap();
    let scene = file.scene();
    assert_eq!((scene.settings.size, scene.settings.depth), ([809, 817], 3));
    assert_eq!(scene.settings.background, Rgb::from_hex("#2b3a55").unwrap());
    assert_eq!(scene.camera.position, Vec3::new(0.0, 1.2, 6.0));
    assert_eq!(scene.camera.turn_deg, Some(Vec3::new(-5.0, 0.0, 0.0)));
    assert_eq!(scene.camera.view_angle_deg, 50.0);
    let LightSource::Disc(lamp) = &scene.lights[0].source else { panic!("{:?}", scene.lights[0]) };
    assert_eq!((lamp.position, lamp.radius), (Vec3::new(2.0, 5.0, 3.0), 0.5));
    assert_eq!(scene.lights[0].intensity, 0.7);
    let glass = scene.material("red glass").unwrap();
    assert_eq!((glass.color, glass.transparency), (Rgb::from_hex("#c8281e").ok(), Some(0.8)));
    let ball = scene.object("ball").unwrap();
    assert_eq!(ball.shape, Shape::Sphere(Sphere { radius: 1.0 }));
    assert_eq!((ball.position, ball.material.as_deref()), (Vec3::Y, Some("red glass")));
    let cone = Mesh { file: "models/cone.obj".into(), ..Mesh::default() };
    assert_eq!(scene.object("cone").unwrap().shape, Shape::Mesh(cone));
    assert_eq!(file.warnings(), []);
}

#[test]
fn whole_numbers_one_scale_and_linear_colours_are_taken() {
    let text = with(
        "[settings]\nbackground = [1, 0.5, 2]\n[[group]]\nname = \"g\"\nscale = 2\nposition = [1, 2, 3]",
    );
    let scene = parse(&text).unwrap().into_scene();
    assert_eq!(scene.settings.background, Rgb::new(1.0, 0.5, 2.0));
    assert_eq!(
        (scene.groups[0].scale, scene.groups[0].position),
        (Vec3::splat(2.0), Vec3::new(1.0, 2.0, 3.0))
    );
}

#[test]
fn every_way_in_which_toml_writes_tables_is_taken() {
    let text = with(
        "settings.depth = 5\nsettings.seed = 9\ncamera = { view_angle_deg = 30 }\n\
         object = [{ name = \"a\", shape = \"plane\" }, { name = \"b\", shape = \"box\", size = [1, 2, 3] }]",
    );
    let scene = parse(&text).unwrap().into_scene();
    assert_eq!((scene.settings.depth, scene.settings.seed, scene.camera.view_angle_deg), (5, 9, 30.0));
    assert_eq!(scene.objects.iter().map(|o| o.shape.kind()).collect::<Vec<_>>(), ["plane", "box"]);
}

#[test]
fn a_number_is_rounded_once() {
    // Just above the middle between two neighbours; through f64 it would fall on the middle and go down.
    let text = with("[camera]\nview_angle_deg = 1.00000017881393432617187499");
    assert_eq!(parse(&text).unwrap().scene().camera.view_angle_deg, 1.000_000_1);
    let text = with("[camera]\nview_angle_deg = 1.00000017881393432617187501");
    assert_eq!(parse(&text).unwrap().scene().camera.view_angle_deg, 1.000_000_2);
    let text = with("[camera]\nview_angle_deg = 1_0.2_5e0_1");
    assert_eq!(parse(&text).unwrap().scene().camera.view_angle_deg, 102.5);
}

#[test]
fn darkness_emptiness_and_a_camera_inside_are_warnings() {
    let file = parse(&with("")).unwrap();
    let messages: Vec<_> = file.warnings().iter().map(|w| w.message.as_str()).collect();
    let [dark, empty] = messages[..] else { panic!("{messages:?}") };
    assert!(dark.contains("no light") && empty.contains("no object"), "{messages:?}");

    let text = with(
        "[[light]]\nname = \"l\"\nkind = \"point\"\n[[object]]\nname = \"bowl\"\nshape = \"sphere\"\nradius = 50",
    );
    let file = parse(&text).unwrap();
    let [inside] = file.warnings() else { panic!("{:?}", file.warnings()) };
    assert_eq!((inside.severity, &file.text()[inside.span.clone()]), (Severity::Warning, "\"bowl\""));
}
