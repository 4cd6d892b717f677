//! The course work's experiment 4.2.2: two mirror balls and a third.

use crate::support::{at, coursework, picture};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::Shape;
use vitrine::{Image, Project};

/// The place on a ball where the camera sees another thing mirrored.
fn mirror_point(project: &Project, ball: &str, thing: &str) -> Vec3 {
    let ball = project.scene.object(ball).unwrap();
    let Shape::Sphere(sphere) = &ball.shape else { panic!("{} is a sphere", ball.name) };
    let thing = project.scene.object(thing).unwrap().position;
    // The normal there halves the angle between the ways to the camera and to the thing.
    let mut p = ball.position + Vec3::Y * sphere.radius;
    for _ in 0..100 {
        let to_camera = (project.scene.camera.position - p).normalize();
        let to_thing = (thing - p).normalize();
        p = ball.position + (to_camera + to_thing).normalize() * sphere.radius;
    }
    p
}

fn small(project: &Project, depth: u32, more: &[&str]) -> Image {
    let depth = format!("settings.depth={depth}");
    picture(project, &[&["settings.size=[320,324]", "settings.samples=1", &depth], more].concat())
}

fn difference(a: Rgb, b: Rgb) -> f32 {
    (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs())
}

/// C20, 4.2.2: the red ball shows the green one and the green ball the red one, if mirror images are allowed at all.
#[test]
fn c20_the_mirror_balls_show_each_other() {
    let project = coursework("two-mirror-spheres");
    for (ball, other) in [("red ball", "green ball"), ("green ball", "red ball"), ("red ball", "yellow ball")]
    {
        let place = mirror_point(&project, ball, other);
        let hide = format!("object.{other}.visible=false");
        let [without, with] = [0, 3].map(|depth| {
            let image = small(&project, depth, &[]);
            let hidden = small(&project, depth, &[&hide]);
            (at(&project, &image, place), at(&project, &hidden, place))
        });
        assert!(difference(without.0, without.1) < 1e-6, "no mirror image of the {other} at depth 0");
        assert!(difference(with.0, with.1) > 0.05, "the {other} in the {ball}: {with:?}");
    }
}

/// C20, 4.2.2: the mirror image has the colour of what is mirrored.
#[test]
fn c20_the_mirror_image_has_the_others_colour() {
    let project = coursework("two-mirror-spheres");
    let place = mirror_point(&project, "red ball", "green ball");
    let [own, mirrored] = [0, 1].map(|depth| at(&project, &small(&project, depth, &[]), place));
    let greenness = |c: Rgb| c.g / c.r;
    assert!(greenness(own) < 0.05, "red by itself: {own:?}");
    assert!(greenness(mirrored) > 4.0 * greenness(own), "green has come in: {mirrored:?}");
}

/// C10, C20: each further depth shows further mirror images, fewer and fewer.
#[test]
fn c20_each_depth_shows_more_mirror_images() {
    let project = coursework("two-mirror-spheres");
    let images: Vec<Image> = (0..5).map(|depth| small(&project, depth, &[])).collect();
    let changed: Vec<usize> = images
        .windows(2)
        .map(|pair| {
            let pixels = pair[0].pixels.iter().zip(&pair[1].pixels);
            pixels.filter(|(a, b)| difference(**a, **b) > 0.004).count()
        })
        .collect();
    assert!(changed.windows(2).all(|pair| pair[0] > pair[1]), "{changed:?}");
    assert!(changed[3] > 0, "{changed:?}");
}
