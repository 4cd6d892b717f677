//! Wall and processor time of a piece of work.

use cpu_time::ProcessTime;
use std::time::{Duration, Instant};

/// A running watch.
#[derive(Clone, Copy, Debug)]
pub struct Stopwatch {
    wall: Instant,
    cpu: ProcessTime,
}

/// What a watch shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Elapsed {
    /// As on a clock on the wall.
    pub wall: Duration,
    /// User and system time of all threads of this process together.
    pub cpu: Duration,
}

impl Stopwatch {
    /// Starts one.
    pub fn start() -> Self {
        Self { wall: Instant::now(), cpu: ProcessTime::now() }
    }

    /// Reads it.
    pub fn elapsed(&self) -> Elapsed {
        Elapsed { wall: self.wall.elapsed(), cpu: self.cpu.elapsed() }
    }
}

/// "0.8 s", "42 s", "3 min 20 s", "2 h 5 min".
pub fn words(duration: Duration) -> String {
    let seconds = duration.as_secs();
    match seconds {
        0..10 => format!("{:.1} s", duration.as_secs_f64()),
        10..60 => format!("{seconds} s"),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        _ => format!("{} h {} min", seconds / 3600, seconds % 3600 / 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_in_words() {
        let of = |seconds| words(Duration::from_secs_f64(seconds));
        assert_eq!([of(0.25), of(59.9), of(200.0), of(7500.0)], ["0.2 s", "59 s", "3 min 20 s", "2 h 5 min"]);
    }
}
