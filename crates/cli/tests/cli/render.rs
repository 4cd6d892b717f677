//! `vitrine render`.

use crate::support::{Folder, SCENE, contains};

#[test]
fn without_a_name_the_picture_stands_beside_the_scene() {
    let folder = Folder::new();
    folder.write("scenes/ball.vitrine.toml", SCENE);
    let outcome = folder.run_well(&["render", "scenes/ball.vitrine.toml"]);
    assert_eq!(folder.picture("scenes/ball.png").size, [40, 30]);
    assert!(outcome.out.starts_with("scenes/ball.png: 40 × 30 pixels in "), "{}", outcome.out);
    assert_eq!(outcome.err, "", "no bar where there is no terminal");
}

#[test]
fn the_extension_says_the_format() {
    let folder = Folder::with_scene();
    for (name, start) in [
        ("a.png", &b"\x89PNG"[..]),
        ("a.jpg", &[0xff, 0xd8, 0xff]),
        ("a.JPEG", &[0xff, 0xd8, 0xff]),
        ("a.exr", &[0x76, 0x2f, 0x31, 0x01]),
        ("a.hdr", b"#?RADIANCE"),
    ] {
        folder.run_well(&["render", "scene.vitrine.toml", "-o", name]);
        assert!(folder.read(name).starts_with(start), "{name}");
    }
}

#[test]
fn bits_and_quality() {
    let folder = Folder::with_scene();
    let render = |more: &[&str]| folder.run_well(&[&["render", "scene.vitrine.toml"], more].concat());
    render(&["-o", "16.png", "--bits", "16"]);
    // The header's byte for the depth: after the signature, the chunk's head, width and height.
    assert_eq!(folder.read("16.png")[24], 16);
    render(&["-o", "8.png", "--bits", "8"]);
    assert_eq!(folder.read("8.png")[24], 8);
    render(&["-o", "poor.jpg", "--quality", "5"]);
    render(&["-o", "fine.jpg", "--quality", "100"]);
    assert!(folder.read("poor.jpg").len() < folder.read("fine.jpg").len());
}

/// C16. The scene has a model beside the ball, so that boxes, triangles and balls are traced.
#[test]
fn c16_the_same_bytes_without_vector_instructions() {
    let folder = Folder::with_scene();
    folder.run_well(&["templates", "benchmark", "-o", "benchmark.vitrine.toml"]);
    for scene in ["scene", "benchmark"] {
        let (file, ending) = (format!("{scene}.vitrine.toml"), ["-fast.png", "-portable.png"]);
        let [fast, portable] = ending.map(|ending| format!("{scene}{ending}"));
        let render = |name: &str, more: &[&str]| {
            let all = ["render", &file, "-o", name, "--size", "100x70", "--samples", "2"];
            folder.run_well(&[&all, more].concat());
        };
        render(&fast, &[]);
        render(&portable, &["--portable"]);
        assert!(folder.read(&fast) == folder.read(&portable), "{scene}");
    }
}

/// C16.
#[test]
fn c16_the_same_bytes_on_any_number_of_threads() {
    let folder = Folder::with_scene();
    for threads in ["1", "2", "3", "8"] {
        let name = format!("{threads}.png");
        folder.run_well(&[
            "render",
            "scene.vitrine.toml",
            "-o",
            &name,
            "--size",
            "100x70",
            "--samples",
            "3",
            "--threads",
            threads,
        ]);
        assert_eq!(folder.read(&name), folder.read("1.png"), "{threads} threads");
    }
}

#[test]
fn the_file_says_how_it_was_made() {
    let folder = Folder::with_scene();
    let outcome =
        folder.run_well(&["render", "scene.vitrine.toml", "--json", "--seed", "77", "--samples", "2"]);
    let hash = outcome.events()[0]["scene_hash"].as_str().expect("the start names the scene").to_owned();
    let bytes = folder.read("scene.png");
    let version = format!("Vitrine {}", vitrine::VERSION);
    for word in
        [&version, "vitrine:scene-hash", &hash, "vitrine:seed", "77", "vitrine:samples", "vitrine:renderer"]
    {
        assert!(contains(&bytes, word), "no {word}");
    }
    assert!(!contains(&bytes, "vitrine:complete"));
    let other =
        folder.run_well(&["render", "scene.vitrine.toml", "--json", "--set", "object.ball.radius=0.5"]);
    assert_ne!(other.events()[0]["scene_hash"], hash.as_str());
}

#[test]
fn lines_for_programs() {
    let folder = Folder::with_scene();
    let outcome = folder.run_well(&[
        "render",
        "scene.vitrine.toml",
        "-o",
        "a.png",
        "--json",
        "--samples",
        "4",
        "--threads",
        "2",
        "--region",
        "10,5,20,15",
    ]);
    let events = outcome.events();
    let (first, last) = (&events[0], &events[events.len() - 1]);
    assert_eq!((first["event"].as_str(), first["width"].as_u64()), (Some("start"), Some(40)));
    assert_eq!(first["region"], serde_json::json!([10, 5, 20, 15]));
    assert_eq!((last["event"].as_str(), last["complete"].as_bool()), (Some("done"), Some(true)));
    assert_eq!((last["width"].as_u64(), last["height"].as_u64()), (Some(20), Some(15)));
    assert_eq!((last["samples"].as_u64(), last["threads"].as_u64()), (Some(20 * 15 * 4), Some(2)));
    assert_eq!(last["output"].as_str(), Some("a.png"));
    assert!(last["rays"].as_u64() > last["samples"].as_u64(), "shadow rays count too: {last}");
    for seconds in ["render_seconds", "cpu_seconds"] {
        assert!(last[seconds].as_f64().is_some_and(|s| s >= 0.0), "{seconds}: {last}");
    }
    for event in &events[1..events.len() - 1] {
        assert_eq!(event["event"], "progress", "{event}");
    }
}

#[test]
fn a_failure_is_a_line_for_programs_too() {
    let folder = Folder::new();
    folder.write("bad.vitrine.toml", "format = 1\n[camera]\npostion = [0, 0, 0]\n");
    let outcome = folder.run(&["render", "bad.vitrine.toml", "--json"]);
    outcome.fails(3, &["postion"]);
    let events = outcome.events();
    assert_eq!((events.len(), events[0]["event"].as_str()), (1, Some("error")));
    assert_eq!(events[0]["exit_code"], 3);
    let finding = &events[0]["findings"][0];
    assert_eq!((finding["line"].as_u64(), finding["column"].as_u64()), (Some(3), Some(1)));
}

#[test]
fn a_value_set_is_a_value_in_the_file() {
    let folder = Folder::with_scene();
    folder.write("clear.vitrine.toml", SCENE.replace("transparency = 0.8", "transparency = 0.25"));
    folder.run_well(&["render", "clear.vitrine.toml"]);
    let set = "object.ball.material.transparency=0.25";
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "set.png", "--set", set]);
    folder.run_well(&["render", "scene.vitrine.toml"]);
    assert!(folder.picture("set.png") == folder.picture("clear.png"));
    assert!(folder.picture("set.png") != folder.picture("scene.png"));
}

#[test]
fn flags_stand_for_settings() {
    let folder = Folder::with_scene();
    let picture = |name: &str, flags: &[&str]| {
        folder.run_well(&[&["render", "scene.vitrine.toml", "-o", name], flags].concat());
        folder.picture(name)
    };
    let plain = picture("plain.png", &[]);
    let cast = picture("cast.png", &["--renderer", "cast"]);
    assert!(cast != plain && cast == picture("cast2.png", &["--set", "settings.renderer=cast"]));
    let flat = picture("flat.png", &["--depth", "0"]);
    assert!(flat != plain && flat == picture("flat2.png", &["--set", "settings.depth=0"]));
    assert!(picture("seed.png", &["--seed", "5"]) != plain, "other points of the lamp");
    assert_eq!(picture("size.png", &["--size", "17x9"]).size, [17, 9]);
}

#[test]
fn a_region_is_that_part_of_the_picture() {
    let folder = Folder::with_scene();
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "all.png"]);
    folder.run_well(&["render", "scene.vitrine.toml", "-o", "part.png", "--region", "7,3,20,11"]);
    let (all, part) = (folder.picture("all.png"), folder.picture("part.png"));
    assert_eq!(part.size, [20, 11]);
    for y in 0..11 {
        for x in 0..20 {
            assert_eq!(part.texel(x, y), all.texel(x + 7, y + 3), "({x}, {y})");
        }
    }
}

#[test]
fn quiet_is_quiet() {
    let folder = Folder::new();
    folder.write("dark.vitrine.toml", "format = 1\n[settings]\nsize = [8, 8]\n");
    let outcome = folder.run_well(&["render", "dark.vitrine.toml", "--quiet"]);
    assert_eq!((outcome.out.as_str(), outcome.err.as_str()), ("", ""));
}

#[test]
fn noise_and_time_end_a_picture() {
    let folder = Folder::with_scene();
    let render = |flags: &[&str]| {
        let all = ["render", "scene.vitrine.toml", "--samples", "65536", "--json"];
        folder.run_well(&[&all, flags].concat()).events().pop().expect("there is an end")
    };
    let clean = render(&["--noise", "0.05", "--set", "settings.shadow_points=1"]);
    assert_eq!((clean["ended"].as_str(), clean["complete"].as_bool()), (Some("noise"), Some(true)));
    assert!(clean["noise"].as_f64().is_some_and(|n| n <= 0.05), "{clean}");
    assert!(clean["samples"].as_u64() < Some(40 * 30 * 65_536));
    assert_eq!(clean["bad_samples"].as_u64(), Some(0));
    assert!(contains(&folder.read("scene.png"), "vitrine:samples-done"));
    assert_eq!(render(&["--time", "0.1"])["ended"].as_str(), Some("time"));
    let said = folder.run_well(&["render", "scene.vitrine.toml", "--samples", "65536", "--time", "0.1"]);
    assert!(said.out.contains("its time was over after"), "{}", said.out);
    assert_eq!(folder.names(), ["scene.png", "scene.vitrine.toml"], "nothing else is left");
}

#[test]
fn the_display_is_that_of_the_settings_or_flags() {
    let folder = Folder::with_scene();
    let picture = |name: &str, flags: &[&str]| {
        folder.run_well(&[&["render", "scene.vitrine.toml", "-o", name], flags].concat());
        folder.picture(name)
    };
    let plain = picture("plain.png", &[]);
    assert!(plain == picture("srgb.png", &["--view", "srgb", "--exposure", "0", "--white-balance", "6500"]));
    let [neutral, agx] = ["neutral", "agx"].map(|view| picture("view.png", &["--view", view]));
    assert!(plain != neutral && plain != agx && neutral != agx);
    let bright = picture("bright.png", &["--exposure", "1"]);
    let sum =
        |p: &vitrine::scene::Picture| p.texels.as_flattened().iter().map(|v| u64::from(*v)).sum::<u64>();
    assert!(sum(&bright) > sum(&plain) && sum(&picture("dark.png", &["--exposure=-1"])) < sum(&plain));
    let warm = picture("warm.png", &["--white-balance", "3000"]);
    let blue = |p: &vitrine::scene::Picture| p.texels.iter().map(|t| u64::from(t[2])).sum::<u64>();
    assert!(blue(&warm) > blue(&plain), "under a bulb's white all looks bluer");
    // Linear light has no display.
    let linear = |name: &str, flags: &[&str]| {
        folder.run_well(&[&["render", "scene.vitrine.toml", "-o", name], flags].concat());
        folder.read(name)
    };
    assert!(linear("a.hdr", &[]).len() == linear("b.hdr", &["--exposure", "2"]).len());
}

#[test]
fn layers_are_for_openexr_and_the_same_bytes_every_time() {
    let folder = Folder::with_scene();
    let layered = |name: &str, flags: &[&str]| {
        folder.run_well(&[&["render", "scene.vitrine.toml", "--layers", "-o", name], flags].concat());
        folder.read(name)
    };
    let classic = layered("a.exr", &[]);
    assert!(classic == layered("b.exr", &["--threads", "3"]));
    for word in ["object.id", "samples", "vitrine:objects", r#"["ground","ball"]"#] {
        assert!(contains(&classic, word), "{word}");
    }
    assert!(!contains(&classic, "albedo.R"), "the classic renderer makes none");
    let photoreal = layered("c.exr", &["--renderer", "photoreal", "--region", "7,3,20,11"]);
    for word in ["albedo.R", "normal.X", "depth.Z", "object.id"] {
        assert!(contains(&photoreal, word), "{word}");
    }
    let refused = folder.run(&["render", "scene.vitrine.toml", "--layers"]);
    refused.fails(2, &["--layers is for OpenEXR", ".exr"]);
}
