//! The ray kernel, and Embree 4 beside it over the same rays.
//!
//! `cargo bench --bench kernel`. With `VITRINE_EMBREE=/path/to/libembree4.so.4` in the environment Embree takes part.
//! `cargo bench --bench kernel -- --help` shows what can be chosen.
//!
//! Both find the same rays in memory in the form that they want, and leave the hits there; only the calls are measured. What
//! differs: Embree's tree has one level and its floor has an end, so a few far hits differ in the seed; its threads are
//! limited to one, while Vitrine's builder takes all of the machine: compared is the processor time of all of them.

// A bench talks to the person who runs it.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod embree;
mod options;
mod report;

use embree::{Edges, Embree, Peer};
use options::Options;
use report::{Built, HEAD, PeerSpeeds, Row, Tree};
use std::process::ExitCode;
use vitrine_measure::race::{self, Contender};
use vitrine_measure::rays::{RaySet, ray_sets};
use vitrine_measure::{Kernel, Scene, SceneKind};

/// The variable that names Embree's library.
const VARIABLE: &str = "VITRINE_EMBREE";

/// How many times each tree is built.
const BUILDS: usize = 5;

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
    match &embree {
        Some(embree) => println!("Beside Embree {}.", embree.version()),
        None => println!("Without Embree: {VARIABLE} does not name its library (libembree4.so.4)."),
    }
    println!(
        "Processor time of one thread, median of {} rounds; million rays a second; instructions: {}\n\n{HEAD}",
        options.rounds,
        vitrine_measure::kernel::instructions()
    );
    let (mut rows, mut trees) = (Vec::new(), Vec::new());
    for &kind in &options.scenes {
        let scene = kind.scene(options.triangles(kind));
        let (built, kernel, peers) = build(kind, &scene, embree.as_ref())?;
        trees.push(built);
        for set in ray_sets(&scene, &kernel, options.size, &options.rays) {
            let row = measure(kind, &set, &kernel, peers.as_ref(), options.rounds);
            println!("{row}");
            rows.push(row);
        }
    }
    report::print(&rows, &trees);
    Ok(())
}

/// A scene in Embree, once as it is by default, once watertight.
struct Peers {
    fast: Peer,
    watertight: Peer,
}

/// Builds a scene's trees several times, in turns; gives the last of them and the median times.
fn build(
    kind: SceneKind,
    scene: &Scene,
    embree: Option<&Embree>,
) -> Result<(Built, Kernel, Option<Peers>), String> {
    let (mut own_times, mut peer_times) = (Vec::new(), Vec::new());
    let mut last = None;
    for _ in 0..BUILDS {
        // One at a time in memory.
        drop(last.take());
        let kernel = Kernel::build(scene);
        own_times.push(kernel.build_time());
        let fast = embree.map(|e| Peer::build(e, scene, Edges::Fast)).transpose()?;
        peer_times.extend(fast.as_ref().map(Peer::build_time));
        last = Some((kernel, fast));
    }
    let (kernel, fast) = last.expect("there is one round at least");
    let own = Tree::new(race::median(own_times), kernel.memory());
    let peer = fast.as_ref().map(|fast| Tree::new(race::median(peer_times), fast.memory()));
    let peers = match (embree, fast) {
        (Some(e), Some(fast)) => Some(Peers { fast, watertight: Peer::build(e, scene, Edges::Watertight)? }),
        _ => None,
    };
    Ok((Built { scene: kind, triangles: scene.triangles(), own, peer }, kernel, peers))
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
    let is_coherent = set.kind.is_coherent();
    let mut fast = peers.fast.single(query);
    let mut watertight = peers.watertight.single(query);
    let mut sixteen = peers.fast.packets(query, is_coherent);
    let mut watertight_sixteen = peers.watertight.packets(query, is_coherent);
    let single_disagreement = race::disagreement(&alone, &race::distances(&mut watertight, &set.rays));
    let packet_disagreement =
        race::disagreement(&together, &race::distances(&mut watertight_sixteen, &set.rays));
    let [own_single, own_packets] = own;
    let mut all =
        [own_single, own_packets, &mut fast, &mut watertight, &mut sixteen, &mut watertight_sixteen];
    let speeds = race::race(&mut all, &set.rays, rounds);
    let peer = PeerSpeeds {
        single: speeds[2],
        watertight: speeds[3],
        sixteen: speeds[4],
        watertight_sixteen: speeds[5],
        single_disagreement,
        packet_disagreement,
    };
    Row { scene, rays: set.kind, single: speeds[0], packets: speeds[1], peer: Some(peer), own_disagreement }
}
