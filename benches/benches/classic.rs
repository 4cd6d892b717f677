//! The classic renderer: the course work's benchmark with and without its dome of glass, and soft shadows of 64 points.
//!
//! `cargo bench --bench classic`

use divan::Bencher;
use vitrine_benches::{Ready, soft_shadows};
use vitrine_scene::Assets;

fn main() {
    divan::main();
}

/// 809 × 817, depth 3, one sample a pixel.
#[divan::bench(args = [1, 2], sample_count = 20)]
fn coursework_benchmark(bencher: Bencher, threads: usize) {
    let ready = Ready::example("coursework/benchmark.vitrine.toml");
    bencher.bench_local(|| ready.render(threads));
}

/// The same without the dome of glass, which costs more than all else.
#[divan::bench(args = [1, 2], sample_count = 20)]
fn without_the_dome(bencher: Bencher, threads: usize) {
    let ready = Ready::benchmark_without_dome();
    bencher.bench_local(|| ready.render(threads));
}

/// 809 × 817, one disc lamp, every one of 64 points tried.
#[divan::bench(args = [1, 2], sample_count = 10)]
fn soft_shadows_64_points(bencher: Bencher, threads: usize) {
    let ready = Ready::new(&soft_shadows(64), &Assets::default());
    bencher.bench_local(|| ready.render(threads));
}
