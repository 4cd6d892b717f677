//! Connections through flat faces that are not parallel: a prism, a box, a bevel, a roof of glass.
//!
//! Of all ways over the same faces in the same order, light takes the one of the shortest optical length (Fermat):
//! V(u) = Σ n_j ‖x_{j+1}−x_j‖ with x_j = o_j + T_j u_j on face j. V is convex, so there is at most one such way, mirrors
//! included. Newton's method with damping finds it, first with the lengths themselves; where it stops at an edge at which
//! two faces meet, and V has a corner, again with √(‖·‖²+ε²) in place of the lengths, ε going to 0.
//!
//! The derivative of the direction follows from that of the equations, as in Jakob and Marschner, "Manifold
//! Exploration", SIGGRAPH 2012.

use glam::{DMat2, DVec2};
use vitrine_math::DVec3;

use super::{Chain, MAX_VERTICES, PathEnds, Target};

/// A flat face on the way.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Any point of its plane, in metres.
    pub point: DVec3,
    /// Its unit normal; which way it points does not matter.
    pub n: DVec3,
    /// The refractive index of the medium before it, on the receiver's side of the path.
    pub before: f64,
    /// The index behind it. For a mirror the path goes on in the medium before.
    pub behind: f64,
    /// The path is reflected.
    pub is_mirror: bool,
}

/// How hard a path is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Care {
    /// Where Newton's method does not arrive there is taken to be none. That misses one path in some thousands, and is many
    /// times as fast where there is none.
    Quick,
    /// Every path is found.
    Full,
}

/// So many steps are taken at most, and each is shortened to this share of Newton's at most.
#[derive(Clone, Copy)]
struct Effort {
    steps: usize,
    share: f64,
}

const PLAIN: Effort = Effort { steps: 16, share: 1e-6 };
const QUICK: Effort = Effort { steps: 12, share: 0.1 };

/// The path over `faces` in this order, from the receiver to the light; or None if there is none. With no face it is the
/// straight line.
///
/// The planes have no edges here: the caller tests each vertex against its face.
#[must_use]
pub fn connect(x: DVec3, target: Target, faces: &[Face], care: Care) -> Option<Chain> {
    if faces.len() > MAX_VERTICES || !x.is_finite() {
        return None;
    }
    match target {
        Target::Point(y) if y.is_finite() => {
            // Most ways have few faces, and moving room for sixteen about takes most of the time.
            match faces.len() {
                0..=2 => Problem::<2>::new(x, y, faces).solve(care),
                3 => Problem::<3>::new(x, y, faces).solve(care),
                4 => Problem::<4>::new(x, y, faces).solve(care),
                5..=6 => Problem::<6>::new(x, y, faces).solve(care),
                7..=8 => Problem::<8>::new(x, y, faces).solve(care),
                _ => Problem::<MAX_VERTICES>::new(x, y, faces).solve(care),
            }
        }
        Target::Distant(w) if w.is_finite() => connect_distant(x, w, faces),
        _ => None,
    }
}

/// The path to a light in the direction `w`. Flat faces keep parallel light parallel, so the directions of all legs follow
/// from the last one, and the points from the first.
fn connect_distant(x: DVec3, w: DVec3, faces: &[Face]) -> Option<Chain> {
    let mut directions = [w; MAX_VERTICES + 1];
    let mut spread = 1.0;
    for (j, face) in faces.iter().enumerate().rev() {
        let after = directions[j + 1];
        let cos_after = face.n.dot(after);
        if face.is_mirror {
            directions[j] = after - face.n * (2.0 * cos_after);
            continue;
        }
        // Snell: n₁ w₁ − n₂ w₂ is along the normal
        let ratio = face.behind / face.before;
        let cos2 = 1.0 - ratio * ratio * (1.0 - cos_after * cos_after);
        if cos2 <= 0.0 {
            return None;
        }
        let cos = cos2.sqrt().copysign(cos_after);
        directions[j] = (after * ratio + face.n * (cos - ratio * cos_after)).normalize();
        // n₁² c₁ dω₁ = n₂² c₂ dω₂, the derivative of Snell's law
        spread *= ratio * ratio * cos_after / cos;
    }
    let mut chain = Chain::new(PathEnds { wx: directions[0], wy: -w, spread });
    let mut p = x;
    for (face, w) in faces.iter().zip(directions) {
        let distance = (face.point - p).dot(face.n) / face.n.dot(w);
        if distance.is_nan() || distance < 0.0 {
            return None;
        }
        p += w * distance;
        chain.push(p);
    }
    chain.is_sound().then_some(chain)
}

/// Points on all faces.
type Points<const N: usize> = [DVec3; N];

/// The way to be found.
struct Problem<'a, const N: usize> {
    x: DVec3,
    y: DVec3,
    faces: &'a [Face],
    /// Two unit vectors along each face.
    along: [(DVec3, DVec3); N],
    /// How long the way is, roughly.
    scale: f64,
}

/// A leg: its direction, how it curves, and its optical length.
#[derive(Clone, Copy)]
struct Leg {
    /// n times the direction, which is shorter than 1 where lengths are smoothed.
    nw: DVec3,
    /// n/ℓ
    bend: f64,
    w: DVec3,
    length: f64,
}

impl<'a, const N: usize> Problem<'a, N> {
    fn new(x: DVec3, y: DVec3, faces: &'a [Face]) -> Self {
        let mut along = [(DVec3::ZERO, DVec3::ZERO); N];
        let mut scale = (y - x).length();
        for (frame, face) in along.iter_mut().zip(faces) {
            *frame = face.n.any_orthonormal_pair();
            scale = scale.max((x - face.point).dot(face.n).abs());
        }
        Self { x, y, faces, along, scale }
    }

    /// The way, or None if light cannot go it.
    fn solve(&self, care: Care) -> Option<Chain> {
        let start = self.straight();
        let points = match care {
            Care::Quick => self.descend(start, 0.0, QUICK)?,
            Care::Full => self.descend(start, 0.0, PLAIN).or_else(|| self.smoothed(&start))?,
        };
        self.chain(&points)
    }

    /// Where the straight line to the image of the light in the mirrors, folded back at them, meets the faces; beside its ends
    /// where it does not.
    fn straight(&self) -> Points<N> {
        let reflected = |p: DVec3, face: &Face| p - face.n * (2.0 * (p - face.point).dot(face.n));
        let mirrors = self.faces.iter().rev().filter(|face| face.is_mirror);
        let mut goal = mirrors.fold(self.y, reflected);
        let mut start = self.x;
        let mut points = [DVec3::ZERO; N];
        for (p, face) in points.iter_mut().zip(self.faces) {
            let d = goal - start;
            let share = (face.point - start).dot(face.n) / d.dot(face.n);
            let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
            let on_line = start + d * share;
            *p = on_line - face.n * (on_line - face.point).dot(face.n);
            if face.is_mirror {
                (start, goal) = (*p, reflected(goal, face));
            }
        }
        points
    }

    /// Leg `j` from its start to its end: leg 0 leaves the receiver, the last one comes to the light.
    #[inline]
    fn leg(&self, points: &Points<N>, j: usize, smooth: f64) -> Leg {
        let start = if j == 0 { self.x } else { points[j - 1] };
        let n = self.index(j);
        let end = if j < self.faces.len() { points[j] } else { self.y };
        let d = end - start;
        let length = (d.length_squared() + smooth * smooth).sqrt();
        let w = d / length;
        Leg { nw: w * n, bend: n / length, w, length: n * length }
    }

    /// The index of the medium of leg `j`.
    #[inline]
    fn index(&self, j: usize) -> f64 {
        match j.checked_sub(1) {
            None => self.faces.first().map_or(1.0, |f| f.before),
            Some(k) if self.faces[k].is_mirror => self.faces[k].before,
            Some(k) => self.faces[k].behind,
        }
    }

    /// T_aᵀ K T_b with K = (n/ℓ)(I − w wᵀ), by the faces' own axes.
    #[inline]
    fn curvature(&self, leg: &Leg, a: usize, b: usize) -> DMat2 {
        let (ta, tb) = (self.along[a], self.along[b]);
        let k = |v: DVec3| (v - leg.w * leg.w.dot(v)) * leg.bend;
        let (k0, k1) = (k(tb.0), k(tb.1));
        DMat2::from_cols(DVec2::new(ta.0.dot(k0), ta.1.dot(k0)), DVec2::new(ta.0.dot(k1), ta.1.dot(k1)))
    }

    /// The optical length.
    fn length(&self, points: &Points<N>, smooth: f64) -> f64 {
        (0..=self.faces.len()).map(|j| self.leg(points, j, smooth).length).sum()
    }

    /// The pieces of the Hessian of V, ready to solve with, and its gradient; None where V has a corner.
    fn linearise(&self, points: &Points<N>, smooth: f64) -> Option<(Blocks<N>, [DVec2; N])> {
        let count = self.faces.len();
        let mut blocks = Blocks::new(count);
        let mut gradient = [DVec2::ZERO; N];
        let mut before = self.leg(points, 0, smooth);
        for (j, gradient) in gradient.iter_mut().enumerate().take(count) {
            let after = self.leg(points, j + 1, smooth);
            // g_j = T_jᵀ(n_{j−1}w_{j−1} − n_j w_j)
            let g = before.nw - after.nw;
            *gradient = DVec2::new(self.along[j].0.dot(g), self.along[j].1.dot(g));
            // H_jj = T_jᵀ(K_{j−1}+K_j)T_j,  H_{j,j+1} = −T_jᵀ K_j T_{j+1}
            let diagonal = self.curvature(&before, j, j) + self.curvature(&after, j, j);
            let next = if j + 1 < count { -self.curvature(&after, j, j + 1) } else { DMat2::ZERO };
            blocks.push(j, diagonal, next)?;
            before = after;
        }
        Some((blocks, gradient))
    }

    /// Newton's method with damping, from `points` to the shortest way; None if it does not arrive with so much effort.
    fn descend(&self, mut points: Points<N>, smooth: f64, effort: Effort) -> Option<Points<N>> {
        let count = self.faces.len();
        let mut value = self.length(&points, smooth);
        for _ in 0..effort.steps {
            let (blocks, gradient) = self.linearise(&points, smooth)?;
            let step = blocks.solve(gradient);
            let fall: f64 = (0..count).map(|j| gradient[j].dot(step[j])).sum();
            let size: f64 = (0..count).map(|j| step[j].length()).fold(0.0, f64::max);
            if !fall.is_finite() {
                return None;
            }
            let moved = |share: f64| {
                let mut p = points;
                for j in 0..count {
                    p[j] -= (self.along[j].0 * step[j].x + self.along[j].1 * step[j].y) * share;
                }
                p
            };
            // So near the goal the length says nothing any more, and the whole step is right.
            if size <= (1e-7 * self.scale).max(0.1 * smooth) {
                points = moved(1.0);
                // Smoothed, it is a stage on the way.
                if smooth > 0.0 || size <= 1e-13 * self.scale {
                    return Some(points);
                }
                value = self.length(&points, smooth);
                continue;
            }
            let mut share = 1.0;
            loop {
                let next = moved(share);
                let shorter = self.length(&next, smooth);
                if shorter <= value - 1e-4 * share * fall {
                    (points, value) = (next, shorter);
                    break;
                }
                share *= 0.5;
                if share < effort.share {
                    return None;
                }
            }
        }
        None
    }

    /// The shortest way by lengths that are smoothed less and less.
    fn smoothed(&self, start: &Points<N>) -> Option<Points<N>> {
        let mut points = *start;
        for smooth in [0.3, 0.02, 2e-3, 2e-4, 1e-5] {
            points = self
                .descend(points, smooth * self.scale, Effort { steps: 40, share: 1e-6 })
                .unwrap_or(points);
        }
        self.descend(points, 0.0, Effort { steps: 24, share: 1e-6 })
    }

    /// The chain, if light can go this way.
    fn chain(&self, points: &Points<N>) -> Option<Chain> {
        let count = self.faces.len();
        for (j, face) in self.faces.iter().enumerate() {
            let before = self.leg(points, j, 0.0);
            let after = self.leg(points, j + 1, 0.0);
            let (a, b) = (face.n.dot(before.w), face.n.dot(after.w));
            let mismatch = (before.nw - after.nw).cross(face.n).length();
            // The shortest way may bend back at a face that it should cross, and stop at an edge.
            if (a * b > 0.0) == face.is_mirror || mismatch.is_nan() || mismatch > 1e-9 * before.nw.length() {
                return None;
            }
        }
        let (first, last) = (self.leg(points, 0, 0.0), self.leg(points, count, 0.0));
        let spread = self.spread(points, &first, &last)?;
        let mut chain = Chain::new(PathEnds { wx: first.w, wy: -last.w, spread });
        for &p in &points[..count] {
            chain.push(p);
        }
        chain.is_sound().then_some(chain)
    }

    /// |det(B_xᵀ V_xu H⁻¹ V_uy B_y)|/n_x², with B the axes across the first and the last leg.
    fn spread(&self, points: &Points<N>, first: &Leg, last: &Leg) -> Option<f64> {
        let count = self.faces.len();
        if count == 0 {
            return Some(1.0 / (self.y - self.x).length_squared());
        }
        let (blocks, _) = self.linearise(points, 0.0)?;
        let (bx, by) = (first.w.any_orthonormal_pair(), last.w.any_orthonormal_pair());
        let m = count - 1;
        let column = |b: DVec3| {
            let mut right = [DVec2::ZERO; N];
            // V_uy = −T_mᵀ K_m, and across the leg K is n/ℓ.
            right[m] = DVec2::new(self.along[m].0.dot(b), self.along[m].1.dot(b)) * -last.bend;
            let u = blocks.solve(right)[0];
            let moved = self.along[0].0 * u.x + self.along[0].1 * u.y;
            // V_xu = −K_0 T_1
            DVec2::new(bx.0.dot(moved), bx.1.dot(moved)) * -first.bend
        };
        let nx = self.index(0);
        Some(DMat2::from_cols(column(by.0), column(by.1)).determinant().abs() / (nx * nx))
    }
}

/// A symmetric positive matrix of 2 × 2 blocks along the diagonal and beside it, eliminated from the first to the last.
struct Blocks<const N: usize> {
    /// The inverse of each pivot.
    pivots: [DMat2; N],
    /// What stands to the right of the diagonal.
    next: [DMat2; N],
    len: usize,
}

impl<const N: usize> Blocks<N> {
    fn new(len: usize) -> Self {
        Self { pivots: [DMat2::ZERO; N], next: [DMat2::ZERO; N], len }
    }

    /// Adds row `j`; None where the matrix is singular.
    #[inline]
    fn push(&mut self, j: usize, diagonal: DMat2, next: DMat2) -> Option<()> {
        let mut pivot = diagonal;
        if j > 0 {
            let above = self.next[j - 1];
            pivot -= above.transpose() * self.pivots[j - 1] * above;
        }
        let determinant = pivot.determinant();
        let is_positive = determinant > 0.0 && determinant.is_finite();
        self.pivots[j] = if is_positive { pivot.inverse() } else { return None };
        self.next[j] = next;
        Some(())
    }

    /// The solution for one right side.
    #[inline]
    fn solve(&self, mut right: [DVec2; N]) -> [DVec2; N] {
        for j in 1..self.len {
            right[j] -= self.next[j - 1].transpose() * (self.pivots[j - 1] * right[j - 1]);
        }
        for j in (0..self.len).rev() {
            let behind = if j + 1 < self.len { self.next[j] * right[j + 1] } else { DVec2::ZERO };
            right[j] = self.pivots[j] * (right[j] - behind);
        }
        right
    }
}

#[cfg(test)]
mod tests;
