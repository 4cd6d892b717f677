//! The camera as a generator of rays.

use vitrine_math::{Mat3, Ray, Vec3};
use vitrine_scene::Camera;

/// A pinhole camera.
#[derive(Clone, Copy, Debug)]
pub struct CompiledCamera {
    position: Vec3,
    world_from_camera: Mat3,
    /// Half of the picture's height at the distance 1.
    tan_half: f32,
}

impl CompiledCamera {
    /// From the scene's camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        Self {
            position: camera.position,
            world_from_camera: camera.rotation(),
            tan_half: libm::tanf(camera.view_angle_deg.to_radians() * 0.5),
        }
    }

    /// The ray through a point of a picture of so many pixels, `at` counted in pixels from its upper left corner. Of unit
    /// direction.
    #[inline(always)]
    #[must_use]
    pub fn generate_ray(&self, at: [f32; 2], size: [u32; 2]) -> Ray {
        let [width, height] = size.map(|v| v as f32);
        let pixel = 2.0 * self.tan_half / height;
        let x = (at[0] - 0.5 * width) * pixel;
        let y = (0.5 * height - at[1]) * pixel;
        let direction = self.world_from_camera * Vec3::new(x, y, -1.0);
        Ray::new(self.position, direction.normalize())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_looks_forward_and_the_upper_edge_up_by_half_the_angle() {
        let camera = CompiledCamera::new(&Camera { view_angle_deg: 60.0, ..Camera::default() });
        let middle = camera.generate_ray([100.0, 50.0], [200, 100]);
        assert_eq!(middle.direction, Vec3::NEG_Z);
        let top = camera.generate_ray([100.0, 0.0], [200, 100]).direction;
        assert!((top.y.asin().to_degrees() - 30.0).abs() < 1e-3);
        let right = camera.generate_ray([200.0, 50.0], [200, 100]).direction;
        assert!(right.x > 0.0 && right.y == 0.0);
    }
}
