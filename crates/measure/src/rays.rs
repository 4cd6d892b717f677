//! The rays of a race, as a renderer would shoot them: from the camera, and from what those rays meet.

use crate::race::Query;
use crate::{Kernel, Scene};
use vitrine_math::{Ray, Vec2, Vec3, hash, warp};

/// Rays from the camera of a picture that is measured: 816 × 824 cut into squares of 8 × 8 without rest.
pub const SIZE: [u32; 2] = [816, 824];

/// How far above a surface rays start that leave it, metres: far more than rounding, far less than the scenes' things.
const GAP: f32 = 2e-4;

/// Why a ray is shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the camera.
    Primary,
    /// From what the camera sees to the lamp: is there anything between?
    Shadow,
    /// From what the camera sees, as a mirror would send it on.
    Mirror,
    /// From what the camera sees in a random direction, more often upright than flat.
    Diffuse,
    /// As diffuse rays, but short: is anything near?
    Ambient,
}

impl RayKind {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Primary, Self::Shadow, Self::Mirror, Self::Diffuse, Self::Ambient];

    /// Its name, in lower case.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Shadow => "shadow",
            Self::Mirror => "mirror",
            Self::Diffuse => "diffuse",
            Self::Ambient => "ambient",
        }
    }

    /// What is asked of such rays.
    #[must_use]
    pub const fn query(self) -> Query {
        match self {
            Self::Primary | Self::Mirror | Self::Diffuse => Query::Closest,
            Self::Shadow | Self::Ambient => Query::Occlusion,
        }
    }

    /// Whether rays in a row lie close together.
    #[must_use]
    pub const fn is_coherent(self) -> bool {
        matches!(self, Self::Primary | Self::Shadow)
    }
}

/// Rays of one kind through one scene.
#[derive(Clone, Debug)]
pub struct RaySet {
    /// Why they are shot.
    pub kind: RayKind,
    /// The rays. Sixteen in a row belong to 4 × 4 pixels.
    pub rays: Vec<Ray>,
}

/// The rays of each of the kinds, for a picture of so many pixels, rounded up to squares of 8 × 8. Where the camera sees
/// nothing, no further rays start.
#[must_use]
pub fn ray_sets(scene: &Scene, kernel: &Kernel, size: [u32; 2], kinds: &[RayKind]) -> Vec<RaySet> {
    let primary = primary(scene, size);
    let seen = seen(scene, kernel, &primary);
    let set = |&kind: &RayKind| RaySet {
        kind,
        rays: match kind {
            RayKind::Primary => primary.clone(),
            _ => seen.iter().enumerate().map(|(i, seen)| next(scene, kind, i as u32, seen)).collect(),
        },
    };
    kinds.iter().map(set).collect()
}

fn primary(scene: &Scene, size: [u32; 2]) -> Vec<Ray> {
    let squares = size.map(|n| n.div_ceil(8));
    let [width, height] = squares.map(|n| 8.0 * n as f32);
    let view = &scene.view;
    let forward = (view.look_at - view.eye).normalize();
    let right = forward.cross(Vec3::Y).normalize();
    let up = right.cross(forward);
    let half = libm::tanf(0.5 * view.angle_deg.to_radians());
    let through = |x: u32, y: u32| {
        let sideways = (2.0 * (x as f32 + 0.5) / width - 1.0) * half;
        let upwards = (1.0 - 2.0 * (y as f32 + 0.5) / height) * half * height / width;
        Ray::new(view.eye, (forward + right * sideways + up * upwards).normalize())
    };
    let square = |s: u32| {
        let (x, y) = (8 * (s % squares[0]), 8 * (s / squares[0]));
        (0..64).map(move |i| (x + even_bits(i), y + even_bits(i >> 1)))
    };
    (0..squares[0] * squares[1]).flat_map(square).map(|(x, y)| through(x, y)).collect()
}

/// Bits 0, 2 and 4 of a number of six bits, side by side: one coordinate along the curve that fills a square of 8 × 8
/// square by square (Morton's order).
const fn even_bits(i: u32) -> u32 {
    (i & 1) | (i >> 1 & 2) | (i >> 2 & 4)
}

/// A point that the camera sees.
struct Seen {
    /// A little above the surface.
    point: Vec3,
    /// Toward the camera's side.
    n: Vec3,
    /// How the ray came.
    direction: Vec3,
}

fn seen(scene: &Scene, kernel: &Kernel, primary: &[Ray]) -> Vec<Seen> {
    let hits = kernel.closest(primary);
    let there = primary.iter().zip(hits).filter_map(|(ray, hit)| Some((ray, hit?)));
    let seen = there.map(|(ray, (t, part))| {
        let point = ray.at(t);
        let n = scene.normal(part, point);
        let n = if n.dot(ray.direction) > 0.0 { -n } else { n };
        Seen { point: point + n * GAP, n, direction: ray.direction }
    });
    seen.collect()
}

fn next(scene: &Scene, kind: RayKind, i: u32, seen: &Seen) -> Ray {
    let Seen { point, n, direction } = *seen;
    match kind {
        RayKind::Primary => Ray::new(scene.view.eye, direction),
        RayKind::Shadow => {
            let to_lamp = scene.lamp - point;
            let distance = to_lamp.length();
            Ray { origin: point, direction: to_lamp / distance, t_max: distance }
        }
        // r = d − 2⟨d, n⟩n
        RayKind::Mirror => Ray::new(point, (direction - 2.0 * direction.dot(n) * n).normalize()),
        RayKind::Diffuse => Ray::new(point, upright(n, i, 0)),
        RayKind::Ambient => Ray { origin: point, direction: upright(n, i, 1), t_max: scene.reach },
    }
}

/// A random direction about a normal, as likely as the cosine between the two (Malley's method: even in the disc below).
fn upright(n: Vec3, i: u32, purpose: u32) -> Vec3 {
    let h = hash::join(hash::mix(purpose), i);
    let disc = warp::concentric_disk(Vec2::new(hash::unit(h), hash::unit(hash::mix(h))));
    let (side, other) = n.any_orthonormal_pair();
    let height = (1.0 - disc.length_squared()).max(0.0).sqrt();
    (side * disc.x + other * disc.y + n * height).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SceneKind;

    fn sets(kind: SceneKind) -> (Scene, Vec<RaySet>) {
        let scene = kind.scene(2000);
        let sets = ray_sets(&scene, &Kernel::build(&scene), [60, 64], &RayKind::ALL);
        (scene, sets)
    }

    #[test]
    fn where_everything_is_closed_each_camera_ray_goes_on() {
        for kind in [SceneKind::Cave, SceneKind::Room] {
            for set in sets(kind).1 {
                assert_eq!(set.rays.len(), 64 * 64, "{} {:?}", kind.name(), set.kind);
            }
        }
    }

    #[test]
    fn sixteen_camera_rays_in_a_row_are_four_by_four_pixels() {
        let places: Vec<_> = (0..16).map(|i| (even_bits(i), even_bits(i >> 1))).collect();
        let mut sorted = places.clone();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), 16);
        assert!(places.iter().all(|&(x, y)| x < 4 && y < 4), "{places:?}");
    }

    #[test]
    fn directions_are_of_unit_length_and_lead_away_from_the_surface() {
        for kind in SceneKind::ALL {
            let (scene, sets) = sets(kind);
            let kernel = Kernel::build(&scene);
            for set in sets {
                assert!(set.rays.iter().all(|r| (r.direction.length() - 1.0).abs() < 1e-5), "{:?}", set.kind);
                if set.kind == RayKind::Diffuse {
                    let near = kernel.closest(&set.rays).into_iter().flatten().filter(|(t, _)| *t < GAP);
                    let share = near.count() as f32 / set.rays.len() as f32;
                    assert!(share < 0.01, "{} of the diffuse rays start in a surface", share);
                }
            }
        }
    }

    #[test]
    fn lit_and_unlit_points_both_exist() {
        for kind in SceneKind::ALL {
            let (scene, sets) = sets(kind);
            let kernel = Kernel::build(&scene);
            for set in sets.iter().filter(|s| s.kind.query() == Query::Occlusion) {
                let found = crate::race::distances(&mut kernel.packets(Query::Occlusion), &set.rays);
                let hidden = found.iter().filter(|t| **t == 0.0).count();
                let share = hidden as f32 / found.len() as f32;
                assert!((0.02..0.9).contains(&share), "{} {:?}: {share}", kind.name(), set.kind);
            }
        }
    }
}
