//! Finds outlines that cross themselves. Ear clipping would take time that grows with the cube of their corners.

/// A point of a flat outline.
type Point = [f64; 2];

/// Whether two edges of an outline cross inside both, or run over one another the same way. Outlines that touch
/// themselves, such as one with a hole and a bridge to it, do not.
pub fn crosses_itself(outline: &[Point]) -> bool {
    let next = outline.iter().cycle().skip(1);
    let mut edges: Vec<[Point; 2]> = outline.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
    // From left to right, only edges that share a piece of the way are compared.
    let [left, right] = [f64::min, f64::max].map(|f| move |e: &[Point; 2]| f(e[0][0], e[1][0]));
    edges.sort_by(|a, b| left(a).total_cmp(&left(b)));
    edges.iter().enumerate().any(|(i, edge)| {
        let end = right(edge);
        edges[i + 1..].iter().take_while(|other| left(other) <= end).any(|other| cross(edge, other))
    })
}

fn cross([a, b]: &[Point; 2], [c, d]: &[Point; 2]) -> bool {
    let sides = [side(a, b, c), side(a, b, d)];
    if sides == [0.0; 2] {
        // On one line: both run the same way, and neither ends before the other begins.
        let along = |p: &Point| (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
        return along(c) < along(d) && along(c) < along(b) && along(d) > 0.0;
    }
    let opposite = |[s, t]: [f64; 2]| s.min(t) < 0.0 && s.max(t) > 0.0;
    opposite(sides) && opposite([side(c, d, a), side(c, d, b)])
}

/// More than 0 when c lies to the left of the way from a to b, 0 when it lies on it.
fn side(a: &Point, b: &Point, c: &Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_that_cross_themselves() {
        let bow = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
        let star: Vec<_> = (0..5).map(|i| f64::from(i * 2) * 1.2566).map(|a| [a.cos(), a.sin()]).collect();
        let twice_around: Vec<_> = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].repeat(2);
        for outline in [&bow[..], &star, &twice_around] {
            assert!(crosses_itself(outline), "{outline:?}");
        }
    }

    #[test]
    fn outlines_that_only_touch_themselves() {
        let comb = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 1.0], [2.0, 3.0], [1.0, 1.0], [0.0, 3.0]];
        let with_a_hole = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 3.0],
            [0.0, 3.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
        ];
        let corners_on_an_edge = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]];
        for outline in [&comb[..], &with_a_hole, &corners_on_an_edge] {
            assert!(!crosses_itself(outline), "{outline:?}");
        }
    }
}
