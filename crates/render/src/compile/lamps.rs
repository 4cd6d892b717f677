//! What shines: every light as it is, and what the classic renderer takes it for, which knows bulbs, discs, sunlight and light
//! that is everywhere alike.

use super::{CompiledLight, limits};
use crate::error::CompileError;
use vitrine_math::{Rgb, black_body_color};
use vitrine_scene::lights::Emission;
use vitrine_scene::{Assets, Scene};

/// The share of a sky's light that comes from the sun, if that is up, in the classic renderer.
const SUN_SHARE: f32 = 0.75;

/// The lights that are on: how each shines, its radiance, its place in the scene's list.
///
/// # Errors
/// [`CompileError::MissingPanorama`].
pub fn emissions(scene: &Scene, assets: &Assets) -> Result<Vec<(Emission, Rgb, usize)>, CompileError> {
    let mut emissions = Vec::new();
    for (index, light) in scene.lights.iter().enumerate().filter(|(_, l)| l.visible && l.intensity > 0.0) {
        let missing = || CompileError::MissingPanorama { light: light.name.clone() };
        let emission = light.source.as_kind().emission(assets).ok_or_else(missing)?;
        emissions.push((limits::drawn_in(emission), limits::dimmed(light.radiance()), index));
    }
    Ok(emissions)
}

/// The lamps that the classic renderer knows, and the sum of all light that is everywhere.
pub fn classic(emissions: &[(Emission, Rgb, usize)]) -> (Vec<CompiledLight>, Rgb) {
    let (mut lamps, mut ambient) = (Vec::new(), Rgb::BLACK);
    for (emission, radiance, _) in emissions {
        let mut lamp = |emission, radiance| lamps.push(CompiledLight { emission, radiance });
        match emission {
            Emission::Everywhere => ambient += *radiance,
            Emission::Environment { map, .. } => ambient += *radiance * map.mean(),
            Emission::Sky { to_sun, sun, .. } => {
                // A low sun is red: as warm as a bulb on the horizon.
                let height = to_sun.y.clamp(0.0, 1.0);
                let sun_share = if *sun && to_sun.y > 0.0 { SUN_SHARE } else { 0.0 };
                if sun_share > 0.0 {
                    let color = black_body_color(2500.0 + 3500.0 * height.sqrt());
                    let travels = -*to_sun;
                    lamp(Emission::Direction { travels }, *radiance * color * sun_share);
                }
                ambient += *radiance * black_body_color(12_000.0) * (1.0 - SUN_SHARE);
            }
            Emission::Sphere { position, radius } => {
                lamp(Emission::Disc { position: *position, radius: *radius }, *radiance);
            }
            other => lamp(other.clone(), *radiance),
        }
    }
    (lamps, ambient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use vitrine_math::Vec3;
    use vitrine_scene::lights::Environment;
    use vitrine_scene::{Light, LightSource, RadianceMap};

    fn of(emission: Emission) -> (Vec<CompiledLight>, Rgb) {
        classic(&[(emission, Rgb::new(2.0, 1.0, 0.5), 0)])
    }

    #[test]
    fn a_ball_is_a_disc_and_a_panorama_its_mean() {
        let (lamps, ambient) = of(Emission::Sphere { position: Vec3::X, radius: 0.5 });
        assert_eq!(lamps[0].emission, Emission::Disc { position: Vec3::X, radius: 0.5 });
        assert_eq!(ambient, Rgb::BLACK);
        let map = Arc::new(RadianceMap { size: [2, 1], pixels: vec![Rgb::WHITE, Rgb::splat(3.0)] });
        let (lamps, ambient) = of(Emission::Environment { map, turn: 1.0 });
        assert_eq!((lamps.len(), ambient), (0, Rgb::new(4.0, 2.0, 1.0)));
    }

    #[test]
    fn a_sky_is_sunlight_and_ambient_light_and_after_sunset_the_latter_alone() {
        let sky = |y: f32, sun| {
            of(Emission::Sky { to_sun: Vec3::new(1.0, y, 0.0).normalize(), turbidity: 3.0, sun })
        };
        let (lamps, ambient) = sky(1.0, true);
        assert!(matches!(lamps[0].emission, Emission::Direction { travels } if travels.y < 0.0));
        assert!(ambient.luminance() > 0.0 && lamps[0].radiance.luminance() > ambient.luminance());
        assert_eq!([sky(1.0, false).0.len(), sky(-0.05, true).0.len()], [0, 0]);
    }

    #[test]
    fn a_missing_panorama_names_its_light() {
        let source = LightSource::Environment(Environment::default());
        let light = Light { name: "street".into(), source, ..Light::default() };
        let scene = Scene { lights: vec![Light::default(), light], ..Scene::default() };
        let error = emissions(&scene, &Assets::default()).unwrap_err();
        assert_eq!(error, CompileError::MissingPanorama { light: "street".into() });
    }
}
