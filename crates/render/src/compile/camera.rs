//! The camera as a generator of rays.

use crate::accel::packet::{along3, scale3, splat3, sub3, unit3};
use crate::accel::simd::Simd;
use vitrine_math::Vec3;
use vitrine_scene::Camera;

/// A pinhole camera.
#[derive(Clone, Copy, Debug)]
pub struct CompiledCamera {
    position: Vec3,
    /// The axes of the camera's own space in the world.
    right: Vec3,
    up: Vec3,
    back: Vec3,
    /// Half of the picture's height at the distance 1.
    tan_half: f32,
}

impl CompiledCamera {
    /// From the scene's camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        let axes = camera.rotation();
        Self {
            position: camera.position,
            right: axes.x_axis,
            up: axes.y_axis,
            back: axes.z_axis,
            tan_half: libm::tanf(camera.view_angle_deg.to_radians() * 0.5),
        }
    }

    /// Where all rays start.
    #[must_use]
    pub const fn position(&self) -> Vec3 {
        self.position
    }

    /// The unit directions through points of a picture of so many pixels, `at` counted in pixels from its upper left corner.
    #[inline(always)]
    pub fn directions<S: Simd>(&self, s: S, at: &[S::F; 2], size: [u32; 2]) -> [S::F; 3] {
        let [width, height] = size.map(|v| v as f32);
        let pixel = s.splat(2.0 * self.tan_half / height);
        let x = s.mul(s.sub(at[0], s.splat(0.5 * width)), pixel);
        let y = s.mul(s.sub(s.splat(0.5 * height), at[1]), pixel);
        let [right, up, back] = [self.right, self.up, self.back].map(|axis| axis.to_array());
        let across = along3(s, &scale3(s, &splat3(s, right), x), &splat3(s, up), y);
        unit3(s, &sub3(s, &across, &splat3(s, back)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::packet::store3;
    use crate::accel::simd::{Instructions, Kernel};

    /// The direction through a point of a picture of 200 × 100 pixels.
    struct Through<'a>(&'a CompiledCamera, [f32; 2]);

    impl Kernel for Through<'_> {
        type Output = Vec3;
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> Vec3 {
            let mut out = [[0.0; 16]; 3];
            let at = [s.splat(self.1[0]), s.splat(self.1[1])];
            store3(s, &self.0.directions(s, &at, [200, 100]), &mut out, 0);
            Vec3::from(out.map(|column| column[S::LANES - 1]))
        }
    }

    #[test]
    fn the_middle_looks_forward_and_the_upper_edge_up_by_half_the_angle() {
        let camera = CompiledCamera::new(&Camera { view_angle_deg: 60.0, ..Camera::default() });
        let through = |at| Instructions::detect().run(Through(&camera, at));
        assert_eq!(through([100.0, 50.0]), Vec3::NEG_Z);
        let top = through([100.0, 0.0]);
        assert!((top.y.asin().to_degrees() - 30.0).abs() < 1e-3);
        let right = through([200.0, 50.0]);
        assert!(right.x > 0.0 && right.y == 0.0);
    }
}
