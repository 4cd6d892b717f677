//! Balls against rays followed forwards, and the count of solutions against a scan.

use vitrine_math::DVec3;

use super::super::trial::{Dice, Event, Surface, event, measured_spread, miss};
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
                // How steeply the path meets the surface says how far rounding carries and where differences are smooth.
                let steep = chain
                    .vertices()
                    .windows(2)
                    .map(|p| (p[1] - p[0]).normalize().dot((p[0] - ball.center) / ball.radius).abs())
                    .fold(chain.wx.dot((chain.vertices()[0] - ball.center) / ball.radius).abs(), f64::min);
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
