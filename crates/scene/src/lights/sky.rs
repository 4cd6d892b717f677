//! The sky by day, and the sun.
//!
//! ```toml
//! [[light]]
//! name = "afternoon"
//! kind = "sky"
//! sun_elevation_deg = 30.0
//! sun_azimuth_deg = 120.0
//! turbidity = 3.0
//! ```

use super::{Emission, LightKind};
use crate::{Assets, ParamKind, Range};
use vitrine_math::Vec3;

crate::params! {
    /// A clear sky by day with its sun; the classic renderer takes it for sunlight and ambient light.
    pub struct Sky {
        /// How high the sun stands: 0 is on the horizon, 90 overhead.
        sun_elevation_deg: f32 = 45.0 => ParamKind::Number(Range::from_to(-5.0, 90.0)), Degrees;
        /// Where the sun stands, as on a compass with its north at −Z: 90 is towards +X, 180 towards +Z.
        sun_azimuth_deg: f32 = 135.0 => ParamKind::Number(Range::from_to(-360.0, 360.0)), Degrees;
        /// How hazy the air is: 2 is clear mountain air, 10 thick haze.
        turbidity: f32 = 3.0 => ParamKind::Number(Range::from_to(2.0, 10.0)), None;
        /// Whether the sun itself is there, not only the light of the sky.
        sun: bool = true => ParamKind::Flag, None;
    }
}

impl LightKind for Sky {
    fn emission(&self, _: &Assets) -> Option<Emission> {
        let (up, ahead) = libm::sincosf(self.sun_elevation_deg.to_radians());
        let (east, north) = libm::sincosf(self.sun_azimuth_deg.to_radians());
        let to_sun = Vec3::new(ahead * east, up, -ahead * north).normalize();
        Some(Emission::Sky { to_sun, turbidity: self.turbidity, sun: self.sun })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn to_sun(sun_elevation_deg: f32, sun_azimuth_deg: f32) -> Vec3 {
        let sky = Sky { sun_elevation_deg, sun_azimuth_deg, ..Sky::default() };
        match sky.emission(&Assets::default()) {
            Some(Emission::Sky { to_sun, .. }) => to_sun,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_sun_stands_where_a_compass_says() {
        assert!((to_sun(0.0, 0.0) - Vec3::NEG_Z).length() < 1e-6);
        assert!((to_sun(0.0, 90.0) - Vec3::X).length() < 1e-6);
        assert!((to_sun(90.0, 30.0) - Vec3::Y).length() < 1e-6);
        assert!(to_sun(-5.0, 30.0).y < 0.0);
    }
}
