//! Prisms and boxes against rays followed forwards, and against panes.

use vitrine_math::DVec3;

use super::super::planes::{self, Stack};
use super::super::trial::{Dice, Event, Surface, event, follow, measured_spread, miss, steepness};
use super::*;

fn events(faces: &[Face]) -> Vec<Event> {
    let one = |f: &Face| {
        let surface = Surface::Plane { n: f.n, offset: f.n.dot(f.point) };
        // Equal indices would be taken for a mirror.
        event(surface, f.before, if f.is_mirror { f.before } else { f.behind * (1.0 + 1e-15) })
    };
    faces.iter().map(one).collect()
}

/// A way that light takes, made by following a ray: faces in its path, and its other end.
fn known_way(dice: &mut Dice, mirrors: bool) -> Option<(DVec3, DVec3, DVec3, Vec<Face>)> {
    let x = dice.direction();
    let start = dice.direction();
    let (mut p, mut w) = (x, start);
    let mut before = 1.0;
    let mut faces: Vec<Face> = Vec::new();
    for _ in 0..1 + (dice.unit() * 5.0) as usize {
        let point = p + w * dice.between(0.02, 1.5);
        let n = dice.direction();
        if n.dot(w).abs() < 0.05 {
            return None;
        }
        let is_mirror = mirrors && dice.unit() < 0.3;
        let behind = if is_mirror { before } else { dice.between(1.0, 2.0) };
        let face = Face { point, n, before, behind, is_mirror };
        faces.push(Face { point: point + n.any_orthonormal_vector() * dice.between(-1.0, 1.0), ..face });
        (p, w) = follow(p, w, &events(&[face]))?;
        before = behind;
    }
    Some((x, start, p + w * dice.between(0.02, 2.0), faces))
}

#[test]
fn every_way_that_a_ray_has_gone_is_found() {
    let mut dice = Dice(21);
    let (mut found, mut compared) = (0, 0);
    while found < 50_000 {
        let Some((x, start, y, faces)) = known_way(&mut dice, found % 2 == 0) else { continue };
        let target = Target::Point(y);
        let chain = connect(x, target, &faces, Care::Full)
            .unwrap_or_else(|| panic!("not found, after {found}: {x} {y} {faces:?}"));
        found += 1;
        let events = events(&faces);
        let steep = steepness(&chain, &events);
        assert!((chain.wx - start).length() < 1e-9 / steep, "{} {start}", chain.wx);
        if steep < 0.1 || found % 8 != 0 {
            continue;
        }
        compared += 1;
        assert!(miss(x, target, &chain, &events, 1.0) < 1e-9);
        let measured = measured_spread(x, target, &chain, &events, 1e-4 * steep * steep);
        assert!((chain.spread / measured - 1.0).abs() < 1e-5, "{} {measured}", chain.spread);
    }
    assert!(compared > 1000, "{compared}");
}

#[test]
fn a_distant_light_is_found_where_a_ray_has_left_towards_it() {
    let mut dice = Dice(22);
    let mut found = 0;
    while found < 5000 {
        let Some((x, start, _, faces)) = known_way(&mut dice, found % 2 == 0) else { continue };
        let events = events(&faces);
        let Some((_, out)) = follow(x, start, &events) else { continue };
        let target = Target::Distant(out);
        let chain = connect(x, target, &faces, Care::Full)
            .unwrap_or_else(|| panic!("not found, after {found}: {x} {out} {faces:?}"));
        found += 1;
        let steep = steepness(&chain, &events);
        assert!((chain.wx - start).length() < 1e-8 / (steep * steep), "{} {start}", chain.wx);
        if steep > 0.1 {
            let measured = measured_spread(x, target, &chain, &events, 1e-4 * steep * steep);
            assert!((chain.spread / measured - 1.0).abs() < 1e-5, "{} {measured}", chain.spread);
        }
    }
}

#[test]
fn parallel_faces_agree_with_the_pane() {
    let mut dice = Dice(23);
    for _ in 0..500 {
        let n = dice.direction();
        let n1 = dice.between(1.1, 2.0);
        let stack = Stack { n, offsets: &[0.1, 0.3], indices: &[1.0, n1, 1.3] };
        let x = n.any_orthonormal_vector() * dice.between(-2.0, 2.0);
        let y = n * dice.between(0.4, 2.0);
        let pane = planes::connect(x, Target::Point(y), &stack).unwrap();
        let face =
            |offset: f64, before, behind| Face { point: n * offset, n, before, behind, is_mirror: false };
        let chain =
            connect(x, Target::Point(y), &[face(0.1, 1.0, n1), face(0.3, n1, 1.3)], Care::Full).unwrap();
        assert!((chain.wx - pane.wx).length() < 1e-10 && (chain.wy - pane.wy).length() < 1e-10);
        assert!((chain.spread / pane.spread - 1.0).abs() < 1e-9);
    }
}

#[test]
fn a_prism_turns_light_by_37_18_degrees_at_least() {
    // 2 asin(n sin(A/2)) − A with n = 1.5 and A = 60°
    let n_of = |angle: f64| DVec3::new(angle.cos(), angle.sin(), 0.0);
    let a = 30_f64.to_radians();
    let face = |point: DVec3, n, before, behind| Face { point, n, before, behind, is_mirror: false };
    let faces = [face(-DVec3::X, n_of(-a), 1.0, 1.5), face(DVec3::X, n_of(a), 1.5, 1.0)];
    let half = (1.5 * a.sin()).asin() - a;
    // The symmetric way runs along the base of the prism inside.
    let x = DVec3::new(-1.0 - 2.0 * half.cos(), -2.0 * half.sin(), 0.0);
    let y = DVec3::new(-x.x, x.y, 0.0);
    let chain = connect(x, Target::Point(y), &faces, Care::Full).unwrap();
    let turned = chain.wx.dot(-chain.wy).acos().to_degrees();
    assert!((turned - 37.18).abs() < 0.005, "{turned}");
}

#[test]
fn without_a_face_it_is_the_straight_line() {
    let chain = connect(DVec3::ZERO, Target::Point(DVec3::Z * 2.0), &[], Care::Full).unwrap();
    assert!((chain.spread - 0.25).abs() < 1e-15 && chain.wx == DVec3::Z && chain.wy == -DVec3::Z);
    let chain = connect(DVec3::ZERO, Target::Distant(DVec3::Z), &[], Care::Full).unwrap();
    assert!(chain.spread == 1.0 && chain.wx == DVec3::Z);
}

#[test]
fn places_without_an_answer_give_none_and_never_nan() {
    let face = |point: DVec3, n| Face { point, n, before: 1.0, behind: 1.5, is_mirror: false };
    let places = [
        DVec3::ZERO,
        DVec3::X,
        -DVec3::X,
        DVec3::Y,
        DVec3::new(1.0, 1e-15, 0.0),
        DVec3::new(-3.0, 2.0, 1.0),
        DVec3::splat(1e15),
        DVec3::NAN,
    ];
    for normals in [[DVec3::X, DVec3::Y], [DVec3::X, DVec3::X], [DVec3::X, -DVec3::X]] {
        for mirror in [false, true] {
            for (x, y) in places.iter().flat_map(|&a| places.map(|b| (a, b))) {
                let second =
                    Face { before: 1.5, behind: 1.0, is_mirror: mirror, ..face(DVec3::X, normals[1]) };
                let faces = [face(DVec3::ZERO, normals[0]), second];
                let w = y.normalize_or(DVec3::Z);
                for target in [Target::Point(y), Target::Distant(w)] {
                    for count in 0..=2 {
                        if let Some(chain) = connect(x, target, &faces[..count], Care::Full) {
                            assert!(chain.is_sound(), "{x} {target:?}");
                            assert!((chain.wx.length() - 1.0).abs() < 1e-9);
                        }
                    }
                }
            }
        }
    }
}
