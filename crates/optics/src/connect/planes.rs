//! Connections through parallel planes: a pane, glazing, the surface of water, the wall of a tank.
//!
//! Between parallel planes p = n sin θ is the same in every layer, so the path is one number: the root of
//! r = Σ h_j p/√(n_j²−p²), where r is how far the ends are apart along the planes and h_j the thickness of the layers.
//! Compare Glaeser and Schröcker, "Reflections on Refractions", Journal for Geometry and Graphics 4 (2000).

use vitrine_math::DVec3;

use super::{Chain, MAX_VERTICES, Target};

/// Parallel planes between a receiver and a light.
#[derive(Clone, Copy, Debug)]
pub struct Stack<'a> {
    /// The unit normal of all planes; which way it points does not matter.
    pub n: DVec3,
    /// Plane k holds the points with n·p = `offsets[k]`, in metres, in the order from the receiver to the light. At most
    /// 16.
    pub offsets: &'a [f64],
    /// The refractive indices of the media from the receiver's to the light's: one more than planes.
    pub indices: &'a [f64],
}

/// One layer with its two surfaces, for light that is reflected inside.
#[derive(Clone, Copy, Debug)]
pub struct Pane {
    /// The unit normal of both surfaces.
    pub n: DVec3,
    /// The surface on the receiver's side holds the points with n·p = `near`, in metres.
    pub near: f64,
    /// The other surface.
    pub far: f64,
    /// The indices on the receiver's side, of the layer, and on the other side.
    pub indices: [f64; 3],
}

/// Which reflections inside a pane a connection takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ladder {
    /// Through the pane with 2k reflections inside, k at most 7. Vertices: entry, the reflections, exit.
    Through(u32),
    /// Back to the receiver's side: 0 at the near surface; m ≥ 1 with 2m−1 reflections inside, m at most 7.
    Back(u32),
}

/// A layer on the way: thickness in metres and index.
type Layer = (f64, f64);

/// The path through parallel planes, or None if there is none: the ends lie on the wrong sides, or the light would be
/// totally reflected.
#[must_use]
pub fn connect(x: DVec3, target: Target, stack: &Stack<'_>) -> Option<Chain> {
    let count = stack.offsets.len();
    if count > MAX_VERTICES || stack.indices.len() != count + 1 {
        return None;
    }
    let height = stack.n.dot(x);
    let end = Ends::new(x, target, stack.n)?;
    let mut layers = [(0.0, 0.0); MAX_VERTICES + 1];
    let mut at = height;
    for k in 0..count {
        let thickness = (stack.offsets[k] - at) * end.up;
        layers[k] = (thickness, stack.indices[k]);
        at = stack.offsets[k];
    }
    // A distant light counts from the last plane on: its layer has no thickness.
    layers[count] = (end.height.map_or(0.0, |h| (h - at) * end.up), stack.indices[count]);
    let layers = &layers[..=count];
    let bend = end.bend(layers)?;
    let mut chain = end.chain(layers, &bend, [stack.n * end.up, stack.n * -end.up])?;
    let mut p = x;
    for &(h, index) in &layers[..count] {
        p += (stack.n * end.up + end.e * bend.tan(index)) * h;
        chain.push(p);
    }
    chain.is_sound().then_some(chain)
}

/// The path through one pane that is reflected inside as `ladder` says, or None if there is none. All vertices are given,
/// the reflections too: even ones lie on the near surface, odd ones on the far.
#[must_use]
pub fn connect_pane(x: DVec3, target: Target, pane: &Pane, ladder: Ladder) -> Option<Chain> {
    let (vertices, last) = match ladder {
        Ladder::Through(k) => (2 * k as usize + 2, pane.indices[2]),
        Ladder::Back(m) => (2 * m as usize + 1, pane.indices[0]),
    };
    if vertices > MAX_VERTICES {
        return None;
    }
    let end = Ends::new(x, target, pane.n)?;
    // Back on the receiver's side the light is mirrored: it goes on away from the pane.
    let up = if (pane.far - pane.near).is_sign_negative() { -1.0 } else { 1.0 };
    let (leaving, out) = match ladder {
        Ladder::Through(_) => (pane.far, up),
        Ladder::Back(_) => (pane.near, -up),
    };
    let d = (pane.far - pane.near).abs();
    let first = (pane.near - pane.n.dot(x)) * up;
    let rest = match end.height {
        Some(h) => (h - leaving) * out,
        None if end.up == out => 0.0,
        None => return None,
    };
    // Unfolded, the reflections inside make one thicker layer: (2k+1)d through, 2md back.
    let layers = [(first, pane.indices[0]), ((vertices - 1) as f64 * d, pane.indices[1]), (rest, last)];
    // Order 0 back does not enter the glass.
    let outside = [layers[0], layers[2]];
    let layers = if vertices == 1 { &outside[..] } else { &layers[..] };
    let bend = end.bend(layers)?;
    let mut chain = end.chain(layers, &bend, [pane.n * up, pane.n * -out])?;
    let mut p = x + (pane.n * up + end.e * bend.tan(pane.indices[0])) * first;
    chain.push(p);
    let mut side = up;
    for _ in 1..vertices {
        p += (pane.n * side + end.e * bend.tan(pane.indices[1])) * d;
        chain.push(p);
        side = -side;
    }
    chain.is_sound().then_some(chain)
}

/// The spread of a path through parallel planes that is known already, in 1/m²: no root is searched.
///
/// `cos_x` is the cosine of the angle between the path and the normal at the receiver, at least 0. `layers` are the
/// thickness in metres and the index of every layer on the way, the end media with their share of it; reflections inside
/// count as thickness. None where the path could not get through.
#[inline]
#[must_use]
pub fn spread_of(cos_x: f64, layers: &[(f64, f64)]) -> Option<f64> {
    let nx = layers.first()?.1;
    // Snell: n²c² = n² − n_x² s_x²
    spread(layers, |n| (n - nx) * (n + nx) + nx * nx * cos_x * cos_x)
}

/// The spread dω_x/dω_y of a distant light through parallel planes, for a path that is known already: `cos_x` and `cos_y`
/// are the cosines of its angles with the normal at the receiver and at the light, `nx` and `ny` the indices there.
#[inline]
#[must_use]
pub fn distant_spread_of(cos_x: f64, cos_y: f64, nx: f64, ny: f64) -> f64 {
    // n_x² c_x dω_x = n_y² c_y dω_y, the derivative of Snell's law
    ny * ny * cos_y / (nx * nx * cos_x)
}

/// dω_x/dA⊥ through `layers`, where `q2` gives n² cos² θ in a medium of the index n.
#[inline]
fn spread(layers: &[Layer], q2: impl Fn(f64) -> f64) -> Option<f64> {
    let (&(_, nx), &(_, ny)) = (layers.first()?, layers.last()?);
    let (mut s1, mut s3) = (0.0, 0.0);
    for &(h, n) in layers {
        let q2 = q2(n);
        if q2 <= 0.0 {
            return None;
        }
        // S₁ = Σ h/(n c), S₃ = Σ h/(n c³)
        let part = h / q2.sqrt();
        s1 += part;
        s3 += part * n * n / q2;
    }
    // r = p S₁ and dr/dp = S₃, so dω_x/dA⊥ = 1/(n_x² c_x c_y S₁ S₃)
    let spread = ny / (nx * (q2(nx) * q2(ny)).sqrt() * s1 * s3);
    spread.is_finite().then_some(spread)
}

/// How steep the path is, as t = tan θ in the medium of the smallest index m.
struct Bend {
    m: f64,
    t: f64,
}

impl Bend {
    /// n² cos² θ in a medium of the index `n`: (n²+(n²−m²)t²)/(1+t²).
    #[inline]
    fn q2(&self, n: f64) -> f64 {
        (n * n + (n - self.m) * (n + self.m) * self.t * self.t) / (1.0 + self.t * self.t)
    }

    /// tan θ in a medium of the index `n`: m t/√(n²+(n²−m²)t²).
    #[inline]
    fn tan(&self, n: f64) -> f64 {
        self.m * self.t / (n * n + (n - self.m) * (n + self.m) * self.t * self.t).sqrt()
    }

    /// The unit vector at this angle from `normal` towards the unit vector `e`.
    #[inline]
    fn direction(&self, n: f64, normal: DVec3, e: DVec3) -> DVec3 {
        let tan = self.tan(n);
        (normal + e * tan) / (1.0 + tan * tan).sqrt()
    }
}

/// The two ends seen along the normal.
struct Ends {
    /// +1 if the light lies along the normal, else −1.
    up: f64,
    /// The unit vector along the planes towards the light, or zero if it is straight ahead.
    e: DVec3,
    /// How far the ends are apart along the planes, or sin θ at a distant light.
    r: f64,
    /// n·y, or None for a distant light.
    height: Option<f64>,
}

impl Ends {
    #[inline]
    fn new(x: DVec3, target: Target, n: DVec3) -> Option<Self> {
        let (d, height) = match target {
            Target::Point(y) => (y - x, Some(n.dot(y))),
            Target::Distant(w) => (w, None),
        };
        let h = n.dot(d);
        let along = d - n * h;
        let r = along.length();
        let e = if r > 0.0 { along / r } else { DVec3::ZERO };
        (r.is_finite() && h.is_finite()).then_some(Self {
            up: if h < 0.0 { -1.0 } else { 1.0 },
            e,
            r,
            height,
        })
    }

    /// The angle of the path, or None where there is no path.
    #[inline]
    fn bend(&self, layers: &[Layer]) -> Option<Bend> {
        let m = layers.iter().fold(f64::INFINITY, |m, l| m.min(l.1));
        if m <= 0.0 || layers.iter().any(|l| l.0 < 0.0) {
            return None;
        }
        let t = if self.height.is_some() {
            tangent(layers, m, self.r)?
        } else {
            // The direction at the light is given: p = n_y sin θ_y.
            let p = layers.last()?.1 * self.r;
            if p >= m {
                return None;
            }
            p / ((m - p) * (m + p)).sqrt()
        };
        Some(Bend { m, t })
    }

    /// The chain without its vertices. `normals` point from the receiver and from the light to where the path comes from.
    #[inline]
    fn chain(&self, layers: &[Layer], bend: &Bend, normals: [DVec3; 2]) -> Option<Chain> {
        let (&(_, nx), &(_, ny)) = (layers.first()?, layers.last()?);
        let wx = bend.direction(nx, normals[0], self.e);
        let wy = bend.direction(ny, normals[1], -self.e);
        let spread = if self.height.is_some() {
            spread(layers, |n| bend.q2(n))?
        } else {
            distant_spread_of(normals[0].dot(wx), normals[1].dot(wy), nx, ny)
        };
        Some(Chain::new(wx, wy, spread))
    }
}

/// t = tan θ in the medium of the smallest index `m`, such that the layers carry the path `r` metres along the planes.
#[inline]
fn tangent(layers: &[Layer], m: f64, r: f64) -> Option<f64> {
    // Layers of the smallest index are straight in t; the others saturate at `cap`.
    let (mut total, mut linear, mut cap) = (0.0, 0.0, 0.0);
    for &(h, n) in layers {
        total += h;
        if n == m {
            linear += h;
        } else {
            cap += h * m / ((n - m) * (n + m)).sqrt();
        }
    }
    if total <= 0.0 || (linear <= 0.0 && r >= cap) {
        return None;
    }
    // f is increasing and concave, and f(t) ≤ r at both: Newton comes up to the root from below.
    let mut t = r / total;
    if linear > 0.0 {
        t = t.max((r - cap) / linear);
    }
    for _ in 0..32 {
        // f(t) = Σ h m t/√(n²+(n²−m²)t²) − r,  f'(t) = Σ h m n²/(n²+(n²−m²)t²)^{3/2}
        let (mut f, mut slope) = (linear * t - r, linear);
        for &(h, n) in layers {
            if n != m {
                let inverse = 1.0 / (n * n + (n - m) * (n + m) * t * t).sqrt();
                let g = h * m * inverse;
                f += g * t;
                slope += g * n * n * inverse * inverse;
            }
        }
        let step = f / slope;
        t -= step;
        if step.abs() <= 1e-10 * t {
            break;
        }
    }
    Some(t.max(0.0))
}

#[cfg(test)]
mod tests;
