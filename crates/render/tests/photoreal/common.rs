//! Scenes for measuring, and what is measured: a mean with its standard error.

pub use crate::shots::{Shot, ball, cuboid, disc, plane, run, v};
use vitrine_film::Region;
pub use vitrine_math::{Rgb, Vec3};
use vitrine_render::{CompiledScene, RenderOptions};
use vitrine_scene::lights::Sphere;
pub use vitrine_scene::{LightSource, Material, Object, Renderer, Shape};

/// Pictures are so large, and so narrow that all pixels in the middle see the same point.
const SIZE: u32 = 4096;
/// So many pixels along each edge are independent measurements of it.
const EDGE: u32 = 8;
/// By so many standard errors what is measured may differ: with these fixed seeds it does not.
const SIGMAS: f64 = 4.0;

/// A scene whose picture is one point of it.
pub fn measuring(position: Vec3, look_at: Vec3) -> Shot {
    let mut shot = Shot::new([SIZE, SIZE], position, look_at);
    shot.scene.settings.renderer = Renderer::Photoreal;
    shot.scene.camera.view_angle_deg = 1.0;
    shot
}

/// What was measured, by channel.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    pub mean: [f64; 3],
    /// The standard error of the mean.
    pub error: [f64; 3],
}

/// The light that the picture's middle shows, from so many samples in each of 64 pixels.
pub fn measure(shot: &Shot, samples: u32) -> Measured {
    measure_in(&shot.compiled(), shot, samples)
}

/// The same without connections through glass.
pub fn measure_by_chance(shot: &Shot, samples: u32) -> Measured {
    measure_in(&shot.compiled().without_connections(), shot, samples)
}

fn measure_in(scene: &CompiledScene, shot: &Shot, samples: u32) -> Measured {
    let mut settings = shot.scene.settings.clone();
    settings.samples = samples;
    let from = (SIZE - EDGE) / 2;
    let region = Region { x: from, y: from, width: EDGE, height: EDGE };
    let rendered = run(scene, RenderOptions { settings, region: Some(region) }, 1);
    assert_eq!(rendered.bad_samples, 0, "all light is a number");
    let pixels = rendered.film.image().pixels;
    let n = pixels.len() as f64;
    let values = |k: usize| pixels.iter().map(move |p| f64::from(p.to_array()[k]));
    let mean = [0, 1, 2].map(|k| values(k).sum::<f64>() / n);
    let error = [0, 1, 2]
        .map(|k| (values(k).map(|x| (x - mean[k]) * (x - mean[k])).sum::<f64>() / (n * (n - 1.0))).sqrt());
    Measured { mean, error }
}

impl Measured {
    /// Fails unless it is the truth within its error, and unless its error is below a share of the truth.
    #[track_caller]
    pub fn assert_is(&self, truth: Rgb, share: f64) {
        for (k, truth) in truth.to_array().map(f64::from).into_iter().enumerate() {
            let (mean, error) = (self.mean[k], self.error[k]);
            let rounding = 1e-4 * truth.abs().max(1e-3);
            assert!(
                (mean - truth).abs() <= SIGMAS * error + rounding,
                "channel {k}: {mean} ± {error} in place of {truth} ({:.1} σ, {:.2} %)",
                (mean - truth) / error,
                (mean / truth - 1.0) * 100.0
            );
            assert!(
                error <= share * truth.abs() + rounding,
                "channel {k}: {mean} ± {error} proves too little"
            );
        }
    }

    /// The same for a truth that is one number.
    #[track_caller]
    pub fn assert_is_grey(&self, truth: f64, share: f64) {
        self.assert_is(Rgb::splat(truth as f32), share);
    }

    /// Fails unless both measured the same, each to within a share of it.
    #[track_caller]
    pub fn assert_agrees(&self, other: &Self, share: f64) {
        for k in 0..3 {
            let (a, b) = (self.mean[k], other.mean[k]);
            let error = self.error[k].hypot(other.error[k]);
            assert!(
                (a - b).abs() <= SIGMAS * error + 1e-5 * a.abs(),
                "channel {k}: {a} ± {} and {b} ± {} ({:.1} σ, {:.2} %)",
                self.error[k],
                other.error[k],
                (a - b) / error,
                (a / b - 1.0) * 100.0
            );
            assert!(a > 0.0 && error <= share * a, "channel {k}: {a} and {b} ± {error} prove too little");
        }
    }
}

/// Scatters evenly and does nothing else.
pub fn white(albedo: f32) -> Material {
    let color = Some(Rgb::splat(albedo));
    let (base_weight, specular_weight) = (Some(1.0), Some(0.0));
    Material { base_color: color, base_weight, specular_weight, ..Material::default() }
}

/// Shines evenly and reflects nothing.
pub fn glowing(radiance: f32) -> Material {
    Material { emission_luminance: Some(radiance), base_weight: Some(0.0), ..white(0.0) }
}

/// Clear glass or water with that index.
pub fn clear(ior: f32) -> Material {
    Material { specular_ior: Some(ior), transmission_weight: Some(1.0), ..polished() }
}

/// Glass that takes this colour from light after so many metres.
pub fn tinted(ior: f32, color: Rgb, depth: f32) -> Material {
    Material { transmission_color: Some(color), transmission_depth: Some(depth), ..clear(ior) }
}

fn polished() -> Material {
    Material { specular_roughness: Some(0.0), specular_weight: Some(1.0), ..Material::default() }
}

/// The same as a solid, where its form alone would make it a sheet.
pub fn solid(material: Material) -> Material {
    Material { geometry_thin_walled: Some(false), ..material }
}

/// A bulb whose surface has that radiance.
pub fn bulb(shot: &mut Shot, position: Vec3, radius: f32, radiance: f32) {
    let source = LightSource::Sphere(Sphere { position, radius });
    shot.light(source, radiance).full_at = Some(radius);
}

/// Fresnel's equations for both polarisations, s and p, from air into the index `n`.
pub fn fresnel(cos: f64, n: f64) -> [f64; 2] {
    let cos_t = (1.0 - (1.0 - cos * cos) / (n * n)).sqrt();
    let s = (cos - n * cos_t) / (cos + n * cos_t);
    let p = (n * cos - cos_t) / (n * cos + cos_t);
    [s * s, p * p]
}
