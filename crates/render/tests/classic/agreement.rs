//! Whole pictures against the oracle: random scenes, every pixel.

use crate::common::{Dice, Shot, ball, cuboid, disc, distance, plane, triangle, v};
use crate::oracle::Oracle;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{Material, Object, Shape};

/// What the materials of a random scene can do.
#[derive(Clone, Copy, PartialEq)]
enum Finish {
    Matte,
    Shiny,
    Mirror,
    Clear,
    Bending,
}

fn material(dice: &mut Dice, finish: Finish) -> Material {
    let mut m = Material { color: Some(dice.color()), diffuse: Some(dice.unit()), ..Material::default() };
    if finish != Finish::Matte {
        m.specular = Some(dice.unit());
        m.shininess = Some(dice.between(1.0, 60.0));
    }
    match finish {
        Finish::Mirror => m.reflectivity = Some(dice.unit()),
        Finish::Clear | Finish::Bending => m.transparency = Some(dice.between(0.2, 1.0)),
        Finish::Matte | Finish::Shiny => {}
    }
    if finish == Finish::Bending {
        m.refraction = Some(dice.between(0.7, 1.8));
    }
    m
}

fn place(dice: &mut Dice, object: &mut Object) {
    object.position = dice.vector() * 2.0;
    object.turn_deg = dice.vector() * 180.0;
    if dice.unit() < 0.5 {
        object.scale = v(dice.between(0.3, 1.5), dice.between(0.3, 1.5), dice.between(0.3, 1.5));
    }
}

fn shape(dice: &mut Dice) -> Shape {
    match (dice.unit() * 4.0) as u32 {
        0 => ball(dice.between(0.2, 1.0)),
        1 => cuboid(v(dice.between(0.3, 2.0), dice.between(0.3, 2.0), dice.between(0.3, 2.0))),
        2 => disc(dice.between(0.4, 1.5)),
        _ => triangle([dice.vector() * 1.5, dice.vector() * 1.5, dice.vector() * 1.5]),
    }
}

fn scene(seed: u32, finish: Finish) -> Shot {
    let mut dice = Dice(seed * 1_000_003);
    let mut shot = Shot::new([64, 48], v(0.3, 1.0, 7.0), Vec3::ZERO);
    shot.scene.settings.background = dice.color();
    for _ in 0..8 {
        let m = material(&mut dice, finish);
        let shape = shape(&mut dice);
        place(&mut dice, shot.put(shape, m));
    }
    let ground = material(&mut dice, Finish::Matte);
    shot.put(plane(), ground).position = v(0.0, -2.2, 0.0);
    let wall = material(&mut dice, if finish == Finish::Mirror { finish } else { Finish::Shiny });
    let wall = shot.put(plane(), wall);
    wall.position = v(0.0, 0.0, -5.0);
    wall.turn_deg = v(80.0, 0.0, 15.0);
    shot.ambient(0.2);
    shot.point(v(3.0, 5.0, 4.0), 0.6);
    shot.sun(v(0.5, -1.0, -0.4), 0.5);
    shot.point(v(-4.0, 3.0, 2.0), 0.4).color = dice.color();
    shot
}

/// Compares every pixel. One may be off where the truth itself jumps: when rays a hundredth of a pixel beside it disagree.
fn compare(shot: &Shot, allowed: f32) {
    let picture = shot.picture();
    let oracle = Oracle::new(&shot.scene, &shot.assets);
    let [width, height] = shot.scene.settings.size;
    let mut jumps = 0;
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let seen = picture.pixel(x, y);
        let (cx, cy) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let truth = oracle.at(cx, cy).color();
        let off = distance(seen, truth);
        if off <= allowed {
            continue;
        }
        let beside = |dx: f64, dy: f64| oracle.at(cx + dx, cy + dy).color();
        let around = [(0.01, 0.0), (-0.01, 0.0), (0.0, 0.01), (0.0, -0.01)].map(|(dx, dy)| beside(dx, dy));
        let spread = around.iter().map(|c| distance(*c, truth)).fold(0.0, f32::max);
        assert!(
            spread * 2.0 > off,
            "pixel ({x}, {y}): {seen:?} in place of {truth:?}, off by {off}; nearby {around:?}"
        );
        jumps += 1;
    }
    assert!(jumps < width * height / 50, "{jumps} pixels on edges");
}

fn not_all_alike(shot: &Shot) {
    let picture = shot.picture();
    let first = picture.pixels[0];
    assert!(picture.pixels.iter().filter(|p| distance(**p, first) > 0.02).count() > 100);
    assert!(picture.pixels.iter().all(|p: &Rgb| p.is_finite()));
}

/// Opaque shiny things in the light of two bulbs, a sun and the air.
pub fn lit_scene() -> Shot {
    scene(20, Finish::Shiny)
}

fn check(finish: Finish, allowed: f32, seeds: std::ops::Range<u32>) {
    for seed in seeds {
        let shot = scene(seed, finish);
        not_all_alike(&shot);
        compare(&shot, allowed);
    }
}

#[test]
fn c1_c4_c9_matte_scenes_are_what_the_formulas_say() {
    check(Finish::Matte, 1e-5, 0..12);
}

#[test]
fn c6_c9_shiny_scenes_are_what_the_formulas_say() {
    check(Finish::Shiny, 4e-5, 20..32);
}

#[test]
fn c10_mirror_scenes_are_what_the_formulas_say() {
    check(Finish::Mirror, 4e-4, 40..52);
}

#[test]
fn c11_transparent_scenes_are_what_the_formulas_say() {
    check(Finish::Clear, 1e-4, 60..72);
}

#[test]
fn c11_refracting_scenes_are_what_the_formulas_say() {
    check(Finish::Bending, 1e-3, 80..92);
}
