//! New things with good defaults: where the camera looks, standing on the floor, of a size that suits the picture, lit
//! and coloured so that they can be seen.

use super::edits::Names;
use super::{Addition, bounds_of_all, object_bounds, plane_level};
use vitrine::math::{Bounds3, Rgb, Vec3};
use vitrine::scene::{Assets, Light, LightSource, ListName, Material, Object, Scene, Shape, Value, params};

/// How far ahead a camera that sees nothing is thought to look, metres.
const NOWHERE: f32 = 5.0;

/// The point that the camera turns about: what it is aimed at, else the nearer of the floor in the middle of the picture
/// and the middle of the things ahead.
#[must_use]
pub fn orbit_center(scene: &Scene, assets: &Assets) -> Vec3 {
    if let Some(target) = scene.camera.look_at {
        return target;
    }
    let (position, forward) = (scene.camera.position, forward(scene));
    let things = bounds_of_all(scene, assets);
    let ahead = (!things.is_empty()).then(|| (things.center() - position).dot(forward));
    let ahead = ahead.filter(|distance| *distance > 0.0 && distance.is_finite());
    let distances = [floor_distance(scene), ahead];
    position + forward * distances.into_iter().flatten().reduce(f32::min).unwrap_or(NOWHERE)
}

fn forward(scene: &Scene) -> Vec3 {
    scene.camera.rotation() * Vec3::NEG_Z
}

/// How far the floor is along the ray through the picture's middle; None when the ray does not meet it.
fn floor_distance(scene: &Scene) -> Option<f32> {
    let (position, forward) = (scene.camera.position, forward(scene));
    let distance = (floor_level(scene) - position.y) / forward.y;
    // A floor that is met near the horizon is nowhere that a person looks at.
    (distance > 0.0 && distance.is_finite() && forward.y < -0.02).then_some(distance)
}

/// The height of the floor: the highest level plane below the camera, else 0.
fn floor_level(scene: &Scene) -> f32 {
    let places = scene.group_places();
    let seen = scene.objects.iter().filter(|object| places.is_seen(object));
    let levels = seen.filter_map(|object| plane_level(object, &places.world_from_object(object)));
    levels.filter(|level| *level < scene.camera.position.y).reduce(f32::max).unwrap_or(0.0)
}

/// The place of a new thing and how large the picture is there.
struct Site {
    /// On the floor.
    point: Vec3,
    /// How many metres the picture's height spans there.
    height: f32,
    /// The camera's right, level.
    right: Vec3,
    /// Away from the camera, level.
    away: Vec3,
}

impl Site {
    fn of(scene: &Scene, assets: &Assets) -> Self {
        let camera = &scene.camera;
        let floor = floor_level(scene);
        let point = match floor_distance(scene) {
            Some(distance) => camera.position + forward(scene) * distance,
            None => orbit_center(scene, assets).with_y(floor),
        };
        let distance = (point - camera.position).length().max(1e-3);
        let height = 2.0 * distance * (camera.view_angle_deg / 2.0).to_radians().tan();
        let right = camera.rotation().x_axis.with_y(0.0).normalize_or(Vec3::X);
        Self { point: point.map(|v| rounded(v, height / 100.0)), height, right, away: Vec3::Y.cross(right) }
    }

    /// A turn about Y that lets a thing face the camera, whole degrees.
    fn facing_deg(&self) -> f32 {
        (-self.right.z).atan2(self.right.x).to_degrees().round() + 0.0
    }
}

/// A new object or light of that kind where the camera looks, with the material that comes with it. Nothing when there is no such kind.
#[must_use]
pub fn new_thing(scene: &Scene, assets: &Assets, list: ListName, kind: &str) -> Addition {
    let site = Site::of(scene, assets);
    match list {
        ListName::Object => new_object(scene, assets, kind, &site).unwrap_or_default(),
        ListName::Light => new_light(scene, kind, &site).unwrap_or_default(),
        ListName::Material | ListName::Texture | ListName::Group => Addition::default(),
    }
}

/// A name that nothing in the list has: this one, or with a number.
#[must_use]
pub fn free_name(scene: &Scene, list: ListName, name: &str) -> String {
    Names::of(scene, list).take(name)
}

/// A name that is not among these: this one, or with a number.
#[must_use]
pub fn free_name_among<'a>(taken: impl Iterator<Item = &'a str>, name: &str) -> String {
    Names::among(taken).take(name)
}

fn new_object(scene: &Scene, assets: &Assets, kind: &str, site: &Site) -> Option<Addition> {
    let mut shape = Shape::from_kind(kind)?;
    // A quarter of the picture's height.
    let size = one_digit(site.height / 4.0);
    let mut turn_deg = Vec3::ZERO;
    match &mut shape {
        Shape::Sphere(sphere) => sphere.radius = one_digit(site.height / 8.0),
        Shape::Box(cuboid) => cuboid.size = Vec3::splat(size),
        Shape::Triangle(triangle) => {
            triangle.points = triangle.points.map(|p| p * size);
            turn_deg.y = site.facing_deg();
        }
        Shape::Disc(disc) => {
            // Upright, facing the camera: lying, it would vanish into the floor.
            disc.radius = one_digit(site.height / 8.0);
            turn_deg = Vec3::new(90.0, site.facing_deg(), 0.0);
        }
        Shape::Plane(_) | Shape::Mesh(_) => {}
    }
    let name = free_name(scene, ListName::Object, kind);
    let mut object = Object { name, shape, turn_deg, ..Object::default() };
    if let Shape::Plane(_) = object.shape {
        place_plane(&mut object, scene, assets, site);
    } else {
        stand(&mut object, scene, assets, site);
    }
    let material = fresh_material(scene, &object.name);
    object.material = Some(material.name.clone());
    Some(Addition { objects: vec![object], materials: vec![material], ..Addition::default() })
}

/// The first plane is the floor, further ones are walls behind everything.
fn place_plane(object: &mut Object, scene: &Scene, assets: &Assets, site: &Site) {
    let places = scene.group_places();
    let has_floor = scene.objects.iter().any(|o| plane_level(o, &places.world_from_object(o)).is_some());
    if !has_floor {
        return;
    }
    let corners = bounds_of_all(scene, assets);
    let depth = |p: Vec3| (p - site.point).dot(site.away);
    let behind =
        if corners.is_empty() { 0.0 } else { corners.corners().into_iter().map(depth).fold(0.0, f32::max) };
    let wall = site.point + site.away * (behind + site.height / 4.0);
    object.position = wall.map(|v| rounded(v, site.height / 100.0));
    object.turn_deg = Vec3::new(90.0, site.facing_deg(), 0.0);
}

/// Puts an object on the floor at the site, or beside it where there is room.
fn stand(object: &mut Object, scene: &Scene, assets: &Assets, site: &Site) {
    let own = object_bounds(object, &object.place(), assets);
    if own.is_empty() {
        object.position = site.point;
        return;
    }
    let foot = own.center().with_y(own.min.y);
    let step = own.size().max_element() * 1.15;
    let others = others(scene, assets);
    let fits = |by: Vec3| {
        let shrunk = own.size() * 0.01;
        let bounds = Bounds3 { min: own.min + by + shrunk, max: own.max + by - shrunk };
        others.iter().all(|other| super::bounds::is_apart(other, &bounds, [0, 1, 2]))
    };
    // In the middle, to the right, to the left, further aside; then a row nearer, a row farther.
    let spots = [0.0, -1.0, 1.0, -2.0].into_iter().flat_map(|row| {
        [0.0, 1.0, -1.0, 2.0, -2.0].map(|aside| site.right * (aside * step) + site.away * (row * step))
    });
    let mut moves = spots.map(|spot| (site.point + spot - foot).map(|v| rounded(v, site.height / 100.0)));
    let first = site.point - foot;
    let mut by = moves.find(|by| fits(*by)).unwrap_or(first);
    // It stands on the floor to the last digit.
    by.y = first.y;
    object.position = by;
}

fn others(scene: &Scene, assets: &Assets) -> Vec<Bounds3> {
    let places = scene.group_places();
    let seen = scene.objects.iter().filter(|object| places.is_seen(object));
    let all = seen.map(|object| object_bounds(object, &places.world_from_object(object), assets));
    all.filter(|bounds| !bounds.is_empty()).collect()
}

/// A light above the site and on the camera's right, weaker when there are others.
fn new_light(scene: &Scene, kind: &str, site: &Site) -> Option<Addition> {
    let mut source = LightSource::from_kind(kind)?;
    let step = site.height / 100.0;
    let above = site.right * (0.3 * site.height) - site.away * (0.25 * site.height);
    let above = (above + Vec3::Y * (0.7 * site.height)).map(|v| rounded(v, step));
    let values = [
        ("position", Value::Vector((site.point + above).map(|v| rounded(v, step)))),
        ("direction", Value::Vector(-above)),
        ("radius", Value::Number(one_digit(site.height / 14.0))),
    ];
    for (key, value) in values {
        // Only what the kind has; a scene of a size that makes a value impossible keeps the default.
        let _ = params::set(source.params_mut(), key, value).is_ok();
    }
    let is_lit = scene.lights.iter().any(|l| l.visible && l.intensity > 0.0);
    let intensity = match (&source, is_lit) {
        (LightSource::Ambient(_), _) => 0.2,
        (LightSource::Environment(_) | LightSource::Sky(_), false) => 1.0,
        (_, true) => 0.4,
        (_, false) => 0.7,
    };
    let name = free_name(scene, ListName::Light, kind);
    let light = Light { name, source, intensity, ..Light::default() };
    Some(Addition { lights: vec![light], ..Addition::default() })
}

/// Colours that go together and differ from one another, also for people who tell red and green apart badly.
const PALETTE: [&str; 8] =
    ["#d9553f", "#3f8fd2", "#e2b13c", "#4fa874", "#8d6bc4", "#e58ab0", "#59b9c6", "#b98a5e"];

/// A material named after its object, of a colour that no other has, with every scale stated.
fn fresh_material(scene: &Scene, name: &str) -> Material {
    let colors: Vec<Rgb> = PALETTE.iter().filter_map(|hex| Rgb::from_hex(hex).ok()).collect();
    let uses = |color: &Rgb| scene.materials.iter().filter(|m| m.color == Some(*color)).count();
    Material {
        name: free_name(scene, ListName::Material, name),
        color: colors.into_iter().min_by_key(uses),
        diffuse: Some(0.8),
        specular: Some(0.3),
        shininess: Some(50.0),
        reflectivity: Some(0.0),
        transparency: Some(0.0),
        ..Material::default()
    }
}

/// The nearest multiple of the power of ten at or below the step.
fn rounded(v: f32, step: f32) -> f32 {
    if !(step > 1e-6 && v.abs() < 1e6 * step) {
        return v;
    }
    let per_unit = 10_f32.powi(-(step.log10().floor() as i32));
    (v * per_unit).round() / per_unit + 0.0
}

/// The number with one digit that counts.
fn one_digit(v: f32) -> f32 {
    digits(v, 0)
}

fn digits(v: f32, more: i32) -> f32 {
    let power = v.abs().max(f32::MIN_POSITIVE).log10().floor() as i32 - more;
    let (per_unit, unit) = (10_f32.powi(-power), 10_f32.powi(power));
    let digits = (v * per_unit).round();
    // Dividing by a whole number rounds once, multiplying by a fraction twice: 0.3 and not 0.30000001.
    if power < 0 { digits / per_unit } else { digits * unit }
}
