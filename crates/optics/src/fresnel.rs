//! How much a dielectric reflects.

/// The reflectance at normal incidence, F₀ = ((n−1)/(n+1))². `eta` is the index inside over the index outside.
#[must_use]
pub fn normal_reflectance(eta: f32) -> f32 {
    let r = (eta - 1.0) / (eta + 1.0);
    r * r
}

#[cfg(test)]
mod tests {
    use super::normal_reflectance;

    #[test]
    fn glass_and_water_have_their_textbook_values() {
        assert!((normal_reflectance(1.5) - 0.04).abs() < 1e-7);
        assert!((normal_reflectance(1.33) - 0.02006).abs() < 1e-5);
    }
}
