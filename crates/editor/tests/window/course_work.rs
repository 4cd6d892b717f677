//! C1 to C8: things that are added by their dialogs, with numbers, and seen.

use crate::person::Person;
use vitrine::math::Vec3;
use vitrine::scene::{LightSource, Object, Shape, Value};
use vitrine_editor::document::Thing;
use vitrine_editor::text::Language;

pub fn in_english() -> Person {
    Person::in_empty_scene(Language::English)
}

/// The object added last.
pub fn newest(person: &Person) -> Object {
    person.scene().objects.last().expect("an object").clone()
}

/// Types x, y and z.
fn type_vector(person: &mut Person, name: &str, xyz: [&str; 3]) {
    for (axis, text) in ["X", "Y", "Z"].into_iter().zip(xyz) {
        person.type_into(&format!("{name} {axis}"), text);
    }
}

/// Does something to the picture that must be seen in it.
pub fn must_be_seen(person: &mut Person, change: impl FnOnce(&mut Person)) {
    let before = person.picture();
    change(person);
    assert!(person.picture() != before, "it cannot be seen in the picture");
}

#[test]
fn c1_a_sphere_comes_from_the_dialog_with_its_centre_and_radius_and_is_seen() {
    let mut person = in_english();
    let before = person.color_at([0.5, 0.5]);
    person.choose(&["Add", "Sphere"]);
    type_vector(&mut person, "Place", ["0", "0.75", "0"]);
    person.type_into("Radius", "0.75");
    person.click("Add");
    let ball = newest(&person);
    let Shape::Sphere(sphere) = &ball.shape else { panic!("a sphere, not {ball:?}") };
    assert_eq!((sphere.radius, ball.position), (0.75, Vec3::new(0.0, 0.75, 0.0)));
    assert!(person.document().selection().contains(&Thing::object(&*ball.name)));
    assert_ne!(person.color_at([0.5, 0.5]), before, "it is in the picture");
}

#[test]
fn c2_a_box_comes_with_its_centre_sizes_and_turn() {
    let mut person = in_english();
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Box"]);
        type_vector(person, "Place", ["0.5", "1", "-1"]);
        type_vector(person, "Edges", ["1", "2", "0.5"]);
        type_vector(person, "Turn", ["0", "30", "0"]);
        person.click("Add");
    });
    let made = newest(&person);
    let Shape::Box(cuboid) = &made.shape else { panic!("{made:?}") };
    assert_eq!(cuboid.size, Vec3::new(1.0, 2.0, 0.5));
    assert_eq!((made.position, made.turn_deg), (Vec3::new(0.5, 1.0, -1.0), Vec3::new(0.0, 30.0, 0.0)));
}

#[test]
fn c3_the_ground_is_there_and_another_plane_can_be_added() {
    let mut person = in_english();
    assert!(person.scene().objects.iter().any(|o| matches!(o.shape, Shape::Plane(_))), "the ground");
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Plane"]);
        type_vector(person, "Place", ["0", "0", "-5"]);
        type_vector(person, "Turn", ["90", "0", "0"]);
        person.click("Add");
    });
    let wall = newest(&person);
    assert!(matches!(wall.shape, Shape::Plane(_)));
    assert_eq!((wall.position.z, wall.turn_deg.x), (-5.0, 90.0));
}

#[test]
fn c4_a_triangle_comes_by_its_three_points() {
    let mut person = in_english();
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Triangle"]);
        type_vector(person, "Corner A", ["-1", "0", "0"]);
        type_vector(person, "Corner B", ["1", "0", "0"]);
        type_vector(person, "Corner C", ["0", "2", "-0.5"]);
        person.click("Add");
    });
    let made = newest(&person);
    let Shape::Triangle(triangle) = &made.shape else { panic!("{made:?}") };
    let corners = triangle.points.map(|p| p + made.position);
    let wanted = [Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 2.0, -0.5)];
    assert!(corners.iter().zip(wanted).all(|(a, b)| (*a - b).length() < 1e-5), "{corners:?}");
}

#[test]
fn c4_three_points_on_one_line_are_refused_with_the_reason() {
    let mut person = in_english();
    person.choose(&["Add", "Triangle"]);
    type_vector(&mut person, "Corner A", ["0", "0", "0"]);
    type_vector(&mut person, "Corner B", ["1", "0", "0"]);
    type_vector(&mut person, "Corner C", ["2", "0", "0"]);
    assert!(person.reads("lie on one line"));
    let before = person.scene().objects.len();
    person.click("Add");
    assert_eq!(person.scene().objects.len(), before);
}

/// A pyramid of six triangles on a square of 2 by 2.
const PYRAMID: &str = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 2 0\n\
                       f 1 2 3\nf 1 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n";

fn with_pyramid() -> Person {
    let mut person = in_english();
    let path = person.path("pyramid.obj");
    std::fs::write(&path, PYRAMID).unwrap();
    person.open(path);
    assert!(person.sees("Model settings"), "{:?}", person.names());
    person
}

#[test]
fn c5_a_model_is_set_up_before_it_is_loaded_and_after() {
    let mut person = with_pyramid();
    must_be_seen(&mut person, |person| {
        type_vector(person, "Place", ["0.5", "0.25", "-1"]);
        type_vector(person, "Turn", ["0", "45", "0"]);
        type_vector(person, "Size", ["0.5", "0.75", "0.5"]);
        person.pick("Made of", "New material");
        person.type_into("Colour", "#10c020");
        person.click("Add");
    });
    let model = newest(&person);
    assert!(matches!(model.shape, Shape::Mesh(_)), "{model:?}");
    assert_eq!(model.position, Vec3::new(0.5, 0.25, -1.0));
    assert_eq!((model.turn_deg.y, model.scale), (45.0, Vec3::new(0.5, 0.75, 0.5)));
    let material = model.material.as_deref().and_then(|m| person.scene().material(m)).unwrap();
    assert_eq!(material.color.unwrap().to_hex().as_deref(), Some("#10c020"));
    must_be_seen(&mut person, |person| {
        person.choose(&["Edit", "Model settings…"]);
        type_vector(person, "Size", ["1", "1", "1"]);
        person.type_into("Turn Y", "10");
        person.type_into("Transparency", "0.5");
        person.click("Apply");
    });
    let model = newest(&person);
    assert_eq!((model.turn_deg.y, model.scale), (10.0, Vec3::ONE));
    let material = model.material.as_deref().and_then(|m| person.scene().material(m)).unwrap();
    assert_eq!(material.transparency, Some(0.5));
}

#[test]
fn c5_the_button_load_model_opens_the_choice_of_a_file() {
    let mut person = in_english();
    person.use_tool("Model");
    assert!(person.sees("Load a model"), "{:?}", person.names());
}

#[test]
fn c6_a_material_is_made_by_its_scales() {
    let mut person = in_english();
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Sphere"]);
        person.type_into("Colour", "#3366cc");
        person.type_into("Matte amount (diffuse)", "0.4");
        person.type_into("Highlight (specular)", "0.9");
        person.type_into("Highlight size (shininess)", "120");
        person.type_into("Mirror (reflectivity)", "0.25");
        person.type_into("Transparency", "0.5");
        person.click("Add");
    });
    let name = newest(&person).material.unwrap();
    let material = person.scene().material(&name).unwrap();
    assert_eq!(material.color.unwrap().to_hex().as_deref(), Some("#3366cc"));
    let scales = [material.diffuse, material.specular, material.shininess];
    assert_eq!(scales, [Some(0.4), Some(0.9), Some(120.0)]);
    assert_eq!([material.reflectivity, material.transparency], [Some(0.25), Some(0.5)]);
}

#[test]
fn c6_a_scale_is_dragged_in_the_panel_as_one_step() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let steps = person.document().history().undoable();
    let slider = person.control("Matte amount (diffuse), slider").rect();
    must_be_seen(&mut person, |person| person.drag(slider.right_center(), slider.left_center()));
    let name = newest(&person).material.unwrap();
    let diffuse = person.scene().material(&name).unwrap().diffuse;
    assert_eq!(diffuse, Some(0.0));
    assert_eq!(person.document().history().undoable(), steps + 1);
}

#[test]
fn c7_a_pattern_and_a_picture_cover_a_shape() {
    let mut person = in_english();
    person.use_tool("Sphere");
    must_be_seen(&mut person, |person| person.pick("Picture on surface", "New pattern"));
    let texture_of = |person: &Person| {
        let name = newest(person).material.unwrap();
        person.scene().material(&name).unwrap().texture.clone().unwrap()
    };
    assert!(person.scene().texture(&texture_of(&person)).is_some());
    let path = person.path("stripes.png");
    let stripes =
        image::RgbImage::from_fn(8, 8, |x, _| image::Rgb(if x < 4 { [250, 20, 20] } else { [20; 3] }));
    stripes.save(&path).unwrap();
    person.select("Sphere");
    must_be_seen(&mut person, |person| person.open(path));
    let name = texture_of(&person);
    let texture = person.scene().texture(&name).unwrap();
    assert_eq!(texture.source.kind(), "picture");
}

#[test]
fn c8_every_kind_of_light_comes_with_its_numbers_and_any_number_of_each() {
    let mut person = in_english();
    let before = person.scene().lights.len();
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Everywhere light (ambient)"]);
        person.type_into("Brightness", "0.2");
        person.click("Add");
    });
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Bulb (point)"]);
        type_vector(person, "Place", ["1", "3", "2"]);
        person.type_into("Brightness", "0.4");
        person.click("Add");
    });
    must_be_seen(&mut person, |person| {
        person.choose(&["Add", "Sunlight (directional)"]);
        type_vector(person, "Direction", ["1", "-2", "0.5"]);
        person.click("Add");
    });
    for _ in 0..2 {
        person.choose(&["Add", "Disc lamp"]);
        type_vector(&mut person, "Place", ["-2", "4", "1"]);
        person.type_into("Disc radius", "0.4");
        person.type_into("Brightness", "0.1");
        person.click("Add");
    }
    let lights = &person.scene().lights[before..];
    let kinds: Vec<_> = lights.iter().map(|l| l.source.kind()).collect();
    assert_eq!(kinds, ["ambient", "point", "directional", "disc", "disc"]);
    assert_eq!([lights[0].intensity, lights[1].intensity, lights[4].intensity], [0.2, 0.4, 0.1]);
    let LightSource::Point(point) = &lights[1].source else { panic!() };
    assert_eq!(point.position, Vec3::new(1.0, 3.0, 2.0));
    let LightSource::Directional(sun) = &lights[2].source else { panic!() };
    assert_eq!(sun.direction, Vec3::new(1.0, -2.0, 0.5));
    let LightSource::Disc(disc) = &lights[4].source else { panic!() };
    assert_eq!((disc.position, disc.radius), (Vec3::new(-2.0, 4.0, 1.0), 0.4));
}

/// A parameter of a thing as the scene file says it.
pub fn value(person: &Person, thing: &Thing, key: &str) -> Value {
    let scene = person.scene();
    scene.value(thing.owner(scene).expect("it is there"), key).expect("it has that")
}
