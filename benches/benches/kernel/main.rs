//! The ray kernel, and Embree 4 beside it over the same rays.
//!
//! `cargo bench --bench kernel`. With `VITRINE_EMBREE=/path/to/libembree4.so.4` in the environment Embree takes part.
//! `cargo bench --bench kernel -- --help` shows what can be chosen.

// A bench talks to the person who runs it.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod embree;
mod options;
mod report;

use embree::{Edges, Embree, Peer};
use options::Options;
use report::{Built, HEAD, PeerSpeeds, Row};
use std::process::ExitCode;
use vitrine_measure::race::{self, Contender};
use vitrine_measure::rays::{RaySet, ray_sets};
use vitrine_measure::{Kernel, Scene, SceneKind};

/// The variable that names Embree's library.
const VARIABLE: &str = "VITRINE_EMBREE";

fn main() -> ExitCode {
    match Options::read(std::env::args().skip(1)).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    let embree = std::env::var_os(VARIABLE).map(|path| Embree::load(path.as_ref())).transpose()?;
    if embree.is_none() {
        println!("Without Embree: {VARIABLE} does not name its library (libembree4.so.4).");
    }
    println!(
        "Processor time of one thread, median of {} rounds; million rays a second; instructions: {}\n\n{HEAD}",
        options.rounds,
        vitrine_measure::kernel::instructions()
    );
    let (mut rows, mut builds) = (Vec::new(), Vec::new());
    for &kind in &options.scenes {
        let scene = kind.scene(options.triangles(kind));
        let kernel = Kernel::build(&scene);
        let peers = match &embree {
            Some(embree) => Some(Peers::build(embree, &scene)?),
            None => None,
        };
        builds.push(Built::new(kind, &scene, &kernel, peers.as_ref().map(|p| &p.fast)));
        for set in ray_sets(&scene, &kernel, options.size, &options.rays) {
            let row = measure(kind, &set, &kernel, peers.as_ref(), options.rounds);
            println!("{row}");
            rows.push(row);
        }
    }
    report::print(&rows, &builds);
    Ok(())
}

/// A scene in Embree, once as it is by default, once watertight.
struct Peers {
    fast: Peer,
    watertight: Peer,
}

impl Peers {
    fn build(embree: &Embree, scene: &Scene) -> Result<Self, String> {
        Ok(Self {
            fast: Peer::build(embree, scene, Edges::Fast)?,
            watertight: Peer::build(embree, scene, Edges::Watertight)?,
        })
    }
}

fn measure(scene: SceneKind, set: &RaySet, kernel: &Kernel, peers: Option<&Peers>, rounds: usize) -> Row {
    let query = set.kind.query();
    let mut single = kernel.single(query);
    let mut packets = kernel.packets(query);
    let mut own: [&mut dyn Contender; 2] = [&mut single, &mut packets];
    let [alone, together] = own.each_mut().map(|c| race::distances(*c, &set.rays));
    let own_disagreement = race::disagreement(&alone, &together);
    let Some(peers) = peers else {
        let speeds = race::race(&mut own, &set.rays, rounds);
        let (single, packets) = (speeds[0], speeds[1]);
        return Row { scene, rays: set.kind, single, packets, peer: None, own_disagreement };
    };
    let mut fast = peers.fast.single(query);
    let mut watertight = peers.watertight.single(query);
    let mut sixteen = peers.fast.packets(query, set.kind.is_coherent());
    let single_disagreement = race::disagreement(&alone, &race::distances(&mut watertight, &set.rays));
    let packet_disagreement = race::disagreement(&together, &race::distances(&mut sixteen, &set.rays));
    let [own_single, own_packets] = own;
    let mut all = [own_single, own_packets, &mut fast, &mut watertight, &mut sixteen];
    let speeds = race::race(&mut all, &set.rays, rounds);
    let peer = PeerSpeeds {
        single: speeds[2],
        watertight: speeds[3],
        sixteen: speeds[4],
        single_disagreement,
        packet_disagreement,
    };
    Row { scene, rays: set.kind, single: speeds[0], packets: speeds[1], peer: Some(peer), own_disagreement }
}
