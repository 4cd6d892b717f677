//! What can be computed with in 32-bit floats. Every number that a scene may hold is finite; here those are refused or drawn in
//! whose products would not be.

use crate::accel::huge;
use vitrine_math::{Bounds3, Rgb, Transform, Vec3};
use vitrine_scene::lights::Emission;

/// No coordinate may be larger, metres: the product of three still is a number.
pub const FARTHEST: f32 = 1e12;
/// Nothing may be stretched or squeezed more: the squares of the inverse still are numbers.
const STEEPEST: f32 = 1e18;
/// Farther lamps shine as if from here, metres. Squares of it are numbers.
const LAMP_FARTHEST: f32 = 1e18;
/// The brightest light and the brightest colour: their product, summed over all samples and thousands of lamps, is a number.
const BRIGHTEST: f32 = 1e15;

/// The most bytes that the trees over a scene's models may take where nothing else is said: half of the machine's memory, or 8 GiB
/// where the system does not tell it. (What a container may take of its machine is not known here.)
#[must_use]
pub fn memory_limit() -> u64 {
    const UNKNOWN: u64 = 16 << 30;
    huge::machine_memory().unwrap_or(UNKNOWN) / 2
}

/// Whether a form in this box can be computed with.
pub fn is_near_enough(bounds: &Bounds3) -> bool {
    bounds.min.abs().max(bounds.max.abs()).cmple(Vec3::splat(FARTHEST)).all()
}

/// Whether one can go from the world into a space of a form's own and bring normals back.
pub fn is_wide_enough(transform: &Transform) -> bool {
    let m = transform.object_from_world;
    [m.matrix3.x_axis, m.matrix3.y_axis, m.matrix3.z_axis]
        .iter()
        .all(|axis| axis.abs().max_element() <= STEEPEST)
        && m.translation.is_finite()
}

/// Whether normals of a model come into the world as numbers. Its box does not tell: what has no thickness can be stretched to any.
pub fn is_little_stretched(transform: &Transform) -> bool {
    let m = transform.world_from_object.matrix3;
    [m.x_axis, m.y_axis, m.z_axis].iter().all(|axis| axis.abs().max_element() <= STEEPEST)
}

/// A colour or a light that is no brighter than products and sums allow.
pub fn dimmed(color: Rgb) -> Rgb {
    Rgb::from(color.to_array().map(|c| c.min(BRIGHTEST)))
}

/// A lamp that is no farther than squares allow, and in the same direction: smaller and nearer in proportion.
pub fn drawn_in(emission: Emission) -> Emission {
    let share = |position: Vec3, radius: f32| {
        let farthest = position.abs().max_element().max(radius);
        (LAMP_FARTHEST / farthest).min(1.0)
    };
    match emission {
        Emission::Point { position } => Emission::Point { position: position * share(position, 0.0) },
        Emission::Disc { position, radius } => {
            let share = share(position, radius);
            Emission::Disc { position: position * share, radius: radius * share }
        }
        Emission::Sphere { position, radius } => {
            let share = share(position, radius);
            Emission::Sphere { position: position * share, radius: radius * share }
        }
        Emission::Everywhere
        | Emission::Direction { .. }
        | Emission::Environment { .. }
        | Emission::Sky { .. } => emission,
    }
}
