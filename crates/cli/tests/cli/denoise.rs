//! `vitrine denoise` and `vitrine render --denoise`: without the library everywhere, with it where VITRINE_OIDN names one.

use crate::support::{Folder, contains, outcome};
use std::io::{self, Write};
use vitrine::denoise::VARIABLE;
use vitrine::formats::read_exr_features;

/// Whether the variable names the library; a word about it where it does not.
fn has_library() -> bool {
    let has = std::env::var_os(VARIABLE).is_some_and(|v| !v.is_empty());
    if !has {
        // Past the test harness, which would keep it to itself.
        let _ =
            writeln!(io::stderr(), "NOT RUN: {VARIABLE} does not name the folder of Open Image Denoise 2");
    }
    has
}

#[test]
fn without_the_library_the_picture_is_saved_with_its_noise_and_it_is_said_why() {
    let folder = Folder::with_scene();
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "plain.png"]);
    let render = ["render", "scene.vitrine.toml", "--denoise", "-o", "kept.png"];
    let outcome = outcome(folder.command().args(render).env(VARIABLE, folder.path("nowhere")));
    outcome
        .fails(1, &["warning", "will keep its noise", "saved with its noise", "nowhere", "pyoidn", VARIABLE]);
    assert!(outcome.out.starts_with("kept.png: ") && !outcome.out.contains("denoised"), "{}", outcome.out);
    assert!(folder.read("kept.png") == folder.read("plain.png"));
}

#[test]
fn programs_are_told_that_the_picture_is_saved_and_then_what_failed() {
    let folder = Folder::with_scene();
    folder.write("oidn.so", "no library");
    let outcome = folder.run(&["render", "scene.vitrine.toml", "--denoise", "--oidn", "oidn.so", "--json"]);
    assert_eq!(outcome.code, Some(1), "{outcome:#?}");
    let events = outcome.events();
    let [.., done, error] = &events[..] else { panic!("{events:?}") };
    assert_eq!((&done["event"], &done["output"]), (&"done".into(), &"scene.png".into()));
    assert!(done["denoised"].is_null(), "{done}");
    assert_eq!((&error["event"], &error["exit_code"]), (&"error".into(), &1.into()));
    assert!(error["message"].as_str().unwrap().contains("oidn.so"), "{error}");
    assert!(events.iter().any(|e| e["event"] == "warning"), "{events:?}");
    assert!(folder.names().contains(&"scene.png".into()));
}

#[test]
fn a_library_that_is_none_leaves_nothing_behind() {
    let folder = Folder::with_scene();
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "a.exr"]);
    folder.write("oidn.so", "no library");
    let before = folder.names();
    folder.run(&["denoise", "a.exr", "-o", "b.png", "--oidn", "oidn.so"]).fails(1, &["not found", "oidn.so"]);
    folder.run(&["denoise", "a.exr", "-o", "b.png", "--oidn", "none"]).fails(1, &["there is no such file"]);
    assert_eq!(folder.names(), before);
}

#[test]
fn what_is_no_exr_picture_is_refused_first() {
    let folder = Folder::with_scene();
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "a.png"]);
    folder.run(&["denoise", "a.png"]).fails(3, &["not an OpenEXR picture", "a.png"]);
    folder.run(&["denoise", "none.exr"]).fails(3, &["no such file", "none.exr"]);
    folder.run(&["denoise", "a.exr", "-o", "b.txt"]).fails(2, &["b.txt", ".png"]);
    folder.run(&["denoise", "a.exr", "--denoise-quality", "hig"]).fails(2, &["high"]);
    folder.run(&["denoise", "a.exr", "--exposure", "99"]).fails(2, &["exposure", "20"]);
}

#[test]
fn a_render_is_denoised_as_its_file_would_be() {
    if !has_library() {
        return;
    }
    let folder = Folder::with_scene();
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "noise.exr"]);
    let render = ["render", "scene.vitrine.toml", "--denoise", "-o", "once.exr", "--threads", "2"];
    let outcome = folder.run_well(&render);
    assert!(outcome.out.trim_end().ends_with(", denoised"), "{}", outcome.out);
    let outcome = folder.run_well(&["denoise", "noise.exr", "-o", "later.exr", "--threads", "2"]);
    assert!(outcome.out.starts_with("later.exr: denoised in "), "{}", outcome.out);
    let read = |name: &str| read_exr_features(&folder.path(name)).unwrap();
    let (noise, once, later) = (read("noise.exr"), read("once.exr"), read("later.exr"));
    assert_eq!(once, later, "the picture and the texts of its file");
    assert_ne!(once.light, noise.light);
    assert!(contains(&folder.read("once.exr"), "Open Image Denoise 2."));
    folder.run_well(&["denoise", "noise.exr"]);
    assert_eq!(folder.picture("noise-denoised.png").size, [40, 30]);
    for (name, flags) in [("darker", ["--exposure", "-2"]), ("film", ["--view", "agx"])] {
        let name = format!("{name}.png");
        folder.run_well(&["denoise", "noise.exr", "-o", &name, flags[0], flags[1]]);
        assert_ne!(folder.picture(&name), folder.picture("noise-denoised.png"), "{flags:?}");
    }
}
