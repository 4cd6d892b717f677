//! What is printed: a row for each set of rays, a row for each tree, and how far the targets are.

use crate::embree::Peer;
use std::fmt;
use vitrine_measure::rays::RayKind;
use vitrine_measure::{Kernel, Scene, SceneKind};

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
    /// The share of rays on which it, watertight, and Vitrine's single rays do not agree, 0 to 1.
    pub single_disagreement: f64,
    /// The share of rays on which its sixteen and Vitrine's packets do not agree, 0 to 1.
    pub packet_disagreement: f64,
}

/// The head of the rows.
pub const HEAD: &str = "\
| scene | rays | Vitrine 1 | Vitrine packets | Embree 1 | Embree 1 robust | Embree 16 | 1 ÷ 1 | 1 ÷ robust | packets ÷ 16 | hits differ, of a million |
|---|---|---|---|---|---|---|---|---|---|---|";

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (scene, rays) = (self.scene.name(), self.rays.name());
        let own = self.own_disagreement * 1e6;
        write!(f, "| {scene} | {rays} | {:.2} | {:.2} | ", self.single, self.packets)?;
        let Some(peer) = &self.peer else {
            return write!(f, "| | | | | | own {own:.0} |");
        };
        let [one, robust, sixteen] =
            [Ratio::Single, Ratio::Watertight, Ratio::Packets].map(|r| r.of(self, peer));
        write!(f, "{:.2} | {:.2} | {:.2} | ", peer.single, peer.watertight, peer.sixteen)?;
        write!(f, "{one:.2} | {robust:.2} | {sixteen:.2} | ")?;
        let [one, sixteen] = [peer.single_disagreement, peer.packet_disagreement].map(|share| share * 1e6);
        write!(f, "own {own:.0}, 1 {one:.0}, 16 {sixteen:.0} |")
    }
}

/// Which speeds are compared.
#[derive(Clone, Copy)]
enum Ratio {
    Single,
    Watertight,
    Packets,
}

impl Ratio {
    fn of(self, row: &Row, peer: &PeerSpeeds) -> f64 {
        match self {
            Self::Single => row.single / peer.single,
            Self::Watertight => row.single / peer.watertight,
            Self::Packets => row.packets / peer.sixteen,
        }
    }
}

/// What building a scene's tree took.
pub struct Built {
    scene: SceneKind,
    triangles: usize,
    own: Tree,
    peer: Option<Tree>,
}

#[derive(Clone, Copy)]
struct Tree {
    /// Seconds of processor time.
    seconds: f64,
    bytes: f64,
}

impl Built {
    pub fn new(kind: SceneKind, scene: &Scene, kernel: &Kernel, peer: Option<&Peer>) -> Self {
        let tree = |time: std::time::Duration, bytes: usize| Tree {
            seconds: time.as_secs_f64(),
            bytes: bytes as f64,
        };
        Self {
            scene: kind,
            triangles: scene.triangles(),
            own: tree(kernel.build_time(), kernel.memory()),
            peer: peer.map(|p| tree(p.build_time(), p.memory())),
        }
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
        name: "single diffuse rays, 1.3 M triangles",
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
pub fn print(rows: &[Row], builds: &[Built]) {
    println!(
        "\n| scene | triangles | build, CPU s | memory, MB | Embree: build, CPU s | memory, MB | time ÷ | memory ÷ |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for Built { scene, triangles, own, peer } in builds {
        let (name, megabytes) = (scene.name(), own.bytes / 1e6);
        let rest = peer.map_or("| | | ".to_owned(), |p| {
            let (time, memory) = (own.seconds / p.seconds, own.bytes / p.bytes);
            format!("{:.3} | {:.1} | {time:.2} | {memory:.2}", p.seconds, p.bytes / 1e6)
        });
        println!("| {name} | {triangles} | {:.3} | {megabytes:.1} | {rest} |", own.seconds);
    }
    let measured = TARGETS.iter().filter_map(|target| Some((target, reached(target, rows)?)));
    let measured: Vec<_> = measured.collect();
    if !measured.is_empty() {
        println!("\n| ratio to Embree | target | least | mean |\n|---|---|---|---|");
    }
    for (target, [least, mean]) in measured {
        println!("| {} | ≥ {:.2} | {least:.2} | {mean:.2} |", target.name, target.least);
    }
}

/// The least and the geometric mean of a target's ratios; None when none was measured.
fn reached(target: &Target, rows: &[Row]) -> Option<[f64; 2]> {
    let wanted = rows.iter().filter(|r| target.rays.contains(&r.rays) && target.scenes.contains(&r.scene));
    let ratios: Vec<_> = wanted.filter_map(|r| Some(target.ratio.of(r, r.peer.as_ref()?))).collect();
    let least = ratios.iter().copied().reduce(f64::min)?;
    let mean = (ratios.iter().map(|r| r.ln()).sum::<f64>() / ratios.len() as f64).exp();
    Some([least, mean])
}
