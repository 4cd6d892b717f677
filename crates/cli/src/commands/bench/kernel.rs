//! `vitrine bench kernel`: how many rays a second this machine traces, and how that changes with the size of a scene.

use super::growth;
use crate::failure::{Exit, Failure};
use crate::progress::Bar;
use crate::{console, draw, output, values};
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::path::PathBuf;
use vitrine::measure::race::{self, Contender};
use vitrine::measure::rays::{RayKind, RaySet, ray_sets};
use vitrine::measure::{Kernel, SceneKind, kernel};
use vitrine::{Progress, formats};

/// Measure how many rays a second this machine traces
///
/// Rays are shot through scenes that the program makes: `seed` (balls, a floor and four cones), `room` (many things in a
/// room) and `cave` (one large model around the camera). The rays are those that a renderer would shoot: primary rays from
/// the camera, shadow rays to a lamp, mirror rays, diffuse rays in random directions, and ambient rays, which look for near
/// things. The table shows million rays a second of one thread by its processor time, each ray traced alone, and many
/// together in packets.
///
/// With --growth caves of 1000 triangles to 10 million show how the time of a ray grows: with the logarithm of their
/// number, as far as the processor's caches reach.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine bench kernel\n  \
    vitrine bench kernel --scenes cave --triangles 100000 --csv kernel.csv\n  \
    vitrine bench kernel --growth --plot growth.svg")]
pub struct KernelBench {
    /// The scenes: seed, room, cave; without it, all of them
    #[arg(long, value_name = "LIST", value_delimiter = ',', conflicts_with = "growth",
          value_parser = PossibleValuesParser::new(SceneKind::ALL.map(SceneKind::name)), hide_possible_values = true)]
    scenes: Vec<String>,

    /// About how many triangles room and cave have, or with --growth the largest cave; without it, 500,000, 1,310,720
    /// and 10,000,000
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1000..=50_000_000))]
    triangles: Option<u32>,

    /// Width and height of the picture that the camera rays are for
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true, default_value = "816x824")]
    size: [u32; 2],

    /// How many times each is measured
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    repeats: u16,

    /// Measure the time of a ray against the number of triangles
    #[arg(long)]
    growth: bool,

    /// Draw the growth, as .svg or .png
    #[arg(long, value_name = "FILE", requires = "growth")]
    plot: Option<PathBuf>,

    /// Write the table as comma-separated values
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// No progress bar
    #[arg(short, long)]
    quiet: bool,
}

/// How fast the rays of one kind are in one scene, million rays a second.
struct Speed {
    rays: RayKind,
    single: f64,
    packets: f64,
}

/// What was measured in one scene.
struct Measured {
    name: &'static str,
    triangles: usize,
    build_seconds: f64,
    memory: usize,
    speeds: Vec<Speed>,
}

impl KernelBench {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        if let Some(path) = &self.plot {
            draw::check_plot(path)?;
        }
        if let Some(path) = &self.csv {
            output::check_place(path)?;
        }
        if self.growth { self.run_growth() } else { self.run_scenes() }
    }

    fn run_scenes(&self) -> Result<Exit, Failure> {
        let bar = self.bar();
        let is_wanted = |k: &SceneKind| self.scenes.is_empty() || self.scenes.iter().any(|s| s == k.name());
        let kinds: Vec<_> = SceneKind::ALL.into_iter().filter(is_wanted).collect();
        let samples_total = (kinds.len() * RayKind::ALL.len()) as u64;
        let mut measured = Vec::new();
        for kind in kinds {
            let samples_done = (measured.len() * RayKind::ALL.len()) as u64;
            measured.push(self.measure(kind, |sets| {
                bar.show(Progress { samples_done: samples_done + sets, samples_total, noise: None });
            }));
        }
        drop(bar);
        let text = format!(
            "{}\n\nMillion rays a second:\n{}\nThe trees:\n{}",
            self.opening(),
            speeds_table(&measured),
            trees_table(&measured)
        );
        console::print(text)?;
        self.write_csv(&csv(&measured))
    }

    fn run_growth(&self) -> Result<Exit, Failure> {
        let bar = self.bar();
        let most = self.triangles.unwrap_or(growth::MOST);
        let steps =
            growth::measure(most, self.size, usize::from(self.repeats), |progress| bar.show(progress));
        drop(bar);
        let curves = growth::curves(&steps);
        console::print(format!("{}\n\n{}", self.opening(), growth::table(&steps, &curves)))?;
        if let Some(path) = &self.plot {
            draw::plot(path, &draw::Growth { curves: &curves })?;
        }
        self.write_csv(&growth::csv(&steps))
    }

    fn bar(&self) -> Bar {
        let bar = Bar::new(self.quiet);
        bar.begin("Measuring");
        bar
    }

    fn measure(&self, kind: SceneKind, mut progress: impl FnMut(u64)) -> Measured {
        progress(0);
        let scene = kind.scene(self.triangles.unwrap_or(kind.triangles()));
        let kernel = Kernel::build(&scene);
        let mut speeds = Vec::new();
        for set in ray_sets(&scene, &kernel, self.size, &RayKind::ALL) {
            let [single, packets] = race_own(&kernel, &set, usize::from(self.repeats));
            speeds.push(Speed { rays: set.kind, single, packets });
            progress(speeds.len() as u64);
        }
        Measured {
            name: kind.name(),
            triangles: scene.triangles(),
            build_seconds: kernel.build_time().as_secs_f64(),
            memory: kernel.memory(),
            speeds,
        }
    }

    fn opening(&self) -> String {
        let [width, height] = self.size;
        format!(
            "{}, one thread, processor time, median of {}, rays for {width} × {height} pixels",
            kernel::instructions(),
            self.repeats
        )
    }

    fn write_csv(&self, text: &str) -> Result<Exit, Failure> {
        if let Some(path) = &self.csv {
            formats::write_atomically(path, text.as_bytes())?;
        }
        Ok(Exit::Done)
    }
}

/// Million rays a second, one at a time and in packets.
pub fn race_own(kernel: &Kernel, set: &RaySet, rounds: usize) -> [f64; 2] {
    let (mut single, mut packets) = (kernel.single(set.kind.query()), kernel.packets(set.kind.query()));
    let mut contenders: [&mut dyn Contender; 2] = [&mut single, &mut packets];
    let speeds = race::race(&mut contenders, &set.rays, rounds);
    [speeds[0], speeds[1]]
}

fn speeds_table(measured: &[Measured]) -> String {
    let mut rows = vec![["Scene", "Rays", "Alone", "In packets"].map(str::to_owned).to_vec()];
    for m in measured {
        rows.extend(m.speeds.iter().map(|s| {
            let [single, packets] = [s.single, s.packets].map(|speed| format!("{speed:.2}"));
            vec![m.name.to_owned(), s.rays.name().to_owned(), single, packets]
        }));
    }
    console::table(&rows, true)
}

fn trees_table(measured: &[Measured]) -> String {
    let mut rows = vec![["Scene", "Triangles", "Built, CPU s", "Memory, MB"].map(str::to_owned).to_vec()];
    rows.extend(measured.iter().map(|m| {
        let triangles = console::thousands(m.triangles as u64);
        let memory = format!("{:.1}", m.memory as f64 / 1e6);
        vec![m.name.to_owned(), triangles, format!("{:.3}", m.build_seconds), memory]
    }));
    console::table(&rows, true)
}

fn csv(measured: &[Measured]) -> String {
    let mut text = "scene,triangles,build_cpu_seconds,memory_bytes,rays,single_million_rays_per_second,\
                    packets_million_rays_per_second\n"
        .to_owned();
    for m in measured {
        for s in &m.speeds {
            let Measured { name, triangles, build_seconds, memory, .. } = m;
            let (rays, single, packets) = (s.rays.name(), s.single, s.packets);
            text +=
                &format!("{name},{triangles},{build_seconds:.6},{memory},{rays},{single:.4},{packets:.4}\n");
        }
    }
    text
}
