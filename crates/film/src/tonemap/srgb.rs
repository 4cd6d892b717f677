//! The sRGB curve, with which every view ends; alone it is the plain view.

use std::sync::LazyLock;
use vitrine_math::{Rgb, srgb_from_linear};

/// Each channel on its own, clamped to 0..1.
pub fn curve(color: Rgb) -> [f32; 3] {
    color.to_array().map(srgb_from_linear)
}

/// The curve in 8 bits, rounded: the same numbers as by [`curve`], many times faster.
pub fn curve_u8() -> impl Fn(f32) -> u8 {
    let steps = &*STEPS;
    |v| steps.at(v)
}

/// The bits of a float that number its cell: the exponent and 7 of the mantissa's. So cells grow as the curve gets flat, and no
/// more than one step begins in each.
const SHIFT: u32 = 16;
/// The first cell. All below it are 0 in 8 bits.
const FIRST: u32 = 0.000_122_070_31_f32.to_bits() >> SHIFT;
/// The last cell, which begins at 1.
const LAST: u32 = 1.0_f32.to_bits() >> SHIFT;
const CELLS: usize = (LAST - FIRST + 1) as usize;

static STEPS: LazyLock<Steps> = LazyLock::new(Steps::new);

/// Where each of the 256 steps begins. A picture has millions of channels, and the curve costs a power for each.
struct Steps {
    /// The step at the lower end of each cell.
    start: [u8; CELLS],
    /// The least value of each step; NaN, which nothing reaches, beyond the last.
    least: [f32; 257],
}

impl Steps {
    fn new() -> Self {
        let start = std::array::from_fn(|i| rounded(f32::from_bits((FIRST + i as u32) << SHIFT)));
        let least = std::array::from_fn(|step| match step {
            0 => 0.0,
            256 => f32::NAN,
            _ => least_of(step as u8),
        });
        Self { start, least }
    }

    #[inline]
    fn at(&self, v: f32) -> u8 {
        // NaN becomes 0 here, and any other number finds its cell: the bits of positive floats are ordered as they are.
        let v = if v > 0.0 { v } else { 0.0 };
        let cell = (v.to_bits() >> SHIFT).clamp(FIRST, LAST) - FIRST;
        let step = self.start[cell as usize];
        step + u8::from(v >= self.least[usize::from(step) + 1])
    }
}

fn rounded(v: f32) -> u8 {
    (srgb_from_linear(v) * 255.0 + 0.5) as u8
}

/// The least number from 0 to 1 that rounds to the step or beyond. Positive floats are ordered as their bits.
fn least_of(step: u8) -> f32 {
    let (mut below, mut at) = (0, 1.0_f32.to_bits());
    while at - below > 1 {
        let middle = u32::midpoint(below, at);
        if rounded(f32::from_bits(middle)) < step { below = middle } else { at = middle }
    }
    f32::from_bits(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_gives_the_same_as_the_curve() {
        let curve_u8 = curve_u8();
        for i in 0..200_000 {
            let v = vitrine_math::hash::unit(vitrine_math::hash::mix(i)) * 1.01;
            assert_eq!(curve_u8(v), rounded(v), "{v}");
        }
        // Around the ends of every step and cell, where the table could be off by one.
        let cells = (FIRST..=LAST).map(|cell| f32::from_bits(cell << SHIFT));
        let ends = STEPS.least[1..256].iter().copied().chain(cells);
        for end in ends {
            for bits in end.to_bits() - 20..end.to_bits() + 20 {
                let v = f32::from_bits(bits);
                assert_eq!(curve_u8(v), rounded(v), "{v}");
            }
        }
        for v in [0.0, -0.0, -1.0, 1.0, 2.0, 1e-45, 1e30, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(curve_u8(v), rounded(v), "{v}");
        }
    }
}
