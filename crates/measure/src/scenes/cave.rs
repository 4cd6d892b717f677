//! The cave: a ball of 1.31 million triangles, pushed in and out at random, with the camera inside. Every ray
//! hits, and rays that leave the wall meet it somewhere else.

use super::noise::octaves;
use super::shapes::{ball, ball_frequency};
use crate::{Scene, View};
use vitrine_math::Vec3;

/// Metres from the middle to the wall before it is pushed.
const RADIUS: f32 = 10.0;

/// Makes the cave.
pub fn scene(triangles: u32) -> Scene {
    let wall = |p: Vec3| {
        // Sideways too, or no part of the wall would hide another from the middle.
        let aside = Vec3::new(octaves(p * 2.0, 5, 1), octaves(p * 2.0, 5, 2), octaves(p * 2.0, 5, 3));
        (p * (1.0 + 0.5 * octaves(p * 3.0, 7, 4)) + 0.25 * aside) * RADIUS
    };
    Scene {
        balls: Vec::new(),
        floor: None,
        models: vec![ball(ball_frequency(triangles)).moved(wall)],
        view: View { eye: Vec3::new(-3.0, -0.5, 2.0), look_at: Vec3::new(5.0, -2.0, -4.0), angle_deg: 75.0 },
        lamp: Vec3::new(2.0, 3.0, 1.0),
        reach: 1.0,
    }
}
