//! The course work's experiments 4.2.3 and 4.2.4: a picture on a sphere and on a triangle.

use crate::support::{at, coursework, picture};
use std::path::Path;
use vitrine::math::Vec3;
use vitrine::scene::{LightSource, Shape};
use vitrine::{Image, Project};

/// Even light alone, of brightness 1: things show their bare colours.
fn evenly_lit(name: &str) -> Project {
    let mut project = coursework(name);
    for light in &mut project.scene.lights {
        light.visible = matches!(light.source, LightSource::Ambient(_));
        light.intensity = 1.0;
    }
    for material in &mut project.scene.materials {
        material.reflectivity = Some(0.0);
    }
    project
}

const SMALL: [&str; 2] = ["settings.size=[240,240]", "settings.samples=1"];

/// The mean squared distance of the colours from their mean, over the pixels that show the globe.
fn variance(project: &Project, image: &Image) -> f32 {
    let middle = project.scene.object("globe").unwrap().position;
    let across = project.scene.camera.rotation();
    let colors: Vec<_> = (0..400)
        .map(|i| {
            let (x, y) = ((i % 20) as f32 / 20.0 - 0.475, (i / 20) as f32 / 20.0 - 0.475);
            at(project, image, middle + across * Vec3::new(x, y, 0.0)).to_array()
        })
        .collect();
    (0..3)
        .map(|k| {
            let mean = colors.iter().map(|c| c[k]).sum::<f32>() / colors.len() as f32;
            colors.iter().map(|c| (c[k] - mean) * (c[k] - mean)).sum::<f32>() / colors.len() as f32
        })
        .sum()
}

/// C20, 4.2.3: the ball shows its picture, not one colour.
#[test]
fn c20_the_ball_shows_its_picture() {
    let mut project = evenly_lit("textured-sphere");
    let shown = variance(&project, &picture(&project, &SMALL));
    for material in &mut project.scene.materials {
        material.texture = None;
    }
    let plain = variance(&project, &picture(&project, &SMALL));
    assert!(plain < 1e-9, "without the picture it has one colour: {plain}");
    assert!(shown > 0.01, "{shown}");
}

/// C7, C20, 4.2.3: longitude runs along the picture's width, so a quarter of a turn is a quarter of the picture.
#[test]
fn c20_turning_the_ball_shifts_its_picture() {
    let project = evenly_lit("textured-sphere");
    let [as_it_was, turned, back] = [("0", "0.25"), ("90", "0.25"), ("90", "0.5")].map(|(turn, shift)| {
        let turn = format!("object.globe.turn_deg=[0,{turn},0]");
        let shift = format!("texture.planet.shift=[{shift},0]");
        picture(&project, &[SMALL[0], SMALL[1], &turn, &shift])
    });
    let differing = |a: &Image, b: &Image| {
        let pixels = a.pixels.iter().zip(&b.pixels);
        pixels.filter(|(a, b)| (a.r - b.r).abs() + (a.g - b.g).abs() > 0.01).count()
    };
    assert!(differing(&as_it_was, &turned) > 1000, "the ball has turned");
    // Rounding may move a sharp line of the picture by a hair.
    assert!(differing(&as_it_was, &back) < 20, "{} pixels", differing(&as_it_was, &back));
}

/// C7, C20, 4.2.4: barycentric coordinates mix the corners' points of the picture.
#[test]
fn c20_the_triangle_shows_its_picture_by_barycentric_coordinates() {
    let project = evenly_lit("textured-triangle");
    let image = picture(&project, &["settings.size=[480,480]", "settings.samples=1"]);
    let sail = project.scene.objects.iter().find(|o| matches!(o.shape, Shape::Triangle(_))).unwrap();
    let Shape::Triangle(triangle) = &sail.shape else { unreachable!() };
    let file = project.scene.textures[0].source.as_kind().file().unwrap();
    let texels = &project.assets.pictures[Path::new(file)];
    let (mut same, mut all) = (0, 0);
    for i in 1..20 {
        for j in 1..20 - i {
            let weights = [i, j, 20 - i - j].map(|w| w as f32 / 20.0);
            let point: Vec3 = (0..3).map(|k| triangle.points[k] * weights[k]).sum();
            let [u, v] = [0, 1].map(|c| (0..3).map(|k| triangle.uvs[k][c] * weights[k]).sum::<f32>());
            let [width, height] = texels.size;
            let texel = texels.texel((u * width as f32) as u32, ((1.0 - v) * height as f32) as u32);
            let seen = at(&project, &image, point);
            let off = (seen.r - texel.r).abs().max((seen.g - texel.g).abs()).max((seen.b - texel.b).abs());
            same += usize::from(off < 0.08);
            all += 1;
        }
    }
    // At the lead between two pieces a pixel and a texel may lie on either side.
    assert!(same * 10 > all * 8, "{same} of {all}");
}
