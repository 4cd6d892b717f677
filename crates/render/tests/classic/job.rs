//! C15 and C16: a job can be stopped and keeps what it has, tells how far it is, and gives the same bytes for any number of
//! threads, for a part of the picture as for the whole, and on every instruction set.

use crate::agreement::lit_scene;
use crate::common::{
    Dice, GREEN, RED, Shot, ball, cuboid, flat, glass, matte, mirror, plane, run, triangle, v,
};
use crate::models;
use std::time::{Duration, Instant};
use vitrine_film::{Image, Region};
use vitrine_math::{Rgb, Vec3};
use vitrine_render::accel::simd::Instructions;
use vitrine_render::{Cancel, Progress, RenderError, RenderJob, RenderOptions};
use vitrine_scene::{Material, Settings};

/// A bit of everything, with soft shadows.
fn rich() -> Shot {
    let mut shot = lit_scene();
    shot.scene.settings.size = [101, 77];
    shot.put(ball(0.9), Material { transparency: Some(0.7), refraction: Some(1.4), ..mirror(RED, 0.2) })
        .position = v(1.0, 0.5, 1.5);
    shot.put(ball(1.5), glass(GREEN, 0.8)).position = v(-1.0, 0.0, 1.0);
    let mut model = models::faceted_ball(1.0, 6);
    model.normals = model.positions.clone();
    let shape = shot.model(model);
    let object = shot.put(shape, Material { reflectivity: Some(0.3), ..matte(Rgb::WHITE) });
    (object.position, object.scale) = (v(0.5, 1.5, 0.0), v(0.8, 0.5, 0.8));
    shot.disc(v(1.0, 6.0, 2.0), 1.0, 0.6);
    shot.scene.settings.shadow_points = 24;
    shot
}

/// Surfaces in one place, and triangles that share edges which many rays meet: where a hit could depend on the way to it.
fn ties() -> Shot {
    let mut shot = Shot::new([90, 70], v(0.0, 4.0, 6.0), Vec3::ZERO);
    let mut dice = Dice(3);
    shot.put(plane(), flat(dice.color()));
    for k in 0..12 {
        let x = (k % 4) as f32 - 1.5;
        // Neighbours share faces; all stand on the ground, half of them twice.
        let material =
            Material { transparency: Some(if k % 3 == 0 { 0.5 } else { 0.0 }), ..flat(dice.color()) };
        shot.put(cuboid(Vec3::ONE), material).position = v(x, 0.5, (k / 4) as f32 - 1.0);
    }
    let corners = [v(-4.0, 0.7, -2.0), v(4.0, 0.7, -2.0), v(4.0, 0.7, 2.0), v(-4.0, 0.7, 2.0)];
    for [a, b, c] in [[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]] {
        shot.put(triangle([corners[a], corners[b], corners[c]]), glass(dice.color(), 0.4));
    }
    for k in 0..3 {
        let square = shot.model(models::square());
        let floor = shot.put(square, glass(dice.color(), 0.6));
        (floor.scale, floor.turn_deg) = (v(3.0, 1.0, 3.0), v(0.0, 45.0 * k as f32, 0.0));
    }
    shot.ambient(0.6);
    shot.point(v(1.0, 5.0, 2.0), 0.7);
    shot
}

fn bytes(image: &Image) -> Vec<u32> {
    image.pixels.iter().flat_map(|p| p.to_array().map(f32::to_bits)).collect()
}

#[test]
fn c16_any_number_of_threads_gives_the_same_bytes() {
    for samples in [1, 20] {
        for region in [None, Some(Region { x: 13, y: 9, width: 70, height: 41 })] {
            let mut shot = rich();
            shot.scene.settings.samples = samples;
            let one = shot.rendered(1, region);
            for threads in [2, 3, 8, 0] {
                let many = shot.rendered(threads, region);
                assert!(bytes(&many.film.image()) == bytes(&one.film.image()), "{threads} threads");
                assert_eq!(many.rays, one.rays);
                assert!(many.is_complete());
            }
        }
    }
}

#[test]
fn c16_a_region_is_the_crop_of_the_whole_picture() {
    for (shot, samples) in [(rich(), 1), (rich(), 5), (ties(), 1), (ties(), 3)] {
        let mut shot = shot;
        shot.scene.settings.samples = samples;
        let scene = shot.compiled();
        let whole = run(&scene, RenderOptions { region: None, ..shot.options() }, 2).film.image();
        for [x, y, width, height] in
            [[0, 0, 90, 70], [1, 0, 32, 32], [7, 13, 33, 5], [89, 69, 1, 1], [17, 3, 50, 60]]
        {
            let region = Region { x, y, width, height };
            let part = run(&scene, RenderOptions { region: Some(region), ..shot.options() }, 2).film;
            assert_eq!(part.region(), region);
            let part = part.image();
            assert_eq!(part.size, [width, height]);
            for (dx, dy) in (0..height).flat_map(|dy| (0..width).map(move |dx| (dx, dy))) {
                let (a, b) = (part.pixel(dx, dy), whole.pixel(x + dx, y + dy));
                assert_eq!(
                    a.to_array().map(f32::to_bits),
                    b.to_array().map(f32::to_bits),
                    "{region:?} {dx} {dy}"
                );
            }
        }
    }
}

#[test]
fn c16_every_instruction_set_gives_the_same_bytes() {
    for shot in [rich(), ties()] {
        let pictures: Vec<_> = Instructions::available()
            .into_iter()
            .map(|set| bytes(&run(&shot.compiled().with_instructions(set), shot.options(), 2).film.image()))
            .collect();
        assert!(pictures.iter().all(|p| *p == pictures[0]));
    }
}

#[test]
fn c15_progress_never_falls_and_ends_at_the_total() {
    let mut shot = rich();
    shot.scene.settings.samples = 30;
    let scene = shot.compiled();
    let job = RenderJob::new(&scene, shot.options()).unwrap();
    let mut told: Vec<Progress> = Vec::new();
    let start = Instant::now();
    let rendered = job.run(2, &Cancel::default(), &mut |p| told.push(p));
    assert!(rendered.is_complete());
    assert_eq!(rendered.film.samples(), 101 * 77 * 30);
    assert!(told.windows(2).all(|w| w[0].samples_done <= w[1].samples_done));
    assert!(told.iter().all(|p| p.samples_total == 101 * 77 * 30));
    assert_eq!(told.last().map(|p| p.samples_done), Some(101 * 77 * 30));
    assert!(told.len() as u128 <= start.elapsed().as_millis() / 100 + 1, "ten times a second at most");
}

#[test]
fn c15_stopping_keeps_the_finished_tiles() {
    let mut shot = rich();
    shot.scene.settings.size = [640, 640];
    shot.scene.settings.samples = 100;
    let scene = shot.compiled();
    let job = RenderJob::new(&scene, shot.options()).unwrap();
    let cancel = Cancel::default();
    let stop = cancel.clone();
    let mut stopped_at = None;
    let rendered = job.run(2, &cancel, &mut |p| {
        if p.samples_done >= 1 {
            stopped_at.get_or_insert_with(Instant::now);
            stop.cancel();
        }
    });
    assert!(cancel.is_cancelled() && !rendered.is_complete());
    assert!(stopped_at.expect("it was told").elapsed() < Duration::from_secs(5), "soon");
    let (done, total) = (rendered.film.samples(), 640 * 640 * 100);
    assert!(done > 0 && done < total, "{done} of {total}");
    assert!(done % (32 * 32) == 0, "whole tiles");
    // What is there is what a complete picture has after as many samples: black, or the picture of a first block.
    let picture = rendered.film.image();
    let mut first = shot.clone();
    first.scene.settings.samples = 1;
    let first = first.picture();
    let (mut black, mut begun) = (0, 0);
    for tile in 0..400 {
        let (left, top) = (tile % 20 * 32, tile / 20 * 32);
        let pixels = || (0..1024).map(|i| (left + i % 32, top + i / 32));
        let is_black = pixels().all(|(x, y)| picture.pixel(x, y) == Rgb::BLACK);
        let is_first = pixels().all(|(x, y)| picture.pixel(x, y) == first.pixel(x, y));
        black += usize::from(is_black);
        begun += usize::from(!is_black);
        let near =
            pixels().map(|(x, y)| (picture.pixel(x, y).g - first.pixel(x, y).g).abs()).sum::<f32>() / 1024.0;
        assert!(is_black || is_first || near < 0.1, "tile {tile} is neither empty nor finished");
    }
    assert!(begun > 0 && black + begun == 400);
}

#[test]
fn c15_a_job_that_is_stopped_before_it_begins_is_black() {
    let shot = rich();
    let scene = shot.compiled();
    let cancel = Cancel::default();
    cancel.cancel();
    let mut told = 0;
    let rendered = RenderJob::new(&scene, shot.options()).unwrap().run(3, &cancel, &mut |_| told += 1);
    assert!(!rendered.is_complete() && rendered.film.samples() == 0 && rendered.rays == 0);
    assert!(rendered.film.image().pixels.iter().all(|p| *p == Rgb::BLACK));
    assert_eq!(told, 1, "the end is told");
}

#[test]
fn c16_more_threads_than_pieces_are_no_trouble() {
    let mut shot = rich();
    shot.scene.settings.size = [3, 2];
    assert!(shot.rendered(64, None).is_complete());
}

#[test]
fn pictures_that_are_too_large_and_parts_outside_are_refused() {
    let shot = rich();
    let scene = shot.compiled();
    let start =
        |settings: Settings, region| RenderJob::new(&scene, RenderOptions { settings, region }).map(|_| ());
    let with_size = |size| Settings { size, ..shot.scene.settings.clone() };
    assert!(matches!(
        start(with_size([32_768, 32_768]), None),
        Err(RenderError::TooLarge { width: 32_768, .. })
    ));
    assert!(matches!(start(with_size([u32::MAX, u32::MAX]), None), Err(RenderError::TooLarge { .. })));
    assert_eq!(start(with_size([16_384, 8192]), None), Ok(()), "the largest");
    for [x, y, width, height] in
        [[0, 0, 102, 1], [101, 0, 1, 1], [0, 0, 0, 1], [50, 50, 10, 28], [u32::MAX, 0, 2, 1]]
    {
        let region = Region { x, y, width, height };
        let error = start(with_size([101, 77]), Some(region)).unwrap_err();
        assert!(error.to_string().contains("101×77"), "{error}");
    }
    assert!(start(with_size([0, 5]), None).is_err(), "an empty picture is no picture");
}
