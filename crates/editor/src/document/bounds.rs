//! How much room things take in the world.

use super::Thing;
use super::edits::members_of;
use super::thing::Places;
use vitrine::math::{Bounds3, Transform, Vec3};
use vitrine::scene::lights::Emission;
use vitrine::scene::{Assets, Geometry, Light, ListName, Object, Owner, Scene};

/// The box in the world around things: objects, what is in groups, lights that have a place. Planes, having no end, do
/// not count, and neither do the camera and models that are not among the assets. Empty when nothing counts.
#[must_use]
pub fn bounds_of(scene: &Scene, assets: &Assets, things: &[Thing]) -> Bounds3 {
    let members = members_of(scene, things);
    let (mut places, groups) = (Places::new(scene), scene.group_places());
    let mut bounds = Bounds3::EMPTY;
    for owner in things.iter().chain(&members).filter_map(|thing| places.owner(thing)) {
        bounds = bounds.union(match owner {
            Owner::Item(ListName::Object, i) => {
                let object = &scene.objects[i];
                object_bounds(object, &groups.world_from_object(object), assets)
            }
            Owner::Item(ListName::Light, i) => light_bounds(&scene.lights[i]),
            _ => Bounds3::EMPTY,
        });
    }
    bounds
}

/// The box in the world around all objects that are seen, planes apart.
#[must_use]
pub fn bounds_of_all(scene: &Scene, assets: &Assets) -> Bounds3 {
    let places = scene.group_places();
    let seen = scene.objects.iter().filter(|object| places.is_seen(object));
    let each = seen.map(|object| object_bounds(object, &places.world_from_object(object), assets));
    each.fold(Bounds3::EMPTY, Bounds3::union)
}

/// The box in the world around an object that stands there.
pub(crate) fn object_bounds(object: &Object, place: &Transform, assets: &Assets) -> Bounds3 {
    let m = place.world_from_object;
    match object.shape.as_kind().geometry(assets) {
        Some(Geometry::Sphere { radius }) => {
            // Along each axis an ellipsoid reaches as far as the row of its map is long.
            let rows = m.matrix3.transpose();
            let lengths = Vec3::new(rows.x_axis.length(), rows.y_axis.length(), rows.z_axis.length());
            let (center, reach) = (Vec3::from(m.translation), lengths * radius);
            Bounds3 { min: center - reach, max: center + reach }
        }
        Some(Geometry::Disc { radius }) => {
            // Likewise, of a disc that has no height.
            let (x, z) = (Vec3::from(m.matrix3.x_axis), Vec3::from(m.matrix3.z_axis));
            let reach = (x * x + z * z).map(f32::sqrt) * radius;
            let center = Vec3::from(m.translation);
            Bounds3 { min: center - reach, max: center + reach }
        }
        Some(Geometry::Box { half }) => place.bounds(&Bounds3 { min: -half, max: half }),
        Some(Geometry::Triangle { points, .. }) => Bounds3::around(points.map(|p| place.point(p))),
        Some(Geometry::Mesh(mesh) | Geometry::Facets(mesh)) => {
            Bounds3::around(mesh.positions.iter().map(|p| place.point(*p)))
        }
        Some(Geometry::Plane) | None => Bounds3::EMPTY,
    }
}

fn light_bounds(light: &Light) -> Bounds3 {
    // What has a place needs no file.
    match light.source.as_kind().emission(&Assets::default()) {
        Some(Emission::Point { position }) => Bounds3::around([position]),
        Some(Emission::Disc { position, radius }) => {
            let reach = Vec3::new(radius, 0.0, radius);
            Bounds3 { min: position - reach, max: position + reach }
        }
        Some(Emission::Sphere { position, radius }) => {
            let reach = Vec3::splat(radius);
            Bounds3 { min: position - reach, max: position + reach }
        }
        _ => Bounds3::EMPTY,
    }
}

/// The height of a plane that lies level; None for all else.
pub(crate) fn plane_level(object: &Object, place: &Transform) -> Option<f32> {
    let is_plane = matches!(object.shape, vitrine::scene::Shape::Plane(_));
    (is_plane && place.normal(Vec3::Y).y.abs() > 0.999_999).then(|| place.point(Vec3::ZERO).y)
}

/// Whether two boxes have no point in common as far as these axes tell.
pub(crate) fn is_apart<const N: usize>(a: &Bounds3, b: &Bounds3, axes: [usize; N]) -> bool {
    axes.iter().any(|axis| a.max[*axis] <= b.min[*axis] || b.max[*axis] <= a.min[*axis])
}
