//! What a person waits for in the window: from an edit to the first picture of it, and to the first at full size (640 × 480, 2
//! threads, the course work's scenes, without the window); and the interface's own work for a frame, without drawing triangles.
//!
//! `cargo bench --bench editor`. Each edit moves an object while the picture of the one before still refines, as in the window.

use divan::Bencher;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use vitrine_editor::egui::{Context, Pos2, RawInput, Rect};
use vitrine_editor::files::Places;
use vitrine_editor::live::{Live, Picture, Request};
use vitrine_editor::{Editor, Pace, WINDOW_SIZE};
use vitrine_formats::{SceneFile, load_assets};
use vitrine_scene::{Assets, Scene};

const SCENES: [&str; 6] = [
    "benchmark",
    "soft-shadows",
    "textured-sphere",
    "textured-triangle",
    "transparent-sphere",
    "two-mirror-spheres",
];
const SIZE: [u32; 2] = [640, 480];
/// No picture takes longer.
const LIMIT: Duration = Duration::from_secs(60);

fn main() {
    divan::main();
}

#[divan::bench(args = SCENES, sample_count = 30, sample_size = 1)]
fn edit_to_first_picture(bencher: Bencher, scene: &str) {
    let mut editing = Editing::of(scene);
    bencher.bench_local(|| editing.edit_until(|_| true));
}

#[divan::bench(args = SCENES, sample_count = 30, sample_size = 1)]
fn edit_to_full_size(bencher: Bencher, scene: &str) {
    let mut editing = Editing::of(scene);
    bencher.bench_local(|| editing.edit_until(|picture| picture.size == SIZE && picture.samples > 0));
}

/// A frame of the whole window with the benchmark scene, while nothing is rendered: layout, panels and triangles ready to be drawn.
#[divan::bench(sample_count = 50, sample_size = 1)]
fn interface_frame(bencher: Bencher) {
    let home = tempfile::tempdir().expect("a folder can be made");
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/coursework/benchmark.vitrine.toml");
    let ctx = Context::default();
    let mut editor = Editor::new(&ctx, Places::inside(home.path()), Some(scene), Pace::Immediate);
    let mut frame = || {
        let size = Rect::from_min_size(Pos2::ZERO, WINDOW_SIZE.into());
        let input = RawInput { screen_rect: Some(size), ..RawInput::default() };
        let output = ctx.run_ui(input, |ui| editor.frame(ui));
        ctx.tessellate(output.shapes, output.pixels_per_point)
    };
    // The scene is read on another thread.
    for _ in 0..50 {
        frame();
        std::thread::sleep(Duration::from_millis(10));
    }
    bencher.bench_local(frame);
}

/// A scene that is being edited and watched.
struct Editing {
    scene: Scene,
    assets: Arc<Assets>,
    live: Live,
    woken: Receiver<()>,
    generation: u64,
}

impl Editing {
    /// Opens a scene and waits until its picture is complete once, so that the live picture knows how fast it is.
    fn of(name: &str) -> Self {
        let file = format!("../scenes/coursework/{name}.vitrine.toml");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let scene = SceneFile::read(&path).expect("an example can be read").into_scene();
        let (assets, _) =
            load_assets(&scene, path.parent().unwrap_or(Path::new("."))).expect("it has its assets");
        let (wake, woken) = channel();
        // When the bench is over nobody listens any more.
        let live = Live::new(Arc::new(move || wake.send(()).unwrap_or_default()));
        let mut editing = Self { scene, assets: Arc::new(assets), live, woken, generation: 0 };
        editing.edit_until(|picture| picture.size == SIZE && picture.samples > 0);
        editing
    }

    /// Moves an object and waits for a picture of that.
    fn edit_until(&mut self, is_enough: impl Fn(&Picture) -> bool) {
        self.generation += 1;
        self.scene.objects[0].position.x += 0.001;
        self.live.show(Request {
            scene: Arc::new(self.scene.clone()),
            assets: self.assets.clone(),
            size: SIZE,
            threads: 2,
            is_dragging: false,
            generation: self.generation,
        });
        loop {
            let picture = self.live.picture();
            if picture.is_some_and(|p| p.generation == self.generation && is_enough(&p)) {
                return;
            }
            self.woken.recv_timeout(LIMIT).expect("a picture comes in time");
        }
    }
}
