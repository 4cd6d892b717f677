//! The seed: what the course work's benchmark consists of, without the dome of glass around it: 15 balls, the ground, and
//! four cones of 642 triangles together.

use super::shapes::cone;
use crate::{Ball, Scene, View};
use std::f32::consts::TAU;
use vitrine_math::Vec3;

/// Makes the seed.
pub fn scene() -> Scene {
    let on_circle = |i: usize, count: usize, radius: f32| {
        let (sin, cos) = libm::sincosf(TAU * i as f32 / count as f32);
        Vec3::new(radius * cos, 0.0, radius * sin)
    };
    let standing = |at: Vec3, radius: f32| Ball { center: at + Vec3::Y * radius, radius };
    let ring = (0..12).map(|i| standing(on_circle(i, 12, 2.3), 0.42));
    let large = [-1.0, 1.0].map(|side| standing(Vec3::new(0.75 * side, 0.0, 0.0), 0.7));
    let models = [80, 80, 80, 81].into_iter().enumerate().map(|(i, sides)| {
        let foot = on_circle(2 * i + 1, 8, 1.45);
        cone(sides).moved(|p| p * 0.9 + foot)
    });
    Scene {
        balls: ring.chain(large).chain([standing(Vec3::new(0.0, 1.35, 0.0), 0.3)]).collect(),
        floor: Some(0.0),
        models: models.collect(),
        view: View { eye: Vec3::new(0.0, 6.6, 8.4), look_at: Vec3::new(0.0, 0.45, 0.0), angle_deg: 34.0 },
        lamp: Vec3::new(-6.0, 11.0, 4.0),
        reach: 0.5,
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_has_the_counts_of_the_course_work() {
        let scene = super::scene();
        assert_eq!((scene.balls.len(), scene.models.len(), scene.triangles()), (15, 4, 642));
    }
}
