//! Large models: reading the OBJ file, building the tree, moving an object, the first picture.
//!
//! `cargo bench --bench mesh`. Watch how the times grow from one size to the next: n log n is a little over ten times.

use divan::Bencher;
use std::path::Path;
use vitrine_benches::{Ready, model, write_bumpy_ball};
use vitrine_formats::{load_assets, read_mesh};
use vitrine_render::compile;

const TRIANGLES: [u32; 3] = [10_000, 100_000, 1_000_000];

fn main() {
    divan::main();
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn read_obj(bencher: Bencher, triangles: u32) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = write_bumpy_ball(folder.path(), triangles).expect("room for the model");
    bencher.bench_local(|| read_mesh(&path).expect("the model can be read"));
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn build_tree(bencher: Bencher, triangles: u32) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = write_bumpy_ball(folder.path(), triangles).expect("room for the model");
    let scene = model(&path);
    let (assets, _) = load_assets(&scene, Path::new("")).expect("the model can be read");
    bencher.bench_local(|| compile(&scene, &assets).expect("the scene compiles"));
}

/// One object moved: no model is touched, so the time does not grow.
#[divan::bench(args = TRIANGLES, sample_count = 100)]
fn move_object(bencher: Bencher, triangles: u32) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = write_bumpy_ball(folder.path(), triangles).expect("room for the model");
    let mut scene = model(&path);
    let (assets, _) = load_assets(&scene, Path::new("")).expect("the model can be read");
    let compiled = compile(&scene, &assets).expect("the scene compiles");
    bencher.bench_local(|| {
        scene.objects[0].position.x += 0.01;
        compiled.recompile(&scene, &assets).expect("the scene compiles")
    });
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn first_picture(bencher: Bencher, triangles: u32) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = write_bumpy_ball(folder.path(), triangles).expect("room for the model");
    let scene = model(&path);
    let (assets, _) = load_assets(&scene, Path::new("")).expect("the model can be read");
    let ready = Ready::new(&scene, &assets);
    bencher.bench_local(|| ready.render(2));
}
