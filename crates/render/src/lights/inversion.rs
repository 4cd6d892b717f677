//! The choice of one of many by their weights: the sums of weights up to each, and a search in them.

/// Sums of weights, from 0 to 1.
#[derive(Clone, Debug)]
pub struct Inversion {
    sums: Vec<f32>,
}

impl Inversion {
    /// By weights that are finite and not negative; all alike where all are 0.
    pub fn new(weights: &[f32]) -> Self {
        // f64: rounding must not add up over thousands of weights.
        let whole: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
        let share = |i: usize, sum: f64| {
            if whole > 0.0 { sum / whole } else { i as f64 / weights.len() as f64 }
        };
        let mut sum = 0.0;
        let mut sums = vec![0.0; weights.len() + 1];
        for (i, &weight) in weights.iter().enumerate() {
            sum += f64::from(weight);
            sums[i + 1] = share(i + 1, sum) as f32;
        }
        Self { sums }
    }

    /// One of them by a number in [0, 1): its index, and where in its share the number lies, 0 to 1. Never one whose share is 0.
    #[inline]
    pub fn choose(&self, u: f32) -> (usize, f32) {
        let after = self.sums.partition_point(|&sum| sum <= u).clamp(1, self.sums.len() - 1);
        let (from, to) = (self.sums[after - 1], self.sums[after]);
        (after - 1, ((u - from) / (to - from)).clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_weights_and_what_has_none_is_never_chosen() {
        let held = Inversion::new(&[0.0, 1.0, 0.0, 3.0, 0.0]);
        for (u, index, place) in [(0.0, 1, 0.0), (0.125, 1, 0.5), (0.25, 3, 0.0), (0.625, 3, 0.5)] {
            assert_eq!(held.choose(u), (index, place), "{u}");
        }
        assert_eq!(held.choose(0.999_999_94).0, 3);
    }

    #[test]
    fn without_any_weight_all_are_alike() {
        let held = Inversion::new(&[0.0; 4]);
        assert_eq!([0.1, 0.3, 0.6, 0.9].map(|u| held.choose(u).0), [0, 1, 2, 3]);
    }
}
