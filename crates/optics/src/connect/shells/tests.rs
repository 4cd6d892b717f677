//! Bulbs and bowls against rays followed forwards.

use vitrine_math::DVec3;

use super::super::trial::{
    Dice, Event, Surface, event, follow, measured_spread, miss, missed_chains, steepness,
};
use super::super::{Chain, MAX_CHAINS};
use super::*;

/// A random nest of one to three surfaces.
fn nest(dice: &mut Dice) -> (DVec3, Vec<Shell>) {
    let count = 1 + (dice.unit() * 3.0) as usize;
    let mut index = || if dice.unit() < 0.3 { 1.0 } else { dice.between(1.0, 2.0) };
    let indices: Vec<f64> = (0..=count).map(|_| index()).collect();
    let mut radius = dice.between(0.5, 2.0);
    let shells = (0..count)
        .map(|k| {
            let shell = Shell { radius, outside: indices[k], inside: indices[k + 1] };
            radius *= dice.between(0.5, 0.98);
            shell
        })
        .collect();
    (dice.direction() * dice.between(0.0, 2.0), shells)
}

/// A place within just so many surfaces.
fn place(dice: &mut Dice, center: DVec3, shells: &[Shell], within: usize) -> DVec3 {
    let high = if within == 0 { 4.0 * shells[0].radius } else { shells[within - 1].radius };
    let low = shells.get(within).map_or(0.02 * high, |s| s.radius);
    center + dice.direction() * (low + (high - low) * dice.between(0.01, 0.99))
}

/// What a ray meets on a course.
fn events(nest: &Nest<'_>, course: &Course) -> Vec<Event> {
    let event_at = |meeting: &Meeting| {
        let s = nest.shells[usize::from(meeting.shell)];
        let surface = Surface::Ball { center: nest.center, radius: s.radius };
        // Equal indices would be taken for a mirror.
        match meeting.deed {
            Deed::Enter => event(surface, s.outside, s.inside * (1.0 + 1e-15)),
            Deed::Leave => event(surface, s.inside * (1.0 + 1e-15), s.outside),
            Deed::Off => event(surface, s.outside, s.outside),
            Deed::Echo => event(surface, s.inside, s.inside),
        }
    };
    course.meetings().iter().map(event_at).collect()
}

/// All courses with at most one reflection.
fn courses(within: [usize; 2], count: usize) -> Vec<Course> {
    let [i, j] = within;
    let deepest = i.max(j);
    let through = (deepest..=count).filter_map(|depth| Course::through(within, depth));
    let back = (deepest..count).filter_map(|mirror| Course::back(within, mirror));
    let echo = (0..count).flat_map(|mirror| {
        let depths = move |end: usize| end.max(mirror + 1)..=count;
        depths(i).flat_map(move |a| depths(j).filter_map(move |b| Course::echo(within, mirror, [a, b])))
    });
    through.chain(back).chain(echo).collect()
}

/// Runs `check` with the chains of all courses through random nests.
fn each(dice: &mut Dice, cases: u32, mut check: impl FnMut(DVec3, Target, &[Chain], &Nest<'_>, &[Event])) {
    let mut out = Chains::default();
    for case in 0..cases {
        let (center, shells) = nest(dice);
        let within = [0, 1].map(|_| (dice.unit() * (shells.len() + 1) as f64) as usize);
        let nest = Nest { center, shells: &shells, within };
        let x = place(dice, center, &shells, within[0]);
        let y = place(dice, center, &shells, within[1]);
        let target = if within[1] == 0 && case % 3 == 0 {
            Target::Distant(dice.direction())
        } else {
            Target::Point(y)
        };
        for course in courses(within, shells.len()) {
            if course.meetings().is_empty() {
                continue;
            }
            out.clear();
            connect(x, target, &nest, &course, &mut out);
            assert!(out.as_slice().len() < MAX_CHAINS);
            check(x, target, out.as_slice(), &nest, &events(&nest, &course));
        }
    }
}

#[test]
fn every_course_obeys_snell_and_its_spread_is_the_derivative() {
    let mut dice = Dice(11);
    let (mut found, mut compared) = (0, 0);
    each(&mut dice, 3000, |x, target, chains, nest, events| {
        for chain in chains {
            found += 1;
            let missed = miss(x, target, chain, events, nest.shells[0].radius);
            assert!(missed < 1e-9, "off by {missed:e}: {nest:?} {x} {target:?}");
            let steep = steepness(chain, events);
            if steep < 0.1 {
                continue;
            }
            compared += 1;
            let size = (nest.shells[0].radius / (x - nest.center).length()).min(1.0);
            let measured = measured_spread(x, target, chain, events, 3e-4 * steep * steep * size);
            let error = (chain.spread / measured - 1.0).abs();
            assert!(
                error < 1e-5,
                "{} against {measured}, off by {error:e}: {nest:?} {x} {target:?}",
                chain.spread
            );
        }
    });
    assert!(found > 3000 && compared > 2500, "{found} {compared}");
}

/// Whether the segment crosses the ball's surface, its own ends left out.
fn cuts(center: DVec3, radius: f64, a: DVec3, b: DVec3) -> bool {
    let (d, o) = (b - a, a - center);
    let (half, c) = (o.dot(d), o.dot(o) - radius * radius);
    let root = (half * half - d.dot(d) * c).sqrt();
    [-half - root, -half + root].iter().any(|t| (1e-6..1.0 - 1e-6).contains(&(t / d.dot(d))))
}

#[test]
fn no_chain_is_missed() {
    let mut dice = Dice(12);
    let mut seen = 0;
    each(&mut dice, 5000, |x, target, chains, nest, events| {
        let to_x = (x - nest.center).normalize();
        let toward = match target {
            Target::Point(y) => y - nest.center,
            Target::Distant(w) => w,
        };
        let across = to_x.cross(toward).normalize();
        let e = across.cross(to_x);
        let directions = (0..=1000).map(|k| {
            let (s, c) = (f64::from(k) / 1000.0 * core::f64::consts::TAU).sin_cos();
            to_x * c + e * s
        });
        // A ray that would meet another surface on its way is another chain's.
        let trace = |w: DVec3| {
            let (mut p, mut w) = (x, w);
            for k in 0..=events.len() {
                let end = match (k == events.len(), target) {
                    (false, _) => follow(p, w, &events[k..=k])?.0,
                    (true, Target::Point(y)) => p + w * w.dot(y - p).max(0.0),
                    (true, Target::Distant(_)) => p + w * 100.0,
                };
                if nest.shells.iter().any(|s| cuts(nest.center, s.radius, p, end)) {
                    return None;
                }
                if k < events.len() {
                    (p, w) = follow(p, w, &events[k..=k])?;
                }
            }
            Some((p, w))
        };
        let (roots, missed) = missed_chains(target, chains, directions, across, trace);
        assert_eq!(missed, 0, "of {roots} seen, {} found: {nest:?} {x} {target:?} {events:?}", chains.len());
        seen += roots;
    });
    assert!(seen > 8000, "{seen}");
}

#[test]
fn light_passes_a_bulb_inside_its_glass_and_through_its_hollow() {
    // A hollow glass ball: past the hollow, through it, and off it by total reflection.
    let shells =
        [Shell { radius: 1.0, outside: 1.0, inside: 1.5 }, Shell { radius: 0.5, outside: 1.5, inside: 1.0 }];
    let nest = Nest { center: DVec3::ZERO, shells: &shells, within: [0, 0] };
    let mut out = Chains::default();
    let mut count = |y: DVec3, course: Option<Course>| {
        out.clear();
        connect(DVec3::new(-3.0, 0.0, 0.0), Target::Point(y), &nest, &course.unwrap(), &mut out);
        out.as_slice().len()
    };
    let [shallow, deep] = [1, 2].map(|depth| Course::through([0, 0], depth));
    let behind = DVec3::new(3.0, 0.1, 0.0);
    assert_eq!([count(behind, shallow), count(behind, deep)], [0, 1]);
    let beside = DVec3::new(1.2, 0.4, 0.0);
    assert!(count(beside, deep) > 0 && count(beside, shallow) > 0);
    assert_eq!(count(DVec3::new(1.0, 3.0, 0.0), Course::back([0, 0], 1)), 1);
}

#[test]
fn a_known_path_has_the_spread_that_the_search_gives() {
    let mut dice = Dice(13);
    let mut out = Chains::default();
    let mut compared = 0;
    for _ in 0..2000 {
        let (center, shells) = nest(&mut dice);
        let within = [0, 1].map(|_| (dice.unit() * (shells.len() + 1) as f64) as usize);
        let nest = Nest { center, shells: &shells, within };
        let [x, y] = within.map(|within| place(&mut dice, center, &shells, within));
        let pair = Pair::new(x, Target::Point(y), &nest).unwrap();
        for course in courses(within, shells.len()) {
            out.clear();
            pair.connect(&course, &mut out);
            for chain in out.as_slice() {
                let spread = pair.spread_of(chain.wx, &course).unwrap();
                let steep = steepness(chain, &events(&nest, &course));
                if steep > 1e-2 {
                    compared += 1;
                    let error = (spread / chain.spread - 1.0).abs();
                    assert!(error < 1e-5, "{course:?}: {spread} against {}", chain.spread);
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}
