//! Smooth chance in space: value noise, in octaves.

use vitrine_math::{Vec3, hash};

/// Sums of noise at rising frequencies and falling strength, each octave twice as fine and half as strong as the last;
/// about −1 to 1.
pub fn octaves(p: Vec3, count: u32, seed: u32) -> f32 {
    let mut sum = 0.0;
    let (mut scale, mut strength) = (1.0, 0.5);
    for octave in 0..count {
        sum += strength * value(p * scale, hash::join(hash::mix(seed), octave));
        scale *= 2.0;
        strength *= 0.5;
    }
    sum
}

/// Random numbers from −1 to 1 at the points of the grid of whole numbers, blended smoothly between them.
fn value(p: Vec3, seed: u32) -> f32 {
    let cell = p.floor();
    let f = p - cell;
    let ease = f * f * (Vec3::splat(3.0) - 2.0 * f);
    let at = |corner: u32| {
        let [x, y, z] = [0, 1, 2].map(|k| (cell[k] as i32).wrapping_add((corner >> k & 1) as i32) as u32);
        2.0 * hash::unit(hash::join(hash::join(hash::join(seed, x), y), z)) - 1.0
    };
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let along_x = |corner: u32| mix(at(corner), at(corner + 1), ease.x);
    let along_y = |corner: u32| mix(along_x(corner), along_x(corner + 2), ease.y);
    mix(along_y(0), along_y(4), ease.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_stays_in_its_range_and_has_no_steps() {
        let (mut last, mut least, mut most) = (octaves(Vec3::ZERO, 4, 7), f32::INFINITY, f32::NEG_INFINITY);
        for i in 1..20_000 {
            let now = octaves(Vec3::new(1.0, 0.7, -0.3) * (i as f32 * 1e-3), 4, 7);
            assert!((now - last).abs() < 0.05, "a step at {i}");
            (least, most) = (least.min(now), most.max(now));
            last = now;
        }
        assert!(least >= -1.0 && most <= 1.0 && most - least > 0.5, "from {least} to {most}");
    }
}
