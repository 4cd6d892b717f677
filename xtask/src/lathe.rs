//! Models of turned things: a curve through a few points beside the axis, turned about it.

use crate::models::number;
use std::f64::consts::TAU;

/// A turned thing.
pub struct Turned {
    /// What it is, for the file's first line.
    pub about: &'static str,
    /// Points of the curve, from the axis to the axis: distance from the axis and height, metres. A point that stands twice
    /// is a sharp edge.
    pub curve: &'static [[f64; 2]],
}

/// A glass bottle, closed by its cork: 0.3 m high.
pub const BOTTLE: Turned = Turned {
    about: "A bottle, 0.31 m high",
    curve: &[
        [0.0, 0.01],
        [0.03, 0.002],
        [0.038, 0.002],
        [0.041, 0.012],
        [0.041, 0.1],
        [0.041, 0.175],
        [0.034, 0.205],
        [0.017, 0.235],
        [0.014, 0.265],
        [0.014, 0.29],
        [0.0175, 0.292],
        [0.0175, 0.305],
        [0.013, 0.31],
        [0.0, 0.31],
    ],
};

/// A vase, open above.
pub const VASE: Turned = Turned {
    about: "A vase, 0.4 m high",
    curve: &[
        [0.0, 0.0],
        [0.062, 0.0],
        [0.066, 0.006],
        [0.058, 0.022],
        [0.085, 0.09],
        [0.118, 0.18],
        [0.105, 0.262],
        [0.055, 0.325],
        [0.043, 0.36],
        [0.062, 0.396],
        [0.066, 0.402],
        [0.058, 0.398],
        [0.036, 0.36],
        [0.046, 0.32],
        [0.09, 0.25],
        [0.1, 0.18],
        [0.0, 0.04],
    ],
};

/// The foot of a snow globe.
pub const FOOT: Turned = Turned {
    about: "A turned foot, 0.3 m high",
    curve: &[
        [0.0, 0.0],
        [0.72, 0.0],
        [0.72, 0.0],
        [0.745, 0.02],
        [0.745, 0.06],
        [0.72, 0.085],
        [0.72, 0.085],
        [0.66, 0.11],
        [0.6, 0.17],
        [0.585, 0.24],
        [0.6, 0.26],
        [0.6, 0.285],
        [0.58, 0.3],
        [0.58, 0.3],
        [0.0, 0.3],
    ],
};

/// A goblet with its stem, open above.
pub const GOBLET: Turned = Turned {
    about: "A goblet, 0.2 m high",
    curve: &[
        [0.0, 0.0],
        [0.036, 0.0],
        [0.038, 0.003],
        [0.02, 0.008],
        [0.006, 0.02],
        [0.005, 0.05],
        [0.008, 0.078],
        [0.005, 0.088],
        [0.02, 0.1],
        [0.038, 0.125],
        [0.041, 0.155],
        [0.036, 0.198],
        [0.034, 0.2],
        [0.033, 0.197],
        [0.037, 0.155],
        [0.034, 0.128],
        [0.0, 0.1],
    ],
};

/// A drinking glass, open above.
pub const TUMBLER: Turned = Turned {
    about: "A tumbler, 0.1 m high",
    curve: &[
        [0.0, 0.0],
        [0.03, 0.0],
        [0.03, 0.0],
        [0.036, 0.1],
        [0.036, 0.1],
        [0.035, 0.101],
        [0.034, 0.1],
        [0.034, 0.1],
        [0.0285, 0.012],
        [0.0285, 0.012],
        [0.0, 0.012],
    ],
};

/// What is in the drinking glass: it reaches a little into the glass.
pub const DRINK: Turned = Turned {
    about: "What fills the tumbler, up to 0.07 m",
    curve: &[[0.0, 0.011], [0.0292, 0.011], [0.0292, 0.011], [0.0328, 0.07], [0.0328, 0.07], [0.0, 0.07]],
};

const SIDES: usize = 36;
const STEPS: usize = 3;

/// The thing as an OBJ file, around the Y axis, standing on the origin.
pub fn obj(turned: &Turned) -> String {
    let rows = rows(turned.curve);
    let mut lines = vec![format!("# {}. Made by `cargo xtask models`.", turned.about)];
    let around = |lines: &mut Vec<String>, word: &str, [out, up]: [f64; 2]| {
        for side in 0..SIDES {
            let angle = TAU * side as f64 / SIDES as f64;
            let (x, z) = (out * libm::cos(angle), out * libm::sin(angle));
            lines.push(format!("{word} {} {} {}", number(x), number(up), number(z)));
        }
    };
    rows.iter().for_each(|(point, _)| around(&mut lines, "v", *point));
    rows.iter().for_each(|(_, normal)| around(&mut lines, "vn", *normal));
    for row in 1..rows.len() {
        let ([below, above], at) = ([rows[row - 1].0, rows[row].0], |row: usize, side: usize| {
            let index = row * SIDES + side % SIDES + 1;
            format!("{index}//{index}")
        });
        for side in 0..SIDES {
            // On the axis all sides meet, and a triangle is left of the quadrangle.
            let mut corners = vec![at(row - 1, side), at(row, side)];
            if above[0] > 0.0 {
                corners.push(at(row, side + 1));
            }
            if below[0] > 0.0 {
                corners.push(at(row - 1, side + 1));
            }
            if (below[0] - above[0]).abs().max((below[1] - above[1]).abs()) > 1e-9 && corners.len() > 2 {
                lines.push(format!("f {}", corners.join(" ")));
            }
        }
    }
    lines.join("\n") + "\n"
}

/// Points on the curve, each with its normal: out of the axis and up. Catmull and Rom, "A class of local interpolating splines",
/// 1974; at a sharp edge the curve begins anew.
fn rows(curve: &[[f64; 2]]) -> Vec<([f64; 2], [f64; 2])> {
    let mut rows = Vec::new();
    let mut start = 0;
    for end in 1..curve.len() {
        let is_edge = end + 1 == curve.len() || curve[end] == curve[end + 1];
        if is_edge && end > start {
            rows.extend(smooth_rows(&curve[start..=end]));
            start = end + 1;
        }
    }
    rows
}

fn smooth_rows(points: &[[f64; 2]]) -> Vec<([f64; 2], [f64; 2])> {
    let point = |i: isize| points[i.clamp(0, points.len() as isize - 1) as usize];
    let mut rows = Vec::new();
    for span in 0..points.len() - 1 {
        let last = usize::from(span + 2 == points.len());
        // A straight run needs no steps.
        let steps = if points.len() == 2 { 1 } else { STEPS };
        for step in 0..steps + last {
            let t = step as f64 / steps as f64;
            let p = [-1, 0, 1, 2].map(|k| point(span as isize + k));
            let along = |k: usize| {
                let [a, b, c, d] = [p[0][k], p[1][k], p[2][k], p[3][k]];
                let (one, two, three) = (c - a, 2.0 * a - 5.0 * b + 4.0 * c - d, -a + 3.0 * b - 3.0 * c + d);
                let value = 0.5 * (2.0 * b + t * (one + t * (two + t * three)));
                (value, 0.5 * (one + t * (2.0 * two + 3.0 * t * three)))
            };
            let ((out, out_slope), (up, up_slope)) = (along(0), along(1));
            // The curve goes up outside, so what points away from the thing is to its right.
            let length = libm::sqrt(out_slope * out_slope + up_slope * up_slope).max(1e-9);
            rows.push(([out.max(0.0), up], [up_slope / length, -out_slope / length]));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_goes_through_its_points_and_normals_are_of_unit_length() {
        for turned in [BOTTLE, VASE, FOOT, GOBLET, TUMBLER, DRINK] {
            let rows = rows(turned.curve);
            for point in turned.curve {
                let there = rows.iter().any(|(p, _)| (p[0] - point[0]).hypot(p[1] - point[1]) < 1e-9);
                assert!(there, "{}: {point:?}", turned.about);
            }
            for (_, normal) in &rows {
                assert!((normal[0].hypot(normal[1]) - 1.0).abs() < 1e-6, "{}", turned.about);
            }
        }
    }

    #[test]
    fn normals_point_out_of_the_thing() {
        let foot = rows(FOOT.curve);
        assert!(foot[0].1[1] < -0.99, "down at the bottom: {:?}", foot[0]);
        assert!(foot.last().unwrap().1[1] > 0.99, "up at the top");
    }
}
