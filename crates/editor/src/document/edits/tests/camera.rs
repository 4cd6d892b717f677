//! Ways to move the camera.

use crate::document::tests::{assert_near, edit, refused, shelf};
use crate::document::{CameraMove, Document, EditCommand, EditError, Thing};
use vitrine::math::{Axis, Vec3};
use vitrine::scene::Value;

fn to(document: &mut Document, change: CameraMove) {
    edit(document, EditCommand::Camera(change));
}

fn stand(document: &mut Document, position: Vec3, turn_deg: Vec3) {
    for (key, value) in [("position", position), ("turn_deg", turn_deg)] {
        let value = Value::Vector(value);
        document.apply(EditCommand::Set { things: vec![Thing::Camera], key: key.into(), value }).unwrap();
    }
}

/// Where a point is in the picture: to the right, up, and how far away.
fn seen(document: &Document, p: Vec3) -> Vec3 {
    let camera = &document.scene().camera;
    let inside = camera.rotation().transpose() * (p - camera.position);
    Vec3::new(inside.x / -inside.z, inside.y / -inside.z, -inside.z)
}

/// The camera's right is level and its up points up.
#[track_caller]
fn assert_upright(document: &Document) {
    let rotation = document.scene().camera.rotation();
    assert!(rotation.x_axis.y.abs() < 1e-5 && rotation.y_axis.y >= 0.0, "{rotation}");
}

/// The camera comes to given coordinates and is turned by a given angle about a given axis.
#[test]
fn c13_turned_by_an_angle_about_an_axis() {
    for (axis, angle_deg) in [(Axis::X, 30.0), (Axis::Y, -110.0), (Axis::Z, 75.0)] {
        let mut document = shelf();
        stand(&mut document, Vec3::new(1.0, 2.0, 3.0), Vec3::new(10.0, 20.0, 0.0));
        let wanted = axis.rotation_deg(angle_deg) * document.scene().camera.rotation();
        to(&mut document, CameraMove::Turn { axis, angle_deg });
        let camera = &document.scene().camera;
        assert!(camera.rotation().abs_diff_eq(wanted, 1e-5), "{axis:?}");
        assert_eq!(camera.position, Vec3::new(1.0, 2.0, 3.0));
        document.undo();
        edit(&mut document, EditCommand::Turn { things: vec![Thing::Camera], axis, angle_deg });
        assert!(document.scene().camera.rotation().abs_diff_eq(wanted, 1e-5), "{axis:?}");
    }
}

#[test]
fn around_a_point_it_stays_upright_and_the_point_stays_in_the_picture() {
    let mut document = shelf();
    stand(&mut document, Vec3::new(1.0, 2.0, 6.0), Vec3::new(-10.0, 15.0, 0.0));
    let around = Vec3::new(0.5, 0.2, -1.0);
    for (right_deg, up_deg) in [(30.0, 0.0), (0.0, 20.0), (-100.0, -35.0), (10.0, 500.0), (10.0, -500.0)] {
        let before = seen(&document, around);
        to(&mut document, CameraMove::Orbit { around, right_deg, up_deg });
        assert!((seen(&document, around) - before).length() < 1e-4, "{right_deg}, {up_deg}");
        assert_upright(&document);
    }
}

#[test]
fn around_what_it_looks_at_it_goes_right_and_up() {
    let mut document = shelf();
    let around = document.scene().camera.look_at.unwrap();
    to(&mut document, CameraMove::Orbit { around, right_deg: 90.0, up_deg: 0.0 });
    assert_near(document.scene().camera.position, Vec3::new(8.0, 1.5, 0.0));
    assert_eq!(document.scene().camera.look_at, Some(around), "it looks there as before");
    let height = document.scene().camera.position.y;
    to(&mut document, CameraMove::Orbit { around, right_deg: 0.0, up_deg: 10.0 });
    assert!(document.scene().camera.position.y > height + 1.0);
    assert_upright(&document);
}

#[test]
fn sideways_the_direction_stays() {
    let mut document = shelf();
    let before = document.scene().camera.rotation();
    let right = before.x_axis;
    let position = document.scene().camera.position;
    to(&mut document, CameraMove::Pan { right: 2.0, up: 0.0 });
    assert_near(document.scene().camera.position, position + right * 2.0);
    assert!(document.scene().camera.rotation().abs_diff_eq(before, 1e-6));
}

#[test]
fn nearer_the_point_stays_where_it_is_in_the_picture() {
    for point in [Vec3::new(0.0, 0.5, 0.0), Vec3::new(2.0, 1.0, -1.0)] {
        let mut document = shelf();
        let before = seen(&document, point);
        to(&mut document, CameraMove::Zoom { toward: point, factor: 2.0 });
        let after = seen(&document, point);
        assert_near(after, before.with_z(before.z / 2.0));
    }
    let mut document = shelf();
    for factor in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let zoom = EditCommand::Camera(CameraMove::Zoom { toward: Vec3::ZERO, factor });
        assert_eq!(refused(&mut document, zoom), EditError::BadNumbers);
    }
}

#[test]
fn it_looks_at_a_point_and_not_at_where_it_stands() {
    let mut document = shelf();
    to(&mut document, CameraMove::LookAt(Vec3::new(3.0, 0.0, 1.0)));
    let middle = seen(&document, Vec3::new(3.0, 0.0, 1.0));
    assert!(middle.truncate().length() < 1e-6);
    let at = document.scene().camera.position;
    let error = refused(&mut document, EditCommand::Camera(CameraMove::LookAt(at)));
    assert!(matches!(error, EditError::Scene(_)));
}

#[test]
fn a_framed_ball_fills_the_picture_from_the_same_side() {
    for size in [[800, 400], [400, 800]] {
        for aims in [true, false] {
            let mut document = shelf();
            let value = Value::Size(size);
            document
                .apply(EditCommand::Set { things: vec![Thing::Settings], key: "size".into(), value })
                .unwrap();
            if !aims {
                stand(&mut document, Vec3::new(0.0, 3.0, 9.0), Vec3::new(-20.0, 10.0, 0.0));
            }
            let before = document.scene().camera.rotation();
            let (center, radius) = (Vec3::new(4.0, 1.0, 2.0), 1.5);
            to(&mut document, CameraMove::Frame { center, radius });
            let camera = &document.scene().camera;
            assert!(camera.rotation().abs_diff_eq(before, 1e-5));
            let middle = seen(&document, center);
            assert!(middle.truncate().length() < 1e-5, "in the middle");
            // The angle that the ball takes, as a part of the picture's narrower side.
            let half =
                (camera.view_angle_deg / 2.0).to_radians().tan() * (size[0] as f32 / size[1] as f32).min(1.0);
            let share = (radius / middle.z).asin() / half.atan();
            assert!((0.8..1.0).contains(&share), "{size:?}: {share}");
        }
    }
    let mut document = shelf();
    let nothing = CameraMove::Frame { center: Vec3::ZERO, radius: 0.0 };
    assert_eq!(refused(&mut document, EditCommand::Camera(nothing)), EditError::BadNumbers);
}
