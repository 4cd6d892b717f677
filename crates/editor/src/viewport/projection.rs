//! Where points of the scene appear in the window, and which ray of the camera a point of the window stands for.

use eframe::egui::{Pos2, Rect, Vec2, pos2, vec2};
use vitrine::math::{Mat3, Ray, Vec3};
use vitrine::scene::Camera;

/// Nothing nearer to the camera is drawn over the picture, metres.
const NEAR: f32 = 1e-3;

/// The camera and the rectangle that its picture fills.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    rect: Rect,
    position: Vec3,
    /// Columns: the camera's right, up and back.
    axes: Mat3,
    /// Points of the window for a metre at the distance of a metre.
    points: f32,
}

impl Projection {
    /// Of a camera whose picture fills a rectangle.
    #[must_use]
    pub fn new(camera: &Camera, rect: Rect) -> Self {
        let half = (camera.view_angle_deg.to_radians() * 0.5).tan();
        let points = 0.5 * rect.height().max(1.0) / half;
        Self { rect, position: camera.position, axes: camera.rotation(), points }
    }

    /// The camera's place.
    #[must_use]
    pub const fn eye(&self) -> Vec3 {
        self.position
    }

    /// The way that the camera looks.
    #[must_use]
    pub fn forward(&self) -> Vec3 {
        -self.axes.z_axis
    }

    /// The camera's right.
    #[must_use]
    pub const fn right(&self) -> Vec3 {
        self.axes.x_axis
    }

    /// The camera's up.
    #[must_use]
    pub const fn up(&self) -> Vec3 {
        self.axes.y_axis
    }

    /// How far before the camera a point is, along its view, metres.
    #[must_use]
    pub fn depth(&self, point: Vec3) -> f32 {
        (point - self.position).dot(self.forward())
    }

    /// Where a point of the scene appears; None when it is behind the camera.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Pos2> {
        let local = self.axes.transpose() * (point - self.position);
        let depth = -local.z;
        let place = self.rect.center() + vec2(local.x, -local.y) * (self.points / depth);
        (depth > NEAR && place.x.is_finite() && place.y.is_finite()).then_some(place)
    }

    /// The camera's ray through a point of the window, of unit direction.
    #[must_use]
    pub fn ray(&self, at: Pos2) -> Ray {
        let from_center = (at - self.rect.center()) / self.points;
        let direction = self.axes * Vec3::new(from_center.x, -from_center.y, -1.0);
        Ray::new(self.position, direction.normalize())
    }

    /// A point of the window as shares of the picture's width and height.
    #[must_use]
    pub fn share(&self, at: Pos2) -> Vec2 {
        (at - self.rect.min) / self.rect.size().max(vec2(1.0, 1.0))
    }

    /// How many metres a point of the window spans at a point of the scene.
    #[must_use]
    pub fn metres_a_point(&self, at: Vec3) -> f32 {
        self.depth(at).max(NEAR) / self.points
    }

    /// Where a ray meets a plane; None when it runs along it or away from it.
    #[must_use]
    pub fn on_plane(ray: &Ray, point: Vec3, n: Vec3) -> Option<Vec3> {
        let slope = ray.direction.dot(n);
        if slope.abs() < 1e-4 {
            return None;
        }
        let t = (point - ray.origin).dot(n) / slope;
        (t > 0.0 && t.is_finite()).then(|| ray.at(t))
    }

    /// How far along a line, from `point` in units of `axis`, a ray comes nearest to it; None when both are parallel.
    #[must_use]
    pub fn along_line(ray: &Ray, point: Vec3, axis: Vec3) -> Option<f32> {
        // The foot of the common perpendicular.
        let (d, w) = (ray.direction, point - ray.origin);
        let (b, axis2) = (axis.dot(d), axis.length_squared());
        let across = axis2 - b * b;
        (across > 1e-4 * axis2).then(|| (b * d.dot(w) - axis.dot(w)) / across)
    }
}

/// The largest rectangle of that shape in the middle of another, its edges on whole pixels.
#[must_use]
pub fn letterbox(outer: Rect, size: [u32; 2], pixels_per_point: f32) -> Rect {
    let [width, height] = size.map(|v| v.max(1) as f32);
    let scale = (outer.width() / width).min(outer.height() / height).max(0.0);
    let whole = |v: f32| (v * pixels_per_point).round() / pixels_per_point;
    let inner = vec2(whole(width * scale), whole(height * scale));
    let corner = outer.center() - inner * 0.5;
    Rect::from_min_size(pos2(whole(corner.x), whole(corner.y)), inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn projection() -> Projection {
        let camera =
            Camera { position: Vec3::new(3.0, 2.0, 6.0), look_at: Some(Vec3::Y), ..Camera::default() };
        Projection::new(&camera, Rect::from_min_size(pos2(100.0, 50.0), vec2(400.0, 300.0)))
    }

    #[test]
    fn rays_go_through_what_appears_there() {
        let projection = projection();
        assert!((projection.project(Vec3::Y).unwrap() - pos2(300.0, 200.0)).length() < 1e-3);
        for point in [Vec3::ZERO, Vec3::new(1.0, 2.0, -3.0), Vec3::new(-4.0, 0.5, 1.0)] {
            let at = projection.project(point).unwrap();
            let ray = projection.ray(at);
            let off = (point - ray.origin).cross(ray.direction).length();
            assert!(off < 1e-4, "{off}");
        }
        assert_eq!(projection.project(Vec3::new(6.0, 3.0, 12.0)), None, "behind the camera");
    }

    #[test]
    fn the_ray_is_the_one_that_the_renderer_sends() {
        let camera =
            Camera { position: Vec3::new(3.0, 2.0, 6.0), look_at: Some(Vec3::Y), ..Camera::default() };
        let scene = vitrine::Scene { camera: camera.clone(), ..vitrine::Scene::default() };
        let compiled = vitrine::render::compile(&scene, &vitrine::scene::Assets::default()).unwrap();
        let projection = Projection::new(&camera, Rect::from_min_size(Pos2::ZERO, vec2(400.0, 300.0)));
        for at in [[0.0, 0.0], [123.0, 45.5], [400.0, 299.0]] {
            let ours = projection.ray(at.into()).direction;
            assert!((ours - compiled.camera_ray(at, [400, 300]).direction).length() < 1e-5);
        }
    }

    #[test]
    fn lines_and_planes_are_met_where_they_are() {
        let ray = Ray::new(Vec3::new(0.0, 2.0, 5.0), Vec3::new(0.0, -0.6, -0.8));
        let floor = Projection::on_plane(&ray, Vec3::ZERO, Vec3::Y).unwrap();
        assert!(floor.y.abs() < 1e-5 && (floor.z - (5.0 - 8.0 / 3.0)).abs() < 1e-4);
        assert_eq!(Projection::on_plane(&ray, Vec3::new(0.0, 9.0, 0.0), Vec3::Y), None, "behind it");
        let along = Projection::along_line(&ray, Vec3::new(1.0, 2.0, 5.0), Vec3::X * 2.0).unwrap();
        assert!((along + 0.5).abs() < 1e-5, "{along}");
        assert_eq!(Projection::along_line(&ray, Vec3::ZERO, ray.direction), None);
    }

    #[test]
    fn pictures_keep_their_shape() {
        let outer = Rect::from_min_size(pos2(10.0, 0.0), vec2(640.0, 520.0));
        let inner = letterbox(outer, [960, 720], 2.0);
        assert_eq!(inner, Rect::from_min_size(pos2(10.0, 20.0), vec2(640.0, 480.0)));
        let tall = letterbox(outer, [100, 400], 1.0);
        assert_eq!((tall.size(), tall.center()), (vec2(130.0, 520.0), outer.center()));
    }
}
