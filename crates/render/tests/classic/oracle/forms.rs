//! Where lines cross the forms, in double precision.

use super::vector::{D3, turned};
use vitrine_scene::{Assets, ClassicMaterial, Geometry, Object, Scene};

/// An object.
pub struct Thing {
    geometry: Geometry,
    position: D3,
    /// Where the object's own unit vectors lie in the world.
    axes: [D3; 3],
    pub material: ClassicMaterial,
}

impl Thing {
    pub fn new(object: &Object, scene: &Scene, assets: &Assets) -> Self {
        let axis = |k: usize| {
            let mut e = D3::default();
            e.0[k] = f64::from(object.scale[k]);
            turned(e, object.turn_deg)
        };
        let named = object.material.as_deref().and_then(|m| scene.material(m));
        Self {
            geometry: object.shape.as_kind().geometry(assets).expect("its model is there"),
            position: D3::of(object.position),
            axes: [axis(0), axis(1), axis(2)],
            material: named.map_or_else(ClassicMaterial::default, vitrine_scene::Material::classic),
        }
    }

    fn vector(&self, v: D3) -> D3 {
        self.axes[0] * v.0[0] + self.axes[1] * v.0[1] + self.axes[2] * v.0[2]
    }

    fn point(&self, p: D3) -> D3 {
        self.position + self.vector(p)
    }

    /// The axes are perpendicular, so each component is a projection.
    fn local(&self, v: D3) -> D3 {
        D3(std::array::from_fn(|k| self.axes[k].dot(v) / self.axes[k].dot(self.axes[k])))
    }

    /// A normal of the object in the world, of unit length.
    fn normal(&self, n: D3) -> D3 {
        let n = D3(std::array::from_fn(|k| n.0[k] / self.axes[k].dot(self.axes[k])));
        self.vector(n).unit()
    }

    /// Every point where the line o + t·d meets the surface, with the outward unit normal.
    pub fn crossings(&self, o: D3, d: D3) -> Vec<(f64, D3)> {
        let (lo, ld) = (self.local(o - self.position), self.local(d));
        match &self.geometry {
            Geometry::Sphere { radius } => {
                let r = f64::from(*radius);
                let (a, b, c) = (ld.dot(ld), lo.dot(ld), lo.dot(lo) - r * r);
                let root = b * b - a * c;
                if root < 0.0 {
                    return Vec::new();
                }
                let at = |sign: f64| {
                    let t = (-b + sign * root.sqrt()) / a;
                    (t, self.normal(lo + ld * t))
                };
                vec![at(-1.0), at(1.0)]
            }
            Geometry::Box { half } => {
                let half = D3::of(*half);
                let mut all = Vec::new();
                for k in 0..3 {
                    for side in [-1.0, 1.0] {
                        let t = (side * half.0[k] - lo.0[k]) / ld.0[k];
                        let p = lo + ld * t;
                        if t.is_finite() && (0..3).all(|j| j == k || p.0[j].abs() <= half.0[j]) {
                            let mut n = D3::default();
                            n.0[k] = side;
                            all.push((t, self.normal(n)));
                        }
                    }
                }
                all
            }
            Geometry::Plane => vec![(-lo.0[1] / ld.0[1], self.normal(D3::new(0.0, 1.0, 0.0)))],
            Geometry::Disc { radius } => {
                let t = -lo.0[1] / ld.0[1];
                let p = lo + ld * t;
                let is_in = p.0[0].hypot(p.0[2]) <= f64::from(*radius);
                is_in.then(|| (t, self.normal(D3::new(0.0, 1.0, 0.0)))).into_iter().collect()
            }
            Geometry::Triangle { points, .. } => {
                self.triangle(points.map(|p| self.point(D3::of(p))), o, d).into_iter().collect()
            }
            Geometry::Mesh(mesh) | Geometry::Facets(mesh) => {
                let corners = |t: &[u32; 3]| t.map(|i| self.point(D3::of(mesh.positions[i as usize])));
                mesh.triangles.iter().filter_map(|t| self.triangle(corners(t), o, d)).collect()
            }
        }
    }

    /// By areas: inside when all three parts turn the same way round.
    fn triangle(&self, [a, b, c]: [D3; 3], o: D3, d: D3) -> Option<(f64, D3)> {
        let n = (b - a).cross(c - a);
        let t = n.dot(a - o) / n.dot(d);
        let p = o + d * t;
        let inside = |from: D3, to: D3| (to - from).cross(p - from).dot(n) >= 0.0;
        (t.is_finite() && inside(a, b) && inside(b, c) && inside(c, a)).then(|| (t, n.unit()))
    }
}
