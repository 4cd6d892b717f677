//! C10: mirror images, to the depth that is asked for.

use crate::common::{BLUE, Dice, GREEN, RED, Shot, assert_near, ball, cuboid, flat, matte, mirror, plane, v};
use crate::oracle::D3;
use vitrine_math::{Rgb, Vec3};

/// Two facing mirrors at z = −1 and z = 2, the camera between them, looking a little aslant so that it never sees itself.
fn facing(depth: u32, [a, b]: [(Rgb, f32); 2]) -> Shot {
    let mut shot = Shot::probe(Vec3::ZERO, v(0.01, 0.02, -1.0));
    for (z, (color, reflectivity)) in [(-1.0, a), (2.0, b)] {
        let object = shot.put(plane(), mirror(color, reflectivity));
        (object.position, object.turn_deg) = (v(0.0, 0.0, z), v(90.0, 0.0, 0.0));
    }
    shot.ambient(1.0);
    shot.scene.settings.depth = depth;
    shot
}

#[test]
fn c10_facing_mirrors_are_a_geometric_series_up_to_the_depth() {
    let (a, b) = ((Rgb::new(0.9, 0.1, 0.2), 0.8), (Rgb::new(0.1, 0.7, 0.4), 0.6));
    for depth in [0, 1, 2, 3, 4, 5, 12] {
        let (mut truth, mut weight) = (D3::default(), 1.0);
        for bounce in 0..=depth {
            let (color, r) = if bounce % 2 == 0 { a } else { b };
            // The last mirror shows its own colour alone.
            let own = if bounce == depth { 1.0 } else { 1.0 - f64::from(r) };
            truth = truth + D3::of_color(color) * (weight * own);
            weight *= f64::from(r);
        }
        assert_near(facing(depth, [a, b]).pixel(), truth.color(), 1e-6);
    }
}

#[test]
fn c10_each_reflection_is_one_ray() {
    for depth in [0, 1, 5, 32] {
        let rendered = facing(depth, [(RED, 1.0), (BLUE, 1.0)]).rendered(1, None);
        assert_eq!(rendered.rays, 1 + u64::from(depth));
    }
}

#[test]
fn c10_reflectivity_mixes_the_mirror_image_in() {
    for r in [0.0, 0.1, 0.5, 0.9, 1.0] {
        let mut shot = Shot::probe(v(0.0, 1.0, 1.0), Vec3::ZERO);
        shot.scene.settings.background = GREEN;
        shot.put(plane(), mirror(RED, r));
        shot.ambient(1.0);
        assert_near(shot.pixel(), RED * (1.0 - r) + GREEN * r, 1e-6);
    }
}

#[test]
fn c10_a_perfect_mirror_shows_nothing_of_its_own() {
    let mut shot = Shot::probe(v(0.0, 1.0, 1.0), Vec3::ZERO);
    let material = vitrine_scene::Material { specular: Some(1.0), diffuse: Some(1.0), ..mirror(RED, 1.0) };
    shot.put(plane(), material);
    shot.ambient(1.0);
    shot.sun(v(0.0, -1.0, -1.0), 1.0);
    assert_eq!(shot.pixel(), Rgb::BLACK, "no colour, no highlight");
    shot.scene.settings.depth = 0;
    assert_ne!(shot.pixel(), Rgb::BLACK);
}

/// A small ball stands where the law of reflection sends the ray: the mirror shows it, and none a little beside it.
fn check_law(shot: &Shot, from: Vec3, p: Vec3, n: D3) {
    let d = (D3::of(p) - D3::of(from)).unit();
    let reflected = d - n * (2.0 * n.dot(d));
    let aside = reflected.cross(D3::new(0.3, 0.5, 0.8)).unit();
    let seen = |place: D3| {
        let mut shot = shot.clone();
        shot.put(ball(0.01), flat(GREEN)).position = Vec3::from(place.0.map(|c| c as f32));
        shot.look(from, p)
    };
    let target = D3::of(p) + reflected * 4.0;
    assert_eq!(seen(target), GREEN);
    assert_eq!(seen(target + aside * 0.0099), GREEN);
    assert_eq!(seen(target + aside * 0.0101), Rgb::BLACK);
}

#[test]
fn c10_the_mirror_direction_is_exact_on_flat_mirrors() {
    let mut dice = Dice(11);
    for _ in 0..20 {
        let turn_deg = dice.vector() * 180.0;
        let n = crate::oracle::turned(D3::new(0.0, 1.0, 0.0), turn_deg);
        let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
        shot.put(cuboid(v(6.0, 0.5, 6.0)), mirror(RED, 1.0)).turn_deg = turn_deg;
        shot.ambient(1.0);
        let up = Vec3::from(n.0.map(|c| c as f32));
        let from = up * 3.0 + dice.vector();
        check_law(&shot, from, up * 0.25, n);
    }
}

#[test]
fn c10_the_mirror_direction_is_exact_on_balls() {
    let mut dice = Dice(12);
    for _ in 0..20 {
        let mut shot = Shot::probe(Vec3::ZERO, Vec3::Z);
        shot.put(ball(1.0), mirror(RED, 1.0));
        shot.ambient(1.0);
        let n = dice.direction();
        let from = (n + dice.direction() * 0.6).normalize() * 5.0;
        check_law(&shot, from, n, D3::of(n).unit());
    }
}

#[test]
fn c10_mirrors_show_lit_and_shaded_things_and_the_background() {
    // A floor that is a perfect mirror shows the world upside down beneath it.
    let mut shot = Shot::new([48, 48], v(0.0, 2.0, 6.0), v(0.0, 0.0, 0.0));
    shot.scene.settings.background = Rgb::new(0.1, 0.2, 0.4);
    shot.put(cuboid(v(1.0, 1.0, 1.0)), matte(RED)).position = v(-0.5, 1.5, 0.0);
    shot.put(ball(0.5), matte(GREEN)).position = v(0.7, 2.2, 0.3);
    shot.point(v(2.0, 5.0, 3.0), 0.9);
    shot.ambient(0.2);
    let direct = shot.picture();
    let mut below = shot.clone();
    for object in &mut below.scene.objects {
        object.position.y = -object.position.y;
    }
    below.scene.lights.remove(0);
    below.point(v(2.0, -5.0, 3.0), 0.9);
    shot.put(plane(), mirror(BLUE, 1.0));
    let (above, below) = (shot.picture(), below.picture());
    let mut compared = 0;
    // The horizon is in row 7: below it the floor is what is seen, save where the things themselves stand before it.
    for (x, y) in (8..48).flat_map(|y| (0..48).map(move |x| (x, y))) {
        if direct.pixel(x, y) == shot.scene.settings.background {
            assert_near(above.pixel(x, y), below.pixel(x, y), 2e-5);
            compared += usize::from(above.pixel(x, y) != shot.scene.settings.background);
        }
    }
    assert!(compared > 100, "the floor shows things: {compared}");
}
