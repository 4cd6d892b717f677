//! The light of lamps on surfaces in lanes, with shadows: hard ones by one ray, soft ones by rays to points of the lamp. Shadow
//! rays are made, traced and summed in one go and never stored.

use super::TileTask;
use super::soft::SoftLight;
use super::tile::TileOrder;
use crate::accel::Packet;
use crate::accel::packet::{dot, scale3, splat3, sub3};
use crate::accel::rays::Rays;
use crate::accel::simd::Simd;
use crate::compile::CompiledLight;
use crate::surface::Seen;
use vitrine_scene::lights::Emission;

/// A highlight below e to minus this, 4e-9 of its middle, is none.
const FADED: f32 = 19.4;

/// Whether things stand in the light of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadows {
    /// They do.
    Cast,
    /// They do not (ray casting).
    None,
}

/// The lamps that shine on a wave.
pub struct Lamps<'a> {
    pub task: &'a TileTask<'a>,
    /// Which sample of the pixels.
    pub sample: u32,
    pub shadows: Shadows,
    /// Where the pixels are.
    pub order: &'a TileOrder,
}

impl Lamps<'_> {
    /// The light that surfaces send to their pixels, given lane by lane; of lanes beyond the mask it means nothing. Counts shadow
    /// rays.
    #[inline(always)]
    pub fn light<S: Rays>(&self, s: S, lit: &Lit<S>, pixels: &[f32], rays: &mut u64) -> [S::F; 3] {
        let scene = self.task.scene;
        let ambient = splat3(s, scene.ambient.to_array());
        let mut sum = scale3(s, &mul3(s, &lit.color, &ambient), lit.weight);
        for (index, light) in scene.lights.iter().enumerate() {
            let factors = match (&light.emission, self.shadows) {
                (Emission::Disc { position, radius }, Shadows::Cast) => {
                    let light = SoftLight { lamps: self, index: index as u32, disc: (*position, *radius) };
                    Some(light.shine(s, lit, pixels, rays))
                }
                _ => self.shine(s, light, lit, rays),
            };
            if let Some([scattered, highlight]) = factors {
                // What is scattered takes the surface's colour, highlights do not.
                for (k, radiance) in light.radiance.to_array().into_iter().enumerate() {
                    let seen = s.add(s.mul(lit.color[k], scattered), highlight);
                    sum[k] = s.add(sum[k], s.mul(seen, s.splat(radiance)));
                }
            }
        }
        sum
    }

    /// The light of a lamp without size, or of one taken for its middle where shadows do not count: what is scattered and the
    /// highlight, or None when it shines on nothing.
    #[inline(always)]
    fn shine<S: Rays>(&self, s: S, light: &CompiledLight, lit: &Lit<S>, rays: &mut u64) -> Option<[S::F; 2]> {
        let surface = &lit.surface;
        let (wi, distance) = match &light.emission {
            Emission::Direction { travels } => (splat3(s, (-*travels).into()), s.splat(f32::INFINITY)),
            Emission::Point { position }
            | Emission::Disc { position, .. }
            | Emission::Sphere { position, .. } => {
                towards(s, &sub3(s, &splat3(s, (*position).into()), &surface.origin))
            }
            // Light from everywhere has no direction; `compile` keeps it apart.
            Emission::Everywhere | Emission::Environment { .. } | Emission::Sky { .. } => return None,
        };
        let (seen, scattered, highlight) = surface.phong(s, &wi);
        let seen = s.and(lit.mask, seen);
        if !s.any(seen) {
            return None;
        }
        let passes = match self.shadows {
            Shadows::None => s.splat(1.0),
            Shadows::Cast => {
                *rays += u64::from(s.bits(seen).count_ones());
                let t_max = s.select(seen, distance, s.splat(-1.0));
                let packet = Packet::new(s, surface.origin, wi);
                self.task.scene.accel.packet_transmittance(s, &packet, t_max)
            }
        };
        let dark = s.splat(0.0);
        let scattered = s.select(seen, s.mul(scattered, passes), dark);
        Some([scattered, s.select(seen, s.mul(highlight, passes), dark)])
    }
}

/// Surfaces in lanes that light falls on.
#[derive(Clone, Copy)]
pub struct Lit<S: Simd> {
    /// Which lanes.
    pub mask: S::M,
    pub surface: SurfaceLanes<S>,
    pub color: [S::F; 3],
    /// The weights of the surfaces' own light in their pixels.
    pub weight: S::F,
}

impl<S: Simd> Lit<S> {
    /// What is seen, in the lanes of the mask, its own light with those weights.
    #[inline(always)]
    pub fn new(s: S, mask: S::M, seen: &Seen<S>, weight: S::F) -> Self {
        let Seen { points, look } = seen;
        let surface = SurfaceLanes {
            origin: points.origin(s),
            n: points.n,
            ns: points.ns,
            wo: points.wo,
            diffuse: s.mul(look.diffuse, weight),
            specular: s.mul(look.specular, weight),
            shininess: look.shininess,
        };
        Self { mask, surface, color: look.color, weight }
    }
}

/// What Phong's formula needs to know of surfaces, in lanes.
#[derive(Clone, Copy)]
pub struct SurfaceLanes<S: Simd> {
    /// Where shadow rays start.
    pub origin: [S::F; 3],
    /// The unit normals of the forms, on the viewer's side.
    pub n: [S::F; 3],
    /// The unit normals for shading.
    pub ns: [S::F; 3],
    /// The unit directions to the viewer.
    pub wo: [S::F; 3],
    /// k_d and k_s, each times the weight of the surface's own light in its pixel.
    pub diffuse: S::F,
    pub specular: S::F,
    pub shininess: S::F,
}

impl<S: Simd> SurfaceLanes<S> {
    /// [`vitrine_optics::phong_light`] in lanes: where anything is lit at all, what is scattered, the highlight.
    #[inline(always)]
    pub fn phong(&self, s: S, wi: &[S::F; 3]) -> (S::M, S::F, S::F) {
        let zero = s.splat(0.0);
        let cos_l = dot(s, &self.ns, wi);
        // A lamp behind the form is hidden by the form itself, whatever the normal for shading says.
        let front = s.and(s.lt(zero, cos_l), s.lt(zero, dot(s, &self.n, wi)));
        let scattered = s.mul(self.diffuse, cos_l);
        // ⟨R, V⟩ = 2⟨N, L⟩⟨N, V⟩ − ⟨L, V⟩
        let double = s.mul(s.add(cos_l, cos_l), dot(s, &self.ns, &self.wo));
        let cos_r = s.min(s.sub(double, dot(s, wi, &self.wo)), s.splat(1.0));
        // x^s ≤ e^(−s·(1 − x)): away from the highlight it is too small to count.
        let exponent = s.mul(self.shininess, s.sub(s.splat(1.0), cos_r));
        let near = s.and(s.lt(zero, cos_r), s.lt(exponent, s.splat(FADED)));
        let shiny = s.and(front, s.and(near, s.lt(zero, self.specular)));
        let highlight = if s.any(shiny) {
            s.select(shiny, s.mul(self.specular, s.pow_unit(cos_r, self.shininess)), zero)
        } else {
            zero
        };
        let lit = s.or(s.lt(zero, scattered), s.lt(zero, highlight));
        (s.and(front, lit), scattered, highlight)
    }
}

/// The unit directions and the distances of offsets.
#[inline(always)]
pub fn towards<S: Simd>(s: S, offset: &[S::F; 3]) -> ([S::F; 3], S::F) {
    let distance = s.sqrt(dot(s, offset, offset));
    (scale3(s, offset, s.div(s.splat(1.0), distance)), distance)
}

/// The products of components.
#[inline(always)]
fn mul3<S: Simd>(s: S, a: &[S::F; 3], b: &[S::F; 3]) -> [S::F; 3] {
    [s.mul(a[0], b[0]), s.mul(a[1], b[1]), s.mul(a[2], b[2])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::simd::{Instructions, Kernel};
    use crate::accel::{BLOCK, Column};
    use vitrine_math::{Rgb, Vec3, hash};
    use vitrine_optics::{PhongSurface, phong_light};

    /// Columns as [`SurfaceLanes`] has them, and the direction to the lamp.
    struct Phong<'a>(&'a [Column; 9], Vec3);

    impl Kernel for Phong<'_> {
        type Output = (Column, Column);

        #[inline(always)]
        fn run<S: Simd>(self, s: S) -> (Column, Column) {
            let (mut scattered, mut highlight) = ([0.0; BLOCK], [0.0; BLOCK]);
            for start in (0..BLOCK).step_by(S::LANES) {
                let wi = splat3(s, self.1.into());
                let [nx, ny, nz, wx, wy, wz, diffuse, specular, shininess] = self.0;
                let n = [s.load(&nx[start..]), s.load(&ny[start..]), s.load(&nz[start..])];
                let surface = SurfaceLanes {
                    origin: [s.splat(0.0); 3],
                    n,
                    ns: n,
                    wo: [s.load(&wx[start..]), s.load(&wy[start..]), s.load(&wz[start..])],
                    diffuse: s.load(&diffuse[start..]),
                    specular: s.load(&specular[start..]),
                    shininess: s.load(&shininess[start..]),
                };
                let (seen, d, h) = surface.phong(s, &wi);
                s.store(s.select(seen, d, s.splat(0.0)), &mut scattered[start..]);
                s.store(s.select(seen, h, s.splat(0.0)), &mut highlight[start..]);
            }
            (scattered, highlight)
        }
    }

    /// C9: the lanes compute what `optics::phong_light`, the formula itself, says.
    #[test]
    fn c9_lanes_agree_with_the_formula() {
        let number = |i: u32| 2.0 * hash::unit(hash::mix(i)) - 1.0;
        let vector = |i: u32| Vec3::new(number(3 * i), number(3 * i + 1), number(3 * i + 2)).normalize();
        for round in 0..50 {
            let mut columns = [[0.0; BLOCK]; 9];
            let mut all = Vec::new();
            for lane in 0..BLOCK {
                let i = round * 100 + lane as u32;
                let phong = PhongSurface {
                    color: Rgb::WHITE,
                    diffuse: number(i).abs(),
                    specular: if i.is_multiple_of(3) { 0.0 } else { number(i + 7).abs() },
                    shininess: 1.0 + 50.0 * number(i + 9).abs(),
                };
                let (n, wo) = (vector(2 * i), vector(2 * i + 1));
                let wo = if wo.dot(n) < 0.0 { -wo } else { wo };
                let numbers = [n.x, n.y, n.z, wo.x, wo.y, wo.z];
                let numbers = numbers.into_iter().chain([phong.diffuse, phong.specular, phong.shininess]);
                columns.iter_mut().zip(numbers).for_each(|(column, number)| column[lane] = number);
                all.push((phong, n, wo));
            }
            let wi = vector(77_777 + round);
            for set in Instructions::available() {
                let (scattered, highlight) = set.run(Phong(&columns, wi));
                for (i, (phong, n, wo)) in all.iter().enumerate() {
                    let (d, h) = phong_light(phong, *n, wi, *wo);
                    assert!((scattered[i] - d).abs() < 1e-6, "{set:?}: {} against {d}", scattered[i]);
                    assert!((highlight[i] - h).abs() < 2e-5, "{set:?}: {} against {h}", highlight[i]);
                }
            }
        }
    }
}
