//! What is known from afar of the light of one light or of many: where they are, which way they face, how much they shine. From it
//! follows how much light they may bring to a point (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree
//! Splitting", 2018; as in Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 12.6.3).

use vitrine_math::{Bounds3, Vec3};

/// More than this counts as this, so that sums stay numbers.
const LARGEST: f32 = 1e30;

/// A ball that holds the lights, a cone that holds the normals of their sides, and their power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Of the ball.
    center: Vec3,
    /// Of the ball, metres.
    radius: f32,
    /// Of the cone, of unit length.
    axis: Vec3,
    /// The cosine of half the cone's angle; −1: they face all ways.
    cos_cone: f32,
    /// Radiant intensity in the brightest direction, as a luminance.
    pub power: f32,
    /// Whether they shine to both sides.
    is_two_sided: bool,
}

impl Bound {
    /// For a light that shines to all sides.
    pub fn all_around(center: Vec3, radius: f32, power: f32) -> Self {
        Self { center, radius, axis: Vec3::Y, cos_cone: -1.0, power, is_two_sided: false }
    }

    /// For a flat light.
    pub fn flat(center: Vec3, radius: f32, n: Vec3, power: f32, is_two_sided: bool) -> Self {
        Self { center, radius, axis: n, cos_cone: 1.0, power, is_two_sided }
    }

    /// With another power.
    pub fn with_power(self, power: f32) -> Self {
        Self { power: power.clamp(f32::MIN_POSITIVE, LARGEST), ..self }
    }

    /// The middle of the lights.
    pub fn center(&self) -> Vec3 {
        self.center
    }

    /// The box around the ball.
    pub fn bounds(&self) -> Bounds3 {
        Bounds3 { min: self.center - Vec3::splat(self.radius), max: self.center + Vec3::splat(self.radius) }
    }

    /// For both.
    pub fn union(&self, other: &Self) -> Self {
        let (center, radius) = union_of_balls((self.center, self.radius), (other.center, other.radius));
        // A light with two sides may as well be turned over.
        let turn = other.is_two_sided && self.axis.dot(other.axis) < 0.0;
        let other_axis = if turn { -other.axis } else { other.axis };
        let (axis, cos_cone) = union_of_cones((self.axis, self.cos_cone), (other_axis, other.cos_cone));
        let power = (self.power + other.power).min(LARGEST);
        Self { center, radius, axis, cos_cone, power, is_two_sided: self.is_two_sided || other.is_two_sided }
    }

    /// How costly the choice among these lights is: power times the solid angles into which they face and shine (Conty Estevez and
    /// Kulla's M_Ω), times the square of their size.
    pub fn cost(&self) -> f32 {
        // M_Ω = 2π(1 − cosθo) + π/2·(2θw·sinθo − cos(θo − 2θw) − 2θo·sinθo + cosθo), θw = min(θo + π/2, π)
        let angle = libm::acosf(self.cos_cone.clamp(-1.0, 1.0));
        let (sin, cos) = libm::sincosf(angle);
        let wide = (angle + std::f32::consts::FRAC_PI_2).min(std::f32::consts::PI);
        let shine = 2.0 * wide * sin - libm::cosf(angle - 2.0 * wide) - 2.0 * angle * sin + cos;
        let facing = std::f32::consts::TAU * (1.0 - cos) + std::f32::consts::FRAC_PI_2 * shine;
        self.power * facing * self.radius * self.radius
    }

    /// Whether `p` is no farther from the middle than so many radii.
    #[inline]
    pub fn is_near(&self, p: Vec3, radii: f32) -> bool {
        let reach = radii * self.radius;
        (p - self.center).length_squared() < reach * reach
    }

    /// About how much light they may bring to `p`: an irradiance, on a surface of normal `n` if one is given. Zero only where no
    /// light of theirs can arrive.
    #[inline]
    pub fn importance(&self, p: Vec3, n: Option<Vec3>) -> f32 {
        let v = p - self.center;
        let (distance2, radius2) = (v.length_squared(), self.radius * self.radius);
        if distance2 <= radius2 {
            return (self.power / radius2).min(LARGEST);
        }
        let distance = distance2.sqrt();
        let w = v / distance;
        let sin_ball = self.radius / distance;
        let ball = [sin_ball, (1.0 - sin_ball * sin_ball).max(0.0).sqrt()];
        let mut estimate = self.power / distance2;
        if self.cos_cone > -1.0 {
            let cos = self.axis.dot(w);
            let cos = if self.is_two_sided { cos.abs() } else { cos };
            let cone = with_sine(self.cos_cone);
            let off_cone = less(with_sine(cos), [cone[1], cone[0]]);
            estimate *= less(with_sine(off_cone), ball).max(0.0);
        }
        if let Some(n) = n {
            estimate *= less(with_sine(-n.dot(w)), ball).max(0.0);
        }
        estimate.min(LARGEST)
    }
}

/// Cosine and sine.
#[inline]
fn with_sine(cos: f32) -> [f32; 2] {
    [cos, (1.0 - cos * cos).max(0.0).sqrt()]
}

/// cos(max(0, a − b)) of an angle a as [cosine, sine] and an angle b as [sine, cosine].
#[inline]
fn less([cos_a, sin_a]: [f32; 2], [sin_b, cos_b]: [f32; 2]) -> f32 {
    if cos_a > cos_b { 1.0 } else { cos_a * cos_b + sin_a * sin_b }
}

/// The smallest ball around two, a little larger than rounding can make it too small.
fn union_of_balls((a, ra): (Vec3, f32), (b, rb): (Vec3, f32)) -> (Vec3, f32) {
    let distance = a.distance(b);
    if distance + rb <= ra {
        return (a, ra);
    }
    if distance + ra <= rb {
        return (b, rb);
    }
    let radius = 0.5 * (distance + ra + rb);
    (a + (b - a) * ((radius - ra) / distance), radius * (1.0 + 4.0 * f32::EPSILON))
}

/// A cone around two, each by its axis and the cosine of half its angle.
fn union_of_cones((a, cos_a): (Vec3, f32), (b, cos_b): (Vec3, f32)) -> (Vec3, f32) {
    use std::f32::consts::PI;
    let all = (a, -1.0);
    if cos_a <= -1.0 || cos_b <= -1.0 {
        return all;
    }
    let (angle_a, angle_b) = (libm::acosf(cos_a.min(1.0)), libm::acosf(cos_b.min(1.0)));
    let between = libm::acosf(a.dot(b).clamp(-1.0, 1.0));
    if (between + angle_b).min(PI) <= angle_a {
        return (a, cos_a);
    }
    if (between + angle_a).min(PI) <= angle_b {
        return (b, cos_b);
    }
    let half = 0.5 * (angle_a + between + angle_b);
    let Some(side) = (b - a * a.dot(b)).try_normalize().filter(|_| half < PI) else { return all };
    let (sin, cos) = libm::sincosf(half - angle_a);
    // A little wider, for rounding.
    (a * cos + side * sin, (libm::cosf(half) - 1e-6).max(-1.0))
}
