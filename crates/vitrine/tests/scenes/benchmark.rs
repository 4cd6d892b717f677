//! The course work's experiment 4.1, the scene in which speed is measured.

use crate::support::coursework;
use vitrine::math::Vec3;
use vitrine::scene::{Geometry, LightSource, Object, Shape};
use vitrine::{Project, RenderJob, RenderOptions};

fn spheres(project: &Project) -> Vec<(&Object, f32)> {
    let radius = |o: &Object| if let Shape::Sphere(s) = &o.shape { Some(s.radius) } else { None };
    project.scene.objects.iter().filter_map(|o| radius(o).map(|r| (o, r))).collect()
}

fn material(project: &Project, object: &Object) -> vitrine::scene::ClassicMaterial {
    project.scene.material(object.material.as_deref().unwrap()).unwrap().classic()
}

/// C18: one transparent sphere, twelve opaque weakly reflective ones, two strongly reflective ones, four cones of 642
/// triangles in all, two lights, the ground; nothing else.
#[test]
fn c18_the_benchmark_has_the_counts_of_the_course_work() {
    let project = coursework("benchmark");
    let scene = &project.scene;
    let materials: Vec<_> = spheres(&project).iter().map(|(o, _)| material(&project, o)).collect();
    let count = |from: f32, to: f32| {
        let within = |r: f32| from <= r && r <= to;
        materials.iter().filter(|m| m.transparency == 0.0 && within(m.reflectivity)).count()
    };
    assert_eq!(materials.iter().filter(|m| m.transparency > 0.5).count(), 1);
    assert_eq!(count(0.05, 0.25), 12, "weak mirrors");
    assert_eq!(count(0.6, 1.0), 2, "strong mirrors");
    assert_eq!(materials.len(), 15);

    let triangles: Vec<usize> = scene
        .objects
        .iter()
        .filter_map(|o| match o.shape.as_kind().geometry(&project.assets) {
            Some(Geometry::Mesh(mesh) | Geometry::Facets(mesh)) => Some(mesh.triangles.len()),
            _ => None,
        })
        .collect();
    assert_eq!((triangles.len(), triangles.iter().sum::<usize>()), (4, 642), "{triangles:?}");

    let planes = scene.objects.iter().filter(|o| matches!(o.shape, Shape::Plane(_))).count();
    assert_eq!((planes, scene.objects.len()), (1, 15 + 4 + 1), "the ground, and nothing besides");
    let lamps = scene.lights.iter().filter(|l| !matches!(l.source, LightSource::Ambient(_)));
    assert_eq!(lamps.count(), 2, "lights that shine from somewhere");
    assert_eq!((scene.settings.size, scene.settings.samples, scene.settings.depth), ([809, 817], 1, 3));
}

#[test]
fn c18_the_transparent_sphere_encloses_everything_but_the_ground() {
    let project = coursework("benchmark");
    let (dome, radius) =
        spheres(&project).into_iter().find(|(o, _)| material(&project, o).transparency > 0.5).unwrap();
    let reach =
        |object: &Object, p: Vec3| project.scene.world_from_object(object).point(p).distance(dome.position);
    for object in project.scene.objects.iter().filter(|o| o.name != dome.name) {
        match object.shape.as_kind().geometry(&project.assets).unwrap() {
            Geometry::Sphere { radius: r } => {
                assert!(reach(object, Vec3::ZERO) + r < radius, "{}", object.name);
            }
            Geometry::Mesh(mesh) | Geometry::Facets(mesh) => {
                assert!(mesh.positions.iter().all(|p| reach(object, *p) < radius), "{}", object.name);
            }
            _ => assert_eq!(object.name, "ground"),
        }
    }
    assert!(project.scene.camera.position.distance(dome.position) > radius, "seen from without");
}

/// The table and the plot of C18 are measured on some 7 million rays.
#[test]
fn c18_the_benchmark_is_as_large_as_it_was() {
    let project = coursework("benchmark");
    let compiled = vitrine::render::compile(&project.scene, &project.assets).unwrap();
    let options = RenderOptions { settings: project.scene.settings.clone(), region: None };
    let rays =
        RenderJob::new(&compiled, options).unwrap().run(0, &vitrine::Cancel::default(), &mut |_| {}).rays;
    assert!((6_500_000..7_500_000).contains(&rays), "{rays} rays");
}
