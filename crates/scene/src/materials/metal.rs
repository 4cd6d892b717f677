//! Metals by their measured index of refraction. The measurements and their sources stand in [`vitrine_optics::metals`].
//!
//! ```toml
//! [[material]]
//! name = "ring"
//! metal = "gold"
//! specular_roughness = 0.2
//! ```

use vitrine_math::Rgb;
use vitrine_optics::fresnel;
use vitrine_optics::metals::MeasuredMetal;

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
    /// Its index n and its extinction k, as red, green and blue see them.
    #[must_use]
    pub fn index(self) -> (Rgb, Rgb) {
        match self {
            Self::Gold => MeasuredMetal::Gold,
            Self::Copper => MeasuredMetal::Copper,
            Self::Silver => MeasuredMetal::Silver,
            Self::Aluminium => MeasuredMetal::Aluminium,
            Self::Chrome => MeasuredMetal::Chrome,
        }
        .index()
    }

    /// What it reflects head-on, its colour.
    #[must_use]
    pub fn color(self) -> Rgb {
        let (n, k) = self.index();
        fresnel::conductor(1.0, n, k)
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
