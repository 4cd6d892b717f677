//! The race: kernels take turns over the same rays, block by block, so that a slow spell of the machine or a cold cache
//! meets all of them alike. Measured is the processor time of the thread, not the time on the wall.

use cpu_time::{ProcessTime, ThreadTime};
use std::time::Duration;
use vitrine_math::Ray;

/// Rays in a block: few enough to stay in a core's cache, enough to hide the reading of the clock (half a microsecond, so
/// about 1 % at 100 million rays a second).
pub const BLOCK: usize = 4096;

/// What [`Contender::read`] gives for a ray that meets nothing.
pub const NOTHING: f32 = f32::INFINITY;

/// What is asked of each ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Query {
    /// The nearest hit.
    Closest,
    /// Whether there is any hit.
    Occlusion,
}

/// A kernel that takes part.
pub trait Contender {
    /// Takes over a block of rays in the form that the kernel wants. Not measured.
    fn load(&mut self, rays: &[Ray]);

    /// Traces the block. This is measured.
    fn cast(&mut self);

    /// Appends what was found: for each ray the distance to the nearest hit, or 0 for an occluded ray; [`NOTHING`] when
    /// there is no hit. Not measured.
    fn read(&self, distances: &mut Vec<f32>);
}

/// What a kernel found, ray by ray.
#[must_use]
pub fn distances(contender: &mut dyn Contender, rays: &[Ray]) -> Vec<f32> {
    let mut found = Vec::with_capacity(rays.len());
    for block in rays.chunks(BLOCK) {
        contender.load(block);
        contender.cast();
        contender.read(&mut found);
    }
    found
}

/// The share of rays, 0 to 1, where one kernel hits and the other does not, or their distances differ by more than one in
/// ten thousand.
#[must_use]
pub fn disagreement(a: &[f32], b: &[f32]) -> f64 {
    const TOLERANCE: f32 = 1e-4;
    let differ = |(&a, &b): (&f32, &f32)| {
        (a == NOTHING) != (b == NOTHING) || (a != NOTHING && (a - b).abs() > TOLERANCE * a.abs().max(b.abs()))
    };
    let differing = a.iter().zip(b).filter(|&pair| differ(pair)).count();
    differing as f64 / a.len().max(1) as f64
}

/// The speed of each contender over all rays, million rays a second, by the median of its times. Each round is one pass
/// over all rays. They are cut into blocks; each block is traced by all contenders, and another one begins each time.
///
/// # Panics
/// Without rounds.
pub fn race(contenders: &mut [&mut dyn Contender], rays: &[Ray], rounds: usize) -> Vec<f64> {
    assert!(rounds > 0, "a race has rounds");
    let count = contenders.len();
    let mut times = vec![Vec::with_capacity(rounds); count];
    for round in 0..rounds {
        let mut sums = vec![Duration::ZERO; count];
        for (i, block) in rays.chunks(BLOCK).enumerate() {
            for k in 0..count {
                let turn = (i + round + k) % count;
                contenders[turn].load(block);
                let start = ThreadTime::now();
                contenders[turn].cast();
                sums[turn] += start.elapsed();
            }
        }
        times.iter_mut().zip(sums).for_each(|(times, sum)| times.push(sum));
    }
    let millions = rays.len() as f64 / 1e6;
    times.into_iter().map(|times| millions / median(times).as_secs_f64().max(1e-9)).collect()
}

/// The middle one, or the mean of the two in the middle.
///
/// # Panics
/// When there is none.
#[must_use]
pub fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    let n = times.len();
    (times[(n - 1) / 2] + times[n / 2]) / 2
}

/// Runs something; gives its result and the processor time of all threads together that it took.
pub fn cpu_time_of<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = ProcessTime::now();
    let result = work();
    (result, start.elapsed())
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine_math::Vec3;

    /// Finds something at x; counts its rays.
    struct Found {
        rays: Vec<Ray>,
        cast: usize,
    }

    impl Contender for Found {
        fn load(&mut self, rays: &[Ray]) {
            self.rays = rays.to_vec();
        }

        fn cast(&mut self) {
            self.cast += self.rays.len();
        }

        fn read(&self, distances: &mut Vec<f32>) {
            distances.extend(self.rays.iter().map(|r| r.origin.x));
        }
    }

    fn rays(count: usize) -> Vec<Ray> {
        (0..count).map(|i| Ray::new(Vec3::X * i as f32, Vec3::Z)).collect()
    }

    #[test]
    fn every_contender_traces_every_ray_in_every_round_and_in_order() {
        let rays = rays(2 * BLOCK + 5);
        let [mut a, mut b] = [0, 0].map(|cast| Found { rays: Vec::new(), cast });
        assert_eq!(race(&mut [&mut a, &mut b], &rays, 3).len(), 2);
        assert_eq!((a.cast, b.cast), (3 * rays.len(), 3 * rays.len()));
        let found = distances(&mut a, &rays);
        assert!(found.iter().enumerate().all(|(i, &x)| x == i as f32) && found.len() == rays.len());
    }

    #[test]
    fn kernels_disagree_on_other_hits_and_other_distances() {
        let n = NOTHING;
        assert_eq!(disagreement(&[1.0, n, 0.0, 5.0], &[1.000_01, n, 0.0, 5.0]), 0.0);
        assert_eq!(disagreement(&[1.0, n, 3.0, n], &[1.001, 1.0, n, n]), 0.75);
        assert_eq!(disagreement(&[], &[]), 0.0);
    }

    #[test]
    fn the_median_is_the_middle_one() {
        let ms = |v: &[u64]| median(v.iter().map(|&t| Duration::from_millis(t)).collect()).as_millis();
        assert_eq!((ms(&[9, 1, 2]), ms(&[4, 2])), (2, 3));
    }
}
