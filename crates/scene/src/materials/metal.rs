//! Metals by their measured index of refraction, n + ik, as red, green and blue see it.
//!
//! Gold, copper, silver: Johnson and Christy, Physical Review B 6 (1972). Aluminium, chrome: Rakić et al., Applied Optics
//! 37 (1998). The spectra are weighted by Rec. 709's primaries.
//!
//! ```toml
//! [[material]]
//! name = "ring"
//! metal = "gold"
//! specular_roughness = 0.2
//! ```

use vitrine_math::Rgb;

crate::choices! {
    /// A metal that is known by its index of refraction.
    pub enum Metal {
        /// Warm yellow.
        Gold = "gold",
        /// Reddish.
        Copper = "copper",
        /// The whitest.
        Silver = "silver",
        /// White, a little dimmer than silver.
        Aluminium = "aluminium",
        /// Grey and bluish.
        Chrome = "chrome",
    }
}

impl Metal {
    /// The real part of its index, n.
    #[must_use]
    pub const fn eta(self) -> Rgb {
        match self {
            Self::Gold => Rgb::new(0.143, 0.375, 1.442),
            Self::Copper => Rgb::new(0.200, 0.924, 1.102),
            Self::Silver => Rgb::new(0.155, 0.117, 0.138),
            Self::Aluminium => Rgb::new(1.657, 0.880, 0.521),
            Self::Chrome => Rgb::new(4.370, 2.917, 1.655),
        }
    }

    /// The imaginary part of its index, the extinction k.
    #[must_use]
    pub const fn k(self) -> Rgb {
        match self {
            Self::Gold => Rgb::new(3.983, 2.386, 1.603),
            Self::Copper => Rgb::new(3.913, 2.453, 2.142),
            Self::Silver => Rgb::new(4.828, 3.122, 2.147),
            Self::Aluminium => Rgb::new(9.224, 6.270, 4.837),
            Self::Chrome => Rgb::new(5.206, 4.231, 3.755),
        }
    }

    /// What it reflects head-on, its colour.
    #[must_use]
    pub fn color(self) -> Rgb {
        // F₀ = ((n − 1)² + k²) / ((n + 1)² + k²)
        let f0 = |n: f32, k: f32| ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
        let (n, k) = (self.eta(), self.k());
        Rgb::new(f0(n.r, k.r), f0(n.g, k.g), f0(n.b, k.b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metals_have_their_published_colours() {
        // Linear Rec. 709 reflectances at normal incidence as tables for artists give them.
        let table = [
            (Metal::Gold, [1.0, 0.78, 0.34]),
            (Metal::Copper, [0.955, 0.638, 0.538]),
            (Metal::Silver, [0.972, 0.960, 0.915]),
            (Metal::Aluminium, [0.913, 0.922, 0.924]),
            (Metal::Chrome, [0.550, 0.556, 0.554]),
        ];
        for (metal, published) in table {
            for (channel, published) in metal.color().to_array().into_iter().zip(published) {
                assert!((channel - published).abs() < 0.035, "{metal:?}: {channel} against {published}");
            }
        }
    }
}
