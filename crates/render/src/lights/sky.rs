//! A clear sky by day and the colour of its sun: Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999.

use std::f32::consts::{FRAC_PI_2, PI};
use std::sync::Arc;
use vitrine_math::{Rgb, Vec3, black_body_color};
use vitrine_scene::RadianceMap;

/// The size of the map: the sky is smooth.
const SIZE: [u32; 2] = [512, 256];
/// From kilocandelas per m² to radiance: a white surface that lies level shows 1 under the default sky with its sun.
const SCALE: f32 = 0.036_7;
/// The illuminance of the sun outside the air, kilolux.
const SUN_OUTSIDE: f32 = 128.0;
/// The temperature whose colour the sun has outside the air, kelvin.
const SUN_KELVIN: f32 = 5778.0;
/// What share of the light on it the ground gives back.
const GROUND: f32 = 0.2;
/// Down to this height of the sun, its sine, there is light in the sky.
const DUSK: f32 = -0.1;

/// A clear sky.
#[derive(Clone, Copy, Debug)]
pub struct SkyModel {
    /// Of unit length.
    to_sun: Vec3,
    turbidity: f32,
    /// The angle between the sun and +Y, radians; at most a right angle.
    sun_angle: f32,
}

/// The five coefficients of Perez' formula for the luminance Y and for the chromaticities x and y.
type Perez = [f32; 5];

impl SkyModel {
    /// By the direction to the sun, of unit length, and how hazy the air is, 2 to 10.
    pub fn new(to_sun: Vec3, turbidity: f32) -> Self {
        Self { to_sun, turbidity, sun_angle: libm::acosf(to_sun.y.clamp(0.0, 1.0)) }
    }

    /// The sky as a map; the ground below it gives back some of its light and of the sun's.
    pub fn map(&self, has_sun: bool) -> Arc<RadianceMap> {
        let [width, height] = SIZE;
        let mut pixels = Vec::with_capacity((width * height) as usize);
        let mut level = Rgb::BLACK;
        for row in 0..height / 2 {
            let (y, ground) = libm::sincosf(FRAC_PI_2 - PI * (row as f32 + 0.5) / height as f32);
            for column in 0..width {
                let (sin, cos) = libm::sincosf(2.0 * PI * ((column as f32 + 0.5) / width as f32 - 0.5));
                let le = self.le(Vec3::new(ground * sin, y, -ground * cos));
                // E/π = ∫ L·cosθ dω / π; a texel is (π/height)·(2π/width)·sinθ
                level += le * (y * ground * 2.0 * PI / (width * height) as f32);
                pixels.push(le);
            }
        }
        if has_sun {
            level += self.sun() * (self.to_sun.y.max(0.0) / PI);
        }
        pixels.resize((width * height) as usize, level * GROUND);
        Arc::new(RadianceMap { size: SIZE, pixels })
    }

    /// The radiance of the sky in a direction above the horizon, of unit length.
    fn le(&self, toward: Vec3) -> Rgb {
        let t = self.turbidity;
        let luminance: Perez = [
            0.1787 * t - 1.4630,
            -0.3554 * t + 0.4275,
            -0.0227 * t + 5.3251,
            0.1206 * t - 2.5771,
            -0.0670 * t + 0.3703,
        ];
        let x: Perez = [
            -0.0193 * t - 0.2592,
            -0.0665 * t + 0.0008,
            -0.0004 * t + 0.2125,
            -0.0641 * t - 0.8989,
            -0.0033 * t + 0.0452,
        ];
        let y: Perez = [
            -0.0167 * t - 0.2608,
            -0.0950 * t + 0.0092,
            -0.0079 * t + 0.2102,
            -0.0441 * t - 1.6537,
            -0.0109 * t + 0.0529,
        ];
        // A low sun's sky is that of the horizon, ever darker.
        let dusk = ((self.to_sun.y - DUSK) / -DUSK).clamp(0.0, 1.0);
        let [zenith, zenith_x, zenith_y] = self.zenith();
        let cos = toward.y.max(1e-3);
        let cos_sun = toward.dot(self.to_sun).clamp(-1.0, 1.0);
        let sun = [libm::acosf(cos_sun), cos_sun];
        let from_zenith = |perez: &Perez| {
            // (C8): value = zenith value · F(θ, γ)/F(0, θsun)
            let at_zenith = perez_formula(perez, 1.0, [self.sun_angle, libm::cosf(self.sun_angle)]);
            perez_formula(perez, cos, sun) / at_zenith
        };
        let luminance = (zenith * from_zenith(&luminance)).max(0.0) * dusk * SCALE;
        rgb_from_chromaticity(zenith_x * from_zenith(&x), zenith_y * from_zenith(&y)) * luminance
    }

    /// Luminance, kilocandelas per m², and chromaticities x and y overhead (A.2).
    fn zenith(&self) -> [f32; 3] {
        let (t, a) = (self.turbidity, self.sun_angle);
        // χ = (4/9 − T/120)(π − 2θsun)
        let chi = (4.0 / 9.0 - t / 120.0) * (PI - 2.0 * a);
        let luminance = (4.0453 * t - 4.9710) * libm::tanf(chi) - 0.2155 * t + 2.4192;
        let cubic = |[c3, c2, c1, c0]: [f32; 4]| ((c3 * a + c2) * a + c1) * a + c0;
        let chromaticity = |c: [[f32; 4]; 3]| (cubic(c[0]) * t + cubic(c[1])) * t + cubic(c[2]);
        let x = chromaticity([
            [0.001_66, -0.003_75, 0.002_09, 0.0],
            [-0.029_03, 0.063_77, -0.032_02, 0.003_94],
            [0.116_93, -0.211_96, 0.060_52, 0.258_86],
        ]);
        let y = chromaticity([
            [0.002_75, -0.006_10, 0.003_17, 0.0],
            [-0.042_14, 0.089_70, -0.041_53, 0.005_16],
            [0.153_46, -0.267_56, 0.066_70, 0.266_88],
        ]);
        [luminance.max(0.0), x, y]
    }

    /// The irradiance that the sun brings through the air to a surface that faces it; black while it is below the horizon.
    pub fn sun(&self) -> Rgb {
        if self.to_sun.y <= 0.0 {
            return Rgb::BLACK;
        }
        // Each channel by the wavelength in its middle, µm, with what ozone absorbs there, 1/cm.
        let channels = [(0.610, 0.120), (0.550, 0.085), (0.465, 0.008)];
        // The mass of the air on the way, relative to that overhead (Kasten 1966).
        let degrees = self.sun_angle.to_degrees();
        let mass = 1.0 / (self.to_sun.y + 0.15 * libm::powf(93.885 - degrees, -1.253));
        let passes = channels.map(|(um, ozone)| {
            // τ = exp(−m·(0.008735·λ^−4.08 + β·λ^−1.3 + k·l)), β = 0.04608·T − 0.04586, l = 0.35 cm (A.1)
            let rayleigh = 0.008_735 * libm::powf(um, -4.08);
            let haze = (0.046_08 * self.turbidity - 0.045_86) * libm::powf(um, -1.3);
            libm::expf(-mass * (rayleigh + haze + 0.35 * ozone))
        });
        black_body_color(SUN_KELVIN) * Rgb::from(passes) * (SUN_OUTSIDE * SCALE)
    }
}

/// F(θ, γ) = (1 + A·exp(B/cosθ))·(1 + C·exp(D·γ) + E·cos²γ): by the angle from the zenith and that from the sun with its cosine.
fn perez_formula([a, b, c, d, e]: &Perez, cos: f32, [angle, cos_sun]: [f32; 2]) -> f32 {
    (1.0 + a * libm::expf(b / cos)) * (1.0 + c * libm::expf(d * angle) + e * cos_sun * cos_sun)
}

/// The colour of luminance 1 with a chromaticity (IEC 61966-2-1's matrix); channels that no screen has are drawn in.
fn rgb_from_chromaticity(x: f32, y: f32) -> Rgb {
    let [big_x, big_z] = [x / y, (1.0 - x - y) / y];
    let rgb = Rgb::new(
        (3.240_97 * big_x - 1.537_383 - 0.498_611 * big_z).max(0.0),
        (-0.969_244 * big_x + 1.875_968 + 0.041_555 * big_z).max(0.0),
        (0.055_63 * big_x - 0.203_977 + 1.056_972 * big_z).max(0.0),
    );
    rgb / rgb.luminance()
}
