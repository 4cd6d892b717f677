//! Balls within balls around one centre: bulbs, snow globes, marbles in marbles. Light that is found on purpose through all of their
//! surfaces has the same mean as light that is found by chance alone, and tiny lamps, which chance does not find, are as bright
//! as large ones.

use crate::chance::{both_agree, floor_at, put_at};
use crate::common::{
    Rgb, Shot, Vec3, ball, bulb, clear, cuboid, fresnel, measure, measure_by_chance, measuring, plane, solid,
    tinted, v, white,
};

const CENTER: Vec3 = Vec3::new(0.0, 0.9, 0.0);

/// Balls around the centre above a floor: radii and indices.
fn nest(shot: &mut Shot, balls: &[(f32, f32)]) {
    for &(radius, ior) in balls {
        put_at(shot, ball(radius), clear(ior), CENTER);
    }
}

/// That light on purpose is not noisier by far says that it is found at all.
#[track_caller]
fn both_agree_and_chance_is_noisier(shot: &Shot) {
    let [found, by_chance] = both_agree(shot);
    assert!(found.error[1] < 0.9 * by_chance.error[1], "{found:?} {by_chance:?}");
}

const HOLLOW: [(f32, f32); 2] = [(0.5, 1.5), (0.4, 1.0)];
const GLOBE: [(f32, f32); 2] = [(0.5, 1.5), (0.46, 1.333)];
const MARBLE: [(f32, f32); 3] = [(0.5, 1.4), (0.35, 1.7), (0.2, 1.2)];

#[test]
fn through_hollow_balls_snow_globes_and_balls_in_balls() {
    for balls in [&HOLLOW[..], &GLOBE, &MARBLE] {
        for x in [0.1, 0.45] {
            let mut shot = floor_at(x, 0.0);
            nest(&mut shot, balls);
            bulb(&mut shot, v(0.2, 2.4, 0.1), 0.5, 2.0);
            both_agree_and_chance_is_noisier(&shot);
        }
    }
}

#[test]
fn past_balls_and_off_them() {
    for balls in [&HOLLOW[..], &GLOBE, &MARBLE] {
        let mut shot = floor_at(1.1, 0.0);
        nest(&mut shot, balls);
        bulb(&mut shot, v(1.2, 1.9, 0.3), 0.5, 4.0);
        both_agree_and_chance_is_noisier(&shot);
    }
}

#[test]
fn from_lamps_within_any_shell() {
    for (balls, lamp, radius) in [
        (&HOLLOW[..], v(0.1, 0.95, 0.0), 0.2),
        (&[(0.8, 1.5), (0.3, 1.0)], v(0.1, 1.4, 0.2), 0.12),
        (&GLOBE, v(0.1, 0.8, 0.1), 0.25),
        (&MARBLE, CENTER, 0.15),
        (&[(0.5, 1.5)], v(0.2, 1.0, 0.1), 0.2),
    ] {
        for x in [0.1, 0.6] {
            let mut shot = floor_at(x, 0.0);
            nest(&mut shot, balls);
            bulb(&mut shot, lamp, radius, 4.0);
            both_agree_and_chance_is_noisier(&shot);
        }
    }
}

#[test]
fn onto_things_within_any_shell() {
    for balls in [&HOLLOW[..], &GLOBE, &MARBLE, &[(0.5, 1.5)]] {
        // Seen from inside, so that the picture is one point.
        let mut shot = measuring(v(0.05, 1.02, 0.06), v(0.0, 0.9, 0.0));
        put_at(&mut shot, cuboid(v(0.1, 0.02, 0.1)), white(0.7), v(0.0, 0.89, 0.0));
        nest(&mut shot, balls);
        bulb(&mut shot, v(0.5, 2.5, 1.1), 0.8, 2.0);
        both_agree_and_chance_is_noisier(&shot);
        // The lamp inside as well.
        shot.scene.lights.clear();
        bulb(&mut shot, v(0.12, 1.0, 0.03), 0.04, 4.0);
        both_agree(&shot);
    }
}

#[test]
fn in_water_and_of_tinted_glass() {
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, ball(0.5), tinted(1.5, Rgb::new(0.9, 0.6, 0.3), 0.3), CENTER);
    put_at(&mut shot, ball(0.4), tinted(1.333, Rgb::new(0.4, 0.6, 0.9), 0.5), CENTER);
    shot.put(plane(), solid(clear(1.333))).position.y = 3.0;
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.5, 2.0);
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn where_something_else_is_in_their_place() {
    // Half of the nest lies in water.
    let mut shot = floor_at(0.1, 0.0);
    nest(&mut shot, &HOLLOW);
    shot.put(plane(), solid(clear(1.333))).position.y = 0.9;
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.6, 2.0);
    both_agree(&shot);
    // Ice reaches through its surfaces.
    let mut shot = floor_at(0.1, 0.0);
    nest(&mut shot, &GLOBE);
    put_at(&mut shot, cuboid(v(0.4, 0.3, 0.3)), clear(1.31), v(0.3, 1.0, 0.0));
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.6, 2.0);
    both_agree(&shot);
    // Beside the middle, so that the inner ball is no part of the nest.
    let mut shot = floor_at(0.1, 0.0);
    nest(&mut shot, &HOLLOW);
    shot.scene.objects[2].position.x += 0.05;
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.6, 2.0);
    both_agree(&shot);
}

#[test]
fn a_point_of_light_in_a_bulb_shines_as_brightly_as_in_air() {
    // From the centre light goes straight on through both surfaces: E = I·(1−F)²/d²; reflected light comes back to the centre
    // and leaves again, with the sum of a pane, (1−F)/(1+F), of which one reflection is solved and the rest not found.
    let mut shot = floor_at(0.0, 0.0);
    shot.scene.settings.bounces = 2;
    nest(&mut shot, &HOLLOW);
    shot.point(CENTER, 1.0).full_at = Some(0.9);
    let f = fresnel(1.0, 1.5)[0];
    let seen = measure(&shot, 64);
    let least = (1.0 - f).powi(2) * 0.5;
    assert!((least..0.5 * (1.0 + f)).contains(&seen.mean[1]), "{seen:?} {least}");
    assert_eq!(measure_by_chance(&shot, 64).mean[1], 0.0);
}

#[test]
fn behind_panes_and_in_display_cases() {
    for (x, balls) in [(0.1, &[(0.4, 1.5)][..]), (0.5, &[(0.4, 1.5)]), (0.1, &HOLLOW)] {
        let mut shot = floor_at(x, 0.0);
        put_at(&mut shot, cuboid(v(6.0, 0.1, 6.0)), clear(1.5), v(0.0, 1.6, 0.0));
        nest(&mut shot, balls);
        bulb(&mut shot, v(0.2, 2.4, 0.1), 0.5, 2.0);
        both_agree_and_chance_is_noisier(&shot);
        // The pane below them.
        shot.scene.objects[1].position.y = 0.3;
        shot.scene.camera.position = v(x + 0.3, 0.1, 0.2);
        both_agree(&shot);
    }
}

#[test]
fn under_the_surface_of_water() {
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, ball(0.4), clear(1.0), CENTER);
    shot.put(plane(), solid(clear(1.333))).position.y = 1.6;
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.6, 2.0);
    both_agree_and_chance_is_noisier(&shot);
    // Things in a snow globe behind a pane.
    let mut shot = measuring(v(0.05, 1.02, 0.06), v(0.0, 0.9, 0.0));
    put_at(&mut shot, cuboid(v(0.1, 0.02, 0.1)), white(0.7), v(0.0, 0.89, 0.0));
    nest(&mut shot, &GLOBE);
    put_at(&mut shot, cuboid(v(6.0, 0.1, 6.0)), clear(1.5), v(0.0, 1.6, 0.0));
    bulb(&mut shot, v(0.5, 2.5, 1.1), 0.8, 2.0);
    both_agree_and_chance_is_noisier(&shot);
}
