//! Files that are wrong: what is said, what is underlined, and the help.

use super::super::finding::Findings;
use super::dice::Dice;
use super::{parse, with};
use crate::scene_file::print_new;
use crate::{FormatError, SceneFile};
use proptest::prelude::*;

/// The lines of a file, the underlined text, words of the message and words of the help.
type Case = (&'static str, &'static str, &'static str, &'static str);

fn check(cases: &[Case]) {
    for (lines, underlined, message, help) in cases {
        let error = parse(&with(lines)).expect_err(lines);
        let [finding] = &error.findings[..] else { panic!("{lines}\n{:#?}", error.findings) };
        assert_eq!(&error.text[finding.span.clone()], *underlined, "{lines}\n{finding:#?}");
        assert!(finding.message.contains(message), "{lines}\n{finding:#?}");
        assert!(finding.help.contains(help), "{lines}\n{finding:#?}");
        assert!(!finding.label.is_empty());
    }
}

#[test]
fn keys() {
    check(&[
        ("[settings]\ndetph = 3", "detph", "[settings] has no key `detph`", "did you mean `depth`?"),
        ("[settings]\nfog = 3", "fog", "[settings] has no key `fog`", "its keys are `size`, `renderer`"),
        ("[camera]\ndepth = 3", "depth", "[camera] has no key `depth`", "it belongs in [settings]"),
        ("depth = 3", "depth", "outside of any section", "[settings]: move it below that header"),
        ("fog = 3", "fog", "a scene file has no key `fog`", "`format`, `about`, `settings`"),
        ("[setings]\ndepth = 3", "[setings]", "no section `setings`", "did you mean `settings`?"),
        (
            "[settings.size]\nx = 3",
            "[settings.size]",
            "takes a value, and this is a section",
            "[width, height]",
        ),
        (
            "[[object]]\nname = \"a b\"\nshape = \"sphere\"\n\"rad ius\" = 3",
            "\"rad ius\"",
            "[[object]] \"a b\" has no key `rad ius`",
            "did you mean `radius`?",
        ),
        (
            "[[object]]\nname = \"crate\"\nshape = \"box\"\nsmooth = true",
            "smooth",
            "`smooth` belongs to shape \"mesh\", and [[object]] \"crate\" is of shape \"box\"",
            "\"box\" has `size`",
        ),
        (
            "[[light]]\nname = \"air\"\nkind = \"ambient\"\nposition = [0, 1, 0]",
            "position",
            "belongs to kind \"point\" or \"disc\"",
            "\"ambient\" has no keys of its own",
        ),
        (
            "[[object]]\nname = \"o\"\nshape = \"plane\"\ncolor = \"#ff0000\"",
            "color",
            "has no key `color`",
            "it belongs in a [[light]] or in a [[texture]] of kind \"checker\" or in a [[material]]",
        ),
    ]);
}

#[test]
fn types() {
    check(&[
        (
            "[settings]\ndepth = 3.0",
            "3.0",
            "`depth` takes a whole number, not a number with a fraction",
            "from 0 to 32",
        ),
        ("[settings]\nsamples = \"16\"", "\"16\"", "takes a whole number, not a text", "samples = 16"),
        (
            "[settings]\nrenderer = true",
            "true",
            "a text in quotes, not true or false",
            "\"classic\", \"cast\"",
        ),
        (
            "[settings]\nsize = 800",
            "800",
            "takes [width, height], not a whole number",
            "whole numbers from 1 to 32768",
        ),
        ("[settings]\nsize = [800]", "[800]", "takes 2 numbers, not 1", "[width, height]"),
        (
            "[settings]\nsize = [800, 6e2]",
            "6e2",
            "takes whole numbers, and this is a number with a fraction",
            "whole",
        ),
        ("[camera]\nposition = [0, \"1\", 2]", "\"1\"", "takes numbers, and this is a text", "[x, y, z]"),
        ("[camera]\nposition = [0, 1]", "[0, 1]", "takes 3 numbers, not 2", "[x, y, z]"),
        ("[camera]\nposition = 2024-01-01", "2024-01-01", "not a date or time", "[x, y, z]"),
        ("[camera]\nview_angle_deg = []", "[]", "takes a number, not a list", "from 1 to 170"),
        ("[camera]\nview_angle_deg = { a = 1 }", "{ a = 1 }", "takes a number, not a table", "from 1 to 170"),
        (
            "[[group]]\nname = \"g\"\nvisible = 1",
            "1",
            "takes true or false, not a whole number",
            "true or false",
        ),
        (
            "[[group]]\nname = \"g\"\nscale = [1, 2]",
            "[1, 2]",
            "takes 3 numbers, not 2",
            "a number or [x, y, z]",
        ),
        (
            "[[material]]\nname = \"m\"\ncolor = 7",
            "7",
            "takes a colour, not a whole number",
            "\"#rrggbb\" (sRGB) or [r, g, b]",
        ),
        (
            "[[object]]\nname = \"t\"\nshape = \"triangle\"\npoints = [[0, 0, 0], [1, 0], [0, 1, 0]]",
            "[1, 0]",
            "takes 3 numbers, not 2",
            "3 points",
        ),
        (
            "[[object]]\nname = \"t\"\nshape = \"triangle\"\npoints = [1, 2, 3]",
            "1",
            "takes points, and this is",
            "3 points",
        ),
        (
            "[[object]]\nname = \"t\"\nshape = \"triangle\"\nuvs = [[0, 0]]",
            "[[0, 0]]",
            "takes 3 pairs, not 1",
            "3 pairs",
        ),
        ("about = 5", "5", "`about` takes a text in quotes, not a whole number", "one line"),
        ("light = 5", "5", "each entry of `light` is a section", "write [[light]] on a line of its own"),
        ("light = [5]", "5", "each entry of `light` is a section", "write [[light]]"),
        ("[light]\nname = \"l\"", "[light]", "`light` is a list", "write [[light]]"),
        ("[[camera]]", "[[camera]]", "there is only one camera", "write [camera]"),
        ("camera = 5", "5", "`camera` is a section", "write [camera]"),
    ]);
}

#[test]
fn numbers_that_no_radius_can_be() {
    let sphere = |radius: &str| format!("[[object]]\nname = \"ball\"\nshape = \"sphere\"\nradius = {radius}");
    for radius in ["0", "0.0", "-1.5", "nan", "-nan", "inf", "-inf", "1e39", "-1e300", "1e-60"] {
        let error = parse(&with(&sphere(radius))).expect_err(radius);
        assert_eq!(error.findings.len(), 1);
        assert_eq!(&error.text[error.findings[0].span.clone()], radius);
        assert_eq!(error.findings[0].message, format!("`radius` cannot be {radius}"));
        assert_eq!(error.findings[0].help, "`radius` takes a number, more than 0");
    }
}

#[test]
fn ranges() {
    check(&[
        ("[settings]\nsize = [0, 600]", "0", "`size` cannot be 0", "from 1 to 32768"),
        ("[settings]\nsize = [800, 40000]", "40000", "`size` cannot be 40000", "from 1 to 32768"),
        (
            "[settings]\nsize = [32768, 32768]",
            "[32768, 32768]",
            "32768 × 32768 pixels is too large",
            "at most",
        ),
        ("[settings]\nsamples = -1", "-1", "`samples` cannot be -1", "from 1 to 65536"),
        (
            "[settings]\nsamples = 9223372036854775807",
            "9223372036854775807",
            "cannot be 9223372036854775807",
            "from 1",
        ),
        (
            "[settings]\nrenderer = \"clasic\"",
            "\"clasic\"",
            "`renderer` cannot be \"clasic\"",
            "did you mean \"classic\"?",
        ),
        ("[settings]\nrenderer = \"x\"", "\"x\"", "`renderer` cannot be \"x\"", "\"classic\", \"cast\""),
        ("[settings]\nbackground = \"#12345\"", "\"#12345\"", "= \"#12345\" is no colour", "\"#rrggbb\""),
        ("[settings]\nbackground = [1, -0.5, 0]", "-0.5", "`background` cannot be -0.5", "0 or more"),
        ("[camera]\nposition = [0, nan, 0]", "nan", "`position` cannot be nan", "finite"),
        ("[camera]\nposition = [0, 1e39, 0]", "1e39", "`position` cannot be 1e39", "finite"),
        (
            "[camera]\nlook_at = [0, 1.2, 6]",
            "[0, 1.2, 6]",
            "look at the point where it stands",
            "at some distance",
        ),
        (
            "[camera]\nturn_deg = [0, 0, 0]\nlook_at = [0, 1, 0]",
            "[0, 1, 0]",
            "both `turn_deg` and `look_at`",
            "keep the one",
        ),
        (
            "[[light]]\nname = \"l\"\nkind = \"point\"\nintensity = -1",
            "-1",
            "`intensity` cannot be -1",
            "0 or more",
        ),
        (
            "[[light]]\nname = \"l\"\nkind = \"directional\"\ndirection = [0, 0, 0]",
            "[0, 0, 0]",
            "`direction` cannot be [0, 0, 0]",
            "not all zero",
        ),
        ("[[group]]\nname = \"g\"\nscale = 0", "0", "`scale` cannot be 0", "none of them zero"),
        (
            "[[group]]\nname = \"g\"\nscale = [1, 0, 1]",
            "[1, 0, 1]",
            "`scale` cannot be [1, 0, 1]",
            "none of them zero",
        ),
        (
            "[[object]]\nname = \"b\"\nshape = \"box\"\nsize = [1, -2, 1]",
            "-2",
            "`size` cannot be -2",
            "more than 0",
        ),
        (
            "[[object]]\nname = \"m\"\nshape = \"mesh\"\nfile = \"\"",
            "\"\"",
            "`file` cannot be \"\"",
            "path of a file",
        ),
        (
            "[[object]]\nname = \"t\"\nshape = \"triangle\"\npoints = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]",
            "[[0, 0, 0], [1, 0, 0], [2, 0, 0]]",
            "lie on one line",
            "move one of the points",
        ),
    ]);
}

#[test]
fn names_kinds_and_references() {
    check(&[
        (
            "[[material]]\ncolor = \"#ffffff\"",
            "[[material]]",
            "this [[material]] has no name",
            "no other [[material]] has",
        ),
        ("[[material]]\nname = 3", "3", "a name is a text in quotes, not a whole number", "name = "),
        ("[[material]]\nname = \"\"", "\"\"", "the name is empty", "give it a name"),
        ("[[material]]\nname = \" \"", "\" \"", "the name is empty", "give it a name"),
        (
            "[[material]]\nname = \"m\"\n[[material]]\nname = 'm'",
            "'m'",
            "two [[material]] with the name `m`",
            "its own name",
        ),
        (
            "[[object]]\nname = \"o\"",
            "[[object]]",
            "[[object]] \"o\" does not say of which shape",
            "\"sphere\", \"box\"",
        ),
        ("[[object]]\nname = \"o\"\nshape = 1", "1", "`shape` takes a text in quotes", "\"sphere\""),
        // The keys of an unknown shape are not judged.
        (
            "[[object]]\nname = \"o\"\nshape = \"spere\"\nradius = 1",
            "\"spere\"",
            "no shape \"spere\"",
            "did you mean \"sphere\"?",
        ),
        ("[[light]]\nname = \"l\"\nkind = \"lamp\"", "\"lamp\"", "no kind \"lamp\"", "\"directional\""),
        (
            "[[object]]\nname = \"o\"\nshape = \"mesh\"",
            "[[object]]",
            "[[object]] \"o\" has no `file`",
            "add file = …",
        ),
        (
            "[[material]]\nname = \"glass\"\n[[object]]\nname = \"o\"\nshape = \"box\"\nmaterial = \"glas\"",
            "\"glas\"",
            "there is no material `glas`",
            "did you mean `glass`?",
        ),
        ("[[group]]\nname = \"a\"\ngroup = \"a\"", "\"a\"", "`a` is inside itself", "outermost"),
        (
            "[[group]]\nname = \"a\"\ngroup = \"b\"\n[[group]]\nname = \"b\"\ngroup = \"a\"",
            "\"b\"",
            "`a` is inside itself",
            "outermost",
        ),
    ]);
}

#[test]
fn versions() {
    let finding = |text: &str| {
        let error = parse(text).expect_err(text);
        (
            error.text[error.findings[0].span.clone()].to_owned(),
            error.findings[0].clone(),
            error.findings.len(),
        )
    };
    let (underlined, missing, _) = finding("[camera]\n");
    assert_eq!((underlined.as_str(), missing.help.as_str()), ("", "write format = 1 as the first line"));
    // Nothing else is said of a file that follows other rules.
    let (underlined, newer, count) = finding("format = 2\n[new]\n");
    assert_eq!((underlined.as_str(), count), ("2", 1));
    assert!(newer.help.contains("newer version"), "{newer:?}");
    for old in ["format = 0", "format = \"1\"", "format = 1.0", "[format]"] {
        assert!(finding(old).1.message.contains("format 1 only"), "{old}");
    }
}

#[test]
fn text_that_is_no_toml() {
    check(&[
        ("name = “ball”", "“ball”", "not a straight quote", "write \""),
        ("visible = True", "True", "no value", "small letters"),
        ("name = ball", "ball", "must stand in quotes", "\"…\""),
        ("name =", "", "the value is missing", "after the ="),
        ("name = \"ball", "", "the text is not closed", "write \" at its end"),
        ("name", "", "neither a key with a value nor a header", "key = value"),
        ("radius = 0,5", "", "between this value and the end of the line", "decimals have a point"),
        ("size = [1, 2", "", "the list is not closed", "]"),
        ("size = [1 2]", "1 2", "several values", "[1, 2, 3]"),
        ("size = [\"a\" \"b\"]", "", "comma is missing", "[1, 2, 3]"),
        ("radius = 1__0", "_", "no number", "-0.5"),
        ("[camera", "", "the header is not closed", "[camera]"),
        ("[[object]", "", "the header is not closed", "[[object]]"),
        ("file = \"models\\cone.obj\"", "", "a backslash in a text", "or / in the path"),
        ("радиус = 1", "радиус", "cannot have this name", "Latin letters"),
        ("[camera]\n[camera]", "camera", "stands twice", "keep one"),
        ("[camera]\nposition = [0, 0, 0]\nposition = [0, 0, 0]", "position", "stands twice", "keep one"),
        ("seed = 99999999999999999999", "99999999999999999999", "too large", "smaller"),
    ]);
}

#[test]
fn everything_wrong_is_said_at_once_in_the_order_of_the_text() {
    let text = "[[object]]\nshape = \"box\"\nsize = 0\n[camera]\nfoo = 1\nposition = nan\n";
    let error = parse(text).unwrap_err();
    let underlined: Vec<_> = error.findings.iter().map(|f| &error.text[f.span.clone()]).collect();
    assert_eq!(underlined, ["", "[[object]]", "0", "foo", "nan"]);
    assert_eq!(error.to_string(), "the file does not say which format it has, and 4 more: test.vitrine.toml");
}

#[test]
fn of_very_many_findings_the_first_are_kept() {
    let keys: String = (0..1000).rev().map(|i| format!("fog{i} = 1\n")).collect();
    let error = parse(&with(&format!("[settings]\n{keys}"))).unwrap_err();
    assert_eq!((error.findings.len(), error.more), (Findings::MOST, 1000 - Findings::MOST));
    assert_eq!(&error.text[error.findings[0].span.clone()], "fog999");
}

#[test]
fn files_that_cannot_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    assert!(matches!(SceneFile::read(&at("none")), Err(FormatError::Missing { .. })));
    assert!(matches!(SceneFile::read(folder.path()), Err(FormatError::NotAFile { .. })));

    std::fs::write(at("latin1"), b"format = 1\nabout = \"caf\xe9\"\n").unwrap();
    let error = SceneFile::read(&at("latin1")).unwrap_err();
    assert!(matches!(error, FormatError::NotText { position: 23, byte: 0xe9, .. }), "{error}");
    assert!(error.to_string().ends_with("latin1"), "{error}");

    std::fs::File::create(at("huge")).unwrap().set_len(super::super::MAX_BYTES + 1).unwrap();
    let error = SceneFile::read(&at("huge")).unwrap_err().to_string();
    assert!(error.contains("more than 16 MB: "), "{error}");

    std::fs::write(at("wide"), b"\xff\xfef\0o\0").unwrap();
    assert!(SceneFile::read(&at("wide")).unwrap_err().help().contains("UTF-16"));
}

/// The text with a few pieces cut out, doubled, moved or replaced by what means something in TOML.
fn damaged(text: &str, dice: &mut Dice) -> String {
    const PARTS: [&str; 14] = ["", "[", "]", "\"", "'", "=", ".", ",", "\n", "{", "}", "#", "nan", "é"];
    let mut chars: Vec<char> = text.chars().collect();
    for _ in 0..1 + dice.below(4) {
        let at = dice.below(chars.len());
        let end = chars.len().min(at + dice.below(12));
        let doubled: String = chars[at..end].iter().collect();
        let part = if dice.chance(3) { doubled + "\n" } else { dice.one_of(&PARTS).to_owned() };
        let to = if dice.chance(2) { at } else { dice.below(at + 1) };
        chars.splice(to..end.max(to), part.chars());
        chars.push('\n');
    }
    chars.into_iter().collect()
}

proptest! {
    #[test]
    fn a_damaged_file_is_read_or_refused_with_places_in_its_text(seed in any::<u64>()) {
        let mut dice = Dice::new(seed);
        let scene = dice.scene();
        let text = damaged(&print_new(&scene), &mut dice);
        match parse(&text) {
            Ok(file) => prop_assert_eq!(file.print(file.scene()), text),
            Err(error) => {
                for finding in &error.findings {
                    prop_assert!(text.get(finding.span.clone()).is_some(), "{finding:?}\n{text}");
                    prop_assert!(!finding.message.is_empty() && !finding.help.is_empty(), "{finding:?}");
                }
            }
        }
    }
}
