//! The filter of pixels: what is near a pixel's middle counts more, and pixels reach into one another a little, so that edges are
//! smooth and free of ripples.
//!
//! Samples are not weighted but put where the filter wants them (Ernst, Stamminger and Greiner, "Filter Importance Sampling", 2006):
//! so each counts alike, and pixels share none. Axis by axis the filter is Blackman and Harris's window of four terms, which is nearly a
//! bell curve but ends (Harris, "On the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", 1978).

use std::f64::consts::PI;

/// Intervals of the table.
const STEPS: usize = 1024;

/// Places of samples around a pixel's middle.
#[derive(Clone, Debug)]
pub struct PixelFilter {
    /// The offsets at which the filter's integral has reached 0, 1/[`STEPS`], … 1; pixels.
    offsets: Vec<f32>,
}

impl PixelFilter {
    /// One that ends `radius` pixels from the middle, along each axis; 1.5 is sharp and free of ripples.
    #[must_use]
    pub fn new(radius: f32) -> Self {
        // f64: the window is tiny at its ends, where most of an interval of the table lies.
        let integral = |x: f64| {
            // w(x) = 0.35875 + 0.48829·cos(πx) + 0.14128·cos(2πx) + 0.01168·cos(3πx) for |x| ≤ 1, integrated from −1 and scaled to 1
            let terms = [0.488_29, 0.141_28, 0.011_68].into_iter().zip(1_u8..);
            let waves: f64 =
                terms.map(|(a, k)| a / (f64::from(k) * PI) * libm::sin(f64::from(k) * PI * x)).sum();
            (0.358_75 * (x + 1.0) + waves) / (2.0 * 0.358_75)
        };
        let offset = |step: usize| {
            let wanted = step as f64 / STEPS as f64;
            let (mut from, mut to) = (-1.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (from + to);
                if integral(middle) < wanted { from = middle } else { to = middle }
            }
            (0.5 * (from + to)) as f32 * radius
        };
        Self { offsets: (0..=STEPS).map(offset).collect() }
    }

    /// Where a sample lies, by a point in [0, 1)²: from the pixel's middle, pixels. Strata stay strata.
    #[inline]
    #[must_use]
    pub fn offset(&self, u: [f32; 2]) -> [f32; 2] {
        u.map(|u| {
            let place = u * STEPS as f32;
            let step = (place as usize).min(STEPS - 1);
            let (from, to) = (self.offsets[step], self.offsets[step + 1]);
            from + (to - from) * (place - step as f32)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samplers::PathSampler;

    fn offsets(radius: f32) -> Vec<[f32; 2]> {
        let filter = PixelFilter::new(radius);
        (0..1 << 14).map(|i| filter.offset(PathSampler::new([4, 2], i, 0).two(0))).collect()
    }

    #[test]
    fn the_middle_stays_the_middle_and_ends_stay_inside() {
        let filter = PixelFilter::new(1.5);
        for (u, expected) in [(0.5, 0.0), (0.0, -1.5)] {
            assert!((filter.offset([u; 2])[0] - expected).abs() < 1e-6);
        }
        assert!(filter.offset([0.999_999_94; 2])[1] <= 1.5);
        for u in [0.01, 0.2, 0.37] {
            assert!((filter.offset([u; 2])[0] + filter.offset([1.0 - u; 2])[0]).abs() < 1e-5, "even");
        }
    }

    #[test]
    fn samples_lie_as_dense_as_the_window_says() {
        // Stratified samples keep to what is expected far closer than random ones.
        let window = |x: f64| {
            let wave = |k: f64| (k * PI * x).cos();
            (0.358_75 + 0.488_29 * wave(1.0) + 0.141_28 * wave(2.0) + 0.011_68 * wave(3.0)) / 0.717_5
        };
        let offsets = offsets(1.5);
        for axis in 0..2 {
            let mut bins = [0.0_f64; 30];
            for offset in &offsets {
                bins[((offset[axis] / 1.5 + 1.0) * 15.0) as usize] += 1.0;
            }
            for (i, count) in bins.into_iter().enumerate() {
                let middles = (0..100).map(|j| (i as f64 + (f64::from(j) + 0.5) / 100.0) / 15.0 - 1.0);
                let expected = middles.map(window).sum::<f64>() / 1500.0 * offsets.len() as f64;
                // The table is straight within its steps, of which the outermost are wide.
                let tolerance = 0.02 * expected + 0.0006 * offsets.len() as f64;
                assert!((count - expected).abs() < tolerance, "bin {i}: {count}, {expected}");
            }
        }
    }

    #[test]
    fn the_filter_is_as_wide_as_its_radius_says() {
        // The variance of the window: ∫x²w/∫w = ⅓ + Σ 2·(−1)ᵏ·aₖ/(a₀·(kπ)²) = 0.07674 for radius 1.
        for radius in [1.0, 1.5, 2.0] {
            let variance: f32 =
                offsets(radius).iter().map(|[x, y]| x * x + y * y).sum::<f32>() / (2 << 14) as f32;
            assert!(
                (variance / (radius * radius) - 0.076_74).abs() < 0.0003,
                "{}",
                variance / (radius * radius)
            );
        }
    }
}
