//! Off balls of polished metal: the spots of light that mirrors throw.

use super::super::chain::Chain;
use super::found::{Found, Leaving, Node};
use super::{Search, Step};
use crate::compile::{CompiledScene, Mirror};
use vitrine_math::{DVec3, Rgb, Vec3};
use vitrine_optics::bsdf::Bsdf;
use vitrine_optics::connect::shells::{Course, Nest, Pair, Shell};
use vitrine_optics::connect::{Chains, Target};

/// Adds the way off each ball on which nothing else is met.
pub fn connect(search: &Search, chains: &mut Chains, found: &mut Found) {
    if !search.kinds.plain {
        return;
    }
    for (number, mirror) in search.solids.mirrors() {
        let Some(course) = Course::back([0, 0], 0) else { continue };
        chains.clear();
        with_pair(search, mirror, |pair| pair.connect(&course, chains));
        let here = search.ends.media.top(search.solids);
        let step = Step { solid: number, reflects: true, before: here, beyond: here, ..Step::NONE };
        for chain in chains.as_slice() {
            let ends = Leaving { wx: chain.wx, wy: chain.wy, spread: chain.spread };
            let node = |p: &DVec3| Node {
                step,
                n: (*p - mirror.center.as_dvec3()) / f64::from(mirror.radius),
                p: *p,
            };
            found.push(ends, chain.vertices().iter().map(node));
        }
    }
}

/// The spread of a way that leaves x along `wx` and has met these surfaces; None if it is not one that [`connect`] looks for.
pub fn spread_of(search: &Search, chain: &Chain, wx: DVec3) -> Option<f64> {
    let mut met = chain.solids();
    let (Some(number), None) = (met.next(), met.next()) else { return None };
    let mirror = search.solids.mirror(number)?;
    let course = Course::back([0, 0], 0)?;
    with_pair(search, mirror, |pair| pair.spread_of(wx, &course)).flatten()
}

/// Gives the two ends around a ball to a solver; None where they lie in different media, or one of them in the ball.
fn with_pair<R>(search: &Search, mirror: &Mirror, solve: impl FnOnce(&Pair<'_>) -> R) -> Option<R> {
    let Search { solids, ends, there, .. } = search;
    let here = ends.media.top(solids);
    let (center, radius) = (mirror.center.as_dvec3(), f64::from(mirror.radius));
    let is_outside = |p: DVec3| (p - center).length_squared() >= radius * radius;
    if there.top(solids) != here || !is_outside(ends.x) || !is_outside(ends.y) {
        return None;
    }
    let index = search.index(here);
    let shells = [Shell { radius, outside: index, inside: index }];
    let nest = Nest { center, shells: &shells, within: [0, 0] };
    Pair::new(ends.x, Target::Point(ends.y), &nest).map(|pair| solve(&pair))
}

/// The share of light that a mirror reflects, in a medium of that index; `cos` is that between the way and the normal.
pub fn reflected(scene: &CompiledScene, mirror: &Mirror, cos: f32, index: f32) -> Rgb {
    let material = scene.primitives[mirror.primitive as usize].material as usize;
    let mut surface = scene.physical[material].surface;
    surface.eta /= index;
    let wo = Vec3::new((1.0 - cos * cos).max(0.0).sqrt(), 0.0, cos);
    let sample = Bsdf::new(&surface, cos).sample(wo, 0.5, [0.5; 2]);
    sample.filter(|s| s.event.is_delta && !s.event.is_transmission).map_or(Rgb::BLACK, |s| s.weight * s.pdf)
}
