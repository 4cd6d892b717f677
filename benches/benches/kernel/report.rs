//! What is printed: a row for each set of rays, a row for each tree, and how far the targets are.

use std::fmt;
use std::time::Duration;
use vitrine_measure::SceneKind;
use vitrine_measure::rays::RayKind;

/// The kernels' speeds over one set of rays, million rays a second.
pub struct Row {
    pub scene: SceneKind,
    pub rays: RayKind,
    pub single: f64,
    pub packets: f64,
    pub peer: Option<PeerSpeeds>,
    /// The share of rays that Vitrine's packets and single rays do not agree on, 0 to 1.
    pub own_disagreement: f64,
}

/// Embree's, with what it does not agree on with Vitrine.
pub struct PeerSpeeds {
    pub single: f64,
    pub watertight: f64,
    pub sixteen: f64,
    pub watertight_sixteen: f64,
    /// The share of rays on which its watertight single rays and Vitrine's do not agree, 0 to 1.
    pub single_disagreement: f64,
    /// The share of rays on which its watertight sixteen and Vitrine's packets do not agree, 0 to 1.
    pub packet_disagreement: f64,
}

/// The head of the rows. A ratio is Vitrine's speed divided by Embree's.
pub const HEAD: &str = "\
| scene | rays | Vitrine: 1 | packets | Embree: 1 | robust | 16 | robust | ÷ 1 | ÷ robust | ÷ 16 | ÷ robust | hits differ, of a million |
|---|---|---|---|---|---|---|---|---|---|---|---|---|";

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (scene, rays) = (self.scene.name(), self.rays.name());
        let own = self.own_disagreement * 1e6;
        write!(f, "| {scene} | {rays} | {:.2} | {:.2} |", self.single, self.packets)?;
        let Some(peer) = &self.peer else {
            return write!(f, "{} own {own:.0} |", " |".repeat(8));
        };
        for speed in [peer.single, peer.watertight, peer.sixteen, peer.watertight_sixteen] {
            write!(f, " {speed:.2} |")?;
        }
        for ratio in [Ratio::Single, Ratio::Watertight, Ratio::Packets, Ratio::WatertightPackets] {
            write!(f, " {:.2} |", ratio.of(self, peer))?;
        }
        let [single, packet] = [peer.single_disagreement, peer.packet_disagreement].map(|share| share * 1e6);
        write!(f, " own {own:.0}, single {single:.0}, packets {packet:.0} |")
    }
}

/// Which speeds are compared.
#[derive(Clone, Copy)]
enum Ratio {
    Single,
    Watertight,
    Packets,
    WatertightPackets,
}

impl Ratio {
    fn of(self, row: &Row, peer: &PeerSpeeds) -> f64 {
        match self {
            Self::Single => row.single / peer.single,
            Self::Watertight => row.single / peer.watertight,
            Self::Packets => row.packets / peer.sixteen,
            Self::WatertightPackets => row.packets / peer.watertight_sixteen,
        }
    }
}

/// What building a scene's trees took.
pub struct Built {
    pub scene: SceneKind,
    pub triangles: usize,
    pub own: Tree,
    pub peer: Option<Tree>,
}

/// What one tree took.
#[derive(Clone, Copy)]
pub struct Tree {
    /// Seconds of processor time, all threads together.
    seconds: f64,
    bytes: f64,
}

impl Tree {
    pub fn new(time: Duration, bytes: usize) -> Self {
        Self { seconds: time.as_secs_f64(), bytes: bytes as f64 }
    }
}

/// A row of the targets: what is compared, over which rays, and the least ratio that is wanted.
struct Target {
    name: &'static str,
    ratio: Ratio,
    rays: &'static [RayKind],
    scenes: &'static [SceneKind],
    least: f64,
}

const LARGE: &[SceneKind] = &[SceneKind::Room, SceneKind::Cave];

const TARGETS: [Target; 5] = [
    Target {
        name: "single rays, coherent and short",
        ratio: Ratio::Single,
        rays: &[RayKind::Primary, RayKind::Shadow, RayKind::Ambient],
        scenes: LARGE,
        least: 1.0,
    },
    Target {
        name: "single diffuse rays, cave",
        ratio: Ratio::Single,
        rays: &[RayKind::Diffuse],
        scenes: &[SceneKind::Cave],
        least: 0.95,
    },
    Target {
        name: "watertight against robust",
        ratio: Ratio::Watertight,
        rays: &RayKind::ALL,
        scenes: LARGE,
        least: 0.95,
    },
    Target {
        name: "coherent packets",
        ratio: Ratio::Packets,
        rays: &[RayKind::Primary],
        scenes: LARGE,
        least: 1.25,
    },
    Target {
        name: "shadow packets",
        ratio: Ratio::Packets,
        rays: &[RayKind::Shadow],
        scenes: LARGE,
        least: 0.95,
    },
];

/// Prints the trees and, when Embree took part, how far the targets are.
pub fn print(rows: &[Row], trees: &[Built]) {
    println!(
        "\n| scene | triangles | Vitrine: build, CPU s | MB | Embree: build, CPU s | MB | time ÷ | memory ÷ |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for Built { scene, triangles, own, peer } in trees {
        let rest = peer.map_or_else(
            || "| | | ".to_owned(),
            |p| {
                let (time, memory) = (own.seconds / p.seconds, own.bytes / p.bytes);
                format!("{:.3} | {:.1} | {time:.2} | {memory:.2}", p.seconds, p.bytes / 1e6)
            },
        );
        println!("| {} | {triangles} | {:.3} | {:.1} | {rest} |", scene.name(), own.seconds, own.bytes / 1e6);
    }
    if rows.iter().any(|r| r.peer.is_some()) {
        print_targets(rows, trees);
    }
}

fn print_targets(rows: &[Row], trees: &[Built]) {
    println!("\n| ratio to Embree | target | worst | mean |\n|---|---|---|---|");
    for target in &TARGETS {
        let wanted =
            rows.iter().filter(|r| target.rays.contains(&r.rays) && target.scenes.contains(&r.scene));
        let ratios: Vec<_> = wanted.filter_map(|r| Some(target.ratio.of(r, r.peer.as_ref()?))).collect();
        let worst = ratios.iter().copied().reduce(f64::min);
        print_target(target.name, &format!("≥ {:.2}", target.least), worst, &ratios);
    }
    let large = trees.iter().filter(|t| LARGE.contains(&t.scene));
    let pairs: Vec<_> = large.filter_map(|t| Some((t.own, t.peer?))).collect();
    let times: Vec<_> = pairs.iter().map(|(own, peer)| own.seconds / peer.seconds).collect();
    let memory: Vec<_> = pairs.iter().map(|(own, peer)| own.bytes / peer.bytes).collect();
    for (name, target, ratios) in [("build, CPU time", "≤ 1.10", times), ("memory", "≤ 0.70", memory)] {
        print_target(name, target, ratios.iter().copied().reduce(f64::max), &ratios);
    }
}

/// A target with the worst and the geometric mean of its ratios; nothing when none was measured.
fn print_target(name: &str, target: &str, worst: Option<f64>, ratios: &[f64]) {
    let Some(worst) = worst else { return };
    let mean = (ratios.iter().map(|r| r.ln()).sum::<f64>() / ratios.len() as f64).exp();
    println!("| {name} | {target} | {worst:.2} | {mean:.2} |");
}
