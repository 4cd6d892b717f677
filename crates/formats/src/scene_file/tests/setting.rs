//! `PATH=VALUE`.

use super::{EXAMPLE, parse, with};
use crate::scene_file::{set, split_values};
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{Renderer, Scene};

fn scene() -> Scene {
    let more = "[[material]]\nname = \"a.b=c\"\n[[material]]\nname = \"2024\"\n[[material]]\nname = \"синее стекло\"\n\
                [[group]]\nname = \"case\"\n";
    parse(&format!("{EXAMPLE}{more}")).unwrap().into_scene()
}

fn changed(argument: &str) -> Scene {
    let mut scene = scene();
    set(&mut scene, argument).unwrap_or_else(|e| panic!("{argument}: {e:?}"));
    scene
}

#[test]
fn values_are_toml_or_bare_texts() {
    assert_eq!(changed("object.ball.material.transparency=0.4").materials[0].transparency, Some(0.4));
    assert_eq!(changed("object.ball.radius = 2").objects[0].shape, {
        vitrine_scene::Shape::Sphere(vitrine_scene::shapes::Sphere { radius: 2.0 })
    });
    assert_eq!(changed("camera.position=[0, 1, 5]").camera.position, Vec3::new(0.0, 1.0, 5.0));
    assert_eq!(changed("settings.background=#ff0000").settings.background, Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(changed("settings.background=\"#ff0000\"").settings.background, Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(changed("settings.renderer=cast").settings.renderer, Renderer::Cast);
    assert!(!changed("object.ball.visible=false").objects[0].visible);
    assert_eq!(changed("object.ball.scale=2").objects[0].scale, Vec3::splat(2.0));
    assert_eq!(changed("object.ball.material='a.b=c'").objects[0].material.as_deref(), Some("a.b=c"));
    // A name that would be a number is a name where a name is wanted.
    assert_eq!(changed("object.ball.material=2024").objects[0].material.as_deref(), Some("2024"));
    assert_eq!(
        changed("object.ball.material=синее стекло").objects[0].material.as_deref(),
        Some("синее стекло")
    );
}

#[test]
fn words_with_dots_stand_in_quotes_and_others_need_none() {
    assert_eq!(changed("material.\"a.b=c\".diffuse=0.5").materials[1].diffuse, Some(0.5));
    assert_eq!(changed("material . 'a.b=c' . diffuse = 0.5").materials[1].diffuse, Some(0.5));
    assert_eq!(changed("material.red glass.diffuse=0.5").materials[0].diffuse, Some(0.5));
    assert_eq!(changed("material.синее стекло.diffuse=0.5").materials[3].diffuse, Some(0.5));
}

#[test]
fn the_last_way_of_aiming_the_camera_counts() {
    let scene = changed("camera.look_at=[0,1,0]");
    assert_eq!((scene.camera.turn_deg, scene.camera.look_at), (None, Some(Vec3::Y)));
}

#[test]
fn what_is_refused_is_underlined_and_changes_nothing() {
    let cases = [
        // argument, underlined, message, help
        ("object.bal.radius=1", "bal", "there is no object `bal`", "did you mean `ball`?"),
        ("object.ball.raduis=1", "raduis", "`object.ball` has no key `raduis`", "did you mean `radius`?"),
        ("objekt.ball.radius=1", "objekt", "a scene has no part `objekt`", "LIST.NAME.KEY"),
        ("object.ball=1", "object.ball", "`object.ball` is not a path to a value", "LIST.NAME.KEY"),
        ("object.cone.material.color=#ffffff", "material", "states no material", "give it a material first"),
        ("object.ball.name=bowl", "name", "`name` cannot be set", "scene file"),
        ("object.ball.shape=box", "shape", "`shape` cannot be set", "scene file"),
        ("object.ball.radius", "", "there is no =", "PATH=VALUE"),
        ("object.ball.radius=", "", "the value is missing", "more than 0"),
        ("", "", "a word of the path is missing", "PATH=VALUE"),
        ("object..radius=1", "", "a word of the path is missing", "PATH=VALUE"),
        ("object.\"ball.radius=1", "\"ball.radius=1", "the quotes are not closed", "write \""),
        ("object.\"ball\"radius=1", "radius=1", "a dot is missing", "PATH=VALUE"),
        ("object.ball.radius=-1", "-1", "`radius` cannot be -1", "more than 0"),
        ("object.ball.radius = nan", "nan", "`radius` cannot be nan", "more than 0"),
        ("object.ball.radius=1 # one", "1 # one", "takes a number, not a text", "more than 0"),
        ("object.ball.radius=1\nx=2", "1\nx=2", "takes a number, not a text", "more than 0"),
        ("object.ball.radius=big", "big", "takes a number, not a text", "more than 0"),
        ("camera.position=[0, x, 1]", "[0, x, 1]", "is no list in TOML", "[x, y, z]"),
        ("camera.position=[0, 1e99, 1]", "1e99", "cannot be 1e99", "finite"),
        ("camera.position=[0, 1]", "[0, 1]", "takes 3 numbers, not 2", "[x, y, z]"),
        ("settings.renderer=clasic", "clasic", "cannot be \"clasic\"", "did you mean \"classic\"?"),
        ("settings.size=[32768,32768]", "[32768,32768]", "too large", "at most"),
        (
            "object.ball.material=red glas",
            "red glas",
            "there is no material `red glas`",
            "did you mean `red glass`?",
        ),
        ("group.case.group=case", "case", "`case` is inside itself", "outermost"),
        ("camera.look_at=[0.0, 1.2, 6.0]", "[0.0, 1.2, 6.0]", "where it stands", "at some distance"),
    ];
    for (argument, underlined, message, help) in cases {
        let mut changed = scene();
        let error = set(&mut changed, argument).expect_err(argument);
        assert_eq!(&argument[error.span.clone()], underlined, "{argument}\n{error:#?}");
        assert!(error.message.contains(message), "{argument}\n{error:#?}");
        assert!(error.help.contains(help), "{argument}\n{error:#?}");
        assert_eq!(changed, scene(), "{argument}");
    }
}

#[test]
fn a_scene_that_is_wrong_already_can_still_be_changed() {
    let mut scene = scene();
    scene.objects[1].material = Some("gone".into());
    set(&mut scene, "object.ball.radius=3").unwrap();
    set(&mut scene, "object.cone.material=red glass").unwrap();
    assert_eq!(scene.problems(), []);
}

#[test]
fn series_are_parted_at_their_commas() {
    let split = |argument: &str| split_values(argument).unwrap();
    let series =
        |path: &str, values: &[&str]| (path.to_owned(), values.iter().map(|v| (*v).to_owned()).collect());
    assert_eq!(
        split("material.glass.transparency=1, 0.8 ,0"),
        series("material.glass.transparency", &["1", "0.8", "0"])
    );
    assert_eq!(split("camera.position=[0,1,5],[1,1,5]"), series("camera.position", &["[0,1,5]", "[1,1,5]"]));
    assert_eq!(split("a.\"x=,\".b=\"1,2\",'3,\\'"), series("a.\"x=,\".b", &["\"1,2\"", "'3,\\'"]));
    assert_eq!(split("object.o.material=\"a \\\",\",Bob's glass,it's"), {
        series("object.o.material", &["\"a \\\",\"", "Bob's glass", "it's"])
    });
    assert_eq!(
        split("o.t.points=[[0,\"]\",0],[1,0]],x"),
        series("o.t.points", &["[[0,\"]\",0],[1,0]]", "x"])
    );
    for (bad, at) in [("a.b=", 4..4), ("a.b=1,", 6..6), ("a.b=1,,2", 6..6), ("a.b=,1", 4..4), ("a.b", 3..3)] {
        assert_eq!(split_values(bad).expect_err(bad).span, at, "{bad}");
    }
}

#[test]
fn each_value_of_a_series_can_be_set() {
    let (path, values) = split_values("object.ball.position=[0,1,0],[0, 2, 0]").unwrap();
    let heights = values.iter().map(|value| changed(&format!("{path}={value}")).objects[0].position.y);
    assert_eq!(heights.collect::<Vec<_>>(), [1.0, 2.0]);
}

#[test]
fn a_key_that_only_other_kinds_have_is_unknown() {
    let mut scene = parse(&with("[[object]]\nname = \"o\"\nshape = \"plane\"")).unwrap().into_scene();
    assert!(set(&mut scene, "object.o.radius=1").unwrap_err().message.contains("no key `radius`"));
}
