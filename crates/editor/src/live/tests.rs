//! The worker without a window: order, stopping and going on, faults. Never times.

use super::*;
use std::sync::{Condvar, Mutex};
use std::time::Instant;
use vitrine::film::{Display, Film};
use vitrine::math::{Rgb, Vec3};
use vitrine::scene::lights::{Disc, LightSource};
use vitrine::scene::shapes::{Plane, Sphere};
use vitrine::scene::{Light, Material, Object, Renderer, Settings, Shape, View};
use vitrine::{Cancel, RenderJob, RenderOptions, display_of};

/// No test waits longer than that; none comes near it.
const LIMIT: Duration = Duration::from_secs(60);

/// Waits until something has become true, woken by the worker.
#[derive(Clone, Default)]
struct Bell(Arc<(Mutex<u64>, Condvar)>);

impl Bell {
    fn wake(&self) -> Wake {
        let bell = self.clone();
        Arc::new(move || {
            *bell.0.0.lock().unwrap() += 1;
            bell.0.1.notify_all();
        })
    }

    #[track_caller]
    fn wait<T>(&self, mut found: impl FnMut() -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(found) = found() {
                return found;
            }
            assert!(start.elapsed() < LIMIT, "it never came");
            let rung = self.0.0.lock().unwrap();
            drop(self.0.1.wait_timeout(rung, Duration::from_millis(20)).unwrap());
        }
    }
}

fn scene(size: [u32; 2], samples: u32) -> Scene {
    let disc = LightSource::Disc(Disc { position: Vec3::new(2.0, 5.0, 3.0), radius: 1.0 });
    let ball = Object {
        name: "ball".into(),
        shape: Shape::Sphere(Sphere { radius: 1.0 }),
        position: Vec3::Y,
        ..Object::default()
    };
    let floor = Object { name: "floor".into(), shape: Shape::Plane(Plane {}), ..Object::default() };
    let settings = Settings { size, samples, ..Settings::default() };
    Scene {
        settings,
        lights: vec![Light { source: disc, ..Light::default() }],
        objects: vec![ball, floor],
        ..Scene::default()
    }
}

fn request(scene: &Scene, generation: u64) -> Request {
    Request {
        scene: Arc::new(scene.clone()),
        assets: Arc::default(),
        size: [160, 120],
        threads: 2,
        is_dragging: false,
        generation,
    }
}

fn coloured(color: Rgb) -> Scene {
    let mut scene = Scene::default();
    scene.settings.background = color;
    scene
}

#[test]
fn the_picture_refines_and_ends() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let mut scene = scene([160, 120], 1);
    scene.settings.shadow_points = 32;
    live.show(request(&scene, 7));
    let mut pictures: Vec<Arc<Picture>> = Vec::new();
    bell.wait(|| {
        let picture = live.picture()?;
        if pictures.last().is_none_or(|last| !Arc::ptr_eq(last, &picture)) {
            pictures.push(picture.clone());
        }
        picture.is_final.then_some(())
    });
    assert!(pictures.windows(2).all(|w| w[0].pass <= w[1].pass && w[0].size <= w[1].size));
    assert!(
        pictures.iter().all(|p| p.generation == 7 && p.rgba.len() == (p.size[0] * p.size[1] * 4) as usize)
    );
    let last = pictures.last().unwrap();
    assert_eq!((last.samples, last.pass, last.size), (64, last.passes, [160, 120]));
    // The end is what the renderer makes of 64 samples.
    assert!(last.rgba == picture::shown(&whole(&scene, 64), &Display::default(), None));
    bell.wait(|| (!live.status().is_busy).then_some(()));
}

#[test]
fn a_photoreal_picture_refines_past_what_ends_a_finished_one_and_is_shown_as_the_settings_say() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let mut scene = scene([40, 30], 3);
    let settings = &mut scene.settings;
    settings.renderer = Renderer::Photoreal;
    (settings.noise, settings.time_limit) = (0.9, 0.001);
    (settings.exposure, settings.white_balance) = (1.0, 4000.0);
    live.show(Request { size: [40, 30], ..request(&scene, 1) });
    let mut told = Vec::new();
    let last = bell.wait(|| {
        told.extend(live.status().samples);
        live.picture().filter(|p| p.is_final)
    });
    assert_eq!((last.samples, last.size), (256, [40, 30]));
    assert!(told.is_sorted() && told.iter().all(|[done, all]| done <= all && *all == 256), "{told:?}");
    bell.wait(|| (!live.status().is_busy).then_some(()));
    assert_eq!(live.status().samples, Some([256, 256]));
    let film = whole(&scene, 256);
    assert!(last.rgba == picture::shown(&film, &display_of(&scene.settings), None));
    assert!(last.rgba != picture::shown(&film, &Display::default(), None));
}

/// All samples of a scene at its own size, whatever else would end it.
fn whole(scene: &Scene, samples: u32) -> Film {
    let compiled = compile(scene, &Assets::default()).unwrap();
    let settings = Settings { samples, noise: 0.0, time_limit: 0.0, ..scene.settings.clone() };
    let job = RenderJob::new(&compiled, RenderOptions { settings, region: None }).unwrap();
    job.run(1, &Cancel::default(), &mut |_| {}).film
}

#[test]
fn an_edit_makes_a_photoreal_picture_begin_again() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let mut scene = scene([40, 30], 60_000);
    scene.settings.renderer = Renderer::Photoreal;
    let wish = |scene: &Scene, generation| Request { size: [40, 30], ..request(scene, generation) };
    live.show(wish(&scene, 1));
    let before = bell.wait(|| live.picture().filter(|p| p.samples >= 4));
    assert!(!before.is_final);
    scene.objects[0].position = Vec3::new(0.5, 1.0, 0.0);
    scene.settings.samples = 1;
    live.show(wish(&scene, 2));
    let last = bell.wait(|| live.picture().filter(|p| p.is_final));
    assert_eq!((last.generation, last.samples), (2, 256));
    // No light of the scene before is in it.
    assert!(last.rgba == picture::shown(&whole(&scene, 256), &display_of(&scene.settings), None));
}

#[test]
fn showing_a_photoreal_picture_otherwise_loses_none_of_its_samples() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let mut scene = scene([40, 30], 600);
    scene.settings.renderer = Renderer::Photoreal;
    let assets: Arc<Assets> = Arc::default();
    let wish = |scene: &Scene, generation| Request {
        size: [40, 30],
        assets: assets.clone(),
        ..request(scene, generation)
    };
    live.show(wish(&scene, 1));
    let mut least = bell.wait(|| live.picture().filter(|p| p.samples >= 8)).samples;
    for (generation, exposure) in (2..8).zip([1.0, -2.0, 0.5, 0.0, 3.0, 0.25]) {
        scene.settings.exposure = exposure;
        scene.settings.white_balance = 4000.0 + 100.0 * exposure;
        // As a slider does: dragged, then let go.
        live.show(Request { is_dragging: generation % 3 > 0, ..wish(&scene, generation) });
        let next = bell.wait(|| live.picture().filter(|p| p.generation == generation));
        assert!(next.samples >= least && next.size == [40, 30], "{} after {least}", next.samples);
        least = next.samples;
        bell.wait(|| live.objects().filter(|map| map.generation == generation));
    }
    // And the light is the same to the bit as if nobody had touched anything.
    (scene.settings.exposure, scene.settings.view) = (1.5, Some(View::Agx));
    live.show(wish(&scene, 8));
    let last = bell.wait(|| live.picture().filter(|p| p.generation == 8 && p.is_final));
    assert!(last.rgba == picture::shown(&whole(&scene, 600), &display_of(&scene.settings), None));
    scene.settings.exposure = -1.0;
    live.show(wish(&scene, 9));
    let again = bell.wait(|| live.picture().filter(|p| p.generation == 9));
    assert!(again.is_final && again.samples == 600);
}

#[test]
fn only_the_newest_wish_counts_and_an_old_picture_never_follows_a_newer() {
    let bell = Bell::default();
    let seen: Arc<Mutex<Vec<u64>>> = Arc::default();
    let mut live = Live::new(bell.wake());
    let scene = scene([160, 120], 1);
    for generation in 1..=40 {
        live.show(Request { is_dragging: generation % 3 == 0, ..request(&scene, generation) });
        if let Some(picture) = live.picture() {
            seen.lock().unwrap().push(picture.generation);
        }
        if generation % 5 == 0 {
            bell.wait(|| live.picture().filter(|p| p.generation == generation));
        }
    }
    let last = bell.wait(|| live.picture().filter(|p| p.generation == 40 && p.is_final));
    assert_eq!(last.samples, 64);
    assert!(seen.lock().unwrap().is_sorted());
}

#[test]
fn a_long_drag_shows_pictures_on_the_way() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let scene = scene([160, 120], 1);
    let mut generation = 0;
    // Wishes come faster than pictures; still some come.
    let seen = bell.wait(|| {
        generation += 1;
        live.show(Request { is_dragging: true, size: [640, 480], ..request(&scene, generation) });
        live.picture()
    });
    assert!(seen.generation <= generation);
}

#[test]
fn when_a_drag_ends_the_same_scene_refines_to_the_end() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let wish = request(&scene([160, 120], 1), 1);
    live.show(Request { is_dragging: true, ..wish.clone() });
    let dragged = bell.wait(|| live.picture().filter(|p| p.is_final));
    assert_eq!((dragged.samples, dragged.size), (1, [160, 120]));
    live.show(wish);
    let last = bell.wait(|| live.picture().filter(|p| p.samples == 64));
    assert!(last.is_final);
}

#[test]
fn a_wrong_scene_gives_an_error_and_the_next_right_one_takes_it_away() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let mut wrong = scene([160, 120], 1);
    wrong.objects[0].material = Some("nothing".into());
    live.show(request(&wrong, 1));
    let error = bell.wait(|| live.status().error);
    assert!(matches!(error, LiveError::Compile(CompileError::MissingName { .. })), "{error}");
    live.show(request(&scene([160, 120], 1), 2));
    bell.wait(|| live.picture().filter(|p| p.generation == 2));
    assert_eq!(live.status().error, None);
}

#[test]
fn a_panic_of_the_renderer_is_an_error_and_not_the_end() {
    fn panics(
        scene: &Scene,
        assets: &Assets,
        _: Option<&CompiledScene>,
    ) -> Result<CompiledScene, CompileError> {
        assert!(scene.about.is_empty(), "broken on purpose");
        compile(scene, assets)
    }
    let bell = Bell::default();
    let mut live = Live::with_compile(bell.wake(), panics);
    let good = scene([160, 120], 1);
    live.show(request(&Scene { about: "bad".into(), ..good.clone() }, 1));
    let error = bell.wait(|| live.status().error);
    assert_eq!(error, LiveError::Panic { message: "broken on purpose".into() });
    live.show(request(&good, 2));
    bell.wait(|| live.picture().filter(|p| p.generation == 2));
}

#[test]
fn c15_a_final_render_that_was_stopped_and_continued_is_the_same_bytes() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let scene = scene([200, 150], 40);
    let compiled = compile(&scene, &Assets::default()).unwrap();
    let options = RenderOptions { settings: scene.settings.clone(), region: None };
    let whole = RenderJob::new(&compiled, options).unwrap().run(2, &Cancel::default(), &mut |_| {});
    assert_eq!(live.final_state(), FinalState::Idle);
    live.start_final(request(&scene, 1));
    let mut stops = 0;
    while live.final_state() != FinalState::Done {
        std::thread::sleep(Duration::from_millis(7));
        live.stop_final();
        if live.final_state() == FinalState::Stopped {
            stops += 1;
            live.continue_final();
        }
    }
    let image = live.final_image().unwrap();
    assert!(stops > 0 && image.is_complete && image.film == whole.film, "after {stops} stops");
    let shown = live.picture().unwrap();
    assert_eq!((shown.source, shown.size, shown.samples), (Source::Final, [200, 150], 40));
    assert_eq!(live.status().samples_done, 200 * 150 * 40);
}

#[test]
fn c15_stopping_keeps_the_picture_and_an_edit_brings_the_live_one_back() {
    let bell = Bell::default();
    let mut live = Live::new(bell.wake());
    let heavy = scene([400, 300], 5000);
    let wish = request(&heavy, 1);
    live.show(wish.clone());
    bell.wait(|| live.picture());
    live.start_final(wish.clone());
    bell.wait(|| live.final_image().filter(|image| image.film.samples() > 0));
    // Neither another size of the view nor other threads are an edit.
    live.show(Request { size: [320, 240], threads: 1, ..wish.clone() });
    assert_eq!(live.final_state(), FinalState::Running);
    live.stop_final();
    assert_eq!(live.final_state(), FinalState::Stopped);
    bell.wait(|| live.picture().filter(|p| p.source == Source::Final));
    live.show(request(&coloured(Rgb::WHITE), 2));
    bell.wait(|| live.picture().filter(|p| p.source == Source::Live && p.generation == 2));
    let image = live.final_image().unwrap();
    assert!(!image.is_complete && *image.scene == heavy, "it can still be saved");
    // It goes on with the scene with which it was begun; an edit stops it.
    live.continue_final();
    assert_eq!(live.final_state(), FinalState::Running);
    bell.wait(|| live.picture().filter(|p| p.source == Source::Final));
    live.show(request(&coloured(Rgb::BLACK), 3));
    assert_eq!(live.final_state(), FinalState::Stopped);
    bell.wait(|| live.picture().filter(|p| p.source == Source::Live && p.generation == 3));
}

#[test]
fn picking_gives_names_and_the_map_has_the_same() {
    let mut live = Live::synchronous();
    let mut scene = scene([160, 120], 1);
    scene.materials.push(Material { name: "grey".into(), ..Material::default() });
    live.show(request(&scene, 3));
    let picture = live.picture().unwrap();
    assert_eq!((picture.size, picture.samples, picture.is_final), ([160, 120], 1, true));
    let map = live.objects().unwrap();
    assert_eq!((map.generation, map.size), (3, [160, 120]));
    for (x, y) in [(80, 62), (10, 110), (3, 3)] {
        let picked = live.pick((x as f32 + 0.5) / 160.0, (y as f32 + 0.5) / 120.0);
        assert_eq!(picked.as_ref().map(|p| p.name.as_str()), map.name(x, y), "{x} {y}");
    }
    assert_eq!(map.name(80, 62), Some("ball"));
    assert_eq!(map.name(10, 110), Some("floor"));
    assert_eq!(map.name(3, 3), None);
    assert_eq!(map.name(160, 0), None, "outside");
}

#[test]
fn without_a_thread_everything_is_there_when_the_call_comes_back() {
    let mut live = Live::synchronous();
    let scene = scene([64, 48], 3);
    live.start_final(request(&scene, 1));
    assert_eq!(live.final_state(), FinalState::Done);
    assert!(live.final_image().unwrap().is_complete);
    assert!(!live.status().is_busy);
}
