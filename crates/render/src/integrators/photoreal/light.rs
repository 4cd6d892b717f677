//! Light that a path meets by chance, weighed against the light that was looked for on purpose.

use super::connect::{Connector, Ends, double};
use super::path::Path;
use crate::compile::CompiledScene;
use vitrine_math::{DVec3, Vec3};

/// What shines at the end of a path.
#[derive(Clone, Copy, Debug)]
pub struct Shining {
    /// The point.
    pub y: DVec3,
    /// The cosine between the surface's normal and the way; 1 for what is infinitely far.
    pub cos: f32,
    /// The density with which it would have been chosen on purpose: 1/m² across the surface, or 1/sr times `spread`.
    pub pdf: f32,
    /// What turns 1/sr into 1/m² for what is infinitely far: the square of the distance that stands for it; else 1.
    pub square: f64,
}

/// The weight of light that a path has met by chance: the rest of it is found on purpose (the balance heuristic).
///
/// A way through smooth surfaces counts as found on purpose if the connector would find it, which depends on its ends and
/// its chain alone.
pub fn chance_weight(
    scene: &CompiledScene,
    connector: &mut Connector,
    path: &Path,
    shining: &Shining,
) -> f32 {
    let origin = &path.origin;
    if origin.pdf <= 0.0 || shining.pdf <= 0.0 {
        return 1.0;
    }
    let x = double(origin.x);
    let way = shining.y - x;
    // Connections start on the side of the surface on which y lies.
    if origin.n != Vec3::ZERO && (way.dot(double(origin.n)) > 0.0) != (origin.wi.dot(origin.n) > 0.0) {
        return 1.0;
    }
    let spread = if path.chain.is_empty() {
        1.0 / way.length_squared()
    } else if path.chain.is_solvable() {
        let ends = Ends { x, y: shining.y, media: origin.media, wavelength: path.wavelength };
        let solids = &scene.photoreal.solids;
        match connector.spread_of(solids, &ends, &path.chain, double(origin.wi)) {
            Some(spread) => spread,
            None => return 1.0,
        }
    } else {
        return 1.0;
    };
    // p_RNEE = p_A/G
    let g = (spread * shining.square) as f32 * shining.cos;
    if g > 0.0 { origin.pdf / (origin.pdf + shining.pdf / g) } else { 1.0 }
}
