//! Paths around a centre: from a list of legs between radii to the chains. Balls and shells differ in their legs only.

use vitrine_math::DVec3;

use super::radial::{Between, ON_AXIS, Root, Sweep, Unit};
use super::{Chains, MAX_VERTICES, PathEnds, Target};

/// By how much of the radius an end may lie on the wrong side of a surface: what single precision can do.
const SLACK: f64 = 1e-5;

/// How a leg runs between two radii.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Run {
    /// Towards the centre all the way.
    In,
    /// Away from the centre all the way.
    Out,
    /// First in, past the point closest to the centre, then out.
    Through,
}

/// A straight part of the path: from where the last one ended to the radius `to`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The index of its medium.
    pub n: f64,
    /// The distance from the centre at which it ends, in metres; infinite at a distant light.
    pub to: f64,
    /// The way it runs.
    pub run: Run,
}

/// The legs of a path, without allocation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Legs {
    legs: [Leg; MAX_VERTICES + 1],
    len: usize,
}

impl Legs {
    pub(super) fn new() -> Self {
        Self { legs: [Leg { n: 1.0, to: 0.0, run: Run::Out }; MAX_VERTICES + 1], len: 0 }
    }

    /// Adds a leg; false where the path has too many.
    pub(super) fn push(&mut self, n: f64, to: f64, run: Run) -> bool {
        let room = self.len <= MAX_VERTICES;
        if room {
            self.legs[self.len] = Leg { n, to, run };
            self.len += 1;
        }
        room
    }

    fn as_slice(&self) -> &[Leg] {
        &self.legs[..self.len]
    }
}

/// Receiver and light seen from the centre.
pub(super) struct Around {
    center: DVec3,
    /// The unit vectors to the receiver and to the light.
    x: DVec3,
    y: DVec3,
    /// The unit vectors across those, each towards the other end.
    ex: DVec3,
    ey: DVec3,
    /// Distances from the centre in metres; the light's is infinite if it is distant.
    pub rx: f64,
    pub ry: f64,
    /// The angle between the ends.
    between: Between,
}

impl Around {
    /// None if something is not finite. `scale` is a length of the scene around the centre: an end at the centre itself
    /// has no direction and is moved off by a tiny part of it.
    pub(super) fn new(x: DVec3, target: Target, center: DVec3, scale: f64) -> Option<Self> {
        let off = 1e-9 * scale;
        let from = |p: DVec3| {
            let d = p - center;
            let r = d.length();
            if r > off { (d / r, r) } else { (DVec3::ZERO, off) }
        };
        let (mut xh, rx) = from(x);
        let (mut yh, ry) = match target {
            Target::Point(y) => from(y),
            Target::Distant(w) => (w, f64::INFINITY),
        };
        // From the centre every way is straight: towards the other end.
        if xh == DVec3::ZERO {
            xh = if yh == DVec3::ZERO { DVec3::Z } else { yh };
        }
        if yh == DVec3::ZERO {
            yh = xh;
        }
        let across = xh.cross(yh);
        let sin = across.length();
        let cos = xh.dot(yh);
        let axis = if sin > ON_AXIS { across / sin } else { xh.any_orthonormal_vector() };
        let ex = axis.cross(xh);
        let ey = yh.cross(axis);
        let finite = rx.is_finite() && !ry.is_nan() && sin.is_finite() && cos.is_finite();
        finite.then(|| Self {
            center,
            x: xh,
            y: yh,
            ex: ex / ex.length(),
            ey: ey / ey.length(),
            rx,
            ry,
            between: Between {
                delta: libm::atan2(sin, cos),
                rest: libm::atan2(sin, -cos),
                unit: Unit { cos, sin },
            },
        })
    }

    /// Whether a direction at the receiver points away from the centre.
    pub(super) fn leaves(&self, w: DVec3) -> bool {
        self.x.dot(w) > 0.0
    }

    /// How far beside the light, as an angle seen from the centre, a path along `legs` ends that leaves the receiver along `wx`
    /// with Bouguer's constant `b`.
    pub(super) fn off_light(&self, legs: &Legs, b: f64, wx: DVec3) -> f64 {
        let (mut u, mut v, mut from) = (1.0, 0.0, self.rx);
        for leg in legs.as_slice() {
            let (s, c) = swept(b, leg, from);
            (u, v) = (u * c - v * s, u * s + v * c);
            from = leg.to;
        }
        let side = self.ex.dot(wx).signum();
        (u - self.between.unit.cos).hypot(v * side - self.between.unit.sin)
    }

    /// Bouguer's constant of a path that leaves the receiver so in a medium of the index `n`: n ρ sin(angle with the radius).
    pub(super) fn bouguer(&self, n: f64, wx: DVec3) -> f64 {
        n * self.rx * self.x.cross(wx).length()
    }

    /// The spread of the path along `legs` that leaves the receiver with Bouguer's constant `b`. It is known to hit the
    /// light up to rounding, so near the axis the angle between the ends follows from b better than from the ends.
    pub(super) fn known_spread(&self, legs: &Legs, b: f64) -> f64 {
        let legs = legs.as_slice();
        let mut slope = 0.0;
        let mut from = self.rx;
        for leg in legs {
            // By b, asin(b/a) grows by 1/√(a²−b²).
            let rate = |rho: f64| {
                let a = leg.n * rho;
                if a.is_finite() { 1.0 / ((a - b) * (a + b)).max(0.0).sqrt() } else { 0.0 }
            };
            slope += match leg.run {
                Run::In => rate(leg.to) - rate(from),
                Run::Out => rate(from) - rate(leg.to),
                Run::Through => -(rate(from) + rate(leg.to)),
            };
            from = leg.to;
        }
        let (first, last) = (legs[0].n, legs[legs.len() - 1].n);
        let (cx, cy) = (angle(b, first, self.rx).1, angle(b, last, self.ry).1);
        let sin = if (b * slope).abs() < 1e-3 { 0.0 } else { self.between.unit.sin };
        self.spread((first, cx, cy), sin, &Root { b, side: 1.0, slope })
    }

    /// Adds all chains along `legs` with b of at least `low` to `out`.
    pub(super) fn connect(&self, legs: &Legs, low: f64, out: &mut Chains) {
        let legs = legs.as_slice();
        let Some(sweep) = self.sweep(legs, low) else { return };
        sweep.solve(&self.between, |root| {
            out.push(self.ends(legs, &root), self.vertices(legs, &root));
        });
    }

    /// The angle that the legs sweep, as a function of b.
    fn sweep(&self, legs: &[Leg], low: f64) -> Option<Sweep> {
        let mut terms = [(0.0, 0.0); 2 * MAX_VERTICES + 2];
        let mut len = 0;
        let mut add = |c: f64, a: f64| {
            if let Some(same) = terms[..len].iter_mut().find(|t| t.1 == a) {
                same.0 += c;
            } else if a.is_finite() {
                terms[len] = (c, a);
                len += 1;
            }
        };
        let mut half_turn = false;
        let mut from = self.rx;
        for leg in legs {
            // With α = asin(b/(nρ)) the angle to the radius at each end: inwards α₂−α₁, outwards α₁−α₂, past the closest
            // point π−α₁−α₂.
            let (c1, c2) = match leg.run {
                Run::In => (-1.0, 1.0),
                Run::Out => (1.0, -1.0),
                Run::Through => (-1.0, -1.0),
            };
            half_turn ^= leg.run == Run::Through;
            add(c1, leg.n * from);
            add(c2, leg.n * leg.to);
            from = leg.to;
        }
        Sweep::new(&terms[..len], half_turn, low)
    }

    /// The ends of the path with Bouguer's constant b of `root`.
    fn ends(&self, legs: &[Leg], root: &Root) -> PathEnds {
        let (first, last) = (legs[0], legs[legs.len() - 1]);
        let (sx, cx) = angle(root.b, first.n, self.rx);
        let (sy, cy) = angle(root.b, last.n, self.ry);
        let outwards = |is_so: bool| if is_so { 1.0 } else { -1.0 };
        // At the light the leg is seen backwards: it leaves outwards where it came in.
        let wx = self.x * (cx * outwards(first.run == Run::Out)) + self.ex * (sx * root.side);
        let wy = self.y * (cy * outwards(last.run == Run::In)) + self.ey * (sy * root.side);
        PathEnds { wx, wy, spread: self.spread((first.n, cx, cy), self.between.unit.sin, root) }
    }

    /// The points between the legs of the path with Bouguer's constant b of `root`.
    fn vertices(&self, legs: &[Leg], root: &Root) -> impl Iterator<Item = DVec3> {
        let Root { b, side, .. } = *root;
        // The direction from the centre in the plane of the path, and the distance.
        let (mut u, mut v, mut from) = (1.0, 0.0, self.rx);
        legs[..legs.len() - 1].iter().map(move |leg| {
            let (s, c) = swept(b, leg, from);
            (u, v) = (u * c - v * s, u * s + v * c);
            from = leg.to;
            self.center + (self.x * u + self.ex * (v * side)) * leg.to
        })
    }

    /// dω_x/dA⊥, or dω_x/dω_y for a distant light; `cx` and `cy` are the cosines of the path with the radius at the ends
    /// and `sin` is sin Δ.
    fn spread(&self, (nx, cx, cy): (f64, f64, f64), sin: f64, root: &Root) -> f64 {
        let bend = root.slope.abs();
        // b/(sin Δ |Θ'|); on the axis sin Δ → b |Θ'|
        let ring = if sin < ON_AXIS { 1.0 / (bend * bend) } else { root.b / (sin * bend) };
        let x = nx * self.rx;
        let y = if self.ry.is_finite() { self.ry * self.ry * cy } else { 1.0 };
        // |b|/(n_x² r_x² cos α_x r_y² cos α_y sin Δ |Θ'|)
        ring / (x * x * cx * y)
    }
}

/// The distance from the centre, if it is on the right side of the surface.
#[inline]
pub(super) fn on_side(r: f64, radius: f64, inside: bool) -> Option<f64> {
    if inside {
        (r <= radius * (1.0 + SLACK)).then_some(r.min(radius))
    } else {
        (r >= radius * (1.0 - SLACK)).then_some(r.max(radius))
    }
}

/// Sine and cosine of the angle between the path and the radius `rho` in a medium of the index `n`.
#[inline]
fn angle(b: f64, n: f64, rho: f64) -> (f64, f64) {
    if rho.is_infinite() {
        return (0.0, 1.0);
    }
    let s = b / (n * rho);
    (s, ((1.0 - s) * (1.0 + s)).max(0.0).sqrt())
}

/// Sine and cosine of the angle that a leg from the radius `from` sweeps around the centre.
#[inline]
fn swept(b: f64, leg: &Leg, from: f64) -> (f64, f64) {
    let (s1, c1) = angle(b, leg.n, from);
    let (s2, c2) = angle(b, leg.n, leg.to);
    match leg.run {
        Run::In => (s2 * c1 - s1 * c2, c1 * c2 + s1 * s2),
        Run::Out => (s1 * c2 - s2 * c1, c1 * c2 + s1 * s2),
        Run::Through => (s1 * c2 + s2 * c1, s1 * s2 - c1 * c2),
    }
}
