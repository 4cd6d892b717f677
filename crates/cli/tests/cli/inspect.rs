//! `vitrine check`, `vitrine info`, `vitrine schema`.

use crate::support::{Folder, SCENE};

#[test]
fn check_shows_everything_of_all_files() {
    let folder = Folder::with_scene();
    folder.write(
        "bad.vitrine.toml",
        SCENE.replace("radius = 0.5", "radius = -1").replace("[camera]", "[camra]"),
    );
    folder.write("dark.vitrine.toml", "format = 1\n");
    folder.write(
        "model.vitrine.toml",
        "format = 1\n[[object]]\nname = \"m\"\nshape = \"mesh\"\nfile = \"m.obj\"\n",
    );
    let all = ["check", "scene.vitrine.toml", "bad.vitrine.toml", "dark.vitrine.toml", "model.vitrine.toml"];
    let outcome = folder.run(&all);
    outcome.fails(3, &["radius = -1", "did you mean", "no light", "object `m`"]);
    let verdicts: Vec<_> = outcome.out.lines().collect();
    assert_eq!(verdicts[0], "scene.vitrine.toml: fine");
    assert_eq!(verdicts[1], "bad.vitrine.toml: 2 errors");
    assert!(verdicts[2].ends_with("warnings"), "{verdicts:?}");
    assert_eq!(verdicts[3], "model.vitrine.toml: 1 error");
    assert!(verdicts[4].starts_with("4 scenes: 3 errors, "), "{verdicts:?}");
}

#[test]
fn warnings_alone_are_no_failure() {
    let folder = Folder::new();
    folder.write("dark.vitrine.toml", "format = 1\n");
    let outcome = folder.run_well(&["check", "dark.vitrine.toml"]);
    assert!(outcome.err.contains("warning:"), "{}", outcome.err);
}

#[test]
fn info_counts_and_says_what_will_be_slow() {
    let folder = Folder::new();
    let mesh = "\n[[object]]\nname = \"cone\"\nshape = \"mesh\"\nfile = \"cone.obj\"\n";
    folder.write("cone.obj", "v 0 0 0\nv 4 0 0\nv 0 3 0\nv 0 0 2\nf 1 2 3\nf 1 2 4\n");
    folder.write("s.vitrine.toml", format!("{SCENE}{mesh}"));
    let outcome =
        folder.run_well(&["info", "s.vitrine.toml", "--samples", "4", "--set", "settings.shadow_points=64"]);
    for words in [
        "a ball for tests",
        "3 (1 sphere, 1 plane, 1 mesh)",
        "2 (1 ambient, 1 disc)",
        "Triangles  2",
        "40 × 30 pixels, 4 samples, depth 3, classic",
        "64 shadow points × 1 disc lamp × 4 samples = up to 256 shadow rays",
        "from [-1.000, 0.000, -1.000] to [4.000, 3.000, 2.000]",
    ] {
        assert!(outcome.out.contains(words), "no `{words}` in {}", outcome.out);
    }
}

#[test]
fn the_schema_is_json_and_knows_the_contract() {
    let outcome = Folder::new().run_well(&["schema"]);
    let schema: serde_json::Value = serde_json::from_str(&outcome.out).unwrap();
    for key in ["format", "settings", "camera", "light", "material", "object"] {
        assert!(schema["properties"][key].is_object(), "{key}");
    }
}
