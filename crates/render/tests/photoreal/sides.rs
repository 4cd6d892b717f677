//! Light that the side faces of panes and blocks reflect from inside, totally for the most part: at the edge of a shelf, in a
//! block, in display cases.

use crate::chance::{both_agree, floor_at, put_at};
use crate::common::{
    Rgb, Shot, Vec3, bulb, clear, cuboid, fresnel, measure, measuring, plane, tinted, v, white,
};

/// Light on purpose that is not noisier than this share of the noise of chance is found.
#[track_caller]
fn both_agree_and_chance_is_noisier(shot: &Shot, share: f64) {
    let [found, by_chance] = both_agree(shot);
    assert!(found.error[1] < share * by_chance.error[1], "{found:?} {by_chance:?}");
}

#[test]
fn sunlight_that_the_edge_of_a_shelf_reflects() {
    // At 60° sunlight enters the shelf, 0.4 m thick, goes on at asin(sin 60°/1.5) and is reflected totally at the edge at x = 1,
    // where it falls on the floor from the other side: E = E₀·cos θ·½Σ(1−R)², besides what passes straight, ½Σ(1−R)/(1+R).
    let mut shot = measuring(v(0.5, 0.3, 0.4), Vec3::ZERO);
    shot.put(plane(), white(1.0));
    shot.scene.settings.bounces = 2;
    shot.sun(v(0.75_f32.sqrt(), -0.5, 0.0), 1.0);
    put_at(&mut shot, cuboid(v(4.0, 0.4, 4.0)), clear(1.5), v(-1.0, 0.7, 0.0));
    let passed = fresnel(0.5, 1.5).map(|r| (1.0 - r) / (1.0 + r) + (1.0 - r).powi(2));
    measure(&shot, 16).assert_is_grey(0.5 * 0.5 * (passed[0] + passed[1]), 1e-4);
}

#[test]
fn under_a_shelf_near_its_edge() {
    for x in [0.5, 0.9] {
        let mut shot = floor_at(x, 0.0);
        put_at(&mut shot, cuboid(v(2.0, 0.3, 2.0)), clear(1.5), v(0.0, 0.6, 0.0));
        bulb(&mut shot, v(0.4, 1.6, 0.1), 0.5, 4.0);
        both_agree_and_chance_is_noisier(&shot, 0.8);
    }
}

#[test]
fn under_and_beside_a_block() {
    for (x, z) in [(0.0, 0.0), (0.45, 0.45), (0.9, 0.2)] {
        let mut shot = floor_at(x, z);
        let block = tinted(1.5, Rgb::new(0.6, 0.8, 0.9), 1.0);
        put_at(&mut shot, cuboid(v(1.2, 0.8, 1.0)), block, v(0.0, 0.95, 0.0)).turn_deg = v(0.0, 10.0, 3.0);
        bulb(&mut shot, v(0.3, 2.2, 0.1), 0.5, 4.0);
        both_agree(&shot);
    }
}

#[test]
fn in_a_display_case() {
    let mut shot = floor_at(0.3, 0.2);
    for (size, position) in [
        (v(1.6, 0.06, 1.2), v(0.0, 1.03, 0.0)),
        (v(0.06, 1.0, 1.2), v(-0.77, 0.495, 0.0)),
        (v(0.06, 1.0, 1.2), v(0.77, 0.495, 0.0)),
        (v(1.46, 1.0, 0.06), v(0.0, 0.495, -0.57)),
    ] {
        put_at(&mut shot, cuboid(size), clear(1.5), position);
    }
    bulb(&mut shot, v(0.9, 1.9, 0.4), 0.5, 4.0);
    both_agree_and_chance_is_noisier(&shot, 0.95);
}

#[test]
fn in_a_tank_of_glass_with_water() {
    let mut shot = measuring(v(0.3, 0.5, 0.3), v(0.2, 0.22, 0.1));
    put_at(&mut shot, cuboid(v(0.4, 0.02, 0.4)), white(0.8), v(0.2, 0.21, 0.1));
    put_at(&mut shot, cuboid(v(1.6, 1.0, 1.2)), clear(1.5), v(0.0, 0.6, 0.0));
    put_at(&mut shot, cuboid(v(1.5, 1.0, 1.1)), clear(1.333), v(0.0, 0.65, 0.0));
    bulb(&mut shot, v(0.4, 2.0, 0.2), 0.5, 4.0);
    both_agree(&shot);
}

#[test]
fn off_a_pane_behind_another() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.1, 6.0)), clear(1.5), v(0.0, 1.0, 0.0));
    put_at(&mut shot, cuboid(v(0.1, 0.8, 3.0)), clear(1.8), v(-0.6, 0.45, 0.0));
    put_at(&mut shot, cuboid(v(0.1, 0.8, 3.0)), clear(1.8), v(-0.6, 1.6, 0.0));
    bulb(&mut shot, v(0.4, 2.0, 0.1), 0.6, 4.0);
    both_agree(&shot);
}

#[test]
fn what_glows_is_seen_in_a_pane_from_below() {
    // Faces that do not face the floor light it by way of the pane: chance alone finds them, for no point of them is chosen.
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.2, 6.0)), clear(1.5), v(0.0, 0.8, 0.0));
    let glass = vitrine_scene::Material { emission_luminance: Some(2.0), ..clear(1.5) };
    put_at(&mut shot, cuboid(v(0.4, 0.3, 0.5)), glass, v(-0.3, 0.4, 0.3));
    both_agree(&shot);
}
