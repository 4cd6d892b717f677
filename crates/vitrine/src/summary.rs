//! A scene in numbers: what is in it, how large it is, what will make its picture slow.

use crate::math::Bounds3;
use crate::render::{CompiledScene, RenderJob, RenderOptions};
use crate::scene::lights::LightSource;
use crate::scene::{Assets, KindSpec, Scene, Settings, Shape};
use crate::{Cancel, Error, Project};

/// How many there are of each kind, in the order of the kinds' register; kinds without any are left out.
pub type Counts = Vec<(&'static str, usize)>;

/// A scene in numbers.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Objects by shape, hidden ones included.
    pub objects: Counts,
    /// How many of the objects are hidden.
    pub hidden_objects: usize,
    /// Lights by kind, those switched off included.
    pub lights: Counts,
    /// How many of the lights are switched off.
    pub hidden_lights: usize,
    /// Triangles of everything visible; a model that is used twice counts twice.
    pub triangles: usize,
    /// The box around everything visible that has an end, metres; empty when there is nothing.
    pub bounds: Bounds3,
    /// Bytes for the geometry, the textures and the picture while it grows.
    pub memory: u64,
    /// About how many rays the picture takes.
    pub rays: u64,
    /// What will be slow, in plain words.
    pub slow: Vec<String>,
}

impl Summary {
    /// Counts and measures a project. A coarse picture is rendered to count its rays.
    ///
    /// # Errors
    /// When the scene cannot be made ready for rendering.
    pub fn of(project: &Project) -> Result<Self, Error> {
        let scene = &project.scene;
        let compiled = crate::render::compile(scene, &project.assets)?;
        let places = scene.group_places();
        let shapes = scene.objects.iter().map(|o| o.shape.kind());
        let sources = scene.lights.iter().map(|l| l.source.kind());
        Ok(Self {
            objects: count(Shape::KINDS, shapes),
            hidden_objects: scene.objects.iter().filter(|o| !places.is_seen(o)).count(),
            lights: count(LightSource::KINDS, sources),
            hidden_lights: scene.lights.iter().filter(|l| !l.visible).count(),
            triangles: compiled.triangles(),
            bounds: compiled.bounds(),
            memory: compiled.memory() as u64 + memory_beside(&project.assets, &scene.settings),
            rays: estimate_rays(&compiled, &scene.settings)?,
            slow: slow_parts(scene, compiled.triangles()),
        })
    }
}

/// About how many rays the whole picture takes: a coarse one of the same view is rendered and its rays counted.
fn estimate_rays(compiled: &CompiledScene, settings: &Settings) -> Result<u64, Error> {
    const PROBE: f64 = 64.0;
    let [width, height] = settings.size.map(f64::from);
    let shrink = (PROBE / width.max(height)).min(1.0);
    let size = [width, height].map(|v| (v * shrink).ceil().max(1.0) as u32);
    let probe = Settings { size, samples: 1, ..settings.clone() };
    let job = RenderJob::new(compiled, RenderOptions { settings: probe, region: None })?;
    let rays = job.run(0, &Cancel::default(), &mut |_| {}).rays;
    let enlarge = width * height * f64::from(settings.samples) / (f64::from(size[0]) * f64::from(size[1]));
    Ok((rays as f64 * enlarge) as u64)
}

fn count<'a>(kinds: &[KindSpec], items: impl Iterator<Item = &'a str>) -> Counts {
    let mut counts: Counts = kinds.iter().map(|kind| (kind.name, 0)).collect();
    for item in items {
        counts.iter_mut().filter(|(kind, _)| *kind == item).for_each(|(_, n)| *n += 1);
    }
    counts.retain(|(_, n)| *n > 0);
    counts
}

/// Textures, panoramas, and sum and count of each pixel.
fn memory_beside(assets: &Assets, settings: &Settings) -> u64 {
    const PIXEL_BYTES: u64 = 16;
    const RADIANCE_BYTES: u64 = 12;
    let texels: usize = assets.pictures.values().map(|p| p.texels.len()).sum();
    let radiances: usize = assets.maps.values().map(|m| m.pixels.len()).sum();
    let pixels = u64::from(settings.size[0]) * u64::from(settings.size[1]);
    3 * texels as u64 + RADIANCE_BYTES * radiances as u64 + pixels * PIXEL_BYTES
}

fn slow_parts(scene: &Scene, triangles: usize) -> Vec<String> {
    let settings = &scene.settings;
    let on = || scene.lights.iter().filter(|l| l.visible && l.intensity > 0.0);
    let discs = on().filter(|l| matches!(l.source, LightSource::Disc(_) | LightSource::Sphere(_))).count();
    let sharp = on().filter(|l| {
        matches!(l.source, LightSource::Point(_) | LightSource::Directional(_) | LightSource::Sky(_))
    });
    let sharp = sharp.count();
    let mut slow = Vec::new();
    let shadow_rays = u64::from(settings.shadow_points) * discs as u64 * u64::from(settings.samples);
    if shadow_rays > 128 {
        slow.push(format!(
            "soft shadows: {} shadow points × {} × {} = up to {shadow_rays} shadow rays for a pixel \
             (settings.shadow_points, settings.samples)",
            settings.shadow_points,
            plural(discs as u64, "disc lamp"),
            plural(u64::from(settings.samples), "sample"),
        ));
    } else if settings.samples > 16 {
        slow.push(format!("{} samples a pixel (settings.samples)", settings.samples));
    }
    if sharp > 8 {
        slow.push(format!("{sharp} lights with hard shadows: a shadow ray to each at every surface"));
    }
    if settings.depth > 6 && scene.materials.iter().any(|m| m.classic().reflectivity > 0.0) {
        slow.push(format!("mirrors in mirrors to depth {} (settings.depth)", settings.depth));
    }
    let megapixels = f64::from(settings.size[0]) * f64::from(settings.size[1]) / 1e6;
    if megapixels > 4.0 {
        slow.push(format!("a picture of {megapixels:.0} million pixels (settings.size)"));
    }
    if triangles > 1_000_000 {
        slow.push(format!("{:.1} million triangles to sort before the first ray", triangles as f64 / 1e6));
    }
    slow
}

/// "1 sample", "2 samples".
#[must_use]
pub fn plural(count: u64, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::lights::Disc;
    use crate::scene::{Light, Material, Object};

    #[test]
    fn kinds_are_counted_in_the_order_of_the_register() {
        let counts = count(Shape::KINDS, ["plane", "sphere", "plane"].into_iter());
        assert_eq!(counts, [("sphere", 1), ("plane", 2)]);
    }

    #[test]
    fn slow_parts_are_named_and_a_light_scene_has_none() {
        let disc = Light { source: LightSource::Disc(Disc::default()), ..Light::default() };
        let mirror = Material { reflectivity: Some(0.5), ..Material::default() };
        let mut scene = Scene {
            lights: vec![disc.clone(), disc],
            materials: vec![mirror],
            objects: vec![Object::default()],
            ..Scene::default()
        };
        scene.settings.shadow_points = 16;
        assert_eq!(slow_parts(&scene, 1000), [""; 0]);
        scene.settings = Settings { samples: 4, shadow_points: 64, depth: 12, ..scene.settings };
        let slow = slow_parts(&scene, 3_000_000);
        assert!(
            slow[0].contains("64 shadow points × 2 disc lamps × 4 samples = up to 512 shadow rays"),
            "{slow:?}"
        );
        assert!(slow[1].contains("depth 12") && slow[2].contains("3.0 million triangles"), "{slow:?}");
    }
}
