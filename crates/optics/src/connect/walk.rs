//! Connections through any sequence of planes and balls, such as a ball behind a pane: one way, or none.
//!
//! No formula counts the ways here, so this is a search: a ray is shot at the light, ray differentials tell how its end
//! moves with its direction, and Newton's method corrects the direction. It starts from the straight line, then
//! from a few places of the first ball. What it finds depends on the input alone, never on luck, so a renderer can ask it again
//! whether a way that it met by chance is one of those.
//!
//! Igehy, "Tracing Ray Differentials", SIGGRAPH 1999. Hanika, Droske, Fascione, "Manifold Next Event Estimation", Computer
//! Graphics Forum 34(4), 2015, move the vertices instead of the ray.

use glam::{DMat2, DVec2};
use vitrine_math::DVec3;

use super::{Chain, MAX_VERTICES, PathEnds, Target};

/// The shape of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// A plane without end.
    Plane {
        /// Any point of it, in metres.
        point: DVec3,
        /// Its unit normal; which way it points does not matter.
        n: DVec3,
    },
    /// A ball: a path from outside meets its near side, one from inside its far side.
    Ball {
        /// In metres.
        center: DVec3,
        /// In metres, above 0.
        radius: f64,
    },
}

/// A surface on the way and what happens there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interface {
    /// Where it is.
    pub surface: Surface,
    /// The index before it, on the receiver's side of the path.
    pub before: f64,
    /// The index behind it. For a mirror the path goes on in the medium before.
    pub behind: f64,
    /// The path is reflected.
    pub is_mirror: bool,
}

/// One path over `interfaces` in this order, from the receiver to the light, or None if the search finds none. There may
/// be more.
#[must_use]
pub fn connect(x: DVec3, target: Target, interfaces: &[Interface]) -> Option<Chain> {
    if interfaces.len() > MAX_VERTICES {
        return None;
    }
    let straight = match target {
        Target::Point(y) => image(y, interfaces, 1.0) - x,
        Target::Distant(w) => image(w, interfaces, 0.0),
    };
    let found = search(x, target, interfaces, straight);
    if found.is_some() {
        return found;
    }
    // Where the straight line leads nowhere, several places of the first ball.
    let (k, center, radius) = interfaces.iter().enumerate().find_map(|(k, i)| match i.surface {
        Surface::Ball { center, radius } => Some((k, center, radius)),
        Surface::Plane { .. } => None,
    })?;
    let toward = image(center, &interfaces[..k], 1.0) - x;
    let aside = straight.reject_from(toward).try_normalize().unwrap_or(DVec3::ZERO) * radius;
    AIMS.iter().find_map(|&aim| search(x, target, interfaces, toward + aside * aim))
}

/// The path over `interfaces` in this order to which Newton's method comes from the direction `start` at the receiver; None if
/// it comes to none.
#[must_use]
pub fn connect_from(x: DVec3, target: Target, interfaces: &[Interface], start: DVec3) -> Option<Chain> {
    if interfaces.len() > MAX_VERTICES { None } else { search(x, target, interfaces, start) }
}

/// Where on the first ball the search starts, in radii off the middle towards the light.
const AIMS: [f64; 7] = [0.0, 0.5, -0.5, 0.8, -0.8, 0.95, -0.95];

/// Where a point (`share` = 1) or a direction (0) stands in the flat mirrors among `interfaces`, seen from before them.
fn image(p: DVec3, interfaces: &[Interface], share: f64) -> DVec3 {
    interfaces.iter().rev().filter(|i| i.is_mirror).fold(p, |p, i| match i.surface {
        Surface::Plane { point, n } => p - n * (2.0 * n.dot(p - point * share)),
        Surface::Ball { .. } => p,
    })
}

/// A ray with what it becomes when its start turns along two axes.
#[derive(Clone, Copy)]
struct Ray {
    p: DVec3,
    w: DVec3,
    dp: [DVec3; 2],
    dw: [DVec3; 2],
}

/// Where a ray has come to.
struct Shot {
    vertices: [DVec3; MAX_VERTICES],
    w: DVec3,
    /// By how much it misses the light, across its direction.
    miss: DVec2,
    /// The derivative of where it comes to by the turns of its start.
    rate: DMat2,
}

/// Newton's method from the direction `start`, of any length.
fn search(x: DVec3, target: Target, interfaces: &[Interface], start: DVec3) -> Option<Chain> {
    let mut w = start.try_normalize()?;
    // The precision of the path is the one of its longest number.
    let scale = match target {
        Target::Point(y) => (y - x).length() + x.length() + y.length(),
        Target::Distant(_) => 1.0,
    };
    let mut shot = shoot(x, target, interfaces, w)?;
    for _ in 0..40 {
        let (u, v) = w.any_orthonormal_pair();
        let step = shot.rate.inverse() * shot.miss;
        let turned = |share: f64| (w + (u * step.x + v * step.y) * share).normalize();
        let miss = shot.miss.length();
        if !(step.is_finite() && miss.is_finite()) {
            return None;
        }
        if miss <= 1e-13 * scale {
            return chain(w, &shot, interfaces.len());
        }
        // Half as far as long as the ray is lost or comes no nearer.
        let mut share = (0.5 / step.length()).min(1.0);
        loop {
            let next = turned(share);
            match shoot(x, target, interfaces, next) {
                Some(nearer) if nearer.miss.length() < miss => {
                    (w, shot) = (next, nearer);
                    break;
                }
                // Where rounding is all that is left, nothing is nearer.
                _ if miss <= 1e-11 * scale => return chain(w, &shot, interfaces.len()),
                _ if share < 1e-4 => return None,
                _ => share *= 0.5,
            }
        }
    }
    None
}

/// The chain of a ray that hits the light.
fn chain(w: DVec3, shot: &Shot, count: usize) -> Option<Chain> {
    // The rays of dω_x fill |det| dω_x at the light.
    let spread = 1.0 / shot.rate.determinant().abs();
    let mut chain = Chain::new(PathEnds { wx: w, wy: -shot.w, spread });
    for &p in &shot.vertices[..count] {
        chain.push(p);
    }
    if chain.is_sound() { Some(chain) } else { None }
}

/// Follows the ray from `x` along `w`; None if it is lost on the way or the light lies behind its end.
fn shoot(x: DVec3, target: Target, interfaces: &[Interface], w: DVec3) -> Option<Shot> {
    let (u, v) = w.any_orthonormal_pair();
    let mut ray = Ray { p: x, w, dp: [DVec3::ZERO; 2], dw: [u, v] };
    let mut vertices = [DVec3::ZERO; MAX_VERTICES];
    for (vertex, interface) in vertices.iter_mut().zip(interfaces) {
        let (n, bend) = ray.advance(&interface.surface)?;
        *vertex = ray.p;
        ray.turn(n, bend, interface)?;
    }
    let (a, b) = ray.w.any_orthonormal_pair();
    let across = |d: DVec3| DVec2::new(a.dot(d), b.dot(d));
    let (miss, rate) = match target {
        Target::Point(y) => {
            let t = (y - ray.p).dot(ray.w);
            let moved = |k: usize| across(ray.dp[k] + ray.dw[k] * t);
            (t >= 0.0).then(|| (across(y - ray.p), DMat2::from_cols(moved(0), moved(1))))?
        }
        Target::Distant(toward) => (toward.dot(ray.w) > 0.0)
            .then(|| (across(toward), DMat2::from_cols(across(ray.dw[0]), across(ray.dw[1]))))?,
    };
    Some(Shot { vertices, w: ray.w, miss, rate })
}

impl Ray {
    /// Goes on to the surface. Returns the normal there that points along the ray, and how fast the normal turns: 1/radius,
    /// with its sign. None if it does not meet the surface.
    fn advance(&mut self, surface: &Surface) -> Option<(DVec3, f64)> {
        let (t, n, bend) = match *surface {
            Surface::Plane { point, n } => ((point - self.p).dot(n) / self.w.dot(n), n, 0.0),
            Surface::Ball { center, radius } => {
                let d = self.p - center;
                let half = d.dot(self.w);
                let beyond = d.length_squared() - radius * radius;
                let root = (half * half - beyond).sqrt();
                // Outside it is the near side; from the surface itself and from inside the far one.
                let is_outside = beyond > 1e-9 * radius * radius;
                let t = if is_outside { -half - root } else { -half + root };
                (t, (d + self.w * t) / radius, 1.0 / radius)
            }
        };
        if !(t >= 0.0 && t.is_finite()) {
            return None;
        }
        let cos = n.dot(self.w);
        self.p += self.w * t;
        for (dp, dw) in self.dp.iter_mut().zip(self.dw) {
            // dp' = dp + t dw + dt w, so that it stays on the surface: n·dp' = 0
            let moved = *dp + dw * t;
            *dp = moved - self.w * (n.dot(moved) / cos);
        }
        Some(if cos < 0.0 { (-n, -bend) } else { (n, bend) })
    }

    /// Refracts or reflects the ray at a surface with the normal `n` along it, which turns by `bend`; None at total
    /// reflection.
    fn turn(&mut self, n: DVec3, bend: f64, interface: &Interface) -> Option<()> {
        let cos = n.dot(self.w);
        // The new direction is ratio w + along n; by the cosine, `along` grows by `slope`.
        let (ratio, along, slope) = if interface.is_mirror {
            (1.0, -2.0 * cos, -2.0)
        } else {
            let ratio = interface.before / interface.behind;
            let cos2 = 1.0 - ratio * ratio * (1.0 - cos * cos);
            if cos2 <= 0.0 {
                return None;
            }
            let after = cos2.sqrt();
            (ratio, after - ratio * cos, ratio * ratio * cos / after - ratio)
        };
        for (dp, dw) in self.dp.iter().zip(&mut self.dw) {
            let dn = *dp * bend;
            let dcos = dn.dot(self.w) + n.dot(*dw);
            *dw = *dw * ratio + n * (slope * dcos) + dn * along;
        }
        self.w = (self.w * ratio + n * along).normalize();
        Some(())
    }
}

#[cfg(test)]
mod tests;
