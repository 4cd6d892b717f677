//! Scenes built in code, and pictures of them.

use std::path::PathBuf;
use std::sync::Arc;
use vitrine_film::{Image, Region};
pub use vitrine_math::{Rgb, Vec3};
use vitrine_render::{Cancel, CompiledScene, RenderJob, RenderOptions, Rendered, compile};
use vitrine_scene::lights::{Ambient, Directional, Disc, Point};
use vitrine_scene::shapes::{self, Cuboid, Mesh, Plane, Sphere, Triangle};
use vitrine_scene::{
    Assets, Camera, Light, LightSource, Material, Object, Renderer, Scene, Settings, Shape, Texture,
    TextureSource, TriangleMesh,
};

/// A point or a direction.
pub const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A scene with what it takes from files. Black background, no light, one sample a pixel.
#[derive(Clone, Debug)]
pub struct Shot {
    pub scene: Scene,
    pub assets: Assets,
}

impl Shot {
    /// A picture of that many pixels by a camera at a point that looks at another.
    pub fn new(size: [u32; 2], position: Vec3, look_at: Vec3) -> Self {
        let settings = Settings { size, background: Rgb::BLACK, ..Settings::default() };
        let camera = Camera { position, look_at: Some(look_at), ..Camera::default() };
        Self { scene: Scene { settings, camera, ..Scene::default() }, assets: Assets::default() }
    }

    /// One pixel, exactly in the direction of a point.
    pub fn probe(position: Vec3, look_at: Vec3) -> Self {
        Self::new([1, 1], position, look_at)
    }

    /// Adds an object; further changes go through the reference.
    pub fn put(&mut self, shape: Shape, material: Material) -> &mut Object {
        let name = format!("material {}", self.scene.materials.len());
        self.scene.materials.push(Material { name: name.clone(), ..material });
        let object = self.put_plain(shape);
        object.material = Some(name);
        object
    }

    /// Adds an object without a material of the scene's.
    pub fn put_plain(&mut self, shape: Shape) -> &mut Object {
        let name = format!("object {}", self.scene.objects.len());
        self.scene.objects.push(Object { name, shape, ..Object::default() });
        self.scene.objects.last_mut().expect("just added")
    }

    /// A shape that is this model.
    pub fn model(&mut self, mesh: TriangleMesh) -> Shape {
        let file = format!("model {}.obj", self.assets.meshes.len());
        self.assets.meshes.insert(PathBuf::from(&file), Arc::new(mesh));
        Shape::Mesh(Mesh { file, ..Mesh::default() })
    }

    /// Adds a texture and gives its name.
    pub fn texture(&mut self, source: TextureSource) -> String {
        let name = format!("texture {}", self.scene.textures.len());
        self.scene.textures.push(Texture { name: name.clone(), source, ..Texture::default() });
        name
    }

    /// Adds a light.
    pub fn light(&mut self, source: LightSource, intensity: f32) -> &mut Light {
        let name = format!("light {}", self.scene.lights.len());
        self.scene.lights.push(Light { name, source, intensity, ..Light::default() });
        self.scene.lights.last_mut().expect("just added")
    }

    pub fn ambient(&mut self, intensity: f32) -> &mut Light {
        self.light(LightSource::Ambient(Ambient {}), intensity)
    }

    pub fn point(&mut self, position: Vec3, intensity: f32) -> &mut Light {
        self.light(LightSource::Point(Point { position }), intensity)
    }

    pub fn sun(&mut self, direction: Vec3, intensity: f32) -> &mut Light {
        self.light(LightSource::Directional(Directional { direction }), intensity)
    }

    pub fn disc(&mut self, position: Vec3, radius: f32, intensity: f32) -> &mut Light {
        self.light(LightSource::Disc(Disc { position, radius }), intensity)
    }

    pub fn compiled(&self) -> CompiledScene {
        compile(&self.scene, &self.assets).expect("the scene compiles")
    }

    pub fn options(&self) -> RenderOptions {
        RenderOptions { settings: self.scene.settings.clone(), region: None }
    }

    /// Everything that a job gives back.
    pub fn rendered(&self, threads: usize, region: Option<Region>) -> Rendered {
        run(&self.compiled(), RenderOptions { region, ..self.options() }, threads)
    }

    /// The picture.
    pub fn picture(&self) -> Image {
        self.rendered(2, None).film.image()
    }

    /// The picture's only pixel, or its first.
    pub fn pixel(&self) -> Rgb {
        let region = Region { x: 0, y: 0, width: 1, height: 1 };
        self.rendered(1, Some(region)).film.image().pixel(0, 0)
    }

    /// What the camera sees in the direction of a point.
    pub fn look(&self, position: Vec3, look_at: Vec3) -> Rgb {
        let mut shot = self.clone();
        shot.scene.settings.size = [1, 1];
        shot.scene.camera.position = position;
        shot.scene.camera.look_at = Some(look_at);
        shot.pixel()
    }

    /// The same scene by ray casting.
    pub fn cast(&self) -> Self {
        let mut shot = self.clone();
        shot.scene.settings.renderer = Renderer::Cast;
        shot
    }
}

/// A job from start to end.
pub fn run(scene: &CompiledScene, options: RenderOptions, threads: usize) -> Rendered {
    RenderJob::new(scene, options).expect("the job can start").run(threads, &Cancel::default(), &mut |_| {})
}

pub fn ball(radius: f32) -> Shape {
    Shape::Sphere(Sphere { radius })
}

pub fn cuboid(size: Vec3) -> Shape {
    Shape::Box(Cuboid { size })
}

pub fn plane() -> Shape {
    Shape::Plane(Plane {})
}

pub fn disc(radius: f32) -> Shape {
    Shape::Disc(shapes::Disc { radius })
}

pub fn triangle(points: [Vec3; 3]) -> Shape {
    Shape::Triangle(Triangle { points, ..Triangle::default() })
}

/// Scatters evenly, with k_d = 1, and does nothing else.
pub fn matte(color: Rgb) -> Material {
    Material { color: Some(color), diffuse: Some(1.0), ..Material::default() }
}

/// Shows its colour wherever there is ambient light of intensity 1, whatever other lights there are.
pub fn flat(color: Rgb) -> Material {
    Material { color: Some(color), diffuse: Some(0.0), ..Material::default() }
}

/// A flat colour through which the rest is seen.
pub fn glass(color: Rgb, transparency: f32) -> Material {
    Material { transparency: Some(transparency), ..flat(color) }
}

/// A flat colour with a mirror image over it.
pub fn mirror(color: Rgb, reflectivity: f32) -> Material {
    Material { reflectivity: Some(reflectivity), ..flat(color) }
}

pub const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);
pub const GREEN: Rgb = Rgb::new(0.0, 1.0, 0.0);
pub const BLUE: Rgb = Rgb::new(0.0, 0.0, 1.0);

/// Numbers that look random and are always the same.
pub struct Dice(pub u32);

impl Dice {
    /// From 0 to 1.
    pub fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(1);
        vitrine_math::hash::unit(vitrine_math::hash::mix(self.0))
    }

    pub fn between(&mut self, from: f32, to: f32) -> f32 {
        from + (to - from) * self.unit()
    }

    /// Each component from −1 to 1.
    pub fn vector(&mut self) -> Vec3 {
        v(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.vector();
            if v.length_squared() > 0.01 && v.length_squared() < 1.0 {
                return v.normalize();
            }
        }
    }

    pub fn color(&mut self) -> Rgb {
        Rgb::new(self.unit(), self.unit(), self.unit())
    }
}

/// The greatest difference of a channel.
pub fn distance(a: Rgb, b: Rgb) -> f32 {
    let (a, b) = (a.to_array(), b.to_array());
    (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f32::max)
}

/// Fails unless all channels are that near.
#[track_caller]
pub fn assert_near(seen: Rgb, truth: Rgb, allowed: f32) {
    let off = distance(seen, truth);
    assert!(off <= allowed, "{seen:?} in place of {truth:?}: off by {off}");
}
