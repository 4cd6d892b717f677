//! Metals by their measured index of refraction, n + ik, as red, green and blue see it.
//!
//! Gold, copper, silver: Johnson and Christy, Physical Review B 6 (1972). Chrome: the same, Physical Review B 9 (1974).
//! Aluminium: Rakić, Applied Optics 34 (1995). Their spectra are averaged with the responses of Rec. 709's red, green and
//! blue to light of even power as weights.
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
            Self::Gold => Rgb::new(0.108, 0.488, 1.478),
            Self::Copper => Rgb::new(0.237, 1.037, 1.298),
            Self::Silver => Rgb::new(0.055, 0.055, 0.043),
            Self::Aluminium => Rgb::new(1.441, 0.988, 0.585),
            Self::Chrome => Rgb::new(3.224, 3.117, 2.256),
        }
    }

    /// The imaginary part of its index, the extinction k.
    #[must_use]
    pub const fn k(self) -> Rgb {
        match self {
            Self::Gold => Rgb::new(3.508, 2.338, 1.809),
            Self::Copper => Rgb::new(3.244, 2.601, 2.353),
            Self::Silver => Rgb::new(4.293, 3.543, 2.535),
            Self::Aluminium => Rgb::new(7.557, 6.566, 5.307),
            Self::Chrome => Rgb::new(3.291, 3.339, 3.114),
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
        // Linear Rec. 709 reflectances head-on as tables for artists give them; their silver is a little tarnished.
        let table = [
            (Metal::Gold, [1.0, 0.78, 0.34]),
            (Metal::Copper, [0.955, 0.638, 0.538]),
            (Metal::Silver, [0.972, 0.960, 0.915]),
            (Metal::Aluminium, [0.913, 0.922, 0.924]),
            (Metal::Chrome, [0.550, 0.556, 0.554]),
        ];
        for (metal, published) in table {
            for (channel, published) in metal.color().to_array().into_iter().zip(published) {
                assert!((channel - published).abs() < 0.065, "{metal:?}: {channel} against {published}");
            }
        }
    }
}
