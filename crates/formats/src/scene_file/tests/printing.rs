//! Files that are written.

use super::dice::Dice;
use super::{EXAMPLE, parse, with};
use crate::scene_file::print_new;
use proptest::prelude::*;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::lights::Point;
use vitrine_scene::shapes::{Cuboid, Plane, Sphere};
use vitrine_scene::{Light, LightSource, Material, Object, Scene, Shape};

/// The same file as an unruly person would write it.
fn unruly(text: &str, dice: &mut Dice) -> String {
    let mut lines = Vec::new();
    for line in text.lines() {
        if line.is_empty() && dice.chance(3) {
            continue;
        }
        if !line.is_empty() && dice.chance(4) {
            lines.push(format!("  # remark {} ", dice.below(100)));
        }
        if line.starts_with('[') && dice.chance(4) {
            lines.push(String::new());
        }
        let indent = dice.one_of(&["", "", "  ", "\t"]);
        let end = dice.one_of(&["", "", "   ", " # said so"]);
        let equals = dice.one_of(&[" = ", "=", "   =  "]);
        lines.push(format!("{indent}{}{end}", line.replacen(" = ", equals, 1)));
    }
    let newline = dice.one_of(&["\n", "\r\n"]);
    let mark = dice.one_of(&["", "", "", "\u{feff}"]);
    mark.to_owned() + &lines.join(newline) + dice.one_of(&["", newline, "\n\n# the end\n"])
}

proptest! {
    #[test]
    fn what_was_printed_reads_as_the_same_scene(seed in any::<u64>()) {
        let scene = Dice::new(seed).scene();
        let text = print_new(&scene);
        match parse(&text) {
            Ok(file) => prop_assert_eq!(file.scene(), &scene, "{}", text),
            Err(error) => prop_assert!(false, "{:#?}\n{}", error.findings, text),
        }
    }

    #[test]
    fn an_unchanged_scene_leaves_the_text_as_it_was(seed in any::<u64>()) {
        let mut dice = Dice::new(seed);
        let scene = dice.scene();
        let text = unruly(&print_new(&scene), &mut dice);
        let file = parse(&text).unwrap_or_else(|e| panic!("{:#?}\n{text}", e.findings));
        prop_assert_eq!(file.scene(), &scene);
        prop_assert_eq!(file.print(&scene), text);
    }

    #[test]
    fn a_changed_scene_is_what_the_changed_text_says(seed in any::<u64>()) {
        let mut dice = Dice::new(seed);
        let scene = dice.scene();
        let text = unruly(&print_new(&scene), &mut dice);
        let changed = dice.changed(&scene);
        let printed = parse(&text).unwrap().print(&changed);
        match parse(&printed) {
            Ok(file) => prop_assert_eq!(file.scene(), &changed, "{}\n----\n{}", text, printed),
            Err(error) => prop_assert!(false, "{:#?}\n{}\n----\n{}", error.findings, text, printed),
        }
    }
}

/// Found by fuzzing: an empty line says as much as none.
#[test]
fn an_empty_about_stays_as_it_was() {
    let text = "format = 1\nabout = \"\"";
    let file = parse(text).unwrap();
    assert_eq!(file.print(file.scene()), text);
}

/// The lines that are in one text and not in the other: (gone, new).
fn difference<'a>(before: &'a str, after: &'a str) -> (Vec<&'a str>, Vec<&'a str>) {
    let only = |a: &'a str, b: &str| a.lines().filter(|line| !b.lines().any(|l| l == *line)).collect();
    (only(before, after), only(after, before))
}

fn edited(text: &str, change: impl FnOnce(&mut Scene)) -> String {
    let file = parse(text).unwrap();
    let mut scene = file.scene().clone();
    change(&mut scene);
    let printed = file.print(&scene);
    let again = parse(&printed).unwrap_or_else(|e| panic!("{:#?}\n{printed}", e.findings));
    assert_eq!(again.scene(), &scene, "{printed}");
    printed
}

#[test]
fn an_edited_value_changes_its_line_alone() {
    let printed = edited(EXAMPLE, |s| s.settings.depth = 7);
    assert_eq!(printed, EXAMPLE.replace("depth = 3   ", "depth = 7   "));
    let printed = edited(EXAMPLE, |s| s.objects[0].shape = Shape::Sphere(Sphere { radius: 0.1 }));
    assert_eq!(printed, EXAMPLE.replace("radius = 1.0", "radius = 0.1"));
    let printed = edited(EXAMPLE, |s| s.materials[0].color = Some(Rgb::new(2.0, 0.0, 0.0)));
    assert_eq!(printed, EXAMPLE.replace("\"#c8281e\"", "[2.0, 0.0, 0.0]"));
}

#[test]
fn of_a_list_only_the_number_that_differs_is_written_anew() {
    let text = with("[camera]\nposition = [ 0, +1_0.50,  # up\n  6.00 ]\n");
    let printed = edited(&text, |s| s.camera.position.x = 0.5);
    assert_eq!(printed, text.replace("[ 0,", "[ 0.5,"));
    let text = with("[settings]\nsize = [0x320, 600]\nbackground = [0.10, 0.20, 0.30]\n");
    let printed = edited(&text, |s| (s.settings.size[1], s.settings.background.b) = (500, 1.0));
    assert_eq!(printed, text.replace("600", "500").replace("0.30", "1.0"));
}

#[test]
fn a_new_key_comes_behind_the_one_that_stands_before_it() {
    let printed = edited(EXAMPLE, |s| s.objects[0].turn_deg.y = 30.0);
    let line = "position = [0.0, 1.0, 0.0]\n";
    assert_eq!(printed, EXAMPLE.replace(line, &format!("{line}turn_deg = [0.0, 30.0, 0.0]\n")));
    let printed = edited(EXAMPLE, |s| s.about = "A ball".into());
    assert_eq!(printed, EXAMPLE.replacen("format = 1\n", "format = 1\nabout = \"A ball\"\n", 1));
}

#[test]
fn what_is_not_stated_any_more_goes_with_its_line() {
    let printed = edited(EXAMPLE, |s| s.materials[0].transparency = None);
    assert_eq!(printed, EXAMPLE.replace("transparency = 0.8\n", ""));
    let printed = edited(EXAMPLE, |s| (s.camera.turn_deg, s.camera.look_at) = (None, Some(Vec3::Y)));
    let (gone, new) = difference(EXAMPLE, &printed);
    assert_eq!((gone.len(), new), (1, vec!["look_at = [0.0, 1.0, 0.0]"]));
}

#[test]
fn another_kind_keeps_what_both_have() {
    let printed = edited(EXAMPLE, |s| {
        s.lights[0].source = LightSource::Point(Point { position: Vec3::new(2.0, 5.0, 1.0) });
    });
    let expected = EXAMPLE
        .replace("\"disc\"", "\"point\"")
        .replace("5.0, 3.0]", "5.0, 1.0]")
        .replace("radius = 0.5\n", "");
    assert_eq!(printed, expected);
}

/// Three objects with remarks of all sorts.
const REMARKS: &str = "#:schema ../docs/vitrine.schema.json
# A file with remarks.
format = 1

# == lamps ==

# The sun.
[[light]]
name = \"sun\" # far away
kind = \"directional\"

# == things ==

# The first.
# It stands left.
[[object]]
name = \"a\"
shape = \"sphere\"
# Its size.
radius = 1 # metre

[[object]]
name = \"b\"
shape = \"box\"

# The last.
[[object]]
name = \"c\"
shape = \"plane\"
";

#[test]
fn a_removed_entry_takes_its_own_remarks_and_no_others() {
    let printed = edited(REMARKS, |s| drop(s.objects.remove(0)));
    let (start, end) =
        (REMARKS.find("# The first").unwrap(), REMARKS.find("[[object]]\nname = \"b\"").unwrap());
    assert_eq!(printed, format!("{}{}", &REMARKS[..start], &REMARKS[end..]));

    let printed = edited(REMARKS, |s| drop(s.objects.pop()));
    assert_eq!(printed, REMARKS[..REMARKS.find("\n# The last").unwrap()]);

    let printed = edited(REMARKS, |s| s.lights.clear());
    let (start, end) = (REMARKS.find("# The sun").unwrap(), REMARKS.find("\n# == things").unwrap());
    assert_eq!(printed, format!("{}{}", &REMARKS[..start], &REMARKS[end..]));
}

#[test]
fn a_moved_entry_takes_its_remarks_along() {
    let printed = edited(REMARKS, |s| s.objects.swap(0, 2));
    let block = |from: &str, to: &str| {
        let start = REMARKS.find(from).unwrap();
        let end = REMARKS[start..].find(to).map_or(REMARKS.len(), |at| start + at);
        &REMARKS[start..end]
    };
    let (first, last) = (block("# The first", "\n[[object]]\nname = \"b\""), block("# The last", "\u{0}"));
    assert_eq!(printed, REMARKS.replace(last, "\u{0}").replace(first, last).replace('\u{0}', first));
}

#[test]
fn a_renamed_entry_is_the_same_entry_and_is_followed() {
    let printed = edited(EXAMPLE, |s| {
        s.materials[0].name = "ruby \"1\"".into();
        s.objects[0].material = Some("ruby \"1\"".into());
    });
    assert_eq!(printed, EXAMPLE.replace("\"red glass\"", r#""ruby \"1\"""#));
}

#[test]
fn new_entries_come_behind_the_one_before_them() {
    let new = Object { name: "new".into(), shape: Shape::Plane(Plane {}), ..Object::default() };
    let block = "[[object]]\nname = \"new\"\nshape = \"plane\"\n";
    let printed = edited(REMARKS, |s| s.objects.insert(1, new.clone()));
    assert_eq!(printed, REMARKS.replace("# metre\n", &format!("# metre\n\n{block}")));
    let printed = edited(REMARKS, |s| s.objects.insert(0, new.clone()));
    assert_eq!(printed, REMARKS.replace("# The first.", &format!("{block}\n# The first.")));
    let printed = edited(REMARKS, |s| s.objects.push(new.clone()));
    assert_eq!(printed, format!("{REMARKS}\n{block}"));
}

#[test]
fn new_sections_and_lists_find_their_place() {
    let printed = edited(REMARKS, |s| {
        s.settings.depth = 5;
        s.camera.view_angle_deg = 30.0;
        s.materials.push(Material { name: "m".into(), ..Material::default() });
    });
    let headers: Vec<_> = printed.lines().filter(|l| l.starts_with('[')).collect();
    let objects = ["[[object]]"; 3];
    assert_eq!(headers[..4], ["[settings]", "[camera]", "[[light]]", "[[material]]"]);
    assert_eq!(headers[4..], objects);
    let (gone, _) = difference(REMARKS, &printed);
    assert!(gone.is_empty(), "{printed}");
}

#[test]
fn line_ends_of_windows_and_a_missing_last_one_stay() {
    let windows = REMARKS.replace('\n', "\r\n");
    let printed = edited(&windows, |s| {
        s.objects[0].position.x = 2.0;
        s.lights.push(Light::default());
    });
    assert_eq!(printed.matches('\n').count(), printed.matches("\r\n").count(), "{printed:?}");
    assert!(printed.contains("# metre\r\nposition = [2.0, 0.0, 0.0]\r\n"), "{printed:?}");

    let open = REMARKS.trim_end();
    let printed = edited(open, |s| s.objects[2].position.y = 2.0);
    assert_eq!(printed, format!("{open}\nposition = [0.0, 2.0, 0.0]"));
    let printed = edited(open, |s| s.objects.swap(0, 2));
    assert_eq!(printed.lines().count(), open.lines().count());
}

#[test]
fn tables_in_braces_and_with_dots_are_edited_in_place_or_written_anew() {
    let text = "format = 1\nsettings.depth = 5 # deep\ncamera = { view_angle_deg = 30 } # narrow\n\
                object = [{ name = \"a\", shape = \"plane\" }, { name = \"b\", shape = \"box\", size = [1, 2, 3] }]\n";
    let printed = edited(text, |s| {
        (s.settings.depth, s.camera.view_angle_deg) = (6, 40.0);
        s.objects[1].shape = Shape::Box(Cuboid { size: Vec3::new(1.0, 2.0, 4.0) });
    });
    assert_eq!(printed, text.replace("= 5", "= 6").replace("= 30", "= 40.0").replace("3] }", "4.0] }"));

    let printed = edited(text, |s| {
        s.settings.seed = 1;
        s.camera.position.x = 1.0;
        s.objects.remove(0);
    });
    assert_eq!(
        printed,
        "format = 1\n\n[settings]\ndepth = 5\nseed = 1\n\n[camera]\nposition = [1.0, 1.2, 6.0]\nview_angle_deg = 30.0\n\
         \n[[object]]\nname = \"b\"\nshape = \"box\"\nsize = [1.0, 2.0, 3.0]\n"
    );
}

#[test]
fn a_new_file_says_what_differs_and_what_it_must() {
    let scene = Scene {
        about: "A \"box\"".into(),
        lights: vec![Light { intensity: 1.0, ..Light::default() }],
        objects: vec![Object { shape: Shape::Box(Cuboid::default()), ..Object::default() }],
        ..Scene::default()
    };
    let expected = "format = 1\nabout = \"A \\\"box\\\"\"\n\n[[light]]\nname = \"light\"\nkind = \"point\"\nintensity = 1.0\n\
                    \n[[object]]\nname = \"object\"\nshape = \"box\"\n";
    assert_eq!(print_new(&scene), expected);
    assert_eq!(print_new(&Scene::default()), "format = 1\n");
}
