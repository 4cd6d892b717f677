//! What the tests of connections stand on: rays followed forwards, without any of the solvers' formulas.

use vitrine_math::{DVec3, hash};

use super::{Chain, Target};

/// A surface that a ray meets.
#[derive(Clone, Copy, Debug)]
pub(super) enum Surface {
    Plane { n: DVec3, offset: f64 },
    Ball { center: DVec3, radius: f64 },
}

/// What happens there: the next surface, and the indices before and behind it; equal ones mean a mirror.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    pub surface: Surface,
    pub before: f64,
    pub behind: f64,
}

pub(super) fn event(surface: Surface, before: f64, behind: f64) -> Event {
    Event { surface, before, behind }
}

/// The numbers of a test, from a fixed seed.
pub(super) struct Dice(pub u32);

impl Dice {
    /// Even in 0 to 1.
    pub(super) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(1);
        let fine = f64::from(hash::unit(hash::mix(self.0 ^ 0x9e37_79b9))) / 16_777_216.0;
        f64::from(hash::unit(hash::mix(self.0))) + fine
    }

    pub(super) fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    pub(super) fn direction(&mut self) -> DVec3 {
        loop {
            let d = DVec3::from_array([0; 3].map(|_| self.between(-1.0, 1.0)));
            if d.length() > 0.1 && d.length() < 1.0 {
                return d.normalize();
            }
        }
    }
}

impl Surface {
    /// Distance along the ray and the normal there.
    fn meet(&self, p: DVec3, w: DVec3) -> Option<(f64, DVec3)> {
        match *self {
            Surface::Plane { n, offset } => {
                let t = (offset - n.dot(p)) / n.dot(w);
                (t > -1e-9).then_some((t, n))
            }
            Surface::Ball { center, radius } => {
                let d = p - center;
                let half = d.dot(w);
                let root = (half * half - d.dot(d) + radius * radius).sqrt();
                // What starts on the ball means its other side.
                let t = if -half - root > 1e-7 * radius { -half - root } else { -half + root };
                let on = d.length() - radius;
                let t = if on.abs() < 1e-7 * radius && half > 0.0 { 0.0 } else { t };
                (t.is_finite() && t > -1e-9).then_some((t, (d + w * t) / radius))
            }
        }
    }

    /// The normal at a point.
    pub(super) fn normal(&self, p: DVec3) -> DVec3 {
        match *self {
            Surface::Plane { n, .. } => n,
            Surface::Ball { center, .. } => (p - center).normalize(),
        }
    }
}

/// Bends or mirrors a direction of travel.
fn bend(w: DVec3, n: DVec3, event: &Event) -> Option<DVec3> {
    let n = if n.dot(w) > 0.0 { n } else { -n };
    let cos = n.dot(w);
    if event.before == event.behind {
        return Some(w - n * (2.0 * cos));
    }
    let ratio = event.before / event.behind;
    let cos2 = 1.0 - ratio * ratio * (1.0 - cos * cos);
    (cos2 > 0.0).then(|| (w * ratio + n * (cos2.sqrt() - ratio * cos)).normalize())
}

/// Follows a ray through all events: the last point, and the direction of travel after it.
pub(super) fn follow(x: DVec3, w: DVec3, events: &[Event]) -> Option<(DVec3, DVec3)> {
    let (mut p, mut w) = (x, w);
    for e in events {
        let (t, n) = e.surface.meet(p, w)?;
        p += w * t;
        w = bend(w, n, e)?;
    }
    Some((p, w))
}

/// dω_x/dA⊥ (or dω_x/dω_y) of a chain by central differences of rays followed forwards.
pub(super) fn measured_spread(x: DVec3, target: Target, chain: &Chain, events: &[Event], step: f64) -> f64 {
    let (u, v) = chain.wx.any_orthonormal_pair();
    let (a, b) = chain.wy.any_orthonormal_pair();
    let at = |du: f64, dv: f64| -> (f64, f64) {
        let (p, w) = follow(x, (chain.wx + u * du + v * dv).normalize(), events).unwrap();
        let d = match target {
            // Where it meets the plane through the light that is perpendicular to the chain.
            Target::Point(y) => p + w * ((y - p).dot(chain.wy) / w.dot(chain.wy)) - y,
            Target::Distant(_) => w,
        };
        (d.dot(a), d.dot(b))
    };
    // Two steps, extrapolated: the error falls with the fourth power.
    let area = |h: f64| {
        let (u1, u0, v1, v0) = (at(h, 0.0), at(-h, 0.0), at(0.0, h), at(0.0, -h));
        let (ua, ub) = ((u1.0 - u0.0) / (2.0 * h), (u1.1 - u0.1) / (2.0 * h));
        let (va, vb) = ((v1.0 - v0.0) / (2.0 * h), (v1.1 - v0.1) / (2.0 * h));
        (ua * vb - ub * va).abs()
    };
    let (coarse, fine) = (area(2.0 * step), area(step));
    3.0 / (4.0 * fine - coarse)
}

/// How far the chain is from the truth: the ray along `wx` against the light, the vertices and Snell's law, relative to
/// `scale`.
pub(super) fn miss(x: DVec3, target: Target, chain: &Chain, events: &[Event], scale: f64) -> f64 {
    let points = chain.vertices();
    assert_eq!(points.len(), events.len());
    let mut error = (chain.wx.length() - 1.0).abs().max((chain.wy.length() - 1.0).abs());
    for (k, e) in events.iter().enumerate() {
        let before = if k == 0 { x } else { points[k - 1] };
        let n = e.surface.normal(points[k]);
        let (t, _) = e.surface.meet(before, (points[k] - before).normalize()).unwrap();
        error = error.max((before + (points[k] - before).normalize() * t - points[k]).length() / scale);
        let wi = (points[k] - before).normalize();
        let wo = match (points.get(k + 1), target) {
            (Some(next), _) => (next - points[k]).normalize(),
            (None, Target::Point(y)) => (y - points[k]).normalize(),
            (None, Target::Distant(w)) => w,
        };
        // Snell as vectors: n₁ w₁ × N = n₂ w₂ × N
        error = error.max((n.cross(wi) * e.before - n.cross(wo) * e.behind).length());
        let through = e.before != e.behind;
        assert_eq!(through, n.dot(wi) * n.dot(wo) > 0.0, "vertex {k} lies on the wrong side");
    }
    let last = match target {
        Target::Point(y) => points.last().map_or(x - y, |p| p - y).normalize(),
        Target::Distant(w) => -w,
    };
    error = error.max((last - chain.wy).length());
    let first = points.first().map_or(chain.wx, |p| (p - x).normalize());
    error.max((first - chain.wx).length())
}

/// The smallest cosine between the path and the surfaces, on both sides of each vertex: how near it is to grazing.
pub(super) fn steepness(chain: &Chain, events: &[Event]) -> f64 {
    let points = chain.vertices();
    let mut least = 1.0_f64;
    for (k, e) in events.iter().enumerate() {
        let n = e.surface.normal(points[k]);
        let wi = if k == 0 { chain.wx } else { (points[k] - points[k - 1]).normalize() };
        let wo = points.get(k + 1).map_or(chain.wy, |p| (p - points[k]).normalize());
        least = least.min(n.dot(wi).abs()).min(n.dot(wo).abs());
    }
    least
}

/// Looks for chains that a search has missed: sends rays from `x` in many directions, neighbours one after the other, as
/// `trace` follows them. Returns between how many neighbours the light is passed, and where no chain starts.
pub(super) fn missed_chains(
    target: Target,
    chains: &[Chain],
    directions: impl Iterator<Item = DVec3>,
    across: DVec3,
    trace: impl Fn(DVec3) -> Option<(DVec3, DVec3)>,
) -> (usize, usize) {
    let (mut seen, mut missed) = (0, 0);
    let mut last: Option<(DVec3, f64)> = None;
    for w in directions {
        let now = trace(w).and_then(|(p, out)| {
            let d = match target {
                Target::Point(y) => y - p,
                Target::Distant(w) => w,
            };
            // On which side of the ray the light lies, if the ray goes its way.
            (out.dot(d) > 0.0).then(|| (w, across.dot(out.cross(d))))
        });
        if let (Some((w0, s0)), Some((w1, s1))) = (last, now)
            && s0 * s1 < 0.0
        {
            seen += 1;
            let slack = 1e-9;
            let between = |c: &Chain| {
                w0.cross(c.wx).dot(across) * w1.cross(c.wx).dot(across) <= slack
                    && (c.wx - w0).length() <= (w1 - w0).length() * (1.0 + 1e-6) + slack
            };
            if !chains.iter().any(between) {
                missed += 1;
            }
        }
        last = now;
    }
    (seen, missed)
}
