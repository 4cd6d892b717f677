//! Panes against formulas of the textbook, and against rays followed forwards.

use vitrine_math::DVec3;

use super::super::trial::{Dice, Event, Surface, event, measured_spread, miss, steepness};
use super::*;

/// A random stack with its ends, as rays would meet it.
struct Case {
    x: DVec3,
    y: DVec3,
    n: DVec3,
    offsets: Vec<f64>,
    indices: Vec<f64>,
}

impl Case {
    fn new(dice: &mut Dice) -> Self {
        let count = 1 + (dice.unit() * 5.0) as usize;
        let n = dice.direction();
        let up = if dice.unit() < 0.5 { 1.0 } else { -1.0 };
        let mut at = dice.between(-2.0, 2.0);
        let x = n * at + n.any_orthonormal_vector() * dice.between(-3.0, 3.0);
        let mut offsets = Vec::new();
        for _ in 0..count {
            at += up * dice.between(0.01, 0.8);
            offsets.push(at);
        }
        at += up * dice.between(0.01, 2.0);
        let (u, v) = n.any_orthonormal_pair();
        let y = n * at + u * dice.between(-3.0, 3.0) + v * dice.between(-3.0, 3.0);
        let indices =
            (0..=count).map(|_| if dice.unit() < 0.4 { 1.0 } else { dice.between(1.0, 2.4) }).collect();
        Self { x, y, n, offsets, indices }
    }

    fn stack(&self) -> Stack<'_> {
        Stack { n: self.n, offsets: &self.offsets, indices: &self.indices }
    }

    fn events(&self) -> Vec<Event> {
        let one = |k: usize| {
            let surface = Surface::Plane { n: self.n, offset: self.offsets[k] };
            // Equal indices would be taken for a mirror.
            event(surface, self.indices[k], self.indices[k + 1] * (1.0 + 1e-15))
        };
        (0..self.offsets.len()).map(one).collect()
    }
}

#[test]
fn a_stack_obeys_snell_and_its_spread_is_the_derivative() {
    let mut dice = Dice(1);
    for k in 0..2000 {
        let case = Case::new(&mut dice);
        let target = Target::Point(case.y);
        let chain = connect(case.x, target, &case.stack()).unwrap();
        let events = case.events();
        let missed = miss(case.x, target, &chain, &events, 1.0);
        assert!(missed < 1e-9, "case {k}: off by {missed:e}");
        let steep = steepness(&chain, &events);
        let measured = measured_spread(case.x, target, &chain, &events, 3e-4 * steep * steep);
        let error = (chain.spread / measured - 1.0).abs();
        assert!(error < 1e-5, "case {k}: {} against {measured}, off by {error:e}", chain.spread);
    }
}

#[test]
fn a_distant_light_keeps_its_direction_and_a_pane_spreads_nothing() {
    let mut dice = Dice(2);
    let mut stopped = 0;
    for k in 0..2000 {
        let case = Case::new(&mut dice);
        let w = dice.direction();
        let target = Target::Distant(w * if w.dot(case.y - case.x) < 0.0 { -1.0 } else { 1.0 });
        let Some(chain) = connect(case.x, target, &case.stack()) else {
            stopped += 1;
            continue;
        };
        let events = case.events();
        assert!(miss(case.x, target, &chain, &events, 1.0) < 1e-9, "case {k}");
        let (cos_x, cos_y) = (chain.wx.dot(case.n).abs(), chain.wy.dot(case.n).abs());
        let known = distant_spread_of(cos_x, cos_y, case.indices[0], case.indices[case.indices.len() - 1]);
        assert!((chain.spread / known - 1.0).abs() < 1e-6, "case {k}");
        let steep = steepness(&chain, &events);
        if steep > 0.02 {
            let measured = measured_spread(case.x, target, &chain, &events, 3e-4 * steep * steep);
            assert!((chain.spread / measured - 1.0).abs() < 1e-5, "case {k}: {} {measured}", chain.spread);
        }
    }
    assert!((100..1500).contains(&stopped), "total reflection stopped {stopped}");
    let pane = Stack { n: DVec3::Z, offsets: &[0.0, 0.01], indices: &[1.0, 1.5, 1.0] };
    let w = DVec3::new(0.6, 0.0, 0.8);
    let chain = connect(DVec3::new(0.0, 0.0, -1.0), Target::Distant(w), &pane).unwrap();
    assert!((chain.wx - w).length() < 1e-15 && (chain.spread - 1.0).abs() < 1e-15);
}

#[test]
fn a_pane_shifts_a_slanting_ray_by_5_1247_mm() {
    // d sin θ (1 − cos θ/√(n²−sin²θ)) with 10 mm, 60° and n = 1.5
    let pane = Stack { n: DVec3::Z, offsets: &[0.0, 0.01], indices: &[1.0, 1.5, 1.0] };
    let w = DVec3::new(0.75_f64.sqrt(), 0.0, 0.5);
    let x = DVec3::new(0.0, 0.0, -1.0);
    let chain = connect(x, Target::Distant(w), &pane).unwrap();
    let shift = (chain.vertices()[1] - x).cross(w).length();
    assert!((shift - 0.005_124_7).abs() < 5e-8, "{shift}");
    // The same path is found to a point on it.
    let y = chain.vertices()[1] + w * 3.0;
    let again = connect(x, Target::Point(y), &pane).unwrap();
    assert!((again.vertices()[1] - chain.vertices()[1]).length() < 1e-12);
}

#[test]
fn water_looks_three_quarters_as_deep_and_a_pane_is_nearer_by_d_less_d_over_n() {
    let water = Stack { n: DVec3::Z, offsets: &[0.0], indices: &[1.0, 4.0 / 3.0] };
    let seen = |stack: &Stack<'_>, x: f64, y: f64| {
        let chain = connect(DVec3::Z * x, Target::Point(DVec3::Z * y), stack).unwrap();
        // The light stands where 1/distance² is the spread.
        1.0 / chain.spread.sqrt()
    };
    assert!((seen(&water, 1.0, -2.0) - (1.0 + 2.0 * 0.75)).abs() < 1e-12);
    let pane = Stack { n: DVec3::Z, offsets: &[0.0, 0.4], indices: &[1.0, 1.5, 1.0] };
    assert!((seen(&pane, -1.0, 2.0) - (3.0 - 0.4 * (1.0 - 1.0 / 1.5))).abs() < 1e-12);
}

#[test]
fn every_reflection_inside_a_pane_obeys_snell_and_spreads_as_measured() {
    let mut dice = Dice(3);
    let mut orders: Vec<Ladder> = (0..=7).map(Ladder::Through).collect();
    orders.extend((0..=7).map(Ladder::Back));
    for ladder in orders {
        for k in 0..200 {
            let n = dice.direction();
            let (near, up) = (dice.between(-1.0, 1.0), if dice.unit() < 0.5 { 1.0 } else { -1.0 });
            let far = near + up * dice.between(0.01, 0.3);
            let (n1, n2) = (dice.between(1.3, 2.0), dice.between(1.0, 1.2));
            let pane = Pane { n, near, far, indices: [1.0, n1, n2] };
            let side = n.any_orthonormal_vector();
            let x = n * (near - up * dice.between(0.1, 2.0));
            let y_height = match ladder {
                Ladder::Through(_) => far + up * dice.between(0.1, 2.0),
                Ladder::Back(_) => near - up * dice.between(0.1, 2.0),
            };
            let slide = side * dice.between(-2.0, 2.0);
            let target = Target::Point(n * y_height + slide);
            let chain = connect_pane(x, target, &pane, ladder).unwrap();
            let (first, second) = (Surface::Plane { n, offset: near }, Surface::Plane { n, offset: far });
            let surface = |k: usize| if k.is_multiple_of(2) { first } else { second };
            let mut events = vec![event(first, 1.0, n1)];
            let count = match ladder {
                Ladder::Through(k) => 2 * k as usize + 2,
                Ladder::Back(m) => 2 * m as usize + 1,
            };
            events.extend((1..count.max(2) - 1).map(|k| event(surface(k), n1, n1)));
            match (ladder, count) {
                (_, 1) => events = vec![event(first, 1.0, 1.0)],
                (Ladder::Through(_), _) => events.push(event(second, n1, n2)),
                (Ladder::Back(_), _) => events.push(event(first, n1, 1.0)),
            }
            assert!(miss(x, target, &chain, &events, 1.0) < 1e-9, "{ladder:?} {k}");
            let steep = steepness(&chain, &events);
            let measured = measured_spread(x, target, &chain, &events, 3e-4 * steep * steep);
            assert!(
                (chain.spread / measured - 1.0).abs() < 1e-5,
                "{ladder:?} {k}: {} {measured}",
                chain.spread
            );
            // A distant light along the same last leg takes the same way.
            let distant = connect_pane(x, Target::Distant(-chain.wy), &pane, ladder).unwrap();
            assert!((distant.wx - chain.wx).length() < 1e-9, "{ladder:?} {k}");
            assert!((distant.vertices()[count - 1] - chain.vertices()[count - 1]).length() < 1e-7);
        }
    }
}

#[test]
fn a_known_path_has_the_spread_that_the_search_gives() {
    let mut dice = Dice(4);
    for _ in 0..500 {
        let case = Case::new(&mut dice);
        let chain = connect(case.x, Target::Point(case.y), &case.stack()).unwrap();
        let heights = [&[case.n.dot(case.x)], &case.offsets[..], &[case.n.dot(case.y)]].concat();
        let layers: Vec<(f64, f64)> =
            heights.windows(2).map(|h| (h[1] - h[0]).abs()).zip(case.indices.iter().copied()).collect();
        let spread = spread_of(chain.wx.dot(case.n).abs(), &layers).unwrap();
        assert!((spread / chain.spread - 1.0).abs() < 1e-6, "{spread} {}", chain.spread);
    }
}

#[test]
fn exchanging_the_ends_keeps_n2_times_the_spread() {
    let mut dice = Dice(5);
    for _ in 0..500 {
        let case = Case::new(&mut dice);
        let there = connect(case.x, Target::Point(case.y), &case.stack()).unwrap();
        let offsets: Vec<f64> = case.offsets.iter().rev().copied().collect();
        let indices: Vec<f64> = case.indices.iter().rev().copied().collect();
        let turned =
            Stack { n: -case.n, offsets: &offsets.iter().map(|o| -o).collect::<Vec<_>>(), indices: &indices };
        let back = connect(case.y, Target::Point(case.x), &turned).unwrap();
        assert!((there.wx - back.wy).length() < 1e-9 && (there.wy - back.wx).length() < 1e-9);
        // n_x² dω_x/dA_y = n_y² dω_y/dA_x
        let (a, b) = (indices[indices.len() - 1], indices[0]);
        assert!((a * a * there.spread / (b * b * back.spread) - 1.0).abs() < 1e-8);
    }
}

#[test]
fn places_without_an_answer_give_none_and_never_nan() {
    let pane = Stack { n: DVec3::Z, offsets: &[0.0, 0.01], indices: &[1.0, 1.5, 1.0] };
    let at = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    let places = [0.0, 1e-300, 1e-9, 0.005, 0.01, 0.02, 1.0, 1e15, -1.0, -1e-12, f64::NAN, f64::INFINITY];
    let mut found = 0;
    for indices in [[1.0, 1.5, 1.0], [1.5, 1.0, 1.5], [1.0, 1.0, 1.0], [1.0, 1.0 + 1e-15, 1.0]] {
        let stack = Stack { indices: &indices, ..pane };
        let glass = Pane { n: DVec3::Z, near: 0.0, far: 0.01, indices };
        for z in places {
            for (side, height) in places.iter().flat_map(|&a| places.map(|b| (a, b))) {
                let w = at(side, height).normalize_or(DVec3::X);
                for target in [Target::Point(at(side, height)), Target::Distant(w)] {
                    let mut chains = vec![connect(at(0.0, z), target, &stack)];
                    let ladders = [
                        Ladder::Through(0),
                        Ladder::Through(3),
                        Ladder::Back(0),
                        Ladder::Back(2),
                        Ladder::Through(9),
                        Ladder::Back(u32::MAX),
                    ];
                    chains.extend(ladders.map(|l| connect_pane(at(0.0, z), target, &glass, l)));
                    for chain in chains.into_iter().flatten() {
                        found += 1;
                        assert!(chain.is_sound());
                        assert!(
                            (chain.wx.length() - 1.0).abs() < 1e-9 && (chain.wy.length() - 1.0).abs() < 1e-9,
                            "{chain:?}"
                        );
                    }
                }
            }
        }
    }
    assert!(found > 1000, "{found}");
    // What rounding has moved through a surface is on it.
    let near = connect(at(0.0, 1e-9), Target::Point(at(0.5, 1.0)), &pane).unwrap();
    let on = connect(at(0.0, 0.0), Target::Point(at(0.5, 1.0)), &pane).unwrap();
    assert!((near.wx - on.wx).length() < 1e-8 && (near.vertices()[0] - at(0.0, 0.0)).length() < 1e-8);
    // From the wrong side, and beside one another in the glass.
    assert!(connect(at(0.0, 0.5), Target::Point(at(0.0, 1.0)), &pane).is_none());
    assert!(connect(at(0.0, -0.5), Target::Point(at(0.0, -1.0)), &pane).is_none());
}
