//! Where in and around its pixel a sample lies: the pixel filter, by importance sampling. So every sample counts the same, and a film
//! only adds.
//!
//! The filter is a Gaussian of a standard deviation of 0.5 pixels, cut off at 1.5 (Ernst, Stamminger and Greiner, "Filter Importance
//! Sampling", 2006).

use std::sync::LazyLock;

/// Nothing beyond counts, pixels from the middle.
const RADIUS: f32 = 1.5;
/// Of the Gaussian, pixels.
const SIGMA: f32 = 0.5;
/// Steps of the inverted table.
const STEPS: usize = 1024;

/// Offsets for evenly spaced shares of the filter's weight.
static INVERSE: LazyLock<[f32; STEPS + 1]> = LazyLock::new(|| {
    // Each by bisection of the share to the left of x: (1 + erf(x/(σ√2))/erf(r/(σ√2)))/2.
    let whole = libm::erf(f64::from(RADIUS / (SIGMA * std::f32::consts::SQRT_2)));
    let share = |x: f64| 0.5 * (1.0 + libm::erf(x / f64::from(SIGMA * std::f32::consts::SQRT_2)) / whole);
    std::array::from_fn(|i| {
        let wanted = i as f64 / STEPS as f64;
        let (mut low, mut high) = (-f64::from(RADIUS), f64::from(RADIUS));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if share(middle) < wanted { low = middle } else { high = middle }
        }
        (0.5 * (low + high)) as f32
    })
});

/// The offset of a sample from the middle of its pixel, in pixels, for numbers in [0, 1).
#[inline]
#[must_use]
pub fn offset(u: [f32; 2]) -> [f32; 2] {
    let inverse = &*INVERSE;
    let along = |u: f32| {
        let at = u * STEPS as f32;
        let i = (at as usize).min(STEPS - 1);
        let f = at - i as f32;
        inverse[i] * (1.0 - f) + inverse[i + 1] * f
    };
    [along(u[0]), along(u[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_have_the_filters_spread() {
        let all: Vec<f32> = (0..10_000).map(|i| offset([(i as f32 + 0.5) / 10_000.0, 0.5])[0]).collect();
        let mean: f32 = all.iter().sum::<f32>() / 10_000.0;
        let variance: f32 = all.iter().map(|x| x * x).sum::<f32>() / 10_000.0;
        assert!(mean.abs() < 1e-4);
        // σ²·(1 − 2r·φ(r)/(2Φ(r) − 1)) with r = 3: what is cut off takes 2.7 % of it.
        assert!((variance - 0.25 * 0.973_3).abs() < 1e-3, "{variance}");
        assert!(all.iter().all(|x| x.abs() <= RADIUS));
        assert!(all.is_sorted());
    }
}
