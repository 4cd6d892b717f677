//! Groups and what is in them.

use crate::document::tests::{assert_near, edit, object, objects, point, refused, shelf};
use crate::document::{Document, EditCommand, EditError, Thing, bounds_of};
use vitrine::math::Vec3;
use vitrine::scene::{ListName, Shape};

/// Corners of some objects in the world.
fn corners<const N: usize>(document: &Document, names: [&str; N]) -> Vec<Vec3> {
    let some = [Vec3::ZERO, Vec3::ONE, Vec3::NEG_X, Vec3::new(0.0, 2.0, 0.5)];
    names.iter().flat_map(|name| some.map(|p| point(document, name, p))).collect()
}

#[track_caller]
fn assert_same(before: &[Vec3], after: &[Vec3]) {
    before.iter().zip(after).for_each(|(a, b)| assert_near(*b, *a));
}

#[test]
fn members_stay_where_they_are_and_the_origin_is_in_their_middle() {
    let mut document = shelf();
    let before = corners(&document, ["ball", "pane", "box"]);
    let middle = bounds_of(document.scene(), document.assets(), &objects(["ball", "pane"])).center();
    // One is in a group that is turned and scaled, one in none.
    edit(&mut document, EditCommand::Group(objects(["ball", "pane"])));
    assert_eq!(document.selection().things(), [Thing::group("group")]);
    assert_same(&before, &corners(&document, ["ball", "pane", "box"]));
    let group = document.scene().group("group").unwrap();
    assert!((group.position - middle).length() < 2e-3 && group.group.is_none());
    // Turned by the group's own 90° and half of its parent's size: told outside of it.
    assert_eq!(object(&document, "ball").turn_deg, Vec3::new(0.0, 90.0, 0.0));
    assert_eq!(object(&document, "ball").scale, Vec3::splat(2.0));
}

#[test]
fn things_of_one_group_get_their_group_inside_it() {
    let mut document = shelf();
    let before = corners(&document, ["ball", "box"]);
    edit(&mut document, EditCommand::Group(objects(["ball", "box"])));
    assert_same(&before, &corners(&document, ["ball", "box"]));
    assert_eq!(document.scene().group("group").unwrap().group.as_deref(), Some("shelf"));
    edit(&mut document, EditCommand::Group(vec![Thing::group("shelf"), Thing::object("pane")]));
    assert_same(&before, &corners(&document, ["ball", "box"]));
    assert_eq!(document.scene().group("shelf").unwrap().group.as_deref(), Some("group 2"));
}

#[test]
fn taken_apart_members_stay_where_they_are() {
    let mut document = shelf();
    let before = corners(&document, ["ball", "box"]);
    edit(&mut document, EditCommand::Ungroup(vec![Thing::group("shelf")]));
    assert_same(&before, &corners(&document, ["ball", "box"]));
    assert_eq!(document.selection().things(), objects(["ball", "box"]));
    assert_eq!(document.scene().names(ListName::Group).count(), 0);
    let place = object(&document, "box");
    assert_eq!((place.turn_deg, place.scale), (Vec3::new(0.0, 120.0, 0.0), Vec3::splat(2.0)));
    assert_eq!(refused(&mut document, EditCommand::Ungroup(objects(["ball"]))), EditError::NotPossible);
}

#[test]
fn groups_in_groups_come_apart_at_once_and_one_by_one() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Group(vec![Thing::group("shelf"), Thing::object("pane")]));
    let before = corners(&document, ["ball", "box", "pane"]);
    let both = EditCommand::Ungroup(vec![Thing::group("group"), Thing::group("shelf")]);
    edit(&mut document, both);
    assert_same(&before, &corners(&document, ["ball", "box", "pane"]));
    assert_eq!(document.scene().groups.len(), 0);
    document.undo();
    edit(&mut document, EditCommand::Ungroup(vec![Thing::group("group")]));
    assert_same(&before, &corners(&document, ["ball", "box", "pane"]));
    assert_eq!(document.scene().group("shelf").unwrap().group, None);
}

#[test]
fn what_is_askew_without_its_group_is_refused_by_name() {
    let mut document = shelf();
    let by = Vec3::new(1.0, 1.0, 3.0);
    edit(&mut document, EditCommand::Resize { things: vec![Thing::group("shelf")], by });
    let error = refused(&mut document, EditCommand::Ungroup(vec![Thing::group("shelf")]));
    assert_eq!(error, EditError::Askew { name: "box".into() });
    let error = refused(&mut document, EditCommand::Group(objects(["box", "pane"])));
    assert_eq!(error, EditError::Askew { name: "box".into() });
}

#[test]
fn the_corners_of_a_triangle_take_up_what_its_group_did_to_it() {
    let mut document = shelf();
    let axis = vitrine::math::Axis::Y;
    edit(&mut document, EditCommand::Turn { things: objects(["pane"]), axis, angle_deg: 30.0 });
    edit(&mut document, EditCommand::Group(objects(["pane"])));
    let by = Vec3::new(1.0, 1.0, 3.0);
    edit(&mut document, EditCommand::Resize { things: vec![Thing::group("group")], by });
    let world = |d: &Document| {
        let Shape::Triangle(t) = &object(d, "pane").shape else { panic!() };
        t.points.map(|p| point(d, "pane", p))
    };
    let before = world(&document);
    edit(&mut document, EditCommand::Ungroup(vec![Thing::group("group")]));
    assert_same(&before, &world(&document));
}

#[test]
fn what_was_hidden_by_its_group_stays_hidden() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Show { things: vec![Thing::group("shelf")], visible: false });
    edit(&mut document, EditCommand::Ungroup(vec![Thing::group("shelf")]));
    assert!(!object(&document, "ball").visible && !object(&document, "box").visible);
}

#[test]
fn only_objects_and_groups_can_be_grouped() {
    let mut document = shelf();
    let others = vec![Thing::Camera, Thing::light("lamp"), Thing::material("glass")];
    assert_eq!(refused(&mut document, EditCommand::Group(others)), EditError::NotPossible);
    edit(&mut document, EditCommand::Group(vec![Thing::object("floor"), Thing::light("lamp")]));
    assert_eq!(object(&document, "floor").group.as_deref(), Some("group"));
}
