//! `vitrine sweep`.

use crate::support::Folder;

const CLEARER: &str = "object.ball.material.transparency=1,0.8,0.6,0.4,0.2,0";

/// C19.
#[test]
fn six_transparencies_on_a_sheet_and_each_by_itself() {
    let folder = Folder::with_scene();
    let outcome = folder.run_well(&[
        "sweep",
        "scene.vitrine.toml",
        "--set",
        CLEARER,
        "-o",
        "sheet.png",
        "--each",
        "pictures/each",
    ]);
    assert_eq!(outcome.out, "sheet.png: 6 pictures\n");
    let sheet = folder.picture("sheet.png");
    assert!(sheet.size[0] > 3 * 40 && sheet.size[1] > 2 * 30, "{:?}", sheet.size);
    assert!(sheet.texels.iter().any(|t| t.iter().all(|c| *c < 60)), "captions are dark");

    for (i, value) in ["1", "0.8", "0.6", "0.4", "0.2", "0"].iter().enumerate() {
        let name = format!("pictures/each/scene-{}-transparency-{value}.png", i + 1);
        let set = format!("object.ball.material.transparency={value}");
        folder.run_well(&["render", "scene.vitrine.toml", "--set", &set, "-o", "one.png"]);
        assert_eq!(folder.read(&name), folder.read("one.png"), "{value}");
    }
}

#[test]
fn large_pictures_become_smaller_and_small_ones_stay() {
    let folder = Folder::with_scene();
    let sweep = |size: &str| {
        folder.run_well(&[
            "sweep",
            "scene.vitrine.toml",
            "--set",
            "settings.depth=0,1,2",
            "--size",
            size,
            "-q",
        ]);
        folder.picture("scene-sweep.png").size
    };
    assert!((1480..=1500).contains(&sweep("900x600")[0]));
    assert!(sweep("20x15")[0] < 400);
}

#[test]
fn other_values_stay_fixed_and_lists_are_one_value() {
    let folder = Folder::with_scene();
    folder.run_well(&[
        "sweep",
        "scene.vitrine.toml",
        "--set",
        "camera.position=[0, 1, 5],[3, 1, 4]",
        "--set",
        "settings.depth=0",
        "--each",
        ".",
    ]);
    folder.run_well(&[
        "render",
        "scene.vitrine.toml",
        "--set",
        "settings.depth=0",
        "--set",
        "camera.position=[3, 1, 4]",
        "-o",
        "one.png",
    ]);
    assert!(folder.picture("scene-2-position-_3__1__4_.png") == folder.picture("one.png"));
}

#[test]
fn wrong_series_are_told_before_rendering() {
    let folder = Folder::with_scene();
    let sweep = |sets: &[&str]| {
        let sets = sets.iter().flat_map(|set| ["--set", set]);
        folder.run(
            &["sweep", "scene.vitrine.toml", "--each", "each"].into_iter().chain(sets).collect::<Vec<_>>(),
        )
    };
    sweep(&[]).fails(2, &["no --set gives several values"]);
    sweep(&["settings.depth=1"]).fails(2, &["no --set gives several values"]);
    sweep(&["settings.depth=1,2", "settings.samples=1,2"]).fails(2, &["two --set give several values"]);
    sweep(&["object.ball.radius=1,2,-3"]).fails(2, &["object.ball.radius=-3", "more than 0"]);
    sweep(&["settings.depth=1,,2"]).fails(2, &["settings.depth=1,,2"]);
    assert_eq!(folder.names(), ["scene.vitrine.toml"]);
}
