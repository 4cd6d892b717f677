//! The choice between lights with a place and distant light, and among few lights.

use super::tree::Cut;

/// Up to here lights with a place are looked at one by one.
pub const FEW: usize = 16;
/// Lights with a place and distant light have at least this share of the choice each, where there are both.
const LEAST_SHARE: f32 = 0.1;

/// What the choice of a light goes by: about what lights bring, as irradiances.
pub struct Weights {
    /// Those that have a place.
    pub local: Local,
    /// All distant light.
    pub distant: f32,
}

/// What the choice among lights with a place goes by.
#[expect(clippy::large_enum_variant, reason = "it lives on the stack, for one choice")]
pub enum Local {
    /// There is one, and nothing else: it is chosen always.
    Only,
    /// What each of few brings, and the sum.
    Each([f32; FEW], f32),
    /// What groups of many bring.
    Cut(Cut),
}

impl Weights {
    /// The probability that distant light is chosen. None where nothing arrives.
    #[inline]
    pub fn distant_share(&self) -> Option<f32> {
        let local = match &self.local {
            Local::Only => 1.0,
            Local::Each(_, sum) => *sum,
            Local::Cut(cut) => cut.sum,
        };
        match (local > 0.0, self.distant > 0.0) {
            (false, false) => None,
            (true, false) => Some(0.0),
            (false, true) => Some(1.0),
            (true, true) => {
                let share = self.distant / (local + self.distant);
                Some(LEAST_SHARE + (1.0 - 2.0 * LEAST_SHARE) * share)
            }
        }
    }
}

impl Local {
    /// Chooses one of few lights; gives its probability.
    #[inline]
    pub fn choose(&self, u: f32) -> Option<(u32, f32)> {
        let Self::Each(each, sum) = self else { return Some((0, 1.0)) };
        let mut rest = u * sum;
        let mut last = None;
        for (light, &weight) in (0..).zip(each).filter(|(_, weight)| **weight > 0.0) {
            last = Some((light, weight / sum));
            if rest < weight {
                break;
            }
            rest -= weight;
        }
        last
    }

    /// The probability with which one of few lights is chosen.
    #[inline]
    pub fn probability(&self, light: u32) -> f32 {
        match self {
            Self::Each(each, sum) if *sum > 0.0 => each[light as usize] / sum,
            Self::Each(..) => 0.0,
            Self::Only | Self::Cut(_) => 1.0,
        }
    }
}
