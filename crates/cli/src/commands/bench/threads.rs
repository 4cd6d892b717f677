//! `vitrine bench threads`: time against the number of threads (course work, section 4.1).

use crate::failure::{Exit, Failure};
use crate::flags::SettingFlags;
use crate::picture;
use crate::progress::Bar;
use crate::report::Report;
use crate::stopwatch::Elapsed;
use crate::{console, draw, interrupt, output, values};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;
use vitrine::render::threads::of_machine;
use vitrine::templates::{Existing, Template};
use vitrine::{Cancel, Progress, Project, formats};

/// The scene that is measured when nobody names one.
const DEFAULT_SCENE: &str = "benchmark";

/// Measure the time of a picture against the number of threads
///
/// Every number of threads renders the same picture several times, in turns; the table shows the median of each. The
/// speed-up is against one thread, which is always measured.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  \
    vitrine bench threads\n  \
    vitrine bench threads --threads 1,2,4,8 --repeats 5 --csv threads.csv --plot threads.svg\n  \
    vitrine bench threads ball.vitrine.toml --size 400x300")]
pub struct Threads {
    /// The scene file; without it, the template `benchmark`
    scene: Option<PathBuf>,

    /// The numbers of threads, such as 1,2,4; without it, 1 to twice the number of cores
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = values::thread_count, allow_hyphen_values = true)]
    threads: Vec<usize>,

    /// How many times each is measured
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1000))]
    repeats: u16,

    /// Write the table as comma-separated values
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Draw the times, as .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,

    /// No progress bar
    #[arg(short, long)]
    quiet: bool,

    #[command(flatten)]
    settings: SettingFlags,
}

/// The median times for one number of threads.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// How many threads.
    pub threads: usize,
    /// Median times.
    pub median: Elapsed,
}

impl Threads {
    /// Runs the command.
    pub fn run(self) -> Result<Exit, Failure> {
        let cancel = interrupt::cancel_on_interrupt()?;
        if let Some(path) = &self.plot {
            draw::check_plot(path)?;
        }
        if let Some(path) = &self.csv {
            output::check_place(path)?;
        }
        let mut project = self.load()?;
        self.settings.apply(&mut project)?;
        let counts = self.counts();
        let Some(measured) = self.measure(&project, &counts, &cancel)? else {
            return Ok(Exit::Interrupted);
        };
        let [width, height] = project.scene.settings.size;
        console::print(format!(
            "{}, {width} × {height} pixels, median of {}, {}\n\n{}",
            project.name(),
            self.repeats,
            vitrine::summary::plural(of_machine() as u64, "core"),
            table(&measured)
        ))?;
        if let Some(path) = &self.csv {
            formats::write_atomically(path, csv(&measured).as_bytes())?;
        }
        if let Some(path) = &self.plot {
            draw::plot(path, &draw::Threads { scene: &project.name(), measured: &measured })?;
        }
        Ok(Exit::Done)
    }

    fn load(&self) -> Result<Project, Failure> {
        if let Some(path) = &self.scene {
            return Ok(vitrine::load(path)?);
        }
        let template = Template::find(DEFAULT_SCENE).expect("the benchmark is among the templates");
        let no_folder = |error| {
            Failure::new(Exit::Failed, Report::error(format!("cannot make a temporary folder: {error}")))
        };
        let folder = tempfile::tempdir().map_err(no_folder)?;
        let path = folder.path().join(format!("{DEFAULT_SCENE}.vitrine.toml"));
        template.write(&path, Existing::Keep)?;
        Ok(vitrine::load(&path)?)
    }

    /// The numbers of threads, rising, each once, 1 among them.
    fn counts(&self) -> Vec<usize> {
        let mut counts = self.threads.clone();
        if counts.is_empty() {
            counts.extend(1..=2 * of_machine());
        }
        counts.push(1);
        counts.sort_unstable();
        counts.dedup();
        counts
    }

    /// Measures in turns, so that a slow spell of the machine hits all alike. None when interrupted.
    fn measure(
        &self,
        project: &Project,
        counts: &[usize],
        cancel: &Cancel,
    ) -> Result<Option<Vec<Measured>>, Failure> {
        let bar = Bar::new(self.quiet);
        let compiled = picture::compile(project)?;
        bar.begin("Measuring");
        let samples_total = counts.len() as u64 * u64::from(self.repeats);
        let mut times = vec![Vec::new(); counts.len()];
        for repeat in 0..u64::from(self.repeats) {
            for (done, (times, &threads)) in times.iter_mut().zip(counts).enumerate() {
                let samples_done = repeat * counts.len() as u64 + done as u64;
                bar.show(Progress { samples_done, samples_total, noise: None });
                let made = picture::make(&compiled, project.options(), threads, cancel, &mut |_| {})?;
                if !made.rendered.is_complete() {
                    return Ok(None);
                }
                times.push(made.elapsed);
            }
        }
        let measured = counts.iter().zip(&times);
        Ok(Some(measured.map(|(&threads, times)| Measured { threads, median: median(times) }).collect()))
    }
}

/// The median of the wall times and that of the processor times.
fn median(times: &[Elapsed]) -> Elapsed {
    let middle = |mut times: Vec<Duration>| {
        times.sort_unstable();
        let (low, high) = (times[(times.len() - 1) / 2], times[times.len() / 2]);
        (low + high) / 2
    };
    Elapsed {
        wall: middle(times.iter().map(|t| t.wall).collect()),
        cpu: middle(times.iter().map(|t| t.cpu).collect()),
    }
}

/// How many times faster than one thread, the first of the list.
fn speed_up(measured: &[Measured], one: &Measured) -> f64 {
    measured[0].median.wall.as_secs_f64() / one.median.wall.as_secs_f64().max(1e-9)
}

fn table(measured: &[Measured]) -> String {
    let head = ["Threads", "Time, s", "CPU time, s", "Speed-up"].map(str::to_owned).to_vec();
    let rows = measured.iter().map(|m| {
        vec![
            m.threads.to_string(),
            format!("{:.3}", m.median.wall.as_secs_f64()),
            format!("{:.3}", m.median.cpu.as_secs_f64()),
            format!("{:.2}", speed_up(measured, m)),
        ]
    });
    console::table(&std::iter::once(head).chain(rows).collect::<Vec<_>>(), true)
}

fn csv(measured: &[Measured]) -> String {
    let rows = measured.iter().map(|m| {
        let (wall, cpu) = (m.median.wall.as_secs_f64(), m.median.cpu.as_secs_f64());
        format!("{},{wall:.6},{cpu:.6},{:.4}\n", m.threads, speed_up(measured, m))
    });
    std::iter::once("threads,wall_seconds,cpu_seconds,speed_up\n".to_owned()).chain(rows).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn elapsed(wall: u64, cpu: u64) -> Elapsed {
        Elapsed { wall: Duration::from_millis(wall), cpu: Duration::from_millis(cpu) }
    }

    #[test]
    fn medians_of_odd_and_even_lists() {
        let odd = median(&[elapsed(900, 1), elapsed(100, 3), elapsed(200, 2)]);
        assert_eq!((odd.wall.as_millis(), odd.cpu.as_millis()), (200, 2));
        let even = median(&[elapsed(100, 1), elapsed(200, 1)]);
        assert_eq!(even.wall.as_millis(), 150);
    }

    #[test]
    fn the_table_lines_up_and_the_file_has_a_row_for_each() {
        let measured = [
            Measured { threads: 1, median: elapsed(2000, 1990) },
            Measured { threads: 12, median: elapsed(1000, 2010) },
        ];
        assert_eq!(
            table(&measured),
            "Threads  Time, s  CPU time, s  Speed-up\n      \
             1    2.000        1.990      1.00\n     \
             12    1.000        2.010      2.00\n"
        );
        assert_eq!(csv(&measured).lines().nth(2), Some("12,1.000000,2.010000,2.0000"));
    }
}
