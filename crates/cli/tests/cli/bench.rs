//! `vitrine bench`: that it measures and reports, not how fast.

use crate::support::Folder;

/// C18.
#[test]
fn a_row_for_each_number_of_threads_a_file_and_a_plot() {
    let folder = Folder::with_scene();
    let outcome = folder.run_well(&[
        "bench",
        "threads",
        "scene.vitrine.toml",
        "--threads",
        "3,1,2",
        "--repeats",
        "2",
        "--csv",
        "t.csv",
        "--plot",
        "t.svg",
    ]);
    let rows: Vec<Vec<&str>> = outcome.out.lines().map(|l| l.split_whitespace().collect()).collect();
    let head = rows.iter().position(|r| r.first() == Some(&"Threads")).expect("the table has a head");
    let threads: Vec<_> = rows[head + 1..].iter().map(|r| r[0]).collect();
    assert_eq!(threads, ["1", "2", "3"], "{}", outcome.out);

    let csv = String::from_utf8(folder.read("t.csv")).unwrap();
    let lines: Vec<_> = csv.lines().collect();
    assert_eq!((lines.len(), lines[0]), (4, "threads,wall_seconds,cpu_seconds,speed_up"));
    assert!(lines[1].starts_with("1,") && lines[1].ends_with(",1.0000"), "{csv}");
    for cell in lines[1..].iter().flat_map(|l| l.split(',')) {
        assert!(cell.parse::<f64>().is_ok_and(|v| v >= 0.0), "{csv}");
    }

    let svg = String::from_utf8(folder.read("t.svg")).unwrap();
    for word in ["<svg", "Number of threads", "Time, s", "Ideal on", "</svg>"] {
        assert!(svg.contains(word), "no {word}");
    }
}

#[test]
fn without_a_scene_it_measures_the_benchmark_of_the_course_work() {
    let small = ["--size", "32x32", "--threads", "1", "--repeats", "1"];
    let outcome = Folder::new().run_well(&[&["bench", "threads"], &small[..]].concat());
    assert!(outcome.out.starts_with("benchmark, 32 × 32 pixels, median of 1, "), "{}", outcome.out);
}

#[test]
fn a_plot_as_a_picture() {
    let folder = Folder::with_scene();
    folder.run_well(&[
        "bench",
        "threads",
        "scene.vitrine.toml",
        "--threads",
        "1,2",
        "--repeats",
        "1",
        "--plot",
        "t.png",
    ]);
    let plot = folder.picture("t.png");
    assert_eq!(plot.size, [960, 600]);
    assert!(plot.texels.iter().any(|[r, _, b]| *b > 120 && *r < 80), "the measured line is blue");
}

#[test]
fn wrong_lists_and_places_are_told_before_measuring() {
    let folder = Folder::with_scene();
    let bench = |more: &[&str]| folder.run(&[&["bench", "threads", "scene.vitrine.toml"], more].concat());
    bench(&["--threads", "1,0"]).fails(2, &["1 to 1024"]);
    bench(&["--threads", "many"]).fails(2, &["1 to 1024"]);
    bench(&["--repeats", "0"]).fails(2, &["repeats"]);
    bench(&["--plot", "t.gif"]).fails(2, &[".svg or .png"]);
    bench(&["--csv", "missing/t.csv"]).fails(1, &["no such folder: missing"]);
    assert_eq!(folder.names(), ["scene.vitrine.toml"]);
}

/// Quick: small scenes, few rays, one round.
const SMALL: [&str; 8] = ["bench", "kernel", "--triangles", "2000", "--size", "32x32", "--repeats", "1"];

#[test]
fn the_kernel_has_a_row_for_each_scene_and_kind_of_ray_and_one_for_each_tree() {
    let folder = Folder::new();
    let text = folder.run_well(&[&SMALL[..], &["--csv", "k.csv"]].concat()).out;
    assert!(text.contains("median of 1, rays for 32 × 32 pixels"), "{text}");
    let rows: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
    for scene in ["seed", "room", "cave"] {
        for rays in ["primary", "shadow", "mirror", "diffuse", "ambient"] {
            let row = rows.iter().find(|r| r.len() == 4 && r[0] == scene && r[1] == rays).expect(rays);
            assert!(row[2..].iter().all(|n| n.parse::<f64>().is_ok_and(|v| v > 0.0)), "{row:?}");
        }
    }
    assert!(rows.iter().any(|r| r[..].starts_with(&["seed", "642"])), "{text}");
    let csv = String::from_utf8(folder.read("k.csv")).unwrap();
    assert_eq!(csv.lines().count(), 16);
    assert!(csv.lines().all(|l| l.split(',').count() == 7), "{csv}");
}

#[test]
fn one_scene_of_the_kernels_is_measured_alone() {
    let text = Folder::new().run_well(&[&SMALL[..], &["--scenes", "cave"]].concat()).out;
    assert!(text.contains("cave") && !text.contains("room") && !text.contains("seed"), "{text}");
}

#[test]
fn growth_of_the_kernel_as_a_table_and_a_plot() {
    let folder = Folder::new();
    let growth = ["--growth", "--plot", "g.svg", "--csv", "g.csv"];
    let text = folder.run_well(&[&SMALL[..], &growth].concat()).out;
    // 20·7² and 20·10² triangles.
    assert!(text.contains("\n      980  ") && text.contains("\n    2 000  "), "{text}");
    assert!(text.contains("Diffuse, alone: each doubling adds "), "{text}");
    let csv = String::from_utf8(folder.read("g.csv")).unwrap();
    assert_eq!(csv.lines().count(), 3);
    let svg = String::from_utf8(folder.read("g.svg")).unwrap();
    for word in ["Number of triangles", "Time of a ray, ns", "Primary, in packets", "Diffuse, alone"] {
        assert!(svg.contains(word), "no {word}");
    }
}

#[test]
fn wrong_words_for_the_kernel_are_told_before_measuring() {
    let folder = Folder::new();
    let kernel = |more: &[&str]| folder.run(&[&SMALL[..], more].concat());
    kernel(&["--scenes", "cellar"]).fails(2, &["cellar", "cave"]);
    kernel(&["--plot", "g.svg"]).fails(2, &["--growth"]);
    kernel(&["--growth", "--plot", "g.gif"]).fails(2, &[".svg or .png"]);
    kernel(&["--growth", "--scenes", "cave"]).fails(2, &["--growth"]);
    kernel(&["--csv", "missing/k.csv"]).fails(1, &["no such folder: missing"]);
    folder.run(&["bench", "kernel", "--triangles", "5"]).fails(2, &["1000"]);
    assert!(folder.names().is_empty(), "{:?}", folder.names());
}
