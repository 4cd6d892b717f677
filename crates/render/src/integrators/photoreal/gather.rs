//! Looking for light on purpose, at a vertex of a path: next-event estimation, straight or through glass.

use super::connect::{Connection, Ends, Node, double, transmittance};
use super::path::{Draw, Path};
use super::step::{Tools, Vertex};
use crate::compile::AIR;
use crate::lights::{LightPoint, LightSample};
use vitrine_math::{DVec3, Rgb, Vec3, offset_origin};
use vitrine_optics::dispersion;

/// How often rare ways are looked for from vertices that the camera does not see: to solve them takes most of the time there, and they bring
/// little light.
const RARE: f32 = 0.25;

/// Light that would add less to a pixel than this is faint: a two hundredth of white.
const FAINT: f32 = 0.005;

impl Tools<'_, '_> {
    /// Looks for light on purpose: one point of one light, and all ways from there.
    pub fn gather(&mut self, path: &Path, vertex: &Vertex) {
        let scene = self.task.scene;
        let photoreal = &scene.photoreal;
        let n = (vertex.n != Vec3::ZERO).then_some(vertex.n);
        let (choice, at) = (path.one(Draw::Light), path.two(Draw::LightPoint));
        let Some(sample) = photoreal.lights.sample(vertex.p, n, choice, at) else { return };
        let x = double(vertex.p);
        let (y, square) = match sample.at {
            LightPoint::Point { position } | LightPoint::Surface { position, .. } => (double(position), 1.0),
            LightPoint::Distant { toward } => {
                (x + double(toward) * photoreal.far, photoreal.far * photoreal.far)
            }
        };
        if photoreal.solids.is_plain() {
            self.offer_straight(path, vertex, &sample);
            return;
        }
        let is_front = vertex.n == Vec3::ZERO || (y - x).dot(double(vertex.n)) > 0.0;
        let media = if is_front { path.media } else { vertex.sides.media };
        let (wavelength, response) = if path.wavelength == 0.0 && photoreal.has_dispersion {
            dispersion::sample_wavelength(path.one(Draw::ConnectionWavelength))
        } else {
            (path.wavelength, Rgb::WHITE)
        };
        let ends = Ends { x, y, media, wavelength };
        let share = if path.is_seen { 1.0 } else { RARE };
        let with_rare = share == 1.0 || path.one(Draw::Rare) < share;
        self.connector.connect(&photoreal.solids, &ends, with_rare);
        let found = std::mem::take(&mut self.connector.found);
        for (number, connection) in found.iter().enumerate() {
            let is_colored = connection.nodes.iter().any(|node| {
                [node.step.before, node.step.beyond]
                    .iter()
                    .any(|m| photoreal.solids.substance(*m).is_some_and(|m| m.is_dispersive))
            });
            let response = if is_colored { response } else { Rgb::WHITE };
            let response = if number < self.connector.plain { response } else { response / share };
            self.offer(
                path,
                vertex,
                &sample,
                &Offer { connection: &connection, ends: &ends, square, response, is_front, number },
            );
        }
        self.connector.found = found;
    }

    /// Adds the light that comes straight, where there is no glass to connect through.
    #[inline]
    fn offer_straight(&mut self, path: &Path, vertex: &Vertex, sample: &LightSample) {
        let (wi, g, end) = match sample.at {
            LightPoint::Distant { toward } => (toward, 1.0, None),
            LightPoint::Point { position } | LightPoint::Surface { position, .. } => {
                let way = position - vertex.p;
                let square = way.length_squared();
                let wi = way / square.sqrt();
                (wi, cos_at(&sample.at, -wi) / square, Some(position))
            }
        };
        let (f, pdf) = vertex.scattering.eval(vertex.wo, wi);
        if g.is_nan() || g <= 0.0 || f == Rgb::BLACK {
            return;
        }
        let side = if wi.dot(vertex.n) < 0.0 { -vertex.n } else { vertex.n };
        let media = if wi.dot(vertex.n) < 0.0 { vertex.sides.media } else { path.media };
        let density = sample.pdf / g + if sample.is_delta { 0.0 } else { pdf };
        let mut light = path.beta * f * sample.le / density;
        let from = offset_origin(vertex.p, side, vertex.reach);
        let solids = &self.task.scene.photoreal.solids;
        let medium = if solids.is_empty() { AIR } else { media.top(solids) };
        let to = end.unwrap_or_else(|| from + wi * self.task.scene.photoreal.far as f32);
        light = light * solids.transmittance(medium, (to - from).length());
        if let Some(light) = worth_tracing(light, || path.one_of(Draw::Faint, 0)) {
            self.shadows.expect(path.pixel, light);
            self.shadows.leg(from, beside(&sample.at, to, -wi), medium);
        }
    }

    /// Adds the light of one connection, if nothing stands in its way.
    fn offer(&mut self, path: &Path, vertex: &Vertex, sample: &LightSample, offer: &Offer) {
        let Offer { connection, ends, square, response, is_front, number } = *offer;
        let wi = connection.ends.wx.as_vec3();
        let leaves_front = vertex.n == Vec3::ZERO || wi.dot(vertex.n) > 0.0;
        if leaves_front != is_front {
            return;
        }
        let (f, pdf) = vertex.scattering.eval(vertex.wo, wi);
        if f == Rgb::BLACK {
            return;
        }
        let cos = cos_at(&sample.at, connection.ends.wy.as_vec3());
        let g = (connection.ends.spread * square) as f32 * cos;
        if g <= 0.0 {
            return;
        }
        // f·τ·L_e·G/p_A, and with the balance heuristic f·τ·L_e/(p_A/G + p_bsdf), which stays finite at caustics.
        let density = sample.pdf / g + if sample.is_delta { 0.0 } else { pdf };
        let solids = self.solids();
        let tau = transmittance(self.task, solids, connection, ends);
        let light = path.beta * response * f * tau * sample.le / density;
        let Some(light) = worth_tracing(light, || path.one_of(Draw::Faint, number)) else { return };
        self.shadows.expect(path.pixel, light);
        self.add_legs(vertex, sample, connection, ends);
    }

    /// The straight parts of a connection.
    fn add_legs(&mut self, vertex: &Vertex, sample: &LightSample, connection: &Connection<'_>, ends: &Ends) {
        let nodes = connection.nodes;
        let wi = connection.ends.wx.as_vec3();
        let side = if wi.dot(vertex.n) < 0.0 { -vertex.n } else { vertex.n };
        let mut from = offset_origin(vertex.p, side, vertex.reach);
        let mut medium = ends.media.top(self.solids());
        let mut d = connection.ends.wx;
        for (k, Node { step, n, p: v }) in nodes.iter().enumerate() {
            // The side of the face from which the light's way comes.
            let near = if n.dot(d) < 0.0 { *n } else { -*n };
            let (p, near) = (v.as_vec3(), near.as_vec3());
            let reach = p.abs().max_element();
            self.shadows.leg(from, offset_origin(p, near, reach), medium);
            let leaving = if step.reflects { near } else { -near };
            from = offset_origin(p, leaving, reach);
            medium = step.after();
            let next = nodes.get(k + 1).map_or(ends.y, |node| node.p);
            d = (next - *v).normalize_or(DVec3::X);
        }
        let to = beside(&sample.at, ends.y.as_vec3(), connection.ends.wy.as_vec3());
        self.shadows.leg(from, to, medium);
    }
}

/// The cosine between the way of light and the normal where it comes from; 1 where there is no surface.
#[inline]
fn cos_at(at: &LightPoint, wy: Vec3) -> f32 {
    match at {
        LightPoint::Surface { n, is_two_sided, .. } => {
            let cos = wy.dot(*n);
            if *is_two_sided { cos.abs() } else { cos.max(0.0) }
        }
        LightPoint::Point { .. } | LightPoint::Distant { .. } => 1.0,
    }
}

/// The point where light comes from, a little beside its surface.
#[inline]
fn beside(at: &LightPoint, y: Vec3, wy: Vec3) -> Vec3 {
    match at {
        LightPoint::Surface { n, .. } => {
            offset_origin(y, if wy.dot(*n) < 0.0 { -*n } else { *n }, y.abs().max_element())
        }
        LightPoint::Point { .. } | LightPoint::Distant { .. } => y,
    }
}

/// A connection that may bring light.
struct Offer<'a> {
    connection: &'a Connection<'a>,
    ends: &'a Ends,
    /// What turns square metres into steradians for what is infinitely far; else 1.
    square: f64,
    /// The colour of the wavelength.
    response: Rgb,
    /// Whether the light comes from the viewer's side.
    is_front: bool,
    /// Which of the connections it is.
    number: usize,
}

/// Light that is worth its shadow rays: faint light is followed only sometimes, and counts for more then.
#[inline]
fn worth_tracing(light: Rgb, chance: impl FnOnce() -> f32) -> Option<Rgb> {
    let largest = light.r.abs().max(light.g.abs()).max(light.b.abs());
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    if largest >= FAINT {
        return Some(light);
    }
    (chance() * FAINT < largest).then(|| light * (FAINT / largest))
}
