//! Stored pictures of the photoreal renderer, and whether it still has the same mean light everywhere. Pictures of another seed are
//! never the same, so they are compared by a statistic ([`compare`]) whose chance to fail a sound renderer is stated.
//!
//! What is stored was made by
//!
//! ```text
//! cargo test -p vitrine-render --test photoreal -- --ignored make_the_stored_pictures
//! ```
//!
//! and is made anew, after a look at why, when the renderer's light changes on purpose or a scene in [`scenes`] does.

mod compare;
mod pfm;
mod scenes;

use crate::common::{Rgb, Shot, run};
use compare::{Golden, Verdict, compare, limit};
use rayon::prelude::*;
use scenes::{SCENES, SIZE};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::OnceLock;

/// Samples a pixel in each picture. A picture is one draw of the statistic, so that what the samples of a pixel have to do with each
/// other does not matter.
const SAMPLES: u32 = 16;
/// So many pictures are what is stored, of the seeds from 0 on.
const STORED_RUNS: u32 = 512;
/// So many pictures are held against it.
const RUNS: u32 = 32;
/// The first of their seeds.
const OTHER_SEED: u32 = 1_000_000;

/// The pixels of pictures with those seeds.
fn pictures(shot: &Shot, seeds: Range<u32>) -> Vec<Vec<Rgb>> {
    let scene = shot.compiled();
    let picture = |seed| {
        let mut options = shot.options();
        (options.settings.seed, options.settings.samples) = (seed, SAMPLES);
        let rendered = run(&scene, options, 1);
        assert_eq!(rendered.bad_samples, 0, "all light is a number");
        rendered.film.image().pixels
    };
    seeds.into_par_iter().map(picture).collect()
}

fn seen(shot: &Shot) -> Golden {
    Golden::of(&pictures(shot, OTHER_SEED..OTHER_SEED + RUNS))
}

fn file_of(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests/photoreal/goldens", &format!("{name}.pfm")].iter().collect()
}

fn stored(name: &str) -> Golden {
    let path = file_of(name);
    let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    // The mean above, the variance below it.
    let (size, mut pixels) = pfm::read(&bytes).expect("a picture");
    assert_eq!(size, [SIZE[0], 2 * SIZE[1]]);
    let variance = pixels.split_off(pixels.len() / 2);
    Golden { mean: pixels, variance, runs: STORED_RUNS }
}

/// What the renderer makes of all scenes now, in their order, and what is stored.
fn now_and_before() -> impl Iterator<Item = (&'static str, &'static Golden, Golden)> {
    static SEEN: OnceLock<Vec<Golden>> = OnceLock::new();
    let now = SEEN.get_or_init(|| SCENES.iter().map(|(_, make)| seen(&make())).collect());
    SCENES.iter().zip(now).map(|((name, _), now)| (*name, now, stored(name)))
}

#[test]
fn the_light_is_that_of_the_stored_pictures() {
    for (name, now, before) in now_and_before() {
        let Verdict { worst, place } = compare(now, &before);
        assert!(worst.abs() <= limit(), "{name}: {worst:.1} σ in {place}");
    }
}

#[test]
fn any_two_different_pictures_fail_each_other() {
    let stored: Vec<_> = SCENES.iter().map(|(name, _)| (name, stored(name))).collect();
    for (one, a) in &stored {
        for (other, b) in &stored {
            let worst = compare(&a.as_seen_by(RUNS), b).worst.abs();
            if one == other {
                assert!(worst == 0.0);
            } else {
                assert!(worst > 3.0 * limit(), "{one} and {other} differ by {worst:.1} σ alone");
            }
        }
    }
}

#[test]
fn a_picture_that_is_a_hundredth_too_bright_or_dark_fails_where_it_can_be_told() {
    let mut told = Vec::new();
    for (name, now, before) in now_and_before() {
        // By so many standard errors a hundredth moves the cell that tells it best. Chance takes away or adds one or two.
        let told_by = 0.01 / before.least_error(RUNS);
        if told_by > limit() + 3.0 {
            for scale in [0.99, 1.01] {
                let worst = compare(&now.scaled(scale), &before).worst.abs();
                assert!(worst > limit(), "{name}: {scale} is off by {worst:.1} σ alone");
            }
            told.push(name);
        }
    }
    assert!(told.len() >= 5, "{told:?}");
}

#[test]
fn slightly_wrong_physics_fails() {
    let fails = |name: &str, spoil: &dyn Fn(&mut Shot)| {
        let mut shot = scenes::find(name);
        spoil(&mut shot);
        let worst = compare(&seen(&shot), &stored(name)).worst.abs();
        assert!(worst > limit(), "{name} is off by {worst:.1} σ alone");
    };
    // Glass that bends a little more, a tint that is a third too strong, too few reflections, milk that throws light back.
    fails("ball", &|shot| shot.scene.materials[1].specular_ior = Some(1.55));
    fails("pane", &|shot| shot.scene.materials[2].transmission_depth = Some(0.03));
    fails("cornell", &|shot| shot.scene.settings.bounces = 4);
    fails("milk", &|shot| shot.scene.materials[1].transmission_scatter_anisotropy = Some(-0.2));
}

/// Makes what is stored, and proves the statistic on it: sound pictures pass.
#[test]
#[ignore = "it replaces the stored pictures"]
fn make_the_stored_pictures() {
    SCENES.par_iter().for_each(|(name, make)| {
        let pictures = pictures(&make(), 0..STORED_RUNS);
        let golden = Golden::of(&pictures);
        let group = |k: usize| {
            let (from, to) = (k * RUNS as usize, (k + 1) * RUNS as usize);
            let others = [&pictures[..from], &pictures[to..]].concat();
            compare(&Golden::of(&pictures[from..to]), &Golden::of(&others)).worst.abs()
        };
        let largest = (0..(STORED_RUNS / RUNS) as usize).map(group).fold(0.0_f64, f64::max);
        assert!(largest <= limit(), "{name}: sound pictures differ by {largest:.1} σ");
        let pixels: Vec<_> = golden.mean.iter().chain(&golden.variance).copied().collect();
        let bytes = pfm::write([SIZE[0], 2 * SIZE[1]], &pixels);
        std::fs::write(file_of(name), bytes).expect("the folder can be written");
    });
}
