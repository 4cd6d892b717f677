//! Balls against rays followed forwards, and the count of solutions against a scan.

use vitrine_math::DVec3;

use super::super::trial::{
    Dice, Event, Surface, event, follow, measured_spread, miss, missed_chains, steepness,
};
use super::super::{Chain, MAX_CHAINS};
use super::*;

/// A ball with a place for each end.
fn ball(dice: &mut Dice, bubbles: bool) -> Ball {
    let eta = dice.between(1.05, 2.4);
    let eta = if bubbles && dice.unit() < 0.3 { 1.0 / eta } else { eta };
    Ball { center: dice.direction() * dice.between(0.0, 3.0), radius: dice.between(0.1, 2.0), eta }
}

fn outside(dice: &mut Dice, ball: &Ball) -> DVec3 {
    let share = dice.unit();
    // Now and then all but touching the ball, or far away.
    let distance = match (dice.unit() * 20.0) as u32 {
        0 => 1.0 + 1e-6 + 1e-5 * share,
        1 => 1000.0,
        _ => 1.01 + 5.0 * share * share * share,
    };
    ball.center + dice.direction() * ball.radius * distance
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
                // From afar the ball is small, and from close by the first leg is short: rounding turns what is measured.
                let height = |p: DVec3| ((p - ball.center).length() / ball.radius - 1.0).abs();
                let is_plain = [x, y].iter().all(|&p| (1e-4..100.0).contains(&height(p)));
                let (most_missed, most) = if is_plain { (1e-9, 1e-5) } else { (1e-8 / steep, 1e-3) };
                assert!(missed < most_missed, "{way:?} {k}: off by {missed:e}, steepness {steep}");
                if steep < 0.05 {
                    continue;
                }
                let size = (ball.radius / (x - ball.center).length()).min(1.0);
                let measured = measured_spread(x, target, chain, &events, 3e-4 * steep * steep * size);
                let error = (chain.spread / measured - 1.0).abs();
                assert!(
                    error < most,
                    "{way:?} {k}: {} against {measured}: {x} {target:?} {ball:?}",
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
        let events = events(&ball, way);
        let trace = |w| follow(x, w, &events);
        let (roots, missed) = missed_chains(target, out.as_slice(), directions, across, trace);
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

#[test]
fn a_known_path_has_the_spread_that_the_search_gives() {
    let mut dice = Dice(5);
    let mut out = Chains::default();
    for way in WAYS {
        for k in 0..1000 {
            let ball = ball(&mut dice, true);
            let (x, y) = ends(&mut dice, &ball, way);
            let target = Target::Point(y);
            out.clear();
            connect(x, target, &ball, way, &mut out);
            for chain in out.as_slice() {
                let spread = spread_of(x, chain.wx, target, &ball, way).unwrap();
                let error = (spread / chain.spread - 1.0).abs();
                let steep = steepness(chain, &events(&ball, way));
                assert!(error < 1e-5 || steep < 1e-2, "{way:?} {k}: {spread} against {}", chain.spread);
            }
        }
    }
}

/// The only chain.
fn only(x: DVec3, target: Target, ball: &Ball, way: Way) -> Chain {
    let mut out = Chains::default();
    connect(x, target, ball, way, &mut out);
    assert_eq!(out.as_slice().len(), 1, "{way:?} {x} {target:?}");
    out.as_slice()[0]
}

#[test]
fn exchanging_the_ends_keeps_n2_times_the_spread() {
    let mut dice = Dice(6);
    let (mut there, mut back) = (Chains::default(), Chains::default());
    for (way, reverse) in [
        (Way::Off, Way::Off),
        (Way::Across(0), Way::Across(0)),
        (Way::Across(1), Way::Across(1)),
        (Way::Out(0), Way::In(0)),
        (Way::Out(1), Way::In(1)),
        (Way::Within(2), Way::Within(2)),
    ] {
        for _ in 0..500 {
            let ball = ball(&mut dice, true);
            let (x, y) = ends(&mut dice, &ball, way);
            there.clear();
            back.clear();
            connect(x, Target::Point(y), &ball, way, &mut there);
            connect(y, Target::Point(x), &ball, reverse, &mut back);
            assert_eq!(there.as_slice().len(), back.as_slice().len());
            let [nx, ny] = way.sides().0.map(|within| if within == 1 { ball.eta } else { 1.0 });
            for a in there.as_slice() {
                // n_x² dω_x/dA_y = n_y² dω_y/dA_x
                let twin = |b: &&Chain| (a.wx - b.wy).length() + (a.wy - b.wx).length() < 1e-6;
                let b = back.as_slice().iter().find(twin).unwrap();
                let error = (nx * nx * a.spread / (ny * ny * b.spread) - 1.0).abs();
                assert!(error < 1e-6 || a.spread > 1e3, "{way:?} {} {}", a.spread, b.spread);
                let turned = b.vertices().iter().rev();
                assert!(a.vertices().iter().zip(turned).all(|(p, q)| (p - q).length() < 1e-6));
            }
        }
    }
}

#[test]
fn near_the_axis_a_ball_is_the_lens_of_the_textbook() {
    // Light along the axis is bent to a focus at nR/(2(n−1)) from the centre: the ray at the height h meets the axis there.
    let ball = Ball { center: DVec3::new(1.0, 2.0, 3.0), radius: 0.7, eta: 1.5 };
    let focal = ball.eta * ball.radius / (2.0 * (ball.eta - 1.0));
    for distance in [2.0, 5.0] {
        let x = ball.center - DVec3::X * distance * ball.radius;
        let chain = only(x, Target::Distant(DVec3::X), &ball, Way::Across(0));
        assert!((chain.wx - DVec3::X).length() < 1e-15);
        // A bundle that leaves x within dω arrives as (1 − r_x/f)² as wide a bundle of directions.
        let magnified = 1.0 - distance * ball.radius / focal;
        assert!((chain.spread * magnified * magnified - 1.0).abs() < 1e-12, "{}", chain.spread);
        // Off the axis by a hair it is the same.
        let near = only(x, Target::Distant(DVec3::new(1.0, 1e-7, 0.0).normalize()), &ball, Way::Across(0));
        assert!((near.spread / chain.spread - 1.0).abs() < 1e-6);
    }
    // Sun behind a ball, r_x = 2R: (1−F₀)⁴ (1−r_x/f)^−2 with F₀ = 0.04 is the concentration 8.29 before two losses.
    let chain =
        only(ball.center - DVec3::X * 2.0 * ball.radius, Target::Distant(DVec3::X), &ball, Way::Across(0));
    assert!((chain.spread * 0.96 * 0.96 - 8.29).abs() < 0.01, "{}", chain.spread);
}

#[test]
fn the_apparent_depth_in_a_ball_seen_along_a_radius_is_gullstrands() {
    // 1/s' = n/s·… for one surface: n/s + (1−n)/R = 1/s' with s the depth below the pole, seen from outside.
    let ball = Ball { center: DVec3::ZERO, radius: 1.0, eta: 1.333 };
    let (s, far) = (0.4, 3.0);
    let (x, y) = (DVec3::Z * (1.0 + far), DVec3::Z * (1.0 - s));
    let chain = only(x, Target::Point(y), &ball, Way::In(0));
    let image = 1.0 / (ball.eta / s + (1.0 - ball.eta) / 1.0);
    // Seen from x the light stands at the depth s' and is larger by n s'/s.
    let expected = (ball.eta * image / s / (far + image)).powi(2);
    assert!((chain.spread / expected - 1.0).abs() < 1e-12, "{} {expected}", chain.spread);
}

#[test]
fn places_without_a_single_answer_give_sound_chains_or_none() {
    let ball = Ball { center: DVec3::new(0.5, 0.0, 0.0), radius: 1.0, eta: 1.5 };
    let on = |d: DVec3| ball.center + d;
    let places = [
        on(DVec3::ZERO),
        on(DVec3::X),
        on(-DVec3::X),
        on(DVec3::Y),
        on(DVec3::X * 2.0),
        on(DVec3::X * -2.0),
        on(DVec3::X * 0.5),
        on(DVec3::X * -0.5),
        on(DVec3::new(-2.0, 1.0, 0.0)),
        on(DVec3::new(2.0, 1.0, 0.0)),
        on(DVec3::new(1e-12, 0.0, 1.0)),
        on(DVec3::new(1.0, 1e-14, 0.0)),
        on(DVec3::new(-2.0, 1e-13, 1e-15)),
        on(DVec3::X * 1e12),
        DVec3::NAN,
        DVec3::INFINITY,
    ];
    let mut out = Chains::default();
    for eta in [1.5, 1.0, 1.0 / 1.5, 1.0 + 1e-12] {
        let ball = Ball { eta, ..ball };
        for way in WAYS.into_iter().chain([Way::Within(0), Way::Across(14), Way::Across(u32::MAX)]) {
            for x in places {
                let lights = places.iter().map(|&y| Target::Point(y));
                for target in lights.chain([DVec3::X, DVec3::Y, -DVec3::X, DVec3::NAN].map(Target::Distant)) {
                    out.clear();
                    connect(x, target, &ball, way, &mut out);
                    for c in out.as_slice() {
                        assert!(c.is_sound(), "{way:?} {x} {target:?} {c:?}");
                        assert!(
                            (c.wx.length() - 1.0).abs() < 1e-9 && (c.wy.length() - 1.0).abs() < 1e-9,
                            "{way:?} {eta} {x} {target:?} {} {}",
                            c.wx,
                            c.wy
                        );
                        assert!(c.vertices().iter().all(|p| ((p - ball.center).length() - 1.0).abs() < 1e-9));
                    }
                }
            }
        }
    }
}
