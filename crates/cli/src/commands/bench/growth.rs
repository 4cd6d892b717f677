//! `vitrine bench kernel --growth`: the time of a ray against the number of triangles.

use super::kernel::race_own;
use crate::console;
use vitrine::Progress;
use vitrine::measure::growth::{Line, sizes};
use vitrine::measure::rays::{RayKind, RaySet, ray_sets};
use vitrine::measure::{Kernel, SceneKind};

/// The largest scene when nobody says.
pub const MOST: u32 = 10_000_000;

const RAYS: [RayKind; 2] = [RayKind::Primary, RayKind::Diffuse];

/// What becomes a curve, in the order of [`Step::nanoseconds`]. Random rays in packets are left out: no renderer would
/// send them so.
const LABELS: [&str; 3] = ["Primary, in packets", "Primary, alone", "Diffuse, alone"];

/// What was measured in a cave of one size.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    triangles: usize,
    /// The time of a ray, nanoseconds: of a primary ray in packets and alone, of a diffuse ray alone.
    nanoseconds: [f64; 3],
    build_seconds: f64,
    memory: usize,
}

/// One kind of ray over all sizes.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The kind of ray and how it is traced.
    pub label: &'static str,
    /// The number of triangles and the time of a ray in nanoseconds.
    pub points: Vec<(f64, f64)>,
    /// What fits best over the logarithm; None for a single point.
    pub line: Option<Line>,
}

/// Measures caves of 1000 triangles up to the largest.
pub fn measure(most: u32, size: [u32; 2], rounds: usize, mut progress: impl FnMut(Progress)) -> Vec<Step> {
    let sizes = sizes(most);
    let samples_total = sizes.len() as u64;
    let mut steps = Vec::new();
    for triangles in sizes {
        progress(Progress { samples_done: steps.len() as u64, samples_total, noise: None });
        let scene = SceneKind::Cave.scene(triangles);
        let kernel = Kernel::build(&scene);
        let race = |set: &RaySet| race_own(&kernel, set, rounds);
        let sets = ray_sets(&scene, &kernel, size, &RAYS);
        let [[primary, primary_packets], [diffuse, _]] = [race(&sets[0]), race(&sets[1])];
        // A million rays a second are 1000 ns a ray.
        let nanoseconds = [primary_packets, primary, diffuse].map(|speed| 1000.0 / speed);
        steps.push(Step {
            triangles: scene.triangles(),
            nanoseconds,
            build_seconds: kernel.build_time().as_secs_f64(),
            memory: kernel.memory(),
        });
    }
    steps
}

/// The curves of the kinds of rays.
pub fn curves(steps: &[Step]) -> Vec<Curve> {
    let curve = |(i, label): (usize, &'static str)| {
        let points: Vec<_> = steps.iter().map(|s| (s.triangles as f64, s.nanoseconds[i])).collect();
        Curve { label, line: Line::fit(&points), points }
    };
    LABELS.into_iter().enumerate().map(curve).collect()
}

/// The times, how far each lies from its line, and the lines.
pub fn table(steps: &[Step], curves: &[Curve]) -> String {
    let head =
        ["Triangles", "Packets, ns", "off", "Primary, ns", "off", "Diffuse, ns", "off", "Built, CPU s", "MB"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for (i, step) in steps.iter().enumerate() {
        let mut row = vec![console::thousands(step.triangles as u64)];
        for curve in curves {
            let off = curve.off(i).map_or_else(String::new, |off| format!("{:+.0} %", 100.0 * off));
            row.extend([format!("{:.0}", curve.points[i].1), off]);
        }
        row.extend([format!("{:.3}", step.build_seconds), format!("{:.1}", step.memory as f64 / 1e6)]);
        rows.push(row);
    }
    let lines = curves.iter().filter_map(Curve::in_words);
    console::table(&rows, true) + "\n" + &lines.collect::<String>()
}

/// The times as comma-separated values.
pub fn csv(steps: &[Step]) -> String {
    let head =
        "triangles,primary_packets_ns,primary_single_ns,diffuse_single_ns,build_cpu_seconds,memory_bytes\n"
            .to_owned();
    let row = |s: &Step| {
        let ([packets, primary, diffuse], Step { triangles, build_seconds, memory, .. }) = (s.nanoseconds, s);
        format!("{triangles},{packets:.3},{primary:.3},{diffuse:.3},{build_seconds:.6},{memory}\n")
    };
    std::iter::once(head).chain(steps.iter().map(row)).collect()
}

impl Curve {
    /// How far a point lies above its line, as a share of the line's time.
    fn off(&self, i: usize) -> Option<f64> {
        let (triangles, time) = self.points[i];
        self.line.map(|line| time / line.at(triangles) - 1.0)
    }

    fn in_words(&self) -> Option<String> {
        let line = self.line?;
        let farthest = (0..self.points.len()).filter_map(|i| self.off(i)).map(f64::abs).fold(0.0, f64::max);
        Some(format!(
            "{}: each doubling adds {:.1} ns; the farthest point is {:.0} % off the line\n",
            self.label,
            line.doubling,
            100.0 * farthest
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_shows_how_far_each_point_is_off_its_line() {
        let step = |triangles, primary| Step {
            triangles,
            nanoseconds: [primary, 10.0, 40.0],
            build_seconds: 0.5,
            memory: 1_000_000,
        };
        let steps = [step(1024, 20.0), step(4096, 20.0), step(16_384, 32.0)];
        let curves = curves(&steps);
        // The line through 20, 20 and 32: 18, 24, 30.
        let text = table(&steps, &curves);
        let rows: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
        assert_eq!(rows[1], ["1", "024", "20", "+11", "%", "10", "+0", "%", "40", "+0", "%", "0.500", "1.0"]);
        assert_eq!(rows[2][3..5], ["-17", "%"], "{text}");
        assert!(
            text.contains("Primary, in packets: each doubling adds 3.0 ns; the farthest point is 17 % off"),
            "{text}"
        );
        assert_eq!(csv(&steps).lines().nth(1), Some("1024,20.000,10.000,40.000,0.500000,1000000"));
    }
}
