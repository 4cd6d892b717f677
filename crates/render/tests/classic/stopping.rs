//! A job ends by noise or by time, and says so.

use crate::agreement::lit_scene;
use crate::common::Shot;
use vitrine_film::{Film, Keep};
use vitrine_render::{Cancel, Ending, RenderJob, Rendered};

/// Soft shadows of few points: noise that more samples take away.
fn shot(samples: u32, noise: f32) -> Shot {
    let mut shot = lit_scene();
    let settings = &mut shot.scene.settings;
    (settings.size, settings.samples) = ([70, 50], samples);
    (settings.shadow_points, settings.shadow_error, settings.noise) = (1, 0.0, noise);
    shot
}

fn run(shot: &Shot, threads: usize) -> Rendered {
    let scene = shot.compiled();
    RenderJob::new(&scene, shot.options()).expect("the job can start").run(
        threads,
        &Cancel::default(),
        &mut |_| {},
    )
}

#[test]
fn c16_a_picture_that_is_clean_enough_is_the_same_on_any_number_of_threads() {
    let shot = shot(4000, 0.008);
    let one = run(&shot, 1);
    assert_eq!(one.ending, Ending::Noise);
    let samples = one.film.tile_samples();
    assert!((33..4000).contains(&samples[0]) && samples.iter().all(|s| *s == samples[0]), "{samples:?}");
    assert!(one.noise.is_some_and(|n| n <= 0.008), "{:?}", one.noise);
    for threads in [2, 3, 7] {
        let many = run(&shot, threads);
        assert!(many.film == one.film, "{threads} threads");
        assert_eq!((many.ending, many.noise, many.rays), (Ending::Noise, one.noise, one.rays));
    }
}

#[test]
fn less_noise_takes_more_samples_and_the_estimate_is_about_right() {
    let truth = run(&shot(4096, 0.0), 2).film.image();
    let mean = truth.pixels.iter().map(|p| p.luminance()).sum::<f32>() / truth.pixels.len() as f32;
    // What is darker than a twentieth of the picture's light counts as that bright, as in the estimate.
    let floor = 3.0 * (0.05 * mean) * (0.05 * mean);
    let mut last = 0;
    for noise in [0.012, 0.006, 0.003] {
        let rendered = run(&shot(4096, noise), 2);
        let samples = rendered.film.tile_samples()[0];
        assert!(samples > last, "{noise}: {samples}");
        last = samples;
        let image = rendered.film.image();
        let errors = image.pixels.iter().zip(&truth.pixels).map(|(a, b)| {
            let d = [a.r - b.r, a.g - b.g, a.b - b.b];
            let square = |v: [f32; 3]| v.iter().map(|v| v * v).sum::<f32>();
            square(d) / (square(b.to_array()) + floor)
        });
        let error = (errors.sum::<f32>() / image.pixels.len() as f32).sqrt();
        // The estimate is for independent samples; these are stratified, so the picture is better than it says.
        assert!(error < 1.3 * noise && error > 0.05 * noise, "{noise}: {error}");
    }
}

#[test]
fn c15_a_noise_limit_is_the_same_after_stops() {
    let shot = shot(4000, 0.008);
    let scene = shot.compiled();
    let job = RenderJob::new(&scene, shot.options()).unwrap();
    let mut looks = Vec::new();
    let whole = job
        .resume(job.nothing_yet(), 2, &Cancel::default(), &mut |glance| looks.push(glance.so_far()))
        .unwrap();
    assert_eq!(whole.film.keep(), Keep::Halves);
    for so_far in looks {
        let again = job.resume(so_far, 3, &Cancel::default(), &mut |_| {}).unwrap();
        assert!(again.film == whole.film && again.ending == Ending::Noise && again.noise == whole.noise);
    }
}

#[test]
fn the_time_limit_ends_a_picture_that_has_every_pixel() {
    let mut shot = shot(65_536, 0.0);
    shot.scene.settings.time_limit = 0.1;
    let rendered = run(&shot, 2);
    assert_eq!((rendered.ending, rendered.is_complete()), (Ending::Time, true));
    assert!(rendered.film.tile_samples().iter().all(|s| *s > 0));
    assert!(rendered.spent.as_secs_f32() >= 0.1);
    shot.scene.settings.time_limit = 1e-9;
    assert!(run(&shot, 2).film.tile_samples().iter().all(|s| *s >= 1), "one sample at least");
    shot.scene.settings.samples = 4;
    shot.scene.settings.time_limit = 1e30;
    assert_eq!(run(&shot, 1).ending, Ending::Samples);
}

#[test]
fn time_counts_on_after_a_stop() {
    let mut shot = shot(65_536, 0.0);
    shot.scene.settings.time_limit = 0.2;
    let scene = shot.compiled();
    let job = RenderJob::new(&scene, shot.options()).unwrap();
    let first = job.run(2, &Cancel::default(), &mut |_| {});
    let samples = first.film.samples();
    let again = job.resume(first, 2, &Cancel::default(), &mut |_| {}).unwrap();
    assert_eq!((again.ending, again.film.samples()), (Ending::Time, samples), "its time is over already");
}

#[test]
fn a_film_that_keeps_something_else_is_refused() {
    let shot = shot(64, 0.01);
    let scene = shot.compiled();
    let job = RenderJob::new(&scene, shot.options()).unwrap();
    let other = Rendered::of_film(Film::new(job.nothing_yet().film.region()));
    assert!(job.resume(other, 1, &Cancel::default(), &mut |_| {}).is_err());
}
