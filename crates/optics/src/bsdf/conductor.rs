//! What metals reflect: by their measured index, or by their colour.

use super::Surface;
use crate::fresnel::{self, ColoredMetal};
use crate::thin_film::Below;
use vitrine_math::Rgb;

/// The metal of a base.
#[derive(Clone, Copy, Debug)]
pub(super) enum Metal {
    /// By its index n + ik, relative to what is above it.
    Measured { n: Rgb, k: Rgb },
    /// By its colours.
    Colored(ColoredMetal),
}

impl Metal {
    /// `above` is the index of what is above it.
    pub(super) fn new(surface: &Surface, above: f32) -> Self {
        match surface.metal {
            Some((n, k)) => Self::Measured { n: n / above, k: k / above },
            None => Self::Colored(ColoredMetal::new(surface.base_color, surface.specular_color)),
        }
    }

    #[inline]
    pub(super) fn reflectance(&self, cos: f32) -> Rgb {
        match self {
            Self::Measured { n, k } => fresnel::conductor(cos, *n, *k),
            Self::Colored(metal) => metal.reflectance(cos),
        }
    }

    /// The mean over even light. A measured metal is taken for a coloured one with the same colours at 0 and 82 degrees.
    pub(super) fn average(&self) -> Rgb {
        match self {
            Self::Measured { n, k } => {
                const COS_82: f32 = 1.0 / 7.0;
                let f0 = fresnel::conductor(1.0, *n, *k);
                let plain = ColoredMetal::new(f0, Rgb::WHITE).reflectance(COS_82);
                let real = fresnel::conductor(COS_82, *n, *k);
                let tint = Rgb::new(real.r / plain.r, real.g / plain.g, real.b / plain.b);
                ColoredMetal::new(f0, tint).average()
            }
            Self::Colored(metal) => metal.average(),
        }
    }

    /// The metal as what is below a film. One that is known by its colour r gets an index with that reflectance facing us
    /// (Gulbrandsen, "Artist Friendly Metallic Fresnel", JCGT 3(4), 2014, with the edge tint 1):
    ///
    ///   n = (1 − r)/(1 + r), k² = (r(n + 1)² − (n − 1)²)/(1 − r)
    pub(super) fn below(&self) -> Below {
        match self {
            Self::Measured { n, k } => Below { n: *n, k: *k },
            Self::Colored(metal) => {
                let f0 = metal.reflectance(1.0);
                let index = |r: f32| {
                    let r = r.clamp(0.0, 0.99);
                    let n = (1.0 - r) / (1.0 + r);
                    let k2 = (r * (n + 1.0) * (n + 1.0) - (n - 1.0) * (n - 1.0)) / (1.0 - r);
                    (n, k2.max(0.0).sqrt())
                };
                let (r, g, b) = (index(f0.r), index(f0.g), index(f0.b));
                Below { n: Rgb::new(r.0, g.0, b.0), k: Rgb::new(r.1, g.1, b.1) }
            }
        }
    }
}
