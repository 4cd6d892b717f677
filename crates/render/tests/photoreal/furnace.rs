//! White furnaces: where as much light comes from everywhere, what absorbs nothing cannot be seen.

use crate::common::{
    Material, Rgb, Shape, Shot, Vec3, ball, clear, cuboid, disc, glowing, measure, measuring, plane, solid,
    tinted, v, white,
};
use vitrine_scene::Renderer;

/// Alike on all sides, seen through a picture of a few pixels that the thing in the middle about fills.
fn furnace() -> Shot {
    let mut shot = Shot::new([4, 4], v(1.1, 0.8, 2.7), Vec3::ZERO);
    shot.scene.settings.renderer = Renderer::Photoreal;
    shot.scene.settings.background = Rgb::WHITE;
    shot.scene.settings.bounces = 1024;
    shot.ambient(1.0);
    shot
}

/// All pixels, and their mean.
fn seen(shot: &mut Shot, samples: u32) -> (Vec<Rgb>, f32) {
    shot.scene.settings.samples = samples;
    let pixels = shot.picture().pixels;
    let mean = pixels.iter().map(|p| p.luminance()).sum::<f32>() / pixels.len() as f32;
    (pixels, mean)
}

#[track_caller]
fn assert_unseen(things: &[(Shape, Material, Vec3)], samples: u32, allowed: f32) {
    let mut shot = furnace();
    for (shape, material, position) in things {
        let object = shot.put(shape.clone(), material.clone());
        (object.position, object.turn_deg) = (*position, v(20.0, 30.0, 10.0));
    }
    let (pixels, mean) = seen(&mut shot, samples);
    for pixel in &pixels {
        for channel in pixel.to_array() {
            assert!((channel - 1.0).abs() <= allowed, "{pixel:?}, {mean} on average");
        }
    }
}

#[test]
fn clear_glass_is_not_seen_at_all() {
    for ior in [1.05, 1.333, 1.5, 2.4] {
        assert_unseen(&[(ball(1.0), clear(ior), Vec3::ZERO)], 64, 2e-4);
        assert_unseen(&[(cuboid(v(1.2, 0.9, 1.1)), clear(ior), Vec3::ZERO)], 64, 2e-4);
        assert_unseen(&[(cuboid(v(2.0, 1.5, 0.01)), clear(ior), Vec3::ZERO)], 64, 2e-4);
    }
}

#[test]
fn glass_in_glass_is_not_seen_either() {
    let drop = (ball(0.5), clear(1.333), v(0.2, 0.1, 0.0));
    let block = (cuboid(v(1.2, 0.9, 1.1)), clear(1.6), Vec3::ZERO);
    assert_unseen(&[drop.clone(), block.clone()], 64, 3e-4);
    let side = (ball(0.5), clear(1.333), v(0.6, 0.1, 0.3));
    assert_unseen(&[block.clone(), side], 64, 3e-4);
    let bubble = (ball(0.4), clear(1.0), Vec3::ZERO);
    assert_unseen(&[block, bubble], 64, 3e-4);
}

#[test]
fn thin_sheets_and_thin_bubbles_are_not_seen() {
    assert_unseen(&[(disc(1.5), clear(1.5), Vec3::ZERO)], 64, 1e-3);
    let thin = Material { geometry_thin_walled: Some(true), ..clear(1.5) };
    assert_unseen(&[(ball(1.0), thin, Vec3::ZERO)], 64, 1e-3);
}

#[test]
fn glass_that_splits_light_is_white_on_average() {
    let flint = Material { transmission_dispersion_abbe_number: Some(15.0), ..clear(1.6) };
    let mut shot = measuring(v(1.1, 0.8, 2.7), v(0.1, 0.5, 0.3));
    shot.scene.settings.background = Rgb::WHITE;
    shot.put(ball(1.0), flint);
    measure(&shot, 512).assert_is_grey(1.0, 0.01);
}

#[test]
fn white_things_are_not_seen() {
    assert_unseen(&[(ball(1.0), white(1.0), Vec3::ZERO)], 1024, 5e-3);
    // Light goes to and fro between them.
    assert_unseen(
        &[(ball(0.6), white(1.0), v(0.5, 0.0, 0.0)), (ball(0.6), white(1.0), v(-0.5, 0.0, 0.0))],
        1024,
        0.02,
    );
}

#[test]
fn mirrors_are_not_seen() {
    for roughness in [0.0, 0.3, 0.7] {
        let mirror = Material {
            base_metalness: Some(1.0),
            specular_weight: Some(1.0),
            specular_roughness: Some(roughness),
            ..white(1.0)
        };
        assert_unseen(&[(ball(1.0), mirror, Vec3::ZERO)], 1024, 0.02);
    }
}

#[test]
fn frosted_glass_is_not_seen() {
    for roughness in [0.1, 0.3, 0.6] {
        let frosted = Material { specular_roughness: Some(roughness), ..clear(1.5) };
        assert_unseen(&[(ball(1.0), frosted.clone(), Vec3::ZERO)], 256, 0.15);
        let mut shot = measuring(v(1.1, 0.8, 2.7), v(0.1, 0.5, 0.3));
        shot.scene.settings.bounces = 1024;
        shot.ambient(1.0);
        shot.put(ball(1.0), frosted);
        let seen = measure(&shot, 256);
        assert!((seen.mean[1] - 1.0).abs() < 0.01, "{roughness}: {seen:?}");
    }
}

#[test]
fn lacquered_things_take_little() {
    // White under a dielectric that light leaves and enters: no model of layers is without loss, this one is to a few percent.
    let lacquered = Material { specular_weight: Some(1.0), specular_roughness: Some(0.2), ..white(1.0) };
    assert_unseen(&[(ball(1.0), lacquered, Vec3::ZERO)], 1024, 0.05);
}

#[test]
fn milk_that_absorbs_nothing_is_not_seen() {
    for anisotropy in [0.0, 0.7] {
        let milk = Material {
            transmission_scatter: Some(Rgb::splat(0.9)),
            transmission_scatter_anisotropy: Some(anisotropy),
            ..tinted(1.33, Rgb::WHITE, 0.5)
        };
        let mut shot = measuring(v(1.1, 0.8, 2.7), v(0.1, 0.5, 0.3));
        shot.scene.settings.bounces = 1024;
        shot.scene.settings.background = Rgb::WHITE;
        shot.ambient(1.0);
        shot.put(ball(1.0), milk);
        measure(&shot, 512).assert_is_grey(1.0, 0.01);
    }
}

#[test]
fn tinted_glass_is_darker_in_its_colour() {
    let mut shot = furnace();
    shot.put(ball(1.0), tinted(1.5, Rgb::new(0.9, 0.5, 0.2), 1.0));
    let (pixels, _) = seen(&mut shot, 256);
    let middle = pixels[5];
    assert!(middle.r < 0.97 && middle.g < middle.r - 0.1 && middle.b < middle.g - 0.1, "{middle:?}");
    assert!(pixels.iter().all(|p| p.r <= 1.0 + 1e-3 && p.b > 0.0), "{pixels:?}");
}

#[test]
fn a_white_floor_under_all_kinds_of_glass_stays_white() {
    let mut shot = measuring(v(0.9, 0.3, 0.4), v(0.1, 0.0, 0.0));
    shot.ambient(1.0);
    shot.scene.settings.background = Rgb::WHITE;
    shot.scene.settings.bounces = 1024;
    shot.put(plane(), white(1.0));
    shot.put(cuboid(v(3.0, 0.2, 3.0)), clear(1.5)).position.y = 1.6;
    shot.put(ball(0.4), clear(1.5)).position.y = 0.7;
    shot.put(cuboid(v(0.5, 0.5, 0.5)), clear(1.3)).position = v(-0.9, 0.4, 0.1);
    measure(&shot, 512).assert_is_grey(1.0, 2e-3);
}

#[test]
fn in_water_white_things_are_brighter_by_the_square_of_the_index() {
    // L = n²·L₀, whatever is reflected to and fro on the way.
    let n = 1.333_f64;
    let mut shot = measuring(v(0.5, 0.3, 0.4), Vec3::ZERO);
    shot.ambient(1.0);
    shot.scene.settings.bounces = 1024;
    shot.put(plane(), white(1.0));
    shot.put(plane(), solid(clear(n as f32))).position.y = 1.0;
    measure(&shot, 1024).assert_is_grey(n * n, 3e-3);
}

#[test]
fn under_water_a_dark_floor_shows_what_the_surface_lets_in() {
    // E = 0.93359·π·L, and of what the floor sends back the surface reflects 1 − 0.93359/n² (n = 1.333).
    let (n, enters, albedo) = (1.333_f64, 0.933_59, 0.2);
    let reflected = 1.0 - enters / (n * n);
    let mut shot = measuring(v(0.5, 0.3, 0.4), Vec3::ZERO);
    shot.ambient(1.0);
    shot.put(plane(), white(albedo as f32));
    shot.put(plane(), solid(clear(n as f32))).position.y = 1.0;
    measure(&shot, 1024).assert_is_grey(albedo * enters / (1.0 - albedo * reflected), 2e-3);
}

#[test]
fn in_a_closed_room_whose_walls_glow_light_adds_up() {
    // L = L_e + ρ·L  ⇒  L = L_e/(1 − ρ)
    for albedo in [0.3, 0.7] {
        let mut shot = measuring(v(0.3, 0.2, 0.4), v(0.5, -1.0, 0.2));
        shot.scene.settings.bounces = 1024;
        for (k, axis) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
            for side in [-1.0, 1.0] {
                let mut size = [2.2; 3];
                size[k] = 0.2;
                let wall = Material { emission_luminance: Some(0.5), ..white(albedo) };
                shot.put(cuboid(Vec3::from_array(size)), wall).position = axis * (side * 1.1);
            }
        }
        measure(&shot, 512).assert_is_grey(0.5 / (1.0 - f64::from(albedo)), 5e-3);
    }
}

#[test]
fn what_glows_shows_its_radiance() {
    let mut shot = measuring(v(1.0, 1.5, 3.0), Vec3::ZERO);
    shot.put(ball(1.0), glowing(0.75));
    measure(&shot, 4).assert_is_grey(0.75, 1e-6);
}
