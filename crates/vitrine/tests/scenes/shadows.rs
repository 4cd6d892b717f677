//! The course work's experiment 4.2.5: a disc lamp and its soft shadows.

use crate::support::{at, coursework, picture};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::lights::{Disc, Point};
use vitrine::scene::{LightSource, Shape};
use vitrine::{Image, Project};

const SIZE: &str = "settings.size=[400,404]";

/// Which light the lamp is, and where it hangs.
fn lamp(project: &Project) -> (usize, Vec3) {
    let position = |source: &LightSource| match source {
        LightSource::Disc(Disc { position, .. }) | LightSource::Point(Point { position }) => Some(*position),
        _ => None,
    };
    let mut lamps =
        project.scene.lights.iter().enumerate().filter_map(|(i, l)| Some((i, position(&l.source)?)));
    lamps.next().unwrap()
}

/// The share of the lamp's light that reaches each point shown; None where it would not with nothing in its way either.
fn shares(project: &Project) -> Image {
    let small = |more: &str| picture(project, &[SIZE, "settings.samples=1", "settings.shadow_error=0", more]);
    let (index, _) = lamp(project);
    let name = &project.scene.lights[index].name;
    let (lit, open) = (small("settings.seed=1"), small("settings.renderer=cast"));
    let dark = small(&format!("light.{name}.visible=false"));
    let pixels = (0..lit.pixels.len()).map(|i| {
        let whole = open.pixels[i].g - dark.pixels[i].g;
        let share = if whole > 0.02 { (lit.pixels[i].g - dark.pixels[i].g) / whole } else { 0.0 };
        Rgb::splat(share)
    });
    Image { size: lit.size, pixels: pixels.collect() }
}

fn partial(shares: &Image) -> usize {
    shares.pixels.iter().filter(|s| (0.1..0.9).contains(&s.g)).count()
}

/// C8, C12, C20, 4.2.5: a disc lamp's shadows have every brightness between dark and light, a bulb's have none.
#[test]
fn c20_a_disc_lamp_casts_soft_shadows_where_a_bulb_casts_hard_ones() {
    let mut project = coursework("soft-shadows");
    assert_eq!(project.scene.settings.shadow_points, 64);
    let soft = shares(&project);
    let (index, position) = lamp(&project);
    assert!(matches!(project.scene.lights[index].source, LightSource::Disc(_)));
    project.scene.lights[index].source = LightSource::Point(Point { position });
    let hard = shares(&project);
    assert_eq!(partial(&hard), 0, "a bulb is seen whole or not at all");
    assert!(partial(&soft) > soft.pixels.len() / 50, "{} of {}", partial(&soft), soft.pixels.len());
    for step in 1..9 {
        let range = step as f32 / 10.0..(step + 1) as f32 / 10.0;
        let there = soft.pixels.iter().filter(|s| range.contains(&s.g)).count();
        assert!(there > 100, "{there} with a share in {range:?}");
    }
}

/// How far on the ground the light takes from dark to full, going away from the lamp over the end of a ball's shadow.
fn width_of_edge(project: &Project, shares: &Image, ball: &str) -> f32 {
    let (_, lamp) = lamp(project);
    let ball = project.scene.object(ball).unwrap();
    assert!(matches!(ball.shape, Shape::Sphere(_)));
    let fall = lamp.y / (lamp.y - ball.position.y);
    let middle = lamp + (ball.position - lamp) * fall;
    let away = Vec3::new(middle.x - lamp.x, 0.0, middle.z - lamp.z).normalize();
    const STEP: f32 = 0.005;
    let along = (0..200).map(|i| at(project, shares, middle.with_y(0.0) + away * (i as f32 * STEP)).g);
    along.filter(|share| (0.1..0.9).contains(share)).count() as f32 * STEP
}

/// C20, 4.2.5: the farther a thing is from the ground, the wider the soft edge of its shadow.
#[test]
fn c20_soft_edges_widen_with_distance() {
    let project = coursework("soft-shadows");
    let shares = shares(&project);
    let near = width_of_edge(&project, &shares, "ball");
    let far = width_of_edge(&project, &shares, "hovering ball");
    assert!(near > 0.03 && far > 1.3 * near, "{near} m and {far} m");
}
