//! The room: half a million triangles in many things that stand around and hang in the air. Rays pass close to much that
//! they do not hit.

use super::noise::octaves;
use super::shapes::{ball, ball_frequency, cuboid, ring};
use crate::{Model, Scene, View};
use vitrine_math::{Bounds3, Vec3, hash, rotation_from_turn};

/// Metres: half the room's length, its height, half its width.
const SIZE: Vec3 = Vec3::new(6.0, 4.0, 4.5);
/// Things in a row, and rows.
const THINGS: [u32; 2] = [16, 12];

/// Makes the room.
pub fn scene(triangles: u32) -> Scene {
    let walls = Bounds3 { min: Vec3::new(-SIZE.x, 0.0, -SIZE.z), max: SIZE };
    let mut all = cuboid(&walls);
    // Of three things one is a box, the others share the triangles.
    let each = triangles / (THINGS[0] * THINGS[1] * 2 / 3);
    let lump = ball(ball_frequency(each));
    let across = ball_frequency(each * 3).max(3);
    let hoop = ring((each / 2 / across).max(3), across, 0.3);
    let case = cuboid(&Bounds3 { min: Vec3::splat(-0.7), max: Vec3::splat(0.7) });
    for i in 0..THINGS[0] * THINGS[1] {
        let chance = |what: u32| hash::unit(hash::join(hash::join(hash::mix(11), i), what));
        let place = Vec3::new(
            ((i % THINGS[0]) as f32 + 0.2 + 0.6 * chance(0)) / THINGS[0] as f32 * 2.0 - 1.0,
            0.06 + 0.8 * chance(1) * chance(1),
            ((i / THINGS[0]) as f32 + 0.2 + 0.6 * chance(2)) / THINGS[1] as f32 * 2.0 - 1.0,
        ) * SIZE;
        let turn = rotation_from_turn(Vec3::new(chance(3), chance(4), chance(5)) * 360.0);
        let size = 0.12 + 0.22 * chance(6);
        let thing = match i % 3 {
            0 => &lump,
            1 => &hoop,
            _ => &case,
        };
        let is_lump = i % 3 == 0;
        all.append(thing, |p: Vec3| {
            let bump = if is_lump { 1.0 + 0.5 * octaves(p * 2.0, 4, i) } else { 1.0 };
            turn * (p * bump * size) + place
        });
    }
    scene_around(all)
}

fn scene_around(things: Model) -> Scene {
    Scene {
        balls: Vec::new(),
        floor: None,
        models: vec![things],
        view: View { eye: Vec3::new(-5.6, 2.6, 4.1), look_at: Vec3::new(1.0, 0.9, -0.8), angle_deg: 70.0 },
        lamp: Vec3::new(0.5, 3.8, 0.5),
        reach: 0.5,
    }
}
