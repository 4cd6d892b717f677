//! The search against the solvers that know all ways, and against rays followed forwards.

use vitrine_math::DVec3;

use super::super::Chains;
use super::super::planes::{self, Stack};
use super::super::sphere::{self, Ball, Way};
use super::super::trial::{self, Dice, Event, event, measured_spread, miss, steepness};
use super::*;

fn interface(surface: Surface, before: f64, behind: f64) -> Interface {
    Interface { surface, before, behind, is_mirror: false }
}

fn events(interfaces: &[Interface]) -> Vec<Event> {
    let one = |i: &Interface| {
        let surface = match i.surface {
            Surface::Plane { point, n } => trial::Surface::Plane { n, offset: n.dot(point) },
            Surface::Ball { center, radius } => trial::Surface::Ball { center, radius },
        };
        event(surface, i.before, if i.is_mirror { i.before } else { i.behind })
    };
    interfaces.iter().map(one).collect()
}

/// A pane at z = 0 and a ball behind it.
fn pane_and_ball(dice: &mut Dice) -> Vec<Interface> {
    let n = (DVec3::Z + dice.direction() * 0.3).normalize();
    let pane = |z: f64| Surface::Plane { point: DVec3::Z * z, n };
    let ball = Surface::Ball { center: DVec3::new(0.1, -0.1, 1.5), radius: dice.between(0.3, 0.8) };
    let eta = dice.between(1.2, 1.9);
    vec![
        interface(pane(0.0), 1.0, 1.5),
        interface(pane(0.05), 1.5, 1.0),
        interface(ball, 1.0, eta),
        interface(ball, eta, 1.0),
    ]
}

#[test]
fn light_behind_a_pane_and_a_ball_is_found_with_its_spread() {
    let mut dice = Dice(31);
    let (mut found, mut compared) = (0, 0);
    for k in 0..2000 {
        let interfaces = pane_and_ball(&mut dice);
        let x = DVec3::new(dice.between(-0.5, 0.5), dice.between(-0.5, 0.5), dice.between(-2.0, -1.0));
        let y = DVec3::new(dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), dice.between(2.6, 4.0));
        let target = if k % 3 == 0 { Target::Distant((y - x).normalize()) } else { Target::Point(y) };
        let Some(chain) = connect(x, target, &interfaces) else { continue };
        found += 1;
        let events = events(&interfaces);
        let missed = miss(x, target, &chain, &events, 1.0);
        assert!(missed < 1e-9, "{k}: off by {missed:e}");
        let steep = steepness(&chain, &events);
        if steep > 0.1 && chain.spread < 100.0 {
            compared += 1;
            let measured = measured_spread(x, target, &chain, &events, 1e-4 * steep * steep);
            assert!((chain.spread / measured - 1.0).abs() < 1e-5, "{k}: {} {measured}", chain.spread);
        }
    }
    assert!(found > 1800 && compared > 1500, "{found} {compared}");
}

#[test]
fn what_it_finds_is_one_of_the_ways_that_the_others_know() {
    let mut dice = Dice(32);
    let mut out = Chains::default();
    let (mut in_ball, mut in_pane, mut known) = (0, 0, 0);
    for _ in 0..2000 {
        let ball = Ball { center: dice.direction() * 0.2, radius: 1.0, eta: dice.between(1.2, 2.0) };
        let surface = Surface::Ball { center: ball.center, radius: 1.0 };
        let (x, y) = (dice.direction() * 3.0, dice.direction() * dice.between(1.5, 4.0));
        let through = [interface(surface, 1.0, ball.eta), interface(surface, ball.eta, 1.0)];
        out.clear();
        sphere::connect(x, Target::Point(y), &ball, Way::Across(0), &mut out);
        known += usize::from(!out.as_slice().is_empty());
        if let Some(chain) = connect(x, Target::Point(y), &through) {
            in_ball += 1;
            let same = |c: &&Chain| (c.wx - chain.wx).length() < 1e-8;
            let other = out.as_slice().iter().find(same).unwrap();
            assert!((chain.spread / other.spread - 1.0).abs() < 1e-5 || chain.spread > 100.0);
        }
        let n = dice.direction();
        let stack = Stack { n, offsets: &[0.0, 0.3], indices: &[1.0, 1.5, 1.2] };
        let (x, y) = (x - n * (n.dot(x) + 0.5), y - n * (n.dot(y) - 1.0));
        let plane = |k: usize| Surface::Plane { point: n * stack.offsets[k], n };
        let pane = [interface(plane(0), 1.0, 1.5), interface(plane(1), 1.5, 1.2)];
        let expected = planes::connect(x, Target::Point(y), &stack).unwrap();
        let chain = connect(x, Target::Point(y), &pane).unwrap();
        in_pane += 1;
        assert!(
            (chain.wx - expected.wx).length() < 1e-9 && (chain.spread / expected.spread - 1.0).abs() < 1e-6
        );
    }
    assert!(in_pane == 2000 && in_ball * 10 > known * 9, "{in_ball} of {known}");
}

#[test]
fn a_mirror_on_the_way_reflects() {
    let mirror = Interface {
        is_mirror: true,
        ..interface(Surface::Plane { point: DVec3::ZERO, n: DVec3::Z }, 1.0, 1.0)
    };
    let ball = Surface::Ball { center: DVec3::new(1.5, 0.0, 1.2), radius: 0.4 };
    let way = [mirror, interface(ball, 1.0, 1.5), interface(ball, 1.5, 1.0)];
    let (x, target) = (DVec3::new(0.0, 0.1, 1.0), Target::Point(DVec3::new(3.0, 0.0, 2.3)));
    let chain = connect(x, target, &way).unwrap();
    assert!(miss(x, target, &chain, &events(&way), 1.0) < 1e-9);
    let measured = measured_spread(x, target, &chain, &events(&way), 1e-5);
    assert!((chain.spread / measured - 1.0).abs() < 1e-5);
}

#[test]
fn places_without_an_answer_give_none_and_never_nan() {
    let interfaces = pane_and_ball(&mut Dice(33));
    let places = [
        DVec3::ZERO,
        DVec3::Z,
        -DVec3::Z,
        DVec3::new(0.1, -0.1, 1.5),
        DVec3::splat(1e15),
        DVec3::NAN,
        -DVec3::Z * 2.0,
        DVec3::Z * 3.0,
    ];
    let mut found = 0;
    for (x, y) in places.iter().flat_map(|&a| places.map(|b| (a, b))) {
        for target in [Target::Point(y), Target::Distant(y.normalize_or(DVec3::Z))] {
            for count in 0..=4 {
                if let Some(chain) = connect(x, target, &interfaces[..count]) {
                    found += 1;
                    assert!(chain.is_sound() && (chain.wx.length() - 1.0).abs() < 1e-12);
                }
            }
        }
    }
    assert!(found > 20, "{found}");
}
