//! Water that stands exactly on its floor or in its glass: there is one surface between them and no film of air. A film would reflect
//! some of the light twice, and at a slant all of it.

use crate::common::{
    Measured, Shape, Vec3, ball, clear, cuboid, fresnel, glowing, measure, measuring, plane, v, white,
};

const WATER: f64 = 1.333;
const GLASS: f64 = 1.5;

/// A floor with sunlight at cos θ = 0.8 and a sheet of water that reaches so far into it; seen from an eye.
fn floor_under_water(depth: f32, eye: Vec3, bounces: u32, turn_deg: Vec3) -> Measured {
    // The whole world is turned, so that faces are the same but for rounding.
    let turned = |p: Vec3| vitrine_math::Transform::from_place(Vec3::ZERO, turn_deg, Vec3::ONE).vector(p);
    let mut shot = measuring(turned(eye), Vec3::ZERO);
    shot.scene.settings.bounces = bounces;
    shot.put(plane(), white(1.0)).turn_deg = turn_deg;
    let water = shot.put(cuboid(v(20.0, 2.0 + depth, 20.0)), clear(WATER as f32));
    (water.position, water.turn_deg) = (turned(v(0.0, 1.0 - 0.5 * depth, 0.0)), turn_deg);
    shot.sun(turned(v(-0.6, -0.8, 0.0)), 1.0);
    measure(&shot, 64)
}

#[test]
fn a_floor_is_as_bright_under_water_that_stands_on_it_as_under_water_that_reaches_into_it() {
    let passed = |cos: f64| 1.0 - 0.5 * fresnel(cos, WATER).iter().sum::<f64>();
    for turn_deg in [Vec3::ZERO, v(13.0, 40.0, -27.0)] {
        // In the water: what passes its surface, 1−F, and nothing else.
        let eye = v(0.5, 0.3, 0.4);
        for depth in [0.0, 0.001] {
            floor_under_water(depth, eye, 2, turn_deg).assert_is_grey(0.8 * passed(0.8), 1e-4);
        }
        // Above it radiance is 1/n² of that, and less by what its surface reflects again.
        let eye = v(0.0, 6.0, 0.0);
        let truth = 0.8 * passed(0.8) * passed(1.0) / (WATER * WATER);
        for depth in [0.0, 0.001] {
            floor_under_water(depth, eye, 3, turn_deg).assert_is_grey(truth, 1e-2);
        }
        // With all that goes to and fro between the floor and the surface, most of it by total reflection.
        let [on, into] = [0.0, 0.001].map(|depth| floor_under_water(depth, eye, 30, turn_deg));
        on.assert_agrees(&into, 0.01);
        assert!(on.mean[1] > 1.2 * truth, "{on:?}");
    }
}

/// The share of light that passes parallel surfaces between these media, at cos θ in the first.
fn passed(indices: &[f64], cos: f64) -> f64 {
    let sin = (1.0 - cos * cos).sqrt() * indices[0];
    let mut stacks = [(1.0, 0.0); 2];
    for pair in indices.windows(2) {
        let cos = (1.0 - (sin / pair[0]).powi(2)).sqrt();
        for ((t, r), f) in stacks.iter_mut().zip(fresnel(cos, pair[1] / pair[0])) {
            // T = T₁T₂/(1−R₁R₂), and what the stack reflects from behind R = R₂ + T₂²R₁/(1−R₁R₂)
            let again = 1.0 / (1.0 - *r * f);
            (*t, *r) = (*t * (1.0 - f) * again, f + (1.0 - f).powi(2) * *r * again);
        }
    }
    0.5 * (stacks[0].0 + stacks[1].0)
}

#[test]
fn stacks_of_one_pane_pass_what_the_formula_for_panes_says() {
    let [s, p] = fresnel(0.5, GLASS).map(|r| (1.0 - r) / (1.0 + r));
    assert!((passed(&[1.0, GLASS, 1.0], 0.5) - 0.5 * (s + p)).abs() < 1e-12);
}

/// What is seen of a wall that glows, straight through x = y = 0 at so many degrees, past things of glass and water.
fn before_a_wall(angle_deg: f64, things: &[(Shape, f64, Vec3)], turn_deg: Vec3) -> Measured {
    let turned = |p: Vec3| vitrine_math::Transform::from_place(Vec3::ZERO, turn_deg, Vec3::ONE).vector(p);
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let eye = v(5.0 * sin as f32, 0.0, 5.0 * cos as f32);
    let mut shot = measuring(turned(eye), Vec3::ZERO);
    let wall = shot.put(cuboid(v(60.0, 60.0, 1.0)), glowing(1.0));
    (wall.position, wall.turn_deg) = (turned(v(0.0, 0.0, -3.0)), turn_deg);
    for (shape, index, position) in things {
        let object = shot.put(shape.clone(), clear(*index as f32));
        (object.position, object.turn_deg) = (turned(*position), turn_deg);
    }
    measure(&shot, 1024)
}

#[test]
fn between_glass_and_water_that_touch_there_is_one_surface() {
    let pane = (cuboid(v(20.0, 20.0, 0.1)), GLASS, v(0.0, 0.0, 0.05));
    let water = (cuboid(v(20.0, 20.0, 0.5)), WATER, v(0.0, 0.0, -0.25));
    for angle in [0.0_f64, 60.0] {
        let truth = passed(&[1.0, GLASS, WATER, 1.0], angle.to_radians().cos());
        let with_film = passed(&[1.0, GLASS, 1.0, WATER, 1.0], angle.to_radians().cos());
        assert!(with_film < 0.96 * truth);
        for things in [[pane.clone(), water.clone()], [water.clone(), pane.clone()]] {
            for turn_deg in [Vec3::ZERO, v(13.0, 40.0, -27.0)] {
                before_a_wall(angle, &things, turn_deg).assert_is_grey(truth, 5e-3);
            }
        }
    }
}

#[test]
fn water_that_fills_a_hollow_touches_the_glass() {
    let glass = (cuboid(v(20.2, 20.2, 0.7)), GLASS, Vec3::ZERO);
    let hollow = (cuboid(v(20.0, 20.0, 0.5)), 1.0, Vec3::ZERO);
    // All of it, and half of it: three of its faces are those of the hollow's.
    let full = (cuboid(v(20.0, 20.0, 0.5)), WATER, Vec3::ZERO);
    let half = (cuboid(v(20.0, 12.0, 0.5)), WATER, v(0.0, -4.0, 0.0));
    for angle in [0.0_f64, 60.0] {
        let truth = passed(&[1.0, GLASS, WATER, GLASS, 1.0], angle.to_radians().cos());
        for water in [&full, &half] {
            for turn_deg in [Vec3::ZERO, v(13.0, 40.0, -27.0)] {
                let things = [glass.clone(), hollow.clone(), water.clone()];
                before_a_wall(angle, &things, turn_deg).assert_is_grey(truth, 5e-3);
            }
        }
        // Without a hollow, and in another order, the smaller is there as well.
        let things = [half.clone(), glass.clone()];
        before_a_wall(angle, &things, Vec3::ZERO).assert_is_grey(truth, 5e-3);
    }
}

#[test]
fn water_that_fills_a_ball_of_glass_touches_it() {
    let truth = passed(&[1.0, GLASS, WATER, GLASS, 1.0], 1.0);
    let place = v(0.0, 0.0, -0.3);
    let things = [(ball(0.6), GLASS, place), (ball(0.5), 1.0, place), (ball(0.5), WATER, place)];
    for turn_deg in [Vec3::ZERO, v(13.0, 40.0, -27.0)] {
        before_a_wall(0.0, &things, turn_deg).assert_is_grey(truth, 1e-2);
    }
}
