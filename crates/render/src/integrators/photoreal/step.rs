//! What happens to a path at its next vertex.

use super::chain::Chain;
use super::connect::{Connector, double, face_of};
use super::light::{Shining, chance_weight};
use super::media::Sides;
use super::path::{Draw, Origin, Path};
use super::polarisation::Polarisation;
use super::shadow::{Shadows, is_traceable};
use super::surface::{Dressed, dress};
use crate::accel::{Hit, HitStream, RayStream};
use crate::compile::{AIR, Solids};
use crate::integrators::TileTask;
use crate::integrators::tile::TileOrder;
use crate::surface::{Spot, Spots};
use vitrine_film::Features;
use vitrine_math::{Frame, Ray, Rgb, Vec3, offset_origin};
use vitrine_optics::bsdf::{Bsdf, BsdfSample};
use vitrine_optics::{absorption, dispersion, phase, refract};

/// From this vertex on, paths end by chance.
const ROULETTE_FROM: u32 = 4;
/// Paths go on for sure while so much of the light that arrives at their end reaches the pixel. Measured on rooms with matt walls: at 1,
/// which costs least a path, the last vertices of few paths make most of the noise.
const SURE: f32 = 0.25;
/// The least chance to go on.
const LEAST_CHANCE: f32 = 0.05;

/// What a wave's step works with.
pub struct Tools<'a, 't> {
    pub task: &'a TileTask<'t>,
    pub connector: &'a mut Connector,
    pub shadows: &'a mut Shadows,
    /// The rays of the paths that go on.
    pub onward: &'a mut RayStream,
    pub light: &'a mut [Rgb],
    pub order: &'a TileOrder,
    pub features: &'a mut [Features],
}

/// Where a path's ray has come to.
pub struct Arrival<'a> {
    pub rays: &'a RayStream,
    pub hits: &'a HitStream,
    pub spots: &'a Spots,
    pub i: usize,
    pub ray: Ray,
    pub hit: Option<Hit>,
}

/// A surface at which light is bent or scattered.
struct Meeting<'a> {
    spot: &'a Spot,
    /// The solid whose surface it is, or [`AIR`].
    solid: u16,
    sides: Sides,
    arrival: &'a Arrival<'a>,
}

/// A vertex at which a path is scattered.
pub struct Vertex<'a> {
    pub p: Vec3,
    /// The form's unit normal on the viewer's side; zero inside milky glass.
    pub n: Vec3,
    pub reach: f32,
    pub wo: Vec3,
    pub scattering: Scattering<'a>,
    pub sides: Sides,
}

/// How light is scattered there.
pub enum Scattering<'a> {
    Surface { bsdf: &'a Bsdf, frame: Frame },
    Inside { anisotropy: f32 },
}

impl Scattering<'_> {
    /// f·|cos θ| and the density of that direction.
    pub fn eval(&self, wo: Vec3, wi: Vec3) -> (Rgb, f32) {
        match self {
            Self::Surface { bsdf, frame } => bsdf.eval(frame.local(wo), frame.local(wi)),
            Self::Inside { anisotropy } => {
                // wo points back, so light that goes on has the cosine −⟨wo, wi⟩.
                let p = phase::henyey_greenstein(-wo.dot(wi), *anisotropy);
                (Rgb::splat(p), p)
            }
        }
    }
}

impl Tools<'_, '_> {
    pub fn solids(&self) -> &Solids {
        &self.task.scene.photoreal.solids
    }

    /// Takes a path on from where its ray has come to. Whether it goes on; its ray is then the last of those onward.
    pub fn take(&mut self, path: &mut Path, arrival: &Arrival) -> bool {
        let end = arrival.hit.map_or(f32::INFINITY, |hit| hit.t);
        self.meet_lamps(path, &arrival.ray, end);
        if let Some(goes_on) = self.cross_inside(path, &arrival.ray, end) {
            return goes_on;
        }
        let Some(hit) = arrival.hit else {
            self.escape(path, &arrival.ray);
            return false;
        };
        let spot = arrival.spots.get(arrival.i, hit);
        let solid = self.solids().of_primitive(hit.primitive);
        let mut sides = Sides { before: AIR, beyond: AIR, media: path.media };
        if solid == AIR {
            let top = path.media.top(self.solids());
            (sides.before, sides.beyond) = (top, top);
        } else {
            sides = path.media.across(self.solids(), solid, spot.is_outside);
            if sides.before == sides.beyond {
                return self.pass_hidden(path, arrival, &hit, sides);
            }
        }
        if path.depth == 0.0 {
            path.depth = hit.t;
        }
        let material = &self.task.scene.physical[spot.material as usize];
        let dressed = dress(self.task.scene, material, &spot, arrival);
        self.meet_emission(path, &spot, &dressed, arrival.ray.direction);
        if path.bounce + 1 >= self.task.settings.bounces {
            return false;
        }
        if solid != AIR && material.is_clear {
            self.bend(path, &Meeting { spot: &spot, solid, sides, arrival }, &dressed)
        } else {
            self.scatter(path, &Meeting { spot: &spot, solid, sides, arrival }, &dressed)
        }
    }

    /// Goes straight on through a surface that something else is in the place of.
    fn pass_hidden(&mut self, path: &mut Path, arrival: &Arrival, hit: &Hit, sides: Sides) -> bool {
        path.media = sides.media;
        path.start_t = hit.t;
        path.bounce += 1;
        let goes_on = path.bounce < self.task.settings.bounces;
        if goes_on {
            self.onward.push_on(&arrival.ray, hit);
        }
        goes_on
    }

    /// Adds light to the path's pixel.
    fn add(&mut self, path: &Path, light: Rgb) {
        self.light[path.pixel as usize] += path.beta * light;
    }

    /// Adds the light of the lamps that the ray meets on its way; they stand in the way of nothing.
    fn meet_lamps(&mut self, path: &Path, ray: &Ray, end: f32) {
        let scene = self.task.scene;
        let lights = &scene.photoreal.lights;
        if !lights.has_lamps() {
            return;
        }
        // Each one once: the search goes on behind the last.
        let mut from = path.start_t;
        loop {
            let rest = Ray { origin: ray.at(from), direction: ray.direction, t_max: end - from };
            let Some(mut lamp) = lights.intersect(&rest, end - from) else { return };
            let le = lights.le_surface(lamp.light, true);
            let step = lamp.t;
            lamp.t += from;
            let y = double(lamp.y);
            let n = (path.origin.n != Vec3::ZERO).then_some(path.origin.n);
            let pdf = lights.pdf_surface(lamp.light, path.origin.x, n, lamp.y);
            let cos = lamp.n.dot(ray.direction).abs();
            let shining = Shining { y, cos, pdf, square: 1.0 };
            let weight = chance_weight(scene, self.connector, path, &shining);
            let faded = self.faded(path, lamp.t - path.start_t);
            self.add(path, le * faded * weight);
            // A little behind the lamp's surface.
            from = lamp.t + step.max(lamp.y.abs().max_element()) * 1e-5;
        }
    }

    /// What is left of light after so much of what the path is inside of.
    fn faded(&self, path: &Path, length: f32) -> Rgb {
        self.solids().transmittance(path.media.top(self.solids()), length)
    }

    /// Lets light fade on its way. None if the path has come to the end of it; else it was scattered or lost before: whether it goes on.
    fn cross_inside(&mut self, path: &mut Path, ray: &Ray, end: f32) -> Option<bool> {
        let top = path.media.top(self.solids());
        let inside = self.solids().substance(top).filter(|s| !s.is_empty()).copied()?;
        let length = end - path.start_t;
        if !inside.scatters() {
            path.beta = path.beta * absorption::transmittance(inside.absorption, length);
            return None;
        }
        let extinction = inside.absorption + inside.scattering;
        // One channel chooses the distance; all three share it by their densities.
        let u = path.one(Draw::Distance) * 3.0;
        let channel = (u as usize).min(2);
        let sigma = extinction.to_array()[channel];
        let u = (u - channel as f32).clamp(0.0, 1.0 - f32::EPSILON);
        let distance = if sigma > 0.0 { -libm::logf(1.0 - u) / sigma } else { f32::INFINITY };
        let is_scattered = distance < length;
        let faded = absorption::transmittance(extinction, distance.min(length));
        let density = if is_scattered { faded * extinction } else { faded };
        let mean = (density.r + density.g + density.b) / 3.0;
        if mean <= 0.0 {
            return Some(false);
        }
        path.beta = path.beta * faded / mean;
        if !is_scattered {
            return None;
        }
        path.beta = path.beta * inside.scattering;
        let p = ray.at(path.start_t + distance);
        Some(self.scatter_inside(path, p, ray.direction, inside.anisotropy))
    }

    /// Scatters a path inside milky glass.
    fn scatter_inside(&mut self, path: &mut Path, p: Vec3, d: Vec3, anisotropy: f32) -> bool {
        if path.bounce + 1 >= self.task.settings.bounces {
            return false;
        }
        let top = path.media.top(self.solids());
        let sides = Sides { before: top, beyond: top, media: path.media };
        let scattering = Scattering::Inside { anisotropy };
        let vertex = Vertex { p, n: Vec3::ZERO, reach: p.abs().max_element(), wo: -d, scattering, sides };
        self.gather(path, &vertex);
        let (wi, pdf) = phase::sample_hg(-d, anisotropy, path.two(Draw::Direction));
        path.origin = Origin { x: p, n: Vec3::ZERO, pdf, wi, media: path.media };
        path.chain = Chain::default();
        path.is_seen = false;
        path.polarisation = Polarisation::default();
        self.go_on(path, &Ray::new(p, wi))
    }

    /// Adds what shines from infinitely far.
    fn escape(&mut self, path: &Path, ray: &Ray) {
        let scene = self.task.scene;
        let photoreal = &scene.photoreal;
        if path.is_seen && !photoreal.has_panorama {
            self.add(path, scene.background);
            return;
        }
        let le = photoreal.lights.le_distant(ray.direction);
        if le == Rgb::BLACK {
            return;
        }
        let n = (path.origin.n != Vec3::ZERO).then_some(path.origin.n);
        let pdf = if path.origin.pdf > 0.0 {
            photoreal.lights.pdf_distant(path.origin.x, n, ray.direction)
        } else {
            0.0
        };
        let far = photoreal.far;
        let y = double(ray.origin) + double(ray.direction) * far;
        let shining = Shining { y, cos: 1.0, pdf, square: far * far };
        let weight = chance_weight(scene, self.connector, path, &shining);
        self.add(path, le * weight);
    }

    /// Adds the light of a surface that shines.
    fn meet_emission(&mut self, path: &Path, spot: &Spot, dressed: &Dressed, d: Vec3) {
        if dressed.emission == Rgb::BLACK || !spot.is_outside {
            return;
        }
        let scene = self.task.scene;
        let lights = &scene.photoreal.lights;
        let n = (path.origin.n != Vec3::ZERO).then_some(path.origin.n);
        let light = lights.emitter(spot.hit.primitive, spot.hit.triangle);
        let pdf = light.map_or(0.0, |light| lights.pdf_surface(light, path.origin.x, n, spot.p));
        let shining = Shining { y: double(spot.p), cos: spot.n.dot(d).abs(), pdf, square: 1.0 };
        let weight = chance_weight(scene, self.connector, path, &shining);
        self.add(path, dressed.emission * weight);
    }

    /// The indices on both sides of a surface. A path that meets glass whose index depends on the wavelength takes one.
    fn indices(&self, path: &mut Path, sides: &Sides) -> [f32; 2] {
        let solids = self.solids();
        let of = |solid: u16| solids.substance(solid);
        let is_dispersive = |solid: u16| of(solid).is_some_and(|s| s.is_dispersive);
        if path.wavelength == 0.0 && (is_dispersive(sides.before) || is_dispersive(sides.beyond)) {
            let (wavelength, response) = dispersion::sample_wavelength(path.one(Draw::Wavelength));
            path.wavelength = wavelength;
            path.beta = path.beta * response;
        }
        [sides.before, sides.beyond].map(|s| of(s).map_or(1.0, |s| s.index_at(path.wavelength)))
    }

    /// At the clear surface of a solid: light is reflected or bent, never scattered.
    fn bend(&mut self, path: &mut Path, meeting: &Meeting, dressed: &Dressed) -> bool {
        let &Meeting { spot, solid, sides, arrival } = meeting;
        let [here, there] = self.indices(path, &sides);
        let (wo, n, eta) = (-arrival.ray.direction, dressed.frame.z, there / here);
        let parting = if self.task.settings.unpolarised {
            Polarisation::part_unpolarised(wo, n, eta)
        } else {
            path.polarisation.part(wo, n, eta)
        };
        let is_reflected = path.one(Draw::Lobe) < parting.reflectance;
        self.add_to_chain(path, solid, spot, is_reflected);
        let (wi, side) = if is_reflected {
            path.polarisation = parting.reflected;
            (vitrine_optics::reflect(wo, n), spot.n)
        } else {
            let Some(wi) = refract(wo, n, eta) else { return false };
            path.polarisation = parting.passed;
            path.beta = path.beta * dressed.surface.transmission_tint / (eta * eta);
            path.condensed *= eta * eta;
            path.media = sides.media;
            (wi, -spot.n)
        };
        wi.dot(side) > 0.0
            && self.go_on(path, &Ray::new(offset_origin(spot.p, side, spot.reach), wi.normalize()))
    }

    /// Notes a smooth surface.
    fn add_to_chain(&self, path: &mut Path, solid: u16, spot: &Spot, is_reflected: bool) {
        let piece = (solid != AIR).then(|| self.solids().get(solid).piece).flatten();
        match piece {
            Some(piece) if self.solids().is_clear(solid) => {
                let outward = if spot.is_outside { spot.n } else { -spot.n };
                path.chain.push(solid, face_of(&piece, outward), is_reflected);
            }
            _ => path.chain.push_other(),
        }
    }

    /// At any other surface: looks for light, then goes on in a direction that the surface chooses.
    fn scatter(&mut self, path: &mut Path, meeting: &Meeting, dressed: &Dressed) -> bool {
        let &Meeting { spot, solid, sides, arrival } = meeting;
        let &Dressed { frame, mut surface, .. } = dressed;
        if solid == AIR && surface.transmission > 0.0 {
            // What has no inside is a sheet, which tints as a whole.
            surface.thin_walled = true;
            surface.thin_absorption = surface.transmission_tint;
            surface.transmission_tint = Rgb::WHITE;
        }
        let here = if solid == AIR {
            self.solids().substance(sides.before).map_or(1.0, |s| s.index_at(path.wavelength))
        } else {
            let [here, there] = self.indices(path, &sides);
            surface.eta = there;
            here
        };
        surface.eta /= here;
        surface.coat_ior /= here;
        let wo = -arrival.ray.direction;
        let wo_local = frame.local(wo);
        let bsdf = Bsdf::new(&surface, wo_local.z);
        let has_smooth_part = bsdf.has_smooth_part();
        if path.is_seen && has_smooth_part {
            self.note_features(path, &bsdf, frame.z);
        }
        if has_smooth_part {
            let scattering = Scattering::Surface { bsdf: &bsdf, frame };
            let vertex = Vertex { p: spot.p, n: spot.n, reach: spot.reach, wo, scattering, sides };
            self.gather(path, &vertex);
        }
        let Some(sample) = bsdf.sample(wo_local, path.one(Draw::Lobe), path.two(Draw::Direction)) else {
            return false;
        };
        let wi = frame.world(sample.wi).normalize();
        // A normal for shading may send light to the other side of the surface than it is meant to.
        let goes_through = wi.dot(spot.n) < 0.0;
        if goes_through != sample.event.is_transmission {
            return false;
        }
        self.follow(path, meeting, &sample, (wi, surface.eta));
        let side = if goes_through { -spot.n } else { spot.n };
        self.go_on(path, &Ray::new(offset_origin(spot.p, side, spot.reach), wi))
    }

    /// Updates a path that leaves a surface.
    fn follow(&self, path: &mut Path, meeting: &Meeting, sample: &BsdfSample, (wi, eta): (Vec3, f32)) {
        let &Meeting { spot, solid, sides, .. } = meeting;
        path.beta = path.beta * sample.weight;
        if sample.event.is_transmission && solid != AIR {
            path.media = sides.media;
            path.condensed *= eta * eta;
        }
        path.polarisation = Polarisation::default();
        if !sample.event.is_delta {
            let (n, media) = (spot.n, path.media);
            path.origin = Origin { x: spot.p, n, pdf: sample.pdf, wi, media };
            path.chain = Chain::default();
            path.is_seen = false;
        } else if let Some(mirror) = self.solids().mirror_of_primitive(spot.hit.primitive) {
            path.chain.push(mirror, 0, true);
        } else if solid != AIR || !sample.event.is_transmission {
            self.add_to_chain(path, solid, spot, !sample.event.is_transmission);
        }
    }

    /// Notes what a denoiser wants to know of the first surface that scatters light.
    fn note_features(&mut self, path: &Path, bsdf: &Bsdf, n: Vec3) {
        let features = &mut self.features[self.order.number(path.pixel as usize)];
        features.albedo += bsdf.albedo();
        features.normal += n;
        features.depth += path.depth;
    }

    /// Sends a path on, or ends it by chance where little of its light arrives. Whether it goes on.
    fn go_on(&mut self, path: &mut Path, ray: &Ray) -> bool {
        path.bounce += 1;
        path.start_t = 0.0;
        let beta = path.beta.to_array();
        let largest = beta.iter().fold(0.0_f32, |a, b| a.max(b.abs())) * path.condensed;
        let is_followed = largest > 0.0 && largest.is_finite();
        if !is_followed || !is_traceable(ray.origin, ray.direction) {
            return false;
        }
        if path.bounce >= ROULETTE_FROM && largest < SURE {
            let chance = (largest / SURE).max(LEAST_CHANCE);
            if path.one(Draw::Roulette) >= chance {
                return false;
            }
            path.beta = path.beta / chance;
        }
        self.onward.push(ray);
        true
    }
}
