//! Scattering held against what must be true of any surface: energy, reciprocity, densities, finite numbers.

mod density;
mod energy;
mod physics;
mod soundness;

use super::*;
use vitrine_math::hash;

/// A colourless surface of OpenPBR's defaults that absorbs nothing.
fn white() -> Surface {
    Surface { base_color: Rgb::WHITE, ..Surface::default() }
}

fn glass(roughness: f32) -> Surface {
    Surface { transmission: 1.0, roughness, ..white() }
}

/// The same from inside.
fn from_inside(surface: Surface) -> Surface {
    Surface { eta: 1.0 / surface.eta, ..surface }
}

fn pane(roughness: f32) -> Surface {
    Surface { thin_walled: true, ..glass(roughness) }
}

fn metal(roughness: f32) -> Surface {
    Surface { metalness: 1.0, roughness, ..white() }
}

/// The direction at an angle with the cosine `cos`, turned by `turn` radians.
fn direction(cos: f32, turn: f32) -> Vec3 {
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    Vec3::new(sin * turn.cos(), sin * turn.sin(), cos)
}

/// `n` choices of lobe and direction, all in [0, 1): the second number stratified, the others scrambled.
fn numbers(n: u32, seed: u32) -> impl Iterator<Item = (f32, [f32; 2])> {
    (0..n).map(move |i| {
        let h = hash::join(hash::mix(seed), i);
        let stratum = (i as f32 + hash::unit(hash::mix(h ^ 1))) / n as f32;
        (hash::unit(h), [stratum.min(0.999_999_9), hash::unit(hash::mix(h ^ 2))])
    })
}
