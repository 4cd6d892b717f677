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
