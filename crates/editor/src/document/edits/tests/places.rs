//! Moving, turning, scaling, setting down.

use crate::document::tests::{assert_near, document_of, edit, object, objects, point, refused, shelf};
use crate::document::{Document, EditCommand, EditError, Thing, bounds_of};
use vitrine::math::{Axis, Mat3, Vec3};
use vitrine::scene::{Shape, Value};

fn turn(things: Vec<Thing>, axis: Axis, angle_deg: f32) -> EditCommand {
    EditCommand::Turn { things, axis, angle_deg }
}

fn value(document: &Document, thing: &Thing, key: &str) -> Vec3 {
    match document.scene().value(thing.owner(document.scene()).unwrap(), key) {
        Some(Value::Vector(v)) => v,
        other => panic!("{key} is {other:?}"),
    }
}

/// The map of directions from an object's own space to the world.
fn directions(document: &Document, name: &str) -> Mat3 {
    Mat3::from(document.scene().world_from_object(object(document, name)).world_from_object.matrix3)
}

#[test]
fn c14_objects_groups_lights_and_the_camera_move_along_the_worlds_axes() {
    let mut document = shelf();
    let by = Vec3::new(1.0, -0.5, 0.25);
    // The box is in a group that is turned and twice as large.
    for name in ["box", "pane"] {
        let before = point(&document, name, Vec3::ONE);
        edit(&mut document, EditCommand::Move { things: objects([name]), by });
        assert_near(point(&document, name, Vec3::ONE), before + by);
    }
    let before = point(&document, "ball", Vec3::ZERO);
    let things = vec![
        Thing::group("shelf"),
        Thing::object("ball"),
        Thing::light("lamp"),
        Thing::light("sun"),
        Thing::Camera,
    ];
    let target = document.scene().camera.look_at.unwrap();
    edit(&mut document, EditCommand::Move { things, by });
    assert_near(point(&document, "ball", Vec3::ZERO), before + by);
    assert_near(value(&document, &Thing::light("lamp"), "position"), Vec3::new(2.0, 5.0, 3.0) + by);
    assert_eq!(document.scene().camera.look_at, Some(target + by));
    for nothing in [Thing::light("sun"), Thing::material("glass"), Thing::Settings] {
        let command = EditCommand::Move { things: vec![nothing], by };
        assert_eq!(refused(&mut document, command), EditError::NotPossible);
    }
    let far = EditCommand::Move { things: objects(["ball"]), by: Vec3::INFINITY };
    assert!(matches!(refused(&mut document, far), EditError::Param { .. }));
}

#[test]
fn c14_things_turn_about_the_worlds_axes_through_their_own_centres() {
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        let mut document = shelf();
        for name in ["box", "floor"] {
            let (center, before) = (point(&document, name, Vec3::ZERO), directions(&document, name));
            edit(&mut document, turn(objects([name]), axis, 25.0));
            assert_near(point(&document, name, Vec3::ZERO), center);
            let wanted = axis.rotation_deg(25.0) * before;
            let got = directions(&document, name);
            assert!(got.abs_diff_eq(wanted, 1e-5), "{name}, {axis:?}: {got} instead of {wanted}");
        }
        // A group turns with all that is in it.
        let (center, before) = (Vec3::new(1.0, 0.0, -1.0), point(&document, "ball", Vec3::X));
        edit(&mut document, turn(vec![Thing::group("shelf"), Thing::object("ball")], axis, -70.0));
        assert_near(point(&document, "ball", Vec3::X), center + axis.rotation_deg(-70.0) * (before - center));
    }
}

#[test]
fn c14_sunlight_turns_and_a_bulb_does_not() {
    let mut document = shelf();
    edit(&mut document, turn(vec![Thing::light("sun")], Axis::X, 90.0));
    assert_near(value(&document, &Thing::light("sun"), "direction"), Vec3::NEG_Z);
    let command = turn(vec![Thing::light("lamp")], Axis::X, 90.0);
    assert_eq!(refused(&mut document, command), EditError::NotPossible);
    let command = turn(objects(["ball"]), Axis::X, f32::NAN);
    assert_eq!(refused(&mut document, command), EditError::BadNumbers);
}

#[test]
fn turns_add_up_to_numbers_that_read_well() {
    let mut document = shelf();
    for _ in 0..8 {
        edit(&mut document, turn(objects(["pane"]), Axis::Y, 15.0));
    }
    assert_eq!(object(&document, "pane").turn_deg, Vec3::new(0.0, 120.0, 0.0));
}

#[test]
fn a_triangle_turns_and_grows_about_its_middle_wherever_its_corners_are() {
    let mut document = shelf();
    let corners = vec![Vec3::new(5.0, 0.0, 0.0), Vec3::new(6.0, 0.0, 0.0), Vec3::new(5.5, 3.0, 0.0)];
    let set =
        EditCommand::Set { things: objects(["pane"]), key: "points".into(), value: Value::Points(corners) };
    edit(&mut document, set);
    let middle = |d: &Document| {
        let Shape::Triangle(t) = &object(d, "pane").shape else { panic!() };
        t.points.map(|p| point(d, "pane", p)).iter().sum::<Vec3>() / 3.0
    };
    let before = middle(&document);
    edit(&mut document, turn(objects(["pane"]), Axis::Z, 90.0));
    assert_near(middle(&document), before);
    edit(&mut document, EditCommand::Resize { things: objects(["pane"]), by: Vec3::splat(3.0) });
    assert_near(middle(&document), before);
}

#[test]
fn c14_things_grow_along_their_own_axes() {
    let mut document = shelf();
    let by = Vec3::new(2.0, 1.0, 3.0);
    let resize = |things: Vec<Thing>| EditCommand::Resize { things, by };
    edit(&mut document, resize(objects(["box"])));
    edit(&mut document, resize(vec![Thing::group("shelf")]));
    assert_eq!(object(&document, "box").scale, by);
    assert_eq!(value(&document, &Thing::group("shelf"), "scale"), by * 2.0);
    let lamp = vec![Thing::light("lamp")];
    edit(&mut document, EditCommand::Resize { things: lamp, by: Vec3::splat(4.0) });
    assert!(document.text().contains("radius = 2.0"), "{}", document.text());
    let nothing = EditCommand::Resize { things: objects(["ball"]), by: Vec3::new(1.0, 0.0, 1.0) };
    assert_eq!(refused(&mut document, nothing), EditError::BadNumbers);
    let huge = EditCommand::Resize { things: objects(["ball"]), by: Vec3::splat(f32::MAX) };
    edit(&mut document, huge);
    let huger = EditCommand::Resize { things: objects(["ball"]), by: Vec3::splat(10.0) };
    assert!(matches!(refused(&mut document, huger), EditError::Param { .. }));
    assert_eq!(refused(&mut document, resize(vec![Thing::Camera])), EditError::NotPossible);
}

#[test]
fn what_turns_stays_where_it_is() {
    let mut document = shelf();
    // A box and a group turn about their origins, a triangle about its middle.
    let origin = [("box", Vec3::ZERO), ("ball", Vec3::ZERO)];
    for (name, of) in origin {
        let before = point(&document, name, of);
        edit(&mut document, turn(objects([name]), Axis::X, 35.0));
        assert_near(point(&document, name, of), before);
    }
    let middle = |document: &Document| {
        let Shape::Triangle(triangle) = &object(document, "pane").shape else {
            panic!("a pane is a triangle")
        };
        let middle = triangle.points.into_iter().sum::<Vec3>() / 3.0;
        point(document, "pane", middle)
    };
    let before = middle(&document);
    edit(&mut document, turn(objects(["pane"]), Axis::X, 35.0));
    assert_near(middle(&document), before);
}

/// A table of height 1 on a floor at −1, and a ball of radius 0.5 somewhere.
fn table(ball: &str) -> Document {
    document_of(&format!(
        "format = 1\n\
         [[object]]\nname = \"floor\"\nshape = \"plane\"\nposition = [0.0, -1.0, 0.0]\n\
         [[object]]\nname = \"table\"\nshape = \"box\"\nsize = [2.0, 1.0, 2.0]\nposition = [0.0, -0.5, 0.0]\n\
         [[object]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.5\nposition = {ball}\n\
         [[object]]\nname = \"other\"\nshape = \"sphere\"\nradius = 0.5\nposition = [0.0, 7.0, 0.0]\n"
    ))
}

fn foot(document: &Document, name: &str) -> f32 {
    bounds_of(document.scene(), document.assets(), &objects([name])).min.y
}

#[test]
fn things_are_set_down_on_the_highest_thing_below() {
    for (place, wanted, what) in [
        ("[0.0, 4.0, 0.0]", 0.0, "the table"),
        ("[3.0, 4.0, 0.0]", -1.0, "the floor"),
        ("[3.0, -1.2, 0.0]", -1.0, "lifted out of the floor"),
        ("[0.0, 0.3, 0.0]", 0.0, "lifted out of the table"),
        ("[0.0, -0.4, 0.0]", -1.0, "too deep in the table"),
    ] {
        let mut document = table(place);
        edit(&mut document, EditCommand::DropToFloor(objects(["ball"])));
        let foot = foot(&document, "ball");
        assert!((foot - wanted).abs() < 1e-5, "{what}: {foot}");
        document.apply(EditCommand::DropToFloor(objects(["ball"]))).unwrap();
        assert_eq!(document.history().undoable(), 1, "{what}: it stands already");
    }
}

#[test]
fn a_pile_is_set_down_as_a_pile_and_what_is_hidden_carries_nothing() {
    let mut document = table("[0.0, 4.0, 0.0]");
    edit(&mut document, EditCommand::DropToFloor(objects(["other", "ball"])));
    assert!((foot(&document, "ball") - 0.0).abs() < 1e-5);
    assert!((foot(&document, "other") - 1.0).abs() < 1e-5);
    edit(&mut document, EditCommand::Show { things: objects(["table", "floor"]), visible: false });
    edit(&mut document, EditCommand::Move { things: objects(["ball"]), by: Vec3::Y });
    edit(&mut document, EditCommand::DropToFloor(objects(["ball"])));
    assert!(foot(&document, "ball").abs() < 1e-5, "without a floor there is y = 0");
    let plane = EditCommand::DropToFloor(objects(["floor"]));
    assert_eq!(refused(&mut document, plane), EditError::NotPossible);
}

#[test]
fn small_things_fall_on_wide_ones_and_wide_ones_on_small_ones() {
    let mut document = table("[400.0, 4.0, -300.0]");
    let by = Vec3::new(1000.0, 1.0, 1000.0);
    edit(&mut document, EditCommand::Resize { things: objects(["table"]), by });
    edit(&mut document, EditCommand::DropToFloor(objects(["ball"])));
    assert!(foot(&document, "ball").abs() < 1e-3);
    edit(&mut document, EditCommand::Move { things: objects(["table"]), by: Vec3::Y * 50.0 });
    edit(&mut document, EditCommand::DropToFloor(objects(["table"])));
    assert!((foot(&document, "table") - 7.5).abs() < 1e-3, "on the ball that hangs at 7 m");
}

#[test]
fn what_is_in_a_turned_group_is_set_down_in_the_world() {
    let mut document = shelf();
    edit(&mut document, turn(vec![Thing::group("shelf")], Axis::X, 40.0));
    edit(&mut document, EditCommand::Show { things: objects(["box"]), visible: false });
    edit(&mut document, EditCommand::DropToFloor(objects(["ball"])));
    assert!(foot(&document, "ball").abs() < 1e-5);
    edit(&mut document, EditCommand::Show { things: objects(["box"]), visible: true });
    let up = Vec3::new(0.0, 3.0, 0.0);
    edit(&mut document, EditCommand::Move { things: vec![Thing::group("shelf")], by: up });
    edit(&mut document, EditCommand::DropToFloor(vec![Thing::group("shelf")]));
    let bounds = bounds_of(document.scene(), document.assets(), &[Thing::group("shelf")]);
    assert!(bounds.min.y.abs() < 1e-5, "{bounds:?}");
}

#[test]
fn bounds_hold_the_surface_and_touch_it() {
    let mut document = shelf();
    let by = Vec3::new(1.0, 2.0, 0.5);
    edit(&mut document, EditCommand::Resize { things: objects(["ball"]), by });
    edit(&mut document, turn(objects(["ball"]), Axis::Z, 33.0));
    let bounds = bounds_of(document.scene(), document.assets(), &objects(["ball"]));
    let mut touched = Vec3::splat(f32::INFINITY);
    for i in 0..200 {
        for j in 0..100 {
            let (a, b) = (i as f32 * 0.0314, j as f32 * 0.0314);
            let p = 0.5 * Vec3::new(a.cos() * b.sin(), b.cos(), a.sin() * b.sin());
            let p = point(&document, "ball", p);
            assert!((p - p.clamp(bounds.min, bounds.max)).length() < 1e-5, "{p} is outside {bounds:?}");
            touched = touched.min(bounds.max - p);
        }
    }
    assert!(touched.max_element() < 2e-3, "{touched}");
}
