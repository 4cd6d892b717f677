//! Solids that light goes through: whether each has an inside, and which of two counts where they overlap.
//!
//! Where two overlap, the smaller one counts, so that water may reach into the wall of its glass. Of two that are equally
//! large the later in the scene counts; that is chance, so it is a warning.

use crate::check::{Cause, Place, Problem, Severity};
use crate::{Assets, Geometry, GroupPlaces, ListName, Material, Object, Owner, Scene};
use vitrine_math::{Bounds3, Transform, Vec3};

/// Nobody reads more warnings than this.
const MOST_WARNINGS: usize = 20;
/// So many pairs are looked at, then the rest of a scene with very many equal things is let be.
const MOST_PAIRS: usize = 10_000;
/// Volumes that differ less than this, as a share, are equal.
const EQUAL: f32 = 1e-5;
/// Points along each axis that are tried for lying in both of two things.
const TRIES: u32 = 12;

/// A solid of glass, as far as overlaps go.
struct Solid<'a> {
    index: usize,
    object: &'a Object,
    geometry: Geometry,
    place: Transform,
    bounds: Bounds3,
    volume: f32,
}

impl Material {
    /// Whether light goes into it and through its inside: it lets light pass and is not said to be a thin sheet.
    #[must_use]
    pub fn is_solid_glass(&self) -> bool {
        let p = self.physical();
        p.transmission_weight > 0.0 && p.base_metalness < 1.0 && p.geometry_thin_walled != Some(true)
    }
}

impl Scene {
    /// Models of a material that light goes through, or with such materials of their own, that are not closed. It takes time in
    /// proportion to their triangles.
    #[must_use]
    pub fn open_solids(&self, assets: &Assets) -> Vec<Problem> {
        let places = self.group_places();
        let is_open = |object: &Object| {
            let glass = |name: &str| self.material(name).is_some_and(Material::is_solid_glass);
            let mesh = match object.shape.as_kind().geometry(assets) {
                Some(Geometry::Mesh(mesh) | Geometry::Facets(mesh)) => mesh,
                _ => return false,
            };
            let is_glass = match object.material.as_deref() {
                Some(name) => glass(name),
                None => mesh.materials.iter().any(|m| m.material.is_solid_glass()),
            };
            is_glass && !mesh.is_closed()
        };
        let seen = self.objects.iter().enumerate().filter(|(_, o)| places.is_seen(o) && is_open(o));
        seen.map(|(i, object)| warning(i, Cause::OpenSolid { name: object.name.clone() })).collect()
    }

    /// Pairs of balls and boxes of different glass that overlap and are equally large.
    pub(crate) fn equal_solids(&self, places: &GroupPlaces) -> Vec<Problem> {
        let mut solids: Vec<Solid> = (0..self.objects.len()).filter_map(|i| self.solid(i, places)).collect();
        solids.sort_by(|a, b| a.bounds.min.x.total_cmp(&b.bounds.min.x));
        let (mut warnings, mut pairs) = (Vec::new(), 0);
        for (i, a) in solids.iter().enumerate() {
            // Sorted by where they begin: what begins beyond the end of this one cannot overlap it.
            for b in solids[i + 1..].iter().take_while(|b| b.bounds.min.x < a.bounds.max.x) {
                pairs += 1;
                if warnings.len() == MOST_WARNINGS || pairs > MOST_PAIRS {
                    return warnings;
                }
                let is_equal = (a.volume - b.volume).abs() <= EQUAL * a.volume.max(b.volume);
                if is_equal && a.object.material != b.object.material && overlap(a, b) {
                    let (first, last) = if a.index < b.index { (a, b) } else { (b, a) };
                    let (name, other) = (last.object.name.clone(), first.object.name.clone());
                    warnings.push(warning(last.index, Cause::EqualSolids { name, other }));
                }
            }
        }
        warnings
    }

    fn solid(&self, index: usize, places: &GroupPlaces) -> Option<Solid<'_>> {
        let object = &self.objects[index];
        let material = self.material(object.material.as_deref()?)?;
        if !places.is_seen(object) || !material.is_solid_glass() {
            return None;
        }
        // Balls and boxes need no files; whether models overlap would take too long to find out.
        let geometry = object.shape.as_kind().geometry(&Assets::default())?;
        let (half, share) = match geometry {
            Geometry::Sphere { radius } => (Vec3::splat(radius), std::f32::consts::PI / 6.0),
            Geometry::Box { half } => (half, 1.0),
            _ => return None,
        };
        let place = places.world_from_object(object);
        let bounds = place.bounds(&Bounds3 { min: -half, max: half });
        let edges = 2.0 * half;
        let volume =
            share * edges.x * edges.y * edges.z * place.world_from_object.matrix3.determinant().abs();
        Some(Solid { index, object, geometry, place, bounds, volume })
    }
}

/// Whether they have room in common, not only a face: as far as a grid of points in what their boxes share can tell.
fn overlap(a: &Solid, b: &Solid) -> bool {
    let (min, max) = (a.bounds.min.max(b.bounds.min), a.bounds.max.min(b.bounds.max));
    // Things that touch share a little by rounding.
    let least = 1e-4 * (a.bounds.max - a.bounds.min);
    if !(max - min).cmpgt(least).all() {
        return false;
    }
    let steps = || (0..TRIES).map(|i| (i as f32 + 0.5) / TRIES as f32);
    steps().any(|x| {
        steps().any(|y| {
            steps().any(|z| {
                let p = min + (max - min) * Vec3::new(x, y, z);
                a.holds(p) && b.holds(p)
            })
        })
    })
}

impl Solid<'_> {
    fn holds(&self, p: Vec3) -> bool {
        let p = self.place.object_from_world.transform_point3(p);
        match self.geometry {
            Geometry::Sphere { radius } => p.length() < radius,
            Geometry::Box { half } => (half - p.abs()).cmpgt(Vec3::ZERO).all(),
            _ => false,
        }
    }
}

fn warning(index: usize, cause: Cause) -> Problem {
    let place = Place { owner: Some(Owner::Item(ListName::Object, index)), key: None };
    Problem { severity: Severity::Warning, place, cause }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Mesh, Sphere};
    use crate::{Shape, TriangleMesh};
    use std::sync::Arc;

    fn glass(name: &str) -> Material {
        Material { name: name.into(), transmission_weight: Some(1.0), ..Material::default() }
    }

    fn ball(name: &str, material: &str, x: f32, radius: f32) -> Object {
        Object {
            name: name.into(),
            shape: Shape::Sphere(Sphere { radius }),
            position: Vec3::X * x,
            material: Some(material.into()),
            ..Object::default()
        }
    }

    fn found(objects: Vec<Object>) -> Vec<Cause> {
        let materials = vec![glass("glass"), glass("water"), Material::default()];
        let scene = Scene { objects, materials, ..Scene::default() };
        scene.equal_solids(&scene.group_places()).into_iter().map(|p| p.cause).collect()
    }

    #[test]
    fn equal_balls_of_different_glass_that_overlap_are_named_the_later_first() {
        let pair = |other: &str, x, r| vec![ball("b", "glass", x, r), ball("a", other, 0.0, 1.0)];
        let wanted = Cause::EqualSolids { name: "a".into(), other: "b".into() };
        assert_eq!(found(pair("water", 1.0, 1.0)), [wanted]);
        assert_eq!(found(pair("water", 1.0, 0.9)), [], "the smaller counts");
        assert_eq!(found(pair("glass", 1.0, 1.0)), [], "it makes no difference");
        assert_eq!(found(pair("material", 1.0, 1.0)), [], "one is no glass");
        assert_eq!(found(pair("water", 2.0, 1.0)), [], "they touch");
        let mut apart = pair("water", 1.5, 1.0);
        apart[0].position.y = 1.5;
        assert_eq!(found(apart), [], "their boxes overlap, they do not");
    }

    #[test]
    fn open_models_of_glass_are_named_unless_they_are_thin() {
        let sheet = TriangleMesh {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            triangles: vec![[0, 1, 2]],
            ..TriangleMesh::default()
        };
        let meshes = [("sheet.obj".into(), Arc::new(sheet))].into();
        let assets = Assets { meshes, ..Assets::default() };
        let shape = Shape::Mesh(Mesh { file: "sheet.obj".into(), ..Mesh::default() });
        let object = Object { name: "bowl".into(), shape, ..ball("", "glass", 0.0, 1.0) };
        let mut scene = Scene { objects: vec![object], materials: vec![glass("glass")], ..Scene::default() };
        let causes = |s: &Scene| s.open_solids(&assets).into_iter().map(|p| p.cause).collect::<Vec<_>>();
        assert_eq!(causes(&scene), [Cause::OpenSolid { name: "bowl".into() }]);
        scene.materials[0].geometry_thin_walled = Some(true);
        assert_eq!(causes(&scene), []);
    }
}
