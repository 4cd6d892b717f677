//! How much of the light gets along a connection: reflected and passed at its surfaces, faded between them.

use super::{Connection, Ends, found, metal};
use crate::compile::Solids;
use crate::integrators::TileTask;
use vitrine_math::Rgb;
use vitrine_optics::fresnel;

/// τ = Π(1−F_i or F_i) · Π exp(−σ_j ℓ_j), times (n_x/n_y)², which radiance gains or loses between two media.
///
/// The way lies in one plane at each surface of a stack or a ball, so the two polarisations are followed each on its own.
pub fn transmittance(task: &TileTask, solids: &Solids, connection: &Connection<'_>, ends: &Ends) -> Rgb {
    let index = |solid: u16| solids.substance(solid).map_or(1.0, |s| s.index_at(ends.wavelength));
    let first = ends.media.top(solids);
    let (mut s, mut p, mut tau) = (0.5_f32, 0.5_f32, Rgb::WHITE);
    let (mut from, mut medium) = (ends.x, first);
    for found::Node { step, n, p: vertex } in connection.nodes {
        let way = *vertex - from;
        tau = tau * solids.transmittance(medium, way.length() as f32);
        let cos = (way.dot(*n) / way.length()).abs() as f32;
        if let Some(mirror) = solids.mirror(step.solid) {
            tau = tau * metal::reflected(task.scene, mirror, cos, index(step.before));
            from = *vertex;
            continue;
        }
        let (rs, rp) = fresnel::dielectric_sp(cos, index(step.beyond) / index(step.before));
        if task.settings.unpolarised {
            let r = 0.5 * (rs + rp);
            let share = if step.reflects { r } else { 1.0 - r };
            (s, p) = (s * share, p * share);
        } else if step.reflects {
            (s, p) = (s * rs, p * rp);
        } else {
            (s, p) = (s * (1.0 - rs), p * (1.0 - rp));
        }
        if !step.reflects {
            let primitive = solids.get(step.solid).primitive as usize;
            let scene = task.scene;
            let material = scene.primitives[primitive].material as usize;
            tau = tau * scene.physical[material].surface.transmission_tint;
        }
        (from, medium) = (*vertex, step.after());
    }
    tau = tau * solids.transmittance(medium, (ends.y - from).length() as f32);
    let ratio = index(first) / index(medium);
    tau * ((s + p) * ratio * ratio)
}
