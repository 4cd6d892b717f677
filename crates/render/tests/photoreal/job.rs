//! The same bytes however often a job was stopped and on any number of threads; and what a lens does to a point.

use crate::common::{
    Shot, Vec3, ball, bulb, clear, cuboid, disc, glowing, measuring, plane, run, tinted, v, white,
};
use vitrine_math::Rgb;
use vitrine_render::{Cancel, RenderJob};
use vitrine_scene::{Material, Renderer};

/// Several tiles of all that is hard: glass in glass, milk, rainbows, frost, a lamp, the sky.
fn still_life() -> Shot {
    let mut shot = Shot::new([70, 45], v(0.5, 1.4, 3.0), v(0.0, 0.4, 0.0));
    let settings = &mut shot.scene.settings;
    (settings.renderer, settings.samples) = (Renderer::Photoreal, 5);
    shot.scene.camera.f_stop = Some(2.0);
    shot.ambient(0.2);
    bulb(&mut shot, v(0.5, 2.5, 0.4), 0.2, 20.0);
    shot.put(plane(), white(0.6));
    let flint = Material { transmission_dispersion_abbe_number: Some(20.0), ..clear(1.6) };
    shot.put(ball(0.4), flint).position = v(-0.6, 0.5, 0.0);
    shot.put(cuboid(v(0.7, 0.7, 0.7)), clear(1.5)).position = v(0.4, 0.4, 0.0);
    shot.put(ball(0.2), clear(1.333)).position = v(0.4, 0.4, 0.0);
    let frosted = Material { specular_roughness: Some(0.3), ..clear(1.5) };
    shot.put(cuboid(v(2.0, 1.0, 0.02)), frosted).position = v(0.0, 0.6, -0.8);
    let milk =
        Material { transmission_scatter: Some(Rgb::splat(0.5)), ..tinted(1.3, Rgb::new(0.8, 0.6, 0.4), 0.2) };
    shot.put(ball(0.25), milk).position = v(0.0, 0.26, 0.9);
    shot
}

#[test]
fn the_picture_is_the_same_bytes_on_any_number_of_threads() {
    let shot = still_life();
    let one = shot.rendered(1, None);
    assert_eq!(one.bad_samples, 0);
    for threads in [2, 3] {
        let many = shot.rendered(threads, None);
        assert!(many.film == one.film && many.rays == one.rays, "{threads} threads");
    }
}

#[test]
fn a_picture_that_was_stopped_goes_on_as_if_it_had_not_been() {
    let shot = still_life();
    let scene = shot.compiled();
    let whole = run(&scene, shot.options(), 2);
    let job = RenderJob::new(&scene, shot.options()).expect("the job can start");
    let mut looks = Vec::new();
    let watched =
        job.resume(job.nothing_yet(), 2, &Cancel::default(), &mut |glance| looks.push(glance.so_far()));
    assert!(watched.expect("it can begin").film == whole.film);
    for so_far in looks {
        let again = job.resume(so_far, 3, &Cancel::default(), &mut |_| {}).expect("it can go on");
        assert!(again.film == whole.film);
    }
}

#[test]
fn what_is_out_of_focus_becomes_a_disc() {
    // The lens has the radius ρ = f/2N, with the focal length f at which a sensor of 24 mm spans the view angle. A point at distance D
    // is a disc of radius ρ·|D−F|/D on the plane at F that is sharp; the mean square of the distance from its middle is
    // half the square of that.
    let (focus, distance, view_deg, size) = (2.0_f32, 3.0_f32, 10.0_f32, 48_u32);
    let mut shot = Shot::new([size, size], Vec3::ZERO, v(0.0, 0.0, -focus));
    shot.scene.settings.renderer = Renderer::Photoreal;
    shot.scene.settings.samples = 256;
    let camera = &mut shot.scene.camera;
    (camera.view_angle_deg, camera.f_stop) = (view_deg, Some(1.0));
    let point = shot.put(disc(0.004), glowing(1.0));
    (point.position, point.turn_deg) = (v(0.0, 0.0, -distance), v(90.0, 0.0, 0.0));
    let tan_half = (view_deg * 0.5).to_radians().tan();
    let blur = 0.012 / tan_half * 0.5 * (distance - focus) / distance;
    let pixel = 2.0 * focus * tan_half / size as f32;
    let truth = 0.5 * (blur / pixel).powi(2);
    // What the point's own size and the pixels' filter spread is there in a sharp picture, too.
    let blurred = spread(&shot);
    shot.scene.camera.f_stop = None;
    let seen = blurred - spread(&shot);
    assert!(blur > 3.0 * pixel && (seen / truth - 1.0).abs() < 0.03, "{seen}, {truth}");
}

/// The mean square of the distance of light from the picture's middle, square pixels.
fn spread(shot: &Shot) -> f32 {
    let image = shot.picture();
    let [width, height] = image.size;
    let (mut sum, mut squares) = (0.0, 0.0);
    for y in 0..height {
        for x in 0..width {
            let [dx, dy] = [(x, width), (y, height)].map(|(k, n)| k as f32 + 0.5 - n as f32 * 0.5);
            let light = image.pixel(x, y).g;
            sum += light;
            squares += light * (dx * dx + dy * dy);
        }
    }
    squares / sum
}

#[test]
fn without_a_lens_a_point_stays_one() {
    let mut shot = measuring(Vec3::ZERO, v(0.0, 0.0, -2.0));
    let point = shot.put(disc(0.004), glowing(1.0));
    (point.position, point.turn_deg) = (v(0.0, 0.0, -3.0), v(90.0, 0.0, 0.0));
    crate::common::measure(&shot, 16).assert_is_grey(1.0, 1e-6);
}
