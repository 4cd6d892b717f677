//! Rays that leave a surface do not hit it again, at any scale: a convex thing alone never stands in its own light, so its
//! picture with shadows is that of ray casting, which has none, bit for bit.

use crate::common::{Dice, Shot, ball, cuboid, disc, matte, plane, triangle, v};
use crate::models;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::Shape;

/// Fainter light comes in at a grazing angle, where the truth itself is a matter of rounding.
const FAINT: f32 = 0.01;

const SCALES: [f32; 5] = [1e-3, 0.03, 1.0, 77.0, 1e4];

/// Near the world's origin and far from it, in sizes of the thing.
const PLACES: [Vec3; 4] =
    [Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), Vec3::new(-7.0, 0.3, 20.0), Vec3::new(300.0, -0.2, 0.01)];

/// How many points are lit, and how many of those a shadow has changed.
#[derive(Clone, Copy, Default)]
struct Count {
    lit: usize,
    shaded: usize,
}

impl Count {
    fn add(&mut self, shot: &Shot) {
        let (shadowed, bare) = (shot.picture(), shot.cast().picture());
        let pairs = shadowed.pixels.iter().zip(&bare.pixels);
        for (shadowed, bare) in pairs.filter(|(_, bare)| bare.g > FAINT) {
            self.lit += 1;
            self.shaded += usize::from(shadowed != bare);
        }
    }

    /// None when no more are shaded than that.
    fn fault(self, name: &str, allowed: usize) -> Option<String> {
        let Self { lit, shaded } = self;
        assert!(lit >= 200, "{name}: {lit} lit points are too few to tell");
        (shaded > allowed).then(|| format!("{name}: {shaded} of {lit} points are in their own shadow"))
    }
}

/// A convex thing.
struct Thing<'a> {
    name: &'a str,
    shape: &'a dyn Fn(&mut Shot, f32) -> Shape,
    stretch: Vec3,
    turn_deg: Vec3,
    /// Whether it can be looked at from inside.
    is_hollow: bool,
}

impl Thing<'_> {
    fn shot(&self, scale: f32, place: Vec3) -> Shot {
        let mut shot = Shot::new([64, 64], Vec3::ZERO, Vec3::Z);
        let shape = (self.shape)(&mut shot, scale);
        let object = shot.put(shape, matte(Rgb::WHITE));
        (object.position, object.turn_deg, object.scale) = (place * scale, self.turn_deg, self.stretch);
        shot
    }

    /// Looked at from any side, in light from about the same side.
    fn outside(&self, scale: f32, place: Vec3, count: &mut Count) {
        let mut dice = Dice(5);
        for view in 0..4 {
            let mut shot = self.shot(scale, place);
            let (middle, from) = (place * scale, dice.direction());
            shot.scene.camera.position = middle + from * (4.5 * scale);
            shot.scene.camera.look_at = Some(middle);
            let to_light = (from + dice.direction() * 0.9).normalize();
            if view % 2 == 0 {
                shot.sun(-to_light, 1.0);
            } else {
                shot.point(middle + to_light * (7.5 * scale), 1.0);
            }
            count.add(&shot);
        }
    }

    /// Looked at from inside, where a bulb hangs.
    fn inside(&self, scale: f32, place: Vec3, count: &mut Count) {
        let mut dice = Dice(6);
        let mut shot = self.shot(scale, place);
        let middle = place * scale;
        shot.scene.camera.position = middle + dice.vector() * (0.05 * scale);
        shot.scene.camera.look_at = Some(middle + dice.direction() * scale);
        shot.scene.camera.view_angle_deg = 120.0;
        shot.point(middle + dice.vector() * (0.05 * scale), 1.0);
        count.add(&shot);
    }

    fn check_everywhere(&self) {
        let mut faults = Vec::new();
        for (scale, place) in SCALES.into_iter().flat_map(|s| PLACES.map(|p| (s, p))) {
            let name = format!("{} of size {scale} at {place}", self.name);
            let (mut outside, mut inside) = (Count::default(), Count::default());
            self.outside(scale, place, &mut outside);
            faults.extend(outside.fault(&name, 0));
            if self.is_hollow {
                self.inside(scale, place, &mut inside);
                // Far from the origin a point in an inner edge may come to lie behind the next face.
                faults.extend(inside.fault(&format!("inside {name}"), 1));
            }
        }
        assert!(faults.is_empty(), "{faults:#?}");
    }
}

const TURN: Vec3 = Vec3::new(30.0, 40.0, 50.0);

#[test]
fn c1_balls_do_not_shade_themselves() {
    let shape = |_: &mut Shot, s| ball(s);
    let ball = Thing { name: "ball", shape: &shape, stretch: Vec3::ONE, turn_deg: TURN, is_hollow: true };
    ball.check_everywhere();
    Thing { name: "stretched ball", stretch: v(1.0, 0.3, 0.6), ..ball }.check_everywhere();
    Thing { name: "lens", stretch: v(1.0, 0.01, 1.0), is_hollow: false, ..ball }.check_everywhere();
}

#[test]
fn c2_boxes_do_not_shade_themselves() {
    let crate_ = |_: &mut Shot, s| cuboid(v(s, 0.5 * s, s));
    let sheet = |_: &mut Shot, s| cuboid(v(s, 1e-3 * s, s));
    let thing = Thing { name: "box", shape: &crate_, stretch: Vec3::ONE, turn_deg: TURN, is_hollow: true };
    thing.check_everywhere();
    Thing { name: "level box", turn_deg: Vec3::ZERO, ..thing }.check_everywhere();
    Thing { name: "sheet", shape: &sheet, is_hollow: false, ..thing }.check_everywhere();
}

#[test]
fn c3_planes_do_not_shade_themselves() {
    let shape = |_: &mut Shot, _| plane();
    for turn_deg in [Vec3::ZERO, v(0.2, 0.0, 0.1), v(30.0, 0.0, 0.0), v(33.0, 10.0, 77.0), v(90.0, 0.0, 0.0)]
    {
        let name = format!("plane turned {turn_deg}");
        Thing { name: &name, shape: &shape, stretch: Vec3::ONE, turn_deg, is_hollow: false }
            .check_everywhere();
    }
}

#[test]
fn discs_do_not_shade_themselves() {
    let shape = |_: &mut Shot, s: f32| disc(s);
    let coin = Thing { name: "disc", shape: &shape, stretch: Vec3::ONE, turn_deg: TURN, is_hollow: false };
    coin.check_everywhere();
    Thing { name: "level disc", turn_deg: Vec3::ZERO, ..coin }.check_everywhere();
    Thing { name: "long disc", stretch: v(3.0, 0.1, 0.4), ..coin }.check_everywhere();
}

#[test]
fn c4_triangles_do_not_shade_themselves() {
    let shape = |_: &mut Shot, s: f32| triangle([v(-s, 0.0, 0.0), v(s, 0.0, 0.1 * s), v(0.0, s, 0.0)]);
    let sail =
        Thing { name: "triangle", shape: &shape, stretch: Vec3::ONE, turn_deg: TURN, is_hollow: false };
    sail.check_everywhere();
}

#[test]
fn c5_closed_models_do_not_shade_themselves() {
    let own_size = |shot: &mut Shot, s| shot.model(models::faceted_ball(s, 12));
    let scaled = |shot: &mut Shot, s| shot.model(models::faceted_ball(100.0 * s, 12));
    let model =
        Thing { name: "model", shape: &own_size, stretch: Vec3::ONE, turn_deg: TURN, is_hollow: true };
    model.check_everywhere();
    Thing { name: "scaled model", shape: &scaled, stretch: v(0.01, -0.005, 0.01), ..model }
        .check_everywhere();
}

/// A model whose own origin is far from it: its points are near the world's origin, its own numbers are large.
#[test]
fn c5_a_model_far_from_its_own_origin_does_not_shade_itself() {
    let mut mesh = models::faceted_ball(1.0, 12);
    mesh.positions.iter_mut().for_each(|p| *p += v(1000.0, 0.0, -300.0));
    let mut shot = Shot::new([128, 128], v(1.0, 2.0, 3.0), Vec3::ZERO);
    let shape = shot.model(mesh);
    let object = shot.put(shape, matte(Rgb::WHITE));
    (object.position, object.turn_deg) = (v(-300.0, 0.0, -1000.0), v(0.0, -90.0, 0.0));
    shot.sun(v(-0.7, -1.0, -1.0), 1.0);
    let mut count = Count::default();
    count.add(&shot);
    assert_eq!(count.fault("model", 0), None);
}

/// A huge ball as the ground, looked at where it passes the world's origin: its points have small coordinates, its numbers
/// are large.
#[test]
fn c1_a_ball_as_the_ground_does_not_shade_itself() {
    for radius in [10.0_f32, 1e3, 1e5] {
        let mut shot = Shot::new([200, 100], v(0.0, 1.6, 6.0), v(0.0, 0.0, -1.0));
        shot.put(ball(radius), matte(Rgb::WHITE)).position = v(0.0, -radius, 0.0);
        shot.sun(v(-0.7, -0.5, -0.3), 1.0);
        let mut count = Count::default();
        count.add(&shot);
        assert_eq!(count.fault(&format!("ground of radius {radius}"), 0), None);
    }
}
