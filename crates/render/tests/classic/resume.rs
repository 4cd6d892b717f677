//! C15: a job that was stopped goes on, and what comes out is the same bytes as if it had never been.

use crate::agreement::lit_scene;
use crate::common::{Dice, Shot};
use vitrine_render::{Cancel, CompiledScene, RenderError, RenderJob, RenderOptions, Rendered};

fn shot(samples: u32) -> Shot {
    let mut shot = lit_scene();
    shot.scene.settings.size = [101, 77];
    shot.scene.settings.samples = samples;
    shot
}

fn job<'a>(scene: &'a CompiledScene, shot: &Shot) -> RenderJob<'a> {
    RenderJob::new(scene, shot.options()).expect("the job can start")
}

/// Stops at moments that chance chooses and goes on, to the end.
fn in_pieces(job: &RenderJob, dice: &mut Dice) -> (Rendered, u32) {
    let (mut so_far, mut stops) = (job.nothing_yet(), 0);
    loop {
        let threads = 1 + (dice.unit() * 4.0) as usize;
        let wait = std::time::Duration::from_micros((dice.unit() * 30_000.0) as u64);
        let cancel = Cancel::default();
        let stop = cancel.clone();
        let stopper = std::thread::spawn(move || {
            std::thread::sleep(wait);
            stop.cancel();
        });
        so_far = job.resume(so_far, threads, &cancel, &mut |_| {}).expect("its own film fits");
        stopper.join().expect("it only sleeps");
        if so_far.is_complete() {
            return (so_far, stops);
        }
        stops += 1;
    }
}

#[test]
fn c15_stopped_and_continued_gives_the_same_bytes() {
    let shot = shot(37);
    let scene = shot.compiled();
    let job = job(&scene, &shot);
    let whole = job.run(2, &Cancel::default(), &mut |_| {});
    let mut dice = Dice(7);
    let mut all_stops = 0;
    for _ in 0..5 {
        let (pieced, stops) = in_pieces(&job, &mut dice);
        assert!(pieced.film == whole.film, "after {stops} stops");
        assert_eq!(pieced.rays, whole.rays);
        all_stops += stops;
    }
    assert!(all_stops > 0, "it was never stopped");
}

#[test]
fn c15_a_job_goes_on_from_every_look_at_it() {
    let shot = shot(60);
    let scene = shot.compiled();
    let job = job(&scene, &shot);
    let mut looks = Vec::new();
    let whole = job
        .resume(job.nothing_yet(), 2, &Cancel::default(), &mut |glance| {
            assert!(glance.film().samples() <= glance.progress().samples_total);
            looks.push(glance.so_far());
        })
        .unwrap();
    assert!(looks.last().is_some_and(|last| last.film == whole.film), "the end is shown");
    for so_far in looks {
        let again = job.resume(so_far, 3, &Cancel::default(), &mut |_| {}).unwrap();
        assert!(again.is_complete() && again.film == whole.film);
        assert_eq!((again.rays, again.bad_samples), (whole.rays, 0));
    }
}

#[test]
fn a_film_of_few_samples_is_the_beginning_of_one_of_many() {
    let (few, many) = (shot(4), shot(16));
    let scene = few.compiled();
    let begun = job(&scene, &few).run(2, &Cancel::default(), &mut |_| {});
    let more = job(&scene, &many).resume(begun, 2, &Cancel::default(), &mut |_| {}).unwrap();
    assert!(more.film == job(&scene, &many).run(1, &Cancel::default(), &mut |_| {}).film);
}

#[test]
fn a_film_of_another_picture_is_refused() {
    let shot = shot(6);
    let scene = shot.compiled();
    let refused = |film: Rendered| {
        let error = job(&scene, &shot).resume(film, 1, &Cancel::default(), &mut |_| {});
        matches!(error, Err(RenderError::OtherFilm | RenderError::OtherBlocks { .. }))
    };
    let rendered = |size, samples| {
        let mut other = shot.clone();
        (other.scene.settings.size, other.scene.settings.samples) = (size, samples);
        let options = RenderOptions { region: None, ..other.options() };
        RenderJob::new(&scene, options).unwrap().run(2, &Cancel::default(), &mut |_| {})
    };
    assert!(refused(rendered([101, 76], 6)), "another size");
    assert!(refused(rendered([101, 77], 3)), "a block that is cut otherwise");
    assert!(refused(rendered([101, 77], 16)), "more samples than wanted");
    assert!(!refused(rendered([101, 77], 4)));
}
