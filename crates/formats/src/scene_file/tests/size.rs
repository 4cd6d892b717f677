//! Files that are very large or very deep: read or refused in seconds, with no overflow of the stack.

use super::parse;
use std::time::{Duration, Instant};

/// Ten megabytes.
const SIZE: usize = 10_000_000;

/// Far more than is needed, even on a busy machine; what grows with the square of the size takes hours.
const PATIENCE: Duration = Duration::from_secs(100);

/// Lines until the text has its size.
fn repeated(start: &str, line: impl Fn(usize) -> String) -> String {
    let mut text = start.to_owned();
    for i in 0.. {
        if text.len() >= SIZE {
            break;
        }
        text += &line(i);
    }
    text
}

/// How many findings there are; 0 for a file that is right.
fn count_findings(text: &str) -> usize {
    let start = Instant::now();
    let count = match parse(text) {
        Ok(file) => {
            let mut scene = file.scene().clone();
            scene.settings.depth = 9;
            if let Some(last) = scene.objects.last_mut() {
                last.name = "renamed".into();
            }
            let printed = file.print(&scene);
            assert!(printed.len().abs_diff(text.len()) < 1000);
            0
        }
        Err(error) => {
            assert!(error.findings.iter().all(|f| error.text.get(f.span.clone()).is_some()));
            assert!(error.findings.iter().all(|f| f.message.len() + f.help.len() < 1000));
            error.findings.len() + error.more
        }
    };
    assert!(start.elapsed() < PATIENCE, "{:?}: {}…", start.elapsed(), &text[..100]);
    count
}

#[test]
fn ten_megabytes_of_objects_in_groups() {
    let text = repeated("format = 1\n", |i| {
        format!(
            "[[group]]\nname = \"g{i}\"\n[[object]]\nname = \"o{i}\"\nshape = \"box\"\ngroup = \"g{i}\"\n"
        )
    });
    assert_eq!(count_findings(&text), 0);
}

#[test]
fn ten_megabytes_of_objects_on_one_line() {
    let text =
        repeated("format = 1\nobject = [", |i| format!("{{ name = \"o{i}\", shape = \"box\" }}, ")) + "]\n";
    assert_eq!(count_findings(&text), 0);
}

#[test]
fn ten_megabytes_of_groups_inside_one_another() {
    let text = repeated("format = 1\n[[group]]\nname = \"g\"\n", |i| {
        let outer = i.checked_sub(1).map_or_else(|| "g".to_owned(), |o| format!("g{o}"));
        format!("[[group]]\nname = \"g{i}\"\ngroup = \"{outer}\"\n")
    });
    assert_eq!(count_findings(&text), 0);
}

#[test]
fn ten_megabytes_of_mistakes() {
    let many = 100_000;
    assert!(count_findings(&repeated("format = 1\n", |i| format!("fog{i} = 1\n"))) > many);
    assert!(count_findings(&repeated("format = 1\n", |_| "[[group]]\nname = \"g\"\n".into())) > many);
    let missing = |i| {
        format!(
            "[[material]]\nname = \"m{i}\"\n[[object]]\nname = \"o{i}\"\nshape = \"box\"\nmaterial = \"n{i}\"\n"
        )
    };
    assert!(count_findings(&repeated("format = 1\n", missing)) > many);
    let long = format!("format = 1\n[settings]\nrenderer = \"{}\"\n", "ж".repeat(SIZE / 2));
    assert_eq!(count_findings(&long), 1);
}

#[test]
fn megabytes_of_junk_of_every_sort() {
    for junk in ["[", "]", "=", "\"", "'''", "a.", "{a=", "\u{0}", "é", "\\", "#\r", "\n[[x]]", "1,"] {
        assert!(count_findings(&junk.repeat(SIZE / 4 / junk.len())) > 0, "{junk:?}");
    }
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        char::from((state >> 25) as u8)
    };
    for _ in 0..20 {
        assert!(count_findings(&(0..SIZE / 20).map(|_| noise()).collect::<String>()) > 0);
    }
}

#[test]
fn deep_nesting_is_refused() {
    for depth in [100, 100_000] {
        for (open, close) in [("[", "]"), ("{ a = ", " }")] {
            let text =
                format!("format = 1\n[camera]\nposition = {}1{}\n", open.repeat(depth), close.repeat(depth));
            let error = parse(&text).unwrap_err();
            assert_eq!(error.findings[0].message, "brackets stand too deep inside one another");
            assert!(error.findings[0].span.start < 1000);
        }
        for (start, end) in [("", " = 1"), ("[", "]"), ("[[", "]]")] {
            let text = format!("format = 1\n{start}a{}{end}\n", ".a".repeat(depth));
            let error = parse(&text).unwrap_err();
            assert_eq!(error.findings[0].message, "a key has far too many dots");
            assert_eq!(error.text[..error.findings[0].span.start].lines().count(), 1, "the line is found");
        }
    }
    // As deep as TOML's parser goes: refused by the reader.
    let text = format!("format = 1\n[camera]\nposition = {}1{}\n", "[".repeat(70), "]".repeat(70));
    assert_eq!(parse(&text).unwrap_err().findings[0].message, "`position` takes 3 numbers, not 1");
}
