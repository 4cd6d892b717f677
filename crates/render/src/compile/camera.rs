//! The camera as a generator of rays.

use crate::accel::packet::{along3, scale3, splat3, sub3, unit3};
use crate::accel::simd::Simd;
use vitrine_math::warp::concentric_disk;
use vitrine_math::{Ray, Vec2, Vec3};
use vitrine_scene::Camera;

/// The height of the sensor for which f-stops are meant, metres: that of a full-frame camera.
const SENSOR_HEIGHT: f32 = 0.024;
/// How far a camera that looks at no point is focused, metres.
const USUAL_FOCUS: f32 = 2.0;

/// A camera: a pinhole, or a thin lens for the renderer that knows lenses.
#[derive(Clone, Copy, Debug)]
pub struct CompiledCamera {
    position: Vec3,
    /// The axes of the camera's own space in the world.
    right: Vec3,
    up: Vec3,
    back: Vec3,
    /// Half of the picture's height at the distance 1.
    tan_half: f32,
    /// None: everything is sharp.
    lens: Option<Lens>,
}

/// A thin lens.
#[derive(Clone, Copy, Debug)]
struct Lens {
    /// Of the opening, metres.
    radius: f32,
    /// Where things are sharp, along the direction of view, metres.
    focus: f32,
    /// How many blades bound the opening; less than 3: it is round.
    blades: u32,
}

impl Lens {
    fn new(camera: &Camera, tan_half: f32) -> Option<Self> {
        let f_stop = camera.f_stop?;
        // The focal length for which the sensor spans the view angle, over twice the f-stop.
        let radius = SENSOR_HEIGHT * 0.5 / tan_half / (2.0 * f_stop);
        let looked_at = camera.look_at.map(|p| (p - camera.position).length());
        let focus = camera.focus_distance.or(looked_at).unwrap_or(USUAL_FOCUS);
        Some(Self { radius, focus, blades: camera.blades })
    }

    /// A point of the opening, metres.
    fn point(&self, u: [f32; 2]) -> Vec2 {
        if self.blades < 3 {
            return concentric_disk(Vec2::from(u)) * self.radius;
        }
        // One of the triangles between the middle and two neighbouring corners, and a point of it.
        let blades = self.blades as f32;
        let turn = u[0] * blades;
        let blade = (turn as u32).min(self.blades - 1) as f32;
        let corner = |k: f32| {
            let (sin, cos) = libm::sincosf(std::f32::consts::TAU * k / blades);
            Vec2::new(cos, sin)
        };
        let (along, across) = ((turn - blade).sqrt(), u[1]);
        (corner(blade) * (1.0 - across) + corner(blade + 1.0) * across) * (along * self.radius)
    }
}

impl CompiledCamera {
    /// From the scene's camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        let axes = camera.rotation();
        let tan_half = libm::tanf(camera.view_angle_deg.to_radians() * 0.5);
        Self {
            position: camera.position,
            right: axes.x_axis,
            up: axes.y_axis,
            back: axes.z_axis,
            tan_half,
            lens: Lens::new(camera, tan_half),
        }
    }

    /// Where all rays start.
    #[must_use]
    pub const fn position(&self) -> Vec3 {
        self.position
    }

    /// The ray through a point of a picture, counted in pixels from its upper left corner, and through the point of the lens that `u`
    /// stands for. Its direction is of unit length.
    #[must_use]
    pub fn ray(&self, at: [f32; 2], size: [u32; 2], u: [f32; 2]) -> Ray {
        let [width, height] = size.map(|v| v as f32);
        let pixel = 2.0 * self.tan_half / height;
        let (x, y) = ((at[0] - 0.5 * width) * pixel, (0.5 * height - at[1]) * pixel);
        let through = self.right * x + self.up * y - self.back;
        let Some(lens) = &self.lens else {
            return Ray::new(self.position, through.normalize());
        };
        let point = lens.point(u);
        let offset = self.right * point.x + self.up * point.y;
        Ray::new(self.position + offset, (through * lens.focus - offset).normalize())
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

    #[test]
    fn all_rays_through_the_lens_meet_where_it_is_focused() {
        for blades in [0, 5, 8] {
            let camera = Camera {
                position: Vec3::new(1.0, 2.0, 3.0),
                f_stop: Some(1.4),
                focus_distance: Some(2.5),
                blades,
                ..Camera::default()
            };
            let camera = CompiledCamera::new(&camera);
            let (at, size) = ([37.0, 11.0], [200, 100]);
            let sharp = |u: [f32; 2]| {
                let ray = camera.ray(at, size, u);
                ray.at((ray.origin.z - 0.5) / -ray.direction.z)
            };
            let first = sharp([0.1, 0.7]);
            for k in 0..50 {
                let u = [0, 1].map(|i| vitrine_math::hash::unit(vitrine_math::hash::mix(2 * k + i)));
                assert!((sharp(u) - first).length() < 1e-5, "{blades} blades");
                let off = camera.ray(at, size, u).origin - camera.position();
                // 12 mm over the tangent of half the angle, over twice the f-stop.
                assert!(off.length() <= 0.012 / 25.0_f32.to_radians().tan() / 2.8 + 1e-6);
            }
        }
    }

    #[test]
    fn without_an_f_stop_a_ray_is_that_of_the_pinhole() {
        let camera = CompiledCamera::new(&Camera::default());
        let ray = camera.ray([30.0, 70.0], [200, 100], [0.3, 0.9]);
        let direction = Instructions::detect().run(Through(&camera, [30.0, 70.0]));
        assert_eq!(ray.origin, camera.position());
        assert!((ray.direction - direction).length() < 1e-6);
    }
}
