//! Balls against rays followed forwards, and the count of solutions against a scan.

use vitrine_math::DVec3;

use super::super::MAX_CHAINS;
use super::super::trial::{Dice, Event, Surface, event, measured_spread, miss, missed_chains, steepness};
use super::*;

/// A ball with a place for each end.
fn ball(dice: &mut Dice, bubbles: bool) -> Ball {
    let eta = dice.between(1.05, 2.4);
    let eta = if bubbles && dice.unit() < 0.3 { 1.0 / eta } else { eta };
    Ball { center: dice.direction() * dice.between(0.0, 3.0), radius: dice.between(0.1, 2.0), eta }
}

fn outside(dice: &mut Dice, ball: &Ball) -> DVec3 {
    let share = dice.unit();
    ball.center + dice.direction() * ball.radius * (1.01 + 5.0 * share * share * share)
}

fn inside(dice: &mut Dice, ball: &Ball) -> DVec3 {
    ball.center + dice.direction() * ball.radius * dice.between(0.02, 0.98)
}

/// What a ray meets on the way.
fn events(ball: &Ball, way: Way) -> Vec<Event> {
    let surface = Surface::Ball { center: ball.center, radius: ball.radius };
    let n = ball.eta;
    let (enter, mirror, leave) = (event(surface, 1.0, n), event(surface, n, n), event(surface, n, 1.0));
    let inside = |k: u32| vec![mirror; k as usize];
    match way {
        Way::Off => vec![event(surface, 1.0, 1.0)],
        Way::Across(k) => [vec![enter], inside(k), vec![leave]].concat(),
        Way::Out(k) => [inside(k), vec![leave]].concat(),
        Way::In(k) => [vec![enter], inside(k)].concat(),
        Way::Within(k) => inside(k),
    }
}

fn ends(dice: &mut Dice, ball: &Ball, way: Way) -> (DVec3, DVec3) {
    let place = |dice: &mut Dice, is_inside: bool| {
        if is_inside { inside(dice, ball) } else { outside(dice, ball) }
    };
    let x = place(dice, matches!(way, Way::Out(_) | Way::Within(_)));
    (x, place(dice, matches!(way, Way::In(_) | Way::Within(_))))
}

const WAYS: [Way; 9] = [
    Way::Off,
    Way::Across(0),
    Way::Across(1),
    Way::Across(2),
    Way::Out(0),
    Way::Out(1),
    Way::In(0),
    Way::In(1),
    Way::Within(1),
];

#[test]
fn every_way_obeys_snell_and_its_spread_is_the_derivative() {
    let mut dice = Dice(2);
    let mut out = Chains::default();
    for way in WAYS {
        let mut found = 0;
        for k in 0..1000 {
            let ball = ball(&mut dice, true);
            let (x, y) = ends(&mut dice, &ball, way);
            let target = if k % 3 == 0 && !matches!(way, Way::In(_) | Way::Within(_)) {
                Target::Distant(dice.direction())
            } else {
                Target::Point(y)
            };
            out.clear();
            connect(x, target, &ball, way, &mut out);
            let events = events(&ball, way);
            for chain in out.as_slice() {
                found += 1;
                let missed = miss(x, target, chain, &events, ball.radius);
                let steep = steepness(chain, &events);
                assert!(missed < 1e-9, "{way:?} {k}: off by {missed:e}, steepness {steep}");
                if steep < 0.05 {
                    continue;
                }
                let size = (ball.radius / (x - ball.center).length()).min(1.0);
                let measured = measured_spread(x, target, chain, &events, 3e-4 * steep * steep * size);
                let error = (chain.spread / measured - 1.0).abs();
                assert!(
                    error < 1e-5,
                    "{way:?} {k}: {} against {measured}, off by {error:e}, steep {steep} {target:?} {x} {ball:?}",
                    chain.spread
                );
            }
        }
        assert!(found > 300, "{way:?}: {found}");
    }
}

/// Directions from x in the plane of the ends, as dense towards the edge of the ball as the path changes there.
fn fan(x: DVec3, toward: DVec3, ball: &Ball, count: u32) -> (impl Iterator<Item = DVec3>, DVec3) {
    let to_x = (x - ball.center).normalize();
    let across = to_x.cross(toward).normalize();
    let e = across.cross(to_x);
    let rx = (x - ball.center).length();
    let directions = (0..=count).map(move |k| {
        let share = 2.0 * f64::from(k) / f64::from(count) - 1.0;
        if rx > ball.radius {
            let s = ball.radius / rx * (share * core::f64::consts::FRAC_PI_2 * 0.999_999).sin();
            to_x * -(1.0 - s * s).sqrt() + e * s
        } else {
            let (s, c) = (share * core::f64::consts::PI).sin_cos();
            to_x * c + e * s
        }
    });
    (directions, across)
}

/// Looks for chains of one way that the search misses, in random places.
fn scan(way: Way, dice: &mut Dice, places: u32, rays: u32) -> usize {
    let mut out = Chains::default();
    let (mut seen, mut most) = (0, 0);
    for k in 0..places {
        let ball = ball(dice, true);
        let (x, y) = ends(dice, &ball, way);
        let (target, toward) = if k % 4 == 0 && !matches!(way, Way::In(_) | Way::Within(_)) {
            let w = dice.direction();
            (Target::Distant(w), w)
        } else {
            (Target::Point(y), y - ball.center)
        };
        out.clear();
        connect(x, target, &ball, way, &mut out);
        most = most.max(out.as_slice().len());
        let (directions, across) = fan(x, toward, &ball, rays);
        let (roots, missed) =
            missed_chains((x, target), out.as_slice(), &events(&ball, way), directions, (across, 0.0));
        assert_eq!(
            missed,
            0,
            "{way:?}, place {k}: of {roots} seen, {} found: {ball:?} {x} {target:?}",
            out.as_slice().len()
        );
        seen += roots;
    }
    assert!(most < MAX_CHAINS, "{way:?}: {most} at once");
    seen
}

#[test]
fn no_chain_is_missed_in_100_000_places() {
    let mut dice = Dice(3);
    for way in [Way::Off, Way::Across(0), Way::Across(1)] {
        let seen = scan(way, &mut dice, 100_000, 64);
        assert!(seen > 30_000, "{way:?}: {seen}");
    }
}

#[test]
fn no_chain_is_missed_by_a_close_look() {
    let mut dice = Dice(4);
    for way in WAYS {
        let seen = scan(way, &mut dice, 1000, 2000);
        assert!(seen > 300, "{way:?}: {seen}");
    }
}
