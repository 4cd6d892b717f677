//! Scenes and helpers that the benches share.

pub mod mitsuba;
pub mod povray;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use vitrine_formats::{SceneFile, load_assets};
use vitrine_math::Vec3;
use vitrine_render::{Cancel, CompiledScene, RenderJob, RenderOptions, Rendered, compile};
use vitrine_scene::lights::{Disc, Point};
use vitrine_scene::shapes::{Mesh, Plane, Sphere};
use vitrine_scene::{Assets, Camera, Light, LightSource, Object, Scene, Settings, Shape};

/// A scene that is ready to be rendered, with its settings.
#[derive(Debug)]
pub struct Ready {
    scene: CompiledScene,
    settings: Settings,
}

impl Ready {
    /// Makes a scene ready.
    ///
    /// # Panics
    /// When the scene cannot be compiled.
    #[must_use]
    pub fn new(scene: &Scene, assets: &Assets) -> Self {
        Self {
            scene: compile(scene, assets).expect("a bench's scene compiles"),
            settings: scene.settings.clone(),
        }
    }

    /// Reads one of the example scenes, by its path below scenes/.
    ///
    /// # Panics
    /// When it cannot be read.
    #[must_use]
    pub fn example(name: &str) -> Self {
        Self::changed_example(name, |_| ())
    }

    /// The course work's benchmark without the dome of glass, which nearly all rays pass three times: in its place stands a small
    /// mirror ball, so that there are 15 balls, the ground and 642 triangles.
    ///
    /// # Panics
    /// When the scene cannot be read or has no dome.
    #[must_use]
    pub fn benchmark_without_dome() -> Self {
        Self::changed_example("coursework/benchmark.vitrine.toml", |scene| {
            let dome = scene.objects.iter_mut().find(|o| o.name == "glass dome").expect("there is a dome");
            dome.shape = Shape::Sphere(Sphere { radius: 0.3 });
            dome.position = Vec3::new(0.0, 0.3, -0.95);
            dome.material = Some("silver".into());
        })
    }

    fn changed_example(name: &str, change: impl FnOnce(&mut Scene)) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name);
        let mut scene = SceneFile::read(&path).expect("an example can be read").into_scene();
        change(&mut scene);
        let folder = path.parent().unwrap_or(Path::new("."));
        let (assets, _) = load_assets(&scene, folder).expect("an example has its assets");
        Self::new(&scene, &assets)
    }

    /// Renders it on so many threads.
    ///
    /// # Panics
    /// When the settings are no picture.
    #[must_use]
    pub fn render(&self, threads: usize) -> Rendered {
        let options = RenderOptions { settings: self.settings.clone(), region: None };
        let job = RenderJob::new(&self.scene, options).expect("a bench's settings are right");
        job.run(threads, &Cancel::default(), &mut |_| ())
    }
}

/// Balls on a floor under a disc lamp, every shadow by so many points.
#[must_use]
pub fn soft_shadows(points: u32) -> Scene {
    let mut scene = lit(LightSource::Disc(Disc { position: Vec3::new(2.0, 5.0, 3.0), radius: 1.0 }));
    scene.settings.shadow_points = points;
    scene.settings.shadow_error = 0.0;
    for i in 0..9_u8 {
        let (column, row) = (f32::from(i % 3) - 1.0, f32::from(i / 3) - 1.0);
        scene.objects.push(Object {
            name: format!("ball {i}"),
            shape: Shape::Sphere(Sphere { radius: 0.5 }),
            position: Vec3::new(1.5 * column, 0.5, 1.5 * row),
            ..Object::default()
        });
    }
    scene
}

/// A model on a floor under a bulb.
#[must_use]
pub fn model(file: &Path) -> Scene {
    let mut scene = lit(LightSource::Point(Point { position: Vec3::new(3.0, 5.0, 4.0) }));
    let shape = Shape::Mesh(Mesh { file: file.to_string_lossy().into_owned(), ..Mesh::default() });
    scene.objects.push(Object { name: "model".into(), shape, position: Vec3::Y, ..Object::default() });
    scene
}

fn lit(source: LightSource) -> Scene {
    let settings = Settings { size: [809, 817], ..Settings::default() };
    let camera = Camera {
        position: Vec3::new(0.0, 3.0, 6.0),
        look_at: Some(Vec3::new(0.0, 0.7, 0.0)),
        ..Camera::default()
    };
    let ground = Object { name: "ground".into(), shape: Shape::Plane(Plane {}), ..Object::default() };
    Scene {
        settings,
        camera,
        lights: vec![Light { source, ..Light::default() }],
        objects: vec![ground],
        ..Scene::default()
    }
}

/// Writes a ball with bumps of about so many triangles as an OBJ file into a folder; gives its path.
///
/// # Errors
/// When the file cannot be written.
pub fn write_bumpy_ball(folder: &Path, triangles: u32) -> std::io::Result<PathBuf> {
    let rows = (f64::from(triangles) / 4.0).sqrt().round().max(2.0) as u32;
    let columns = 2 * rows;
    let mut text = String::with_capacity(triangles as usize * 48);
    for row in 0..=rows {
        for column in 0..columns {
            let (latitude, longitude) = (
                std::f32::consts::PI * (row as f32 / rows as f32 - 0.5),
                std::f32::consts::TAU * column as f32 / columns as f32,
            );
            let radius = 1.0 + 0.05 * (12.0 * longitude).sin() * (10.0 * latitude).cos() * latitude.cos();
            let (x, z) = (latitude.cos() * longitude.cos(), -latitude.cos() * longitude.sin());
            let _ = writeln!(text, "v {:.6} {:.6} {:.6}", radius * x, radius * latitude.sin(), radius * z);
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let at = |r: u32, c: u32| r * columns + c % columns + 1;
            let (a, b) = (at(row, column), at(row, column + 1));
            let (c, d) = (at(row + 1, column + 1), at(row + 1, column));
            let _ = writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}");
        }
    }
    let path = folder.join(format!("ball-{triangles}.obj"));
    std::fs::write(&path, text)?;
    Ok(path)
}
