//! The truth to compare with: recursive ray tracing as the course work writes it down, in double precision, without a tree,
//! packets, waves or weights. It shares no code with the renderer and is far too slow for pictures.

mod forms;
mod vector;

use forms::Thing;
pub use vector::{D3, turned};
use vitrine_scene::lights::Emission;
use vitrine_scene::{Assets, Camera, ClassicMaterial, Scene};

/// A scene in double precision.
pub struct Oracle {
    things: Vec<Thing>,
    lamps: Vec<(Emission, D3)>,
    ambient: D3,
    background: D3,
    camera: Camera,
    size: [u32; 2],
    depth: u32,
}

/// A ray after a distance.
#[derive(Clone, Copy)]
struct Way {
    o: D3,
    d: D3,
    after: f64,
}

impl Oracle {
    /// Textures and groups are beyond it.
    pub fn new(scene: &Scene, assets: &Assets) -> Self {
        let mut lamps = Vec::new();
        let mut ambient = D3::default();
        for light in scene.lights.iter().filter(|l| l.visible) {
            let radiance = D3::of_color(light.color) * f64::from(light.intensity);
            match light.source.as_kind().emission(assets).expect("no panorama is missing") {
                Emission::Everywhere => ambient = ambient + radiance,
                emission => lamps.push((emission, radiance)),
            }
        }
        Self {
            things: scene
                .objects
                .iter()
                .filter(|o| o.visible)
                .map(|o| Thing::new(o, scene, assets))
                .collect(),
            lamps,
            ambient,
            background: D3::of_color(scene.settings.background),
            camera: scene.camera.clone(),
            size: scene.settings.size,
            depth: scene.settings.depth,
        }
    }

    /// The colour at a point of the picture, in pixels from its upper left corner.
    pub fn at(&self, x: f64, y: f64) -> D3 {
        self.see(Way { o: D3::of(self.camera.position), d: self.direction(x, y), after: 0.0 }, self.depth)
    }

    /// Not turned, the camera looks along −Z with Y up; the angle spans the picture's height; pixels are square.
    pub fn direction(&self, x: f64, y: f64) -> D3 {
        let [w, h] = self.size.map(f64::from);
        let half = (f64::from(self.camera.view_angle_deg).to_radians() * 0.5).tan();
        let (right, up) = ((x - 0.5 * w) / (0.5 * h) * half, (0.5 * h - y) / (0.5 * h) * half);
        match self.camera.look_at {
            Some(target) => {
                let forward = (D3::of(target) - D3::of(self.camera.position)).unit();
                let across = forward.cross(D3::new(0.0, 1.0, 0.0)).unit();
                (forward + across * right + across.cross(forward) * up).unit()
            }
            None => turned(D3::new(right, up, -1.0), self.camera.turn_deg.unwrap_or_default()).unit(),
        }
    }

    fn nearest(&self, way: &Way) -> Option<(f64, D3, &ClassicMaterial)> {
        let mut best: Option<(f64, D3, &ClassicMaterial)> = None;
        for thing in &self.things {
            for (t, n) in thing.crossings(way.o, way.d) {
                if t > way.after && best.as_ref().is_none_or(|b| t < b.0) {
                    best = Some((t, n, &thing.material));
                }
            }
        }
        best
    }

    /// C = α·((1 − r)·A + r·mirrored) + (1 − α)·behind
    fn see(&self, way: Way, depth: u32) -> D3 {
        let Some((t, outward, m)) = self.nearest(&way) else { return self.background };
        let p = way.o + way.d * t;
        let is_outside = outward.dot(way.d) < 0.0;
        let n = if is_outside { outward } else { -outward };
        let (alpha, r) = (1.0 - f64::from(m.transparency), f64::from(m.reflectivity));
        let r = if depth == 0 { 0.0 } else { r };
        let mut color = D3::default();
        if alpha * (1.0 - r) > 0.0 {
            color = color + self.lit(p, n, -way.d, m) * (alpha * (1.0 - r));
        }
        if alpha * r > 0.0 {
            let mirrored = self.leaving(p, way.d - n * (2.0 * n.dot(way.d)));
            color = color + self.see(mirrored, depth - 1) * (alpha * r);
        }
        if alpha < 1.0 {
            let index = f64::from(m.refraction);
            let onward = if index == 1.0 {
                Way { after: t * (1.0 + 1e-12) + 1e-9, ..way }
            } else {
                self.bent(p, n, way.d, if is_outside { index } else { 1.0 / index })
            };
            color = color + self.see(onward, depth) * (1.0 - alpha);
        }
        color
    }

    fn leaving(&self, p: D3, d: D3) -> Way {
        Way { o: p, d: d.unit(), after: 1e-9 * (1.0 + p.length()) }
    }

    /// Snell's law; a mirror beyond the critical angle.
    fn bent(&self, p: D3, n: D3, d: D3, index: f64) -> Way {
        let cos_i = -n.dot(d);
        let sin2 = (1.0 - cos_i * cos_i) / (index * index);
        if sin2 >= 1.0 {
            return self.leaving(p, d + n * (2.0 * cos_i));
        }
        self.leaving(p, (d + n * cos_i) * (1.0 / index) - n * (1.0 - sin2).sqrt())
    }

    /// I = I_A + Σ I_m·k_d·max(0, ⟨N, L⟩) + Σ I_m·k_s·max(0, ⟨R, V⟩)^s; the colour tints all but the highlight.
    fn lit(&self, p: D3, n: D3, wo: D3, m: &ClassicMaterial) -> D3 {
        let color = D3::of_color(m.color);
        let mut sum = self.ambient.times(color);
        for (emission, radiance) in &self.lamps {
            let (l, distance) = match emission {
                Emission::Direction { travels } => ((-D3::of(*travels)).unit(), f64::INFINITY),
                Emission::Point { position } => {
                    let to = D3::of(*position) - p;
                    (to.unit(), to.length())
                }
                other => panic!("the oracle knows no lamp such as {other:?}"),
            };
            let cos = n.dot(l);
            if cos <= 0.0 {
                continue;
            }
            let r = n * (2.0 * cos) - l;
            let highlight = f64::from(m.specular) * r.dot(wo).max(0.0).powf(f64::from(m.shininess));
            let scattered = color * (f64::from(m.diffuse) * cos);
            let passes = self.passes(self.leaving(p, l), distance);
            sum = sum + radiance.times(scattered + D3::new(highlight, highlight, highlight)) * passes;
        }
        sum
    }

    /// Every surface on the way lets its transparency through.
    fn passes(&self, way: Way, distance: f64) -> f64 {
        let mut passes = 1.0;
        for thing in &self.things {
            for (t, _) in thing.crossings(way.o, way.d) {
                if t > way.after && t < distance {
                    passes *= f64::from(thing.material.transparency);
                }
            }
        }
        passes
    }
}
