//! Measured metals: their complex indices over the visible spectrum, and what a renderer of three channels makes of them.
//!
//! Sources, by way of the public-domain collection refractiveindex.info: gold, silver and copper from Johnson and Christy,
//! "Optical constants of the noble metals", Phys. Rev. B 6, 1972; chrome from Johnson and Christy, "Optical constants of
//! transition metals", Phys. Rev. B 9, 1974; aluminium from Rakić, "Algorithm for the determination of intrinsic optical
//! constants of metal films: application to aluminum", Applied Optics 34, 1995.

use crate::spectrum;
use vitrine_math::Rgb;

/// A metal that has been measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredMetal {
    /// Gold.
    Gold,
    /// Copper.
    Copper,
    /// Silver.
    Silver,
    /// Aluminium.
    Aluminium,
    /// Chrome.
    Chrome,
}

impl MeasuredMetal {
    /// Its index of refraction n and its absorption k, both against air, for red, green and blue: the means over the
    /// spectrum by the eye's response in linear Rec. 709.
    #[must_use]
    pub fn index(self) -> (Rgb, Rgb) {
        let (mut n, mut k) = (Rgb::BLACK, Rgb::BLACK);
        for (i, step) in spectrum::steps().iter().enumerate() {
            let (n_here, k_here) = self.at(spectrum::middle_nm(i));
            n += step.share * n_here;
            k += step.share * k_here;
        }
        (n, k)
    }

    /// n and k at a wavelength in nanometres, 380 to 780, between the neighbours that were measured.
    #[must_use]
    pub fn at(self, wavelength_nm: f32) -> (f32, f32) {
        let table = self.measured();
        let above = table.partition_point(|row| row[0] < wavelength_nm).clamp(1, table.len() - 1);
        let ([from, n0, k0], [to, n1, k1]) = (table[above - 1], table[above]);
        let t = ((wavelength_nm - from) / (to - from)).clamp(0.0, 1.0);
        (n0 + t * (n1 - n0), k0 + t * (k1 - k0))
    }

    fn measured(self) -> &'static [[f32; 3]] {
        match self {
            Self::Gold => &GOLD,
            Self::Copper => &COPPER,
            Self::Silver => &SILVER,
            Self::Aluminium => &ALUMINIUM,
            Self::Chrome => &CHROME,
        }
    }
}

/// Wavelength in nanometres, n, k.
const GOLD: [[f32; 3]; 16] = [
    [367.9, 1.48, 1.895],
    [381.5, 1.46, 1.933],
    [397.4, 1.47, 1.952],
    [413.3, 1.46, 1.958],
    [430.5, 1.45, 1.948],
    [450.9, 1.38, 1.914],
    [471.4, 1.31, 1.849],
    [495.9, 1.04, 1.833],
    [520.9, 0.62, 2.081],
    [548.6, 0.43, 2.455],
    [582.1, 0.29, 2.863],
    [616.8, 0.21, 3.272],
    [659.5, 0.14, 3.697],
    [704.5, 0.13, 4.103],
    [756.0, 0.14, 4.542],
    [821.1, 0.16, 5.083],
];

const SILVER: [[f32; 3]; 16] = [
    [367.9, 0.07, 1.657],
    [381.5, 0.05, 1.864],
    [397.4, 0.05, 2.070],
    [413.3, 0.05, 2.275],
    [430.5, 0.04, 2.462],
    [450.9, 0.04, 2.657],
    [471.4, 0.05, 2.869],
    [495.9, 0.05, 3.093],
    [520.9, 0.05, 3.324],
    [548.6, 0.06, 3.586],
    [582.1, 0.05, 3.858],
    [616.8, 0.06, 4.152],
    [659.5, 0.05, 4.483],
    [704.5, 0.04, 4.838],
    [756.0, 0.03, 5.242],
    [821.1, 0.04, 5.727],
];

const COPPER: [[f32; 3]; 16] = [
    [367.9, 1.36, 1.975],
    [381.5, 1.33, 2.045],
    [397.4, 1.32, 2.116],
    [413.3, 1.28, 2.207],
    [430.5, 1.25, 2.305],
    [450.9, 1.24, 2.397],
    [471.4, 1.25, 2.483],
    [495.9, 1.22, 2.564],
    [520.9, 1.18, 2.608],
    [548.6, 1.02, 2.577],
    [582.1, 0.70, 2.704],
    [616.8, 0.30, 3.205],
    [659.5, 0.22, 3.747],
    [704.5, 0.21, 4.205],
    [756.0, 0.24, 4.665],
    [821.1, 0.26, 5.180],
];

#[allow(clippy::approx_constant, reason = "an absorption that happens to be 3.14")]
const CHROME: [[f32; 3]; 16] = [
    [368.0, 1.87, 2.69],
    [381.0, 1.92, 2.74],
    [397.0, 2.00, 2.83],
    [413.0, 2.08, 2.93],
    [431.0, 2.19, 3.04],
    [451.0, 2.33, 3.14],
    [471.0, 2.51, 3.24],
    [496.0, 2.75, 3.30],
    [521.0, 2.94, 3.33],
    [549.0, 3.18, 3.33],
    [582.0, 3.22, 3.30],
    [617.0, 3.17, 3.30],
    [659.0, 3.09, 3.34],
    [704.0, 3.05, 3.39],
    [756.0, 3.08, 3.42],
    [821.0, 3.20, 3.48],
];

const ALUMINIUM: [[f32; 3]; 11] = [
    [364.66, 0.398_77, 4.3957],
    [413.28, 0.521_35, 5.0008],
    [442.80, 0.607_90, 5.3676],
    [476.87, 0.727_80, 5.7781],
    [516.60, 0.873_40, 6.2418],
    [563.57, 1.0728, 6.7839],
    [619.93, 1.3660, 7.4052],
    [652.25, 1.5724, 7.7354],
    [688.81, 1.8301, 8.0601],
    [729.32, 2.1606, 8.3565],
    [774.91, 2.6154, 8.4914],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fresnel::conductor;

    const ALL: [MeasuredMetal; 5] = [
        MeasuredMetal::Gold,
        MeasuredMetal::Copper,
        MeasuredMetal::Silver,
        MeasuredMetal::Aluminium,
        MeasuredMetal::Chrome,
    ];

    #[test]
    fn three_channels_reflect_what_the_spectrum_does() {
        for metal in ALL {
            let (n, k) = metal.index();
            for cos in [1.0, 0.6, 0.2] {
                let mut truth = Rgb::BLACK;
                for (i, step) in spectrum::steps().iter().enumerate() {
                    let (n, k) = metal.at(spectrum::middle_nm(i));
                    truth += step.share * conductor(cos, Rgb::splat(n), Rgb::splat(k)).g;
                }
                let ours = conductor(cos, n, k);
                for (t, o) in truth.to_array().into_iter().zip(ours.to_array()) {
                    assert!((t - o).abs() < 0.05, "{metal:?} {cos}: {truth:?} {ours:?}");
                }
            }
        }
    }

    #[test]
    fn metals_have_their_colours() {
        let facing = |metal: MeasuredMetal| {
            let (n, k) = metal.index();
            conductor(1.0, n, k)
        };
        let gold = facing(MeasuredMetal::Gold);
        assert!(gold.r > 0.9 && gold.g < 0.85 && gold.b < 0.45, "{gold:?}");
        let copper = facing(MeasuredMetal::Copper);
        assert!(copper.r > 0.88 && copper.g < 0.7 && copper.b < copper.g, "{copper:?}");
        for (metal, least) in
            [(MeasuredMetal::Silver, 0.94), (MeasuredMetal::Aluminium, 0.89), (MeasuredMetal::Chrome, 0.5)]
        {
            let f = facing(metal);
            let (low, high) = (f.r.min(f.g).min(f.b), f.r.max(f.g).max(f.b));
            assert!(low > least && high - low < 0.06, "{metal:?}: {f:?}");
        }
    }
}
