//! Rays that leave surfaces, in lanes: mirrored and bent ones. The formulas are those of `vitrine_optics`.

use super::Points;
use crate::accel::packet::{dot, scale3, select3, sub3, unit3};
use crate::accel::simd::Simd;
use vitrine_math::{OFFSET_SHARE, OFFSET_STEPS};

/// Where rays start and where they go, of unit direction.
#[derive(Clone, Copy)]
pub struct Leaving<S: Simd> {
    pub origin: [S::F; 3],
    pub direction: [S::F; 3],
}

impl<S: Simd> Points<S> {
    /// Where rays start that leave on the viewer's side.
    #[inline(always)]
    pub fn origin(&self, s: S) -> [S::F; 3] {
        offset(s, &self.p, &self.n, self.reach)
    }

    /// Where rays start that leave on the other side.
    #[inline(always)]
    fn origin_beyond(&self, s: S) -> [S::F; 3] {
        offset(s, &self.p, &sub3(s, &[s.splat(0.0); 3], &self.n), self.reach)
    }

    /// The mirror rays.
    #[inline(always)]
    pub fn mirrored(&self, s: S) -> Leaving<S> {
        let wi = reflect(s, &self.wo, &self.ns);
        // A smooth normal may send it into the surface: then the form's own normal decides.
        let leaves = s.lt(s.splat(0.0), dot(s, &wi, &self.n));
        let all = s.bits(leaves).count_ones() as usize == S::LANES;
        let wi = if all { wi } else { select3(s, leaves, &wi, &reflect(s, &self.wo, &self.n)) };
        Leaving { origin: self.origin(s), direction: unit3(s, &wi) }
    }

    /// The refracted rays, or at total reflection the mirror rays. `refraction` is the index inside over the index outside.
    #[inline(always)]
    pub fn bent(&self, s: S, refraction: S::F) -> Leaving<S> {
        let (zero, one) = (s.splat(0.0), s.splat(1.0));
        let eta = s.select(self.is_outside, refraction, s.div(one, refraction));
        let cos_i = dot(s, &self.ns, &self.wo);
        // Snell: sin²θt = sin²θi / η²
        let sin2_t = s.div(s.max(s.sub(one, s.mul(cos_i, cos_i)), zero), s.mul(eta, eta));
        let cos_t = s.sqrt(s.sub(one, sin2_t));
        let along_n = s.sub(s.div(cos_i, eta), cos_t);
        let by_eta = [s.div(self.wo[0], eta), s.div(self.wo[1], eta), s.div(self.wo[2], eta)];
        let wi = sub3(s, &scale3(s, &self.ns, along_n), &by_eta);
        // A smooth normal may send it back where it came from: that is not through.
        let passes = s.and(s.lt(sin2_t, one), s.lt(dot(s, &wi, &self.n), zero));
        let mirrored = self.mirrored(s);
        Leaving {
            origin: select3(s, passes, &self.origin_beyond(s), &mirrored.origin),
            direction: select3(s, passes, &unit3(s, &wi), &mirrored.direction),
        }
    }
}

/// [`vitrine_math::offset_origin`] in lanes.
#[inline(always)]
fn offset<S: Simd>(s: S, p: &[S::F; 3], n: &[S::F; 3], reach: S::F) -> [S::F; 3] {
    let zero = s.splat(0.0);
    let small = s.max(s.mul(s.splat(0.5), reach), s.splat(f32::MIN_POSITIVE));
    let by = s.mul(s.splat(OFFSET_SHARE), reach);
    let mut moved = *p;
    for k in 0..3 {
        let steps = s.mul(s.splat(OFFSET_STEPS), n[k]);
        let outwards = s.select(s.lt(p[k], zero), s.sub(zero, steps), steps);
        let is_small = s.le(s.abs(p[k]), small);
        moved[k] = s.select(is_small, s.add(p[k], s.mul(n[k], by)), s.step(p[k], outwards));
    }
    moved
}

/// 2N⟨N, wo⟩ − wo
#[inline(always)]
fn reflect<S: Simd>(s: S, wo: &[S::F; 3], n: &[S::F; 3]) -> [S::F; 3] {
    sub3(s, &scale3(s, n, s.mul(s.splat(2.0), dot(s, n, wo))), wo)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::packet::{load3, store3};
    use crate::accel::simd::{Instructions, Kernel};
    use crate::accel::{BLOCK, Column};
    use vitrine_math::{Vec3, hash};
    use vitrine_optics as optics;

    /// Mirrored and bent directions at points with normals n seen from wo.
    struct Leave<'a> {
        n: &'a [Column; 3],
        wo: &'a [Column; 3],
        refraction: f32,
    }

    impl Kernel for Leave<'_> {
        type Output = [[Column; 3]; 2];
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> [[Column; 3]; 2] {
            let (zero, mut out) = (s.splat(0.0), [[[0.0; BLOCK]; 3]; 2]);
            for start in (0..BLOCK).step_by(S::LANES) {
                let n = load3(s, self.n, start);
                let points = Points {
                    p: [zero; 3],
                    n,
                    ns: n,
                    wo: load3(s, self.wo, start),
                    is_outside: s.le(zero, zero),
                    reach: zero,
                };
                let bent = points.bent(s, s.splat(self.refraction));
                store3(s, &points.mirrored(s).direction, &mut out[0], start);
                store3(s, &bent.direction, &mut out[1], start);
            }
            out
        }
    }

    #[test]
    fn lanes_agree_with_the_formulas() {
        let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
        let vector = |i: u32| Vec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2)).normalize();
        let at = |v: &[Column; 3], lane: usize| Vec3::new(v[0][lane], v[1][lane], v[2][lane]);
        let mut totally = 0;
        for (round, refraction) in [1.5, 0.7, 1.0, 2.4, 0.4].into_iter().enumerate() {
            let (mut n, mut wo) = ([[0.0; BLOCK]; 3], [[0.0; BLOCK]; 3]);
            for lane in 0..BLOCK {
                let i = (round * BLOCK + lane) as u32;
                let (normal, to_viewer) = (vector(2 * i), vector(2 * i + 1));
                let side = if normal.dot(to_viewer) < 0.0 { -1.0 } else { 1.0 };
                for k in 0..3 {
                    (n[k][lane], wo[k][lane]) = (side * normal[k], to_viewer[k]);
                }
            }
            for set in Instructions::available() {
                let [mirrored, bent] = set.run(Leave { n: &n, wo: &wo, refraction });
                for lane in 0..BLOCK {
                    let (n, wo) = (at(&n, lane), at(&wo, lane));
                    let mirror = optics::reflect(wo, n);
                    let through = optics::refract(wo, n, refraction);
                    totally += u32::from(through.is_none());
                    assert!((at(&mirrored, lane) - mirror).length() < 1e-6, "{set:?}");
                    assert!((at(&bent, lane) - through.unwrap_or(mirror)).length() < 1e-5, "{set:?}");
                }
            }
        }
        assert!(totally > 0, "some are reflected totally");
    }

    /// Points moved off along n, each by its own reach.
    struct MoveOff<'a>(&'a [Column; 3], &'a [Column; 3], &'a Column);

    impl Kernel for MoveOff<'_> {
        type Output = [Column; 3];
        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> [Column; 3] {
            let mut out = [[0.0; BLOCK]; 3];
            for start in (0..BLOCK).step_by(S::LANES) {
                let (p, n) = (load3(s, self.0, start), load3(s, self.1, start));
                store3(s, &offset(s, &p, &n, s.load(&self.2[start..])), &mut out, start);
            }
            out
        }
    }

    #[test]
    fn lanes_move_origins_to_the_same_bits() {
        let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
        for round in 0..100_u32 {
            let (mut p, mut n, mut reach) = ([[0.0; BLOCK]; 3], [[0.0; BLOCK]; 3], [0.0_f32; BLOCK]);
            for lane in 0..BLOCK {
                let i = 7 * (round * BLOCK as u32 + lane as u32);
                let normal = Vec3::new(number(i), number(i + 1), number(i + 2)).normalize();
                for k in 0..3 {
                    (p[k][lane], n[k][lane]) = (number(i + 3 + k as u32), normal[k]);
                    reach[lane] = reach[lane].max(p[k][lane].abs());
                }
                reach[lane] *= if lane % 2 == 0 { 1.0 } else { 1.0 + number(i + 6).abs() };
            }
            for set in Instructions::available() {
                let moved = set.run(MoveOff(&p, &n, &reach));
                for lane in 0..BLOCK {
                    let at = |v: &[Column; 3]| Vec3::new(v[0][lane], v[1][lane], v[2][lane]);
                    assert_eq!(at(&moved), vitrine_math::offset_origin(at(&p), at(&n), reach[lane]));
                }
            }
        }
    }
}
