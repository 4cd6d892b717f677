//! C9 to C17: how the picture is made, the camera, the finished render, the window.

use crate::course_work::{in_english, must_be_seen, newest, value};
use crate::person::Person;
use eframe::egui::{Key, Modifiers};
use std::time::Duration;
use vitrine::math::Vec3;
use vitrine::scene::{Renderer, Value};
use vitrine_editor::action::Action;
use vitrine_editor::document::Thing;
use vitrine_editor::files::Config;
use vitrine_editor::live::FinalState;
use vitrine_editor::text::Language;
use vitrine_editor::{Editor, Pace, WINDOW_SIZE, window_builder};

#[test]
fn c9_the_renderer_is_switched_in_the_line_at_the_bottom() {
    let mut person = in_english();
    person.use_tool("Sphere");
    must_be_seen(&mut person, |person| person.click("Ray casting"));
    assert_eq!(person.scene().settings.renderer, Renderer::Cast);
    must_be_seen(&mut person, |person| person.click("Classic"));
    assert_eq!(person.scene().settings.renderer, Renderer::Classic);
}

#[test]
fn photoreal_is_switched_on_in_both_languages_and_refines_while_one_looks() {
    for (language, word, all) in [
        (Language::English, "Photoreal", ["Classic", "Ray casting", "Photoreal"]),
        (Language::Russian, "Фотореалистичный", ["Классический", "Бросание лучей", "Фотореалистичный"]),
    ] {
        let config = Config { language, ..Config::default() };
        let mut person = Person::at_pace(tempfile::tempdir().unwrap(), &config, Pace::Threads);
        person.ask(Action::NewFrom("empty".into()));
        assert!(all.iter().all(|name| person.sees(name)), "{:?}", person.names());
        person.control(word).click();
        let samples = |e: &Editor| {
            let is_photoreal = e.document().scene().settings.renderer == Renderer::Photoreal;
            let picture = e.live().picture().filter(|p| is_photoreal && p.passes > 5);
            picture.map_or(0, |p| p.samples)
        };
        person.until_seen("the first sample", |e| samples(e) >= 1);
        let first = person.picture();
        person.until_seen("more of them", |e| samples(e) >= 4);
        assert_ne!(person.picture(), first);
        let told = person.window.state().live().status().samples;
        assert!(told.is_some_and(|[done, all]| done >= 4 && all == 256), "{told:?}");
    }
}

#[test]
fn a_photoreal_picture_is_saved_with_the_samples_asked_for() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let mut save = |renderer: &str, samples: &str| {
        let path = person.path(&format!("{renderer} {samples}.png"));
        person.press(Key::P, Modifiers::COMMAND);
        person.pick("Picture", "Render now");
        person.type_into("File", &path.display().to_string());
        person.type_into("Width", "80");
        person.type_into("Quality (samples)", samples);
        person.pick("Renderer", renderer);
        person.click("Render and save");
        person.until("the file", |_| path.is_file());
        person.settle();
        image::open(&path).unwrap().to_rgb8()
    };
    let rough = save("Photoreal", "1");
    assert_eq!(rough.dimensions(), (80, 60));
    let (fine, classic) = (save("Photoreal", "64"), save("Classic", "64"));
    let apart = |a: &image::RgbImage, b: &image::RgbImage| {
        a.iter().zip(b.iter()).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>()
    };
    assert!(apart(&fine, &classic) > 0 && apart(&rough, &fine) > 0);
}

#[test]
fn c10_the_depth_of_reflections_is_set_and_seen() {
    let mut person = Person::at_the_start(Language::English);
    person.click("Two mirror spheres");
    must_be_seen(&mut person, |person| {
        let depth = format!("Depth: {}", person.scene().settings.depth);
        person.click(&depth);
        person.type_into("Reflection depth", "0");
        person.click("OK");
    });
    assert_eq!(person.scene().settings.depth, 0);
    assert!(person.sees("Depth: 0"));
    person.press(Key::Z, Modifiers::COMMAND);
    assert_ne!(person.scene().settings.depth, 0, "it is a step that can be undone");
}

#[test]
fn c11_transparency_is_set_by_its_scale_and_seen() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let material = newest(&person).material.unwrap();
    must_be_seen(&mut person, |person| person.type_into("Transparency", "0.6"));
    assert_eq!(person.scene().material(&material).unwrap().transparency, Some(0.6));
    must_be_seen(&mut person, |person| person.type_into("Light bending (index)", "1.5"));
    assert_eq!(person.scene().material(&material).unwrap().refraction, Some(1.5));
}

#[test]
fn c12_soft_shadows_have_their_quality_and_their_lamp_its_radius() {
    let mut person = in_english();
    person.use_tool("Sphere");
    person.select("lamp");
    must_be_seen(&mut person, |person| person.type_into("Disc radius", "1.5"));
    assert_eq!(value(&person, &Thing::light("lamp"), "radius"), Value::Number(1.5));
    // The first leaves the field.
    person.press(Key::Escape, Modifiers::NONE);
    person.press(Key::Escape, Modifiers::NONE);
    assert!(person.document().selection().is_empty());
    person.click("More");
    must_be_seen(&mut person, |person| {
        person.type_into("Shadow points", "4");
        person.type_into("Shadow grain", "0");
    });
    let settings = &person.scene().settings;
    assert_eq!((settings.shadow_points, settings.shadow_error), (4, 0.0));
}

#[test]
fn c13_the_camera_goes_to_a_place_and_turns_by_an_angle_about_an_axis() {
    let mut person = in_english();
    person.select("Camera");
    must_be_seen(&mut person, |person| {
        person.type_into("Camera place X", "1.5");
        person.type_into("Camera place Y", "3");
    });
    assert_eq!(person.scene().camera.position, Vec3::new(1.5, 3.0, 6.0));
    let forward = |person: &Person| person.scene().camera.rotation() * Vec3::NEG_Z;
    let before = forward(&person);
    must_be_seen(&mut person, |person| {
        person.type_into("Angle", "30");
        person.click("Axis Y");
        // The same word stands below the picture.
        let turn = person.all("Turn").into_iter().find(|n| n.rect().left() > 1020.0).expect("the button");
        turn.click();
        person.wait();
    });
    let angle = |v: Vec3| v.x.atan2(v.z).to_degrees();
    let turned = (angle(forward(&person)) - angle(before)).rem_euclid(360.0);
    assert!((turned - 30.0).abs() < 0.01, "{turned}");
    assert_eq!(person.scene().camera.position, Vec3::new(1.5, 3.0, 6.0));
}

/// A scene whose render takes long, in a window with threads.
fn with_long_render() -> Person {
    let home = tempfile::tempdir().unwrap();
    let mut person = Person::at_pace(home, &Config::default(), Pace::Threads);
    person.ask(Action::NewFrom("empty".into()));
    person.type_into("Picture size Width", "1500");
    person.type_into("Picture size Height", "1000");
    person.type_into("Quality (rays per pixel)", "4000");
    assert_eq!(person.scene().settings.size, [1500, 1000]);
    person
}

#[test]
fn c15_a_render_is_started_stopped_continued_and_saved_as_it_is() {
    let mut person = with_long_render();
    person.use_tool("Start");
    let has_samples = |e: &Editor| e.live().final_image().is_some_and(|image| image.film.samples() > 0);
    person.until("some of the picture", has_samples);
    assert_eq!(person.window.state().live().final_state(), FinalState::Running);
    person.use_tool("Stop");
    person.until("the stop", |e| e.live().final_state() == FinalState::Stopped);
    let stopped = person.window.state().live().final_image().expect("the picture stays");
    person.use_tool("Continue");
    person.until("more of it", |e| e.live().final_state() == FinalState::Running);
    person.use_tool("Stop");
    person.until("the stop", |e| e.live().final_state() == FinalState::Stopped);
    let image = person.window.state().live().final_image().unwrap();
    assert!(image.film.samples() >= stopped.film.samples());
    let path = person.path("as it is.png");
    person.use_tool("Picture");
    person.type_into("File", &path.display().to_string());
    person.click("Save");
    person.until("the file", |_| path.is_file());
    let size = image::open(&path).unwrap();
    assert_eq!((size.width(), size.height()), (1500, 1000));
}

#[test]
fn c15_a_picture_of_another_size_is_rendered_and_saved() {
    let mut person = in_english();
    person.use_tool("Sphere");
    let path = person.path("small.png");
    person.press(Key::P, Modifiers::COMMAND);
    person.type_into("File", &path.display().to_string());
    person.click("Keep the ratio of width and height");
    person.type_into("Width", "90");
    person.type_into("Height", "70");
    person.type_into("Quality (samples)", "1");
    person.click("Render and save");
    person.until("the file", |_| path.is_file());
    person.settle();
    let picture = image::open(&path).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (90, 70));
    assert!(picture.pixels().any(|p| p != picture.get_pixel(0, 0)));
}

#[test]
fn c16_the_number_of_threads_is_set_and_kept() {
    let mut person = in_english();
    person.choose(&["Edit", "Settings…"]);
    person.pick("Threads", "1");
    person.click("OK");
    assert!(person.sees("Threads: 1"), "{:?}", person.names());
    let Person { window, home } = person;
    drop(window);
    let (config, warning) = Config::load(&vitrine_editor::files::Places::inside(home.path()));
    assert_eq!((config.threads, warning.is_none()), (1, true));
}

#[test]
fn c17_the_window_has_one_size() {
    let builder = window_builder();
    let size = Some(WINDOW_SIZE.into());
    assert_eq!([builder.inner_size, builder.min_inner_size, builder.max_inner_size], [size; 3]);
    assert_eq!((builder.resizable, builder.maximize_button), (Some(false), Some(false)));
}

#[test]
fn the_time_of_a_render_is_told_before_it_is_saved() {
    let mut person = in_english();
    person.use_tool("Start");
    person.until("the render", |e| e.live().final_state() == FinalState::Done);
    std::thread::sleep(Duration::from_millis(2));
    person.window.step();
    person.use_tool("Picture");
    person.pick("Picture", "Render now");
    assert!(person.reads("about "), "{:?}", person.names());
}
