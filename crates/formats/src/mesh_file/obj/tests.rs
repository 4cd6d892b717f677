//! Tests of the OBJ reader.

use super::*;
use proptest::prelude::*;
use std::fs;
use vitrine_scene::MeshPart;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn parse_text(text: &str) -> Result<Reading, FormatError> {
    parse(text.as_bytes(), Path::new("a.obj"), &mut |name| Err(FormatError::Missing { path: name.into() }))
}

fn mesh(text: &str) -> TriangleMesh {
    let (mesh, warnings) = parse_text(text).unwrap();
    assert_eq!(warnings, [""; 0]);
    mesh
}

fn message(text: &str) -> String {
    parse_text(text).unwrap_err().to_string()
}

#[test]
fn corners_share_vertices_where_all_they_say_is_the_same() {
    let m = mesh(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\n\
         f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n",
    );
    assert_eq!(m.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(m.positions.len(), 4);
    assert_eq!(m.uvs[2], Vec2::ONE);
    assert_eq!(m.normals, [Vec3::Z; 4], "made unit length");
    let split = mesh(&format!("{TRIANGLE}v 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 2/2 4/2 3/2\n"));
    assert_eq!(split.positions.len(), 6, "a seam in the texture splits vertices");
}

#[test]
fn corners_without_normals_have_zero_and_models_without_have_none() {
    let m = mesh(&format!("{TRIANGLE}v 0 0 1\nvn 0 0 1\nf 1 2 3\nf 1//1 2//1 3//1\nf 1 2 4\n"));
    assert_eq!(m.normals, [Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, Vec3::Z, Vec3::Z, Vec3::Z, Vec3::ZERO]);
    assert!(m.uvs.is_empty());
    assert!(mesh(&format!("{TRIANGLE}vn 0 0 1\nf 1 2 3")).normals.is_empty());
}

#[test]
fn negative_indices_count_from_the_end() {
    let m = mesh(&format!("{TRIANGLE}f -3 -2 -1\nv 0 0 1\nf -4 -2 -1\n"));
    assert_eq!(m.positions, [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z]);
    assert_eq!(m.triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn groups_and_materials_make_parts() {
    let text = format!(
        "mtllib a.mtl\n{TRIANGLE}f 1 2 3\ng left  side\nusemtl red\nf 1 2 3\nf 1 3 2\nusemtl blue\nf 1 2 3\n\
         usemtl red\ng empty\no right\nf 1 2 3\n"
    );
    let mut asked = Vec::new();
    let library = |name: &str| {
        asked.push(name.to_owned());
        Ok(b"newmtl blue\nnewmtl unused\nnewmtl red\nmap_Kd r.png".to_vec())
    };
    let (m, warnings) = parse(text.as_bytes(), Path::new("models/a.obj"), &mut { library }).unwrap();
    assert_eq!(warnings, [""; 0]);
    let part = |name: &str, triangles, material| MeshPart { name: name.into(), triangles, material };
    assert_eq!(
        m.parts,
        [
            part("default", 0..1, None),
            part("left  side", 1..3, Some(0)),
            part("left  side", 3..4, Some(1)),
            part("right", 4..5, Some(0)),
        ]
    );
    let names: Vec<_> = m.materials.iter().map(|m| m.material.name.as_str()).collect();
    assert_eq!(names, ["red", "blue"], "only those in use");
    assert_eq!(m.materials[0].picture, Some("r.png".into()));
    assert_eq!(asked, ["a.mtl"]);
}

#[test]
fn libraries_in_folders_with_spaces_and_several_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    fs::create_dir(folder.path().join("sub")).unwrap();
    write("two words.mtl", "newmtl a");
    write("sub/b.mtl", "newmtl b\nmap_Kd b.png");
    write("c.mtl", "newmtl c");
    write(
        "m.obj",
        &format!(
            "mtllib \"two words.mtl\"\nmtllib two words.mtl\nmtllib sub\\b.mtl c.mtl\n{TRIANGLE}\
             usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n"
        ),
    );
    let (m, warnings) = crate::read_mesh(&folder.path().join("m.obj")).unwrap();
    assert_eq!(warnings, [""; 0]);
    assert_eq!(m.materials.len(), 3);
    assert_eq!(m.materials[1].picture, Some("sub/b.png".into()));
}

#[test]
fn missing_and_broken_libraries_are_warnings() {
    let (m, warnings) = parse_text(&format!("mtllib a.mtl\n{TRIANGLE}usemtl red\nf 1 2 3\n")).unwrap();
    assert_eq!(m.parts[0].material, None);
    assert_eq!(warnings, ["the model's materials are missing, there is no such file: a.mtl"]);
    let text = format!("mtllib a.mtl\n{TRIANGLE}f 1 2 3\n");
    let (_, warnings) = parse(text.as_bytes(), Path::new("a.obj"), &mut |_| Ok(vec![0; 9])).unwrap();
    assert_eq!(warnings, ["the model's materials are missing, line 1: this is not text: a.mtl"]);
    let text = format!("mtllib a.mtl\n{TRIANGLE}usemtl red\nf 1 2 3\n");
    let library = |_: &str| Ok(b"newmtl blue".to_vec());
    let (_, warnings) = parse(text.as_bytes(), Path::new("a.obj"), &mut { library }).unwrap();
    assert_eq!(warnings, ["there is no material `red`: a.obj"]);
}

#[test]
fn endless_lists_of_libraries_end() {
    let many: String = (0..3000).map(|i| format!("mtllib {i} {}\n", "x ".repeat(500))).collect();
    let mut asked = 0;
    let library = |name: &str| {
        asked += 1;
        Err(FormatError::Missing { path: name.into() })
    };
    let text = format!("{many}{TRIANGLE}f 1 2 3\n");
    let (_, warnings) = parse(text.as_bytes(), Path::new("a.obj"), &mut { library }).unwrap();
    assert_eq!(warnings.len(), MAX_NAMES);
    assert!(asked <= MAX_LIBRARIES * (MAX_LIBRARIES + 1), "{asked}");
}

#[test]
fn a_concave_polygon_is_cut_right() {
    let m = mesh("v 0 0 0\nv 4 -2 0\nv 2 0 0\nv 4 2 0\nv 0 3 0\nf 1 2 3 4 5\n");
    let area: f64 = m
        .triangles
        .iter()
        .map(|t| super::super::polygon::double_area(t.map(|i| m.positions[i as usize])).z / 2.0)
        .sum();
    assert!((area - 10.0).abs() < 1e-9, "{area}");
    assert_eq!(m.triangles.len(), 3);
}

#[test]
fn faces_without_area_are_left_out_and_counted() {
    let (m, warnings) = parse_text(&format!("{TRIANGLE}v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\n")).unwrap();
    assert_eq!(m.triangles.len(), 1);
    assert_eq!(m.positions.len(), 3, "their vertices too");
    assert_eq!(warnings, ["2 faces have no area and are left out: a.obj"]);
    assert_eq!(message(&format!("{TRIANGLE}f 1 1 2")), "no face of this model has an area: a.obj");
}

#[test]
fn bad_normals_and_texture_coordinates_are_warnings() {
    let text =
        format!("{TRIANGLE}vn nan 0 0\nvn 0 0 1\nvt -1.#IND 0\nf 1/1/1 2/1/2 3/1/2\nl 1 2\ncurv 0 1 1 2\n");
    let (m, warnings) = parse_text(&text).unwrap();
    assert_eq!(m.normals, [Vec3::ZERO, Vec3::Z, Vec3::Z]);
    assert_eq!(m.uvs, [Vec2::ZERO; 3]);
    assert_eq!(warnings.len(), 4);
}

#[test]
fn indices_that_name_nothing_are_errors_with_the_line() {
    for (face, reason) in [
        ("f 0 1 2", "a face names position 0, and counting starts at 1"),
        ("f 1 2 4", "a face names position 4, and 3 stand above it"),
        ("f 1 2 -4", "a face names position -4, and 3 stand above it"),
        ("f 1 2 9999999999", "a face names position 9999999999, and 3 stand above it"),
        ("f 1/1 2/1 3/1", "a face names texture coordinate 1, and 0 stand above it"),
        ("f 1//1 2//1 3//1", "a face names normal 1, and 0 stand above it"),
        ("f 1 2 99999999999999999999", "`99999999999999999999` is no number of a position"),
        ("f 1 2 x", "`x` is no number of a position"),
        ("f 1/1/1/1 2 3", "`1/1/1/1` is no corner of a face"),
        ("f 1 2", "a face has 2 corners and needs 3 at least"),
        ("f 1 2 # 3", "a face has 2 corners and needs 3 at least"),
        ("f", "a face has 0 corners and needs 3 at least"),
    ] {
        assert_eq!(message(&format!("{TRIANGLE}\n{face}\n")), format!("line 5: {reason}: a.obj"));
    }
    let least = format!("{TRIANGLE}f 1 2 {}", i64::MIN);
    assert!(message(&least).contains("3 stand above it"));
}

#[test]
fn positions_that_are_no_finite_numbers_are_errors_with_the_line() {
    for (line, reason) in [
        ("v nan 0 0", "`nan` is not a finite number"),
        ("v 0 -inf 0", "`-inf` is not a finite number"),
        ("v 0 0 1e39", "`1e39` is not a finite number"),
        ("v 0,5 0 0", "`0,5` is not a finite number"),
        ("v 0 0", "a position lacks a coordinate"),
    ] {
        let error = parse_text(&format!("# header\n{line}\n")).unwrap_err();
        assert_eq!(error.to_string(), format!("line 2: {reason}: a.obj"));
        assert!(!error.help().is_empty());
    }
}

#[test]
fn claims_of_a_header_cost_nothing() {
    let header = "# 1000000000 vertices\n# 1000000000 faces\nvertices 1000000000\nfaces 1000000000\n";
    assert_eq!(mesh(&format!("{header}{TRIANGLE}f 1 2 3")).triangles.len(), 1);
    assert_eq!(message(header), "there is no face in this model: a.obj");
    assert_eq!(message(""), "there is no face in this model: a.obj");
}

#[test]
fn polygons_with_too_many_corners_are_refused() {
    let face = format!("{TRIANGLE}f {}", "1 2 3 ".repeat(MAX_CORNERS / 3 + 1));
    assert!(message(&face).contains("corners"));
}

#[test]
fn files_that_cannot_be_models() {
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str| crate::read_mesh(&folder.path().join(name)).unwrap_err();
    assert!(matches!(read("none.obj"), FormatError::Missing { .. }));
    fs::create_dir(folder.path().join("folder.obj")).unwrap();
    assert!(matches!(read("folder.obj"), FormatError::NotAFile { .. }));
    fs::write(folder.path().join("junk.OBJ"), [0x89, b'P', b'N', b'G', 13, 10, 26, 10, 0, 0]).unwrap();
    assert!(read("junk.OBJ").to_string().starts_with("line 3: this is not text"));
    let unknown = read("model.xyz");
    assert_eq!(unknown.help(), "known are .obj");
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused_without_a_panic(
        lines in proptest::collection::vec("(v|vt|vn|f|o|g|usemtl|mtllib|l|#) ?[-0-9 ./e\\\\]{0,20}", 0..40)
    ) {
        if let Ok((mesh, _)) = parse_text(&lines.join("\n")) {
            prop_assert_eq!(mesh.parts.last().map(|p| p.triangles.end), Some(mesh.triangles.len()));
            for triangle in &mesh.triangles {
                prop_assert!(triangle.iter().all(|i| (*i as usize) < mesh.positions.len()));
            }
            for list in [mesh.normals.len(), mesh.uvs.len()] {
                prop_assert!(list == 0 || list == mesh.positions.len());
            }
        }
    }
}
