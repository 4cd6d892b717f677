//! Cuts polygons of any form into triangles.

use super::crossing::crosses_itself;
use earcut::Earcut;
use glam::DVec3;
use vitrine_math::Vec3;

/// Polygons with more corners are cut by their ears only if they do not cross themselves.
const MAX_WILD: usize = 100;

/// Cuts one polygon after the other; it keeps its memory.
#[derive(Default)]
pub struct PolygonCutter {
    earcut: Option<Earcut<f64>>,
    flat: Vec<[f64; 2]>,
    pieces: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl PolygonCutter {
    /// The triangles of a polygon, three of its corners each, turning the way in which the polygon turns. Convex or
    /// concave; of one that is not flat or cuts itself, something near. Some may have no area; all may be missing.
    pub fn cut(&mut self, corners: &[Vec3]) -> &[[u32; 3]] {
        self.triangles.clear();
        let normal = newell_normal(corners);
        match (corners.len(), halve(corners, normal)) {
            (0..3, _) => {}
            (3, _) => self.triangles.push([0, 1, 2]),
            (_, Some(halves)) => self.triangles.extend(halves),
            _ => self.cut_ears(corners, normal),
        }
        &self.triangles
    }

    fn cut_ears(&mut self, corners: &[Vec3], normal: DVec3) {
        // Leaving out the axis along which the normal is longest keeps the polygon's form and every coordinate's bits.
        let n = normal.abs();
        let (u, v) = match (n.x >= n.y && n.x >= n.z, n.y >= n.z) {
            (true, _) => (1, 2),
            (false, true) => (2, 0),
            (false, false) => (0, 1),
        };
        let mirrored = normal[3 - u - v] < 0.0;
        self.flat.clear();
        self.flat.extend(corners.iter().map(|p| [f64::from(p[u]), f64::from(p[v])]));
        if self.flat.len() > MAX_WILD && crosses_itself(&self.flat) {
            let fan = (2..corners.len() as u32).flat_map(|i| [0, i - 1, i]);
            self.pieces.clear();
            self.pieces.extend(fan);
        } else {
            let earcut = self.earcut.get_or_insert_with(Earcut::new);
            earcut.earcut(self.flat.iter().copied(), &[], &mut self.pieces);
        }
        for piece in self.pieces.chunks_exact(3) {
            let [a, b, c] = [piece[0], piece[1], piece[2]];
            let [p, q, r] = [a, b, c].map(|i| self.flat[i as usize]);
            let turns_left = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0;
            self.triangles.push(if turns_left == mirrored { [a, c, b] } else { [a, b, c] });
        }
    }
}

/// A quadrilateral by whichever diagonal lies inside it, the first corner's if both do. None: neither does, or it is no
/// quadrilateral.
fn halve(corners: &[Vec3], normal: DVec3) -> Option<[[u32; 3]; 2]> {
    const WAYS: [[[u32; 3]; 2]; 2] = [[[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]];
    let faces_front = |t: &[u32; 3]| double_area(t.map(|i| corners[i as usize])).dot(normal) > 0.0;
    if corners.len() != 4 {
        return None;
    }
    WAYS.into_iter().find(|halves| halves.iter().all(faces_front))
}

/// A vector along the normal, as long as twice the area, exact enough to tell a triangle without area.
pub fn double_area([a, b, c]: [Vec3; 3]) -> DVec3 {
    let a = a.as_dvec3();
    (b.as_dvec3() - a).cross(c.as_dvec3() - a)
}

/// The mean normal of a polygon that need not be flat, as long as twice its area (Newell's method).
fn newell_normal(corners: &[Vec3]) -> DVec3 {
    let Some(origin) = corners.first().map(|p| p.as_dvec3()) else { return DVec3::ZERO };
    // Relative to one corner, so that a small polygon far out keeps its digits.
    let relative = |p: &Vec3| p.as_dvec3() - origin;
    corners.windows(2).map(|pair| relative(&pair[0]).cross(relative(&pair[1]))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f32::consts::TAU;

    /// The area of all triangles, and of the polygon by the shoelace formula, both along the polygon's normal.
    fn areas(corners: &[Vec3]) -> (f64, f64) {
        let normal = newell_normal(corners);
        let mut cutter = PolygonCutter::default();
        let triangles = cutter.cut(corners);
        let sum = triangles.iter().map(|t| double_area(t.map(|i| corners[i as usize])).length()).sum();
        (sum, normal.length())
    }

    fn turned(points: &[[f32; 2]], about: Vec3, angle: f32) -> Vec<Vec3> {
        let turn = vitrine_math::Quat::from_axis_angle(about.normalize(), angle);
        points.iter().map(|p| turn * Vec3::new(p[0], p[1], 0.5)).collect()
    }

    #[test]
    fn a_concave_polygon_keeps_its_area_and_its_side() {
        // An arrowhead whose fan from the first corner would cover the notch, and a comb.
        let arrow = [[0.0, 0.0], [4.0, -2.0], [2.0, 0.0], [4.0, 2.0]];
        let comb =
            [[0.0, 0.0], [5.0, 0.0], [5.0, 3.0], [4.0, 1.0], [3.0, 3.0], [2.0, 1.0], [1.0, 3.0], [0.0, 1.0]];
        for points in [&arrow[..], &comb[..]] {
            for start in 0..points.len() {
                for angle in [0.0, 1.0, 2.0, 3.0, 4.0, 5.0] {
                    let mut points = points.to_vec();
                    points.rotate_left(start);
                    let corners = turned(&points, Vec3::new(1.0, 2.0, -0.5), angle);
                    let (sum, whole) = areas(&corners);
                    assert!((sum - whole).abs() < 1e-5 * whole, "{sum} of {whole}");
                    let normal = newell_normal(&corners);
                    for t in PolygonCutter::default().cut(&corners) {
                        assert!(double_area(t.map(|i| corners[i as usize])).dot(normal) > 0.0);
                    }
                }
            }
        }
    }

    #[test]
    fn a_quadrilateral_with_a_corner_on_an_edge_has_no_empty_half() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
        let mut cutter = PolygonCutter::default();
        for t in cutter.cut(&corners) {
            assert!(double_area(t.map(|i| corners[i as usize])).length() > 0.0);
        }
    }

    #[test]
    fn polygons_without_area_give_nothing_that_has_one() {
        for corners in [vec![Vec3::ONE; 5], (0..6).map(|i| Vec3::X * i as f32).collect(), vec![]] {
            let mut cutter = PolygonCutter::default();
            let triangles = cutter.cut(&corners);
            assert!(triangles.iter().all(|t| double_area(t.map(|i| corners[i as usize])) == DVec3::ZERO));
        }
    }

    #[test]
    fn a_wild_outline_of_many_corners_is_cut_somehow() {
        // A box's corners again and again: by ears this takes seconds.
        let corners: Vec<_> =
            (0..4000_u32).map(|i| Vec3::from([0, 1, 2].map(|axis| (i >> axis & 1) as f32))).collect();
        assert_eq!(PolygonCutter::default().cut(&corners).len(), 3998);
    }

    proptest! {
        #[test]
        fn star_shaped_polygons_keep_their_area(
            radii in proptest::collection::vec(0.1_f32..10.0, 3..60),
            axis in (-1.0_f32..1.0, -1.0_f32..1.0, 0.1_f32..1.0),
            angle in 0.0_f32..TAU,
        ) {
            let step = TAU / radii.len() as f32;
            let points: Vec<_> =
                radii.iter().enumerate().map(|(i, r)| [r * (i as f32 * step).cos(), r * (i as f32 * step).sin()]).collect();
            let (sum, whole) = areas(&turned(&points, axis.into(), angle));
            prop_assert!((sum - whole).abs() < 1e-4 * whole, "{} of {}", sum, whole);
        }
    }
}
