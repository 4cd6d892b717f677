//! How the time of a ray grows with the number of triangles. A tree of n triangles is about log₂ n deep, so a line over
//! the logarithm is expected, until the triangles no longer fit into the processor's caches.

/// The numbers of triangles to measure: from 1000 on, each about three times the last, to the largest, which is the last.
#[must_use]
pub fn sizes(most: u32) -> Vec<u32> {
    let rising = (0..).map(|i| 1000.0 * 10_f64.powf(f64::from(i) / 2.0));
    let mut sizes: Vec<u32> =
        rising.map(|n| n.round() as u32).take_while(|n| f64::from(*n) < 0.9 * f64::from(most)).collect();
    sizes.push(most);
    sizes
}

/// The line that fits best, by least squares: time = base + doubling·log₂(triangles).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The time at one triangle.
    pub base: f64,
    /// What twice as many triangles add.
    pub doubling: f64,
}

impl Line {
    /// Fits the line to points (triangles, time); None when they do not differ in triangles.
    #[must_use]
    pub fn fit(points: &[(f64, f64)]) -> Option<Self> {
        let n = points.len() as f64;
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(&|p| p.0.log2()), mean(&|p| p.1));
        let spread = mean(&|p| (p.0.log2() - x).powi(2));
        let doubling = mean(&|p| (p.0.log2() - x) * (p.1 - y)) / spread;
        (spread > 0.0).then_some(Self { base: y - doubling * x, doubling })
    }

    /// The time at so many triangles.
    #[must_use]
    pub fn at(&self, triangles: f64) -> f64 {
        self.base + self.doubling * triangles.log2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_rise_to_the_largest() {
        assert_eq!(sizes(300_000), [1000, 3162, 10_000, 31_623, 100_000, 300_000]);
        assert_eq!(sizes(1000), [1000]);
        assert_eq!(*sizes(10_000_000).last().unwrap(), 10_000_000);
        assert_eq!(sizes(10_000_000).len(), 9);
    }

    #[test]
    fn a_logarithm_is_fitted_exactly_and_a_single_point_not_at_all() {
        let points = [1e3, 1e4, 1e5].map(|n: f64| (n, 20.0 + 7.0 * n.log2()));
        let line = Line::fit(&points).unwrap();
        assert!((line.base - 20.0).abs() < 1e-9 && (line.doubling - 7.0).abs() < 1e-9, "{line:?}");
        assert!((line.at(1024.0) - 90.0).abs() < 1e-9);
        assert_eq!(Line::fit(&[(5.0, 1.0)]), None);
    }
}
