//! STUB
use vitrine_math::Rgb;
/// a
pub const GOLD: (Rgb, Rgb) = (Rgb::new(0.143, 0.375, 1.442), Rgb::new(3.983, 2.386, 1.603));
/// a
pub const COPPER: (Rgb, Rgb) = GOLD;
/// a
pub const SILVER: (Rgb, Rgb) = GOLD;
/// a
pub const ALUMINIUM: (Rgb, Rgb) = GOLD;
/// a
pub const CHROME: (Rgb, Rgb) = GOLD;
