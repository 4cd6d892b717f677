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

/// What a ray meets that reaches the surfaces down to before `depth`, and is reflected at `depth` if `mirror` says so.
fn events(nest: &Nest<'_>, depth: usize, mirror: bool) -> Vec<Event> {
    let surface = |s: &Shell| Surface::Ball { center: nest.center, radius: s.radius };
    // Equal indices would be taken for a mirror.
    let go_in = nest.shells[nest.within[0]..depth]
        .iter()
        .map(|s| event(surface(s), s.outside, s.inside * (1.0 + 1e-15)));
    let back = mirror
        .then(|| event(surface(&nest.shells[depth]), nest.shells[depth].outside, nest.shells[depth].outside));
    let go_out = nest.shells[nest.within[1]..depth]
        .iter()
        .rev()
        .map(|s| event(surface(s), s.inside * (1.0 + 1e-15), s.outside));
    go_in.chain(back).chain(go_out).collect()
}

/// Runs `check` with the chains of random nests: all that pass through down to one depth, or are reflected at it.
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
        let deepest = within[0].max(within[1]);
        for depth in deepest..shells.len() {
            out.clear();
            connect(x, target, &nest, Course::Back(depth), &mut out);
            check(x, target, out.as_slice(), &nest, &events(&nest, depth, true));
        }
        out.clear();
        connect(x, target, &nest, Course::Through, &mut out);
        assert!(out.as_slice().len() < MAX_CHAINS);
        for depth in deepest..=shells.len() {
            let events = events(&nest, depth, false);
            if !events.is_empty() {
                let chains: Vec<Chain> =
                    out.as_slice().iter().filter(|c| c.vertices().len() == events.len()).copied().collect();
                check(x, target, &chains, &nest, &events);
            }
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
    each(&mut dice, 10_000, |x, target, chains, nest, events| {
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
    let count = |y: DVec3, course, out: &mut Chains| {
        out.clear();
        connect(DVec3::new(-3.0, 0.0, 0.0), Target::Point(y), &nest, course, out);
        let lengths: Vec<usize> = out.as_slice().iter().map(|c| c.vertices().len()).collect();
        lengths
    };
    assert_eq!(count(DVec3::new(3.0, 0.1, 0.0), Course::Through, &mut out), [4]);
    let depths = count(DVec3::new(1.2, 0.4, 0.0), Course::Through, &mut out);
    assert!(depths.contains(&4) && depths.contains(&2), "{depths:?}");
    assert_eq!(count(DVec3::new(1.0, 3.0, 0.0), Course::Back(1), &mut out), [3]);
}
