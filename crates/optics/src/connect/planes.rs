//! Connections through parallel planes: a pane, glazing, the surface of water, the wall of a tank.
//!
//! Between parallel planes p = n sin θ is the same in every layer, so the path is one number: the root of
//! r = Σ h_j p/√(n_j²−p²), where r is how far the ends are apart along the planes and h_j the thickness of the layers.
//! Compare Glaeser and Schröcker, "Reflections on Refractions", Journal for Geometry and Graphics 4 (2000).

use vitrine_math::DVec3;

use super::{Chain, MAX_VERTICES, PathEnds, Target};

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
    for (layer, (&offset, &index)) in layers.iter_mut().zip(stack.offsets.iter().zip(stack.indices)) {
        *layer = ((offset - at) * end.up, index);
        at = offset;
    }
    // A distant light counts from the last plane on: its layer has no thickness.
    layers[count] = (end.height.map_or(0.0, |h| (h - at) * end.up), stack.indices[count]);
    let layers = &mut layers[..=count];
    settle(layers)?;
    let normal = stack.n * end.up;
    let mut slopes = [0.0; MAX_VERTICES + 1];
    let mut chain = Chain::new(end.bend(layers, [normal, -normal], &mut slopes)?);
    let mut p = x;
    for (&(h, _), tan) in layers[..count].iter().zip(slopes) {
        p += (normal + end.e * tan) * h;
        chain.push(p);
    }
    if chain.is_sound() { Some(chain) } else { None }
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
    let mut layers = [(first, pane.indices[0]), ((vertices - 1) as f64 * d, pane.indices[1]), (rest, last)];
    // Order 0 back does not enter the glass.
    let mut outside = [layers[0], layers[2]];
    let layers = if vertices == 1 { &mut outside[..] } else { &mut layers[..] };
    settle(layers)?;
    let mut slopes = [0.0; MAX_VERTICES + 1];
    let mut chain = Chain::new(end.bend(layers, [pane.n * up, pane.n * -out], &mut slopes)?);
    let mut p = x + (pane.n * up + end.e * slopes[0]) * layers[0].0;
    chain.push(p);
    let mut side = up;
    for _ in 1..vertices {
        p += (pane.n * side + end.e * slopes[1]) * d;
        chain.push(p);
        side = -side;
    }
    if chain.is_sound() { Some(chain) } else { None }
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
    let ny = layers.last()?.1;
    // Snell: n²c² = n² − n_x² s_x²
    let q2 = |n: f64| (n - nx) * (n + nx) + nx * nx * cos_x * cos_x;
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

/// The spread dω_x/dω_y of a distant light through parallel planes, for a path that is known already: `cos_x` and `cos_y`
/// are the cosines of its angles with the normal at the receiver and at the light, `nx` and `ny` the indices there.
#[inline]
#[must_use]
pub fn distant_spread_of(cos_x: f64, cos_y: f64, nx: f64, ny: f64) -> f64 {
    // n_x² c_x dω_x = n_y² c_y dω_y, the derivative of Snell's law
    ny * ny * cos_y / (nx * nx * cos_x)
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

    /// t = tan θ in the medium of the smallest index `m`, or None where there is no path.
    #[inline]
    fn tangent(&self, layers: &[Layer], m: f64) -> Option<f64> {
        if self.height.is_some() {
            return tangent(layers, m, self.r);
        }
        // The direction at the light is given: p = n_y sin θ_y.
        let p = layers.last()?.1 * self.r;
        (p < m).then(|| p / ((m - p) * (m + p)).sqrt())
    }

    /// The ends of the path, and tan θ in each layer as `slopes`. `normals` point from the receiver and from the light to
    /// where the path comes from.
    #[inline]
    fn bend(&self, layers: &[Layer], normals: [DVec3; 2], slopes: &mut [f64]) -> Option<PathEnds> {
        let m = layers.iter().fold(f64::INFINITY, |m, l| m.min(l.1));
        if m <= 0.0 {
            return None;
        }
        let t = self.tangent(layers, m)?;
        let (mut s1, mut s3) = (0.0, 0.0);
        let (mut first, mut inverse) = (0.0, 0.0);
        for (k, &(h, n)) in layers.iter().enumerate() {
            // With w = n²+(n²−m²)t² it is n²c² = w/(1+t²) and tan θ = m t/√w; here is 1/√w.
            inverse = if n == m { 1.0 / m } else { 1.0 / (n * n + (n - m) * (n + m) * t * t).sqrt() };
            first = if k == 0 { inverse } else { first };
            slopes[k] = m * t * inverse;
            s1 += h * inverse;
            s3 += h * n * n * inverse * inverse * inverse;
        }
        let (nx, ny) = (layers[0].1, layers[layers.len() - 1].1);
        let steep = 1.0 + t * t;
        let direction = |normal: DVec3, tan: f64| (normal + self.e * tan) / (1.0 + tan * tan).sqrt();
        let wx = direction(normals[0], slopes[0]);
        let wy = direction(normals[1], -slopes[layers.len() - 1]);
        // S₁ = Σ h/(n c) and S₃ = Σ h/(n c³): r = p S₁ and dr/dp = S₃, so dω_x/dA⊥ = 1/(n_x² c_x c_y S₁ S₃)
        let spread = if self.height.is_some() {
            ny * first * inverse / (nx * s1 * s3 * steep)
        } else {
            // n_y² c_y/(n_x² c_x)
            ny * first / (nx * inverse)
        };
        Some(PathEnds { wx, wy, spread })
    }
}

/// Takes an end that is on a plane up to rounding for one that is on it; None if one is on the wrong side.
#[inline]
fn settle(layers: &mut [Layer]) -> Option<()> {
    // What single precision can do.
    let slack = 1e-6 * layers.iter().map(|l| l.0.abs()).sum::<f64>();
    for layer in layers {
        if layer.0.is_nan() || layer.0 < -slack {
            return None;
        }
        layer.0 = layer.0.max(0.0);
    }
    Some(())
}

/// t = tan θ in the medium of the smallest index `m`, such that the layers carry the path `r` metres along the planes.
#[inline]
fn tangent(layers: &[Layer], m: f64, r: f64) -> Option<f64> {
    // Layers of the smallest index are straight in t; the others saturate, together at `cap`. Of those h m, n², n²−m².
    let mut curved = [(0.0, 0.0, 0.0); MAX_VERTICES + 1];
    let (mut count, mut steepest, mut linear, mut cap) = (0, 0.0, 0.0, 0.0);
    for &(h, n) in layers {
        if n == m {
            linear += h;
        } else {
            let rest = (n - m) * (n + m);
            curved[count] = (h * m, n * n, rest);
            count += 1;
            steepest += h * m / n;
            cap += h * m / rest.sqrt();
        }
    }
    steepest += linear;
    if steepest <= 0.0 || (linear <= 0.0 && r >= cap) {
        return None;
    }
    // f is increasing and concave, steepest at 0, and f ≤ r at both of these: Newton comes up to the root from below.
    let mut t = r / steepest;
    if linear > 0.0 {
        t = t.max((r - cap) / linear);
    }
    for _ in 0..32 {
        // f(t) = Σ h m t/√(n²+(n²−m²)t²) − r,  f'(t) = Σ h m n²/(n²+(n²−m²)t²)^{3/2}
        let (mut f, mut slope) = (linear * t - r, linear);
        for &(hm, n2, rest) in &curved[..count] {
            let inverse2 = 1.0 / (n2 + rest * t * t);
            let g = hm * inverse2.sqrt();
            f += g * t;
            slope += g * n2 * inverse2;
        }
        let step = f / slope;
        t -= step;
        // The next error is below 3/2 of the square of the last relative step.
        if step.abs() <= 1e-8 * t {
            break;
        }
    }
    Some(t.max(0.0))
}

#[cfg(test)]
mod tests;
