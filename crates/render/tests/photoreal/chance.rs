//! Light that is found on purpose through glass has the same mean as light that is found by chance alone. Lamps are large here, so
//! that chance finds them at all.

use crate::common::{
    Material, Measured, Object, Rgb, Shot, Vec3, ball, bulb, clear, cuboid, glowing, measure,
    measure_by_chance, measuring, plane, solid, tinted, v, white,
};

/// Samples in each of 64 pixels.
const SAMPLES: u32 = 4096;

/// A floor at y = 0, seen from beside.
pub fn floor_at(x: f32, z: f32) -> Shot {
    let mut shot = measuring(v(x + 0.5, 0.3, z + 0.4), v(x, 0.0, z));
    shot.put(plane(), white(0.5));
    shot
}

pub fn put_at(
    shot: &mut Shot,
    shape: vitrine_scene::Shape,
    material: Material,
    position: Vec3,
) -> &mut Object {
    let object = shot.put(shape, material);
    object.position = position;
    object
}

#[track_caller]
pub fn both_agree(shot: &Shot) -> [Measured; 2] {
    let (found, by_chance) = (measure(shot, SAMPLES), measure_by_chance(shot, SAMPLES));
    found.assert_agrees(&by_chance, 0.03);
    [found, by_chance]
}

#[track_caller]
fn both_agree_and_chance_is_noisier(shot: &Shot) {
    let [found, by_chance] = both_agree(shot);
    assert!(found.error[1] < 0.7 * by_chance.error[1], "{found:?} {by_chance:?}");
}

#[test]
fn through_a_slab() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.4, 6.0)), clear(1.5), v(0.0, 1.0, 0.0));
    bulb(&mut shot, v(0.3, 2.2, 0.1), 0.5, 4.0);
    both_agree_and_chance_is_noisier(&shot);
    shot.scene.settings.unpolarised = true;
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn through_a_tinted_slab_that_is_turned_at_a_slant() {
    let mut shot = floor_at(0.0, 0.0);
    let slab = tinted(1.6, Rgb::new(0.9, 0.6, 0.3), 0.3);
    put_at(&mut shot, cuboid(v(6.0, 0.2, 6.0)), slab, v(0.0, 1.2, 0.0)).turn_deg = v(10.0, 20.0, -8.0);
    bulb(&mut shot, v(0.8, 2.5, 0.1), 0.6, 4.0);
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn off_a_mirror_ball() {
    for color in [Rgb::WHITE, Rgb::new(0.9, 0.6, 0.3)] {
        let mut shot = floor_at(0.0, 0.0);
        let mirror = Material {
            base_metalness: Some(1.0),
            base_color: Some(color),
            specular_roughness: Some(0.0),
            ..Material::default()
        };
        put_at(&mut shot, ball(0.8), mirror, v(-1.1, 0.9, 0.0));
        // What stands in the way of the straight line.
        put_at(&mut shot, cuboid(v(0.1, 0.8, 4.0)), white(0.5), v(0.6, 1.0, 0.0));
        bulb(&mut shot, v(1.8, 2.2, 0.2), 0.9, 6.0);
        both_agree_and_chance_is_noisier(&shot);
        // The same under water.
        put_at(&mut shot, cuboid(v(8.0, 8.0, 8.0)), clear(1.33), v(0.0, 3.9, 0.0));
        both_agree(&shot);
    }
}

#[test]
fn through_the_surface_though_the_straight_line_leaves_by_a_wall() {
    // Water over the floor; the straight line to the lamp goes through its wall, the light from above through its surface.
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(2.0, 1.0, 4.0)), clear(1.33), v(-0.55, 0.5, 0.0));
    bulb(&mut shot, v(2.0, 1.9, 0.1), 0.4, 6.0);
    both_agree_and_chance_is_noisier(&shot);
    // The same in glass.
    put_at(&mut shot, cuboid(v(2.1, 1.1, 4.1)), clear(1.52), v(-0.55, 0.5, 0.0));
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn through_a_thick_pane_beside_the_straight_line() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(1.0, 0.8, 4.0)), clear(1.7), v(-0.1, 1.0, 0.0));
    bulb(&mut shot, v(1.2, 2.2, 0.1), 0.5, 6.0);
    both_agree(&shot);
}

#[test]
fn through_two_panes() {
    let mut shot = floor_at(0.0, 0.0);
    for y in [0.9, 1.1] {
        put_at(&mut shot, cuboid(v(8.0, 0.05, 8.0)), clear(1.5), v(0.0, y, 0.0));
    }
    bulb(&mut shot, v(1.2, 1.9, 0.1), 0.6, 4.0);
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn off_a_pane_and_water() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(0.1, 3.0, 6.0)), clear(1.8), v(-0.5, 1.6, 0.0));
    bulb(&mut shot, v(0.2, 1.5, 0.3), 0.7, 4.0);
    both_agree(&shot);
    let mut shot = measuring(v(0.5, 1.4, 0.4), v(0.0, 1.6, 0.0));
    put_at(&mut shot, cuboid(v(1.0, 0.2, 1.0)), white(0.8), v(0.0, 1.7, 0.0));
    shot.put(plane(), solid(clear(1.333)));
    bulb(&mut shot, v(1.5, 1.0, 0.3), 0.7, 4.0);
    both_agree(&shot);
}

#[test]
fn through_a_ball() {
    for x in [0.1, 0.45] {
        let mut shot = floor_at(x, 0.0);
        put_at(&mut shot, ball(0.5), clear(1.5), v(0.0, 0.9, 0.0));
        bulb(&mut shot, v(0.2, 2.4, 0.1), 0.5, 2.0);
        both_agree(&shot);
    }
}

#[test]
fn through_a_pane_and_a_ball() {
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, ball(0.5), clear(1.5), v(0.0, 0.8, 0.0));
    put_at(&mut shot, cuboid(v(8.0, 0.1, 8.0)), clear(1.5), v(0.0, 1.5, 0.0));
    bulb(&mut shot, v(0.4, 2.2, 0.1), 0.6, 2.0);
    both_agree(&shot);
    // The pane below the ball, where it bends what has been concentrated.
    shot.scene.objects[2].position.y = 0.15;
    shot.scene.camera.position = v(0.3, 0.05, 0.2);
    both_agree(&shot);
}

#[test]
fn through_two_balls() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, ball(0.3), clear(1.5), v(-0.2, 0.6, 0.1));
    put_at(&mut shot, ball(0.4), clear(1.4), v(0.3, 1.1, 0.0));
    bulb(&mut shot, v(0.1, 2.2, 0.1), 0.5, 2.0);
    both_agree(&shot);
}

#[test]
fn under_water() {
    let mut shot = floor_at(0.0, 0.0);
    let water = solid(tinted(1.333, Rgb::new(0.5, 0.8, 0.9), 1.0));
    put_at(&mut shot, plane(), water, v(0.0, 1.0, 0.0));
    bulb(&mut shot, v(0.5, 2.0, 0.1), 0.6, 4.0);
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn under_water_in_a_tank_without_walls() {
    let mut shot = floor_at(0.0, 0.0);
    // It stands exactly on the floor.
    put_at(&mut shot, cuboid(v(2.0, 1.0, 1.6)), clear(1.333), v(0.0, 0.5, 0.0));
    bulb(&mut shot, v(0.9, 1.8, 0.1), 0.6, 4.0);
    both_agree(&shot);
}

#[test]
fn in_a_ball_of_glass() {
    let mut shot = measuring(v(0.5, 1.6, 3.0), v(0.05, 0.25, 0.1));
    put_at(&mut shot, ball(1.0), clear(1.5), Vec3::ZERO);
    put_at(&mut shot, ball(0.3), white(0.7), v(0.05, 0.0, 0.0));
    bulb(&mut shot, v(0.5, 2.5, 1.1), 0.8, 2.0);
    both_agree(&shot);
}

#[test]
fn out_of_a_bulb_of_glass() {
    let mut shot = floor_at(0.4, 0.0);
    put_at(&mut shot, ball(0.5), clear(1.5), v(0.0, 0.9, 0.0));
    put_at(&mut shot, ball(0.42), clear(1.0), v(0.0, 0.9, 0.0));
    bulb(&mut shot, v(0.0, 0.9, 0.0), 0.3, 4.0);
    both_agree(&shot);
}

#[test]
fn from_within_a_ball() {
    let mut shot = floor_at(0.4, 0.0);
    put_at(&mut shot, ball(0.5), clear(1.5), v(0.0, 0.9, 0.0));
    bulb(&mut shot, v(0.1, 0.9, 0.0), 0.3, 4.0);
    both_agree(&shot);
}

#[test]
fn from_within_water() {
    let mut shot = measuring(v(0.5, 1.4, 0.4), v(0.0, 1.6, 0.0));
    put_at(&mut shot, cuboid(v(1.0, 0.2, 1.0)), white(0.8), v(0.0, 1.7, 0.0));
    put_at(&mut shot, plane(), solid(clear(1.333)), v(0.0, 1.2, 0.0));
    bulb(&mut shot, v(0.5, 0.5, 0.3), 0.5, 4.0);
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn through_adjacent_faces_of_a_box() {
    for unpolarised in [true, false] {
        let mut shot = floor_at(0.7, 0.0);
        put_at(&mut shot, cuboid(v(1.0, 1.0, 1.0)), clear(1.3), v(0.0, 0.6, 0.0));
        bulb(&mut shot, v(-0.3, 1.9, 0.2), 0.6, 4.0);
        shot.scene.settings.unpolarised = unpolarised;
        both_agree(&shot);
    }
}

#[test]
fn through_milk() {
    let milk = Material {
        transmission_scatter: Some(Rgb::new(0.4, 0.7, 0.9)),
        transmission_scatter_anisotropy: Some(0.4),
        ..tinted(1.4, Rgb::new(0.5, 0.4, 0.3), 0.6)
    };
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, ball(0.5), milk.clone(), v(0.0, 0.9, 0.0));
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.6, 2.0);
    both_agree(&shot);
    let mut shot = measuring(v(0.5, 1.0, 3.0), v(0.05, 0.0, 0.1));
    shot.put(cuboid(v(1.0, 1.0, 1.0)), milk);
    bulb(&mut shot, v(0.5, 2.0, 0.1), 0.8, 2.0);
    both_agree(&shot);
}

#[test]
fn through_glass_that_splits_light() {
    let flint = Material { transmission_dispersion_abbe_number: Some(20.0), ..clear(1.6) };
    let mut shot = floor_at(0.1, 0.0);
    put_at(&mut shot, ball(0.5), flint.clone(), v(0.0, 0.9, 0.0));
    bulb(&mut shot, v(0.2, 2.4, 0.1), 0.5, 2.0);
    both_agree(&shot);
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.6, 6.0)), flint, v(0.0, 1.0, 0.0));
    bulb(&mut shot, v(0.8, 2.2, 0.1), 0.5, 4.0);
    both_agree(&shot);
}

#[test]
fn through_water_in_glass() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(2.0, 1.0, 2.0)), clear(1.5), v(0.0, 1.0, 0.0));
    // It reaches out of the glass at the top.
    put_at(&mut shot, cuboid(v(1.8, 0.9, 1.8)), clear(1.333), v(0.0, 1.15, 0.0));
    bulb(&mut shot, v(0.4, 2.4, 0.1), 0.6, 4.0);
    both_agree(&shot);
    // From the side, through walls that do not face each other as well.
    shot.scene.camera.look_at = Some(v(1.5, 0.0, 0.0));
    shot.scene.camera.position = v(1.9, 0.3, 0.4);
    both_agree(&shot);
}

#[test]
fn through_a_ball_of_air_in_water_and_glass_in_water() {
    for ior in [1.0, 1.5] {
        let mut shot = floor_at(0.1, 0.0);
        put_at(&mut shot, plane(), solid(clear(1.333)), v(0.0, 1.5, 0.0));
        put_at(&mut shot, ball(0.3), clear(ior), v(0.0, 0.8, 0.0));
        bulb(&mut shot, v(0.3, 2.4, 0.1), 0.8, 4.0);
        both_agree(&shot);
    }
}

#[test]
fn a_surface_that_glows_behind_a_slab() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.4, 6.0)), clear(1.5), v(0.0, 1.0, 0.0));
    put_at(&mut shot, cuboid(v(1.0, 0.5, 0.8)), glowing(3.0), v(0.3, 2.0, 0.0));
    both_agree_and_chance_is_noisier(&shot);
}

#[test]
fn light_that_is_everywhere_through_all_kinds_of_glass() {
    let mut shot = floor_at(0.1, 0.0);
    shot.ambient(1.0);
    put_at(&mut shot, cuboid(v(3.0, 0.2, 3.0)), tinted(1.5, Rgb::splat(0.5), 0.2), v(0.0, 1.6, 0.0));
    put_at(&mut shot, ball(0.4), tinted(1.5, Rgb::new(0.9, 0.5, 0.2), 0.5), v(0.0, 0.7, 0.0));
    both_agree(&shot);
}

#[test]
fn through_a_sheet_and_a_slab() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.4, 6.0)), clear(1.5), v(0.0, 1.0, 0.0));
    let tint = Material { transmission_color: Some(Rgb::new(0.9, 0.7, 0.5)), ..clear(1.5) };
    put_at(&mut shot, plane(), tint, v(0.0, 0.6, 0.0));
    bulb(&mut shot, v(0.3, 2.2, 0.1), 0.5, 4.0);
    both_agree(&shot);
}

#[test]
fn onto_a_glossy_floor() {
    for roughness in [0.15, 0.5] {
        let mut shot = floor_at(0.0, 0.0);
        shot.scene.materials[0].specular_weight = Some(1.0);
        shot.scene.materials[0].specular_roughness = Some(roughness);
        put_at(&mut shot, cuboid(v(6.0, 0.2, 6.0)), clear(1.5), v(0.0, 0.8, 0.0));
        put_at(&mut shot, ball(0.2), clear(1.5), v(-0.3, 0.4, -0.2));
        bulb(&mut shot, v(-1.0, 1.5, -0.8), 0.4, 4.0);
        both_agree(&shot);
    }
}

#[test]
fn from_glass_that_glows() {
    let mut shot = floor_at(0.1, 0.0);
    let glowing_glass = Material { emission_luminance: Some(2.0), ..clear(1.5) };
    put_at(&mut shot, cuboid(v(6.0, 0.2, 6.0)), clear(1.5), v(0.0, 0.8, 0.0));
    put_at(&mut shot, ball(0.5), glowing_glass.clone(), v(0.3, 1.6, 0.0));
    put_at(&mut shot, cuboid(v(0.4, 0.3, 0.5)), glowing_glass, v(-0.3, 0.4, 0.3));
    both_agree(&shot);
}

#[test]
fn from_a_bulb_that_reaches_through_the_glass() {
    let mut shot = floor_at(0.0, 0.0);
    put_at(&mut shot, cuboid(v(6.0, 0.4, 6.0)), clear(1.5), v(0.0, 1.0, 0.0));
    bulb(&mut shot, v(0.3, 1.1, 0.1), 0.5, 4.0);
    both_agree(&shot);
}

#[test]
fn onto_frosted_glass_and_through_it() {
    let mut shot = measuring(v(0.5, 0.3, 0.4), v(0.0, 0.6, 0.0));
    let frosted = Material { specular_roughness: Some(0.4), ..clear(1.5) };
    put_at(&mut shot, cuboid(v(6.0, 0.1, 6.0)), frosted, v(0.0, 0.65, 0.0));
    put_at(&mut shot, cuboid(v(6.0, 0.2, 6.0)), clear(1.5), v(0.0, 1.2, 0.0));
    bulb(&mut shot, v(-0.5, 2.2, -0.4), 0.6, 4.0);
    both_agree(&shot);
}

#[test]
fn from_eyes_under_water_and_in_glass() {
    let mut shot = measuring(v(0.5, 0.5, 0.4), v(0.0, 0.3, 0.0));
    put_at(&mut shot, plane(), solid(clear(1.333)), v(0.0, 1.0, 0.0));
    put_at(&mut shot, cuboid(v(1.5, 0.6, 1.5)), clear(1.6), v(0.3, 0.5, 0.2));
    put_at(&mut shot, ball(0.1), white(0.7), v(0.0, 0.3, 0.0));
    bulb(&mut shot, v(0.4, 1.8, 0.3), 0.6, 4.0);
    both_agree(&shot);
}
