//! What shines in photoreal pictures: lamps, objects of glowing materials, sun, sky, panoramas. The register of lights, which chooses
//! one of them and a point of it, and tells with what density it would have chosen another.
//!
//! Lights with a place are chosen in proportion to about what they bring to the point that is lit, one by one where they are few, in a
//! tree where they are many; all distant light has a share of that choice. Light that reaches a surface from behind its normal is
//! not chosen: for what lets light through, no normal is given.
//!
//! How bright a lamp is: a white surface that faces it at the distance [`LampSpec::full_at`] shows its intensity I, which is what the
//! classic renderer shows at any distance. So the irradiance there is π·I, and a point has the radiant intensity π·I·d².

mod bound;
mod choice;
mod cuboid;
mod disc;
mod distant;
mod ellipsoid;
mod emitters;
mod environment;
mod form;
mod inversion;
mod lamps;
mod sky;
mod sphere;
mod sun;
#[cfg(test)]
mod tests;
mod tree;
mod triangle;

pub use emitters::{Emitter, EmitterForm};
pub use lamps::LampHit;

use bound::Bound;
use choice::{FEW, Local, Weights};
use disc::Plate;
use distant::DistantLights;
use emitters::EmitterTable;
use form::Form;
use lamps::{Lamp, LampForm, Lamps};
use std::f32::consts::PI;
use tree::LightTree;
use vitrine_math::{Ray, Rgb, Vec3, hash};
use vitrine_scene::lights::Emission;

/// No radiance is larger, so that products stay numbers.
const BRIGHTEST: f32 = 1e30;

/// A light of the scene.
#[derive(Clone, Debug)]
pub struct LampSpec {
    /// How it shines.
    pub emission: Emission,
    /// Intensity times colour.
    pub radiance: Rgb,
    /// For [`Emission::Point`], [`Emission::Disc`] and [`Emission::Sphere`]: the distance at which it lights a white surface as
    /// brightly as its intensity says, metres.
    pub full_at: f32,
}

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightPoint {
    /// A point without size.
    Point {
        /// World space, metres.
        position: Vec3,
    },
    /// A point of a surface.
    Surface {
        /// World space, metres.
        position: Vec3,
        /// The unit normal on the side that shines toward who asked.
        n: Vec3,
        /// Whether the other side shines, too.
        is_two_sided: bool,
    },
    /// A direction without end.
    Distant {
        /// From the point that is lit to the light, of unit length.
        toward: Vec3,
    },
}

/// A point of a light that was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// The light; all distant light is [`DISTANT`].
    pub light: u32,
    /// Where its light comes from.
    pub at: LightPoint,
    /// Of a surface or a direction: radiance. Of a point: radiant intensity. Of sunlight without a width: the irradiance on a surface
    /// that faces it.
    pub le: Rgb,
    /// Of a surface: the density per m². Of a direction: the density per steradian. Where `is_delta`: the probability.
    pub pdf: f32,
    /// Whether no other way of sampling can find it.
    pub is_delta: bool,
}

/// In place of an index, all light without end.
pub const DISTANT: u32 = u32::MAX;

/// All lights, ready to be chosen from.
#[derive(Clone, Debug, Default)]
pub struct Lights {
    /// Those that have a place.
    local: Vec<LocalLight>,
    /// What is known of each from afar.
    bounds: Vec<Bound>,
    /// Over many.
    tree: Option<LightTree>,
    distant: DistantLights,
    lamps: Lamps,
    emitters: EmitterTable,
}

/// A light that has a place.
#[derive(Clone, Debug)]
struct LocalLight {
    form: Form,
    /// Radiance; of a point, radiant intensity.
    le: Rgb,
    is_two_sided: bool,
}

impl Lights {
    /// Of the scene's lights and the objects that shine. Those that are black or have no area are left out.
    #[must_use]
    pub fn new(lamps: &[LampSpec], emitters: &[Emitter]) -> Self {
        let mut lights = Self::default();
        let mut seen = Vec::new();
        for spec in lamps {
            lights.add_lamp(spec, &mut seen);
        }
        let mut rows = Vec::new();
        for emitter in emitters {
            let le = limited(emitter.radiance);
            let Some(form) = emitter.form.form().filter(|_| le.luminance() > 0.0) else { continue };
            let light = lights.add_local(LocalLight { form, le, is_two_sided: emitter.is_two_sided });
            rows.push(((emitter.primitive, emitter.triangle), light));
        }
        lights.tree = (lights.local.len() > FEW).then(|| LightTree::new(&lights.bounds));
        lights.lamps = Lamps::new(seen);
        lights.emitters = EmitterTable::new(rows);
        lights
    }

    fn add_lamp(&mut self, spec: &LampSpec, seen: &mut Vec<Lamp>) {
        let full2 = spec.full_at * spec.full_at;
        let (form, le, lamp, radius, position) = match spec.emission {
            // Φ/ω = π·I·d²
            Emission::Point { position } => {
                (Some(Form::Point(position)), spec.radiance * (PI * full2), None, 0.0, position)
            }
            // π·r²·L = π·I·d²
            Emission::Sphere { position, radius } => {
                let form = EmitterForm::Sphere { center: position, radius }.form();
                let le = spec.radiance * (full2 / (radius * radius));
                (form, le, Some(LampForm::Ball), radius, position)
            }
            Emission::Disc { position, radius } => {
                let form = Plate::new(position, Vec3::Z * radius, Vec3::X * radius).map(Form::Plate);
                let le = spec.radiance * (full2 / (radius * radius));
                (form, le, Some(LampForm::Disc), radius, position)
            }
            _ => return self.distant.add(&spec.emission, spec.radiance),
        };
        let le = limited(le);
        let Some(form) = form.filter(|_| le.luminance() > 0.0) else { return };
        // A ball shines outwards alone: bent light may come to a point that x sees from inside the ball.
        let is_two_sided = !matches!(lamp, Some(LampForm::Ball));
        let light = self.add_local(LocalLight { form, le, is_two_sided });
        seen.extend(lamp.map(|form| Lamp { form, position, radius, light }));
    }

    fn add_local(&mut self, light: LocalLight) -> u32 {
        let bound = light.form.bound(light.is_two_sided);
        self.bounds.push(bound.with_power(bound.power * light.le.luminance()));
        self.local.push(light);
        self.local.len() as u32 - 1
    }

    /// Whether nothing shines.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.local.is_empty() && self.distant.is_empty()
    }

    /// Chooses a light for the point `p` and a point of it. With a normal, light from behind it does not count. None where no light
    /// arrives, or where the one that was chosen is seen from behind. All numbers are in [0, 1).
    #[must_use]
    pub fn sample(&self, p: Vec3, n: Option<Vec3>, u_choice: f32, u: [f32; 2]) -> Option<LightSample> {
        let weights = self.weights(p, n);
        let distant = weights.distant_share()?;
        if u_choice < distant {
            let chosen = self.distant.choose(n, u_choice / distant, u)?;
            let at = LightPoint::Distant { toward: chosen.toward };
            let pdf = chosen.pdf * distant;
            return Some(LightSample { light: DISTANT, at, le: chosen.le, pdf, is_delta: chosen.is_delta });
        }
        let rest = (u_choice - distant) / (1.0 - distant);
        let (light, of_light) = match (&self.tree, &weights.local) {
            (Some(tree), Local::Cut(cut)) => tree.choose(cut, p, n, with_more_digits(rest, u))?,
            (_, local) => local.choose(rest)?,
        };
        let probability = of_light * (1.0 - distant);
        let LocalLight { form, le, is_two_sided } = &self.local[light as usize];
        if let Form::Point(position) = form {
            let at = LightPoint::Point { position: *position };
            let sample = LightSample { light, at, le: *le, pdf: probability, is_delta: true };
            return (*position != p).then_some(sample);
        }
        let chosen = form.choose(p, u, *is_two_sided)?;
        let at = LightPoint::Surface { position: chosen.y, n: chosen.n, is_two_sided: *is_two_sided };
        let pdf = chosen.pdf * probability;
        (pdf > 0.0).then_some(LightSample { light, at, le: *le, pdf, is_delta: false })
    }

    /// The density per m² with which [`Self::sample`] from `p` finds `y`, a point of a light on a side that shines.
    #[must_use]
    pub fn pdf_surface(&self, light: u32, p: Vec3, n: Option<Vec3>, y: Vec3) -> f32 {
        let Some(held) = self.local.get(light as usize) else { return 0.0 };
        let weights = self.weights(p, n);
        let Some(distant) = weights.distant_share() else { return 0.0 };
        let of_light = match (&self.tree, &weights.local) {
            (Some(tree), Local::Cut(cut)) => tree.probability(cut, light, p, n),
            (_, local) => local.probability(light),
        };
        held.form.pdf(p, y, held.is_two_sided) * of_light * (1.0 - distant)
    }

    /// The density per steradian with which [`Self::sample`] from `p` finds a direction of unit length, of all distant light with
    /// a width.
    #[must_use]
    pub fn pdf_distant(&self, p: Vec3, n: Option<Vec3>, toward: Vec3) -> f32 {
        if !self.distant.has_width() {
            return 0.0;
        }
        let Some(distant) = self.weights(p, n).distant_share() else { return 0.0 };
        self.distant.pdf(n, toward) * distant
    }

    /// The radiance of all distant light from a direction of unit length: what a ray sees that hits nothing.
    #[inline]
    #[must_use]
    pub fn le_distant(&self, toward: Vec3) -> Rgb {
        self.distant.le(toward)
    }

    /// The radiance that leaves a light's surface on the side of its normal (`is_front`) or on the other one.
    #[inline]
    #[must_use]
    pub fn le_surface(&self, light: u32, is_front: bool) -> Rgb {
        match self.local.get(light as usize) {
            Some(LocalLight { le, is_two_sided, form }) if is_front || *is_two_sided => match form {
                Form::Point(_) => Rgb::BLACK,
                _ => *le,
            },
            _ => Rgb::BLACK,
        }
    }

    /// The light that a triangle of a primitive is; None for one that does not shine. Primitives without triangles have number 0.
    #[inline]
    #[must_use]
    pub fn emitter(&self, primitive: u32, triangle: u32) -> Option<u32> {
        self.emitters.light(primitive, triangle)
    }

    /// Whether there are lamps that rays can meet.
    #[inline]
    #[must_use]
    pub fn has_lamps(&self) -> bool {
        !self.lamps.is_empty()
    }

    /// The nearest lamp that a ray meets before `t_max`; balls from outside only.
    #[inline]
    #[must_use]
    pub fn intersect(&self, ray: &Ray, t_max: f32) -> Option<LampHit> {
        self.lamps.intersect(ray, t_max)
    }

    /// About what the lights bring to `p`.
    #[inline]
    fn weights(&self, p: Vec3, n: Option<Vec3>) -> Weights {
        let distant = self.distant.importance(n);
        let local = if let Some(tree) = &self.tree {
            Local::Cut(tree.cut(p, n))
        } else if self.local.len() == 1 && distant == 0.0 {
            Local::Only
        } else {
            let (mut each, mut sum) = ([0.0; FEW], 0.0);
            for (weight, bound) in each.iter_mut().zip(&self.bounds) {
                *weight = bound.importance(p, n);
                sum += *weight;
            }
            Local::Each(each, sum)
        };
        Weights { local, distant }
    }
}

/// A number in [0, 1) with further digits, which follow from two others: among thousands of lights those of an `f32` do not suffice.
fn with_more_digits(u: f32, [a, b]: [f32; 2]) -> f64 {
    let digits = hash::unit(hash::join(hash::join(hash::mix(u.to_bits()), a.to_bits()), b.to_bits()));
    f64::from(u) + f64::from(digits) / 16_777_216.0
}

/// No brighter than products allow.
fn limited(le: Rgb) -> Rgb {
    Rgb::from(le.to_array().map(|c| c.min(BRIGHTEST)))
}
